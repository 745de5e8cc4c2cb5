"""What places cost, compiled.

Of the project only the names of arrays are imported: the cache of compiled code sees changes of this file alone.
"""

from typing import Any, NamedTuple

import numpy as np
from numba import float64, types
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled, inner
from apartgen.stages.space.boxes import Boxes

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


class Lines(NamedTuple):
    """Where walls start, their directions and inward normals (E, 2), lengths (E,); whether the room is convex."""

    start: Floats
    along: Floats
    normal: Floats
    length: Floats
    convex: bool


class Walls(NamedTuple):
    """The lines of the walls, and the bodies of those that meet at corners which stand out into the room."""

    lines: Lines
    corners: Boxes


class Zones(NamedTuple):
    """What is to be kept clear (Z,), and which of it is before windows."""

    boxes: Boxes
    window: Flags


class Others(NamedTuple):
    """What stands (k,): boxes, b′, which of it is no hindrance, which is a seat or table with the object, and how far
    the two may be drawn into one another, m."""

    boxes: Boxes
    grown: Boxes
    soft: Flags
    seated: Flags
    tuck: Floats


class Turned(NamedTuple):
    """Boxes with the cosines and sines of their yaw."""

    center: Floats
    size: Floats
    cos: Floats
    sin: Floats


class Kept(NamedTuple):
    """`Zones`, turned."""

    center: Floats
    size: Floats
    cos: Floats
    sin: Floats
    window: Flags


class Stood(NamedTuple):
    """`Others`, turned; b′ is turned as its box is."""

    center: Floats
    size: Floats
    g_center: Floats
    g_size: Floats
    cos: Floats
    sin: Floats
    soft: Flags
    seated: Flags
    tuck: Floats


class Room(NamedTuple):
    """What parts that open sweep, and how deep a contact is none, m."""

    zones: Kept
    lines: Lines
    corners: Turned
    slack: float


named: Any = types.NamedTuple
A, B, C = float64[::1], float64[:, ::1], types.boolean[::1]
BOXES = named((B, B, A), Boxes)
LINES = named((B, B, B, A, types.boolean), Lines)
WALLS = named((LINES, BOXES), Walls)
ZONES = named((BOXES, C), Zones)
OTHERS = named((BOXES, BOXES, C, C, A), Others)


def writable(found: Boxes) -> Boxes:
    """Floats in memory of their own, as compiled code takes them; boxes of one size may share that."""
    return Boxes(*(np.ascontiguousarray(part, float) for part in found))


@inner
def _turned(boxes: Boxes) -> Turned:
    return Turned(boxes.center, boxes.size, np.cos(boxes.yaw), np.sin(boxes.yaw))


@inner
def _depth(at: Floats, size: Floats, c: float, s: float, other: Floats, extent: Floats, oc: float, os: float) -> float:
    """`boxes.penetration` of two boxes, or 0 where apart."""
    depth = (size[2] + extent[2]) / 2 - abs(other[2] - at[2])
    if depth <= 0:
        return 0.0
    x, y = other[0] - at[0], other[1] - at[1]
    cosine, sine = abs(c * oc + s * os), abs(s * oc - c * os)
    ax, ay, bx, by = size[0] / 2, size[1] / 2, extent[0] / 2, extent[1] / 2
    depth = min(depth, ax + bx * cosine + by * sine - abs(x * c + y * s))
    if depth <= 0:
        return 0.0
    depth = min(depth, ay + bx * sine + by * cosine - abs(y * c - x * s))
    if depth <= 0:
        return 0.0
    depth = min(depth, bx + ax * cosine + ay * sine - abs(x * oc + y * os))
    return float(max(min(depth, by + ax * sine + ay * cosine - abs(y * oc - x * os)), 0.0))


@inner
def _least(x: float, y: float, lines: Lines) -> float:
    """The least distance inwards from the walls' lines; 0 in a room that is not convex, of which it tells nothing."""
    least = float(np.inf) if lines.convex else 0.0
    for k in range(len(lines.length) if lines.convex else 0):
        least = min(least, (x - lines.start[k, 0]) * lines.normal[k, 0] + (y - lines.start[k, 1]) * lines.normal[k, 1])
    return least


@inner
def _far(x: float, y: float, lines: Lines) -> float:
    """0 on the floor, else the distance to the nearest wall."""
    if _least(x, y, lines) > 0:
        return 0.0
    within, nearest = _nearest(x, y, lines)
    return 0.0 if within and not lines.convex else nearest


@inner
def _nearest(x: float, y: float, lines: Lines) -> tuple[bool, float]:
    """Whether a point lies on the floor, and its distance to the nearest wall."""
    start, along, _, length, _ = lines
    n, within, nearest = len(length), False, float(np.inf)
    for k in range(n):
        u, v, after = x - start[k, 0], y - start[k, 1], start[(k + 1) % n, 1]
        share = min(max(u * along[k, 0] + v * along[k, 1], 0.0), length[k])
        nearest = min(nearest, np.hypot(u - share * along[k, 0], v - share * along[k, 1]))
        if (start[k, 1] > y) != (after > y):
            turn = along[k, 0] * v - along[k, 1] * u
            if (turn > 0) if after > start[k, 1] else (turn < 0):
                within = not within
    return within, nearest


@inner
def _beyond(at: Floats, size: Floats, c: float, s: float, lines: Lines, corners: Turned) -> float:
    """How far a box stands beyond the walls."""
    center, extent, cos, sin = corners
    far = 0.0
    for i in (-0.5, 0.5):
        for j in (-0.5, 0.5):
            x, y = i * size[0], j * size[1]
            far = max(far, _far(at[0] + x * c - y * s, at[1] + x * s + y * c, lines))
    for k in range(len(cos)):
        far = max(far, _depth(at, size, c, s, center[k], extent[k], cos[k], sin[k]))
    return far


