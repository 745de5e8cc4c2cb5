"""ProcTHOR and AI2-THOR houses as JSON or JSON lines: published ones, and those that the exporter writes.

Unity's axes: y up, left-handed, yaw clockwise in degrees, an object's front +z, `position` the box's centre. Sizes
come from `asset-database.json` of the Python package `procthor`: given as `sizes`, found beside or below `root`, or in
the installed package. Walls have no thickness there, and next to none in the plan that is read.

Exported houses need no sizes: each part says under `apartgen` what THOR has no field for. Their boxes are those of the
assets that stand in them, and what the exporter left out stays out.
"""

import json
import logging
from collections import Counter
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from shapely.geometry import Polygon

from apartgen.schemas.base import Point, RoomType
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Room, Walls
from apartgen.stages.layout.datasets import _frames, _json, _words
from apartgen.stages.things.categories import TABLE

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
Part = dict[str, Any]
DATABASE = "asset-database.json"
log = logging.getLogger("apartgen")


def homes(root: Path | None, sizes: Path | None = None) -> Iterator[Layout]:
    """Every house below `root`; BadInput names the row that is none, and a message the things left out of all."""
    found = _json.files(root, "procthor", "ProcTHOR houses")
    left_out: Counter[str] = Counter()
    for path in found:
        if path.name == DATABASE:
            continue
        for number, row in enumerate(_json.rows(path), 1):
            if isinstance(row, dict) and row.get("apartgen") == "export":
                continue  # the record that an export leaves beside its house
            try:
                known = {} if all("apartgen" in o for o in _flat(row["objects"])) else _sizes(sizes, found)
                yield layout(row, known, left_out)
            except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
                raise BadInput(f"{path}, row {number}: not a ProcTHOR house ({_json.fault(error)})") from error
    if left_out:
        kinds = ", ".join(f"{kind} ({count})" for kind, count in sorted(left_out.items()))
        log.info("procthor: left out what is no furniture here: %s", kinds)


def _sizes(given: Path | None, found: list[Path]) -> Sizes:
    spec = find_spec("procthor")
    installed = [Path(p) / "databases" / DATABASE for p in (spec.submodule_search_locations or [])] if spec else []
    beside = [p for p in found if p.name == DATABASE] + [found[0].parent / DATABASE]
    for path in [given] if given else beside + installed:
        if path == given or path.exists():
            return read_sizes(path)
    raise BadInput(f"procthor: sizes unknown; put {DATABASE} of the Python package procthor beside the houses")


@cache
def read_sizes(path: Path) -> Sizes:
    """Sizes by asset id; BadInput when the file is not that database."""
    try:
        groups = json.loads(path.read_text())
        return {a["assetId"]: (kind, _size(a["boundingBox"])) for kind, assets in groups.items() for a in assets}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise BadInput(f"{path}: not ProcTHOR's asset database ({error!r})") from error


def _size(box: dict[str, float]) -> tuple[float, float, float]:
    return box["z"], box["x"], box["y"]


def category(kind: str, room: RoomType, size: tuple[float, float, float]) -> str:
    """Our category of an AI2-THOR type in a type of room; empty for what is no furniture of ours."""
    return _words.by_size(IN_ROOM.get((kind, room), CATEGORY.get(kind, "")), size)


def layout(house: Part, sizes: Sizes, left_out: Counter[str] | None = None) -> Layout:
    """A house in our frame; what is no furniture of ours is left out, and counted by type in `left_out`."""
    said = house.get("metadata", {}).get("apartgen")
    walls = Walls(**said["walls"]) if said else WALLS
    rooms: dict[str, Room] = {}
    for row in house["rooms"]:
        rooms[row["id"]] = _room(row, list(rooms.values()), walls.inner / 2 if said else 0.0)
    height = max(p["y"] for wall in house["walls"] for p in wall["polygon"])
    beyond = (walls.outer - walls.inner) / 2
    openings = [o for key, kind in (("doors", "door"), ("windows", "window"))
                for o in _openings(house, key, kind, rooms, beyond)]
    objects: list[Box] = []
    for row in _flat(house["objects"]):
        one = _box(row, rooms, sizes, len(objects) + 1)
        if one is not None:
            objects.append(one)
        elif left_out is not None:
            left_out[sizes.get(row["assetId"], (row.get("objectType", "unknown"),))[0]] += 1
    return _frames.home(list(rooms.values()), openings, objects, height).model_copy(update={"walls": walls})


