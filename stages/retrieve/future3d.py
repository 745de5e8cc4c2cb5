"""3D-FUTURE: `3D-FUTURE-model/<jid>/` a mesh and a texture each, and `model_info.json` about them."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.stages.retrieve.reading import limits, obj
from apartgen.stages.retrieve.reading.fitting import fitted
from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.model import Model, Part, asset
from apartgen.stages.retrieve.reading.pieces import Piece
from apartgen.stages.retrieve.reading.source import Source, beside, image
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.categories import TABLE, labelled
from apartgen.stages.things.words import OTHER, category

MESHES = ("raw_model.obj", "normalized_model.obj")
INFO = "model_info.json"
CREDIT = "3D-FUTURE (Alibaba Topping Homestyler), model {}, under its terms of use for research"
SUPER: dict[str, tuple[str, ...]] = {
    "bed": ("double_bed", "single_bed"),
    "sofa": ("sofa", "armchair"),
    "chair": ("chair", "armchair"),
    "table": ("dining_table", "coffee_table", "side_table"),
    "cabinet/shelf/desk": ("chest", "bookshelf", "desk"),
    "pier/stool": ("stool", "pouffe"),
    "lighting": ("ceiling_lamp", "floor_lamp", "table_lamp"),
}
UNITS = (1.0, 0.01, 0.001)
"""Metres, centimetres, millimetres."""


def assets(root: Path) -> Iterator[Source]:
    """Every model folder below `root` that has a mesh, or is listed and should have one."""
    about, boxes = _tables(root)
    folders = {file.parent.name: file.parent for name in reversed(MESHES) for file in sorted(root.rglob(name))}
    for jid in sorted({*folders, *about}):
        yield Source(jid, partial(_load, jid, folders.get(jid), root, about.get(jid, {}), boxes.get(jid)))


def _tables(root: Path) -> tuple[dict[str, dict[str, Any]], dict[str, Any]]:
    """What is told of each jid, and bounding boxes in centimetres: two kinds of file share one name."""
    about: dict[str, dict[str, Any]] = {}
    boxes: dict[str, Any] = {}
    for file in sorted(root.rglob(INFO)):
        table = limits.parsed(file)
        if isinstance(table, list):
            about |= {str(row["model_id"]): row for row in table if isinstance(row, dict) and row.get("model_id")}
        elif isinstance(table, dict):
            boxes |= {str(jid): row.get("boundingBox") for jid, row in table.items() if isinstance(row, dict)}
    return about, boxes


def _load(jid: str, folder: Path | None, root: Path, about: dict[str, Any], box: Any) -> Asset:
    if folder is None:
        raise Broken(f"is listed in {INFO} but has no folder with {' or '.join(MESHES)}")
    # The raw mesh keeps its size and place; the normalised one is a unit cube.
    file = next(folder / name for name in MESHES if (folder / name).exists())
    pieces = obj.parse(limits.read(limits.inside(root, file)), file.name, beside(file, root), image(file, root))
    texture = folder / "texture.png"
    pieces = [_textured(p, texture) for p in pieces]
    extents = _extents(pieces)
    kind, scale = _real(about, extents, file.name == MESHES[1], box)
    style = str(about.get("style") or "")
    return asset(Model(jid, kind, [Part("base", pieces)], style=style, scale=scale, credit=CREDIT.format(jid)), "")


def _textured(piece: Piece, texture: Path) -> Piece:
    if piece.material.texture or not texture.exists() or piece.uv is None:
        return piece
    material = piece.material.__class__(piece.material.name, (1.0, 1.0, 1.0, 1.0), 0.7, 0.0, str(texture.resolve()))
    return Piece(piece.vertices, piece.faces, material, piece.uv)


def _extents(pieces: list[Piece]) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Depth, width, height of y-up pieces in their own unit."""
    used = [p.vertices[np.unique(p.faces)] for p in pieces if len(p.faces)]
    if not used:
        raise Broken("has no faces")
    x, y, z = np.ptp(np.concatenate(used), axis=0)
    return np.array([z, x, y])


def _candidates(about: dict[str, Any]) -> tuple[str, ...]:
    told = str(about.get("category") or "").strip().lower()
    if told in labelled("future3d"):
        return labelled("future3d")[told]
    named = category(told)
    return (named,) if named != OTHER else SUPER.get(str(about.get("super-category") or "").strip().lower(), ())


def _real(
    about: dict[str, Any], extents: np.ndarray[tuple[int, ...], np.dtype[np.float64]], normalised: bool, box: Any
) -> tuple[str, float]:
    """Category and metres per unit: a bounding box in cm settles it, else the unit in which its sides are likely."""
    kinds, longest, told = _candidates(about), float(extents.max()), _longest(box)
    if told:
        exact = told / 100 / max(longest, 1e-9)
        near = min(UNITS, key=lambda unit: abs(np.log(unit / exact)))
        return (kinds or (OTHER,))[0], exact if normalised else near
    if not kinds:
        if normalised:
            raise Broken("is a unit cube of unknown category, so its size can't be told")
        return OTHER, next((unit for unit in UNITS if longest * unit < 5), UNITS[-1])
    if normalised:
        return fitted(extents, kinds)
    sides = np.log(np.maximum(extents, 1e-9))
    off = {
        (kind, unit): float(np.abs(sides + np.log(unit) - np.log(TABLE[kind].size)).sum())
        for kind in kinds
        for unit in UNITS
    }
    return min(off, key=lambda key: (off[key], key))


def _longest(box: Any) -> float:
    """The longest side of a bounding box in cm, of whatever form; 0 where there is none."""
    sides = list(box.values()) if isinstance(box, dict) else box if isinstance(box, list) else []
    numbers = [float(side) for side in sides if isinstance(side, int | float)]
    return max((side for side in numbers if np.isfinite(side)), default=0.0)
