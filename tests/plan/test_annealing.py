"""Annealing accepts what Metropolis accepts, and finds more for it than going downhill or wandering does."""

import numpy as np
import pytest

from apartgen.schemas.plan import Program, Walls
from apartgen.stages.plan import kernel
from apartgen.stages.plan.blocks import given
from apartgen.stages.plan.problem import Slack, Whim, copy, problem, scratch
from apartgen.stages.plan.slicing import LACKING, Problem, Tree

WALLS = Walls(inner=0.1, outer=0.3)
KINDS = ("hallway", "living_room", "kitchen", "bedroom", "bathroom", "bedroom")
ALWAYS = 1e15
"""A temperature at which every proposal is taken."""


def flat() -> Problem:
    """Six rooms of 64 m² in a rectangle of 9.5 × 8 m, all linked to the hallway."""
    ring = [(0.0, 0.0), (9.5, 0.0), (9.5, 8.0), (0.0, 8.0)]
    area = {"hallway": 6.0, "living_room": 20.0, "kitchen": 8.0, "bedroom": 12.0, "bathroom": 5.0}
    names = [f"{kind}_{KINDS[:i].count(kind) + 1}" for i, kind in enumerate(KINDS)]
    rooms = [{"id": name, "type": kind, "area": area[kind]} for name, kind in zip(names, KINDS, strict=True)]
    program = Program(rooms=rooms, links=[(names[0], name) for name in names[1:]], envelope={"outline": ring})
    nothing = Whim((1,) * len(KINDS), [(2, 4, 2)], "rectangle", 1.0)
    return problem(program, given(program.envelope, WALLS.inner), nothing, WALLS, Slack())


def chain(rng: np.random.Generator) -> Tree:
    """A random caterpillar of cuts over the rooms in random order."""
    n = len(KINDS)
    nodes = np.zeros((2 * n, 3), np.int64)
    nodes[:n, 0] = rng.permutation(n)
    for cut in range(n, 2 * n - 1):
        nodes[cut] = cut - n + 1, 0 if cut == n else cut - 1, rng.integers(2)
    nodes[-1, 0] = 2 * n - 2
    return Tree(nodes, np.append(rng.uniform(5, 20, n), 1.0))


def annealed(
    p: Problem, tree: Tree, seed: int, steps: int, hot: float, cold: float
) -> tuple[float, float, Tree, Tree]:
    """The lowest cost, what that state lacks, that state, and the last state."""
    z = scratch(p, len(tree.share) - 1)
    last, best = copy(tree), copy(tree)
    low = kernel.anneal(p, last, copy(tree), best, z, np.array([seed], np.uint64), steps, hot, cold)
    return float(low), float(z.terms[LACKING]), best, last


def cost(p: Problem, tree: Tree) -> float:
    return annealed(p, tree, 1, 0, 1.0, 1.0)[0]


def same(a: Tree, b: Tree) -> bool:
    return np.array_equal(a.nodes, b.nodes) and np.array_equal(a.share, b.share)


@pytest.mark.parametrize("temperature", [3.0, 30.0])
def test_a_worse_state_is_taken_as_often_as_boltzmann_says(temperature: float) -> None:
    p, rng = flat(), np.random.default_rng(5)
    here = min((annealed(p, chain(rng), seed, 6000, 20.0, 1.0)[2] for seed in range(1, 5)), key=lambda t: cost(p, t))
    worse, taken = [], []
    for seed in rng.integers(1, 2**63, 6000).tolist():
        there = annealed(p, here, seed, 1, ALWAYS, ALWAYS)[3]
        if not same(here, there):
            worse.append(cost(p, there) - cost(p, here))
            # A run of one step ends at the lower of its temperatures.
            taken.append(same(there, annealed(p, here, seed, 1, 50 * temperature, temperature)[3]))
    likely = np.minimum(1.0, np.exp(-np.array(worse) / temperature))
    hit = np.array(taken)
    assert hit[likely == 1].all() and not hit[likely < 1e-6].any()
    for low, high in ((0.01, 0.2), (0.2, 0.5), (0.5, 0.8), (0.8, 0.999)):
        some = (likely > low) & (likely < high)
        spread = np.sqrt((likely[some] * (1 - likely[some])).sum())
        assert some.sum() > 30 and abs(hit[some].sum() - likely[some].sum()) < 4 * spread


def test_annealing_beats_going_downhill_and_wandering_at_as_many_steps() -> None:
    p = flat()
    lows = {}
    for name, hot, cold in (("annealed", 20.0, 1.0), ("downhill", 1e-9, 1e-9), ("wandering", ALWAYS, ALWAYS)):
        rng = np.random.default_rng(8)
        lows[name] = [annealed(p, chain(rng), seed, 9000, hot, cold)[0] for seed in range(1, 161)]
    mean = {name: np.mean(low) for name, low in lows.items()}
    assert mean["annealed"] < mean["downhill"] - 4 and mean["annealed"] < mean["wandering"] - 50
