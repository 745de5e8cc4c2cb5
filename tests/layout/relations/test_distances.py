"""A sofa far from what it looks at, a table near to a sofa: prices by hand."""

import numpy as np
import pytest
from rooms_for_tests import box, one_room, room, some_rooms

from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import distances
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import upright
from apartgen.stages.layout.rooms import KINDS

SOFA, TABLE = (0.9, 2.0, 0.8), (0.9, 1.6, 0.75)


def priced(name: str, one: np.ndarray, there: Furniture) -> float:
    boxes = one[None]
    return float(distances.price(name, boxes, upright(boxes), there.names, there.boxes, there.space)[0])


def free(one: np.ndarray, there: Furniture) -> float:
    return float(distances.ahead(upright(one[None]), there.space)[0])


def angle() -> Furniture:
    """5 m by 4 without its north-east quarter of 2 m by 2."""
    rooms = some_rooms(1)
    corners = [[-2.5, -2], [2.5, -2], [2.5, 0], [0.5, 0], [0.5, 2], [-2.5, 2]]
    rooms.polygon[0], rooms.openings[0] = np.nan, np.nan
    rooms.polygon[0, :6] = np.array(corners, np.float32)
    return Furniture(space_of(rooms, 0))


@pytest.mark.parametrize("x, y, yaw, far", [
    (-2.05, -1.0, 0.0, 4.1), (-2.05, 1.0, 0.0, 2.1),    # past the quarter that is not there, and before it
    (0.0, -1.55, np.pi / 2, 3.1), (1.5, -1.55, np.pi / 2, 1.1),
    (2.05, -1.0, np.pi, 4.1), (0.0, 0.45, -np.pi / 2, 2.0),
])
def test_free_length_ends_at_the_wall_across(x: float, y: float, yaw: float, far: float) -> None:
    assert free(box(SOFA, x, y, yaw), angle()) == pytest.approx(far, abs=1e-5)


@pytest.mark.parametrize("width, far", [(3.4, 0.0), (3.6, 0.2), (4.0, 0.6), (4.4, 1.0), (6.0, 1.0)])
def test_a_sofa_costs_what_its_screen_is_too_far(width: float, far: float) -> None:
    """It is .9 m deep, the stand across .4 m, and 2.1 m between them cost nothing; over a metre more no more."""
    at_wall = box(SOFA, -width / 2 + 0.45, 0.0)
    assert priced("sofa", at_wall, room(width, 4.0)) == pytest.approx(distances.FARTHER * far, abs=1e-4)
    assert priced("armchair", at_wall, room(width, 4.0)) == 0


@pytest.mark.parametrize("gap, near", [(0.5, 1.0), (0.9, 1.0), (1.5, 0.4), (1.9, 0.0), (3.0, 0.0)])
def test_a_table_costs_what_it_is_too_near_to_a_sofa(gap: float, near: float) -> None:
    there, table = room(9.0, 5.0), box(TABLE, -4.5 + 0.9 + gap + 0.45, 0.0)
    assert priced("dining_table", table, there) == 0, "without a sofa"
    there.add("sofa", box(SOFA, -4.05, 0.0))
    assert priced("dining_table", table, there) == pytest.approx(distances.TOGETHER * near, abs=1e-4)
    assert priced("desk", table, there) == 0


@pytest.mark.parametrize("y, far", [(1.0, 0.0), (0.55, 0.0), (0.45, 1.0), (0.1, 1.0)])
def test_the_wall_that_a_sofa_looks_at_is_as_wide_as_a_screen(y: float, far: float) -> None:
    """It ends at y = 0; past it the room goes on for 2 m."""
    assert priced("sofa", box(SOFA, -2.05, y), angle()) == pytest.approx(distances.FARTHER * far, abs=1e-4)


@pytest.mark.parametrize("gap, near", [(0.1, 0.7), (0.5, 0.3), (0.8, 0.0), (2.0, 0.0)])
def test_a_table_costs_what_it_is_too_near_to_a_bed(gap: float, near: float) -> None:
    there = room(9.0, 5.0)
    there.add("double_bed", box((2.0, 1.6, 0.5), -3.5, 0.0))
    table = box(TABLE, -2.5 + gap + 0.45, 0.0)
    assert priced("dining_table", table, there) == pytest.approx(distances.NEARER * near, abs=1e-4)


