"""Armchairs find their places about a sofa's low table."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import followers, instead
from apartgen.stages.layout.relations.standing import BROKEN, Furniture

SOFA, LOW, STAND, CHAIR = (0.9, 2.0, 0.8), (0.6, 1.1, 0.42), (0.4, 1.6, 0.5), (0.82, 0.78, 0.85)


def lived_in(turn: float, low: bool) -> tuple[Furniture, np.ndarray]:
    """A wide room with a sofa's group in its middle, turned, its television 2.6 m before the sofa; the way it faces."""
    there, ahead = room(9.0, 9.0), np.array([np.cos(turn), np.sin(turn)])
    rows = [("sofa", SOFA, 0.0), ("tv_stand", STAND, 3.25), *([("coffee_table", LOW, 1.1)] if low else [])]
    for name, size, far in rows:
        there.add(name, box(size, *(far * ahead), turn + np.pi * (name == "tv_stand")))
    return there, ahead


@pytest.mark.parametrize("turn", [0.0, np.pi / 2, 2.2])
@pytest.mark.parametrize("low", [True, False])
def test_an_armchair_has_places_at_both_ends_of_the_low_table(turn: float, low: bool) -> None:
    """It looks at the table, or where one would be, within 50 degrees, stands no farther from it than 1.2 m, and
    leaves the middle metre and a half of the sofa its view of the screen."""
    there, ahead = lived_in(turn, low)
    found = followers.known("armchair", box(CHAIR, 3.0, 3.0)[None], there.names, there.boxes)
    good = found[there.prices("armchair", found, strict=True) < BROKEN]
    assert len(good) and np.allclose(good[:, 3:5], CHAIR[:2])
    across = good[:, :2] @ [-ahead[1], ahead[0]]
    assert (across > 0).any() and (across < 0).any()
    to = 1.1 * ahead - good[:, :2]
    off = np.arctan2(to[:, 1], to[:, 0]) - good[:, 2]
    assert (np.abs((off + np.pi) % (2 * np.pi) - np.pi) < np.radians(50)).all()
    assert (np.abs(across) - np.hypot(*CHAIR[:2]) / 2 < 0.55 + 1.2).all()
    assert (np.abs(across) - np.hypot(*CHAIR[:2]) / 2 > 0.5).all()


def test_a_second_armchair_is_as_large_as_the_first() -> None:
    there, _ = lived_in(0.0, True)
    there.add("armchair", box((0.9, 0.8, 0.85), 1.1, 1.4, -np.pi / 2))
    found = followers.known("armchair", box(CHAIR, 3.0, 3.0)[None], there.names, there.boxes)
    assert np.allclose(found[:, 3:5], (0.9, 0.8))
    assert instead.alternatives("armchair", box(CHAIR, 3.0, 3.0)[None], there, {})[0][0] == "armchair"


def test_without_a_sofa_no_armchair_has_a_place_that_is_known() -> None:
    there = room()
    assert not len(followers.known("armchair", box(CHAIR, 0, 0)[None], there.names, there.boxes))


@pytest.mark.parametrize("width, depth, fits", [(3.4, 4.0, False), (5.0, 7.5, True)])
def test_an_armchair_leaves_the_table_with_its_chairs_its_floor(width: float, depth: float, fits: bool) -> None:
    """Where a table for six comes after it, .9 by 1.8 m and .67 m on both sides."""
    there, chair = room(width, depth), box(CHAIR, 0, 0)
    assert (followers.fit(there, "armchair", chair, ["dining_table", *["chair"] * 6]) == 1) == fits
    assert followers.fit(there, "armchair", chair, ["plant"]) == 1


def test_an_armchair_is_not_to_blame_for_a_table_that_finds_no_better_place_without_it() -> None:
    """In a room of 2.3 m a table for six, .9 by 1.8 m, has .67 m on both sides, and not the .78 m that chairs take."""
    left, chair = ["dining_table", *["chair"] * 6], box(CHAIR, 0, 0)
    narrow, there = room(2.3, 8.0), room(2.3, 3.2)
    assert followers.fit(narrow, "armchair", box(CHAIR, 0.6, -3.0), left) == 1
    assert followers.fit(there, "armchair", chair, left) == 0.25
