"""Tokens in the frames of others, and what continues a run, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Doubles = NDArray[np.float64]
Ints = NDArray[np.int64]


@compiled("float32[:,::1](float32[:,::1],float32[:,::1],int64[::1])")
def seen(boxes: Floats, viewers: Floats, owner: Ints) -> Floats:
    """Boxes (N, 7) in the frames of viewers (R, 7), of which each has an `owner` (N,), as `tokens.seen` has them."""
    found = np.empty((len(boxes), 9), np.float32)
    cosine, sine = np.cos(viewers[:, 2]), np.sin(viewers[:, 2])
    for i in range(len(boxes)):
        o = owner[i]
        x, y, c, s = boxes[i, 0] - viewers[o, 0], boxes[i, 1] - viewers[o, 1], cosine[o], sine[o]
        yaw, depth, width = boxes[i, 2] - viewers[o, 2], boxes[i, 3], boxes[i, 4]
        across, along = abs(np.cos(yaw)), abs(np.sin(yaw))
        found[i, 0], found[i, 1], found[i, 2] = x * c + y * s, y * c - x * s, yaw
        found[i, 3] = (depth * across + width * along) / np.float32(2)
        found[i, 4] = (depth * along + width * across) / np.float32(2)
        found[i, 5], found[i, 6], found[i, 7], found[i, 8] = boxes[i, 5], boxes[i, 6], depth, width
    return found


@compiled("boolean[::1](float32[:,::1],float32[:,::1],float64,float64,float64)")
def beside(boxes: Floats, units: Floats, flush: float, corner: float, in_line: float) -> NDArray[np.bool_]:
    """Which candidates (n, 7) are flush with one of some units (m, 7): side by side with backs in line, or round the
    corner from it."""
    found = np.zeros(len(boxes), np.bool_)
    half = np.float32(0.5)
    for k in range(len(units)):
        unit = units[k]
        c, s = np.cos(np.float64(unit[2])), np.sin(np.float64(unit[2]))
        for i in range(len(boxes)):
            if found[i]:
                continue
            box = boxes[i]
            dx, dy, turned = box[0] - unit[0], box[1] - unit[1], np.cos(box[2] - unit[2])
            x, y = dx * c + dy * s, abs(dy * c - dx * s)
            if turned > 0.99:
                backs = abs(x - box[3] * half + unit[3] * half) < in_line
                found[i] = backs and abs(y - (unit[4] + box[4]) * half) < flush
            elif abs(turned) < 0.01:
                behind = abs(x + unit[3] * half) < box[4] * half + corner
                aside = abs(y - (unit[4] + box[3]) * half) < 2 * flush
                ahead = abs(x - (unit[3] + box[4]) * half) < flush
                within = abs(y - (unit[4] - box[3]) * half) < corner
                found[i] = aside and behind or ahead and within
    return found


@compiled("float32[:,::1](float32[:,::1],float64[:,::1],float32[:,::1],float64,float64)")
def continued(units: Floats, sizes: Doubles, walls: Floats, between: float, off: float) -> Floats:
    """Places (n, 7) of things of some sizes (k, 4) to the left and to the right of units (m, 7), backs in line, and
    round a corner: with the back to a wall that meets the unit's at a right angle, beginning where its front is."""
    found = np.empty((len(sizes) * len(units) * (2 + len(walls)), 7), np.float32)
    n = 0
    for size in sizes:
        for unit in units:
            yaw, c, s = unit[2], np.cos(np.float64(unit[2])), np.sin(np.float64(unit[2]))
            x, y = (size[0] - unit[3]) / 2, (unit[4] + size[1]) / 2 + between
            for side in (y, -y):
                found[n, 0], found[n, 1], found[n, 2] = unit[0] + c * x - s * side, unit[1] + s * x + c * side, yaw
                for i in range(4):
                    found[n, 3 + i] = size[i]
                n += 1
            ahead = unit[0] * c + unit[1] * s + (unit[3] + size[1]) / 2 + between
            for wall in walls:
                a, b = np.cos(np.float64(wall[2])), np.sin(np.float64(wall[2]))
                if abs(a * c + b * s) > 0.01:
                    continue
                deep = wall[0] * a + wall[1] * b + size[0] / 2 + off
                found[n, 0], found[n, 1], found[n, 2] = ahead * c + deep * a, ahead * s + deep * b, wall[2]
                for i in range(4):
                    found[n, 3 + i] = size[i]
                n += 1
    return found[:n]
