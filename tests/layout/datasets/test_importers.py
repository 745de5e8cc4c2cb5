"""Other data sets' formats, on small files made by hand in exactly their form."""

import gzip
import json
from itertools import islice
from pathlib import Path
from typing import Any

import commandline
import handmade
import numpy as np
import pytest
from shapely.geometry import LineString, Point

from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.stages.layout.datasets import _json, front3d, procthor, ssr
from apartgen.stages.layout.datasets import boxes as atiss
from apartgen.stages.space import boxes, polygons

BACK = [0.0, 0.0, 0.0, 1.0]
"""No turn: the front is +z there, -y here."""
LEFT = [0.0, 0.70711, 0.0, 0.70711]
"""A quarter turn about y: the front is +x there and here."""


def only(home: Layout, category: str) -> Box:
    found = [o for o in home.objects if o.category == category]
    assert len(found) == 1, [o.category for o in home.objects]
    return found[0]


def front(o: Box) -> list[float]:
    return [round(float(v), 3) + 0.0 for v in boxes.axes(boxes.of([o]))[0, 0]]


SSR = {
    "room_type": "bedroom", "room_id": "MasterBedroom-1",
    "bounds_bottom": [[-2, 0, 1.5], [2, 0, 1.5], [2, 0, -1.5], [-2, 0, -1.5]],
    "bounds_top": [[-2, 2.7, 1.5], [2, 2.7, 1.5], [2, 2.7, -1.5], [-2, 2.7, -1.5]],
    "objects": [
        {"desc": "A modern king-size bed with a padded headboard and a chair-like bench.", "jid": "a",
         "pos": [-0.9, 0, 0.25], "rot": LEFT, "size": [1.8, 1.0, 2.1]},
        {"desc": "Modern nightstand with two drawers.", "jid": "b", "pos": [-1.7, 0, -1.0], "rot": LEFT,
         "size": [0.5, 0.6, 0.4]},
        {"desc": "Brown rattan pendant lamp with a metal suspension.", "jid": "c", "pos": [0, 1.9, 0], "rot": BACK,
         "size": [0.5, 0.8, 0.5]},
        {"desc": "A pair of slippers.", "jid": "d", "pos": [0, 0, 0], "rot": BACK, "size": [0.2, 0.1, 0.3]},
    ],
}


