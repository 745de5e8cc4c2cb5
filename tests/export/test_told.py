"""What the page tells: where floor is, where a robot gets to, what was changed and why things are where they are."""

import json

import numpy as np
import pytest
import shapely
from export.conftest import EXAMPLE

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable
from apartgen.stages.export._reasons import reasons
from apartgen.stages.export._told import told
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, polygons


@pytest.fixture(scope="module")
def home():
    return artifact.read(str(EXAMPLE), Walkable).body


@pytest.fixture(scope="module")
def facts(home):
    return json.loads(json.dumps(told(home)))


def test_runs_of_floor_cover_the_rooms(home, facts):
    floor = facts["floor"]
    assert sum(length for _, length in floor["runs"]) == floor["columns"] * floor["rows"]
    for index, room in enumerate(home.rooms):
        area = sum(length for at, length in floor["runs"] if at == index) * floor["cell"] ** 2
        shape = shapely.Polygon(room.polygon)
        assert area == pytest.approx(shape.area, abs=shape.length * floor["cell"] / 2)


def test_free_floor_keeps_off_walls_and_furniture(home, facts):
    free = facts["free"]
    points = shapely.points([(free["x"] + (c + 0.5) * free["cell"], free["y"] + (row + 0.5) * free["cell"])
                             for row, a, b in free["runs"] for c in range(a, b)])
    assert len(points) > 1000
    things = shapely.union_all([shapely.Polygon(boxes.corners(boxes.of([o]))[0]) for o in home.objects
                                if reach.in_the_way(o)])
    near = reach.RADIUS - free["cell"]
    assert shapely.distance(points, things).min() > near
    assert shapely.distance(points, polygons.walls(home)).min() > near


def test_the_way_stays_on_free_floor_and_sees_every_room(home, facts):
    free, line = facts["free"], shapely.LineString(facts["way"])
    cells = shapely.union_all([shapely.box(free["x"] + a * free["cell"], free["y"] + row * free["cell"],
                                           free["x"] + b * free["cell"], free["y"] + (row + 1) * free["cell"])
                               for row, a, b in free["runs"]])
    assert line.difference(cells.buffer(0.15)).length == 0
    assert all(line.distance(shapely.Polygon(room.polygon)) == 0 for room in home.rooms if room.base != "balcony")


def test_steps_follow_one_another_to_the_home_as_it_is(home, facts):
    last = {}
    for step in facts["steps"]:
        for shift in step["shifts"]:
            assert shift["id"] not in last or last[shift["id"]] == shift["before"]
            last[shift["id"]] = shift["after"]
    assert len(facts["steps"]) == len(home.walkable.steps) > 0
    places = {o.id: o for o in home.objects}
    for name, place in last.items():
        assert (place is None) == (name not in places)
        assert place is None or place["center"] == pytest.approx(list(places[name].center))


def test_reasons_are_what_is_seen(home, facts):
    found = reasons(home)
    by_id = {o.id: o for o in home.objects}
    backs = [name for name, words in found.items() if "its back is at a wall" in words]
    walls = polygons.walls(home)
    assert backs
    for name in backs:
        o = by_id[name]
        back = np.array(o.center[:2]) - o.size[0] / 2 * np.array([np.cos(o.yaw), np.sin(o.yaw)])
        assert walls.distance(shapely.Point(back)) < 0.1
    for step in home.walkable.steps:
        words = " ".join(found[step.object])
        assert ("taken away" in words) == (step.after is None)
    assert any("stands on the floor" in words for words in found.values())
    assert all(thing["why"] == found.get(thing["id"], []) for thing in facts["things"])
