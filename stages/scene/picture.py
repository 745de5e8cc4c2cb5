"""Pictures as a photographer would take them: light, gloss, what glows, exposure, and smooth edges."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.kernels import edges, smoothed, spread
from apartgen.stages.scene.light import LIFT, SUN, irradiance, sunlit
from apartgen.stages.scene.looking import Eye, First, Seen, angle, first, seen
from apartgen.stages.scene.noise import GOLDEN, noise_of
from apartgen.stages.scene.soup import Array, Index, byted
from apartgen.stages.scene.world import World

STEP = 5
"""Light is found at every so many pixels, and spread over those between."""
EDGE_RAYS = 4
"""Further rays through pixels where something begins or ends."""
THIN = 6
"""How far things thinner than a pixel are followed from where they are met, pixels."""
BESIDE = ((0.25, 0.75),)
"""Where else in a pixel it is looked whether something thin crosses it."""
ALIKE = 1e-4
"""Points of which less was found nearby have their light found for themselves."""
APART = 0.3
"""What directions and colours of neighbours may differ by within a surface."""
RAISED = 1.5e-3
"""Surfaces that face alike are two from this distance on, m."""
GLOSSY = 0.42
"""Surfaces rougher than this mirror nothing."""
MEAN = 0.25
"""What the mean of a picture's light is brought to."""
MIDDLE = np.array([0.5, 0.5])
GLOW = np.array([1.0, 0.88, 0.72], np.float32) * 0.9
HORIZON = np.array([0.80, 0.88, 0.95], np.float32)
ZENITH = np.array([0.34, 0.56, 0.86], np.float32)
GROUND = np.array([0.42, 0.47, 0.36], np.float32)


class Lit(NamedTuple):
    """Of every pixel: where light was found (rows, columns, …), to look up that of points nearby."""

    light: Array
    point: Array
    normal: Array
    start: int
    mean: Array


def taken(world: World, eye: Eye, exposure: float | None = None) -> NDArray[np.uint8]:
    """The image (rows, columns, 3) of one camera."""
    return picture(world, eye, *_all(world, eye), exposure)


def metered(world: World, eye: Eye) -> float:
    """The exposure that suits one camera."""
    whole, surface = _all(world, eye)
    lit = _lit(world, eye, surface)
    pixels = np.arange(eye.rows * eye.columns)
    return _exposure(_shaded(world, eye, lit, pixels, whole.direction, surface, False), surface.triangle >= 0)


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
    pixels = np.arange(eye.rows * eye.columns)
    lit = _lit(world, eye, surface)
    shaded = _shaded(world, eye, lit, pixels, whole.direction, surface, True)
    exposure = _exposure(shaded, surface.triangle >= 0) if exposure is None else exposure
    image = _developed(shaded, surface, whole.direction, exposure)
    edge = _edges(world, eye, whole, surface)
    within = (0.5 + np.arange(1, EDGE_RAYS + 1)[:, None] * GOLDEN) % 1
    again = np.tile(edge, EDGE_RAYS)
    part = first(world, eye, again, np.repeat(within, len(edge), axis=0).T)
    fine = seen(world, eye.eye, part.direction, part.hits, angle(eye))
    more = _developed(_shaded(world, eye, lit, again, part.direction, fine, False), fine, part.direction, exposure)
    image[edge] = (image[edge] + more.reshape(EDGE_RAYS, -1, 3).sum(0)) / (EDGE_RAYS + 1)
    return byted(image.reshape(eye.rows, eye.columns, 3))


def _lit(world: World, eye: Eye, surface: Seen) -> Lit:
    """Light at every `STEP`-th pixel, smoothed."""
    start = STEP // 2
    rows, columns = np.arange(start, eye.rows, STEP), np.arange(start, eye.columns, STEP)
    chosen = (rows[:, None] * eye.columns + columns).ravel()
    point, normal = surface.point[chosen], surface.normal[chosen]
    light, mean = irradiance(world, point, normal, noise_of(np.arange(len(chosen)), len(columns)))
    shape = (len(rows), len(columns))
    parts = [a.reshape(*shape, 3).astype(np.float32) for a in (light, point, normal)]
    distance = np.minimum(surface.distance[chosen], 100).reshape(shape).astype(np.float32)
    return Lit(smoothed(parts[0], parts[1], parts[2], distance, 2), parts[1], parts[2], start, mean)