@pytest.mark.parametrize("name", ["rooms.jsonl.gz", "rooms.jsonl", "room.json"])
def test_ssr_rooms_are_read_in_our_frame(name: str, tmp_path: Path) -> None:
    text = json.dumps({"scene": SSR, "split": "val"})
    (tmp_path / name).write_bytes(gzip.compress(text.encode()) if name.endswith("gz") else text.encode())
    (home,) = ssr.homes(tmp_path)
    assert home.rooms[0].type == "bedroom" and home.height == pytest.approx(2.7)
    x, y = np.array(home.rooms[0].polygon).T
    assert (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2 == pytest.approx(12.0)
    bed, lamp = only(home, "double_bed"), only(home, "ceiling_lamp")
    assert bed.size == (2.1, 1.8, 1.0) and bed.center == (-0.9, -0.25, 0.5) and front(bed) == [1, 0]
    assert lamp.center == (0, 0, 2.3) and front(lamp) == [0, -1]
    assert len(home.objects) == 3


DATABASE = {
    "Bed": [{"assetId": "Bed_1", "boundingBox": {"x": 1.6, "y": 1.0, "z": 2.1}}],
    "SideTable": [{"assetId": "Side_1", "boundingBox": {"x": 0.5, "y": 0.5, "z": 0.4}}],
    "TVStand": [{"assetId": "Stand_1", "boundingBox": {"x": 1.5, "y": 0.5, "z": 0.4}}],
    "Television": [{"assetId": "TV_1", "boundingBox": {"x": 1.1, "y": 0.7, "z": 0.1}}],
    "HousePlant": [{"assetId": "Plant_1", "boundingBox": {"x": 0.3, "y": 0.4, "z": 0.3}}],
}


def wall(room: int, a: tuple[float, float], b: tuple[float, float]) -> dict[str, Any]:
    return {"id": f"wall|{room}|{a[0]:.2f}|{a[1]:.2f}|{b[0]:.2f}|{b[1]:.2f}", "roomId": f"room|{room}", "polygon": [
        {"x": p[0], "y": y, "z": p[1]} for y in (0, 2.8) for p in (a, b)]}


def thing(id: str, asset: str, x: float, y: float, z: float, turn: float, *children: Any) -> dict[str, Any]:
    return {"id": id, "assetId": asset, "position": {"x": x, "y": y, "z": z}, "rotation": {"x": 0, "y": turn, "z": 0},
            "kinematic": True, "children": list(children)}


def house() -> dict[str, Any]:
    """A bedroom of 4 × 3 m and a living room of 4 × 3 m to its right."""
    rooms = []
    for number, x, kind in ((2, 0.0, "Bedroom"), (3, 4.0, "LivingRoom")):
        ring = [(x, 0.0), (x, 3.0), (x + 4, 3.0), (x + 4, 0.0)]
        rooms.append({"id": f"room|{number}", "roomType": kind, "children": [], "ceilings": [],
                      "floorPolygon": [{"x": a, "y": 0, "z": b} for a, b in ring]})
    between = wall(2, (4.0, 0.0), (4.0, 3.0))
    outer = wall(2, (4.0, 3.0), (0.0, 3.0))
    hole = [{"x": 0.5, "y": 0, "z": 0}, {"x": 1.4, "y": 2.1, "z": 0}]
    pane = [{"x": 1.0, "y": 0.9, "z": 0}, {"x": 2.5, "y": 2.2, "z": 0}]
    return {
        "rooms": rooms, "walls": [between, outer],
        "doors": [{"id": "door|2|3", "room0": "room|2", "room1": "room|3", "wall0": between["id"],
                   "wall1": "wall|3|4.00|0.00|4.00|3.00", "assetId": "Doorway_1", "holePolygon": hole}],
        "windows": [{"id": "window|2|0", "room0": "room|2", "room1": "room|2", "wall0": outer["id"],
                     "wall1": "wall|exterior|4.00|3.00|0.00|3.00", "assetId": "Window_1", "holePolygon": pane}],
        "objects": [
            thing("2|0", "Bed_1", 1.05, 0.5, 1.5, 90), thing("Side|2|1", "Side_1", 0.2, 0.25, 0.4, 90),
            thing("3|2|0", "Stand_1", 7.8, 0.25, 1.5, 270,
                  thing("small|3|5", "Plant_1", 7.8, 0.7, 1.0, 0), thing("3|2|1", "TV_1", 7.8, 0.85, 1.5, 270)),
            thing("3|9", "Unknown_7", 5.0, 0.5, 1.0, 0),
        ],
    }


def procthor_files(folder: Path) -> Path:
    (folder / "asset-database.json").write_text(json.dumps(DATABASE))
    (folder / "houses.jsonl").write_text(json.dumps(house()) + "\n")
    return folder


def test_procthor_houses_are_read_in_our_frame(tmp_path: Path) -> None:
    (home,) = procthor.homes(procthor_files(tmp_path))
    assert [room.id for room in home.rooms] == ["bedroom_1", "living_room_1"] and home.height == 2.8
    bed, stand, tv = (only(home, name) for name in ("double_bed", "tv_stand", "tv"))
    assert bed.size == (2.1, 1.6, 1.0) and bed.center == (1.05, 1.5, 0.5) and front(bed) == [1, 0]
    assert front(stand) == [-1, 0] and tv.room == stand.room == "living_room_1"
    assert only(home, "nightstand").room == "bedroom_1"
    assert len(home.objects) == 4, "a plant on a table and an unknown asset are left out"
    door, window = home.openings
    assert door.kind == "door" and set(door.rooms) == {"bedroom_1", "living_room_1"}
    assert door.segment == ((4.0, 0.5), (4.0, 1.4))
    assert window.segment == ((3.0, 3.0), (1.5, 3.0)) and (window.sill, window.head) == (0.9, 2.2)


def test_what_is_no_furniture_is_named(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level("INFO", "apartgen"):
        list(procthor.homes(procthor_files(tmp_path)))
    assert "HousePlant (1), unknown (1)" in caplog.text


def test_the_sizes_may_lie_beside_a_single_file(tmp_path: Path) -> None:
    (home,) = procthor.homes(procthor_files(tmp_path) / "houses.jsonl")
    assert only(home, "double_bed").size == (2.1, 1.6, 1.0)


def test_a_house_without_sizes_says_what_is_missing(tmp_path: Path) -> None:
    (procthor_files(tmp_path) / "asset-database.json").unlink()
    with pytest.raises(BadInput, match="put asset-database.json"):
        list(procthor.homes(tmp_path))


def test_an_exports_record_beside_a_house_is_no_house(tmp_path: Path) -> None:
    (procthor_files(tmp_path) / "export.json").write_text('{"apartgen": "export", "version": 1, "body": {"files": []}}')
    assert len(list(procthor.homes(tmp_path))) == 1


def mesh(uid: str, kind: str, points: list[list[float]], faces: list[int]) -> dict[str, Any]:
    xyz = [v for p in points for v in p]
    return {"uid": uid, "type": kind, "xyz": xyz, "faces": faces, "normal": [], "instanceid": uid}


def front3d_house() -> dict[str, Any]:
    floor = mesh("floor", "Floor", [[0, 0, 0], [4, 0, 0], [4, 0, 3], [0, 0, 3]], [0, 1, 2, 0, 2, 3])
    door = mesh("door", "Door", [[3.95, 0, 1], [4.15, 0, 1], [4.15, 2.1, 1.9], [3.95, 2.1, 1.9]], [0, 1, 2, 0, 2, 3])
    ceiling = mesh("top", "Ceiling", [[0, 2.8, 0], [4, 2.8, 0], [4, 2.8, 3]], [0, 1, 2])

    def child(ref: str, pos: list[float], rot: list[float]) -> dict[str, Any]:
        return {"ref": ref, "pos": pos, "rot": rot, "scale": [1, 1, 1], "instanceid": f"furniture/{ref}"}

    return {
        "uid": "house", "mesh": [floor, door, ceiling],
        "furniture": [
            {"uid": "1/model", "jid": "bed", "bbox": [1.8, 1.0, 2.1], "valid": True},
            {"uid": "2/model", "jid": "lamp", "bbox": [0.4, 0.5, 0.4]},
            {"uid": "3/model", "jid": "bed", "bbox": [1.8, 1.0, 2.1], "valid": False},
            {"uid": "4/model", "jid": "stand", "valid": True},
        ],
        "scene": {"room": [
            {"type": "MasterBedroom", "instanceid": "r1", "children": [
                child("floor", [0, 0, 0], BACK), child("door", [0, 0, 0], BACK),
                child("1/model", [1.1, 0, 1.5], LEFT), child("2/model", [2, 2.3, 1.5], BACK),
                child("3/model", [3, 0, 1.5], LEFT), child("4/model", [0.3, 0, 0.4], LEFT)]},
            {"type": "none", "instanceid": "r2", "children": []},
        ]},
    }


def test_raw_front3d_is_joined_with_its_models(tmp_path: Path) -> None:
    (tmp_path / "house.json").write_text(json.dumps(front3d_house()))
    (tmp_path / "model_info.json").write_text(json.dumps([
        {"model_id": "bed", "super-category": "Bed", "category": "King-size Bed"},
        {"model_id": "lamp", "super-category": "Lighting", "category": "Pendant Lamp"},
        {"model_id": "stand", "super-category": "Nightstand", "category": None},
    ]))
    (tmp_path / "stand").mkdir()
    (tmp_path / "stand" / "raw_model.obj").write_text("v -0.25 0 -0.2\nv 0.25 0.55 0.2\nvn 0 0 1\n")
    (home,) = front3d.homes(tmp_path)
    assert home.rooms[0].type == "bedroom" and home.height == pytest.approx(2.8)
    assert np.ptp(np.array(home.rooms[0].polygon), 0) == pytest.approx([4, 3], abs=1e-3)
    bed, lamp, stand = (only(home, name) for name in ("double_bed", "ceiling_lamp", "nightstand"))
    assert bed.center == (1.1, -1.5, 0.5) and bed.size == (2.1, 1.8, 1.0) and front(bed) == [1, 0]
    assert lamp.center[2] == pytest.approx(2.55)
    assert stand.size == (0.4, 0.5, 0.55)
    (door,) = home.openings
    assert door.kind == "door" and door.head == 2.1
    assert np.hypot(*np.diff(door.segment, axis=0)[0]) == pytest.approx(0.9)


def npz(folder: Path, name: str, **changed: Any) -> None:
    """A room of 4 × 3 m whose floor's centroid is not the origin, with a bed and a lamp."""
    (folder / name).mkdir(parents=True)
    arrays = dict(
        uids=np.array(["u1", "u2"]), jids=np.array(["j1", "j2"]),
        floor_plan_vertices=np.array([[1, 0, 1], [5, 0, 1], [5, 0, 4], [1, 0, 4]], np.float32),
        floor_plan_faces=np.array([[0, 1, 2], [0, 2, 3]]), floor_plan_centroid=np.array([3, 0, 2.5], np.float32),
        class_labels=np.array([[1, 0, 0, 0], [0, 1, 0, 0]], np.float32),
        translations=np.array([[-0.9, 0.5, 0.0], [0, 2.3, 0]], np.float32),
        sizes=np.array([[0.9, 0.5, 1.05], [0.2, 0.2, 0.2]], np.float32),
        angles=np.array([[np.pi / 2], [0]], np.float32),
    )
    np.savez(folder / name / "boxes.npz", **(arrays | changed))


def test_preprocessed_boxes_are_read_and_split(tmp_path: Path) -> None:
    npz(tmp_path, "house_MasterBedroom-1")
    npz(tmp_path, "house_MasterBedroom-2")
    names = ["double_bed", "pendant_lamp", "start", "end"]
    (tmp_path / "dataset_stats.txt").write_text(json.dumps({"class_labels": names}))
    (tmp_path / "splits.csv").write_text("MasterBedroom-1,train\nMasterBedroom-2,val\n")
    assert len(list(atiss.homes(tmp_path))) == 2
    (home,) = atiss.homes(tmp_path, split="val", splits=tmp_path / "splits.csv")
    bed = only(home, "double_bed")
    assert home.rooms[0].type == "bedroom"
    assert bed.center == pytest.approx((2.1, -2.5, 0.5)) and bed.size == pytest.approx((2.1, 1.8, 1.0))
    assert front(bed) == [1, 0] and only(home, "ceiling_lamp").center[2] == pytest.approx(2.3)


def test_a_split_is_reached_from_the_command_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The real room is the validation one, not that of the training half."""
    npz(tmp_path / "all", "house_MasterBedroom-1")
    npz(tmp_path / "all", "house_MasterBedroom-2")
    names = ["double_bed", "pendant_lamp", "start", "end"]
    (tmp_path / "all" / "dataset_stats.txt").write_text(json.dumps({"class_labels": names}))
    (tmp_path / "splits.csv").write_text("MasterBedroom-1,train\nMasterBedroom-2,val\n")
    (tmp_path / "ours.json").write_text(artifact.finish(handmade.home(), Made(by="test", seed=0))[0])

    def run(*args: object) -> commandline.Done:
        return commandline.run(capsys, monkeypatch, *args)

    part = ("--split", "val", "--splits", tmp_path / "splits.csv")
    done = run("train", "corpus", f"boxes={tmp_path}/all", *part, "-o", tmp_path / "c.npz")
    assert done.code == 0 and "c.npz: 1 rooms" in done.err
    against = ("metrics", tmp_path / "ours.json", "--metric", "relations", "--real", tmp_path / "all", "--as")
    for given, n in (((), 2), (part, 1)):
        values = json.loads(run(*against, "boxes", *given).out)["body"]["values"]
        seen = {(v["name"], v["version"], v["of"]): v["n"] for v in values}
        assert seen["objects_a_room", "real", "bedroom"] == n
    assert run(*against, "ssr", *part).code == run(*against, "boxes", "--split", "val").code == 2


@pytest.mark.parametrize("change, said", [
    ({"class_labels": np.eye(9)[[7, 8]]}, "a label is none of the 4"),
    ({"sizes": np.ones((1, 3))}, "sizes has 3 numbers, 6 belong to 2"),
    ({"translations": np.full((2, 3), np.nan)}, "translations is not finite"),
    ({"floor_plan_faces": np.array([[0, 1, 9]])}, "a corner that is not there"),
    ({"floor_plan_vertices": np.zeros((4, 3))}, "no area"),
])
def test_a_broken_preprocessed_room_is_named(change: dict[str, Any], said: str, tmp_path: Path) -> None:
    npz(tmp_path, "house_MasterBedroom-1", **change)
    with pytest.raises(BadInput, match=said):
        atiss.layout(tmp_path / "house_MasterBedroom-1" / "boxes.npz", ["double_bed", "pendant_lamp", "start", "end"])


def test_a_preprocessed_room_may_be_bare(tmp_path: Path) -> None:
    columns = {"class_labels": 4, "translations": 3, "sizes": 3, "angles": 1}
    none = {name: np.zeros((0, n)) for name, n in columns.items()}
    npz(tmp_path, "house_MasterBedroom-1", **none)
    home = atiss.layout(tmp_path / "house_MasterBedroom-1" / "boxes.npz", ["double_bed"])
    assert home.objects == [] and home.rooms[0].type == "bedroom"


def test_what_is_wrong_with_a_row_fits_a_line(tmp_path: Path) -> None:
    low = SSR | {"bounds_top": SSR["bounds_bottom"]}
    (tmp_path / "room.json").write_text(json.dumps(low))
    with pytest.raises(BadInput) as error:
        list(ssr.homes(tmp_path))
    assert "row 1" in str(error.value) and "height: input should be greater than 0" in str(error.value)
    assert "\n" not in str(error.value) and "http" not in str(error.value)


def test_a_front3d_room_without_type_is_left_out(tmp_path: Path) -> None:
    house = front3d_house()
    house["scene"]["room"][1]["type"] = None
    assert front3d.layout(house, {"bed": "King-size Bed", "lamp": "Pendant Lamp", "stand": ""}, tmp_path) is not None


SHARED = Path(__file__).parents[4] / "shared" / "data"


@pytest.mark.skipif(not SHARED.exists(), reason="real data not at hand")
def test_real_rooms_make_sense_in_our_frame() -> None:
    """Real beds stand with their backs to a wall, which any mistake of axes would undo."""
    backs = []
    for home in ssr.homes(SHARED / "front3d_val" / "dataset_bedroom_val.jsonl.gz"):
        corners = np.array(home.rooms[0].polygon)
        for o in home.objects:
            if o.category == "double_bed":
                back = np.array(o.center[:2]) - np.array(front(o)) * o.size[0] / 2
                a, b = corners, np.roll(corners, -1, 0)
                share = np.clip(((back - a) * (b - a)).sum(1) / ((b - a) ** 2).sum(1), 0, 1)
                backs.append(np.hypot(*(a + share[:, None] * (b - a) - back).T).min())
    assert len(backs) > 300 and np.mean(np.array(backs) < 0.15) > 0.8


@pytest.mark.skipif(not SHARED.exists(), reason="real data not at hand")
@pytest.mark.parametrize("name", ["r1k_val", "rh_val"])
def test_published_houses_make_sense_in_our_frame(name: str) -> None:
    """Doors lie between their rooms and clear of furniture, which a hole measured from the other end would undo."""
    rows = islice(_json.rows(SHARED / "procthor" / f"{name}.jsonl.gz"), 30)
    doors = []
    for row in rows:
        sizes = {o["assetId"]: ("Desk", (0.6, 0.6, 0.6)) for o in row["objects"] if o["position"]["y"] < 1}
        home = procthor.layout(row, sizes)
        floors = polygons.floors(home)
        assert len(home.rooms) == len(row["rooms"]) and home.objects
        assert all(floors[o.room].buffer(0.01).contains(Point(o.center[:2])) for o in home.objects)
        assert sum(o.kind == "entrance" for o in home.openings) == 1
        for opening in home.openings:
            assert all(floors[id].boundary.buffer(1e-3).contains(LineString(opening.segment)) for id in opening.rooms)
            if opening.kind != "window":
                middle = np.mean(opening.segment, axis=0)
                doors.append(min(np.hypot(*(middle - o.center[:2])) for o in home.objects))
    assert len(doors) >= 30 and min(doors) > 0.5
