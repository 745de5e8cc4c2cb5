"""Runs that go round a corner for worktop, in a room of 2.45 m by 4 about the origin, a door in its south wall."""

from collections import Counter

import numpy as np
import pytest
from rooms_for_tests import box, one_room, room

from apartgen.stages.layout.relations import exchange, lengthened, turned
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import shell

WIDE, DEEP = 2.45, 4.0
UNITS = ("fridge", "kitchen_sink", "kitchen_base", "oven")


def kitchen() -> Furniture:
    """Units of .6 m that take the whole north wall."""
    there = room(WIDE, DEEP)
    for k, name in enumerate(UNITS):
        high = 1.9 if name == "fridge" else 0.9
        there.add(name, box((0.6, 0.597, high), 0.01 - WIDE / 2 + (k + 0.5) * 0.6, DEEP / 2 - 0.305, -np.pi / 2))
    return there


def run_on(there: Furniture, fixed: int = 0, asked: tuple[str, ...] = ()) -> Furniture:
    return lengthened.run_on(there, shell(one_room(WIDE, DEEP), 0), fixed, room(WIDE, DEEP).fork, asked)


def test_a_run_that_ends_at_a_wall_goes_round_the_corner() -> None:
    """.6 m of worktop are half of what one wants; there is no place for more beside it in its line."""
    before = kitchen()
    assert exchange.lacks_worktop(before.names, before.boxes)
    there = run_on(before)
    assert not exchange.lacks_worktop(there.names, there.boxes)
    assert turned.CORNER in there.names and Counter(UNITS) - Counter(there.names) <= Counter({"kitchen_base": 1})
    assert len({round(float(yaw) % np.pi, 2) for yaw in there.boxes[:, 2]}) == 2, "two lines"


def test_one_more_unit_may_be_of_use_only_once_others_change_places() -> None:
    """Its only place is at the far end of a run that ends with the fridge, where nobody has use of it; elsewhere in the
    run it is beside what one cooks on."""
    wide = 3.05
    there = room(wide, DEEP)
    for k, name in enumerate(("oven", "kitchen_base", "kitchen_sink", "fridge")):
        high = 1.9 if name == "fridge" else 0.9
        there.add(name, box((0.6, 0.597, high), 0.01 - wide / 2 + (k + 0.5) * 0.6, DEEP / 2 - 0.305, -np.pi / 2))
    found = lengthened.run_on(there, shell(one_room(wide, DEEP), 0), 0, room(wide, DEEP).fork, (turned.CORNER,))
    bases = [box[4] for name, box in zip(found.names, found.boxes, strict=True) if name == "kitchen_base"]
    assert sum(bases) == pytest.approx(1.2, abs=0.06)
    assert Counter(("oven", "kitchen_sink", "fridge")) <= Counter(found.names)
    hot = found.boxes[found.names.index("oven")]
    beside = [np.hypot(*(box[:2] - hot[:2])) for name, box in zip(found.names, found.boxes, strict=True)
              if name == "kitchen_base"]
    assert max(beside) < 0.62, "one at each side"


@pytest.mark.parametrize("fixed, asked", [(len(UNITS), ()), (0, (turned.CORNER,))])
def test_what_is_given_stays_and_what_is_told_of_corners_holds(fixed: int, asked: tuple[str, ...]) -> None:
    before = kitchen()
    there = run_on(before, fixed, asked)
    assert turned.CORNER not in there.names
    assert fixed == 0 or np.array_equal(there.boxes[:fixed], before.boxes)


def test_what_hangs_above_a_unit_goes_with_it() -> None:
    before = kitchen()
    oven = before.boxes[UNITS.index("oven")]
    before.add("hood", np.array([oven[0], 2.0 - 0.205, -np.pi / 2, 0.4, 0.6, 1.55, 1.9], np.float32))
    there = run_on(before)
    assert turned.CORNER in there.names and there.names.count("hood") == 1
    found = dict(zip(there.names, there.boxes.astype(float), strict=True))
    hood, below = found["hood"], found["oven"]
    assert np.hypot(*(hood[:2] - below[:2])) == pytest.approx(0.1, abs=0.01)
    assert np.cos(hood[2] - below[2]) == pytest.approx(1, abs=1e-4)
