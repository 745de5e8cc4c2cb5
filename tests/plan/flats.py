"""Flats that several plan tests build once, small hand-made programmes, and rooms drawn by hand."""

from functools import cache

import numpy as np

from apartgen.schemas.plan import Plan, Program, Room
from apartgen.stages.plan import PlanConfig, build
from apartgen.stages.plan.study import archetypes


@cache
def flat(name: str, seed: int = 0) -> Plan:
    """An archetype's plan."""
    return build(archetypes()[name], PlanConfig(), np.random.default_rng(seed))


def within(program: Program, **envelope: object) -> Program:
    """The programme with another envelope."""
    return program.model_copy(update={"envelope": program.envelope.model_copy(update=envelope)})


def drawn(name: str, x0: float, y0: float, x1: float, y1: float) -> Room:
    """A rectangular room."""
    return Room(id=name, type=name.rsplit("_", 1)[0], polygon=[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def cottage(gap: float = 0.0) -> list[Room]:
    """Five rooms along a hallway, `gap` apart."""
    g = gap / 2
    return [
        drawn("hallway_1", 0, 4 + g, 9, 5.4 - g),
        drawn("living_room_1", 0, 0, 5 - g, 4 - g),
        drawn("kitchen_1", 5 + g, 0, 9, 4 - g),
        drawn("bedroom_1", 0, 5.4 + g, 4 - g, 9),
        drawn("bathroom_1", 4 + g, 5.4 + g, 6 - g, 9),
        drawn("bedroom_2", 6 + g, 5.4 + g, 9, 9),
    ]
