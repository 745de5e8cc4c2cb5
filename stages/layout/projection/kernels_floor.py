# mypy: disable-error-code="no-untyped-def,no-untyped-call"
"""What is cut off of a floor, compiled.

Nothing here is imported from the project: the cache of compiled code sees changes of this file alone.
"""

from typing import Any

import numpy as np
from numba import njit

# Not callable from Python: those wrappers cost as much to compile as the functions.
WITHIN: dict[str, Any] = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
inner = njit(**WITHIN)
A, B = "float64[:]", "float64[:,:]"
CELL = "int64[:]"


def compiled(signature: str) -> Any:
    """Compiled when first imported, and kept in numba's cache."""
    return njit(signature, cache=True, error_model="numpy")


@inner
def _window(box, reach, raster):  # rows and columns of the cells that may lie within reach of a footprint
    x0, y0, step, rows, columns = raster
    c, s = abs(np.cos(box[4])), abs(np.sin(box[4]))
    x, y = (c * box[2] + s * box[3]) / 2 + reach, (s * box[2] + c * box[3]) / 2 + reach
    left, below = int(np.floor((box[0] - x - x0) / step)), int(np.floor((box[1] - y - y0) / step))
    right, above = int(np.ceil((box[0] + x - x0) / step)) + 1, int(np.ceil((box[1] + y - y0) / step)) + 1
    return max(below, 0), min(max(above, 0), rows), max(left, 0), min(max(right, 0), columns)


@inner
def _close(box, c, s, row, column, radius, raster):  # whether a cell's centre is closer to a footprint than radius
    x, y = raster[0] + (column + 0.5) * raster[2] - box[0], raster[1] + (row + 0.5) * raster[2] - box[1]
    ahead = max(abs(x * c + y * s) - box[2] / 2, 0.0)
    aside = max(abs(y * c - x * s) - box[3] / 2, 0.0)
    return ahead * ahead + aside * aside < (radius - 1e-9) ** 2


@inner
def _shade(count, box, radius, by, raster):
    c, s = np.cos(box[4]), np.sin(box[4])
    below, above, left, right = _window(box, radius, raster)
    for row in range(below, above):
        for column in range(left, right):
            if _close(box, c, s, row, column, radius, raster):
                count[row, column] += by


@compiled(f"void(int16[:,:,:],{A},{A},int16,float64,float64,float64)")
def shade(count, box, radii, by, x0, y0, step):
    """Add `by` to the cells (radii, rows, columns) closer than each radius to a footprint [x, y, depth, width, yaw]."""
    raster = (x0, y0, step, count.shape[1], count.shape[2])
    for k in range(len(radii)):
        _shade(count[k], box, radii[k], by, raster)


@inner
def _root(parent, label):
    while parent[label] != label:
        label = parent[label]
    return label


@inner
def _label(free, labels, parent, sizes):  # by edges; then `parent` is the first label of each one's part
    rows, columns = free.shape
    n = 0
    for i in range(rows):
        for j in range(columns):
            labels[i, j] = 0
            if not free[i, j]:
                continue
            up = labels[i - 1, j] if i else 0
            left = labels[i, j - 1] if j else 0
            if up == 0 and left == 0:
                n += 1
                parent[n], sizes[n] = n, 0
                labels[i, j] = n
            elif up == 0 or left == 0 or up == left:
                labels[i, j] = max(up, left)
            else:
                a, b = _root(parent, up), _root(parent, left)
                parent[max(a, b)] = min(a, b)
                labels[i, j] = min(a, b)
            sizes[labels[i, j]] += 1
    for k in range(1, n + 1):
        parent[k] = _root(parent, parent[k])
        if parent[k] != k:
            sizes[parent[k]] += sizes[k]
            sizes[k] = 0
    return n


@inner
def _home(labels, parent, sizes, n, rows, columns):  # the part with most doors' floor, else the largest
    home = 0
    for k in range(len(rows)):
        part = parent[labels[rows[k], columns[k]]]
        if sizes[part] > sizes[home]:
            home = part
    if home == 0:
        for part in range(1, n + 1):
            if sizes[part] > sizes[home]:
                home = part
    return home


@inner
def _touched(box, labels, parent, home, radius, raster):  # whether any of a part lies about a footprint
    c, s = np.cos(box[4]), np.sin(box[4])
    below, above, left, right = _window(box, radius, raster)
    for row in range(below, above):
        for column in range(left, right):
            if parent[labels[row, column]] == home and _close(box, c, s, row, column, radius, raster):
                return True
    return False


@compiled(
    f"float64(boolean[:,:,:],int16[:,:,:],{A},{A},{B},{B},{CELL},{CELL},{CELL},float64,float64,float64,{A},float64)"
)
def cut_off(inside, count, radii, worth, bodies, more, door_row, door_column, door_of, x0, y0, step, prices, limit):
    """What of a floor is cut off, see `paths.Paths.cut_off`.

    `inside`, `count` (radii, rows, columns); `bodies` all that stands, `more` those of them that `count` lacks, rows
    of [x, y, depth, width, yaw]; a door's cell and the radius it is of; prices [sliver, door, unreached, beside].
    """
    rows, columns = inside.shape[1:]
    raster = (x0, y0, step, rows, columns)
    free, labels = np.empty((rows, columns), np.bool_), np.empty((rows, columns), np.int32)
    room = rows * columns // 2 + 2
    parent, sizes, hidden = np.zeros(room, np.int32), np.zeros(room, np.int64), np.zeros((rows, columns), np.int16)
    for k in range(len(more)):
        _shade(hidden, more[k], radii[0], 1, raster)
    total = 0.0
    for r in range(len(radii)):
        if r:
            hidden[:] = 0
            for k in range(len(more)):
                _shade(hidden, more[k], radii[r], 1, raster)
        for i in range(rows):
            for j in range(columns):
                free[i, j] = inside[r, i, j] and count[r, i, j] == 0 and hidden[i, j] == 0
        n = _label(free, labels, parent, sizes)
        mine = door_of == r
        home = _home(labels, parent, sizes, n, door_row[mine], door_column[mine])
        lost = 1 - sizes[home] / sizes[: n + 1].sum() if home else 1.0
        if lost > prices[0]:
            total += worth[r] * lost
        for k in range(len(door_of)):
            if door_of[k] == r and parent[labels[door_row[k], door_column[k]]] != home:
                total += prices[1] * worth[r]
        if total > limit:
            break
        if r == 0:
            for k in range(len(bodies)):
                if home == 0 or not _touched(bodies[k], labels, parent, home, prices[3], raster):
                    total += prices[2]
    return total
