"""A television stands straight across from its sofa, for which the sofa is put where that can be."""

from collections import Counter

import numpy as np
import pytest
from rooms_for_tests import box, one_room, room

from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import across, known
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import shell
from apartgen.stages.layout.rooms import KINDS, Rooms

SOFA, STAND = (0.9, 2.0, 0.8), (0.4, 1.6, 0.5)


def two_windows() -> Rooms:
    """A room of 4 by 5 m with windows in its east wall but for 1.6 m in the middle of it."""
    rooms = one_room(4.0, 5.0)
    for k, (low, high) in enumerate(((-2.3, -0.8), (0.8, 2.3)), 1):
        rooms.openings[0, k] = [2.0, low, 2.0, high, KINDS["window"], -1, 0]
    return rooms


@pytest.mark.parametrize("y", [0.0, 0.6])
def test_places_across_are_on_the_sofas_axis_at_the_wall(y: float) -> None:
    there = room(4.0, 5.0)
    there.add("sofa", box(SOFA, -1.54, y))
    found = across.places("tv_stand", box(STAND, 0, 0)[None], there.names, there.boxes, there.space)
    assert len(found) == 3 and np.allclose(found[0, :5], [2.0 - 0.21, y, np.pi, *STAND[:2]], atol=1e-3)
    assert (there.prices("tv_stand", found, strict=True) < BROKEN).all()
    assert not len(across.places("plant", box(STAND, 0, 0)[None], there.names, there.boxes, there.space))
    _, weight = known.further(there, "tv_stand", box(STAND, 1.7, 1.0, np.pi)[None], np.ones(1), shell(one_room(), 0))
    assert weight[1:].sum() == pytest.approx(known.STRAIGHT)


def test_a_screen_costs_what_it_is_beside_the_axis() -> None:
    there = room(4.0, 5.0)
    there.add("sofa", box(SOFA, -1.54, 0.0))
    rows = np.stack([box(STAND, 1.79, y, np.pi) for y in (0.0, 0.15, 0.7, -0.7, 1.6)])
    cost = across.price(there, "tv_stand", rows, [])
    assert cost[0] == cost[1] == 0 < cost[2] < cost[4] and cost[2] == pytest.approx(cost[3])


def test_a_sofa_costs_what_the_wall_across_has_no_place_for_a_screen() -> None:
    """Between the windows one stands .3 m about the middle of the wall; at the free walls anywhere."""
    there = Furniture(space_of(two_windows(), 0))
    middle, aside, turned = box(SOFA, -1.54, 0.0), box(SOFA, -1.54, 1.2), box(SOFA, 1.54, 1.2, np.pi)
    rows = np.stack([middle, aside, turned])
    cost = across.price(there, "sofa", rows, ["tv_stand"])
    assert cost[0] == cost[2] == 0 and cost[1] > 5
    assert not across.price(there, "sofa", rows, ["plant"]).any(), "where none is to come"


@pytest.mark.parametrize(("at", "fixed", "asked", "others", "left"), [
    ((-1.54, 0.0, 0.0), 0, {}, [], True),  # the bed looks at it
    ((0.0, -1.4, np.pi / 2), 0, {}, [], False), ((0.0, -1.4, np.pi / 2), 2, {}, [], True),
    ((0.0, -1.4, np.pi / 2), 0, {"tv": 1}, [], True), ((0.0, -1.4, np.pi / 2), 0, {"tv_stand": 1}, [], True),
    ((0.0, -1.4, np.pi / 2), 0, {}, ["sofa"], True),
])  # fmt: skip
def test_a_screen_that_nobody_sees_from_bed_is_left_out_with_what_is_on_it(
    at: tuple[float, float, float], fixed: int, asked: dict[str, int], others: list[str], left: bool
) -> None:
    there = room(4.0, 5.0)
    screen = box((0.1, 1.0, 0.6), 1.79, 0.0, np.pi)
    screen[5:] = 0.5, 1.1
    there.add("tv_stand", box(STAND, 1.79, 0.0, np.pi))
    there.add("tv", screen)
    there.add("double_bed", box((2.0, 1.6, 0.5), *at))
    there.add("chest", box((0.4, 0.8, 0.8), 1.79, 1.8, np.pi))
    for name in others:
        there.add(name, box(SOFA, -1.54, 1.0))
    found = across.watched(there, fixed, lambda: Furniture(there.space), Counter(asked))
    assert found.names == (there.names if left else ["double_bed", "chest"])
    assert not len(found.names) or np.array_equal(found.boxes[-1], there.boxes[-1])
