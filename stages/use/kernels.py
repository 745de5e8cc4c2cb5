"""How much of a rectangle of floor is free, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
ACROSS = 6
"""Points a side at which a rectangle is looked at."""


@compiled("boolean(float64,float64,float64[:,:],float64[:,:])")
def within(x: float, y: float, start: Floats, end: Floats) -> bool:
    """Whether a point lies in the polygon of sides (w, 2) to (w, 2); even-odd."""
    inside = False
    for k in range(len(start)):
        if (start[k, 1] > y) != (end[k, 1] > y):
            share = (y - start[k, 1]) / (end[k, 1] - start[k, 1])
            if x < start[k, 0] + share * (end[k, 0] - start[k, 0]):
                inside = not inside
    return inside


@compiled("float64(float64[:],float64[:],float64[:,:],float64[:,:],float64[:,:],boolean[:])")
def free(frame: Floats, zone: Floats, start: Floats, end: Floats, things: Floats, counts: Flags) -> float:
    """Share of a rectangle that lies in the room and in none of the things that count.

    `frame` (x, y, cos, sin) · `zone` (least and most ahead, least and most to the left) in it · things (n, 6) rows of
    x, y, cos, sin, half depth, half width.
    """
    x, y, c, s = frame
    empty = 0
    near = np.zeros(len(things), np.bool_)
    ahead, left = (zone[0] + zone[1]) / 2, (zone[2] + zone[3]) / 2
    middle_x, middle_y = x + ahead * c - left * s, y + ahead * s + left * c
    reach = np.hypot(zone[1] - zone[0], zone[3] - zone[2]) / 2
    for j in range(len(things)):
        far = reach + np.hypot(things[j, 4], things[j, 5])
        near[j] = counts[j] and np.hypot(things[j, 0] - middle_x, things[j, 1] - middle_y) < far
    for i in range(ACROSS):
        a = zone[0] + (i + 0.5) / ACROSS * (zone[1] - zone[0])
        for k in range(ACROSS):
            b = zone[2] + (k + 0.5) / ACROSS * (zone[3] - zone[2])
            px, py = x + a * c - b * s, y + a * s + b * c
            taken = not within(px, py, start, end)
            for j in range(len(things)):
                if near[j] and not taken:
                    u, v = px - things[j, 0], py - things[j, 1]
                    taken = (abs(u * things[j, 2] + v * things[j, 3]) < things[j, 4]
                             and abs(v * things[j, 2] - u * things[j, 3]) < things[j, 5])
            empty += not taken
    return empty / (ACROSS * ACROSS)
