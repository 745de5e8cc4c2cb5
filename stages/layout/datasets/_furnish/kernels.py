"""What is asked thousands of times while a room is furnished, compiled.

Boxes are rows [x, y, z, depth, width, height, cos yaw, sin yaw] about their centres. Of the project only what
compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled, inner

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Numbers = NDArray[np.int32]


@inner
def _meets(a: Floats, b: Floats, touch: float) -> bool:
    # deeper in one another than `touch`: separating axes of both, and height
    if (a[5] + b[5]) / 2 - abs(a[2] - b[2]) <= touch:
        return False
    x, y = b[0] - a[0], b[1] - a[1]
    cosine, sine = abs(a[6] * b[6] + a[7] * b[7]), abs(a[7] * b[6] - a[6] * b[7])
    ax, ay, bx, by = a[3] / 2, a[4] / 2, b[3] / 2, b[4] / 2
    if ax + bx * cosine + by * sine - abs(x * a[6] + y * a[7]) <= touch:
        return False
    if ay + bx * sine + by * cosine - abs(y * a[6] - x * a[7]) <= touch:
        return False
    if bx + ax * cosine + ay * sine - abs(x * b[6] + y * b[7]) <= touch:
        return False
    return bool(by + ax * sine + ay * cosine - abs(y * b[6] - x * b[7]) > touch)


@compiled("boolean[:](float64[:,:,::1],float64[:,::1],boolean[:,::1],float64)")
def clash(some: Floats, others: Floats, forbidden: Flags, touch: float) -> Flags:
    """Which arrangements (m,) of boxes (m, p, 8) meet one of the others (q, 8) where `forbidden` (p, q) says so."""
    m, p, _ = some.shape
    out = np.zeros(m, np.bool_)
    for k in range(m):
        for i in range(p):
            for j in range(len(others)):
                if forbidden[i, j] and _meets(some[k, i], others[j], touch):
                    out[k] = True
                    break
            if out[k]:
                break
    return out


@inner
def _within(x: float, y: float, start: Floats) -> bool:  # even-odd
    inside, n = False, len(start)
    for k in range(n):
        x0, y0, x1, y1 = start[k, 0], start[k, 1], start[(k + 1) % n, 0], start[(k + 1) % n, 1]
        if (y0 > y) != (y1 > y) and x < (x1 - x0) * (y - y0) / (y1 - y0) + x0:
            inside = not inside
    return inside


@inner
def _crossed(a: Floats, x0: float, y0: float, x1: float, y1: float, slack: float) -> bool:
    # whether a segment passes through the footprint shrunk by `slack`
    hx, hy = max(a[3] / 2 - slack, 1e-4), max(a[4] / 2 - slack, 1e-4)
    ux, uy = (x0 - a[0]) * a[6] + (y0 - a[1]) * a[7], (y0 - a[1]) * a[6] - (x0 - a[0]) * a[7]
    vx, vy = (x1 - a[0]) * a[6] + (y1 - a[1]) * a[7], (y1 - a[1]) * a[6] - (x1 - a[0]) * a[7]
    if max(ux, vx) < -hx or min(ux, vx) > hx or max(uy, vy) < -hy or min(uy, vy) > hy:
        return False
    dx, dy = vx - ux, vy - uy
    return bool(abs(dx * uy - dy * ux) <= hx * abs(dy) + hy * abs(dx))


@compiled("boolean[:](float64[:,:,::1],boolean[::1],float64[:,::1],float64)")
def leaves(some: Floats, asked: Flags, start: Floats, slack: float) -> Flags:
    """Which arrangements (m,) of boxes (m, p, 8) reach beyond the room's corners (e, 2) by more than `slack`."""
    m, p, _ = some.shape
    n, out = len(start), np.zeros(m, np.bool_)
    for k in range(m):
        for i in range(p):
            if not asked[i]:
                continue
            a = some[k, i]
            bad = not _within(a[0], a[1], start)
            for e in range(n):
                if bad:
                    break
                f = (e + 1) % n
                bad = _crossed(a, start[e, 0], start[e, 1], start[f, 0], start[f, 1], slack)
            if bad:
                out[k] = True
                break
    return out


