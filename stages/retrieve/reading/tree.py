"""A tree of bodies and joints, as robots' formats have it, cut into the parts of an asset."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from apartgen.stages.retrieve.reading import gltf, limits, obj, stl
from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.model import Motion, Part
from apartgen.stages.retrieve.reading.pieces import Array, Piece, count
from apartgen.stages.retrieve.reading.source import beside, image
from apartgen.stages.things.asset import Collider, Material

LINKS = 2000
"""Most links of one object."""
ENDLESS = float(np.pi)
"""Half the range given to joints that turn without end, rad."""


@dataclass
class Body:
    """A body at zero pose: `frame` (4 × 4), geometry and motion in the tree's root frame; `parent` is its index."""

    name: str
    parent: int | None
    frame: Array
    pieces: list[Piece] = field(default_factory=list)
    colliders: list[Collider] = field(default_factory=list)
    motion: Motion | None = None
    mass: float | None = None


def bounded(bodies: Sequence[Body], name: str) -> None:
    """Broken when all bodies together have more faces than are accepted."""
    every = [piece for body in bodies for piece in body.pieces]
    count(sum(len(piece.vertices) for piece in every), sum(len(piece.faces) for piece in every), name)


def parts(bodies: Sequence[Body]) -> list[Part]:
    """One part per body that moves against what stays; whatever hangs on it, moving or not, is fixed to it.

    Parents come before children.
    """
    owner: list[int] = []
    for i, body in enumerate(bodies):
        above = owner[body.parent] if body.parent is not None else -1
        owner.append(above if above >= 0 else i if body.motion is not None else -1)
    return [_part(bodies, [j for j, own in enumerate(owner) if own == key], key) for key in sorted(set(owner))]


def _part(bodies: Sequence[Body], rows: Sequence[int], key: int) -> Part:
    masses = [mass for j in rows if (mass := bodies[j].mass)]
    return Part(
        bodies[key].name if key >= 0 else "base",
        [p for j in rows for p in bodies[j].pieces],
        bodies[key].motion if key >= 0 else None,
        sum(masses) if masses else None,
        [c for j in rows for c in bodies[j].colliders],
    )


def mesh(file: Path, root: Path) -> list[Piece]:
    """The pieces of a mesh file: STL, OBJ, GLB or glTF."""
    real = limits.inside(root, file)
    data = limits.read(real)
    match real.suffix.lower():
        case ".stl":
            return stl.parse(data, real.name)
        case ".obj":
            return obj.parse(data, real.name, beside(real, root), image(real, root))
        case ".glb" | ".gltf":
            return [piece for node in gltf.parse(data, real.name, beside(real, root)) for piece in node.all()]
        case other:
            raise Broken(f"{real.name}: {other or 'no'} meshes are not understood; convert them to OBJ or GLB")


def dyed(pieces: Sequence[Piece], material: Material | None) -> list[Piece]:
    """The pieces in one material, as they are without one; its image only where a mesh says how it lies."""
    if material is None:
        return list(pieces)
    bare = replace(material, texture=None)
    return [Piece(p.vertices, p.faces, material if p.uv is not None else bare, p.uv) for p in pieces]


def motion(kind: str, axis: Array, frame: Array, span: tuple[float, float] | None, name: str) -> Motion:
    """A joint's motion in the root frame from its own; `kind` is hinge or slide, `span` None for no limits."""
    low, high = span or (-ENDLESS, ENDLESS)
    if not (np.isfinite([low, high]).all() and low <= high):
        raise Broken(f"joint {name}: limits {low} to {high}")
    if np.linalg.norm(axis) < 1e-9:
        raise Broken(f"joint {name}: an axis of no length")
    turned = frame[:3, :3] @ axis
    return Motion(
        "slide" if kind == "slide" else "hinge", turned, frame[:3, 3], (low, high), part_class(kind, turned, name)
    )


def part_class(kind: str, axis: Array, name: str) -> str:
    """GAPartNet class told from a joint's kind, its axis (z up) and its name."""
    if kind == "slide":
        return "slider_button" if "button" in name.lower() else "slider_drawer"
    if any(word in name.lower() for word in ("knob", "switch", "dial")):
        return "hinge_knob"
    upright = abs(axis[2]) > 0.7 * np.linalg.norm(axis)
    return "hinge_lid" if not upright and "lid" in name.lower() else "hinge_door"
