"""One camera's frame: its pictures as files, and what is known of it."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.render import Instance, Row4, Seeing, View
from apartgen.stages.render.labels import Labels, labelled, visible
from apartgen.stages.scene.camera import MIDDLE, Camera
from apartgen.stages.scene.looking import Eye, angle, first, seen
from apartgen.stages.scene.picture import picture
from apartgen.stages.scene.png import png
from apartgen.stages.scene.world import HomeWorld

PARTS = ("rgb", "depth", "normal", "albedo", "instance", "semantic")
"""Pictures of a frame, each a file NAME.PART.png."""
Pictures = dict[str, NDArray[np.uint8] | NDArray[np.uint16]]


def taken(world: HomeWorld, eye: Eye, things: list[Instance]) -> Pictures:
    """All pictures of one camera."""
    whole = first(world, eye, np.arange(eye.rows * eye.columns), MIDDLE)
    surface = seen(world, eye.eye, whole.direction, whole.hits, angle(eye))
    labels: Labels = labelled(world, eye, whole, surface, things)
    return {"rgb": picture(world, eye, whole, surface), **labels._asdict()}


def view(name: str, kind: Seeing, room: str, eye: Eye, pictures: Pictures) -> View:
    """What is known of a frame."""
    inner = eye.intrinsics if isinstance(eye, Camera) else None
    seen = visible(pictures["instance"].astype(np.uint16))
    return View(name=name, kind=kind, room=room, width=eye.columns, height=eye.rows, intrinsics=inner,
                pose=pose(eye), visible=seen)


def pose(eye: Eye) -> tuple[Row4, Row4, Row4, Row4]:
    """Camera to world, the camera's x to the right, y down, z ahead."""
    if isinstance(eye, Camera):
        turn = (eye.frame.astype(float) * np.array([[1.0], [-1.0], [-1.0]])).T
    else:
        turn = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    whole = np.eye(4)
    whole[:3, :3], whole[:3, 3] = turn, eye.eye
    a, b, c, d = ((float(r[0]), float(r[1]), float(r[2]), float(r[3])) for r in whole)
    return a, b, c, d


def saved(folder: Path, name: str, pictures: Pictures) -> list[Path]:
    """The files of a frame, once they are written."""
    paths = [folder / f"{name}.{part}.png" for part in PARTS]
    for path, part in zip(paths, PARTS):
        path.write_bytes(png(pictures[part]))
    return paths
