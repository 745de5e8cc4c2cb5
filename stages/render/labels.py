"""Numbers for every pixel: how far, which way the surface faces, its colour, which thing it is and of which class."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Layout
from apartgen.schemas.render import Instance, Visible
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.kernels import extents
from apartgen.stages.scene.lens import noted
from apartgen.stages.scene.looking import Eye, First, Seen, angle
from apartgen.stages.scene.soup import Array, Hits, byted, colors
from apartgen.stages.scene.world import HomeWorld
from apartgen.stages.things.body import Body

FARTHEST = 65_535.0
"""Of depth pictures, mm."""
BUILDING = ("wall", "floor", "ceiling", "trim", "door", "entrance", "window", "opening")
"""Classes that every home has, numbers 1 to 8; those of furniture follow by name."""


class Labels(NamedTuple):
    """Pictures (rows, columns, …): `depth` in mm, `normal` and `albedo` as colours, numbers of things and classes; 0
    where there is nothing.
    """

    depth: NDArray[np.uint16]
    normal: NDArray[np.uint8]
    albedo: NDArray[np.uint8]
    instance: NDArray[np.uint16]
    semantic: NDArray[np.uint16]


def classes(bodies: list[Body]) -> dict[str, int]:
    """The number of each class."""
    furniture = sorted({_class(body) for body in bodies} - set(BUILDING))
    return {name: k for k, name in enumerate([*BUILDING, *furniture], 1)}


def _class(body: Body) -> str:
    if body.kind in ("object", "door", "window"):
        return body.category
    return "wall" if body.kind == "lining" else body.kind


def instances(world: HomeWorld) -> list[Instance]:
    """Every thing of the home; its number is one more than its body's index."""
    numbers = classes(world.bodies)
    objects = {o.id: o for o in world.plan.objects} if isinstance(world.plan, Layout) else {}
    found = []
    for k, body in enumerate(world.bodies, 1):
        o = objects.get(body.id) if body.kind == "object" else None
        box = (*o.center, *o.size, o.yaw) if o is not None else None
        name = _class(body)
        found.append(Instance(number=k, id=body.id if body.kind in ("object", "door", "window") else body.name,
                              category=name, label=numbers[name], room=body.room, box=box))
    return found


def labelled(world: HomeWorld, eye: Eye, whole: First, surface: Seen, things: list[Instance]) -> Labels:
    """The labels of what rays through the middles of all pixels meet, `surface` being what is opaque behind."""
    shape = (eye.rows, eye.columns)
    hits, direction = whole.hits, whole.direction
    ahead = -eye.frame[2].astype(float) if isinstance(eye, Camera) else np.zeros(3)
    depth, normal, number = noted(hits.triangle, hits.distance, direction, ahead, world.faces, world.every.soup.owner,
                                  FARTHEST)
    albedo = byted(_color(world, eye, hits, surface))
    table = np.array([0, *(thing.label for thing in things)], np.uint16)
    return Labels(depth.reshape(shape), normal.reshape(*shape, 3), albedo.reshape(*shape, 3), number.reshape(shape),
                  table[number].reshape(shape))


def _color(world: HomeWorld, eye: Eye, hits: Hits, surface: Seen) -> Array:
    """Colours of what was met first, panes too."""
    pane = np.flatnonzero(surface.triangle != hits.triangle)
    if not len(pane):
        return surface.color
    color = surface.color.copy()
    some = Hits(hits.triangle[pane], hits.distance[pane], hits.weights[pane])
    color[pane], _ = colors(some, world.every.soup, angle(eye))
    return color


def visible(instance: NDArray[np.uint16]) -> list[Visible]:
    """What is seen of each thing."""
    return [Visible(number=k, pixels=pixels, rectangle=(x, y, right - x + 1, below - y + 1), inmost=(i, j, steps))
            for k, (pixels, x, y, right, below, i, j, steps) in enumerate(extents(instance).tolist()) if k and pixels]
