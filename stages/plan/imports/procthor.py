"""ProcTHOR and AI2-THOR houses as JSON, published ones and those that the exporter writes.

Unity's axes: y up, left-handed, yaw clockwise in degrees, an object's front +z. Walls are sheets that two rooms share.
"""

import json
from collections.abc import Iterator
from typing import Any

import numpy as np
from shapely.geometry import MultiPoint, Polygon
from shapely.ops import nearest_points

from apartgen.schemas.base import Point
from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.drawing import Drawing, Hole, Space, Thing
from apartgen.stages.plan.imports._walls import Axis, bodies
from apartgen.stages.things.categories import TABLE, by_word
from apartgen.stages.things.words import OTHER, split

Part = dict[str, Any]
SHEET = 0.004
"""Thickness given to walls, m."""


def holds(name: str, data: bytes) -> bool:
    """JSON whose rooms have floors in THOR's words."""
    return data.lstrip()[:1] == b"{" and b'"floorPolygon"' in data


def read(name: str, data: bytes) -> Drawing:
    """The house."""
    try:
        house = json.loads(data)
    except ValueError as error:
        raise BadInput(f"not the JSON of one house: {error}") from None
    where = "rooms"
    try:
        own = (house.get("metadata") or {}).get("apartgen", {}).get("walls", {})
        inner = float(own.get("inner", 0.0))
        spaces = [_space(room, inner / 2) for room in house["rooms"]]
        where = "walls"
        walls = {wall["id"]: wall for wall in house["walls"]}
        height = max(float(p["y"]) for wall in walls.values() for p in wall["polygon"])
        axes = [] if own else [Axis(_axis(wall), SHEET) for wall in walls.values() if not wall.get("empty")]
        where = "doors and windows"
        floors = {space.name: space.floor for space in spaces}
        holes = [
            _hole(row, kind, walls, floors)
            for key, kind in (("doors", "door"), ("windows", "window"))
            for row in house[key]
        ]
        where = "objects"
        said: list[str] = []
        things = [
            thing for row, depth in _flat(house.get("objects") or []) if (thing := _thing(row, depth, said)) is not None
        ]
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise BadInput(f"{where}: not those of a ProcTHOR house ({type(error).__name__}: {error})") from None
    if said:
        said = [f"sizes of {len(said)} objects are not in the file: usual ones taken"]
    return Drawing(
        spaces=spaces,
        walls=[body for body in bodies(axes) if body.area > 0],
        holes=holes,
        things=things,
        height=height,
        outer=own.get("outer"),
        said=said,
    )


def _point(p: Part) -> Point:
    return float(p["x"]), float(p["z"])


def _space(room: Part, inset: float) -> Space:
    floor = Polygon([_point(p) for p in room["floorPolygon"]])
    name = room.get("apartgen", {}).get("id") or room.get("roomType", "")
    return Space(str(name), floor.buffer(-inset, join_style="mitre") if inset else floor)


def _axis(wall: Part) -> np.ndarray:
    return np.array([_point(p) for p in wall["polygon"][:2]])


def _hole(row: Part, kind: Any, walls: dict[str, Part], floors: dict[str, Polygon]) -> Hole:
    """A hole is measured along its first wall from that one's start; exported ones say how their leaf turns."""
    start, end = _axis(walls[row["wall0"]])
    wall = float(np.hypot(*(end - start)))
    if not 0 < wall < np.inf:
        raise ValueError(f"{row.get('id', 'one')} is in a wall of {wall:g} m")
    along = (end - start) / wall
    a, b = (start + float(p["x"]) * along for p in row["holePolygon"])
    sill, head = (float(p["y"]) for p in row["holePolygon"])
    bare = kind == "door" and str(row.get("assetId", "")).startswith("Doorframe")
    own = row.get("apartgen", {})
    ends = (float(a[0]), float(a[1])), (float(b[0]), float(b[1]))
    hinge = ends[int(own.get("hinge", 0))] if own.get("into") in floors else None
    swung = nearest_points(floors[own["into"]], MultiPoint(ends).centroid)[0] if hinge else None
    into = (float(swung.x), float(swung.y)) if swung else None
    return Hole(str(row.get("id", "")), "opening" if bare else kind, ends, sill, head, hinge, into)


def _flat(rows: list[Part], depth: int = 0) -> Iterator[tuple[Part, int]]:
    """Objects, and how deep each stands in others."""
    for row in rows:
        yield row, depth
        yield from _flat(row.get("children") or [], depth + 1)


def _thing(row: Part, depth: int, said: list[str]) -> Thing | None:
    """An object; None for small things, which have no kind of ours."""
    kind = row.get("apartgen", {}).get("category") or _kind(str(row.get("assetId", "")))
    if kind not in TABLE or (depth and TABLE[kind].place == "floor"):
        return None
    (x, y), z = _point(row["position"]), float(row["position"]["y"])
    yaw = float(np.pi / 2 - np.radians(float(row["rotation"]["y"])))
    if box := row.get("boundingBox"):
        return Thing(kind, (x, y, z), (float(box["z"]), float(box["x"]), float(box["y"])), yaw)
    said.append(kind)
    d, w, h = TABLE[kind].size
    if TABLE[kind].place == "floor":  # what stands on the floor is twice as high as its middle
        h = float(np.clip(2 * z, TABLE[kind].min[2], TABLE[kind].max[2]))
        z = h / 2
    return Thing(kind, (x, y, z), (d, w, h), yaw, sized=False)


def _kind(asset: str) -> str:
    """Our category of an asset whose name begins with a word for one, such as `Dining_Table_203_1`."""
    words = split(asset.replace("RoboTHOR", ""))
    begun = [" ".join(words[:length]) for length in range(len(words), 0, -1)]
    return next((by_word()[run] for run in begun if run in by_word()), OTHER)