@compiled(A(BOXES, WALLS))
def beyond(found: Boxes, walls: Walls) -> Floats:
    """How far each box (n,) stands beyond the walls, m."""
    (center, size, yaw), lines, corners = found, walls.lines, _turned(walls.corners)
    far = np.empty(len(yaw))
    for i in range(len(yaw)):
        far[i] = _beyond(center[i], size[i], np.cos(yaw[i]), np.sin(yaw[i]), lines, corners)
    return far


@compiled(A(BOXES, A, WALLS))
def behind(found: Boxes, aside: Floats, walls: Walls) -> Floats:
    """Distance of each back (n,), `aside` of its middle, from the nearest wall, m."""
    center, size, yaw = found
    away = np.empty(len(yaw))
    for i in range(len(yaw)):
        c, s, back = np.cos(yaw[i]), np.sin(yaw[i]), size[i, 0] / 2
        x, y = center[i, 0] - c * back - s * aside[i], center[i, 1] - s * back + c * aside[i]
        least = _least(x, y, walls.lines)
        away[i] = least if least > 0 else _nearest(x, y, walls.lines)[1]
    return away


@inner
def _priced(depth: float, price: float, slack: float) -> float:
    return price + 5 * price * depth if depth > slack else 0.0


@inner
def _most(at: Floats, size: Floats, c: float, s: float, zones: Kept, windows: bool) -> float:
    """Deepest in any door's zone, or in any window's."""
    center, extent, cos, sin, window = zones
    deepest = 0.0
    for k in range(len(cos)):
        if window[k] == windows:
            deepest = max(deepest, _depth(at, size, c, s, center[k], extent[k], cos[k], sin[k]))
    return deepest


@inner
def _bodies(at: Floats, size: Floats, c: float, s: float, stood: Stood, zones: Kept, slack: float) -> float:
    """Price of standing before doors and windows and in others."""
    center, extent, _, _, cos, sin, soft, _, tuck = stood
    total = _priced(_most(at, size, c, s, zones, False), 30.0, slack)
    total += _priced(_most(at, size, c, s, zones, True), 12.0, slack)
    for k in range(len(cos)):
        if not soft[k]:
            depth = _depth(at, size, c, s, center[k], extent[k], cos[k], sin[k])
            total += _priced(depth - tuck[k], 20.0, slack)
    return total


@inner
def _sweeps(at: Floats, size: Floats, c: float, s: float, far: float, stood: Stood, room: Room) -> float:
    """Price of sweeping others, and of being swept."""
    center, extent, g_center, g_extent, cos, sin, soft, seated, _ = stood
    zones, lines, corners, slack = room
    total, opens = 0.0, far > 1e-6
    ahead, wide = at.copy(), size.copy()
    if opens:
        ahead[0] += c * far / 2
        ahead[1] += s * far / 2
        wide[0] += far
        total += _priced(_beyond(ahead, wide, c, s, lines, corners), 12.0, slack)
        total += _priced(_most(ahead, wide, c, s, zones, False), 6.0, slack)
    for k in range(len(cos)):
        if soft[k] or seated[k]:
            continue
        if g_extent[k, 0] > extent[k, 0] + 1e-6:
            total += _priced(_depth(at, size, c, s, g_center[k], g_extent[k], cos[k], sin[k]), 14.0, slack)
            if opens:
                total += _priced(_depth(ahead, wide, c, s, g_center[k], g_extent[k], cos[k], sin[k]), 10.5, slack)
        if opens:
            total += _priced(_depth(ahead, wide, c, s, center[k], extent[k], cos[k], sin[k]), 14.0, slack)
    return total


@compiled(A(BOXES, A, A, OTHERS, ZONES, WALLS, types.float64, types.float64))
def prices(found: Boxes, reach: Floats, way: Floats, others: Others, zones: Zones, walls: Walls, slack: float,
           broken: float) -> Floats:
    """Price of each place (n,): `way` there, and what of `costs.cost` it breaks; what is broken by the walls is not
    asked for bodies, nor what is broken by these for sweeps, unless all are."""
    (o_center, o_size, o_yaw), (g_center, g_size, _), soft, seated, tuck = others
    stood = Stood(o_center, o_size, g_center, g_size, np.cos(o_yaw), np.sin(o_yaw), soft, seated, tuck)
    (z_center, z_size, z_yaw), window = zones
    kept, lines = Kept(z_center, z_size, np.cos(z_yaw), np.sin(z_yaw), window), walls.lines
    corners = _turned(walls.corners)
    room = Room(kept, lines, corners, slack)
    (center, size, yaw), n = found, len(found.yaw)
    base, total, whole = np.empty(n), np.empty(n), n > 0
    for i in range(n):
        c, s = np.cos(yaw[i]), np.sin(yaw[i])
        past = _beyond(center[i], size[i], c, s, lines, corners)
        base[i] = way[i] + (40 + 100 * past if past > slack else 0.0)
        total[i] = base[i]
        if total[i] < broken:
            total[i] += _bodies(center[i], size[i], c, s, stood, kept, slack)
        if total[i] < broken:
            total[i] += _sweeps(center[i], size[i], c, s, reach[i], stood, room)
        whole &= total[i] >= broken
    if whole:
        for i in range(n):
            c, s = np.cos(yaw[i]), np.sin(yaw[i])
            total[i] = base[i] + _bodies(center[i], size[i], c, s, stood, kept, slack)
            total[i] += _sweeps(center[i], size[i], c, s, reach[i], stood, room)
    return total