def _room(row: Part, before: list[Room], inset: float) -> Room:
    """The clear floor, `inset` within the middle of its walls."""
    own = row.get("apartgen", {})
    type = own.get("type") or ROOMS[row["roomType"]]
    floor = Polygon([(p["x"], p["z"]) for p in row["floorPolygon"]])
    floor = (floor.buffer(-inset, join_style="mitre") if inset else floor).simplify(1e-6)
    if not isinstance(floor, Polygon) or floor.is_empty:
        raise ValueError(f"{row['id']} is narrower than its walls")
    room = _frames.room(type, 1 + sum(r.type == type for r in before), list(floor.exterior.coords))
    return room.model_copy(update={"id": own["id"]}) if own else room


def _flat(rows: list[Part]) -> Iterator[Part]:
    for row in rows:
        yield row
        yield from _flat(row.get("children", []))


def _box(row: Part, rooms: dict[str, Room], sizes: Sizes, number: int) -> Box | None:
    """The object; None for what is no furniture of ours or stands in no room."""
    room, own = rooms.get(_room_of(row, rooms)), row.get("apartgen")
    if room is None:
        return None
    p = row["position"]
    if own:
        name, size = own["category"], _size(row["boundingBox"])
    else:
        kind, size = sizes.get(row["assetId"], ("", (0.0, 0.0, 0.0)))
        name = category(kind, room.base, size)
    if name not in TABLE or (not own and name == "plant" and p["y"] - size[2] / 2 > 0.15):
        return None
    yaw = np.pi / 2 - np.radians(row["rotation"]["y"])
    id = own["id"] if own else f"{room.id}.{name}_{number}"
    return _frames.box(id, room.id, name, (p["x"], p["z"], p["y"]), size, yaw)


def _room_of(row: Part, rooms: dict[str, Room]) -> str:
    """Published ids read "2|0", "small|2|0" or "Fridge|6|1": the first number is the room's."""
    numbers = (f"room|{part}" for part in row["id"].split("|") if f"room|{part}" in rooms)
    return str(row["room"]) if "room" in row else next(numbers, "")


def _openings(house: Part, key: str, kind: str, rooms: dict[str, Room], beyond: float) -> Iterator[Opening]:
    """In the middle of their walls: that of an outer wall is `beyond` outside the sheet that the hole is in."""
    walls = {wall["id"]: wall["polygon"] for wall in house["walls"]}
    for number, row in enumerate(house[key], 1):
        start, end = (np.array([p["x"], p["z"]]) for p in walls[row["wall0"]][:2])
        along = (end - start) / np.hypot(*(end - start))
        both = list(dict.fromkeys([rooms[row["room0"]].id, rooms[row["room1"]].id]))
        # Sheets run clockwise about their room, so the open air is on their left.
        shift = beyond * np.array([-along[1], along[0]]) if len(both) == 1 else np.zeros(2)
        left, right = (start + shift + along * row["holePolygon"][k]["x"] for k in (0, 1))
        one = kind if kind == "window" or len(both) == 2 else "entrance"
        if kind == "door" and row["assetId"].startswith("Doorframe"):
            one = "opening"
        own = row.get("apartgen", {"id": f"{one}_{number}", "kind": one})
        yield Opening(
            rooms=both, segment=(_point(left), _point(right)), sill=row["holePolygon"][0]["y"],
            head=row["holePolygon"][1]["y"], **own,
        )


def _point(p: Any) -> Point:
    return float(p[0]), float(p[1])
