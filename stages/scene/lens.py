"""What lies between pixels and surfaces: rays of a pinhole, panes on their way, where they end, what labels say of
that, and how light becomes a picture, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Doubles = NDArray[np.float64]
Ints = NDArray[np.int64]
Shorts = NDArray[np.uint16]
Bytes = NDArray[np.uint8]

_KNEE = np.float32(0.75)  # above it highlights are rolled off


@compiled("float32[:,:](int64[:],int64,int64,float64[:],float64[:],float64[:],float64[:,:])")
def pinhole(
    pixels: Ints, rows: int, columns: int, within: Doubles, half: Doubles, middle: Doubles, frame: Doubles
) -> Floats:
    """Unit directions (n, 3) through a point of each pixel; rows of `frame` are right, up, back."""
    found = np.empty((len(pixels), 3), np.float32)
    wide, high = 2.0 * half[0] / columns, 2.0 * half[1] / rows
    left, top = middle[0] - half[0] + within[0] * wide, middle[1] + half[1] - within[1] * high
    for n in range(len(pixels)):
        i = pixels[n] // columns
        x, y = left + (pixels[n] - i * columns) * wide, top - i * high
        length = 1.0 / np.sqrt(x * x + y * y + 1.0)
        for k in range(3):
            found[n, k] = (x * frame[0, k] + y * frame[1, k] - frame[2, k]) * length
    return found


@compiled("float32[:,:](float32[:,:],float32[:,:],float32[:],float32[:,:])")
def ended(origin: Floats, direction: Floats, distance: Floats, normal: Floats) -> Floats:
    """Points (n, 3) at the ends of rays that begin in one place (1, 3) or each in its own, 100 m away where they meet
    nothing; turns normals (n, 3) in place against the rays, and makes them the way back where there are none.
    """
    found = np.empty((len(direction), 3), np.float32)
    step = 1 if len(origin) > 1 else 0
    for i in range(len(direction)):
        far = distance[i] if np.isfinite(distance[i]) else np.float32(100.0)
        along, square = np.float32(0.0), np.float32(0.0)
        for k in range(3):
            found[i, k] = origin[i * step, k] + direction[i, k] * far
            along += normal[i, k] * direction[i, k]
            square += normal[i, k] * normal[i, k]
        for k in range(3):
            if square == 0:
                normal[i, k] = -direction[i, k]
            elif along > 0:
                normal[i, k] = -normal[i, k]
    return found


@compiled("Tuple((float32[:,:],float32[:,:]))(int64[:],int64[:],float32[:],float32[:,:],float32[:,:],float32[:],int64[:],"
          "float32[:,:],float32,float32,float32,float32[:,:],float32[:,:])")
def passed(
    rows: Ints, triangle: Ints, distance: Floats, origin: Floats, direction: Floats, alpha: Floats,
    material: Ints, flat: Floats, past: np.float32, clear: np.float32, pale: np.float32, through: Floats, veil: Floats
) -> tuple[Floats, Floats]:
    """Where some of the rays (n, 3) go on, `past` the panes that they met, and which way; what the panes let `through`
    and the `veil` that they lay over it change in place: `clear` is the share of their opacity that they have, `pale`
    how bright they are.
    """
    start, way = np.empty((len(rows), 3), np.float32), np.empty((len(rows), 3), np.float32)
    step = 1 if len(origin) > 1 else 0
    for r in range(len(rows)):
        i = rows[r]
        opaque, far = alpha[triangle[i]] * clear, distance[i] + past
        for k in range(3):
            veil[i, k] += through[i, k] * opaque * flat[material[triangle[i]], k] * pale
            through[i, k] *= np.float32(1.0) - opaque
            way[r, k] = direction[i, k]
            start[r, k] = origin[i * step, k] + direction[i, k] * far
    return start, way


@compiled("int64[:](int64[:],int64[:],float32[:],float32[:,:],float32[:],float32,int64[:],float32[:],float32[:,:])")
def arrived(
    rows: Ints, met: Ints, far: Floats, corners: Floats, alpha: Floats, past: np.float32, triangle: Ints,
    distance: Floats, weights: Floats
) -> Ints:
    """Writes what those rays met behind their panes in place of these, and gives the ones that met a pane again."""
    found, count = np.empty(len(rows), np.int64), 0
    for r in range(len(rows)):
        i = rows[r]
        distance[i] = far[r] + (distance[i] + past)
        triangle[i] = met[r]
        for k in range(3):
            weights[i, k] = corners[r, k]
        if alpha[met[r]] < 1:
            found[count] = i
            count += 1
    return found[:count]


@compiled("Tuple((uint16[:],uint8[:,:],uint16[:]))(int64[:],float32[:],float32[:,:],float64[:],float32[:,:],int64[:],"
          "float64)")
def noted(
    triangle: Ints, distance: Floats, direction: Floats, ahead: Doubles, faces: Floats, owner: Ints,
    farthest: float
) -> tuple[Shorts, Bytes, Shorts]:
    """Of what rays (n, 3) meet: depth in mm along the way `ahead`, along the ray where that is zero; the normal of the
    triangle's face towards the eye, as a colour; the number of its owner, from 1 on. 0 where there is nothing.
    """
    n = len(triangle)
    depth, number = np.zeros(n, np.uint16), np.zeros(n, np.uint16)
    normal = np.zeros((n, 3), np.uint8)
    along_rays = ahead[0] == 0 and ahead[1] == 0 and ahead[2] == 0
    for i in range(n):
        t = triangle[i]
        if t < 0:
            continue
        share, towards = 0.0, 0.0
        for k in range(3):
            share += direction[i, k] * ahead[k]
            towards += direction[i, k] * faces[t, k]
        side = -1.0 if towards > 0 else 1.0
        for k in range(3):
            normal[i, k] = np.uint8(np.rint((side * faces[t, k] + 1.0) * 127.5))
        far = distance[i] * (1.0 if along_rays else share) * 1000.0
        depth[i] = np.uint16(np.rint(min(max(far, 0.0), farthest)))
        number[i] = owner[t] + 1
    return depth, normal, number


@compiled("void(float32[:,:],float32,float32[:,:],float32[:,:])")
def developed(light: Floats, exposure: float, through: Floats, veil: Floats) -> None:
    """Light (n, 3), in place, as linear colours in [0, 1] behind their panes, highlights rolled off softly."""
    for i in range(len(light)):
        for k in range(3):
            here = light[i, k] * exposure
            if here > _KNEE:
                here = _KNEE + (np.float32(1.0) - _KNEE) * (
                    np.float32(1.0) - np.exp((_KNEE - here) / (np.float32(1.0) - _KNEE)))
            light[i, k] = min(max(here * through[i, k] + veil[i, k], np.float32(0.0)), np.float32(1.0))
