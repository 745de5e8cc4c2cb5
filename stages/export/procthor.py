"""ProcTHOR house JSON: rooms, walls, doors, windows and objects as AI2-THOR's procedural houses have them.

THOR's world is left-handed and y up: (x, y, z) here is (x, z, y) there, and headings turn clockwise from +z, in
degrees. Its walls are sheets: rooms grow by half an inner wall, so that neighbours share theirs.

THOR loads none but its own assets. Where the Python package `procthor` is installed, which lists them, each object is
the one of its type that is nearest in size, and what has no like is left out; elsewhere objects are named by their
apartgen asset, with its box. What THOR has no field for, each part says under `apartgen`: ids, types of room,
categories, hinges, the thickness of walls; `stages/layout/datasets/procthor.py` reads it again.
"""

import json
import logging
from pathlib import Path
from typing import Any

import numpy as np
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.polygon import orient

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.export import _thor
from apartgen.stages.export._readback import read_json
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import polygons
from apartgen.stages.things.carrying import told
from apartgen.stages.things.categories import TABLE

ROOMS = {"living_room": "LivingRoom", "kitchen": "Kitchen", "bedroom": "Bedroom", "bathroom": "Bathroom"}
"""THOR has four types of room; any other counts as a living room."""
log = logging.getLogger("apartgen")
OUTSIDE = "exterior"
TILES, PAINT = "bathroomTilesGrey", "PureWhite"
ROUNDING = 2e-3  # m, of corners
Part = dict[str, Any]
Corner = tuple[float, float]
Stretch = tuple[Corner, Corner]
Triple = tuple[float, float, float]


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, house.json."""
    path = out / "house.json"
    path.write_text(json.dumps(_house(scene), indent=1) + "\n", encoding="utf-8")
    return [path]


def read_back(files: list[Path]) -> None:
    """By the parser of JSON."""
    read_json(files)


def _house(scene: Scene) -> Part:
    home = scene.home
    scene.bodies  # noqa: B018  what has no assets can't be written
    objects = told(home.objects, home.height) if isinstance(home, Layout) else []
    stretches = _stretches(home)
    openings = [_opening(o, stretches) for o in home.openings]
    known = _thor.furniture()
    return {
        "rooms": [_room(room, home) for room in home.rooms],
        "walls": _walls(home, stretches),
        "doors": [part for part, o in zip(openings, home.openings) if o.kind != "window"],
        "windows": [part for part, o in zip(openings, home.openings) if o.kind == "window"],
        "objects": _theirs(objects, known) if known else [_ours(o) for o in objects],
        "proceduralParameters": {
            "ceilingMaterial": {"name": PAINT}, "floorColliderThickness": 1.0, "receptacleHeight": 0.7,
            "skyboxId": "Sky1", "reflections": [],
            "lights": [_light(light.name, light.position, light.lumens) for light in scene.lights],
        },
        "metadata": {
            "schema": "1.0.0", "agent": _agent(home), "assets": "AI2-THOR" if known else "apartgen",
            "credits": scene.credits, "apartgen": {"walls": home.walls.model_dump()},
        },
    }  # fmt: skip


def _xyz(x: float, y: float, z: float = 0.0) -> Part:
    """A point of ours in THOR's axes."""
    return {"x": round(float(x), 4), "y": round(float(z), 4), "z": round(float(y), 4)}


def _heading(yaw: float) -> float:
    return round(float((90 - np.degrees(yaw)) % 360), 3)


def _outline(room: Room, home: Plan) -> list[Corner]:
    """Corners of the room grown to the middle of inner walls, clockwise seen from above, to the millimetre."""
    grown = polygons.floor(room).buffer(home.walls.inner / 2, join_style="mitre")
    points = orient(Polygon(grown.exterior), -1.0).exterior.coords[:-1]
    return [(round(x, 3) + 0.0, round(y, 3) + 0.0) for x, y in points]


def _stretches(home: Plan) -> dict[str, list[Stretch]]:
    """Each room's sides, parted where a neighbour's corner lies on them, so that two rooms share whole stretches."""
    outlines = {room.id: _outline(room, home) for room in home.rooms}
    every = sorted({corner for outline in outlines.values() for corner in outline})
    found = {}
    for id, outline in outlines.items():
        sides = [LineString(side) for side in zip(outline, [*outline[1:], outline[0]])]
        found[id] = [stretch for side in sides for stretch in _parted(side, every)]
    return found


def _parted(side: LineString, corners: list[Corner]) -> list[Stretch]:
    on_it = sorted((side.project(Point(c)), c) for c in corners if side.distance(Point(c)) < ROUNDING)
    points = [c for at, c in on_it]
    return [(a, b) for a, b in zip(points, points[1:]) if Point(a).distance(Point(b)) > ROUNDING]


def _name(owner: str, stretch: Stretch) -> str:
    (ax, ay), (bx, by) = sorted(stretch)
    return f"wall|{owner}|{ax:.2f}|{ay:.2f}|{bx:.2f}|{by:.2f}"


def _room(room: Room, home: Plan) -> Part:
    return {
        "id": f"room|{room.id}", "roomType": ROOMS.get(room.base, "LivingRoom"),
        "apartgen": {"id": room.id, "type": room.type},
        "floorPolygon": [_xyz(x, y) for x, y in _outline(room, home)], "floorMaterial": {"name": "WoodFloorsCross"},
        "children": [], "ceilings": [], "layer": "Procedural0",
    }  # fmt: skip


