"""Wardrobes and basins grow into floor that nothing else took, and nothing else moves."""

import numpy as np
import pytest
from rooms_for_tests import box, one_room, room

from apartgen.stages.layout.relations import lengthened
from apartgen.stages.layout.relations.exchange import cost
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import shell

NAMES = ("wardrobe",)
CLOTHES = (0.6, 1.2, 2.1)


def bedroom(*more: tuple[str, np.ndarray], x: float = 0.0) -> Furniture:
    """A wardrobe at the north wall of a room of 5 m by 4."""
    there = room(5.0, 4.0)
    there.add("wardrobe", box(CLOTHES, x, 1.695, -np.pi / 2))
    for name, one in more:
        there.add(name, one)
    return there


def grown(there: Furniture, fixed: int = 0) -> Furniture:
    return lengthened.grown(there, NAMES, fixed, room(5.0, 4.0).fork)


def ends(there: Furniture) -> tuple[float, float]:
    x, width = there.boxes[there.names.index("wardrobe")][[0, 4]].astype(float)
    return round(x - width / 2, 3), round(x + width / 2, 3)


@pytest.mark.parametrize("x, after", [(0.0, (-1.0, 1.0)), (-1.85, (-2.45, -0.45)), (1.85, (0.45, 2.45))])
def test_it_grows_to_two_metres_along_its_wall_and_stays_in_the_room(x: float, after: tuple[float, float]) -> None:
    there = grown(bedroom(x=x))
    assert ends(there) == pytest.approx(after, abs=1e-3)
    assert there.boxes[0, [1, 2, 3, 5, 6]].tolist() == bedroom(x=x).boxes[0, [1, 2, 3, 5, 6]].tolist()


def test_it_grows_beside_what_stands_there_and_breaks_nothing() -> None:
    shelf = ("bookshelf", box((0.3, 0.8, 1.8), 1.05, 1.845, -np.pi / 2))
    before = bedroom(shelf)
    there = grown(before)
    assert ends(there) == pytest.approx((-1.4, 0.6), abs=1e-3)
    assert np.array_equal(there.boxes[1], before.boxes[1]) and there.names == before.names
    rest = room(5.0, 4.0)
    rest.add(*shelf)
    assert rest.prices("wardrobe", there.boxes[:1], strict=True)[0] < BROKEN


def test_two_are_two_metres_together_and_what_is_given_or_of_other_rooms_stays() -> None:
    second = ("wardrobe", box(CLOTHES, -2.195, 0.0))
    assert grown(bedroom(second)).boxes[:, 4] == pytest.approx([1.2, 1.2])
    assert ends(grown(bedroom(), fixed=1)) == (-0.6, 0.6)
    assert ends(lengthened.grown(bedroom(), (), 0, room(5.0, 4.0).fork)) == (-0.6, 0.6)


def kitchen(*more: tuple[str, np.ndarray]) -> Furniture:
    """Sink, base unit and hob side by side in the middle of the north wall of a room of 5 m by 4."""
    there = room(5.0, 4.0)
    for name, x, wide in (("kitchen_sink", -0.753, 0.6), ("kitchen_base", -0.15, 0.6), ("oven", 0.453, 0.6)):
        there.add(name, box((0.6, wide, 0.9), x, 1.695, -np.pi / 2))
    for name, one in more:
        there.add(name, one)
    return there


def run_on(there: Furniture, fixed: int = 0) -> Furniture:
    return lengthened.run_on(there, shell(one_room(5.0, 4.0), 0), fixed, room(5.0, 4.0).fork)


def test_a_run_goes_on_where_it_lacks_worktop() -> None:
    """.6 m in one piece are half of what one wants; base units more make it longer, and end the run beside the hob."""
    before = kitchen()
    there = run_on(before)
    base = [k for k, name in enumerate(there.names) if name == "kitchen_base"]
    assert len(base) in (2, 3) and len(there.names) == 3 + len(base) - 1
    widths, at = there.boxes[:, 4].astype(float), there.boxes[:, 0].astype(float)
    line = sorted(range(len(at)), key=lambda k: at[k])
    ends = [at[b] - widths[b] / 2 - at[a] - widths[a] / 2 for a, b in zip(line[:-1], line[1:], strict=True)]
    assert np.abs(ends).max() < 0.01, "side by side"
    assert cost(there.names, there.boxes, there.space) < cost(before.names, before.boxes, before.space)


def test_no_unit_is_put_where_something_stands_nor_where_there_is_enough() -> None:
    """What stands at an end closes it; a run with 1.3 m beside its hob, amid its units, is long enough."""
    closed = kitchen(("fridge", box((0.6, 0.6, 1.9), -1.356, 1.695, -np.pi / 2)),
                     ("plant", box((0.6, 0.6, 1.2), 1.1, 1.6, -np.pi / 2)))
    names = run_on(closed).names
    at_hob = [box for name, box in zip(names, run_on(closed).boxes, strict=True) if name == "kitchen_base"]
    assert all(abs(float(one[0]) - 1.1) > 0.5 for one in at_hob)
    enough = kitchen(("kitchen_drawers", box((0.6, 1.3, 0.9), 1.406, 1.695, -np.pi / 2)))
    assert run_on(enough).names == enough.names


@pytest.mark.parametrize("beside, widths", [(0.0, (-0.3, 0.3)), (0.55, (-0.3, 0.3)), (0.35, (-0.35, 0.25))])
def test_a_small_basin_grows_into_free_floor(beside: float, widths: tuple[float, float]) -> None:
    """A cupboard beside it is as near as it may be, or the one side is all there is to grow to."""
    there, empty = room(2.4, 4.0), room(2.4, 4.0).fork
    there.add("vanity", box((0.36, 0.5, 0.85), -1.2 + 0.185, 0.0))
    if beside:
        there.add("chest", box((0.3, 0.3, 0.8), -1.2 + 0.16, beside + 0.15))
    found = lengthened.grown(there, ("vanity",), 0, empty).boxes[0].astype(float)
    assert (found[1] - found[4] / 2, found[1] + found[4] / 2) == pytest.approx(widths, abs=1e-4)
    assert found[3] == pytest.approx(0.46) and found[0] - found[3] / 2 == pytest.approx(-1.195, abs=1e-4)
    for names, fixed in ((("vanity",), 1), ((), 0)):
        assert np.array_equal(lengthened.grown(there, names, fixed, empty).boxes, there.boxes)


def test_a_narrow_unit_fills_the_gap_between_a_hob_and_the_wall() -> None:
    """The run ends .42 m from the east wall, which is less than most units are wide."""
    there = room(3.13, 4.0)
    for name, x, wide in (("kitchen_sink", -0.753, 0.6), ("kitchen_base", 0.0, 0.9), ("oven", 0.753, 0.6)):
        there.add(name, box((0.6, wide, 0.9), x + 0.09, 1.695, -np.pi / 2))
    there.add("kitchen_base", box((0.6, 0.4, 0.9), -1.17, 1.695, -np.pi / 2))
    found = lengthened.run_on(there, shell(one_room(3.13, 4.0), 0), 0, room(3.13, 4.0).fork)
    (more,) = [one for name, one in zip(found.names, found.boxes, strict=True)
               if name == "kitchen_base" and one[0] > 1.0]
    assert more[4] == pytest.approx(0.3) and 0 <= more[0] - 0.15 - 1.143 < 0.02
