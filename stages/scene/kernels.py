"""Colours of surfaces, edges between them, and light of few pixels spread over all, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]
Shorts = NDArray[np.uint16]

_LIKE = 12.0  # how much less a neighbour counts that is turned another way
_FEW = 0.15  # weight of the nearest four below which more are asked
_OFF = 0.04  # share of the distance from the eye by which a neighbour may be off the surface


@compiled("float32(float32[:],float32[:],float32[:],float32[:],float32)")
def _alike(point: Floats, normal: Floats, other: Floats, turned: Floats, level: np.float32) -> np.float32:
    """How far two points with normals are of one surface, in (0, 1], `level` being what a metre off it counts."""
    turn, off = np.float32(0.0), np.float32(0.0)
    for k in range(3):
        turn += (normal[k] - turned[k]) ** 2
        off += normal[k] * (other[k] - point[k])
    off *= level
    half = np.float32(0.5) * (np.float32(_LIKE) * turn + off * off)
    rise = half * (np.float32(1.0) + half * (np.float32(0.5) + half / np.float32(6.0)))
    fall = np.float32(1.0) / (np.float32(1.0) + rise)
    return fall * fall + np.float32(1e-6)  # as exp(-2 half), but with few steps


@compiled("float32[:,:,:](float32[:,:,:],float32[:,:,:],float32[:,:,:],float32[:,:],int64)")
def smoothed(light: Floats, point: Floats, normal: Floats, distance: Floats, reach: int) -> Floats:
    """Light (r, c, 3) averaged over neighbours up to `reach` away that lie on the same surface."""
    rows, columns = distance.shape
    found = np.empty_like(light)
    for i in range(rows):
        for j in range(columns):
            total = np.zeros(3, np.float32)
            weight = np.float32(0.0)
            level = np.float32(1.0) / (np.float32(_OFF) * distance[i, j] + np.float32(0.01))
            for y in range(max(0, i - reach), min(rows, i + reach + 1)):
                for x in range(max(0, j - reach), min(columns, j + reach + 1)):
                    w = _alike(point[i, j], normal[i, j], point[y, x], normal[y, x], level)
                    weight += w
                    for k in range(3):
                        total[k] += w * light[y, x, k]
            for k in range(3):
                found[i, j, k] = total[k] / weight
    return found


@compiled("Tuple((float32[:,:],float32[:]))(float32[:,:,:],float32[:,:,:],float32[:,:,:],int64,int64,int64[:],int64,"
          "float32[:,:],float32[:,:],float32[:])")
def spread(
    light: Floats, point: Floats, normal: Floats, step: int, start: int, pixels: Ints, across: int,
    points: Floats, normals: Floats, distance: Floats
) -> tuple[Floats, Floats]:
    """Light (n, 3) at pixels of a picture `across` wide, from that of every `step`-th pixel that lies on the same
    surface; and how far any did (n,).
    """
    rows, columns = light.shape[:2]
    found, alike = np.empty((len(pixels), 3), np.float32), np.empty(len(pixels), np.float32)
    one, least = np.float32(1.0), np.float32(0.02)
    for n in range(len(pixels)):
        row = pixels[n] // across
        y, x = np.float32(row - start) / step, np.float32(pixels[n] - row * across - start) / step
        i, j = min(max(int(np.floor(y)), 0), rows - 2), min(max(int(np.floor(x)), 0), columns - 2)
        level = one / (np.float32(_OFF) * min(distance[n], np.float32(100.0)) + np.float32(0.01))
        red, green, blue, weight = np.float32(0.0), np.float32(0.0), np.float32(0.0), np.float32(0.0)
        for wide in range(2):
            if weight > _FEW:
                break
            for a in range(max(0, i - wide), min(rows, i + 2 + wide)):
                for b in range(max(0, j - wide), min(columns, j + 2 + wide)):
                    near = max(least, one - np.float32(abs(a - y))) * max(least, one - np.float32(abs(b - x)))
                    w = near * _alike(points[n], normals[n], point[a, b], normal[a, b], level)
                    weight += w
                    red += w * light[a, b, 0]
                    green += w * light[a, b, 1]
                    blue += w * light[a, b, 2]
        found[n, 0], found[n, 1], found[n, 2] = red / weight, green / weight, blue / weight
        alike[n] = weight
    return found, alike


@compiled("Tuple((float32[:,:],float32[:,:]))(int64[:],float32[:,:],float32[:],float32,float32[:,:,:],float32[:,:,:],"
          "int64[:],float32[:,:],int64[:,:],uint16[:,:],float32[:])")
def painted(
    triangle: Ints, weights: Floats, distance: Floats, angle: float, normals: Floats, uv: Floats,
    material: Ints, flat: Floats, textures: Ints, texels: Shorts, repeats: Floats
) -> tuple[Floats, Floats]:
    """Linear colours and unit normals (n, 3) where rays hit, zeros where they did not (-1).

    `textures` (k, 2) says for each material where its texels begin and how wide the finest level is, 0 without one;
    coarser levels follow. A ray stands for `angle`, rad; `repeats` are those of the texture along a metre.
    """
    n = len(triangle)
    color, normal = np.empty((n, 3), np.float32), np.empty((n, 3), np.float32)
    for i in range(n):
        t = triangle[i]
        if t < 0:
            color[i] = normal[i] = 0.0
            continue
        a, b, c = weights[i]
        square = np.float32(0.0)
        for k in range(3):
            normal[i, k] = a * normals[t, 0, k] + b * normals[t, 1, k] + c * normals[t, 2, k]
            square += normal[i, k] * normal[i, k]
        length = max(np.float32(np.sqrt(square)), np.float32(1e-9))
        for k in range(3):
            normal[i, k] /= length
        m = material[t]
        start, size = textures[m]
        if size == 0:
            for k in range(3):
                color[i, k] = flat[m, k]
            continue
        wide = distance[i] * angle * repeats[t] * size
        while wide > np.float32(1.4142135) and size > 1 and size % 2 == 0:
            start += size * size
            size //= 2
            wide *= np.float32(0.5)
        x = a * uv[t, 0, 0] + b * uv[t, 1, 0] + c * uv[t, 2, 0]
        y = np.float32(1.0) - (a * uv[t, 0, 1] + b * uv[t, 1, 1] + c * uv[t, 2, 1])
        column = min(max(int((x - np.floor(x)) * size), 0), size - 1)
        row = min(max(int((y - np.floor(y)) * size), 0), size - 1)
        at = start + row * size + column
        for k in range(3):
            color[i, k] = texels[at, k] / np.float32(65535.0)
    return color, normal


@compiled("float32[:,:](float32[:,:],float32[:,:],float32[:,:])")
def scattered(normal: Floats, noise: Floats, shifts: Floats) -> Floats:
    """Directions (k × n, 3) about normals (n, 3), as likely as their cosine, from numbers (n, 2) in [0, 1) shifted by
    each of some (k, 2).
    """
    n = len(normal)
    found = np.empty((len(shifts) * n, 3), np.float32)
    for s in range(len(shifts)):
        for i in range(n):
            a, b = noise[i, 0] + shifts[s, 0], noise[i, 1] + shifts[s, 1]
            up = np.float32(1.0) - np.float32(2.0) * (a - np.floor(a))
            turn = np.float32(2.0 * np.pi) * b
            ring = np.sqrt(max(np.float32(1.0) - up * up, np.float32(0.0)))
            x, y, z = normal[i, 0] + ring * np.cos(turn), normal[i, 1] + ring * np.sin(turn), normal[i, 2] + up
            length = np.float32(1.0) / max(np.sqrt(x * x + y * y + z * z), np.float32(1e-9))
            at = s * n + i
            found[at, 0], found[at, 1], found[at, 2] = x * length, y * length, z * length
    return found


@compiled("void(float32[:,:],float32[:,:],int64[:],float32[:],float32[:,:],float32[:,:],float32,float32,float32[:,:],"
          "float32[:,:],float32[:,:])")
def bounced(
    start: Floats, way: Floats, triangle: Ints, distance: Floats, faces: Floats, colors: Floats, nearby: np.float32,
    lift: np.float32, share: Floats, place: Floats, facing: Floats
) -> None:
    """What rays (k × n, 3), k from each of some points (n, 3), meet: adds the share of light that comes back to
    `share` (n, 3), and writes where that is, and which way it faces (k × n, 3). `faces` and `colors` are of triangles.
    """
    n = len(start)
    for i in range(len(way)):
        t, p = triangle[i], i % n
        if t < 0:
            place[i] = facing[i] = 0.0
            continue
        far = distance[i]
        along = np.float32(0.0)
        for k in range(3):
            share[p, k] += colors[t, k] * far / (far + nearby)
            along += faces[t, k] * way[i, k]
        side = np.float32(-1.0) if along > 0 else np.float32(1.0)
        for k in range(3):
            facing[i, k] = side * faces[t, k]
            place[i, k] = start[p, k] + way[i, k] * far + facing[i, k] * lift


@compiled("boolean[:,:](int64[:,:],float32[:,:,:],float32[:,:,:],float32[:,:,:],float32[:,:,:],float32,float32)")
def edges(
    owner: Ints, point: Floats, normal: Floats, color: Floats, through: Floats, most: float, raised: float
) -> Flags:
    """Pixels (r, c) beside one of another owner, of a direction and colour that differ by more than `most`, or of a
    surface `raised` over their own.
    """
    rows, columns = owner.shape
    found = np.zeros((rows, columns), np.bool_)
    for i in range(rows):
        for j in range(columns):
            for down in range(2):
                y, x = i + down, j + 1 - down
                if y == rows or x == columns:
                    continue
                step, off = np.float32(0.0), np.float32(0.0)
                for k in range(3):
                    step += abs(normal[y, x, k] - normal[i, j, k])
                    step += np.float32(2.0) * abs(color[y, x, k] - color[i, j, k])
                    step += np.float32(2.0) * abs(through[y, x, k] - through[i, j, k])
                    off += (point[y, x, k] - point[i, j, k]) * normal[i, j, k]
                if owner[y, x] != owner[i, j] or step > most or abs(off) > raised:
                    found[i, j] = found[y, x] = True
    return found


@compiled("boolean[:,:](boolean[:,:],int64)")
def widened(found: Flags, by: int) -> Flags:
    """What is found (r, c), and what is up to so many pixels above, below, left or right of it."""
    rows, columns = found.shape
    wide = np.zeros((rows, columns), np.bool_)
    for i in range(rows):
        for j in range(columns):
            if found[i, j]:
                wide[max(0, i - by):i + by + 1, j] = True
                wide[i, max(0, j - by):j + by + 1] = True
    return wide


@compiled("int64[:,:](uint16[:,:])")
def extents(number: Shorts) -> Ints:
    """Of each number in a picture (r, c): how many pixels it has, its first column and row, its last ones, its pixel
    that is farthest from all of other numbers and from the outside, and how many steps that is, also aslant (k, 8).
    """
    rows, columns = number.shape
    steps = np.ones((rows, columns), np.int64)
    for i in range(1, rows - 1):
        for j in range(1, columns - 1):
            here, same = number[i, j], True
            for y in range(i - 1, i + 2):
                for x in range(j - 1, j + 2):
                    same = same and number[y, x] == here
            if same:
                steps[i, j] = 1 + min(min(steps[i, j - 1], steps[i - 1, j - 1]),
                                      min(steps[i - 1, j], steps[i - 1, j + 1]))
    for i in range(rows - 2, 0, -1):
        for j in range(columns - 2, 0, -1):
            if steps[i, j] > 1:
                steps[i, j] = min(steps[i, j], 1 + min(min(steps[i, j + 1], steps[i + 1, j - 1]),
                                                       min(steps[i + 1, j], steps[i + 1, j + 1])))
    found = np.zeros((number.max() + 1, 8), np.int64)
    for i in range(rows):
        for j in range(columns):
            one = found[number[i, j]]
            if one[0] == 0:
                one[1], one[2], one[3] = j, i, j
            one[0] += 1
            one[1], one[3], one[4] = min(one[1], j), max(one[3], j), i
            if steps[i, j] > one[7]:
                one[5], one[6], one[7] = j, i, steps[i, j]
    return found
