"""Where in the home a room lies: nine rooms in three rows, whose places are plain."""

import handmade as h
import pytest

from apartgen.schemas.plan import Plan, Requirement
from apartgen.stages.plan import met

ROWS = (("southwest", "south", "southeast"), ("west", "centre", "east"), ("northwest", "north", "northeast"))
SIDES = ("north", "south", "east", "west")


def nine() -> Plan:
    rooms = [{"id": f"{name}_1", "type": "study", "polygon": h.rectangle(3.1 * i, 3.1 * j, 3, 3)}
             for j, row in enumerate(ROWS) for i, name in enumerate(row)]
    asked = {"rooms": [{"id": room["id"], "type": "study"} for room in rooms]}
    way_in = {"id": "in", "kind": "entrance", "rooms": ["south_1"], "segment": [[4.1, -0.15], [5.0, -0.15]], "sill": 0,
              "head": 2.1, "into": "south_1"}
    return Plan.model_validate({"program": asked, "rooms": rooms, "openings": [way_in]})


def holds(room: str, value: str, to: str = "") -> bool | None:
    asked = Requirement.model_validate({"id": "1", "kind": "position", "of": f"{room}_1", "value": value} | (
        {"to": f"{to}_1"} if to else {}))
    return met.met(asked, met._seen(nine()))


@pytest.mark.parametrize("room", [name for row in ROWS for name in row])
def test_every_room_lies_where_its_name_says(room):
    for side in SIDES:
        assert holds(room, side) is (side in room), side
    assert holds(room, "centre") is (room == "centre")
    assert holds(room, "corner") is (room in {"southwest", "southeast", "northwest", "northeast"})


@pytest.mark.parametrize("other", [name for row in ROWS for name in row])
def test_rooms_lie_to_the_sides_of_one_another(other):
    place = {name: (i, j) for j, row in enumerate(ROWS) for i, name in enumerate(row)}
    for room, (i, j) in place.items():
        if room != other:
            di, dj = i - place[other][0], j - place[other][1]
            found = {side for side in SIDES if holds(room, side, other)}
            true = (("east", di > 0), ("west", di < 0), ("north", dj > 0), ("south", dj < 0))
            assert found == {side for side, yes in true if yes}, room
