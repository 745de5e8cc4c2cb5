"""What surfaces send to the eye, where rays cross triangles that are known, and which pixel's light serves for a ray
beside it, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Doubles = NDArray[np.float64]
Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]
Cells = NDArray[np.int16]


@compiled("Tuple((float32[:],float32[:,:]))(float32[:],float32[:,:],int64[:],boolean[:],float32[:,:,:])")
def crossed(origin: Floats, direction: Floats, triangle: Ints, known: Flags, corners: Floats) -> tuple[Floats, Floats]:
    """Where rays (n, 3) from a point cross the planes of triangles that they are `known` to meet: distance (n,) and
    weights of the corners (n, 3).
    """
    n = len(triangle)
    distance, weights = np.empty(n, np.float32), np.empty((n, 3), np.float32)
    a, b, s, p, q = np.empty(3), np.empty(3), np.empty(3), np.empty(3), np.empty(3)
    for i in range(n):
        if not known[i]:
            continue
        t = triangle[i]
        for k in range(3):
            a[k] = corners[t, 1, k] - corners[t, 0, k]
            b[k] = corners[t, 2, k] - corners[t, 0, k]
            s[k] = origin[k] - corners[t, 0, k]
        for k in range(3):
            x, y = (k + 1) % 3, (k + 2) % 3
            p[k] = direction[i, x] * b[y] - direction[i, y] * b[x]
            q[k] = s[x] * a[y] - s[y] * a[x]
        whole = a[0] * p[0] + a[1] * p[1] + a[2] * p[2]
        u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / whole
        v = (direction[i, 0] * q[0] + direction[i, 1] * q[1] + direction[i, 2] * q[2]) / whole
        distance[i] = (b[0] * q[0] + b[1] * q[1] + b[2] * q[2]) / whole
        weights[i, 0], weights[i, 1], weights[i, 2] = 1.0 - u - v, u, v
    return distance, weights


@compiled("boolean[:](int64[:,:])")
def amid(triangle: Ints) -> Flags:
    """Pixels (rows × columns,) all of whose neighbours, too, are of one triangle."""
    rows, columns = triangle.shape
    found = np.zeros(rows * columns, np.bool_)
    for i in range(1, rows - 1):
        for j in range(1, columns - 1):
            here, same = triangle[i, j], triangle[i, j] >= 0
            for y in range(i - 1, i + 2):
                for x in range(j - 1, j + 2):
                    same = same and triangle[y, x] == here
            found[i * columns + j] = same
    return found


@compiled("float32[:](float32[:,:],float32[:,:],int64[:],int64[:],float32[:,:],float32)")
def mirroring(
    direction: Floats, normal: Floats, triangle: Ints, material: Ints, looks: Floats, glossy: float
) -> Floats:
    """Share of light (n,) that surfaces mirror to the eye; `looks` are metalness and roughness of materials (k, 2)."""
    found = np.zeros(len(triangle), np.float32)
    for i in range(len(triangle)):
        if triangle[i] < 0:
            continue
        metal, rough = looks[material[triangle[i]]]
        dull = np.float32(1.0) - rough / (glossy + np.float32(0.5) * metal)
        if dull <= 0:
            continue
        facing = np.float32(0.0)
        for k in range(3):
            facing -= direction[i, k] * normal[i, k]
        off = np.float32(1.0) - min(max(facing, np.float32(0.0)), np.float32(1.0))
        least = np.float32(0.04) + np.float32(0.86) * metal
        found[i] = (least + (np.float32(1.0) - least) * off * off * off * off * off) * dull * np.sqrt(dull)
    return found


@compiled("float32[:,:](float32[:,:],float32[:,:],float32[:,:],int64[:],float32[:],int64[:],int64[:],float32[:,:],"
          "boolean[:],float32[:])")
def sent(
    color: Floats, full: Floats, around: Floats, like: Ints, share: Floats, triangle: Ints, material: Ints,
    looks: Floats, glow: Flags, shine: Floats
) -> Floats:
    """Light (n, 3) that surfaces send to the eye: of what falls on them, `full`, of what they mirror, `around`, those
    of each being at `like`, and their own.
    """
    found = np.empty((len(triangle), 3), np.float32)
    for i in range(len(triangle)):
        t, at = triangle[i], like[i]
        metal = looks[material[t], 0] if t >= 0 else np.float32(0.0)
        back = np.float32(1.0) - np.float32(0.85) * metal
        for k in range(3):
            found[i, k] = color[i, k] * full[at, k] * back
            if share[i] > np.float32(0.02):
                found[i, k] += around[at, k] * share[i] * (color[i, k] if metal > 0.5 else np.float32(1.0))
            if t >= 0 and glow[t]:
                found[i, k] += color[i, k] * shine[k]
    return found


@compiled("int64[:](int64[:],int64[:],float32[:,:],float32[:,:],int64[:,:],float32[:,:,:],float32[:,:,:],int64[:],"
          "float32)")
def served(
    pixel: Ints, triangle: Ints, point: Floats, normal: Floats, triangles: Ints, points: Floats,
    normals: Floats, owner: Ints, raised: float
) -> Ints:
    """For rays (n,) through pixels the one of the nine about each whose middle (r, c, …) lies on the same surface, or
    -1: on the same triangle, or on the same body, as level and turned alike.
    """
    rows, columns = triangles.shape
    found = np.full(len(pixel), -1, np.int64)
    for n in range(len(pixel)):
        t = triangle[n]
        i, j = pixel[n] // columns, pixel[n] % columns
        if t < 0 or triangles[i, j] == t:
            found[n] = pixel[n]
            continue
        best = np.float32(0.97)
        for y in range(max(0, i - 1), min(rows, i + 2)):
            for x in range(max(0, j - 1), min(columns, j + 2)):
                other = triangles[y, x]
                if other < 0 or owner[other] != owner[t]:
                    continue
                turn, off = np.float32(0.0), np.float32(0.0)
                for k in range(3):
                    turn += normal[n, k] * normals[y, x, k]
                    off += (points[y, x, k] - point[n, k]) * normal[n, k]
                if turn > best and abs(off) < raised:
                    found[n], best = y * columns + x, turn
    return found


@compiled("float32[:](float32[:,:],float32[:,:],float32[:],int16[:,:],float64[:],boolean[:],float32[:,:])")
def sunward(
    point: Floats, normal: Floats, sun: Floats, rooms: Cells, raster: Doubles, open_air: Flags, ways: Floats
) -> Floats:
    """How squarely the sun can fall on points (n, 3), (n,): zero where they face away from it, or lie in a room and
    see it through none of the `ways` out of doors (k, 6): corner, horizontal side, least and greatest height. `rooms`
    holds the index of the room in each cell, -1 for none; `raster` its corner and the side of cells.
    """
    found = np.zeros(len(point), np.float32)
    for i in range(len(point)):
        fall = normal[i, 0] * sun[0] + normal[i, 1] * sun[1] + normal[i, 2] * sun[2]
        if fall <= 0:
            continue
        row = min(max(int((point[i, 1] - raster[1]) / raster[2]), 0), rooms.shape[0] - 1)
        column = min(max(int((point[i, 0] - raster[0]) / raster[2]), 0), rooms.shape[1] - 1)
        room = rooms[row, column]
        dark = room >= 0 and not open_air[room]
        for w in range(len(ways) if dark else 0):
            turn = sun[0] * ways[w, 3] - sun[1] * ways[w, 2]
            if turn == 0:
                continue
            x, y = ways[w, 0] - point[i, 0], ways[w, 1] - point[i, 1]
            far, along = (x * ways[w, 3] - y * ways[w, 2]) / turn, (x * sun[1] - y * sun[0]) / turn
            height = point[i, 2] + far * sun[2]
            if far > -0.5 and 0 <= along <= 1 and ways[w, 4] <= height <= ways[w, 5]:
                dark = False
                break
        if not dark:
            found[i] = fall
    return found
