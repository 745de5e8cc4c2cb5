"""Raw 3D-FRONT houses: `<house>.json` files with 3D-FUTURE's `model_info.json` beside or above them.

Furniture is joined by `jid`; where `category` is null the super-category serves; what is marked invalid is left out.
Sizes are `bbox` × scale, else measured on `<jid>/raw_model.obj`. Axes: y up, front +z, `pos` under the middle.
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from shapely.geometry import Point, Polygon

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Room
from apartgen.stages.layout.datasets import _frames, _json, _words
from apartgen.stages.space.boxes import Array

OPENS_WITHIN = 0.4
"""An opening belongs to the rooms whose floor comes so close to its middle, m."""
KINDS = {"Door": "door", "Window": "window", "BayWindow": "window", "Hole": "opening"}

Models = dict[str, str]
"""English name of each model by jid."""


def homes(root: Path | None) -> Iterator[Layout]:
    """Every house below `root` that has rooms of types that we know."""
    found = _json.files(root, "front3d", "3D-FRONT houses and model_info.json")
    info = [p for p in found if p.name == "model_info.json"]
    if not info:
        raise BadInput(f"{root}: model_info.json of 3D-FUTURE is missing; put it beside the houses")
    models = read_models(info[0])
    for path in found:
        if path.name == "model_info.json":
            continue
        for row in _json.rows(path):
            try:
                home = layout(row, models, path.parent)
            except (AttributeError, KeyError, TypeError, ValueError, IndexError) as error:
                raise BadInput(f"{path}: not a 3D-FRONT house ({_json.fault(error)})") from error
            if home is not None:
                yield home


def read_models(path: Path) -> Models:
    """Names from `model_info.json`; an entry without category is known by its super-category."""
    try:
        rows = json.loads(path.read_text())
        return {row["model_id"]: str(row.get("category") or row.get("super-category") or "") for row in rows}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BadInput(f"{path}: not 3D-FUTURE's model_info.json ({error!r})") from error


def layout(house: dict[str, Any], models: Models, folder: Path) -> Layout | None:
    """A house in our frame, None without any room that we know."""
    meshes = {mesh["uid"]: mesh for mesh in house["mesh"]}
    pieces = {p["uid"]: p for p in house["furniture"] if p.get("valid", True)}
    rooms: list[Room] = []
    objects: list[Box] = []
    holes: dict[str, dict[str, Any]] = {}
    for row in house["scene"]["room"]:
        type = _words.room_type(row["type"] or "")
        parts = [meshes[c["ref"]] for c in row["children"] if c["ref"] in meshes]
        outline = _floor([m for m in parts if m["type"] == "Floor"])
        if type is None or outline is None:
            continue
        holes |= {m["uid"]: m for m in parts if m["type"] in KINDS}
        room = _frames.room(type, 1 + sum(r.type == type for r in rooms), list(outline.exterior.coords))
        rooms.append(room)
        for child in row["children"]:
            if child["ref"] in pieces:
                _place(child, pieces[child["ref"]], room, models, folder, objects)
    if not rooms:
        return None
    top = max(float(_vertices(m)[:, 1].max()) for m in meshes.values())
    openings = [o for k, mesh in enumerate(holes.values(), 1) if (o := _opening(mesh, k, rooms)) is not None]
    return _frames.home(rooms, openings, objects, round(top, 3) if top > 2 else 2.6)


def _vertices(mesh: dict[str, Any]) -> Array:
    return np.array(mesh["xyz"], float).reshape(-1, 3)


def _floor(meshes: list[dict[str, Any]]) -> Polygon | None:
    """Outline of all floor meshes of a room together."""
    if not meshes:
        return None
    points = [_vertices(mesh) for mesh in meshes]
    first = np.cumsum([0, *(len(p) for p in points)])
    faces = [np.array(mesh["faces"], int) + k for mesh, k in zip(meshes, first, strict=False)]
    return _frames.outline(np.concatenate(points), np.concatenate(faces))


def _place(
    child: dict[str, Any], piece: dict[str, Any], room: Room, models: Models, folder: Path, objects: list[Box]
) -> None:
    name = _words.category(models.get(piece["jid"]) or str(piece.get("category") or piece.get("title") or ""))
    size = _size(piece, folder)
    if name is None or size is None:
        return
    w, h, d = np.abs(size * np.array(child["scale"], float))
    if min(w, h, d) < 1e-3:
        return
    x, y, z = child["pos"]
    _, qy, _, qw = child["rot"]
    name = _words.by_size(name, (d, w, h))
    objects.append(
        _frames.box(
            f"{room.id}.{name}_{len(objects) + 1}", room.id, name, (x, -z, y + h / 2), (d, w, h),
            float(2 * np.arctan2(qy, qw) - np.pi / 2),
        )
    )


def _size(piece: dict[str, Any], folder: Path) -> Array | None:
    """Width, height, depth of the model at scale 1."""
    given = piece.get("bbox")
    if isinstance(given, list) and len(given) == 3 and all(isinstance(v, int | float) and v > 0 for v in given):
        return np.array(given, float)
    model = folder / piece["jid"] / "raw_model.obj"
    if not model.exists():
        return None
    rows = [line.split()[1:4] for line in model.read_text().splitlines() if line.startswith("v ")]
    points = np.array(rows, float)
    return np.asarray(points.max(0) - points.min(0))


def _opening(mesh: dict[str, Any], number: int, rooms: list[Room]) -> Opening | None:
    """A door, window or passage, along the longer side of its mesh; None where no room is near."""
    points = _vertices(mesh)
    plan, low, high = points[:, [0, 2]] * [1, -1], float(points[:, 1].min()), float(points[:, 1].max())
    middle, reach = (plan.max(0) + plan.min(0)) / 2, (plan.max(0) - plan.min(0)) / 2
    near = [room.id for room in rooms if Polygon(room.polygon).distance(Point(middle)) < OPENS_WITHIN][:2]
    kind = KINDS[mesh["type"]]
    if kind == "opening" and low > 0.3:
        kind = "window"
    if not near or max(reach) < 0.1:
        return None
    along = np.array([reach[0], 0.0]) if reach[0] >= reach[1] else np.array([0.0, reach[1]])
    (ax, ay), (bx, by) = middle - along, middle + along
    return Opening(
        id=f"{kind}_{number}", kind=kind, rooms=near if kind != "window" else near[:1],
        segment=((float(ax), float(ay)), (float(bx), float(by))),
        sill=max(0.0, low) if kind == "window" else 0.0, head=high,
    )
