"""Pictures as a photographer would take them: exposure, what is beyond the windows, and smooth edges."""

from functools import reduce

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.camera import MIDDLE
from apartgen.stages.scene.kernels import edges, widened
from apartgen.stages.scene.lens import developed
from apartgen.stages.scene.looking import Eye, First, Seen, angle, first, seen
from apartgen.stages.scene.shading import Shade, outside, refined, shaded
from apartgen.stages.scene.soup import Array, Hits, Index, byted
from apartgen.stages.scene.surfaces import amid, crossed
from apartgen.stages.scene.world import World

Corners = tuple[tuple[int, int], ...]

ASIDE = 0.36
"""How far from the middle of a pixel, to the side and up or down, further rays go where something begins or ends."""
CORNERS = (((-1, 1), (1, -1)), ((-1, -1), (1, 1)))
"""Through which corners: two of all such pixels, the other two where those and the middle are apart."""
CONTRAST, OWN = 0.25, np.float32(1.6)
"""How far they must be, as roots of light, and how much more the middle counts than a corner."""
THIN = 6
"""How far things thinner than a pixel are followed from where they are met, pixels."""
BESIDE, BETWEEN = ((0.25, 0.75),), 5
"""Where else in a pixel it is looked whether something thin crosses it, and in how many pixels once."""
APART = 0.5
"""What directions and colours of neighbours may differ by within a surface."""
RAISED = 1.5e-3
"""Surfaces that face alike are two from this distance on, m."""
MEAN, METERED = 0.25, 7
"""What the mean of a picture's light is brought to, that of every so many pixels."""


def taken(world: World, eye: Eye, exposure: float | None = None) -> NDArray[np.uint8]:
    """The image (rows, columns, 3) of one camera."""
    return picture(world, eye, *_all(world, eye), exposure)


def metered(world: World, eye: Eye) -> float:
    """The exposure that suits one camera."""
    whole, surface = _all(world, eye)
    return _exposure(shaded(world, eye, whole.direction, surface, False).sent, surface.triangle >= 0)


def _all(world: World, eye: Eye) -> tuple[First, Seen]:
    """What rays through the middles of all pixels meet, and what is opaque behind."""
    whole = first(world, eye, np.arange(eye.rows * eye.columns), MIDDLE)
    return whole, seen(world, eye.eye, whole.direction, whole.hits, angle(eye))


def picture(
    world: World, eye: Eye, whole: First, surface: Seen, exposure: float | None = None
) -> NDArray[np.uint8]:
    """The image (rows, columns, 3); `whole` is what rays through the middles of all pixels meet, `surface` what is
    opaque behind. Its exposure is found where none is given.
    """
    shade = shaded(world, eye, whole.direction, surface, True)
    exposure = _exposure(shade.sent, surface.triangle >= 0) if exposure is None else exposure
    image = shade.sent
    _developed(image, surface, whole.direction, exposure)
    edge, thin = _edges(world, eye, whole, surface)
    known = amid(whole.hits.triangle.reshape(eye.rows, eye.columns)) & ~thin
    middle = image[edge]
    total, weight = middle * OWN, np.full((len(edge), 1), OWN)
    some = np.arange(len(edge))
    for corners in CORNERS:
        lights = _around(world, eye, edge[some], corners, whole, surface, known, shade, exposure)
        total[some] += sum(lights)
        weight[some] += len(lights)
        some = some[_contrast([middle[some], *lights]) > CONTRAST]
    image[edge] = total / weight
    return byted(image.reshape(eye.rows, eye.columns, 3))


def _around(world: World, eye: Eye, pixels: Index, corners: Corners, whole: First, surface: Seen,
            known: NDArray[np.bool_], shade: Shade, exposure: float) -> list[Array]:
    """Linear colours (n, 3) of what rays towards corners of pixels meet; those `known`, of all pixels, meet the
    triangle of the middle.
    """
    within = 0.5 + ASIDE * np.array(corners)
    parts = [_beside(world, eye, pixels, at, whole, known[pixels]) for at in within]
    fine = [seen(world, eye.eye, part.direction, part.hits, angle(eye)) for part in parts]
    lights = refined(world, eye, shade, pixels, [part.direction for part in parts], surface, fine, RAISED)
    for part, surfaces, light in zip(parts, fine, lights):
        _developed(light, surfaces, part.direction, exposure)
    return lights


