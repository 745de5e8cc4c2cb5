"""URDF, MJCF and SDF objects in a folder: z up, metres, with the joints their files give them."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.reading import limits, mjcf, sdf, tree, urdf
from apartgen.stages.retrieve.reading.model import FRONT_MINUS_Y, Z_UP, Model, asset
from apartgen.stages.retrieve.reading.source import Source, credit, files
from apartgen.stages.retrieve.reading.tree import Body
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.words import OTHER, category

FRONTS = {"x": Z_UP, "-y": FRONT_MINUS_Y, "y": -FRONT_MINUS_Y * (1, 1, -1), "-x": np.diag([-1.0, -1.0, 1.0])}
"""Turns the named side to the front."""


def assets(root: Path, scale: float = 1.0, front: str = "") -> Iterator[Source]:
    """Every object below `root`. `front` names the axis objects face (x, -x, y, -y); by default where they open to."""
    if front and front not in FRONTS:
        raise BadInput(f"front {front!r}: one of {', '.join(FRONTS)}")
    by = credit(root)
    for path in files(root, (".urdf", ".sdf", ".xml")):
        stem = str(path.relative_to(root).with_suffix(""))
        try:
            found = _objects(path, root)
        except BadInput as error:
            yield Source(stem, partial(_refuse, error))
            continue
        for name, load in found:
            id = stem if len(found) == 1 else f"{stem}/{name}"
            yield Source(id, partial(_load, load, id, name, path.stem, scale, front, by))


def _refuse(error: BadInput) -> Asset:
    raise error


def _objects(path: Path, root: Path) -> list[tuple[str, partial[list[Body]]]]:
    """Names of a file's objects, and how to read each."""
    if path.suffix == ".urdf":
        return [(path.stem, partial(_urdf, path, root))]
    if path.suffix == ".sdf":
        return [(m.get("name", path.stem), partial(_sdf, m, path, root)) for m in sdf.models(path)]
    data = limits.read(path, limits.TEXT_BYTES)
    if mjcf.is_model(data):
        doc = mjcf.document(path, root)
        return [(_name(body, i), partial(mjcf.bodies, doc, body)) for i, body in enumerate(mjcf.top_bodies(doc))]
    return []


def _name(body: Element, i: int) -> str:
    named = [b.get("name") for b in body.iter("body") if b.get("name")]
    return next((name for name in named if name), f"body_{i}")


def _urdf(path: Path, root: Path) -> list[Body]:
    return urdf.read(path, root, hulls=True).bodies


def _sdf(model: Element, path: Path, root: Path) -> list[Body]:
    return sdf.bodies(model, path, root)


def _load(read: partial[list[Body]], id: str, name: str, stem: str, scale: float, front: str, by: str) -> Asset:
    bodies = read()
    kind = category(name)
    turn = FRONTS[front or _opens_to(bodies)]
    named = kind if kind != OTHER else category(stem)
    return asset(Model(id, named, tree.parts(bodies), credit=by, turn=turn, scale=scale), "")


def _opens_to(bodies: list[Body]) -> str:
    """The side on which moving parts stand out the most before what stays; x where nothing moves."""
    moving = [p.vertices for body in bodies if body.motion for p in body.pieces if len(p.vertices)]
    still = [p.vertices for body in bodies if not body.motion for p in body.pieces if len(p.vertices)]
    if not moving or not still:
        return "x"
    (low, high), (lo, hi) = ((points.min(0), points.max(0)) for points in map(np.concatenate, (moving, still)))
    out = {"-y": lo[1] - low[1], "y": high[1] - hi[1], "x": high[0] - hi[0], "-x": lo[0] - low[0]}
    return max(out, key=lambda side: round(float(out[side]), 4))
