"""From a file's parts to an asset: frame, units, centre, one joint per moving link, colliders, masses."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from apartgen.schemas.retrieve import Joint
from apartgen.stages.retrieve.reading import convex
from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.pieces import Array, Piece, sound
from apartgen.stages.things.asset import Asset, Collider, Link, Mesh

DENSITY = 350.0
"""Of furniture whose file names no mass: board and air, kg/m³."""
LEAST, MOST = 0.01, 8.0
"""Sides outside this range mean that the units are not what the reader was told, m."""

Y_UP = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
"""glTF's frame (y up, front +z, left +x) to this project's."""
Z_UP = np.eye(3)
FRONT_MINUS_Y = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
"""z up, front -y, to this project's."""


@dataclass(frozen=True)
class Motion:
    """A joint in the file's frame; `range` in radians, or in the file's own length for slides."""

    type: Literal["hinge", "slide"]
    axis: Array
    origin: Array
    range: tuple[float, float]
    part: str


@dataclass(frozen=True)
class Part:
    """Geometry that moves as one; `motion` is None for what stays. `colliders` and `mass` where the file has them."""

    name: str
    pieces: list[Piece]
    motion: Motion | None = None
    mass: float | None = None
    colliders: list[Collider] = field(default_factory=list)
    handle: Array | None = None
    grip: str = ""


@dataclass(frozen=True)
class Model:
    """All that a reader knows of one asset; `turn` brings the file's axes onto this project's, `scale` to metres."""

    id: str
    category: str
    parts: list[Part]
    style: str = ""
    credit: str = ""
    turn: Array = field(default_factory=lambda: Y_UP)
    scale: float = 1.0


def asset(model: Model, library: str) -> Asset:
    """The asset; Broken, with the reason, when its geometry can't be used."""
    parts = _base_first([_sound(part) for part in model.parts])
    lo, hi = _bounds([piece for part in parts for piece in part.pieces], model)
    size = hi - lo
    if size.max() > MOST or size.max() < LEAST:
        raise Broken(f"would be {size.max():.4g} m long; declare the scale of its units")
    links = _named([_link(part, model, (lo + hi) / 2) for part in parts])
    d, w, h = (float(max(side, 0.001)) for side in size)
    return Asset(library, model.id, model.category, model.style, (d, w, h), links, credit=model.credit)


def _sound(part: Part) -> Part:
    pieces = [sound(piece, part.name) for piece in part.pieces]
    return replace(part, pieces=[piece for piece in pieces if len(piece.faces)])


def _base_first(parts: Sequence[Part]) -> list[Part]:
    """All that stays as one part, then what moves and has a shape."""
    still = [part for part in parts if part.motion is None]
    moving = [part for part in parts if part.motion is not None and part.pieces]
    masses = [part.mass for part in still if part.mass is not None]
    base = Part(
        "base",
        [p for part in still for p in part.pieces],
        mass=sum(masses) if masses else None,
        colliders=[c for part in still for c in part.colliders],
    )
    if not base.pieces and not moving:
        raise Broken("has no faces")
    return [base, *moving] if base.pieces else [replace(moving[0], motion=None), *moving[1:]]


def _bounds(pieces: Sequence[Piece], model: Model) -> tuple[Array, Array]:
    used = np.concatenate([p.vertices[np.unique(p.faces)] for p in pieces]) @ model.turn.T * model.scale
    return used.min(0), used.max(0)


def _link(part: Part, model: Model, center: Array) -> Link:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = model.turn * model.scale, -center
    pieces = [piece.moved(matrix) for piece in part.pieces]
    solid = [_collider(c, model, center) for c in part.colliders] or convex.colliders(pieces)
    mass = part.mass if part.mass else DENSITY * sum(map(convex.volume, solid))
    joint = _joint(part, model, center, pieces) if part.motion else None
    handle = None
    if joint is not None:
        handle = part.handle @ matrix[:3, :3].T + matrix[:3, 3] if part.handle is not None else _grip(joint, pieces)
    visuals = [Mesh(p.vertices, p.faces, p.material, p.uv) for p in pieces]
    return Link(part.name, visuals, solid, float(np.clip(mass, 0.02, 400)), joint, handle, grip=part.grip)


def _collider(piece: Collider, model: Model, center: Array) -> Collider:
    return Collider(
        piece.kind,
        model.scale * model.turn @ piece.center - center,
        piece.size * model.scale,
        model.turn @ piece.rotation,
        None if piece.vertices is None else piece.vertices * model.scale,
    )


def _joint(part: Part, model: Model, center: Array, pieces: Sequence[Piece]) -> Joint:
    assert part.motion is not None
    motion = part.motion
    axis = model.turn @ (motion.axis / max(float(np.linalg.norm(motion.axis)), 1e-12))
    factor = model.scale if motion.type == "slide" else 1.0
    low, high = (float(end) * factor + 0.0 for end in motion.range)
    if high <= 0 > low:
        # Opening is the positive direction.
        axis, low, high = -axis, -high + 0.0, -low
    points = np.concatenate([piece.vertices for piece in pieces])
    return Joint(
        name=part.name,
        type=motion.type,
        axis=_vector(axis),
        origin=_vector(model.scale * model.turn @ motion.origin - center),
        range=(low, high),
        part=motion.part,
        extent=(_vector(points.min(0)), _vector(points.max(0))),
    )


def _vector(values: Array) -> tuple[float, float, float]:
    x, y, z = (round(float(v), 6) + 0.0 for v in values)
    return x, y, z


def _grip(joint: Joint, pieces: Sequence[Piece]) -> Array:
    """Where to take hold of a part without a handle: the front's middle, at a leaf its edge away from the hinge."""
    lo, hi = (np.asarray(corner) for corner in joint.extent or ((0, 0, 0), (0, 0, 0)))
    grip = np.array([hi[0], (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2])
    if joint.type == "hinge":
        upright = abs(joint.axis[2]) > 0.7
        side = 1 if upright else 2
        grip[side] = hi[side] if hi[side] - joint.origin[side] > joint.origin[side] - lo[side] else lo[side]
    return grip


def _named(links: Sequence[Link]) -> list[Link]:
    """Links with unique names, since files repeat theirs."""
    seen: dict[str, int] = {}
    out = []
    for link in links:
        seen[link.name] = seen.get(link.name, 0) + 1
        name = link.name if seen[link.name] == 1 else f"{link.name}_{seen[link.name]}"
        out.append(replace(link, name=name, joint=link.joint.model_copy(update={"name": name}) if link.joint else None))
    return out
