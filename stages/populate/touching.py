"""Which boxes touch what stands in a room, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


@compiled("boolean(float64,float64,float64,float64[:],float64[:],float64[:])")
def parted(x: float, y: float, z: float, between: Floats, box: Floats, solid: Floats) -> bool:
    """Whether a direction separates a box from an upright solid that is so far `between` their middles (3,)."""
    length = np.sqrt(x * x + y * y + z * z)
    if length < 1e-6:
        return False
    reach = abs(z) * solid[5]
    if solid[8] > 0:
        reach += solid[3] * np.hypot(x, y)
    else:
        reach += solid[3] * abs(x * solid[6] + y * solid[7]) + solid[4] * abs(y * solid[6] - x * solid[7])
    for k in range(3):
        reach += box[12 + k] * abs(x * box[3 + 3 * k] + y * box[4 + 3 * k] + z * box[5 + 3 * k])
    return bool(abs(x * between[0] + y * between[1] + z * between[2]) >= reach)


@compiled("boolean(float64[:],float64[:],float64[:])")
def touches(between: Floats, box: Floats, solid: Floats) -> bool:
    """Whether a box and an upright solid overlap; of round ones, no more directions than needed are looked along.

    box (15,): middle, its three axes, half of its sides · solid (9,): middle, half of its sides, cos, sin, whether it
    is round.
    """
    if parted(0.0, 0.0, 1.0, between, box, solid):
        return False
    c, s = solid[6], solid[7]
    if solid[8] > 0:
        c, s = between[0], between[1]
    if parted(c, s, 0.0, between, box, solid) or (solid[8] == 0 and parted(-s, c, 0.0, between, box, solid)):
        return False
    for k in range(3):
        x, y, z = box[3 + 3 * k], box[4 + 3 * k], box[5 + 3 * k]
        if parted(x, y, z, between, box, solid) or parted(y, -x, 0.0, between, box, solid):
            return False
        if solid[8] == 0 and (parted(-s * z, c * z, s * x - c * y, between, box, solid)
                              or parted(c * z, s * z, -c * x - s * y, between, box, solid)):
            return False
    return True


@compiled("float64[:](float64[:,:],int64)")
def radii(rows: Floats, first: int) -> Floats:
    """Of the balls about solids (n,), half of whose sides are in three columns."""
    return np.sqrt(rows[:, first] ** 2 + rows[:, first + 1] ** 2 + rows[:, first + 2] ** 2)


@compiled("boolean[:](float64[:,:],float64[:,:])")
def hits(boxes: Floats, solids: Floats) -> Flags:
    """Which boxes (k, 15) overlap any of the solids (m, 9)."""
    found, between = np.zeros(len(boxes), np.bool_), np.empty(3)
    wide, far = radii(boxes, 12), radii(solids, 3)
    for i in range(len(boxes)):
        for j in range(len(solids)):
            for k in range(3):
                between[k] = solids[j, k] - boxes[i, k]
            apart = between[0] ** 2 + between[1] ** 2 + between[2] ** 2
            if apart < (wide[i] + far[j]) ** 2 and touches(between, boxes[i], solids[j]):
                found[i] = True
                break
    return found
