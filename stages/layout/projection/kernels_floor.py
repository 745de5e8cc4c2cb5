"""What is cut off of a floor, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

from typing import Any, NamedTuple

import numpy as np
from numba import boolean, float64, int16, int64, types
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled, inner

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Counts = NDArray[np.int16]
Labels = NDArray[np.int32]
Indices = NDArray[np.int64]


class Raster(NamedTuple):
    """Lower left corner and size of cells, m; their rows and columns."""

    x: float
    y: float
    step: float
    rows: int
    columns: int


class Walkers(NamedTuple):
    """Their radii, m, and how many metres of shifting each is worth (r,)."""

    radii: Floats
    worth: Floats


class Doors(NamedTuple):
    """A door's cell, and which radius it is of (d,)."""

    row: Indices
    column: Indices
    of: Indices


class Prices(NamedTuple):
    """The share of the floor that may be cut off, what a door and an object out of reach count, how near, m, one has
    to get to an object, and how near and how far before what opens the widest walker has to stand."""

    sliver: float
    door: float
    unreached: float
    beside: float
    close: float
    far: float


A, B = float64[::1], float64[:, ::1]
named: Any = types.NamedTuple
of_one_type: Any = types.NamedUniTuple
RASTER = named((float64, float64, float64, int64, int64), Raster)
WALKERS = of_one_type(A, 2, Walkers)
DOORS = of_one_type(int64[::1], 3, Doors)
PRICES = of_one_type(float64, 6, Prices)


@inner
def _window(box: Floats, reach: float, raster: Raster) -> tuple[int, int, int, int]:
    """Rows and columns of the cells that may lie within reach of a footprint."""
    x0, y0, step, rows, columns = raster
    c, s = abs(np.cos(box[4])), abs(np.sin(box[4]))
    x, y = (c * box[2] + s * box[3]) / 2 + reach, (s * box[2] + c * box[3]) / 2 + reach
    left, below = int(np.floor((box[0] - x - x0) / step)), int(np.floor((box[1] - y - y0) / step))
    right, above = int(np.ceil((box[0] + x - x0) / step)) + 1, int(np.ceil((box[1] + y - y0) / step)) + 1
    return max(below, 0), min(max(above, 0), rows), max(left, 0), min(max(right, 0), columns)


@inner
def _close(box: Floats, c: float, s: float, row: int, column: int, radius: float, raster: Raster) -> bool:
    """Whether a cell's centre is closer to a footprint than a radius."""
    x, y = raster.x + (column + 0.5) * raster.step - box[0], raster.y + (row + 0.5) * raster.step - box[1]
    ahead = max(abs(x * c + y * s) - box[2] / 2, 0.0)
    aside = max(abs(y * c - x * s) - box[3] / 2, 0.0)
    return bool(ahead * ahead + aside * aside < (radius - 1e-9) ** 2)


@inner
def _shade(count: Counts, box: Floats, radius: float, by: int, raster: Raster) -> None:
    c, s = np.cos(box[4]), np.sin(box[4])
    below, above, left, right = _window(box, radius, raster)
    for row in range(below, above):
        for column in range(left, right):
            if _close(box, c, s, row, column, radius, raster):
                count[row, column] += by


@compiled(types.void(int16[:, :, ::1], A, A, int16, RASTER))
def shade(count: Counts, box: Floats, radii: Floats, by: int, raster: Raster) -> None:
    """Add `by` to the cells (radii, rows, columns) closer than each radius to a footprint [x, y, depth, width, yaw]."""
    for k in range(len(radii)):
        _shade(count[k], box, radii[k], by, raster)


@inner
def _root(parent: Labels, label: int) -> int:
    while parent[label] != label:
        label = parent[label]
    return label


@inner
def _label(inside: Flags, count: Counts, labels: Labels, parent: Labels, sizes: Indices) -> int:
    """Cells inside that nothing keeps off, by edges; then `parent` is the first label of each one's part."""
    rows, columns = inside.shape
    n, parent[0], sizes[0] = 0, 0, 0
    for i in range(rows):
        own, many = 0, 0
        for j in range(columns):
            if not inside[i, j] or count[i, j] != 0:
                sizes[own] += many
                own, many, labels[i, j] = 0, 0, 0
                continue
            up = labels[i - 1, j] if i else 0
            if own == 0:
                if up == 0:
                    n += 1
                    parent[n], sizes[n], up = n, 0, n
                own = up
            elif up != 0 and up != own:
                a, b = _root(parent, up), _root(parent, own)
                parent[max(a, b)] = min(a, b)
            many += 1
            labels[i, j] = own
        sizes[own] += many
    for k in range(1, n + 1):
        parent[k] = _root(parent, parent[k])
        if parent[k] != k:
            sizes[parent[k]] += sizes[k]
            sizes[k] = 0
    return n


