"""The ProcTHOR house: shape of the published houses, shared walls, holes where the openings are."""

import json
import logging

import numpy as np
import pytest
from export import sample
from export.conftest import EXAMPLE
from shapely.geometry import LineString, Point, Polygon

from apartgen.schemas import artifact
from apartgen.schemas.errors import BadInput
from apartgen.schemas.walkable import Walkable
from apartgen.stages import export
from apartgen.stages.export import _thor
from apartgen.stages.layout.datasets import procthor
from apartgen.stages.space import polygons
from apartgen.stages.things import categories

KEYS = {
    "rooms": "id roomType floorPolygon floorMaterial children ceilings", "walls": "id roomId polygon material",
    "doors": "id room0 room1 wall0 wall1 assetId assetPosition holePolygon openable openness",
    "windows": "id room0 room1 wall0 wall1 assetId assetPosition holePolygon",
    "objects": "id assetId position rotation kinematic",
}  # fmt: skip


@pytest.fixture(scope="module")
def house(exported):
    out = exported("procthor")
    return json.loads((out / "house.json").read_text())


def _plan(points):
    return [(p["x"], p["z"]) for p in points]


def test_rooms_are_clockwise_and_fill_the_flat(house):
    plan = sample.plan()
    for room, own in zip(plan.rooms, house["rooms"]):
        found = Polygon(_plan(own["floorPolygon"]))
        assert not found.exterior.is_ccw
        assert found.buffer(1e-6).contains(polygons.floor(room))
        assert found.area == pytest.approx(polygons.floor(room).buffer(0.05, join_style="mitre").area, abs=0.01)


def test_every_wall_has_another_side(house):
    """Each stretch is in two sheets that run opposite ways: two rooms', or a room's and the open air's."""
    ends = {}
    for wall in house["walls"]:
        a, b, above_a, above_b = wall["polygon"]
        assert above_a == {**a, "y": 2.6} and above_b == {**b, "y": 2.6}
        ends.setdefault(wall["id"].split("|", 2)[2], []).append(_plan([a, b]))
    for pair in ends.values():
        assert len(pair) == 2 and pair[0] == pair[1][::-1]


def test_openings_are_holes_in_walls_of_their_rooms(house):
    plan = sample.plan()
    walls = {wall["id"]: wall for wall in house["walls"]}
    parts = {part["id"].split("|")[1]: part for part in house["doors"] + house["windows"]}
    for opening in plan.openings:
        part = parts[opening.id]
        first, second = walls[part["wall0"]], walls[part["wall1"]]
        assert first["roomId"] == f"room|{opening.rooms[0]}"
        assert second["roomId"] == (f"room|{opening.rooms[1]}" if len(opening.rooms) > 1 else "exterior")
        side = LineString(_plan(first["polygon"][:2]))
        lo, hi = part["holePolygon"]
        assert 0 <= lo["x"] < hi["x"] <= side.length
        assert (lo["y"], hi["y"]) == (opening.sill, opening.head)
        middle = side.interpolate((lo["x"] + hi["x"]) / 2)
        assert middle.distance(Point(*np.mean(opening.segment, axis=0))) < 0.16


def test_objects_are_placed_in_thors_axes(house):
    for o, got in zip(sample.home().objects, house["objects"]):
        assert [got["position"][k] for k in "xzy"] == pytest.approx(o.center, abs=1e-4)
        heading = np.radians(got["rotation"]["y"])
        front = np.array([np.sin(heading), np.cos(heading)])  # THOR's front at heading 0 is +z
        assert front == pytest.approx([np.cos(o.yaw), np.sin(o.yaw)], abs=1e-4)


def test_every_part_has_the_fields_that_published_houses_have(house):
    assert set(KEYS) | {"proceduralParameters", "metadata"} <= set(house)
    for part, keys in KEYS.items():
        assert all(set(keys.split()) <= set(found) for found in house[part]), part
    assert {"ceilingMaterial", "floorColliderThickness", "lights", "reflections", "skyboxId"} <= set(
        house["proceduralParameters"])
    assert set(house["metadata"]["agent"]) == {"position", "rotation", "standing", "horizon"}


BOXES = {
    "Bed": [("Bed_1", 1.5, 0.9, 2.0), ("Bed_2", 1.0, 0.9, 1.9), ("Bed_9", 3.0, 0.9, 3.0)],
    "Chair": [("Chair_1", 0.4, 0.9, 0.42)], "Sofa": [("Sofa_1", 9.0, 1.0, 1.0)],
    "TVStand": [("TV_Stand_1", 1.5, 0.4, 0.3)], "Television": [("Television_1", 1.0, 0.6, 0.05)],
}  # fmt: skip
"""Of assets by type: id, width, height, depth."""


