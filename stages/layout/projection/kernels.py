# mypy: disable-error-code="no-untyped-def,no-untyped-call"
"""What places cost, compiled.

Nothing here is imported from the project: the cache of compiled code sees changes of this file alone.
"""

from typing import Any

import numpy as np
from numba import njit

# Not callable from Python: those wrappers cost as much to compile as the functions.
WITHIN: dict[str, Any] = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
inner = njit(**WITHIN)
A, B, C = "float64[:]", "float64[:,:]", "boolean[:]"
BOXES = f"{B},{B},{A}"


def compiled(signature: str) -> Any:
    """Compiled when first imported, and kept in numba's cache."""
    return njit(signature, cache=True, error_model="numpy")


@inner
def _depth(at, size, c, s, other, extent, oc, os):  # `boxes.penetration` of two boxes, or 0 where apart
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
    return max(min(depth, by + ax * sine + ay * cosine - abs(y * oc - x * os)), 0.0)


@inner
def _far(x, y, walls):  # 0 on the floor, else the distance to the nearest wall
    start, along, normal, length, convex = walls
    n = len(length)
    if convex:
        inside = True
        for k in range(n):
            inside &= (x - start[k, 0]) * normal[k, 0] + (y - start[k, 1]) * normal[k, 1] > 0
        if inside:
            return 0.0
    nearest, within = np.inf, False
    for k in range(n):
        u, v, after = x - start[k, 0], y - start[k, 1], start[(k + 1) % n, 1]
        share = min(max(u * along[k, 0] + v * along[k, 1], 0.0), length[k])
        nearest = min(nearest, np.hypot(u - share * along[k, 0], v - share * along[k, 1]))
        if (start[k, 1] > y) != (after > y):
            turn = along[k, 0] * v - along[k, 1] * u
            if (turn > 0) if after > start[k, 1] else (turn < 0):
                within = not within
    return 0.0 if within and not convex else nearest


@inner
def _beyond(at, size, c, s, walls, corners):  # how far a box stands beyond the walls
    center, extent, cos, sin = corners
    far = 0.0
    for i in (-0.5, 0.5):
        for j in (-0.5, 0.5):
            x, y = i * size[0], j * size[1]
            far = max(far, _far(at[0] + x * c - y * s, at[1] + x * s + y * c, walls))
    for k in range(len(cos)):
        far = max(far, _depth(at, size, c, s, center[k], extent[k], cos[k], sin[k]))
    return far


@compiled(f"{A}({BOXES},{B},{B},{B},{A},boolean,{BOXES})")
def beyond(center, size, yaw, start, along, normal, length, convex, r_center, r_size, r_yaw):
    """How far each box (n,) stands beyond the walls, m; `r_` are bodies of walls at corners that stand out."""
    walls, corners = (start, along, normal, length, convex), (r_center, r_size, np.cos(r_yaw), np.sin(r_yaw))
    found = np.empty(len(yaw))
    for i in range(len(yaw)):
        found[i] = _beyond(center[i], size[i], np.cos(yaw[i]), np.sin(yaw[i]), walls, corners)
    return found


@inner
def _priced(depth, price, slack):
    return price + 5 * price * depth if depth > slack else 0.0


@inner
def _most(at, size, c, s, zones, windows):  # deepest in any door's zone, or in any window's
    center, extent, cos, sin, window = zones
    deepest = 0.0
    for k in range(len(cos)):
        if window[k] == windows:
            deepest = max(deepest, _depth(at, size, c, s, center[k], extent[k], cos[k], sin[k]))
    return deepest


@inner
def _bodies(at, size, c, s, others, zones, slack):  # of standing before doors and windows and in others
    center, extent, _, _, cos, sin, soft, _, tuck = others
    total = _priced(_most(at, size, c, s, zones, False), 30.0, slack)
    total += _priced(_most(at, size, c, s, zones, True), 12.0, slack)
    for k in range(len(cos)):
        if not soft[k]:
            depth = _depth(at, size, c, s, center[k], extent[k], cos[k], sin[k])
            total += _priced(depth - tuck[k], 20.0, slack)
    return total


@inner
def _sweeps(at, size, c, s, far, others, zones, walls, corners, slack):  # of sweeping others and being swept
    center, extent, g_center, g_extent, cos, sin, soft, seated, _ = others
    total, opens = 0.0, far > 1e-6
    ahead, wide = at.copy(), size.copy()
    if opens:
        ahead[0] += c * far / 2
        ahead[1] += s * far / 2
        wide[0] += far
        total += _priced(_beyond(ahead, wide, c, s, walls, corners), 12.0, slack)
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


@compiled(
    f"{A}({BOXES},{A},{A},{B},{B},{B},{B},{A},{C},{C},{A},{BOXES},{C},{B},{B},{B},{A},boolean,{BOXES},float64,float64)"
)
def prices(center, size, yaw, reach, way, o_center, o_size, g_center, g_size, o_yaw, soft, seated, tuck, z_center,
           z_size, z_yaw, window, start, along, normal, length, convex, r_center, r_size, r_yaw, slack, broken):
    """Price of each place (n,): `way` there, and what of `costs.cost` it breaks.

    A place that is broken by the walls is not asked for bodies, nor one broken by these for sweeps, unless all are.
    `o_` are what stands, `g_` b′ of it, `z_` the zones of doors and windows, `r_` walls at corners that stand out.
    """
    others = (o_center, o_size, g_center, g_size, np.cos(o_yaw), np.sin(o_yaw), soft, seated, tuck)
    zones = (z_center, z_size, np.cos(z_yaw), np.sin(z_yaw), window)
    walls, corners = (start, along, normal, length, convex), (r_center, r_size, np.cos(r_yaw), np.sin(r_yaw))
    n = len(yaw)
    base, total, whole = np.empty(n), np.empty(n), n > 0
    for i in range(n):
        c, s = np.cos(yaw[i]), np.sin(yaw[i])
        past = _beyond(center[i], size[i], c, s, walls, corners)
        base[i] = way[i] + (40 + 100 * past if past > slack else 0.0)
        total[i] = base[i]
        if total[i] < broken:
            total[i] += _bodies(center[i], size[i], c, s, others, zones, slack)
        if total[i] < broken:
            total[i] += _sweeps(center[i], size[i], c, s, reach[i], others, zones, walls, corners, slack)
        whole &= total[i] >= broken
    if whole:
        for i in range(n):
            c, s = np.cos(yaw[i]), np.sin(yaw[i])
            total[i] = base[i] + _bodies(center[i], size[i], c, s, others, zones, slack)
            total[i] += _sweeps(center[i], size[i], c, s, reach[i], others, zones, walls, corners, slack)
    return total
