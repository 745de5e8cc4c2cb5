"""Walls seen from within: things are where a viewer has them, dimensions add up, no thing is left out or twice."""

import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from export import sample
from shapely.geometry import Point, Polygon

from apartgen.schemas import artifact
from apartgen.schemas.plan import Opening
from apartgen.schemas.populate import without_things
from apartgen.schemas.walkable import Walkable
from apartgen.stages import export
from apartgen.stages.export._seen_walls import walls_seen
from apartgen.stages.export.elevations import STEP, _merged

HOME = Path(__file__).parent.parent / "golden/v2/walkable.json"
SVG = "{http://www.w3.org/2000/svg}"


def turned(point, quarter):
    x, y = point
    for _ in range(quarter):
        x, y = -y, x
    return x, y


@pytest.mark.parametrize("quarter", range(4))
def test_left_and_right_are_a_viewers(quarter):
    """A wall of 4 m, seen from the south: 60 cm from its left end to its right end, a shelf above, a window."""
    home = sample.home()
    ring = [turned(p, quarter) for p in ((0, 0), (4, 0), (4, 3), (0, 3))]
    room = home.rooms[0].model_copy(update={"polygon": ring})
    facing = -np.pi / 2 + quarter * np.pi / 2
    base = without_things(home).objects[0]

    def thing(id, x, y, z, size, on):
        return base.model_copy(update={"id": id, "room": room.id, "center": (*turned((x, y), quarter), z), "size": size,
                                       "yaw": facing, "on": on, "joints": []})

    things = [thing("low", 0.5, 2.7, 0.45, (0.6, 0.8, 0.9), "floor"),
              thing("hung", 3.0, 2.825, 1.8, (0.35, 1.0, 0.7), "wall"),
              thing("free", 2.0, 1.0, 0.4, (0.6, 0.8, 0.8), "floor")]
    window = Opening(id="w", kind="window", rooms=[room.id], sill=1.0, head=2.0,
                     segment=(turned((1.5, 3.15), quarter), turned((2.2, 3.15), quarter)))
    alone = home.model_copy(update={"rooms": [room], "objects": things, "openings": [window]})
    (wall,) = walls_seen(alone, [room])
    assert wall.length == pytest.approx(4.0)
    put = {o.id: (p.left, p.right, p.low, p.high) for o, p in [*wall.things, *wall.openings]}
    assert put == {"low": pytest.approx((0.1, 0.9, 0.0, 0.9)), "hung": pytest.approx((2.5, 3.5, 1.45, 2.15)),
                   "w": pytest.approx((1.5, 2.2, 1.0, 2.0))}


def test_a_jamb_is_no_wall_to_be_drawn():
    """Of two returns of a niche, .4 m and .2 m deep, each with a panel on it, the deeper one is seen as a wall."""
    home = sample.home()
    ring = [(0, 0), (4, 0), (4, 3), (2.5, 3), (2.5, 3.4), (1.5, 3.4), (1.5, 3.2), (0, 3.2)]
    room = home.rooms[0].model_copy(update={"polygon": ring})
    base = without_things(home).objects[0]

    def panel(id, x, y, yaw):
        return base.model_copy(update={"id": id, "room": room.id, "center": (x, y, 1.0), "size": (0.02, 0.1, 0.5),
                                       "yaw": yaw, "on": "wall", "joints": []})

    things = [panel("deep", 2.49, 3.2, np.pi), panel("shallow", 1.51, 3.3, 0.0)]
    seen = walls_seen(home.model_copy(update={"rooms": [room], "objects": things, "openings": []}), [room])
    assert [(wall.length, [o.id for o, _ in wall.things]) for wall in seen] == [(pytest.approx(0.4), ["deep"])]


@pytest.fixture(scope="module")
def studio():
    return artifact.read(HOME, Walkable).body


def test_what_has_its_back_to_a_wall_is_on_one(studio):
    """By the middle of its back and the room's outline; what stands near a corner askew is not asked for."""
    seen = [o.id for wall in walls_seen(studio, studio.rooms) for o, _ in wall.things]
    assert len(seen) == len(set(seen))
    for o in without_things(studio).objects:
        outline = Polygon(next(room.polygon for room in studio.rooms if room.id == o.room))
        ahead = np.array([np.cos(o.yaw), np.sin(o.yaw)])
        far = outline.exterior.distance(Point(np.array(o.center[:2]) - ahead * o.size[0] / 2))
        square = abs(np.sin(2 * o.yaw)) < 0.1
        if square and far < 0.05:
            assert o.id in seen, o.id
        if far > 0.3:
            assert o.id not in seen, o.id


def test_dimensions_add_up(studio, tmp_path):
    """Below each wall the parts have the length of the whole, but for rounding and what is too short to be told."""
    export.run(studio, ["elevations"], tmp_path / "out", sample.load)
    root = ElementTree.parse(tmp_path / "out/elevations.svg").getroot()
    walls = {f"{wall.room.id}_{wall.number}": wall for wall in walls_seen(studio, studio.rooms)}
    for name, wall in walls.items():
        (group,) = [g for g in root.iter(f"{SVG}g") if g.get("id") == name]
        things = {g.get("id") for g in group}
        assert {o.id for o, _ in wall.things} <= {re.sub(r"-\d+$", "", id) for id in things}
        words = [text.text for g in group if g.get("id", "").startswith("dimensions") for text in g.iter(f"{SVG}text")]
        numbers = [int(word) for word in words]
        whole = round(100 * wall.length)
        assert whole in numbers
        parts = numbers[:numbers.index(whole)] if numbers[0] != whole else [whole]
        assert abs(sum(parts) - whole) <= len(parts) + 10 * (len(wall.things) + 1)


def test_a_home_without_furniture_has_a_sheet(tmp_path):
    export.run(sample.plan(), ["elevations"], tmp_path / "out", sample.load)
    assert "no furnished walls" in (tmp_path / "out/elevations.svg").read_text()


def test_dimensions_that_all_but_meet_are_one_from_end_to_end():
    assert _merged([4.0, 0.0, 1.0, 1.0 + STEP / 2, 2.5]) == [0.0, 1.0, 2.5, 4.0]
    assert _merged([0.0, 3.0, 3.0 - STEP / 2]) == [0.0, 3.0]