def _database(folder, text):
    place = folder / "procthor" / "databases"
    place.mkdir(parents=True)
    (place.parent / "__init__.py").write_text("")
    (place / "asset-database.json").write_text(text)


def _written(folder):
    export.run(sample.home(), ["procthor"], folder / "house", sample.load)
    house = json.loads((folder / "house" / "house.json").read_text())
    return house, {o["id"].rsplit("_", 1)[0]: o for o in house["objects"]}


@pytest.fixture
def known(tmp_path, monkeypatch):
    """Folder whose package `procthor` knows these assets."""
    groups = {
        kind: [{"assetId": id, "boundingBox": {"x": x, "y": y, "z": z}} for id, x, y, z in rows]
        for kind, rows in BOXES.items()
    }
    _database(tmp_path, json.dumps(groups))
    monkeypatch.syspath_prepend(tmp_path)
    return tmp_path


def test_objects_are_thors_own_assets_where_they_are_known(known):
    house, things = _written(known)
    assert house["metadata"]["assets"] == "AI2-THOR"
    # The bed nearest in size; a sofa of nine metres is too large, and there is no bath.
    assert {k: o["assetId"] for k, o in things.items()} == {
        "double_bed": "Bed_1", "chair": "Chair_1", "tv_stand": "TV_Stand_1", "tv": "Television_1"}
    ours = {o.id.rsplit("_", 1)[0]: o for o in sample.home().objects}
    for name, theirs in things.items():
        o, size = ours[name], theirs["boundingBox"]
        front = np.array([np.cos(o.yaw), np.sin(o.yaw)])
        back = np.array([theirs["position"]["x"], theirs["position"]["z"]]) - front * size["z"] / 2
        assert back == pytest.approx(np.array(o.center[:2]) - front * o.size[0] / 2, abs=1e-4), name
    stand, tv = (things[name] for name in ("tv_stand", "tv"))
    assert stand["position"]["y"] == pytest.approx(0.2) and tv["position"]["y"] == pytest.approx(0.4 + 0.3)


def test_a_database_that_is_none_is_named(tmp_path, monkeypatch):
    _database(tmp_path, "[1]")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(BadInput, match="asset-database.json: not ProcTHOR's asset database"):
        _written(tmp_path)


def test_without_the_database_objects_are_ours_with_their_boxes(house):
    assert house["metadata"]["assets"] == "apartgen"
    for o, got in zip(sample.home().objects, house["objects"]):
        assert got["assetId"] == f"plain/{o.category}"
        assert [got["boundingBox"][k] for k in "zxy"] == pytest.approx(o.size, abs=1e-4)


def test_windows_and_doors_are_thors(house):
    assert [part["assetId"] for part in house["windows"]] == [
        "Window_Fixed_96x48", "Window_Fixed_60x48", "Window_Fixed_36x48"]
    assert {part["assetId"] for part in house["doors"]} == {"Doorway_1"}


CLOSE = 0.02  # m


def _read(path):
    (home,) = procthor.homes(path)
    return home


def _turned(a, b):
    """Degrees between two yaws."""
    return np.degrees(abs((a - b + np.pi) % (2 * np.pi) - np.pi))


def _pivot(o):
    return o.into and (o.into, pytest.approx(o.segment[o.hinge], abs=CLOSE))


def _alike_rooms(home, again):
    assert [(r.id, r.type) for r in again.rooms] == [(r.id, r.type) for r in home.rooms]
    assert (again.height, again.walls) == (home.height, home.walls)
    for one, two in zip(home.rooms, again.rooms):
        assert polygons.floor(one).hausdorff_distance(polygons.floor(two)) < CLOSE
    found = {o.id: o for o in again.openings}
    assert set(found) == {o.id for o in home.openings}
    for one in home.openings:
        two = found[one.id]
        assert (two.kind, two.rooms, two.sill, two.head) == (one.kind, one.rooms, one.sill, one.head)
        assert np.array(sorted(two.segment)) == pytest.approx(np.array(sorted(one.segment)), abs=CLOSE), one.id
        assert (two.into and (two.into, two.segment[two.hinge])) == _pivot(one)


def _alike_furniture(home, again):
    for one, two in zip(home.objects, again.objects, strict=True):
        assert (two.id, two.room, two.category) == (one.id, one.room, one.category)
        assert two.center == pytest.approx(one.center, abs=CLOSE) and two.size == pytest.approx(one.size, abs=CLOSE)
        assert _turned(one.yaw, two.yaw) < 1


