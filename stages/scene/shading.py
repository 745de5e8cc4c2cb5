"""Light that surfaces send to the eye: what falls on them, what they mirror, and what glows."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from apartgen.stages.scene.kernels import smoothed, spread
from apartgen.stages.scene.light import LIFT, SUN, irradiance, sunlit
from apartgen.stages.scene.looking import Eye, Seen, seen
from apartgen.stages.scene.noise import noise_of
from apartgen.stages.scene.soup import Array, Index
from apartgen.stages.scene.surfaces import mirroring, sent, served
from apartgen.stages.scene.world import World

STEP = 4
"""Light is found at every so many pixels, and spread over those between."""
ALIKE = 1e-4
"""Points of which less was found nearby have their light found for themselves."""
GLOSSY = 0.42
"""Surfaces rougher than this mirror nothing."""
MIRRORED = 0.06
"""Share of light from which it is looked what a surface mirrors; below, the light about it stands for it."""
GLOW = np.array([1.0, 0.88, 0.72], np.float32) * np.float32(0.9)
HORIZON = np.array([0.80, 0.88, 0.95], np.float32)
ZENITH = np.array([0.34, 0.56, 0.86], np.float32)
GROUND = np.array([0.42, 0.47, 0.36], np.float32)


class Lit(NamedTuple):
    """Of every `STEP`-th pixel: where light was found (rows, columns, …), to look up that of points nearby."""

    light: Array
    point: Array
    normal: Array
    start: int
    mean: Array


class Shade(NamedTuple):
    """Of all pixels: light `sent` to the eye (n, 3), light that falls on what is there, `full`, light that it could
    mirror, `around`.
    """

    lit: Lit
    sent: Array
    full: Array
    around: Array


def shaded(world: World, eye: Eye, direction: Array, surface: Seen, mirrored: bool) -> Shade:
    """What the surfaces in all pixels send; not `mirrored`, the light about them stands for what they mirror."""
    lit = _lit(world, eye, surface)
    full, around = _falling(world, eye, lit, np.arange(eye.rows * eye.columns), surface)
    share = _mirroring(world, direction, surface)
    if mirrored:
        chosen = np.flatnonzero(share > MIRRORED)
        chosen = chosen[_looks(world)[world.every.soup.material[surface.triangle[chosen]], 1] < GLOSSY]
        around[chosen] = _mirrored(world, lit, direction[chosen], surface.point[chosen], surface.normal[chosen])
    own = np.arange(len(share))
    return Shade(lit, _sent(world, surface, full, around, own, share), full, around)


def refined(world: World, eye: Eye, shade: Shade, pixels: Index, directions: Sequence[Array], surface: Seen,
            fine: Sequence[Seen], raised: float) -> list[Array]:
    """Light (n, 3) that is sent along each of several rays beside the middles of pixels; light on what is there is that
    of the same surface in the middle of the pixel or of one next to it, where there is one.
    """
    shape = (eye.rows, eye.columns)
    about = surface.triangle.reshape(shape), surface.point.reshape(*shape, 3), surface.normal.reshape(*shape, 3)
    like = [served(pixels, part.triangle, part.point, part.normal, *about, world.every.soup.owner, raised)
            for part in fine]
    new = [np.flatnonzero(part < 0) for part in like]
    alone = Seen(*(np.concatenate([part[rows] for part, rows in zip(parts, new)]) for parts in zip(*fine)))
    falling = _falling(world, eye, shade.lit, np.concatenate([pixels[rows] for rows in new]), alone)
    full, around = (np.concatenate(parts) for parts in zip((shade.full, shade.around), falling))
    found, start = [], len(shade.full)
    for direction, part, same, rows in zip(directions, fine, like, new):
        same[rows] = np.arange(start, start + len(rows))
        found.append(_sent(world, part, full, around, same, _mirroring(world, direction, part)))
        start += len(rows)
    return found


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


def _falling(world: World, eye: Eye, lit: Lit, pixels: Index, surface: Seen) -> tuple[Array, Array]:
    """Light (n, 3) that falls on surfaces, and what stands for light that they mirror."""
    light, alike = spread(lit.light, lit.point, lit.normal, STEP, lit.start, pixels, eye.columns, surface.point,
                          surface.normal, surface.distance)
    alone = np.flatnonzero((alike < ALIKE) & (surface.triangle >= 0))
    if len(alone):
        noise = noise_of(pixels[alone], eye.columns)
        light[alone], _ = irradiance(world, surface.point[alone], surface.normal[alone], noise, lit.mean)
    around = light * np.float32(0.55)
    light += sunlit(world, surface.point, surface.normal)[:, None] * SUN
    return light, around


def _looks(world: World) -> Array:
    """Metalness and roughness of materials, (k, 2)."""
    return np.array([(m.metalness, m.roughness) for m in world.every.soup.materials], np.float32)


def _mirroring(world: World, direction: Array, surface: Seen) -> Array:
    return np.asarray(mirroring(direction, surface.normal, surface.triangle, world.every.soup.material, _looks(world),
                                GLOSSY))


def _sent(world: World, surface: Seen, full: Array, around: Array, like: Index, share: Array) -> Array:
    return np.asarray(sent(surface.color, full, around, like, share, surface.triangle, world.every.soup.material,
                           _looks(world), world.glow, GLOW))


def _mirrored(world: World, lit: Lit, direction: Array, point: Array, normal: Array) -> Array:
    """Light (n, 3) of what surfaces mirror to the eye."""
    back = (direction - 2 * np.einsum("nd,nd->n", direction, normal)[:, None] * normal).astype(np.float32)
    start = point + normal * LIFT
    there = seen(world, start, back, world.every.first(start, back), 3e-3)
    mean = lit.light.reshape(-1, 3).mean(0)
    light = there.color * (mean + sunlit(world, there.point, there.normal)[:, None] * SUN)
    light[world.glow[there.triangle]] += GLOW
    out = there.triangle < 0
    light[out] = outside(back[out]) * 1.5
    return np.asarray(light, np.float32)


def outside(direction: Array) -> Array:
    """What is beyond the windows: sky, and hazy ground below the horizon."""
    up = direction[:, 2:]
    sky = HORIZON + (ZENITH - HORIZON) * np.sqrt(up.clip(0)) * 0.9
    ground = HORIZON * 0.9 + (GROUND - HORIZON * 0.9) * (1 - np.exp(up.clip(-1, 0) * 7))
    return np.asarray(np.where(up > 0, sky, ground), np.float32)