@compiled("float64[:](float64[:,::1],float64[:,::1],float64[:,::1])")
def ahead(points: Floats, heading: Floats, start: Floats) -> Floats:
    """How far from each point (m, 2) along its heading (m, 2) the first side of the room lies."""
    m, n = len(points), len(start)
    out = np.full(m, np.inf)
    for k in range(m):
        hx, hy = heading[k, 0], heading[k, 1]
        for e in range(n):
            f = (e + 1) % n
            ax, ay = start[e, 0] - points[k, 0], start[e, 1] - points[k, 1]
            bx, by = start[f, 0] - points[k, 0], start[f, 1] - points[k, 1]
            u, v = hx * ay - hy * ax, hx * by - hy * bx
            if (u > 0) == (v > 0) or abs(u - v) < 1e-12:
                continue
            t = u / (u - v)
            far = hx * (ax + t * (bx - ax)) + hy * (ay + t * (by - ay))
            if far > 1e-6 and far < out[k]:
                out[k] = far
    return out


@compiled("float64[:,::1](float64[:,:,::1],float64[:,::1])")
def walls_away(grid: Floats, start: Floats) -> Floats:
    """Distance of grid points (r, c, 2) to the nearest side of the room, negative outside."""
    r, c, _ = grid.shape
    n, out = len(start), np.empty((r, c))
    for i in range(r):
        for j in range(c):
            x, y, best = grid[i, j, 0], grid[i, j, 1], 1e18
            for e in range(n):
                f = (e + 1) % n
                dx, dy = start[f, 0] - start[e, 0], start[f, 1] - start[e, 1]
                u, v = x - start[e, 0], y - start[e, 1]
                t = min(max((u * dx + v * dy) / (dx * dx + dy * dy), 0.0), 1.0)
                best = min(best, np.hypot(u - t * dx, v - t * dy))
            out[i, j] = best if _within(x, y, start) else -1.0
    return out


@compiled("float64[:,::1](float64[:,:,::1],float64[:,::1],float64)")
def away(grid: Floats, some: Floats, most: float) -> Floats:
    """Distance of grid points (r, c, 2) to the nearest of the footprints (q, 8), `most` where it is more."""
    r, c, _ = grid.shape
    out = np.full((r, c), most)
    for q in range(len(some)):
        a = some[q]
        span = np.hypot(a[3], a[4]) / 2 + most
        for i in range(r):
            if abs(grid[i, 0, 0] - a[0]) > span:
                continue
            for j in range(c):
                x, y = grid[i, j, 0] - a[0], grid[i, j, 1] - a[1]
                if abs(y) > span:
                    continue
                u = max(abs(x * a[6] + y * a[7]) - a[3] / 2, 0.0)
                v = max(abs(y * a[6] - x * a[7]) - a[4] / 2, 0.0)
                out[i, j] = min(out[i, j], np.hypot(u, v))
    return out


@compiled("int32[:,::1](boolean[:,::1])")
def parts(free: Flags) -> Numbers:
    """Numbers from 1 of the parts that hang together by edges; 0 where not free."""
    r, c = free.shape
    out, stack, count = np.zeros((r, c), np.int32), np.empty(r * c, np.int64), 0
    for i in range(r):
        for j in range(c):
            if not free[i, j] or out[i, j]:
                continue
            count += 1
            out[i, j], stack[0], n = count, i * c + j, 1
            while n:
                n -= 1
                u, v = stack[n] // c, stack[n] % c
                for k in range(4):
                    a, b = u + (k == 0) - (k == 1), v + (k == 2) - (k == 3)
                    if 0 <= a < r and 0 <= b < c and free[a, b] and not out[a, b]:
                        out[a, b], stack[n] = count, a * c + b
                        n += 1
    return out


@compiled("boolean[:](float64[:,:,::1],int32[:,::1],int64,float64[:,::1],float64[:,::1])")
def got_to(grid: Floats, part: Numbers, main: int, some: Floats, use: Floats) -> Flags:
    """Which boxes (q, 8) are got to from the part `main`.

    `use` (q, 4): how far open parts stand out in front (negative: it is used from any side), from how far in front of
    those it is used, how far to each side, and what is kept from open parts.
    """
    r, c, _ = grid.shape
    out = np.zeros(len(some), np.bool_)
    for q in range(len(some)):
        a, opened, arm, aside, keep = some[q], use[q, 0], use[q, 1], use[q, 2], use[q, 3]
        for i in range(r):
            for j in range(c):
                if part[i, j] != main:
                    continue
                x, y = grid[i, j, 0] - a[0], grid[i, j, 1] - a[1]
                u, v = x * a[6] + y * a[7] - a[3] / 2, abs(y * a[6] - x * a[7]) - a[4] / 2
                if opened < 0:
                    near = np.hypot(max(abs(u + a[3] / 2) - a[3] / 2, 0.0), max(v, 0.0)) < arm
                else:
                    near = 0 < u <= opened + arm and v < aside and (u > opened + keep or v > keep)
                if near:
                    out[q] = True
                    break
            if out[q]:
                break
    return out