def _shaded(world: World, eye: Eye, lit: Lit, pixels: Index, direction: Array, surface: Seen, mirrored: bool) -> Array:
    """Light (n, 3) that surfaces send to the eye."""
    where = np.stack([pixels // eye.columns, pixels % eye.columns], -1).astype(np.float32)
    distance = np.minimum(surface.distance, 100).astype(np.float32)
    light = spread(lit.light, lit.point, lit.normal, STEP, lit.start, where, surface.point, surface.normal,
                   distance)
    light, alike = light[:, :3], light[:, 3]
    alone = np.flatnonzero((alike < ALIKE) & (surface.triangle >= 0))
    if len(alone):
        noise = noise_of(pixels[alone], eye.columns)
        light[alone], _ = irradiance(world, surface.point[alone], surface.normal[alone], noise, lit.mean)
    full = light + sunlit(world, surface.point, surface.normal)[:, None] * SUN
    glow = world.glow[surface.triangle] & (surface.triangle >= 0)
    metal, rough = _properties(world, surface.triangle)
    shaded = surface.color * full * (1 - 0.85 * metal)[:, None]
    _shine(world, lit, direction, surface, light, metal, rough, shaded, mirrored)
    shaded[glow] += surface.color[glow] * GLOW
    return np.asarray(shaded)


def _properties(world: World, triangle: Index) -> tuple[Array, Array]:
    """Metalness and roughness of surfaces, (n,) each."""
    soup = world.every.soup
    table = np.array([(m.metalness, m.roughness) for m in soup.materials], np.float32)[soup.material[triangle]]
    return table[:, 0], np.where(triangle >= 0, table[:, 1], 1.0)


def _shine(world: World, lit: Lit, direction: Array, surface: Seen, light: Array, metal: Array, rough: Array,
           shaded: Array, mirrored: bool) -> None:
    """Adds what smooth surfaces mirror, in place; where nothing is traced, the light about them stands for it."""
    facing = -np.einsum("nd,nd->n", direction, surface.normal).clip(-1, 0)
    least = 0.04 + 0.86 * metal
    share = (least + (1 - least) * (1 - facing) ** 5) * (1 - rough / (GLOSSY + 0.5 * metal)).clip(0) ** 1.5
    rows = np.flatnonzero(share > 0.02)
    if not len(rows):
        return
    around = 0.55 * light[rows]
    clear = np.flatnonzero((share[rows] > 0.06) & (rough[rows] < GLOSSY)) if mirrored else np.zeros(0, np.int64)
    if len(clear):
        chosen = rows[clear]
        normal, way = surface.normal[chosen], direction[chosen]
        back = (way - 2 * np.einsum("nd,nd->n", way, normal)[:, None] * normal).astype(np.float32)
        start = surface.point[chosen] + normal * LIFT
        there = seen(world, start, back, world.every.first(start, back), 3e-3)
        mean = lit.light.reshape(-1, 3).mean(0)
        sent = there.color * (mean + sunlit(world, there.point, there.normal)[:, None] * SUN)
        sent[world.glow[there.triangle]] += GLOW
        out = there.triangle < 0
        sent[out] = outside(back[out]) * 1.5
        around[clear] = sent
    tint = np.where(metal[rows, None] > 0.5, surface.color[rows], 1.0)
    shaded[rows] += around * share[rows, None] * tint


def outside(direction: Array) -> Array:
    """What is beyond the windows: sky, and hazy ground below the horizon."""
    up = direction[:, 2:]
    sky = HORIZON + (ZENITH - HORIZON) * np.sqrt(up.clip(0)) * 0.9
    ground = HORIZON * 0.9 + (GROUND - HORIZON * 0.9) * (1 - np.exp(up.clip(-1, 0) * 7))
    return np.asarray(np.where(up > 0, sky, ground), np.float32)


def _exposure(shaded: Array, indoors: NDArray[np.bool_]) -> float:
    """What light is multiplied with, so that most of what is inside is neither dark nor white."""
    if not indoors.any():
        return 1.0
    bright = shaded[indoors] @ np.array([0.21, 0.72, 0.07], np.float32)
    return float(np.clip(MEAN / max(float(np.exp(np.log(bright + 1e-3).mean())), 1e-3), 0.4, 4.0))


def _developed(shaded: Array, surface: Seen, direction: Array, exposure: float) -> Array:
    """Linear colours in [0, 1] behind their panes."""
    image = toned(shaded * exposure)
    out = surface.triangle < 0
    image[out] = outside(direction[out])
    return np.asarray((image * surface.through + surface.veil).clip(0, 1), np.float32)


def _edges(world: World, eye: Eye, whole: First, surface: Seen) -> Index:
    """Pixels beside one of another body, another direction or clearly another colour, and such that hold two bodies,
    materials or directions though their neighbours do not.
    """
    shape = (eye.rows, eye.columns)
    owner = np.where(surface.triangle >= 0, world.every.soup.owner[surface.triangle], -1).reshape(shape)
    point, normal, color, through = (
        part.reshape(*shape, 3).astype(np.float32, copy=False)
        for part in (surface.point, surface.normal, surface.color, surface.through))
    found = edges(owner, point, normal, color, through, APART, RAISED)
    thin = _within(world, eye, whole, found.ravel()).reshape(shape)
    return np.flatnonzero(found | _widened(thin, THIN))


def _widened(found: NDArray[np.bool_], by: int) -> NDArray[np.bool_]:
    """What is found, and what is up to so many pixels above, below, left or right of it."""
    from scipy import ndimage

    line = np.ones(2 * by + 1, bool)
    wide: NDArray[np.bool_] = ndimage.binary_dilation(found, line[:, None]) | ndimage.binary_dilation(found, line[None])
    return wide


def _within(world: World, eye: Eye, whole: First, known: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Where a ray beside the middle of a pixel, of every second one that is not known, meets another body, material or
    direction.
    """
    soup, found = world.every.soup, np.zeros(eye.rows * eye.columns, bool)
    pixels = np.arange(len(found))
    pixels = pixels[((pixels // eye.columns + pixels % eye.columns) % 2 == 0) & ~known]
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


def toned(light: Array) -> Array:
    """Highlights rolled off softly, everything else left."""
    knee = np.float32(0.75)
    over = (light - knee).clip(0)
    return np.where(light > knee, knee + (1 - knee) * (1 - np.exp(-over / (1 - knee))), light)