def _walls(home: Plan, stretches: dict[str, list[Stretch]]) -> list[Part]:
    """A sheet for each side of each stretch: two rooms', or a room's and the open air's."""
    owned = {(id, frozenset(stretch)) for id, own in stretches.items() for stretch in own}
    types = {room.id: room.base for room in home.rooms}
    found = []
    for id, own in stretches.items():
        for stretch in own:
            found.append(_wall(id, stretch, home.height, types[id] == "bathroom"))
            if not any((other, frozenset(stretch)) in owned for other in stretches if other != id):
                found.append(_wall(OUTSIDE, (stretch[1], stretch[0]), home.height, False))
    return found


def _wall(owner: str, stretch: Stretch, height: float, tiled: bool) -> Part:
    (ax, ay), (bx, by) = stretch
    return {
        "id": _name(owner, stretch), "roomId": OUTSIDE if owner == OUTSIDE else f"room|{owner}",
        "polygon": [_xyz(ax, ay), _xyz(bx, by), _xyz(ax, ay, height), _xyz(bx, by, height)],
        "material": {"name": TILES if tiled else PAINT}, "layer": "Procedural0",
    }  # fmt: skip


def _opening(opening: Opening, stretches: dict[str, list[Stretch]]) -> Part:
    """A hole in the stretch it lies on, measured along the first room's sheet from its start."""
    a, b = np.asarray(opening.segment, float)
    middle, owner = Point(*(a + b) / 2), opening.rooms[0]
    stretch = min(stretches[owner], key=lambda s: LineString(s).distance(middle))
    at, half = LineString(stretch).project(middle), float(np.hypot(*(b - a))) / 2
    runs_alike = float((b - a) @ np.subtract(stretch[1], stretch[0])) > 0
    beyond = opening.rooms[1] if len(opening.rooms) > 1 else OUTSIDE
    kind = "window" if opening.kind == "window" else "door"
    part: Part = {
        "id": f"{kind}|{opening.id}", "room0": f"room|{owner}", "room1": f"room|{opening.rooms[-1]}",
        "wall0": _name(owner, stretch), "wall1": _name(beyond, stretch), "assetId": _asset(opening),
        "holePolygon": [_xyz(at - half, 0, opening.sill), _xyz(at + half, 0, opening.head)],
        "assetPosition": _xyz(at, 0, (opening.sill + opening.head) / 2),
        "apartgen": {  # the hinge is at the hole's first or second corner
            "id": opening.id, "kind": opening.kind, "into": opening.into,
            "hinge": opening.hinge if runs_alike else 1 - opening.hinge,
        },
    }  # fmt: skip
    return part | ({} if kind == "window" else {"openable": opening.into is not None, "openness": 0})


def _asset(opening: Opening) -> str:
    """THOR's own asset of the kind."""
    width = polygons.width(opening)
    if opening.kind == "window":
        return _thor.window(width, opening.head - opening.sill)
    return _thor.passage(width, opening.kind != "opening")


def _ours(o: Box) -> Part:
    asset = f"{o.asset.library}/{o.asset.id}" if isinstance(o, Furnishing) else ""
    return _object(o, asset, o.category.title().replace("_", ""), o.center, o.size)


def _theirs(objects: list[Box], known: list[_thor.Model]) -> list[Part]:
    """The objects as THOR's assets."""
    found = _thor.dressed(objects, known)
    bare = sorted({o.category for o in objects if o.id not in found})
    if bare:
        log.info("AI2-THOR has no like of some objects, which are left out: %s", ", ".join(bare))
    put = [(o, *found[o.id]) for o in objects if o.id in found]
    return [_object(o, model.id, model.kind, middle, model.size) for o, model, middle in put]


def _object(o: Box, asset: str, kind: str, middle: Triple, size: Triple) -> Part:
    depth, width, height = size
    return {
        "id": o.id, "assetId": asset, "objectType": kind, "room": f"room|{o.room}", "position": _xyz(*middle),
        "rotation": {"x": 0, "y": _heading(o.yaw), "z": 0}, "boundingBox": _xyz(width, depth, height),
        "kinematic": not (o.category in TABLE and TABLE[o.category].loose), "children": [], "layer": "Procedural0",
        "apartgen": {"id": o.id, "category": o.category},
    }  # fmt: skip


def _light(name: str, at: Any, lumens: float) -> Part:
    return {
        "id": name, "type": "point", "position": _xyz(*at), "intensity": round(lumens / 1500, 3), "range": 15,
        "rgb": {"r": 1.0, "g": 0.93, "b": 0.82},
        "shadow": {"type": "Soft", "strength": 1, "normalBias": 0, "bias": 0.05},
    }  # fmt: skip


def _agent(home: Plan) -> Part:
    """Inside the entrance, looking in; without one, in the first room."""
    ways = [o for o in home.openings if o.kind == "entrance"]
    x, y = polygons.floor(home.rooms[0]).representative_point().coords[0]
    heading = 0.0
    if ways:
        normal, reach = polygons.face(ways[0], home, ways[0].rooms[0])
        x, y = np.mean(np.asarray(ways[0].segment, float), axis=0) + (reach + 0.5) * normal
        heading = _heading(float(np.arctan2(normal[1], normal[0])))
    turn = {"x": 0, "y": heading, "z": 0}
    return {"position": _xyz(x, y, 0.95), "rotation": turn, "standing": True, "horizon": 30}
