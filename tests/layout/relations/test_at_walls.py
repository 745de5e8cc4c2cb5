"""What has a wall behind it, or beside it, in an L-shaped room, in cases by hand."""

import numpy as np
import pytest
from rooms_for_tests import box, some_rooms

from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations.standing import BROKEN, Furniture

SOUTH = -np.pi / 2


@pytest.fixture(scope="module")
def corner() -> Furniture:
    """6 x 4 m about the origin without the quarter in the north-east: a wall from (0, 0) to (0, 2), one to (3, 0)."""
    rooms = some_rooms(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :6] = np.array([[-3, -2], [3, -2], [3, 0], [0, 0], [0, 2], [-3, 2]], np.float32)
    rooms.openings[0] = np.nan
    rooms.openings[0, 0] = [-2.6, -2, -1.8, -2, 0, -1, 0]
    return Furniture(space_of(rooms, 0))


def price(there: Furniture, name: str, at: np.ndarray, strict: bool = False) -> float:
    return float(there.prices(name, at[None], strict=strict)[0])


@pytest.mark.parametrize("past, strict, plain", [(0.05, False, False), (0.35, True, False), (0.6, True, True)])
def test_a_television_stand_has_a_wall_behind_it(corner: Furniture, past: float, strict: bool, plain: bool) -> None:
    """1.6 m wide, so far past the western end of the wall behind it: at a second look a little is let pass."""
    at = box((0.4, 1.6, 0.5), 0.8 - past, -0.205, SOUTH)
    assert (price(corner, "tv_stand", at, strict=True) >= BROKEN) == strict
    assert (price(corner, "tv_stand", at) >= BROKEN) == plain


@pytest.mark.parametrize("name", ["coat_rack", "floor_lamp", "plant"])
def test_what_stands_in_the_middle_of_the_floor_is_rather_at_a_wall(corner: Furniture, name: str) -> None:
    middle, beside = (price(corner, name, box((0.4, 0.4, 1.7), x, 0.6)) for x in (-1.5, -0.3))
    assert beside == 0 and 0 < middle < BROKEN


def test_an_armchair_apart_from_its_group_is_left_out() -> None:
    """Beside a low table, and across the room from it; no other seat is there."""
    there = Furniture(space_of(some_rooms(3), 2))
    there.add("sofa", box((0.9, 1.8, 0.8), 0, float(there.space.corners[:, 1].min()) + 0.5, np.pi / 2))
    sofa = there.boxes[0]
    near = box((0.8, 0.8, 0.8), 0, float(sofa[1]) + 0.45 + 1.2 + 0.4, SOUTH)
    far = box((0.8, 0.8, 0.8), 0, float(sofa[1]) + 0.45 + 1.7 + 0.4, SOUTH)
    assert price(there, "armchair", near) < BROKEN <= price(there, "armchair", far)


@pytest.mark.parametrize("name, size, on_wardrobe", [
    ("table_lamp", (0.2, 0.2, 0.4), False), ("tv", (0.1, 0.6, 0.4), False), ("plant", (0.2, 0.2, 0.4), None),
])
def test_no_lamp_or_screen_stands_on_what_is_higher_than_eyes(name: str, size: tuple[float, float, float],
                                                             on_wardrobe: bool | None) -> None:
    there = Furniture(space_of(some_rooms(1), 0))
    low = there.space.corners.min(0)
    for other, wide, high, at in (("wardrobe", (0.6, 1.0), 2.0, 0.52), ("chest", (0.45, 1.0), 0.8, 1.6)):
        there.add(other, box((*wide, high), float(low[0]) + wide[0] / 2 + 0.005, float(low[1]) + at))
    found = []
    for k, top in ((0, 2.0), (1, 0.8)):
        one = box(size, *there.boxes[k, :2])
        one[5:] += top
        found.append(bool(there._carried(name, one[None])[0]))
    assert found == [on_wardrobe is None, True]


@pytest.mark.parametrize("name, other, size, holds", [
    ("table_lamp", "laundry_basket", (0.4, 0.4, 0.6), False), ("table_lamp", "plant", (0.4, 0.4, 0.8), False),
    ("table_lamp", "piano", (0.6, 1.4, 1.0), False), ("table_lamp", "nightstand", (0.4, 0.4, 0.5), True),
    ("table_lamp", "desk", (0.6, 1.0, 0.75), True), ("monitor", "desk", (0.6, 1.0, 0.75), True),
    ("monitor", "nightstand", (0.4, 0.4, 0.5), False), ("monitor", "wardrobe", (0.6, 1.0, 2.0), False),
])
def test_lamps_stand_on_nothing_with_a_lid_and_one_works_at_desks(
    name: str, other: str, size: tuple[float, float, float], holds: bool
) -> None:
    there = Furniture(space_of(some_rooms(1), 0))
    middle = there.space.corners.mean(0)
    there.add(other, box(size, *middle))
    one = box((0.2, 0.35, 0.4), *middle)
    one[5:] += size[2]
    assert there._carried(name, one[None])[0] == holds
