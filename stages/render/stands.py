"""Where a person would stand and look to see much: on free floor, the head in free air, towards most things."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Layout
from apartgen.stages.robot import reach
from apartgen.stages.robot.way import spread_places
from apartgen.stages.scene.camera import MIDDLE, Camera, Panorama
from apartgen.stages.scene.soup import Array, Index
from apartgen.stages.scene.world import HomeWorld, hangs
from apartgen.stages.space import boxes, grid

PLACES, HEADINGS = 9, 16
"""Places of a room, and headings of each, that are tried."""
PITCH = np.radians(-10.0)
COARSE, AROUND = 32, 144
"""Columns of the pictures by which views are judged, and directions all around that they are made of."""
ENOUGH = 0.01
"""Share of the picture from which a thing counts as seen."""
MARGIN = 1.25
"""What is seen coarsely must cover so much more than that."""
HEAD = 0.25
"""How far from everything a camera at the height of eyes is, m."""
OPENS = 2.0
"""To show something that opens is worth so many other things."""
CLOSE = 0.7
"""What is nearer than this is in the way of seeing, m."""
GLARE, GLARING = 2.0, 4.0
"""Nearer than this, m, a lamp that hangs is in the way so many times as much."""


class Stand(NamedTuple):
    """A place to look from, its room's index, and the heading."""

    room: int
    place: Array
    yaw: float


def free_floor(world: HomeWorld) -> tuple[reach.Space, NDArray[np.bool_]]:
    """The raster of a robot, and where on it one may stand."""
    space = reach.space(world.plan)
    objects = world.plan.objects if isinstance(world.plan, Layout) else []
    return space, reach.free(space, objects)


def free_air(world: HomeWorld, height: float) -> tuple[reach.Space, NDArray[np.bool_]]:
    """The raster of a robot, and where on its floor a head at that height touches nothing, hanging things included."""
    space, cells = free_floor(world)
    return space, cells & _clear(world, space, height)


def _clear(world: HomeWorld, space: reach.Space, height: float) -> NDArray[np.bool_]:
    objects = world.plan.objects if isinstance(world.plan, Layout) else []
    level = boxes.of([o for o in objects if abs(o.center[2] - height) < o.size[2] / 2 + HEAD])
    return np.asarray(space.open & (grid.near(level, space.grid, HEAD) == 0))


def middles(world: HomeWorld, height: float) -> list[Stand]:
    """One place of each room, from where a panorama shows most; over furniture where no floor is free."""
    space, cells = free_air(world, height)
    over, found = _clear(world, space, height), []
    for i in range(len(world.plan.rooms)):
        some = (spread_places(space, free, i, 1) for free in (cells, over))
        at = next((places[0] for places in some if len(places)), np.array(world.plan.rooms[i].polygon).mean(0))
        found.append(Stand(i, np.array([*at, height]), 0.0))
    return found


def best(world: HomeWorld, views: int, height: float, field: float, shape: tuple[int, int]) -> list[Stand]:
    """Up to so many stands that together show most things; each shows five or more where any does.

    `field` in rad and `shape` (columns, rows) are those of the pictures.
    """
    space, cells = free_air(world, height)
    stands = [Stand(i, np.array([*place, height]), float(yaw)) for i in range(len(world.plan.rooms))
              for place in spread_places(space, cells, i, PLACES)
              for yaw in np.arange(HEADINGS) * 2 * np.pi / HEADINGS]
    if not stands:
        return []
    shares, near = _judged(world, stands, field, shape[1] / shape[0])
    seen = shares > ENOUGH * MARGIN
    counts = seen.sum(1)
    opens = [any(link.joint for link in body.links) for body in world.bodies if body.kind == "object"]
    new_worth = np.where(opens, OPENS, 1.0)
    chosen: list[int] = []
    taken: dict[int, int] = {}
    while len(chosen) < views:
        gain = seen @ new_worth + 0.25 * np.minimum(counts, 8) - 8 * near
        gain = gain - 1.5 * np.array([taken.get(s.room, 0) for s in stands])
        gain[counts < 5] -= 100
        gain[chosen] = -np.inf
        k = int(np.argmax(gain))
        if chosen and (not np.isfinite(gain[k]) or counts[k] < 5):
            break
        chosen.append(k)
        taken[stands[k].room] = taken.get(stands[k].room, 0) + 1
        new_worth[seen[k]] *= 0.3
    return [stands[k] for k in sorted(chosen)]


def _judged(world: HomeWorld, stands: list[Stand], field: float, aspect: float) -> tuple[Array, Array]:
    """Share of each object in a coarse picture from each stand, (n, objects), and of what is too near, (n,)."""
    column, row, around = _coarse(field, aspect)
    objects = np.array([body.kind == "object" for body in world.bodies])
    hanging = np.array([hangs(body) for body in world.bodies])
    count, index = int(objects.sum()), np.where(objects, np.cumsum(objects) - 1, -1)
    shares, near = np.zeros((len(stands), count)), np.zeros(len(stands))
    turn = np.arange(HEADINGS)[:, None]
    cells = row * AROUND + (column + turn * (AROUND // HEADINGS)) % AROUND
    for start in range(0, len(stands), HEADINGS):
        eye = np.broadcast_to(stands[start].place.astype(np.float32), around.shape)
        hits = world.every.first(eye, around)
        thing = np.where(hits.triangle >= 0, index[world.every.soup.owner[hits.triangle]], -1)[cells]
        seen = np.bincount((turn * count + thing)[thing >= 0], minlength=HEADINGS * count)
        shares[start:start + HEADINGS] = seen.reshape(HEADINGS, count) / cells.shape[1]
        lamp = (hits.triangle >= 0) & hanging[world.every.soup.owner[hits.triangle]] & (hits.distance < GLARE)
        near[start:start + HEADINGS] = np.where(lamp, GLARING, hits.distance < CLOSE)[cells].mean(1)
    return shares, near


def _coarse(field: float, aspect: float) -> tuple[Index, Index, Array]:
    """Of the pixels of a coarse picture to the east: the nearest column and row of a raster of all directions around;
    and those directions (rows × `AROUND`, 3).
    """
    camera = Camera.looking(np.zeros(3), 0.0, PITCH, field, COARSE, max(1, round(COARSE * aspect)))
    way = camera.rays(np.arange(camera.rows * camera.columns), MIDDLE).astype(float)
    step = 2 * np.pi / AROUND
    column = np.rint(np.arctan2(way[:, 1], way[:, 0]) / step).astype(np.int64)
    row = np.rint(np.arcsin(way[:, 2].clip(-1, 1)) / step).astype(np.int64)
    yaw, pitch = np.arange(AROUND) * step, (row.min() + np.arange(np.ptp(row) + 1))[:, None] * step
    flat = np.cos(pitch)
    around = np.stack(np.broadcast_arrays(flat * np.cos(yaw), flat * np.sin(yaw), np.sin(pitch)), -1)
    return column, row - row.min(), around.reshape(-1, 3).astype(np.float32)


def panorama(stand: Stand, rows: int) -> Panorama:
    """All that is seen from a stand."""
    return Panorama(stand.place.astype(np.float32), rows, 2 * rows)