@inner
def _home(labels: Labels, parent: Labels, sizes: Indices, n: int, doors: Doors, which: int) -> int:
    """The part with most floor before doors, those of one radius, else the largest."""
    home, (row, column, of) = 0, doors
    for k in range(len(of)):
        part = parent[labels[row[k], column[k]]]
        if of[k] == which and sizes[part] > sizes[home]:
            home = part
    if home == 0:
        for part in range(1, n + 1):
            if sizes[part] > sizes[home]:
                home = part
    return home


@inner
def _touched(box: Floats, labels: Labels, parent: Labels, home: int, radius: float, raster: Raster) -> bool:
    """Whether any of a part lies about a footprint."""
    c, s = np.cos(box[4]), np.sin(box[4])
    below, above, left, right = _window(box, radius, raster)
    for row in range(below, above):
        for column in range(left, right):
            if parent[labels[row, column]] == home and _close(box, c, s, row, column, radius, raster):
                return True
    return False


@inner
def _used(box: Floats, labels: Labels, parent: Labels, home: int, prices: Prices, raster: Raster) -> bool:
    """Whether any of a part lies before a footprint, as far from what it opens, box[5], as one stands to use it."""
    c, s = np.cos(box[4]), np.sin(box[4])
    face, half = box[2] / 2 + box[5], box[3] / 2 + prices.close
    below, above, left, right = _window(box, box[5] + prices.far, raster)
    for row in range(below, above):
        for column in range(left, right):
            if parent[labels[row, column]] == home:
                x, y = raster.x + (column + 0.5) * raster.step - box[0], raster.y + (row + 0.5) * raster.step - box[1]
                ahead = x * c + y * s - face
                if prices.close <= ahead <= prices.far and abs(y * c - x * s) <= half:
                    return True
    return False


@compiled(float64(boolean[:, :, ::1], int16[:, :, ::1], WALKERS, B, B, DOORS, RASTER, PRICES, float64))
def cut_off(inside: Flags, count: Counts, walkers: Walkers, bodies: Floats, more: Floats, doors: Doors, raster: Raster,
            prices: Prices, limit: float) -> float:
    """What of a floor is cut off, see `paths.Paths.cut_off`.

    `inside`, `count` (radii, rows, columns); `bodies` all that stands, `more` those of them that `count` lacks, rows
    of [x, y, depth, width, yaw, how far it opens, -1 where it does not, or -2 where nobody need get at it].
    """
    (radii, worth), (_, _, _, rows, columns), (door_row, door_column, door_of) = walkers, raster, doors
    labels, room = np.empty((rows, columns), np.int32), rows * columns // 2 + 2
    parent, sizes, taken = np.empty(room, np.int32), np.empty(room, np.int64), np.empty((rows, columns), np.int16)
    total = 0.0
    for r in range(len(radii)):
        for i in range(rows):
            for j in range(columns):
                taken[i, j] = count[r, i, j]
        for k in range(len(more)):
            _shade(taken, more[k], radii[r], 1, raster)
        n = _label(inside[r], taken, labels, parent, sizes)
        home, whole = _home(labels, parent, sizes, n, doors, r), 0
        for k in range(1, n + 1):
            whole += sizes[k]
        lost = 1 - sizes[home] / whole if home else 1.0
        if lost > prices.sliver:
            total += worth[r] * lost
        for k in range(len(door_of)):
            if door_of[k] == r and parent[labels[door_row[k], door_column[k]]] != home:
                total += prices.door * worth[r]
        if total > limit:
            break
        if r == 0:
            for k in range(len(bodies)):
                got_at = bodies[k, 5] >= -1
                if got_at and (home == 0 or not _touched(bodies[k], labels, parent, home, prices.beside, raster)):
                    total += prices.unreached
        elif r == len(radii) - 1:
            for k in range(len(bodies)):
                if bodies[k, 5] >= 0 and (home == 0 or not _used(bodies[k], labels, parent, home, prices, raster)):
                    total += prices.unreached
    return total
