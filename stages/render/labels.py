"""Numbers for every pixel: how far, which way the surface faces, its colour, which thing it is and of which class."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Layout
from apartgen.schemas.render import Instance, Visible
from apartgen.stages.render.looking import Eye, First, Seen, angle, turned
from apartgen.stages.render.world import World
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.soup import Array, Hits, Index, colors, encoded
from apartgen.stages.things.body import Body

FARTHEST = 65_535
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


def instances(world: World) -> list[Instance]:
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


def labelled(world: World, eye: Eye, whole: First, surface: Seen, things: list[Instance]) -> Labels:
    """The labels of what rays through the middles of all pixels meet, `surface` being what is opaque behind."""
    shape = (eye.rows, eye.columns)
    hits, direction = whole.hits, whole.direction
    rows = np.flatnonzero(hits.triangle >= 0)
    met = Hits(hits.triangle[rows], hits.distance[rows], hits.weights[rows])
    depth, number = np.zeros(len(direction)), np.zeros(len(direction), np.uint16)
    normal, albedo = np.zeros((len(direction), 3), np.uint8), np.zeros((len(direction), 3), np.uint8)
    depth[rows] = met.distance * (_ahead(eye, direction[rows]) if isinstance(eye, Camera) else 1.0) * 1000
    normal[rows] = np.rint((turned(world.faces[met.triangle], direction[rows]) + 1) * 127.5)
    albedo[rows] = np.rint(encoded(_color(world, eye, rows, met, surface)) * 255)
    number[rows] = world.every.soup.owner[met.triangle] + 1
    table = np.array([0, *(thing.label for thing in things)], np.uint16)
    return Labels(np.rint(depth).clip(0, FARTHEST).astype(np.uint16).reshape(shape), normal.reshape(*shape, 3),
                  albedo.reshape(*shape, 3), number.reshape(shape), table[number].reshape(shape))


def _color(world: World, eye: Eye, rows: Index, met: Hits, surface: Seen) -> Array:
    """Colours of what was met first, panes too."""
    color = surface.color[rows]
    pane = np.flatnonzero(surface.triangle[rows] != met.triangle)
    if len(pane):
        some = Hits(met.triangle[pane], met.distance[pane], met.weights[pane])
        color[pane], _ = colors(some, world.every.soup, some.distance * angle(eye))
    return color


def _ahead(eye: Camera, direction: NDArray[np.float32]) -> NDArray[np.float64]:
    """How far along the camera's axis a metre along each ray goes."""
    return np.asarray(-direction.astype(float) @ eye.frame[2].astype(float))


def visible(instance: NDArray[np.uint16]) -> list[Visible]:
    """What is seen of each thing."""
    counts = np.bincount(instance.ravel())
    rows, columns = np.indices(instance.shape)
    most = len(counts)
    ends = []
    for place in (columns, rows):
        low, high = np.full(most, 2**31 - 1), np.zeros(most, np.int64)
        np.minimum.at(low, instance, place)
        np.maximum.at(high, instance, place)
        ends.append((low, high))
    (x0, x1), (y0, y1) = ends
    return [Visible(number=int(k), pixels=int(counts[k]),
                    rectangle=(int(x0[k]), int(y0[k]), int(x1[k] - x0[k] + 1), int(y1[k] - y0[k] + 1)))
            for k in np.flatnonzero(counts) if k]
