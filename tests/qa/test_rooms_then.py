"""Rooms of a film that are asked for: a few, and none that lie open to each other."""

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest

from apartgen.schemas.render import Film, Shown
from apartgen.stages.qa.kinds import room_then

TYPES = ("hallway", "kitchen", "living room", "bedroom", "bathroom", "study", "storage")


def facts(open_pairs):
    """A film that stays ten seconds in each of seven rooms, of which some lie open to each other."""
    frames = [Shown(seconds=float(k), room=TYPES[k // 10]) for k in range(10 * len(TYPES))]
    film = Film(file="walk.mp4", rate=1, width=64, height=48, frames=frames)
    return SimpleNamespace(
        render=SimpleNamespace(film=film), rooms=dict.fromkeys(TYPES), type_of=lambda room: room,
        joined=lambda types: any(set(pair) <= set(types) for pair in open_pairs))


@pytest.mark.parametrize("open_pairs", [[], [("kitchen", "living room")], list(combinations(TYPES, 2))])
@pytest.mark.parametrize("seed", range(8))
def test_a_few_rooms_none_of_which_lies_open_to_another(open_pairs, seed):
    found = room_then.ask(facts(open_pairs), np.random.default_rng(seed), 20)
    asked = {draft.answer for draft in found} | {wrong for draft in found for wrong in draft.wrong}
    assert len(asked) == (0 if len(open_pairs) > 1 else room_then.MOST)
    assert not any(set(pair) <= asked for pair in open_pairs)
    for draft in found:
        (second,) = draft.evidence["seconds"]
        assert draft.answer == TYPES[int(second) // 10] and draft.answer not in draft.wrong