def test_a_screen_is_rather_not_before_a_window() -> None:
    """The window is in the north wall, 1.2 m wide about the middle."""
    there = Furniture(space_of(some_rooms(1), 0))
    low, high = there.space.corners.min(0), there.space.corners.max(0)
    stand = (0.4, 1.2, 0.5)
    at_window = box(stand, 0.0, float(high[1]) - 0.205, -np.pi / 2)
    away = box(stand, float(low[0]) + 0.205, 0.0)
    assert priced("tv_stand", at_window, there) == distances.GLARE
    assert priced("tv_stand", away, there) == priced("chest", at_window, there) == 0


@pytest.mark.parametrize("gap, near", [(0.6, 0.0), (0.5, 0.0), (0.3, 0.2), (0.0, 0.5)])
def test_an_armchair_costs_what_it_is_too_near_to_the_television(gap: float, near: float) -> None:
    there = room()
    there.add("tv_stand", box((0.4, 1.4, 0.5), 0, 0))
    chair = box((0.8, 0.8, 0.8), 0.6 + gap, 0)
    assert priced("armchair", chair, there) == pytest.approx(distances.CLOSE * near, abs=1e-5)
    table = box((0.8, 1.2, 0.75), 0.6 + gap, 0)
    assert priced("dining_table", table, there) == pytest.approx(distances.CLOSE * near, abs=1e-5)
    assert priced("plant", chair, there) == 0


@pytest.mark.parametrize("name, gap, lost", [
    ("double_bed", 0.3, 0.3), ("double_bed", 0.5, 0.1), ("double_bed", 0.6, 0.0), ("double_bed", 1.2, 0.0),
    ("single_bed", 0.02, 0.0), ("single_bed", 0.2, 0.15), ("single_bed", 0.4, 0.1), ("single_bed", 0.5, 0.0),
    ("single_bed", 0.9, 0.0), ("wardrobe", 0.3, 0.0),
])
@pytest.mark.parametrize("side", [1, -1])
def test_a_bed_stands_at_a_wall_or_free_of_it(name: str, gap: float, lost: float, side: int) -> None:
    """Its head at the west wall of a room of 4 by 4 m, a side so far from the south or the north wall."""
    wide = 1.6 if name == "double_bed" else 0.9
    bed, there = box((2.0, wide, 0.5), -1.0, side * (2 - wide / 2 - gap)), room()
    assert priced(name, bed, there) == pytest.approx(distances.TIGHT * lost, abs=1e-4)
    there.add("sofa", box(SOFA, 1.5, 0.0, np.pi))
    assert priced(name, bed, there) == 0, "where one lives, too"


def test_two_in_a_narrow_room_cannot_do_better() -> None:
    assert priced("double_bed", box((2.0, 1.6, 0.5), -1.0, 0.1), room(4.0, 2.6)) == 0
    assert priced("double_bed", box((2.0, 1.6, 0.5), -1.0, 0.3), room(4.0, 2.9)) == pytest.approx(
        distances.TIGHT * 0.25, abs=1e-4)


@pytest.mark.parametrize("y, price", [(-2.25, 6.0), (-1.3, 1.8), (0.0, 0.0)])
def test_a_bed_stands_rather_not_where_one_comes_in(y: float, price: float) -> None:
    """In a room 6 m deep which is entered in the middle of its south wall: .25, 1.2 and 2.5 m off it."""
    rooms = one_room(5.0, 6.0)
    rooms.openings[0, 0, 4] = KINDS["entrance"]
    bed = box((2.0, 1.0, 0.5), 0.5, y)
    for there, expected in ((Furniture(space_of(rooms, 0)), price), (room(5.0, 6.0), 0.0)):  # by any other door it may
        there.add("sofa", box(SOFA, -1.0, 2.5, -np.pi / 2))
        assert priced("single_bed", bed, there) == pytest.approx(expected, abs=1e-4)


@pytest.mark.parametrize("gap, price", [(0.6, 0.0), (0.25, 3.0), (0.0, 6.0)])
def test_a_bed_is_rather_not_at_a_sofa(gap: float, price: float) -> None:
    there = room(8.0, 8.0)
    there.add("sofa", box(SOFA, 0, 0))
    bed = box((2.0, 1.6, 0.5), -0.45 - gap - 1.0, 0)
    assert priced("double_bed", bed, there) == pytest.approx(price, abs=1e-4)
