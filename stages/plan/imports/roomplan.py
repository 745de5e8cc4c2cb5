"""Apple RoomPlan scans, a CapturedRoom or CapturedStructure as JSON: walls, openings, floors, sections, objects.

Metres, y up, right-handed; a transform is a 4 × 4 matrix by columns, and a surface's own x runs along its width.
"""

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import Point as Place
from shapely.geometry import Polygon

from apartgen.schemas.base import Point
from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.drawing import Drawing, Hole, Space, Thing
from apartgen.stages.plan.imports._walls import Axis, bodies

Array = NDArray[np.float64]
Part = dict[str, Any]
SHEET = 0.004
"""Thickness given to walls, which are scanned from inside and have none, m."""
KINDS = {"doors": "door", "windows": "window", "openings": "opening"}
OBJECTS = {
    "storage": "sideboard",
    "refrigerator": "fridge",
    "stove": "hob",
    "bed": "bed",
    "sink": "vanity",
    "washerDryer": "washing machine",
    "toilet": "toilet",
    "bathtub": "bath",
    "oven": "oven",
    "dishwasher": "dishwasher",
    "table": "dining table",
    "sofa": "sofa",
    "chair": "chair",
    "fireplace": "fireplace",
    "television": "tv",
    "stairs": "stairs",
}
"""What its categories of objects are called here."""
TALL = 1.6
"""Storage from this height on is a wardrobe, m."""


def holds(name: str, data: bytes) -> bool:
    """JSON with walls that have transforms."""
    return data.lstrip()[:1] == b"{" and b'"walls"' in data and b'"transform"' in data and b'"dimensions"' in data


def read(name: str, data: bytes) -> Drawing:
    """The lowest storey of the scan."""
    try:
        raw = json.loads(data)
    except ValueError as error:
        raise BadInput(f"not JSON: {error}") from None
    said: list[str] = []
    found = {key: _storey(raw, key) for key in ("walls", "floors", "objects", "sections", *KINDS)}
    base = _base(found["walls"])
    spaces = [
        space for k, floor in enumerate(found["floors"]) if (space := _space(floor, f"floors[{k}]", found)) is not None
    ]
    if len(spaces) < len(found["sections"]):
        said.append(f"{len(found['sections'])} rooms are named, but {len(spaces)} have a floor of their own")
    walls = [(_matrix(wall, f"walls[{k}]"), wall) for k, wall in enumerate(found["walls"])]
    axes = [Axis(_ends(matrix, wall["dimensions"][0]), SHEET) for matrix, wall in walls if wall["dimensions"][0] > 0.05]
    heights = [float(wall["dimensions"][1]) for _, wall in walls]
    holes = [_hole(part, f"{key}[{k}]", KINDS[key], base) for key in KINDS for k, part in enumerate(found[key])]
    things = [_thing(part, f"objects[{k}]", base) for k, part in enumerate(found["objects"])]
    return Drawing(
        spaces=spaces,
        walls=bodies(axes),
        holes=holes,
        things=things,
        said=said,
        height=float(np.median(heights)) if heights else None,
    )


def _storey(raw: Part, key: str) -> list[Part]:
    """The parts of the lowest storey; those of a structure's rooms where it has none of its own."""
    rooms = raw.get("rooms") if isinstance(raw.get("rooms"), list) else []
    parts = raw.get(key) or [part for room in rooms or [] for part in room.get(key) or []]
    if not isinstance(parts, list) or not all(isinstance(part, dict) for part in parts):
        raise BadInput(f"{key}: not a list of objects")
    lowest = min((part.get("story") or 0 for part in raw.get("walls") or parts), default=0)
    return [part for part in parts if (part.get("story") or 0) == lowest]


def _matrix(part: Part, where: str) -> Array:
    try:
        matrix = np.array(part["transform"], float).reshape(4, 4).T
        if np.isfinite(matrix).all() and np.isfinite(np.array(part["dimensions"], float)).all():
            return matrix
    except (KeyError, TypeError, ValueError):
        pass
    raise BadInput(f"{where}: transform must be 16 numbers and dimensions three")


def _base(walls: list[Part]) -> float:
    """Height of the floor: where walls stand."""
    feet = [_matrix(wall, f"walls[{k}]")[1, 3] - wall["dimensions"][1] / 2 for k, wall in enumerate(walls)]
    return float(np.median(feet)) if feet else 0.0


def _flat(p: Array) -> Point:
    return float(p[0]), float(-p[2])


def _ends(matrix: Array, width: float) -> Array:
    across = 0.5 * width * matrix[:3, 0]
    return np.array([_flat(matrix[:3, 3] - across), _flat(matrix[:3, 3] + across)])


def _space(floor: Part, where: str, found: dict[str, list[Part]]) -> Space | None:
    """A floor by its corners, named by the section in it."""
    matrix = _matrix(floor, where)
    corners = [np.array([*map(float, corner), 0.0, 0.0][:3]) for corner in floor.get("polygonCorners") or []]
    if len(corners) < 3:
        w, d = (float(v) / 2 for v in floor["dimensions"][:2])
        corners = [np.array([x, y, 0.0]) for x, y in ((-w, -d), (w, -d), (w, d), (-w, d))]
    outline = Polygon([_flat(matrix[:3, :3] @ corner + matrix[:3, 3]) for corner in corners])
    if outline.area < 0.05:
        return None
    labels = [
        str(section.get("label", ""))
        for section in found["sections"]
        if "center" in section and outline.intersects(Place(_flat(np.array(section["center"], float))))
    ]
    return Space(next((label for label in labels if label != "unidentified"), ""), outline)


def _category(part: Part) -> str:
    """Swift encodes an enumeration as {"door": {"isOpen": true}}; some write its name alone."""
    given = part.get("category", "")
    return str(next(iter(given), "")) if isinstance(given, dict) else str(given)


def _hole(part: Part, where: str, kind: Any, base: float) -> Hole:
    matrix = _matrix(part, where)
    width, height = (float(v) for v in part["dimensions"][:2])
    a, b = _ends(matrix, width)
    sill = float(matrix[1, 3]) - height / 2 - base
    return Hole(where, kind, ((a[0], a[1]), (b[0], b[1])), sill, sill + height)


def _thing(part: Part, where: str, base: float) -> Thing:
    """The box; its own +z is the front."""
    matrix = _matrix(part, where)
    width, height, depth = (max(float(v), 0.01) for v in part["dimensions"])
    kind = _category(part)
    name = "wardrobe" if kind == "storage" and height >= TALL else OBJECTS.get(kind, kind)
    x, y = _flat(matrix[:3, 3])
    fx, fy = _flat(matrix[:3, 2])
    return Thing(name, (x, y, float(matrix[1, 3]) - base), (depth, width, height), float(np.arctan2(fy, fx)))
