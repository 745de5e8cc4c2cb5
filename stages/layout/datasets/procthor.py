"""ProcTHOR and AI2-THOR houses as JSON or JSON lines, read and written.

Unity's axes: y up, left-handed, yaw clockwise in degrees, an object's front +z, `position` the box's centre. Sizes
come from `asset-database.json` of the Python package `procthor`: given as `sizes`, found below `root`, or in the
installed package. Walls have no thickness there, and next to none in the plan that is read.
"""

import json
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from shapely.geometry import Polygon

from schemas.base import Point, RoomType
from schemas.errors import BadInput
from schemas.layout import Box, Layout
from schemas.plan import Opening, Room, Walls
from stages.layout.datasets import _frames, _json, _words

WALLS = Walls(inner=1e-3, outer=1e-3)
ROOMS: dict[str, RoomType] = {
    "Bedroom": "bedroom", "Bathroom": "bathroom", "Kitchen": "kitchen", "LivingRoom": "living_room",
}
CATEGORY = {
    "ArmChair": "armchair", "Bed": "double_bed", "Chair": "chair", "ClothesDryer": "dryer",
    "CoffeeTable": "coffee_table",
    "CounterTop": "kitchen_base", "Desk": "desk", "DeskLamp": "table_lamp", "Desktop": "monitor",
    "DiningTable": "dining_table", "Dresser": "chest", "FloorLamp": "floor_lamp", "Footstool": "pouffe",
    "Fridge": "fridge", "GarbageCan": "bin", "HousePlant": "plant", "LaundryHamper": "laundry_basket",
    "Microwave": "microwave", "Ottoman": "pouffe", "ShelvingUnit": "shelving", "SideTable": "side_table",
    "Sink": "vanity", "Sofa": "sofa", "Stool": "stool", "TVStand": "tv_stand", "Television": "tv", "Toilet": "toilet",
    "WashingMachine": "washing_machine",
}
"""Our category of an AI2-THOR object type; what is not here is no furniture of ours."""
IN_ROOM = {("SideTable", "bedroom"): "nightstand", ("Sink", "kitchen"): "kitchen_sink",
           ("ShelvingUnit", "living_room"): "bookshelf", ("ShelvingUnit", "bedroom"): "bookshelf"}

Sizes = dict[str, tuple[str, tuple[float, float, float]]]
"""Object type and size [depth, width, height] by asset id."""


def homes(root: Path | None, sizes: Path | None = None) -> Iterator[Layout]:
    """Every house below `root`; BadInput names the row that is none."""
    found = _json.files(root, "procthor", "ProcTHOR houses")
    known = read_sizes(sizes or _database(found))
    for path in found:
        if path.name == "asset-database.json":
            continue
        for number, row in enumerate(_json.rows(path), 1):
            try:
                yield layout(row, known)
            except (KeyError, TypeError, ValueError, IndexError) as error:
                raise BadInput(f"{path}, row {number}: not a ProcTHOR house ({error!r})") from error


def _database(found: list[Path]) -> Path:
    beside = [p for p in found if p.name == "asset-database.json"]
    spec = find_spec("procthor")
    places = (spec.submodule_search_locations or []) if spec else []
    for path in beside + [Path(p) / "databases" / "asset-database.json" for p in places]:
        if path.exists():
            return path
    raise BadInput("procthor: sizes unknown; put asset-database.json of the Python package procthor beside the houses")


@cache
def read_sizes(path: Path) -> Sizes:
    """Sizes by asset id; BadInput when the file is not that database."""
    try:
        groups = json.loads(path.read_text())
        return {
            a["assetId"]: (kind, (a["boundingBox"]["z"], a["boundingBox"]["x"], a["boundingBox"]["y"]))
            for kind, assets in groups.items() for a in assets
        }
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadInput(f"{path}: not ProcTHOR's asset database ({error!r})") from error


