"""Leaves of doors that get in each other's way, and the cheapest doors that do not."""

from itertools import product

import numpy as np
import pytest
import shapely
from numpy.random import Generator
from plan.flats import cottage, drawn
from shapely.geometry import Polygon

from apartgen.schemas.errors import Unmet
from apartgen.stages.plan import PlanConfig, doors, from_polygons
from apartgen.stages.plan.faces import edges
from apartgen.stages.plan.swings import Box, Choice, Column, clash, together
from apartgen.stages.space import polygons

FACE = edges(Polygon([(0, 0), (9, 0), (9, 9), (0, 9)]))[0]


def _box(rng: Generator, size: float) -> Box:
    x, y = rng.integers(0, 60, 2) * 0.05
    return x, y, x + size, y + size


def _choice(rng: Generator) -> Choice:
    fronts = tuple(_box(rng, 0.5) for _ in range(2))
    ways = tuple(_box(rng, 0.4) for _ in range(2))
    return Choice(FACE, 0.0, 0.8, 0, None, float(rng.uniform(0, 5)), _box(rng, 0.8), _box(rng, 0.1), fronts, ways)


def _in_the_way(a: Choice, b: Choice) -> bool:
    def meet(p: Box, q: Box) -> bool:
        return min(min(p[i + 2], q[i + 2]) - max(p[i], q[i]) for i in (0, 1)) > 1e-9

    return meet(a.sweep, b.sweep) or any(
        any(meet(one.sweep, front) for front in other.front) or any(meet(one.stands, way) for way in other.way)
        for one, other in ((a, b), (b, a))
    )


@pytest.mark.parametrize("seed", range(20))
def test_the_cheapest_doors_that_do_not_meet(seed: int) -> None:
    rng = np.random.default_rng(seed)
    columns = [
        Column("door", [], sorted((_choice(rng) for _ in range(rng.integers(2, 7))), key=lambda c: c.cost), 2.1)
        for _ in range(4)
    ]
    every = [choice for column in columns for choice in column.choices]
    assert clash(every).tolist() == [[_in_the_way(a, b) for b in every] for a in every]
    possible = [
        sum(choice.cost for choice in some)
        for some in product(*(column.choices for column in columns))
        if not any(_in_the_way(a, b) for i, a in enumerate(some) for b in some[:i])
    ]
    if not possible:
        with pytest.raises(Unmet, match="get in each other's way"):
            together(columns)
        return
    chosen = together(columns)
    assert all(any(choice is mine for mine in column.choices) for choice, column in zip(chosen, columns, strict=True))
    assert sum(choice.cost for choice in chosen) == pytest.approx(min(possible))


@pytest.mark.parametrize(("wide", "into"), [(1.35, "storage_1"), (2.1, "hallway_1")])
def test_a_leaf_bars_no_hall(wide: float, into: str) -> None:
    """A storage's leaf opens out of it, unless nobody gets by the leaf to the rooms behind."""
    rooms = [drawn("hallway_1", 0, 0, 9, wide), drawn("storage_1", 3.6, wide, 5.0, wide + 2),
             drawn("bathroom_1", 0, wide, 3.6, wide + 2), drawn("bedroom_1", 5.0, wide, 9, wide + 4),
             drawn("living_room_1", 0, -5, 9, 0)]  # fmt: skip
    plan = from_polygons(rooms, PlanConfig())
    (door,) = [o for o in plan.openings if "storage_1" in o.rooms]
    assert door.into == into


@pytest.mark.parametrize("gap", [0.0, 0.2])
def test_where_leaves_stand_open(gap: float) -> None:
    """The floor kept for an open leaf is where the built door's leaf stands, at either hinge, into either room."""
    plan = from_polygons(cottage(gap), PlanConfig())
    floors = {room.id: polygons.floor(room) for room in plan.rooms}
    for column in doors._columns(plan.program, floors, plan.walls, (0.7, 0.5)):
        for choice in column.choices if column.kind == "door" else ():
            leaf = polygons.leaf(doors._built(column, choice, 1), plan, np.pi / 2)
            stands = shapely.box(*choice.stands)
            assert leaf.intersection(stands).area > 0.6 * leaf.area


def test_one_carries_plates_no_farther_along_a_hall_than_need_be() -> None:
    """The living room reaches 2.1 m from the kitchen, the entrance is at its other end."""
    rooms = [
        drawn("hallway_1", 0, 0, 12, 1.4), drawn("bedroom_1", 0, 1.5, 12, 4.5), drawn("living_room_1", 0, -4, 7, -0.1),
        drawn("bathroom_1", 7.1, -4, 9, -0.1), drawn("kitchen_1", 9.1, -4, 12, -0.1),
    ]  # fmt: skip
    plan = from_polygons(rooms, PlanConfig())
    door = {frozenset(o.rooms): np.mean([x for x, _ in o.segment]) for o in plan.openings if o.kind == "door"}
    kitchen, living = (door[frozenset(("hallway_1", room))] for room in ("kitchen_1", "living_room_1"))
    assert kitchen - living < 3.8
