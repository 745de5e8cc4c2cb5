"""Pictures of bodies: sun, sky and their shadows, by ray tracing."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.noise import GOLDEN, about, noise_of, shifted
from apartgen.stages.scene.soup import Array, Hits, Index, Soup, Tracer, colors, encoded, split

PASSES, EDGE_PASSES = 2, 6
"""Rays through each pixel, and further ones through those where something begins or ends."""
SKY_RAYS = 3
"""Rays to the sky from each point that a pass sees."""
BAND = 60_000
"""Rays at a time, so that what belongs to them stays in the processor's cache."""


def _vector(x: float, y: float, z: float, scale: float = 1.0) -> Array:
    return np.array([x, y, z], np.float32) * np.float32(scale)


SUN = _vector(-0.55, -0.42, 1.0, 1 / np.sqrt(0.55**2 + 0.42**2 + 1))
SUN_SIZE = 0.05  # rad, half the angle it is seen under; wider than the real one for soft edges
LIGHT = np.stack([_vector(1.00, 0.93, 0.80, 1.2), _vector(0.86, 0.93, 1.0, 0.95)])
"""Colours of sun and sky."""
BOUNCE = _vector(1.0, 0.96, 0.90, 0.20)
"""Light that has been about the rooms more than once, taken as even."""
PAPER = _vector(0.93, 0.935, 0.94)
_LIFT = np.float32(2e-3)  # m that secondary rays start off their surface


class Seen(NamedTuple):
    """At pixels (n, …): colour of the surface, shares of sun and sky on it (2), its normal (0, 0, 2 for the ground)."""

    color: Array
    light: Array
    normal: Array


class View(NamedTuple):
    """What is looked at: a camera, what is solid and what is glass, and the height of the ground under them, m."""

    camera: Camera
    solid: Tracer
    glass: Tracer
    ground: Array


def picture(every: Soup, camera: Camera, ground: float) -> NDArray[np.uint8]:
    """The image, (rows, columns, 3), of triangles above a plain ground at that height, m."""
    clear = np.array([m.color[3] < 1 for m in every.materials])[every.material]
    glass, solid = split(every, clear)
    view = View(camera, Tracer(solid), Tracer(glass), np.asarray(ground, np.float32))
    whole = np.arange(camera.rows * camera.columns)
    seen = Seen(*(sum(part) / PASSES for part in zip(*(_pass(view, whole, k) for k in range(PASSES)))))
    shape = (camera.rows, camera.columns)
    light = _smooth(seen.light.reshape(*shape, 2), seen.normal.reshape(*shape, 3)).reshape(-1, 2)
    image = seen.color * _falling(light, seen.normal)
    edge = np.flatnonzero(_edges(seen.normal.reshape(*shape, 3), seen.color.reshape(*shape, 3)))
    fine = [_pass(view, edge, PASSES + k) for k in range(EDGE_PASSES)]
    image[edge] = sum(toned(part.color * _falling(light[edge], part.normal)) for part in fine) / EDGE_PASSES
    return np.asarray(np.rint(encoded(toned(image)).reshape(*shape, 3) * 255), np.uint8)


def _falling(light: Array, normal: Array) -> Array:
    """Light (n, 3) that falls where sun and sky have these shares; the ground is paper and only half shaded."""
    full: Array = light @ LIGHT + BOUNCE
    open_ = np.array([SUN[2], 0.9], np.float32) @ LIGHT + BOUNCE
    shade = 0.45 + 0.55 * (full / open_).clip(0, 1)
    return np.where(normal[:, 2:] > 1.5, shade / PAPER, full)


