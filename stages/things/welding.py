"""Rows that differ, and normals of surfaces, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@compiled("uint64(float64[:])")
def spread(row: Floats) -> Any:
    """A number that is the same for rows that are, and seldom for others."""
    found = np.uint64(1469598103934665603)
    for value in row:
        mixed = found ^ np.uint64(np.int64(value * 1048576.0))
        found = (mixed ^ (mixed >> np.uint64(31))) * np.uint64(1099511628211)
    return found ^ (found >> np.uint64(29))


@compiled("boolean(float64[:],float64[:])")
def same(a: Floats, b: Floats) -> bool:
    """Whether two rows are equal."""
    for k in range(len(a)):
        if a[k] != b[k]:
            return False
    return True


@compiled("boolean(float64[:],float64[:])")
def before(a: Floats, b: Floats) -> bool:
    """Whether a row comes before another, by its first number that differs."""
    for k in range(len(a)):
        if a[k] != b[k]:
            return bool(a[k] < b[k])
    return False


@compiled("Tuple((int64[:],int64[:]))(float64[:,:])")
def grouped(rows: Floats) -> tuple[Integers, Integers]:
    """The first (u,) of every group of equal rows (n, k), in order of appearance, and each row's group (n,)."""
    size = 16
    while size < 2 * len(rows):
        size *= 2
    table, first, which = np.full(size, -1), np.empty(len(rows), np.int64), np.empty(len(rows), np.int64)
    count = 0
    for i in range(len(rows)):
        at = np.int64(spread(rows[i]) & np.uint64(size - 1))
        while table[at] >= 0 and not same(rows[first[table[at]]], rows[i]):
            at = (at + 1) & (size - 1)
        if table[at] < 0:
            table[at], first[count] = count, i
            count += 1
        which[i] = table[at]
    return first[:count], which


@compiled("int64[:](float64[:,:],int64[:])")
def ordered(rows: Floats, chosen: Integers) -> Integers:
    """The chosen rows (u,), all different, in order: merged from runs, twice as long each time."""
    now, then, n = chosen.copy(), np.empty_like(chosen), len(chosen)
    run = 1
    while run < n:
        for start in range(0, n, 2 * run):
            a, b, middle, end = start, min(start + run, n), min(start + run, n), min(start + 2 * run, n)
            for k in range(start, end):
                left = a < middle and (b >= end or not before(rows[now[b]], rows[now[a]]))
                then[k] = now[a] if left else now[b]
                a, b = (a + 1, b) if left else (a, b + 1)
        now, then, run = then, now, 2 * run
    return now


@compiled("Tuple((float64[:,:],int64[:]))(float64[:,:])")
def distinct(rows: Floats) -> tuple[Floats, Integers]:
    """The rows (n, k) that differ, in order, and which of them each of the given ones is."""
    first, which = grouped(rows)
    order = ordered(rows, first)
    place, found = np.empty(len(rows), np.int64), np.empty((len(order), rows.shape[1]))
    for k in range(len(order)):
        place[order[k]], found[k] = k, rows[order[k]]
    for i in range(len(rows)):
        which[i] = place[first[which[i]]]
    return found, which


@compiled("float64[:,:](float64[:,:],int64[:,:])")
def crossed(vertices: Floats, faces: Integers) -> Floats:
    """Twice the area of each face (m, 3), along its normal."""
    found = np.empty((len(faces), 3))
    for i in range(len(faces)):
        p, q, r = faces[i]
        for k in range(3):
            m, n = (k + 1) % 3, (k + 2) % 3
            found[i, k] = ((vertices[q, m] - vertices[p, m]) * (vertices[r, n] - vertices[p, n])
                           - (vertices[q, n] - vertices[p, n]) * (vertices[r, m] - vertices[p, m]))
    return found


@compiled("float64[:,:](float64[:,:],float64)")
def unit(rows: Floats, least: float) -> Floats:
    """Rows (n, 3) over their lengths, which are taken to be at least so much."""
    found = np.empty_like(rows)
    for i in range(len(rows)):
        length = max(np.sqrt(rows[i, 0] ** 2 + rows[i, 1] ** 2 + rows[i, 2] ** 2), least)
        for k in range(3):
            found[i, k] = rows[i, k] / length
    return found


@compiled("Tuple((int64[:],int64[:]))(int64[:],int64)")
def sorted_out(group: Integers, count: int) -> tuple[Integers, Integers]:
    """The places of each group's members in turn, and where each group's begin, and the last one's end."""
    starts = np.zeros(count + 1, np.int64)
    for own in group:
        starts[own + 1] += 1
    for k in range(count):
        starts[k + 1] += starts[k]
    free, members = starts[:-1].copy(), np.empty_like(group)
    for i in range(len(group)):
        members[free[group[i]]] = i
        free[group[i]] += 1
    return members, starts


@compiled("float64[:,:](float64[:,:],float64[:,:],int64[:,:],float64)")
def normals(vertices: Floats, welded: Floats, faces: Integers, crease: float) -> Floats:
    """The sum (3 × m, 3) of the areas about each face's corners that meet at less than an angle of this cosine;
    vertices are one where they are equal when `welded`.
    """
    area = crossed(vertices, faces)
    flat, total = unit(area, 1e-15), np.zeros((3 * len(faces), 3))
    first, which = grouped(welded)
    members, starts = sorted_out(which[faces.ravel()], len(first))
    for g in range(len(first)):
        for mine in members[starts[g]:starts[g + 1]]:
            for other in members[starts[g]:starts[g + 1]]:
                a, b = flat[mine // 3], flat[other // 3]
                if a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > crease:
                    for k in range(3):
                        total[mine, k] += area[other // 3, k]
    return total
