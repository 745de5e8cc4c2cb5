"""What a place is worth for those who sit, by hand."""

import numpy as np
import pytest
from rooms_for_tests import some_rooms

from apartgen.stages.layout.projection import comfort, partners
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE


def at(x: float, y: float, yaw: float, name: str) -> Boxes:
    d, w, h = TABLE[name].size
    return Boxes(np.array([[x, y, TABLE[name].z + h / 2]]), np.array([[d, w, h]]), np.array([yaw]))


def worth(angle: float, away: float = 2.5, turned: float = 0.0) -> float:
    """Of a television at the origin that looks east (but for `turned`), to a sofa `away` before it whose own front is
    turned by `angle` from the way to it."""
    sofa = at(away, 0.0, np.pi + np.radians(angle), "sofa")
    return float(partners.watched(at(0, 0, np.radians(turned), "tv_stand"), sofa, ["sofa"])[0])


def test_straight_ahead_is_the_best_view_and_nobody_turns_round() -> None:
    assert worth(0) == pytest.approx(partners.WATCH)
    assert worth(95) == worth(180) == 0
    for off in (10, 30, 45):
        assert worth(off) == pytest.approx(worth(-off)) and worth(off - 5) > worth(off)


@pytest.mark.parametrize("angle", [55, 65, 80])
def test_from_the_side_is_better_than_not_at_all(angle: float) -> None:
    """Three tenths of the best, less what lies off its axis, which counts up to a metre."""
    aside = 1.5 * np.sin(np.radians(angle))
    assert worth(angle, 1.5) == pytest.approx(max(0.3 * partners.WATCH - partners.OFF_AXIS * min(aside, 1.0), 0))
    assert worth(angle, 1.5) > 0


def test_a_screen_is_watched_from_before_it_and_not_from_close_by() -> None:
    assert worth(0, 1.45) == worth(0, 4.0) == pytest.approx(partners.WATCH) and worth(0, 1.35) == 0
    assert worth(0, turned=39) > 0 and worth(0, turned=-39) > 0 and worth(0, turned=41) == worth(0, turned=180) == 0
    found = partners.watched(at(0, 0, 0, "tv_stand"), at(2.5, 0, np.pi, "chair"), ["chair"])
    assert found.tolist() == [0]


@pytest.mark.parametrize("name, kept", [
    ("dining_table", True), ("desk", True), ("round_table", True), ("coffee_table", False), ("pouffe", False)])
def test_nobody_dines_or_works_before_a_sofa(name: str, kept: bool) -> None:
    """A sofa that looks east in the middle of a large room; right before it, and as far behind it."""
    rooms = some_rooms(1)
    rooms.polygon[0, :4] = np.array([[-6, -6], [6, -6], [6, 6], [-6, 6]], np.float32)
    rooms.openings[0] = np.nan
    space, sofa = space_of(rooms, 0), at(0.0, 0.0, 0.0, "sofa")
    far = (TABLE["sofa"].size[0] + TABLE[name].size[0]) / 2 + 0.3
    before, behind = (comfort.price(name, at(x, 0.0, 0.0, name), space, sofa, ["sofa"])[0] for x in (far, -far))
    assert before - behind == pytest.approx(comfort.OPEN * kept)
