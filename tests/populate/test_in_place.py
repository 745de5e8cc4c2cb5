"""Parts are opened and shut with what is in them, and things are taken from where they are."""

from collections import Counter

import handling
import pytest
from inhabited import library, lived_in, things

from apartgen.stages.things.grasps import WIDEST

HEAVIEST = 1.0
"""What the gripper is asked to lift, kg."""
LEAST_TAKEN = 0.7
"""What lies below another and flat things on boards leave no room for fingers."""
pytestmark = pytest.mark.slow


@pytest.mark.parametrize("seed", range(2))
def test_parts_open_and_shut_with_what_is_in_them(seed, tmp_path):
    home = lived_in(seed)
    moved = list(handling.opened(home, handling.model(home, library().load_asset, tmp_path)))
    assert len(moved) > 10 and not [one for one in moved if one.fallen]
    assert sum(one.jams for one in moved) <= 0.01 * len(moved), [one for one in moved if one.jams]


def test_most_things_are_taken_from_where_they_are(tmp_path):
    home = lived_in(0)
    made, rested = handling.model_with_hand(home, library().load_asset, tmp_path)
    held = handling.contents(home)
    part_of = {id: part for (part, _), ids in held.items() for id in ids}
    along = {part: ids for (part, _), ids in held.items()}
    fit = [o for o in things(home) if o.on != "wall" and min(o.size) <= WIDEST
           and library().load_asset(o.asset.library, o.asset.id).links[0].mass <= HEAVIEST][::2]
    under = handling.under_boards(home)
    outcomes = Counter(handling.taken(made, rested, o, part, along.get(part, ()), o.id in under)
                       for o in fit for part in [part_of.get(o.id)])
    assert len(fit) > 25 and outcomes[""] >= LEAST_TAKEN * len(fit), outcomes