def layout(house: dict[str, Any], sizes: Sizes) -> Layout:
    """A house in our frame; things that are no furniture of ours are left out."""
    rooms: list[Room] = []
    ids: dict[str, str] = {}
    for row in house["rooms"]:
        type = ROOMS[row["roomType"]]
        outline = Polygon([(p["x"], p["z"]) for p in row["floorPolygon"]]).simplify(1e-6)
        room = _frames.room(type, 1 + sum(r.type == type for r in rooms), list(outline.exterior.coords))
        rooms.append(room)
        ids[row["id"]] = room.id
    height = max(p["y"] for wall in house["walls"] for p in wall["polygon"])
    openings = [o for key, kind in (("doors", "door"), ("windows", "window")) for o in _openings(house, key, kind, ids)]
    objects: list[Box] = []
    for row in _flat(house["objects"]):
        _place(row, rooms, ids, sizes, objects)
    return _frames.home(rooms, openings, objects, height).model_copy(update={"walls": WALLS})


def _flat(rows: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    for row in rows:
        yield row
        yield from _flat(row.get("children", []))


def _place(row: dict[str, Any], rooms: list[Room], ids: dict[str, str], sizes: Sizes, objects: list[Box]) -> None:
    kind, size = sizes.get(row["assetId"], ("", (0.0, 0.0, 0.0)))
    # Ids read "2|0", "small|2|0" or "Fridge|6|1": the first number is the room's.
    number = next((part for part in row["id"].split("|") if f"room|{part}" in ids), "")
    room = next((r for r in rooms if r.id == ids.get(f"room|{number}")), None)
    if kind not in CATEGORY or room is None:
        return
    name = IN_ROOM.get((kind, room.type), CATEGORY[kind])
    name = _words.by_size(name, size)
    p = row["position"]
    if name == "plant" and p["y"] - size[2] / 2 > 0.15:
        return
    yaw = np.pi / 2 - np.radians(row["rotation"]["y"])
    center = (p["x"], p["z"], p["y"])
    objects.append(_frames.box(f"{room.id}.{name}_{len(objects) + 1}", room.id, name, center, size, yaw))


def _openings(house: dict[str, Any], key: str, kind: str, ids: dict[str, str]) -> Iterator[Opening]:
    walls = {wall["id"]: wall["polygon"] for wall in house["walls"]}
    for number, row in enumerate(house[key], 1):
        start, end = (np.array([p["x"], p["z"]]) for p in walls[row["wall0"]][:2])
        along = (end - start) / np.hypot(*(end - start))
        left, right = (start + along * row["holePolygon"][k]["x"] for k in (0, 1))
        both = list(dict.fromkeys([ids[row["room0"]], ids[row["room1"]]]))
        one = kind if kind == "window" or len(both) == 2 else "entrance"
        if kind == "door" and row["assetId"].startswith("Doorframe"):
            one = "opening"
        yield Opening(
            id=f"{one}_{number}", kind=one, rooms=both, segment=(_point(left), _point(right)),
            sill=row["holePolygon"][0]["y"], head=row["holePolygon"][1]["y"],
        )


def _point(p: Any) -> Point:
    return float(p[0]), float(p[1])


def house(home: Layout, sizes: Sizes) -> dict[str, Any]:
    """The home as a house that ProcTHOR's format can hold: each object the known asset of its type nearest in size.

    What has no type there is left out; rooms of other types become living rooms.
    """
    number = {room.id: k for k, room in enumerate(home.rooms, 2)}
    outlines = {room.id: _outer(room, home.walls.inner / 2) for room in home.rooms}
    types = {ours: theirs for theirs, ours in ROOMS.items()}
    rooms = [
        {"id": f"room|{number[r.id]}", "roomType": types.get(r.type, "LivingRoom"), "children": [], "ceilings": [],
         "floorPolygon": [_xyz(x, 0.0, y) for x, y in reversed(outlines[r.id])]}
        for r in home.rooms
    ]
    walls = {r.id: _walls(number[r.id], outlines[r.id], home.height) for r in home.rooms}
    doors = [_door(o, k, number, walls) for k, o in enumerate(home.openings) if o.kind != "window"]
    windows = [_door(o, k, number, walls) for k, o in enumerate(home.openings) if o.kind == "window"]
    objects = [row for k, o in enumerate(home.objects) if (row := _thing(o, k, number, sizes)) is not None]
    return {"rooms": rooms, "doors": doors, "windows": windows, "objects": objects,
            "walls": [wall for some in walls.values() for wall in some],
            "proceduralParameters": {}, "metadata": {"schema": "1.0.0"}}


def _xyz(x: float, y: float, z: float) -> dict[str, float]:
    return {"x": round(x, 4), "y": round(y, 4), "z": round(z, 4)}


def _outer(room: Room, by: float) -> list[Point]:
    """The room's outline on the centre lines of its walls."""
    grown = Polygon(room.polygon).buffer(by, join_style="mitre").simplify(1e-6)
    return _frames.counter_clockwise(list(grown.exterior.coords))


def _walls(number: int, outline: list[Point], height: float) -> list[dict[str, Any]]:
    found = []
    for (ax, ay), (bx, by) in zip(outline, [*outline[1:], outline[0]], strict=True):
        name = f"wall|{number}|{ax:.2f}|{ay:.2f}|{bx:.2f}|{by:.2f}"
        corners = [_xyz(ax, 0.0, ay), _xyz(bx, 0.0, by), _xyz(ax, height, ay), _xyz(bx, height, by)]
        found.append({"id": name, "roomId": f"room|{number}", "polygon": corners})
    return found


def _door(o: Opening, k: int, number: dict[str, int], walls: dict[str, list[dict[str, Any]]]) -> dict[str, Any]:
    ends, wall = np.array(o.segment), _nearest(np.mean(o.segment, axis=0), walls[o.rooms[0]])
    start, end = (np.array([p["x"], p["z"]]) for p in wall["polygon"][:2])
    place = np.sort((ends - start) @ (end - start) / np.hypot(*(end - start)))
    both = [number[o.rooms[0]], number[o.rooms[-1]]]
    other = _nearest(np.mean(o.segment, axis=0), walls[o.rooms[-1]])["id"]
    beyond = other if len(o.rooms) == 2 else "wall|exterior|" + wall["id"].split("|", 2)[2]
    asset = {"window": "Window_Hung_48x36", "opening": "Doorframe_1"}.get(o.kind, "Doorway_1")
    return {
        "id": f"{'window' if o.kind == 'window' else 'door'}|{both[0]}|{both[1]}|{k}", "assetId": asset,
        "room0": f"room|{both[0]}", "room1": f"room|{both[1]}", "wall0": wall["id"], "wall1": beyond,
        "holePolygon": [_xyz(float(place[0]), o.sill, 0.0), _xyz(float(place[1]), o.head, 0.0)],
        "assetPosition": _xyz(float(place.mean()), (o.sill + o.head) / 2, 0.0),
        "openable": o.kind in ("door", "entrance"), "openness": 0,
    }


def _nearest(point: Any, walls: list[dict[str, Any]]) -> dict[str, Any]:
    """The wall whose line comes nearest to a plan point."""
    def away(wall: dict[str, Any]) -> float:
        a, b = (np.array([p["x"], p["z"]]) for p in wall["polygon"][:2])
        share = np.clip((point - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        return float(np.hypot(*(a + share * (b - a) - point)))

    return min(walls, key=away)


def _thing(o: Box, k: int, number: dict[str, int], sizes: Sizes) -> dict[str, Any] | None:
    alike = {"single_bed": "double_bed", "corner_sofa": "sofa", "round_table": "dining_table", "office_chair": "chair",
             "nightstand": "side_table", "kitchen_sink": "vanity", "bookshelf": "shelving"}
    kinds = [kind for kind, ours in CATEGORY.items() if ours == alike.get(o.category, o.category)]
    fits = [(name, size) for name, (kind, size) in sizes.items() if kind in kinds]
    if not fits:
        return None
    name, size = min(fits, key=lambda row: (sum(abs(a - b) for a, b in zip(row[1], o.size, strict=True)), row[0]))
    x, y, z = o.center
    turn = float(np.degrees(np.pi / 2 - o.yaw) % 360)
    bottom = z - o.size[2] / 2
    return {"id": f"{number[o.room]}|{k}", "assetId": name, "kinematic": True, "children": [],
            "position": _xyz(x, bottom + size[2] / 2, y), "rotation": {"x": 0, "y": round(turn, 3), "z": 0}}
