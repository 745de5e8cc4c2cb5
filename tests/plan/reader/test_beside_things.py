"""Where in its room a thing is to stand: told in its words, while the thing is asked for where it is said to be."""

import numpy as np
import pytest

from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.beside_things import WHY

THINGS = {"a television": "tv", "a chest": "chest", "a bookshelf": "bookshelf", "a plant": "plant", "a desk": "desk"}
BY = ("opposite", "facing", "across from", "next to", "beside", "near", "by", "behind", "in front of", "close to")
HOSTS = ("the bed", "the wardrobe", "the armchair")
ROOMS = {"the main bedroom": "bedroom_1", "the living room": "living_room_1", "the kitchen": "kitchen_1"}


def test_a_thing_is_where_it_is_said_to_be_and_what_it_stands_by_is_told() -> None:
    rng = np.random.default_rng(161900)
    wrong = []
    for _ in range(120):
        thing, by, host, room = (str(rng.choice(list(some))) for some in (THINGS, BY, HOSTS, ROOMS))
        said = str(rng.choice(["two-bedroom flat. {x} {by} {y} in {room}", "two-bedroom flat; {room} has {x} {by} {y}",
                               "two-bedroom flat with {x} {by} {y} in {room}"]))
        text = said.format(x=thing, by=by, y=host, room=room)
        program = read(text)
        asked = [(o.room, o.category, o.count) for o in program.objects]
        told = len(program.unread) == 1 and program.unread[0].startswith(f"{by} {host} ({WHY}")
        if asked != [(ROOMS[room], THINGS[thing], 1)] or program.requirements or not told:
            wrong.append((text, asked, program.requirements, program.unread))
    assert not wrong


@pytest.mark.parametrize("text", [
    "studio with a sideboard with a table lamp on it", "studio. A sideboard with a table lamp on top of it, and a rug",
])  # fmt: skip
def test_on_it_is_told(text: str) -> None:
    program = read(text)
    assert any(WHY in words for words in program.unread)
    assert {"sideboard", "table_lamp"} <= {o.category for o in program.objects}


@pytest.mark.parametrize(("text", "kind"), [
    ("two-bedroom flat, the bathroom next to the bedroom", "adjacent"),
    ("two-bedroom flat with the kitchen opposite the living room", "opposite"),
])  # fmt: skip
def test_where_rooms_lie_is_asked_for_as_ever(text: str, kind: str) -> None:
    program = read(text)
    assert [one.kind for one in program.requirements] == [kind] and not program.unread
