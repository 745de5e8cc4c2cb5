"""What carries an object: told once from where things are, recorded, and kept true by every stage."""

import json
from pathlib import Path

import numpy as np
import pytest
from shapely import Point
from shapely import box as rectangle
from shapely.affinity import rotate, translate

from apartgen.schemas import artifact
from apartgen.schemas.carrying import Body, carrier, over
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.schemas.walkable import Walkable
from apartgen.stages.things import carrying
from apartgen.stages.things.categories import TABLE

GOLDEN = Path(__file__).parent / "golden"
STAND = Body("stand", "r", "floor", (1.0, 2.0, 0.25), (0.4, 1.2, 0.5), np.pi / 2)  # reaches 1.2 m along x


def body(place, x=1.0, y=2.0, low=0.5, tall=0.3, room="r", id="a"):
    return Body(id, room, place, (x, y, low + tall / 2), (0.2, 0.2, tall), 0.3)


CASES = {
    "a lamp on its table": (body("top"), "stand"),
    "at its end, as it is turned": (body("top", x=1.59), "stand"),
    "just beyond its end": (body("top", x=1.61), "wall"),
    "beside it": (body("top", y=2.21), "wall"),
    "sunk into a tray": (body("top", low=0.46), "stand"),
    "under its top plate": (body("top", low=-0.01), "floor"),
    "a hand above it": (body("top", low=0.6), "wall"),
    "in another room": (body("top", room="s"), "wall"),
    "a plant on the floor": (body("floor", low=0.0), "floor"),
    "a plant on a table": (body("floor"), "stand"),
    "a chair in the air": (body("floor", low=1.5), "floor"),
    "a rug": (body("flat", low=0.0), "floor"),
    "a curtain down to the floor": (body("wall", low=0.0), "wall"),
    "a lamp from the ceiling over a table": (body("ceiling", low=0.5), "ceiling"),
    "of no known kind, low": (body("", low=0.02), "floor"),
    "of no known kind, on a table": (body(""), "stand"),
    "of no known kind, under the ceiling": (body("", x=3, low=2.28), "ceiling"),
    "of no known kind, in the air": (body("", x=3, low=1.0), "wall"),
}


@pytest.mark.parametrize("case", CASES)
def test_what_carries_it_follows_from_its_kind_and_place(case):
    one, wanted = CASES[case]
    assert carrier(one, [STAND, one], 2.6) == wanted


def test_the_highest_top_carries_and_small_things_and_rugs_do_not():
    board = Body("board", "r", "wall", (1.0, 2.0, 0.48), (0.4, 0.4, 0.1), 0.0)
    book, rug = body("top", low=0.45, tall=0.06, id="book"), Body("rug", "r", "flat", (1, 2, 0.51), (2, 2, 0.02), 0.0)
    lamp = body("top", low=0.53)
    assert carrier(lamp, [STAND, board, book, rug, lamp], 2.6) == "board"


def test_over_is_over_whatever_way_it_is_turned():
    """Against shapely, on tops turned by any angle."""
    rng, found = np.random.default_rng(4), []
    for _ in range(200):
        (x, y, dx, dy, yaw), (d, w) = rng.uniform(-1, 1, 5) * (2, 2, 0.8, 0.8, np.pi), rng.uniform(0.3, 1.5, 2)
        top = Body("top", "r", "floor", (x, y, 0.25), (d, w, 0.5), yaw)
        mark = translate(rotate(rectangle(-d / 2, -w / 2, d / 2, w / 2), yaw, (0, 0), use_radians=True), x, y)
        found.append(mark.contains(Point(x + dx, y + dy)))
        assert over(body("top", x + dx, y + dy), top) == found[-1]
    assert 40 < sum(found) < 160


def box(id, category, center, size, **more):
    return {"id": id, "room": "living_room_1", "category": category, "center": center, "size": size, "yaw": 0.0, **more}


def home(*objects):
    raw = json.loads((GOLDEN / "v1" / "layout.json").read_text(encoding="utf-8"))["body"]
    return Layout.model_validate(raw | {"objects": objects})


def test_what_is_said_is_not_asked_again_and_what_stands_on_it_is_found():
    said = home(box("a", "side_table", [1, 1, 0.25], [0.5, 0.5, 0.5], on="wall"),
                box("b", "table_lamp", [1, 1, 0.7], [0.2, 0.2, 0.4]),
                box("c", "plant", [1, 1, 1.0], [0.1, 0.1, 0.2], on="b"))
    a, b, c = carrying.recorded(said).objects
    assert (a.on, b.on, c.on) == ("wall", "a", "b")
    assert carrying.carried(a, [a, b, c]) == [b, c] and carrying.carried(c, [a, b, c]) == []
    assert carrying.by_another(b) and not carrying.by_another(a) and carrying.by_another(said.objects[1])


def test_files_of_version_1_say_what_carries_their_objects():
    read = artifact.read(GOLDEN / "v1" / "walkable.json", Walkable).body
    on = {o.id: o.on for o in read.objects}
    for o in read.objects:
        low = o.center[2] - o.size[2] / 2
        match TABLE[o.category].place:
            case "top":
                below = next(p for p in read.objects if p.id == o.on)
                assert abs(below.center[2] + below.size[2] / 2 - low) < 0.02
                assert np.hypot(*np.subtract(below.center, o.center)[:2]) < np.hypot(*below.size[:2]) / 2
            case "wall" | "ceiling" as place:
                assert on[o.id] == place
            case _:
                assert on[o.id] == "floor" and low < 0.01


@pytest.mark.parametrize("on, words", [
    ({"a": "b"}, r"objects\[0\]\.on: there is no object 'b'"), ({"a": "a"}, "would stand on itself"),
    ({"a": "c", "c": "a"}, "would stand on itself by way of 'c'"),
])
def test_files_whose_objects_stand_on_nothing_are_turned_away(on, words):
    raw = json.loads((GOLDEN / "v2" / "layout.json").read_text(encoding="utf-8"))
    raw["body"]["objects"] = [box(id, "side_table", [1, 1, 0.25], [0.5, 0.5, 0.5], on=on.get(id)) for id in "ac"]
    with pytest.raises(BadInput, match=words):
        artifact.parse(json.dumps(raw).encode(), "file", Layout)


@pytest.mark.parametrize("kind", ["layout", "retrieve", "walkable"])
def test_every_stage_says_what_is_so(kind):
    """As version 2 was written: what is said to carry a thing is under it, by arithmetic of our own."""
    read = artifact.read(GOLDEN / "v2" / f"{kind}.json", Layout).body
    known = {o.id: o for o in read.objects}
    assert any(o.on in known for o in read.objects)
    for o in read.objects:
        low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
        if o.on in known:
            below = known[o.on]
            c, s = np.cos(below.yaw), np.sin(below.yaw)
            x, y = np.subtract(o.center, below.center)[:2]
            assert (np.abs([c * x + s * y, c * y - s * x]) <= np.array(below.size[:2]) / 2).all()
            assert below.center[2] < low <= below.center[2] + below.size[2] / 2 + 0.02
        else:
            assert {"floor": low < 0.01, "ceiling": high > read.height - 0.05, "wall": True}[o.on]