def _pass(view: View, pixels: Index, k: int) -> Seen:
    """What the k-th ray through each of the pixels sees."""
    bands = np.array_split(pixels, max(1, len(pixels) // BAND))
    parts = [_band(view, band, k) for band in bands]
    return Seen(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _band(view: View, pixels: Index, k: int) -> Seen:
    camera, solid = view.camera, view.solid
    direction = camera.rays(pixels, (0.5 + (k + 1) * GOLDEN) % 1)
    origin = np.broadcast_to(camera.eye, direction.shape)
    hits, panes = solid.first(origin, direction), view.glass.first(origin, direction)
    rows, ground = np.flatnonzero(hits.triangle >= 0), np.flatnonzero(hits.triangle < 0)
    color = np.broadcast_to(PAPER, direction.shape).copy()
    normal = np.broadcast_to(_vector(0, 0, 1), direction.shape).copy()
    color[rows], normal[rows] = _surface(hits, rows, solid.soup, direction)
    distance = hits.distance.copy()
    distance[ground] = ((view.ground - camera.eye[2]) / direction[:, 2])[ground]
    light = _light(solid, camera.eye + direction * distance[:, None], normal, pixels, camera.columns, k)
    normal[ground] *= 2
    _tint(panes, hits, view.glass.soup, color)
    return Seen(color, light, normal)


def _surface(hits: Hits, rows: Index, of: Soup, direction: Array) -> tuple[Array, Array]:
    color, normal = colors(Hits(hits.triangle[rows], hits.distance[rows], hits.weights[rows]), of)
    away = np.einsum("nd,nd->n", normal, direction[rows]) > 0
    normal[away] *= -1
    return color, normal


def _light(solid: Tracer, place: Array, normal: Array, pixels: Index, columns: int, k: int) -> Array:
    """Shares of sun and sky that reach points, (n, 2)."""
    start = place + normal * _LIFT
    base, first = noise_of(pixels, columns), k * (SKY_RAYS + 1)
    noise = shifted(base, first)
    spread, turn = SUN_SIZE * np.sqrt(noise[:, :1]), 2 * np.pi * noise[:, 1:]
    side = np.cross(SUN, _vector(0, 1, 0))
    sun = SUN + spread * (np.cos(turn) * side + np.sin(turn) * np.cross(SUN, side))
    light = np.stack([(normal @ SUN).clip(0), np.zeros(len(place), np.float32)], -1)
    lit = np.flatnonzero(light[:, 0])
    light[lit, 0] *= solid.free(start[lit], sun[lit])
    for j in range(1, SKY_RAYS + 1):
        way = about(normal, shifted(base, first + j))
        up = np.flatnonzero(way[:, 2] > 0)
        light[up, 1] += solid.free(start[up], way[up]) * (0.55 + 0.45 * way[up, 2]) / SKY_RAYS
    return light


def _tint(panes: Hits, hits: Hits, of: Soup, color: Array) -> None:
    """Lays panes that are in front over what is behind, in place."""
    rows = np.flatnonzero((panes.triangle >= 0) & (panes.distance < hits.distance))
    if len(rows):
        chosen = Hits(panes.triangle[rows], panes.distance[rows], panes.weights[rows])
        own, _ = colors(chosen, of)
        alpha = np.array([m.color[3] for m in of.materials], np.float32)[of.material[chosen.triangle]][:, None]
        color[rows] = color[rows] * (1 - 0.8 * alpha) + own * 0.8 * alpha


def _edges(normal: Array, color: Array) -> NDArray[np.bool_]:
    """Pixels (rows, columns) beside one of another surface or clearly another colour."""
    found = np.zeros(normal.shape[:2], bool)
    for axis in (0, 1):
        step = np.abs(np.diff(normal, axis=axis)).sum(-1) + 2.0 * np.abs(np.diff(color, axis=axis)).sum(-1) > 0.15
        ahead, behind = ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1]))[axis]
        found[ahead] |= step
        found[behind] |= step
    return found


def _smooth(light: Array, normal: Array) -> Array:
    """The light averaged over near pixels of the same surface: three rounds of wider and wider rings."""
    rows, columns = light.shape[:2]
    for reach in (1, 2, 3):
        total, weight = light.copy(), np.ones((rows, columns, 1), np.float32)
        for dy, dx in ((y, x) for y in (-reach, 0, reach) for x in (-reach, 0, reach) if x or y):
            here = np.s_[max(0, dy) : rows + min(0, dy), max(0, dx) : columns + min(0, dx)]
            there = np.s_[max(0, -dy) : rows + min(0, -dy), max(0, -dx) : columns + min(0, -dx)]
            apart = np.square(normal[here] - normal[there]).sum(-1) * 40 + np.square(light[here] - light[there]).sum(-1)
            w = np.exp(-apart)[..., None]
            total[here] += w * light[there]
            weight[here] += w
        light = total / weight
    return light


def toned(light: Array) -> Array:
    """Highlights rolled off softly, everything else left."""
    knee = np.float32(0.75)
    over = (light - knee).clip(0)
    return np.where(light > knee, knee + (1 - knee) * (1 - np.exp(-over / (1 - knee))), light)
