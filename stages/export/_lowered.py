"""The building cut off below its ceilings, as models are, so that walls do not hide the rooms behind them."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from apartgen.stages.export._section import section
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Link, Material, Mesh
from apartgen.stages.things.body import Body

HEIGHT = 1.5
"""Where walls, doors and windows end, m."""
HANGS = 1.2
"""What hangs higher than this would float above them, m."""
FACE = Material("cut", (0.36, 0.35, 0.34, 1.0), 0.9)
"""What is cut through."""
_THICK = 0.004  # m
_BUILDING = ("wall", "lining", "trim", "door", "window")


def lowered(bodies: Sequence[Body]) -> list[Body]:
    """The bodies, those of the building up to `HEIGHT` and with faces where they are cut; nothing that hangs high."""
    high = [body for body in bodies if body.kind in _BUILDING]
    face = solids.extruded(section(high, HEIGHT, HEIGHT), HEIGHT - _THICK, HEIGHT, FACE)
    cut = Body("cut", "wall", "", "", np.zeros(3), 0.0, [Link("base", [face], [], 0.0)])
    return [cut, *(_up_to(body) if body.kind in _BUILDING else body for body in bodies if not _hangs(body))]


def _hangs(body: Body) -> bool:
    if body.kind != "object":
        return body.kind == "ceiling"
    lowest = min(mesh.vertices[:, 2].min() for link in body.links for mesh in link.visuals)
    return float(lowest + body.position[2]) > HANGS


def _up_to(body: Body) -> Body:
    top = HEIGHT - _THICK - float(body.position[2])
    return replace(body, links=[replace(link, visuals=_below(link.visuals, top)) for link in body.links])


def _below(meshes: Sequence[Mesh], top: float) -> list[Mesh]:
    return [cut for mesh in meshes if len((cut := _sliced(mesh, top)).faces)]


def _sliced(mesh: Mesh, top: float) -> Mesh:
    """What of a mesh is below `top`, open there."""
    if float(mesh.vertices[:, 2].max()) <= top:
        return mesh
    from trimesh import intersections

    sliced: Any = intersections.slice_faces_plane
    vertices, faces, uv = sliced(mesh.vertices, mesh.faces, np.array([0.0, 0, -1]), np.array([0.0, 0, top]), mesh.uv)
    return Mesh(np.asarray(vertices), np.asarray(faces, np.int64), mesh.material, uv)
