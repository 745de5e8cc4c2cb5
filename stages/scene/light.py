"""Light that falls on points of a home: sun, windows, lamps, and what comes back from the surfaces around."""

import numpy as np

from apartgen.stages.scene.kernels import bounced, scattered
from apartgen.stages.scene.noise import GOLDEN
from apartgen.stages.scene.soup import Array, Index
from apartgen.stages.scene.sources import from_ball, through_pane
from apartgen.stages.scene.surfaces import sunward
from apartgen.stages.scene.world import CELL, World

LIFT = np.float32(2e-3)
"""How far off their surface rays begin, m."""
SUN = np.array([1.0, 0.92, 0.80], np.float32) * 1.8
SKY = np.array([0.86, 0.94, 1.0], np.float32) * 3.2
"""Radiance of the sky before windows."""
LAMP = np.array([1.0, 0.88, 0.72], np.float32) * 2.2e-3
"""Of one lumen into all directions, at 1 m."""
LEAST = np.array([1.0, 0.98, 0.95], np.float32) * 0.04
"""Light that is everywhere."""
GATHERED, ON_PANES, ON_LAMPS = 5, 3, 1
"""Rays from a point to its surroundings, to each window and to each lamp of its room."""
BULB = 0.14
"""Radius of lamps, m."""
NEARBY = np.float32(0.5)
"""Surfaces nearer than about this give back less than the room's mean light, m."""
BACK = 0.55
"""Mean share of light that rooms give back."""
DIM = np.float32(1e-5)
"""Less light than this from one place is not looked for."""


def _sequence(first: int, n: int) -> Array:
    """Shifts (n, 2) by which numbers fill the unit square evenly, from the first-th on."""
    return np.asarray(((first + 1 + np.arange(n))[:, None] * GOLDEN % 1).astype(np.float32))


_SHIFTS, _ON_PANES = _sequence(101, GATHERED), _sequence(0, ON_PANES)


def irradiance(
    world: World, point: Array, normal: Array, noise: Array, mean: Array | None = None
) -> tuple[Array, Array]:
    """All light on points (n, 3) but the sun's own, which has sharp edges, and the mean light (3,) about them, which
    may be given; `noise` (n, 2) in [0, 1).
    """
    start = point + normal * LIFT
    room = world.room_at(point + normal * 0.08)
    direct = _from_panes(world, start, normal, room, noise) + _from_lamps(world, start, normal, room, noise)
    known, share = _gathered(world, start, normal, room, noise)
    known += direct + LEAST
    mean = known.mean(0) / (1 - BACK * float(share.mean())) if mean is None else mean
    return np.asarray(known + share * mean, np.float32), mean


def sunlit(world: World, point: Array, normal: Array, lift: float = float(LIFT)) -> Array:
    """Share of the sun's light that falls on points, (n,), looked for so far above them."""
    fall = _sunward(world, point, normal)
    rows = np.flatnonzero(fall)
    way = np.broadcast_to(world.sun, (len(rows), 3))
    if len(rows):
        fall[rows] *= world.blockers.free(point[rows] + normal[rows] * np.float32(lift), way)
    return fall


def _sunward(world: World, point: Array, normal: Array) -> Array:
    """How squarely the sun falls on points that can see it."""
    raster = np.array([*world.cells.origin, CELL])
    return np.asarray(sunward(point, normal, world.sun, world.rooms, raster, world.outdoors, world.ways))


def _from_panes(world: World, start: Array, normal: Array, room: Index, noise: Array) -> Array:
    found = np.zeros_like(start)
    for pane in world.panes:
        rows = np.flatnonzero(room == pane.room)
        if len(rows):
            window = pane.corner, pane.across, pane.up, pane.normal, pane.area / np.pi
            to, flux = through_pane(start, normal, noise, rows, _ON_PANES, *window)
            _shine(world, start, rows, to, flux, 0.97, SKY, found)
    return found


def _from_lamps(world: World, start: Array, normal: Array, room: Index, noise: Array) -> Array:
    found = np.zeros_like(start)
    for j, lamp in enumerate(world.lamps):
        rows = np.flatnonzero(room == lamp.room)
        if len(rows):
            shifts = _sequence(31 + 2 * j, ON_LAMPS)
            to, flux = from_ball(start, normal, noise, rows, shifts, lamp.position, BULB)
            _shine(world, start, rows, to, flux, 1.0, LAMP * np.float32(lamp.lumens), found)
    return found


def _shine(world: World, start: Array, rows: Index, to: Array, flux: Array, far: float, light: Array, found: Array
           ) -> None:
    """Adds the light that comes to some of the points (n, 3) from places, k for each, that nothing hides up to `far` of
    the way.
    """
    at, lit = np.tile(rows, len(flux) // len(rows)), np.flatnonzero(flux > DIM)
    flux = flux[lit] * world.blockers.free(start[at[lit]], to[lit] * np.float32(far), 1.0)
    found += np.bincount(at[lit], flux, len(found)).astype(np.float32)[:, None] * light


def _gathered(world: World, start: Array, normal: Array, room: Index, noise: Array) -> tuple[Array, Array]:
    """Light from the surroundings that is known, and the coloured share of the room's mean light that comes back."""
    known, share = np.zeros_like(start), np.zeros_like(start)
    n, of = len(start), world.blockers.soup
    colors = world.flat[of.material]
    way = scattered(normal, noise, _SHIFTS)
    hits = world.blockers.first(np.tile(start, (GATHERED, 1)), way)
    place, facing = np.empty_like(way), np.empty_like(way)
    bounced(start, way, hits.triangle, hits.distance, of.normals[:, 0], colors, NEARBY, LIFT, share, place, facing)
    fall = sunlit(world, place, facing, 0.0)
    lit = np.flatnonzero(fall)
    np.add.at(known, lit % n, colors[hits.triangle[lit]] * fall[lit, None] * SUN)
    open_air = np.tile((room < 0) | world.outdoors[room], GATHERED)
    missed = np.flatnonzero((hits.triangle < 0) & open_air)
    np.add.at(known, missed % n, SKY * (0.35 + 0.4 * way[missed, 2:].clip(0)))
    return known / GATHERED, share / GATHERED