def test_a_house_of_our_own_assets_is_read_again_whole(exported):
    home, again = sample.home(), _read(exported("procthor"))
    _alike_rooms(home, again)
    _alike_furniture(home, again)


def test_a_planned_flat_is_read_again_whole(make, library):
    made = make(artifact.read(EXAMPLE, Walkable).body, library, ["procthor"])
    home, again = made.scene.home, _read(made.folder)
    _alike_rooms(home, again)
    _alike_furniture(home, again)


def test_a_house_of_thors_assets_is_read_again_as_it_stands_and_the_rest_is_named(known, caplog):
    with caplog.at_level(logging.INFO, "apartgen"):
        house, _ = _written(known)
    home, again = sample.home(), _read(known / "house")
    _alike_rooms(home, again)
    found = {o.id: o for o in again.objects}
    boxes = {row["id"]: row for row in house["objects"]}
    for one in home.objects:
        if one.id not in found:
            assert one.category in caplog.text
            continue
        two, row = found[one.id], boxes[one.id]
        assert (two.room, two.category) == (one.room, one.category) and _turned(one.yaw, two.yaw) < 1
        assert two.center == pytest.approx([row["position"][k] for k in "xzy"], abs=CLOSE)
        assert two.size == pytest.approx([row["boundingBox"][k] for k in "zxy"], abs=CLOSE)
    assert {o.category for o in again.objects} == {"double_bed", "chair", "tv_stand", "tv"}


def _without_ours(part):
    """The house as a tool of AI2-THOR's would write it back."""
    if isinstance(part, list):
        return [_without_ours(one) for one in part]
    if isinstance(part, dict):
        return {k: _without_ours(v) for k, v in part.items() if k not in ("apartgen", "boundingBox", "objectType")}
    return part


def test_what_is_thors_alone_is_read_like_a_published_house(known):
    house, things = _written(known)
    sizes = {id: (kind, (z, x, y)) for kind, rows in BOXES.items() for id, x, y, z in rows}
    home, again = sample.home(), procthor.layout(_without_ours(house), sizes)
    assert [r.type for r in again.rooms] == ["living_room", "bedroom", "living_room", "bathroom"]
    for one, two in zip(home.rooms, again.rooms):  # which has no thickness of walls
        assert polygons.floor(two).contains(polygons.floor(one))
    kinds = sorted(o.kind for o in home.openings)
    assert sorted(o.kind for o in again.openings) == kinds
    assert sorted(o.category for o in again.objects) == ["chair", "double_bed", "tv", "tv_stand"]
    for two in again.objects:
        row = things[two.category]
        assert two.center == pytest.approx([row["position"][k] for k in "xzy"], abs=CLOSE)
        assert _turned(np.pi / 2 - np.radians(row["rotation"]["y"]), two.yaw) < 1


NEXT_BEST = {
    "balcony_chair": "chair", "balcony_table": "side_table", "bunk_bed": "single_bed", "console_table": "side_table",
    "display_cabinet": "bookshelf", "dressing_table": "desk", "island": "kitchen_base",
    "kitchen_corner": "kitchen_base", "kitchen_drawers": "kitchen_base", "kitchen_sink": "kitchen_base",
    "office_chair": "chair", "shelving": "bookshelf", "shoe_cabinet": "chest", "sideboard": "chest",
    "workbench": "desk",
}  # fmt: skip
"""Categories for which THOR has only a wider word."""


def test_thors_words_are_read_as_the_categories_they_are_written_for():
    for name, row in categories.TABLE.items():
        kind = _thor.type_of(name)
        if kind is None or row.like:  # what is like another may share its word
            continue
        room = next((r for r in row.rooms if r in procthor.ROOMS.values()), "living_room")
        assert procthor.category(kind, room, row.size) == NEXT_BEST.get(name, name)


def test_what_a_robot_may_push_or_lift_is_not_kinematic(house):
    """Of the sample's things a plant, a chair, a bin and the television; furniture, fixtures and lamps stay."""
    free = {o["apartgen"]["category"] for o in house["objects"] if not o["kinematic"]}
    assert free == {"plant", "chair", "bin", "tv"}


def test_a_wide_way_has_a_door_or_frame_for_two_leaves():
    """No leaf is 1.8 m wide, and two of 45 cm are none that one walks through."""
    assert [_thor.passage(1.8, leaf) for leaf in (True, False)] == ["Doorway_Double_1", "Doorframe_Double_1"]
    assert [_thor.passage(0.9, leaf) for leaf in (True, False)] == ["Doorway_1", "Doorframe_1"]
