"""Several clearly different plans of one programme."""

from itertools import combinations

import numpy as np
from numpy.random import Generator

from apartgen.schemas.plan import Plan, Program
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.plan.solve import solve
from apartgen.stages.space import polygons


def several(program: Program, config: PlanConfig, rng: Generator, k: int) -> list[Plan]:
    """`k` plans, each the one furthest from those before it among `config.candidates` drawn a plan."""
    lanes = rng.spawn(1 + (k - 1) * config.candidates)
    plans = [solve(program, config, lane) for lane in lanes]
    marks = [touching(plan) for plan in plans]
    taken = [0]
    while len(taken) < k:
        far = [-1.0 if i in taken else min(difference(mark, marks[t]) for t in taken) for i, mark in enumerate(marks)]
        taken.append(int(np.argmax(far)))
    return [plans[t] for t in taken]


def touching(plan: Plan) -> frozenset[tuple[str, str]]:
    """Pairs of rooms that share at least half a metre of wall."""
    grown = {r.id: polygons.floor(r).buffer(plan.walls.inner / 2 + 0.01, join_style="mitre") for r in plan.rooms}
    pairs = combinations(sorted(grown), 2)
    return frozenset((a, b) for a, b in pairs if grown[a].intersection(grown[b]).length > 1.0)


def difference(a: frozenset[tuple[str, str]], b: frozenset[tuple[str, str]]) -> float:
    """Share of the neighbourhoods of two plans that only one of them has, 0 to 1."""
    return len(a ^ b) / max(len(a | b), 1)