def _contrast(lights: list[Array]) -> Array:
    """How far colours (n, 3) are apart where they are farthest, as roots of light, (n,)."""
    least, most = (np.sqrt(reduce(pick, lights)) for pick in (np.minimum, np.maximum))
    return np.asarray((most - least).max(1))


def _beside(world: World, eye: Eye, pixels: Index, within: Array, whole: First, known: NDArray[np.bool_]) -> First:
    """What rays through a point of pixels meet; those of which it is known meet the triangle of the middle."""
    direction = eye.rays(pixels, within)
    triangle = whole.hits.triangle[pixels]
    distance, weights = crossed(np.asarray(eye.eye, np.float32), direction, triangle, known, world.every.soup.corners)
    some = np.flatnonzero(~known)
    origin = np.broadcast_to(np.asarray(eye.eye, np.float32), (len(some), 3))
    met = world.every.first(origin, direction[some])
    triangle[some], distance[some], weights[some] = met.triangle, met.distance, met.weights
    return First(direction, Hits(triangle, distance, weights))


def _exposure(shaded: Array, indoors: NDArray[np.bool_]) -> float:
    """What light is multiplied with, so that most of what is inside is neither dark nor white."""
    if not indoors.any():
        return 1.0
    some = np.flatnonzero(indoors)[::METERED]
    bright = shaded[some] @ np.array([0.21, 0.72, 0.07], np.float32)
    return float(np.clip(MEAN / max(float(np.exp(np.log(bright + 1e-3).mean())), 1e-3), 0.4, 4.0))


def _developed(light: Array, surface: Seen, direction: Array, exposure: float) -> None:
    """Makes of light linear colours in [0, 1] behind their panes, in place."""
    developed(light, exposure, surface.through, surface.veil)
    out = np.flatnonzero(surface.triangle < 0)
    light[out] = (outside(direction[out]) * surface.through[out] + surface.veil[out]).clip(0, 1)


def _edges(world: World, eye: Eye, whole: First, surface: Seen) -> tuple[Index, NDArray[np.bool_]]:
    """Pixels beside one of another body, another direction or clearly another colour, and such that hold two bodies,
    materials or directions though their neighbours do not; of all pixels, where something thin may be.
    """
    shape = (eye.rows, eye.columns)
    owner = np.where(surface.triangle >= 0, world.every.soup.owner[surface.triangle], -1).reshape(shape)
    point, normal, color, through = (
        part.reshape(*shape, 3).astype(np.float32, copy=False)
        for part in (surface.point, surface.normal, surface.color, surface.through))
    found = edges(owner, point, normal, color, through, APART, RAISED).ravel()
    thin = widened(_within(world, eye, whole, found).reshape(shape), THIN).ravel()
    return np.flatnonzero(found | thin), thin


def _within(world: World, eye: Eye, whole: First, known: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Where a ray beside the middle of a pixel, of every `BETWEEN`-th one that is not known, meets another body,
    material or direction.
    """
    soup, found = world.every.soup, np.zeros(eye.rows * eye.columns, bool)
    places = np.arange(eye.columns) + 2 * np.arange(eye.rows)[:, None]
    pixels = np.flatnonzero((places.ravel() % BETWEEN == 0) & ~known)
    here = whole.hits.triangle[pixels]
    for within in BESIDE:
        there = first(world, eye, pixels, np.array(within)).hits.triangle
        apart = np.flatnonzero(here != there)
        rows, a, b = pixels[apart], here[apart], there[apart]
        turn = np.einsum("nd,nd->n", soup.normals[a, 0], soup.normals[b, 0]) < 0.9
        other = (soup.owner[a] != soup.owner[b]) | (soup.material[a] != soup.material[b]) | turn
        away = soup.corners[b, 0] - soup.corners[a, 0]
        other |= np.abs(np.einsum("nd,nd->n", away, soup.normals[a, 0])) > RAISED
        found[rows] |= other | (np.minimum(a, b) < 0)
    return found
