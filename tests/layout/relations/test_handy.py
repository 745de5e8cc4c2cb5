"""Bins stand where one prepares, lamps at walls beside seats, and there are places for them."""

import numpy as np
import pytest
from rooms_for_tests import box, one_room, room, some_rooms

from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import handy
from apartgen.stages.layout.relations.standing import BROKEN, Furniture

UNIT, BIN, LAMP, SOFA = (0.6, 0.6, 0.9), (0.28, 0.28, 0.45), (0.4, 0.4, 1.6), (0.9, 2.0, 0.8)


def kitchen(*names: str) -> Furniture:
    """Units along the west wall of a room of 4 by 4 m, from 1.4 m north of its south wall on."""
    there = room()
    for k, name in enumerate(names):
        there.add(name, box(UNIT, -2 + 0.31, -0.3 + 0.6 * k))
    return there


ROW = ("kitchen_base", "oven", "kitchen_base", "kitchen_sink")


@pytest.mark.parametrize("x, y, near", [
    (-1.85, -0.76, True),      # at the end of the run
    (-0.6, 1.85, True),        # at the next wall, .64 m from the sink, whose doors open
    (1.85, -1.0, False), (1.0, 1.85, False), (-1.85, -1.6, False),
])
def test_a_bin_is_at_the_end_of_the_run_or_near_the_sink(x: float, y: float, near: bool) -> None:
    there, one = kitchen(*ROW), box(BIN, x, y)
    assert (there.prices("bin", one[None], strict=True)[0] < BROKEN) == near
    assert (there.prices("bin", one[None])[0] < BROKEN) == near
    assert there.prices("bin", one[None], loose=True)[0] < BROKEN, "for who asked for one"


def test_bins_find_places_there() -> None:
    there = kitchen(*ROW)
    found = handy.places("bin", box(BIN, 0, 0)[None], there.names, there.boxes, there.space)
    good = found[there.prices("bin", found, strict=True) < BROKEN]
    end = np.hypot(*(good[:, :2] - [-1.86, -0.76]).T) < 0.05
    assert end.any() and np.allclose(good[:, 3:5], 0.28)
    assert not len(handy.places("bin", box(BIN, 0, 0)[None], ["shower"], there.boxes[:1], there.space))


@pytest.mark.parametrize("x, y, good", [(-1.78, 1.45, True), (-1.78, -1.45, True), (-1.2, 1.45, False),
                                        (1.78, 0.0, False), (1.78, 1.78, False)])
def test_a_lamp_is_at_a_wall_beside_a_seat(x: float, y: float, good: bool) -> None:
    """The sofa stands in the middle of the west wall."""
    there = room()
    there.add("sofa", box(SOFA, -2 + 0.46, 0.0))
    assert (there.prices("floor_lamp", box(LAMP, x, y)[None], strict=True)[0] < BROKEN) == good


def test_lamps_find_places_there() -> None:
    there = Furniture(space_of(one_room(5.0, 5.0), 0))
    assert not len(handy.places("floor_lamp", box(LAMP, 0, 0)[None], there.names, there.boxes, there.space))
    there.add("sofa", box(SOFA, -2.5 + 0.46, 0.0))
    found = handy.places("floor_lamp", box(LAMP, 0, 0)[None], there.names, there.boxes, there.space)
    assert (there.prices("floor_lamp", found, strict=True) < BROKEN).sum() >= 2


def test_lamps_find_the_tops_that_they_belong_on() -> None:
    there = room()
    stand, basket = box((0.4, 0.5, 0.55), 1.0, 0.5, 0.3), box((0.4, 0.4, 0.6), -1.0, 0.5)
    lamp = box((0.2, 0.2, 0.4), 0, 0)[None]
    found = handy.places("table_lamp", lamp, ["nightstand", "laundry_basket"], np.stack([stand, basket]), there.space)
    assert np.allclose(found, [[1.0, 0.5, 0.3, 0.2, 0.2, 0.55, 0.95]], atol=1e-6)
    assert not len(handy.places("table_lamp", lamp, ["laundry_basket"], basket[None], there.space))


def test_lamps_stand_at_beds_before_chests() -> None:
    there = room()
    there.add("double_bed", box((2.0, 1.6, 0.5), -2 + 1.01, 0.0))
    stands = [box((0.4, 0.45, 0.5), -1.79, y) for y in (1.1, -1.1)]
    for stand in stands:
        there.add("nightstand", stand)
    there.add("chest", box((0.45, 1.0, 0.8), 1.76, 0.0, np.pi))
    on = [box((0.2, 0.2, 0.4), *stand[:2]) + np.array([0, 0, 0, 0, 0, 0.5, 0.5], np.float32) for stand in stands]
    rows = np.stack([*on, box((0.2, 0.2, 0.4), 1.76, 0.0) + np.array([0, 0, 0, 0, 0, 0.8, 0.8], np.float32)])
    assert (there.prices("table_lamp", rows, strict=True) < BROKEN).tolist() == [True, True, False]
    there.add("table_lamp", rows[0])
    assert (there.prices("table_lamp", rows[1:], strict=True) < BROKEN).tolist() == [True, False]
    there.add("table_lamp", rows[1])
    assert there.prices("table_lamp", rows[2:], strict=True)[0] < BROKEN


@pytest.mark.parametrize("wide, some", [(0.6, False), (0.9, True)])
def test_a_microwave_leaves_worktop_beside_what_cooks(wide: float, some: bool) -> None:
    there = room()
    there.add("oven", box(UNIT, -2 + 0.31, 0.0))
    there.add("kitchen_base", box((0.6, wide, 0.9), -2 + 0.31, 0.3 + wide / 2))
    one = box((0.36, 0.5, 0.3), 0, 0)[None]
    found = handy.places("microwave", one, there.names, there.boxes, there.space)
    for strict in (True, False):
        good = found[there.prices("microwave", found, strict=strict) < BROKEN]
        assert len(good) == some and (good[:, 1] - 0.25 >= 0.6 - 1e-4).all()
    assert (there.prices("microwave", found, loose=True) < BROKEN).any(), "for who asked for one"


@pytest.mark.parametrize("x, before", [(0.0, True), (0.5, True), (1.3, False)])
def test_no_microwave_stands_before_a_window(x: float, before: bool) -> None:
    """A window from -.6 to .6 in the north wall; the hob stands elsewhere."""
    rooms = some_rooms(1, 4)
    north = float(rooms.polygon[0, :4, 1].max())
    there = Furniture(space_of(rooms, 0))
    there.add("oven", box(UNIT, float(rooms.polygon[0, :4, 0].min()) + 0.31, 0.0))
    there.add("kitchen_base", box((0.6, 0.6, 0.9), x, north - 0.31, -np.pi / 2))
    (one,) = handy.places("microwave", box((0.36, 0.5, 0.3), 0, 0)[None], there.names, there.boxes, there.space)[:1]
    assert (there.prices("microwave", one[None], strict=True)[0] >= BROKEN) == before
