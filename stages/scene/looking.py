"""What rays of a camera meet: the first surface, glass too, which labels are of, and the first that is opaque."""

from typing import NamedTuple

import numpy as np

from apartgen.stages.scene.camera import Camera, Panorama
from apartgen.stages.scene.lens import arrived, ended, passed
from apartgen.stages.scene.soup import Array, Hits, Index, colors
from apartgen.stages.scene.world import World

PANES = 4
"""Clear surfaces behind one another that are looked through."""
PAST = np.float32(1e-3)
"""How far behind a pane a ray goes on, m."""
CLEAR, VEIL = np.float32(0.7), np.float32(0.75)
"""Share of their opacity that clear surfaces have in pictures, and how bright they are."""

Eye = Camera | Panorama


class First(NamedTuple):
    """Of rays: `triangle` (-1 for none), `distance` along the ray (inf), `weights` of its corners."""

    direction: Array
    hits: Hits


class Seen(NamedTuple):
    """Opaque surfaces at the ends of rays: which `triangle` (-1 for the outside), where, its normal to the eye, colour;
    `through` and `veil` of the panes before it: what is seen is colour × through + veil.
    """

    triangle: Index
    distance: Array
    point: Array
    normal: Array
    color: Array
    through: Array
    veil: Array


def first(world: World, eye: Eye, pixels: Index, within: Array) -> First:
    """What rays through a point of each pixel meet first."""
    direction = eye.rays(pixels, within)
    origin = np.broadcast_to(np.asarray(eye.eye, np.float32), direction.shape)
    return First(direction, world.every.first(origin, direction))


def seen(world: World, origin: Array, direction: Array, hits: Hits, angle: float) -> Seen:
    """What is opaque behind what rays from `origin` (3,) or (n, 3) met first; a ray stands for `angle`, rad."""
    n, single = len(direction), np.asarray(origin, np.float32).reshape(-1, 3)
    through, veil = np.ones((n, 3), np.float32), np.zeros((n, 3), np.float32)
    rows = np.flatnonzero(world.alpha[hits.triangle] < 1)
    if len(rows):
        hits = Hits(hits.triangle.copy(), hits.distance.copy(), hits.weights.copy())
    for _ in range(PANES):
        if not len(rows):
            break
        start, way = passed(rows, hits.triangle, hits.distance, single, direction, world.alpha,
                            world.every.soup.material, world.flat, PAST, CLEAR, VEIL, through, veil)
        rows = arrived(rows, *world.every.first(start, way), world.alpha, PAST, *hits)
    color, normal = colors(hits, world.every.soup, angle)
    point = ended(single, direction, hits.distance, normal)
    return Seen(hits.triangle, hits.distance, point, normal, color, through, veil)


def angle(eye: Eye) -> float:
    """What a pixel in the middle spans, rad."""
    return 2 * float(eye.half[0]) / eye.columns if isinstance(eye, Camera) else 2 * np.pi / eye.columns
