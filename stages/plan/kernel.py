"""Simulated annealing over slicing trees, compiled.

A slicing tree cuts the outline by straight walls; each leaf is a rectangle of it and belongs to a room, so rooms
tile the outline without gaps or overlaps. Lengths are metres between wall centre lines ("gross"); floors lie half an
inner wall inside of that. A cost is the weighted sum of the reward terms plus `LACK` times what the
requirements lack, in metres.
"""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

LACK = 60.0
EPS = 1e-6


class Problem(NamedTuple):
    """What does not change while annealing; `n` rooms, `m` links, `k` blocks, `e` edges."""

    target: Floats  # (n,) net area wanted, m2
    loose: Floats  # (n,) free share of deviation from it
    width: Floats  # (n,) least clear width of the largest part
    joint: Floats  # (n,) least clear width where parts meet, and of small parts
    aspect: Floats  # (n,) greatest aspect of the bounding box
    form: Floats  # (n,) how much the shape terms count
    corners: Floats  # (n,) corners wanted
    face: Floats  # (n,) straight outside wall needed for a window, m
    role: Ints  # (n, 4) corridor, wet, functional, wants outside wall
    links: Ints  # (m, 2)
    order: Ints  # (n,) rooms breadth first from the entrance
    parent: Ints  # (n,) the room before it on the way from the entrance, -1 at the start
    blocks: Floats  # (k, 4) x0 y0 x1 y1, disjoint, together the outline
    edges: Floats  # (e, 6) axis (0: x is constant), coordinate, lo, hi, window allowed, entrance allowed
    weights: Floats  # (13,) by TERMS
    limits: Floats  # (5,) least and greatest stretch, inner wall, link wall, entrance wall


class Tree(NamedTuple):
    """A state; leaves are nodes 0..L-1, cuts are nodes L..2L-2."""

    left: Ints
    right: Ints
    upright: Ints  # 1: the cut is a vertical line
    room: Ints  # (L,)
    share: Floats  # (L,) gross area wanted, any unit
    top: Ints  # (1,) the root
    stretch: Floats  # (1,) x times this, y divided by it


class Scratch(NamedTuple):
    """Measures of the state last evaluated."""

    box: Floats  # (2L-1, 4)
    seq: Ints  # (2L-1,)
    total: Floats  # (2L-1,)
    piece: Floats  # (P, 4) rectangles of rooms
    owner: Ints  # (P,)
    wall: Floats  # (n, n) longest straight wall between two rooms
    door: Floats  # (n, n, 2) its middle
    room: Floats  # (n, 12) area, x0, y0, x1, y1, pieces, joints, greatest part, its width, least part, window wall, outside wall
    terms: Floats  # (14,) the terms, then the lack
    entry: Floats  # (3,) entrance x, y, length of its wall
    walked: Floats  # (n, 3) distance to the room's door, x, y of it


@njit(cache=True, nogil=True)
def _random(state: NDArray[np.uint64]) -> float:
    x = state[0]
    x ^= x << np.uint64(13)
    x ^= x >> np.uint64(7)
    x ^= x << np.uint64(17)
    state[0] = x
    return float(x >> np.uint64(11)) / 9007199254740992.0


@njit(cache=True, nogil=True)
def _covered(p, s, x0, y0, x1, y1):  # area of the outline within a box
    area = 0.0
    for k in range(p.blocks.shape[0]):
        w = min(x1, p.blocks[k, 2] * s) - max(x0, p.blocks[k, 0] * s)
        h = min(y1, p.blocks[k, 3] / s) - max(y0, p.blocks[k, 1] / s)
        if w > 0 and h > 0:
            area += w * h
    return area


@njit(cache=True, nogil=True)
def _cut(p, s, box, upright, share):  # where a cut leaves `share` of the covered area before it
    a, b = (box[0], box[2]) if upright else (box[1], box[3])
    if p.blocks.shape[0] == 1:
        return a + share * (b - a)
    goal = share * _covered(p, s, box[0], box[1], box[2], box[3])
    lo, hi = a, b
    for _ in range(18):
        c = 0.5 * (lo + hi)
        got = _covered(p, s, box[0], box[1], c, box[3]) if upright else _covered(p, s, box[0], box[1], box[2], c)
        if got < goal:
            lo = c
        else:
            hi = c
    for e in range(p.edges.shape[0]):  # follow a nearby corner of the outline
        if (p.edges[e, 0] == 0) == (upright == 1):
            line = p.edges[e, 1] * s if upright else p.edges[e, 1] / s
            if abs(line - c) < 0.45 and line - a > 0.9 and b - line > 0.9:
                return line
    return c


@njit(cache=True, nogil=True)
def lay(p, t, z):  # boxes of all nodes, pieces of all rooms; returns the number of pieces
    leaves = t.room.shape[0]
    s = t.stretch[0]
    z.seq[0] = t.top[0]
    count = 1
    for i in range(2 * leaves - 1):
        node = z.seq[i]
        if node >= leaves:
            z.seq[count] = t.left[node]
            z.seq[count + 1] = t.right[node]
            count += 2
    for i in range(2 * leaves - 2, -1, -1):
        node = z.seq[i]
        z.total[node] = t.share[node] if node < leaves else z.total[t.left[node]] + z.total[t.right[node]]
    root = z.box[t.top[0]]
    root[0] = root[1] = 1e9
    root[2] = root[3] = -1e9
    for k in range(p.blocks.shape[0]):
        root[0] = min(root[0], p.blocks[k, 0] * s)
        root[1] = min(root[1], p.blocks[k, 1] / s)
        root[2] = max(root[2], p.blocks[k, 2] * s)
        root[3] = max(root[3], p.blocks[k, 3] / s)
    count = 0
    for i in range(2 * leaves - 1):
        node = z.seq[i]
        box = z.box[node]
        if node < leaves:
            count = _part(p, s, box, t.room[node], z, count)
            continue
        l, r = t.left[node], t.right[node]
        c = _cut(p, s, box, t.upright[node], z.total[l] / (z.total[node] + 1e-12))
        z.box[l] = box
        z.box[r] = box
        if t.upright[node]:
            z.box[l, 2] = z.box[r, 0] = c
        else:
            z.box[l, 3] = z.box[r, 1] = c
    return count


@njit(cache=True, nogil=True)
def _part(p, s, box, room, z, count):  # the pieces of the outline within a leaf's box
    whole = (box[2] - box[0]) * (box[3] - box[1])
    if p.blocks.shape[0] == 1 or _covered(p, s, box[0], box[1], box[2], box[3]) > whole - EPS:
        z.piece[count] = box
        z.owner[count] = room
        return count + 1
    for k in range(p.blocks.shape[0]):
        x0, x1 = max(box[0], p.blocks[k, 0] * s), min(box[2], p.blocks[k, 2] * s)
        y0, y1 = max(box[1], p.blocks[k, 1] / s), min(box[3], p.blocks[k, 3] / s)
        if x1 - x0 > EPS and y1 - y0 > EPS:
            q = z.piece[count]
            q[0], q[1], q[2], q[3] = x0, y0, x1, y1
            z.owner[count] = room
            count += 1
    return count


@njit(cache=True, nogil=True)
def _measure(p, z, count):  # areas, extents and parts of the rooms
    thick = p.limits[2]
    z.room[:] = 0.0
    z.room[:, 1] = z.room[:, 2] = 1e9
    z.room[:, 3] = z.room[:, 4] = -1e9
    z.room[:, 9] = 1e9
    for i in range(count):
        q, room = z.piece[i], z.room[z.owner[i]]
        w, h = q[2] - q[0], q[3] - q[1]
        area = max(w - thick, 0.0) * max(h - thick, 0.0)
        room[0] += area
        room[1], room[2] = min(room[1], q[0]), min(room[2], q[1])
        room[3], room[4] = max(room[3], q[2]), max(room[4], q[3])
        room[5] += 1
        if area >= room[7]:
            room[7], room[8] = area, min(w, h) - thick
        room[9] = min(room[9], min(w, h) - thick)


@njit(cache=True, nogil=True)
def _touch(p, z, count):  # walls between rooms, joints within them
    thick = p.limits[2]
    z.wall[:] = 0.0
    for i in range(count):
        a = z.piece[i]
        for j in range(i):
            b = z.piece[j]
            x0, x1 = max(a[0], b[0]), min(a[2], b[2])
            y0, y1 = max(a[1], b[1]), min(a[3], b[3])
            w, h = x1 - x0, y1 - y0
            if w < -EPS or h < -EPS or (w < EPS and h < EPS):
                continue
            r, o = z.owner[i], z.owner[j]
            long = max(w, h)
            if r == o:
                z.room[r, 0] += thick * max(long - thick, 0.0)
                if long - thick >= p.joint[r]:
                    z.room[r, 6] += 1
            elif long > z.wall[r, o]:
                z.wall[r, o] = z.wall[o, r] = long
                z.door[r, o, 0] = z.door[o, r, 0] = 0.5 * (x0 + x1)
                z.door[r, o, 1] = z.door[o, r, 1] = 0.5 * (y0 + y1)


@njit(cache=True, nogil=True)
def _outside(p, s, z, count):  # outside walls of the rooms, and the best wall for the entrance
    z.entry[:] = 0.0
    first = p.order[0]
    for i in range(count):
        q, r = z.piece[i], z.owner[i]
        for e in range(p.edges.shape[0]):
            edge = p.edges[e]
            if edge[0] == 0:
                at, lo, hi = edge[1] * s, max(edge[2] / s, q[1]), min(edge[3] / s, q[3])
                on = min(abs(q[0] - at), abs(q[2] - at))
            else:
                at, lo, hi = edge[1] / s, max(edge[2] * s, q[0]), min(edge[3] * s, q[2])
                on = min(abs(q[1] - at), abs(q[3] - at))
            if on > 1e-4 or hi - lo < EPS:
                continue
            z.room[r, 11] += hi - lo
            if edge[4] > 0:
                z.room[r, 10] = max(z.room[r, 10], hi - lo)
            if r == first and edge[5] > 0 and hi - lo > z.entry[2]:
                middle = 0.5 * (lo + hi)
                z.entry[0] = at if edge[0] == 0 else middle
                z.entry[1] = middle if edge[0] == 0 else at
                z.entry[2] = hi - lo


@njit(cache=True, nogil=True)
def _corners(z, count, r):  # corners of a room of several pieces
    found = 0
    for i in range(count):
        if z.owner[i] != r:
            continue
        for c in range(4):
            x, y = z.piece[i, 2 * (c & 1)], z.piece[i, 2 * (c >> 1) + 1]
            quadrants, seen = 0, False
            for j in range(count):
                if z.owner[j] != r:
                    continue
                b = z.piece[j]
                for d in range(4):
                    u, v = x + (1e-3 if d & 1 else -1e-3), y + (1e-3 if d >> 1 else -1e-3)
                    if b[0] < u < b[2] and b[1] < v < b[3]:
                        quadrants += 1
                on = (abs(b[0] - x) < EPS or abs(b[2] - x) < EPS) and (abs(b[1] - y) < EPS or abs(b[3] - y) < EPS)
                seen = seen or (j < i and on)
            if quadrants & 1 and not seen:
                found += 1
    return found


@njit(cache=True, nogil=True)
def _shape(p, z, count):  # the terms of one room's form: 1 area, 2 aspect, 3 convexity, 4 conciseness, 9 narrow passage
    total, wanted = 0.0, 0.0
    for r in range(p.target.shape[0]):
        total += z.room[r, 0]
        wanted += p.target[r]
    for r in range(p.target.shape[0]):
        room = z.room[r]
        ratio = (room[0] + 0.01) * wanted / (p.target[r] * total + 0.01)
        z.terms[1] += (max(ratio, 1 / ratio) - 1) * (0.5 if p.role[r, 0] else 1.0)
        w, h = room[3] - room[1] - p.limits[2], room[4] - room[2] - p.limits[2]
        aspect = max(w, h) / max(min(w, h), 0.1)
        z.terms[2] += p.form[r] * (aspect - 1)
        hull = 0.5 * (1 + max(w, 0.1) * max(h, 0.1) / (room[0] + 0.01))  # exact where only corners are missing
        z.terms[3] += p.form[r] * (hull - 1) ** 2
        if room[5] > 1 or p.corners[r] != 4:
            z.terms[4] += (max(_corners(z, count, r), 4) / p.corners[r] - 1) ** 2
        for radius in (0.25, 0.5):
            z.terms[9] += 1.0 if room[9] < 2 * radius else 0.0
        lack = max(0.0, abs(ratio - 1) - p.loose[r]) * 3
        lack += 2 * max(0.0, p.width[r] - room[8]) + 2 * max(0.0, p.joint[r] - room[9])
        lack += max(0.0, aspect - p.aspect[r]) + 1.5 * max(0.0, room[5] - 1 - room[6])
        lack += max(0.0, p.face[r] - room[10])
        if p.role[r, 0]:  # a corridor no wider than needed
            z.terms[12] += max(0.0, room[8] - 1.4)
        z.terms[13] += lack


@njit(cache=True, nogil=True)
def _relations(p, z):  # links, ways, outside walls, wet rooms
    n = p.target.shape[0]
    for i in range(p.links.shape[0]):
        a, b = p.links[i, 0], p.links[i, 1]
        z.terms[13] += max(0.0, p.limits[3] - z.wall[a, b])
        if z.wall[a, b] == 0.0:
            gap_x = max(z.room[a, 1], z.room[b, 1]) - min(z.room[a, 3], z.room[b, 3])
            gap_y = max(z.room[a, 2], z.room[b, 2]) - min(z.room[a, 4], z.room[b, 4])
            z.terms[13] += 0.3 * (max(0.0, gap_x) + max(0.0, gap_y))
    z.terms[13] += max(0.0, p.limits[4] - z.entry[2])
    total, functional, outer, wanted = 0.0, 0.0, 0.0, 0.0
    for r in range(n):
        total += z.room[r, 0]
        functional += z.room[r, 0] * p.role[r, 2]
        outer += z.room[r, 11]
        wanted += z.room[r, 11] * p.role[r, 3]
        apart = 1e9 if p.role[r, 1] else 0.0
        for o in range(n):
            if p.role[r, 1] and p.role[o, 1] and o != r:
                gap_x = max(z.room[o, 1], z.room[r, 1]) - min(z.room[o, 3], z.room[r, 3])
                gap_y = max(z.room[o, 2], z.room[r, 2]) - min(z.room[o, 4], z.room[r, 4])
                apart = min(apart, max(0.0, gap_x) + max(0.0, gap_y))
        z.terms[11] += min(apart, 6.0) if apart < 1e8 else 0.0
    z.terms[5] = (wanted / (outer + 0.01) - 1) ** 2 * n
    z.terms[8] = (1 - functional / (total + 0.01)) ** 2 * n
    for i in range(n):
        r = p.order[i]
        o = p.parent[r]
        x, y, before = z.entry[0], z.entry[1], 0.0
        if o >= 0:
            x, y = z.door[r, o, 0], z.door[r, o, 1]
            before = z.walked[o, 0] + abs(x - z.walked[o, 1]) + abs(y - z.walked[o, 2])
        z.walked[r, 0], z.walked[r, 1], z.walked[r, 2] = before, x, y
        straight = abs(x - z.entry[0]) + abs(y - z.entry[1])
        z.terms[0] += (before / (straight + 0.5) - 1) ** 2 if before > straight + 0.5 else 0.0


@njit(cache=True, nogil=True)
def _lines(p, t, z, count):  # outer corners held by rooms that want them; distinct wall lines
    root = z.box[t.top[0]]
    held, lines = 0, 0
    for i in range(count):
        q = z.piece[i]
        side_x = abs(q[0] - root[0]) < EPS or abs(q[2] - root[2]) < EPS
        side_y = abs(q[1] - root[1]) < EPS or abs(q[3] - root[3]) < EPS
        if side_x and side_y:
            held += p.role[z.owner[i], 3]
        new_x, new_y = 1, 1
        for j in range(i):
            if abs(z.piece[j, 0] - q[0]) < 0.05:
                new_x = 0
            if abs(z.piece[j, 1] - q[1]) < 0.05:
                new_y = 0
        lines += new_x + new_y
    z.terms[6] = (min(held, 4) / 4 - 1) ** 2 * p.target.shape[0]
    z.terms[7] = lines


@njit(cache=True, nogil=True)
def evaluate(p, t, z):
    """Cost of a tree; the measures, terms and lack are left in `z`."""
    count = lay(p, t, z)
    z.terms[:] = 0.0
    _measure(p, z, count)
    _touch(p, z, count)
    _outside(p, t.stretch[0], z, count)
    _shape(p, z, count)
    _relations(p, z)
    _lines(p, t, z, count)
    cost = LACK * z.terms[13]
    for i in range(13):
        cost += p.weights[i] * z.terms[i]
    return cost


@njit(cache=True, nogil=True)
def _copy(a, b):
    for i in range(a.left.shape[0]):
        b.left[i], b.right[i], b.upright[i] = a.left[i], a.right[i], a.upright[i]
    for i in range(a.room.shape[0]):
        b.room[i], b.share[i] = a.room[i], a.share[i]
    b.top[0], b.stretch[0] = a.top[0], a.stretch[0]


@njit(cache=True, nogil=True)
def _regraft(t, leaf, onto, upright, before):  # move a leaf beside another node
    leaves = t.room.shape[0]
    up = -1
    for node in range(leaves, 2 * leaves - 1):
        if t.left[node] == leaf or t.right[node] == leaf:
            up = node
    other = t.right[up] if t.left[up] == leaf else t.left[up]
    if onto == leaf or onto == up:
        return
    if t.top[0] == up:
        t.top[0] = other
    for node in range(leaves, 2 * leaves - 1):
        if t.left[node] == up:
            t.left[node] = other
        elif t.right[node] == up:
            t.right[node] = other
    if t.top[0] == onto:
        t.top[0] = up
    else:
        for node in range(leaves, 2 * leaves - 1):
            if node != up and t.left[node] == onto:
                t.left[node] = up
            elif node != up and t.right[node] == onto:
                t.right[node] = up
    t.left[up], t.right[up] = (leaf, onto) if before else (onto, leaf)
    t.upright[up] = upright


@njit(cache=True, nogil=True)
def _propose(p, t, z, rng):
    leaves = t.room.shape[0]
    move = _random(rng)
    i = int(_random(rng) * leaves)
    j = int(_random(rng) * leaves)
    cut = leaves + int(_random(rng) * (leaves - 1))
    if move < 0.28:
        t.room[i], t.room[j] = t.room[j], t.room[i]
        t.share[i], t.share[j] = t.share[j], t.share[i]
    elif move < 0.36:
        t.upright[cut] = 1 - t.upright[cut]
    elif move < 0.44:
        t.left[cut], t.right[cut] = t.right[cut], t.left[cut]
    elif move < 0.68:
        onto = int(_random(rng) * (2 * leaves - 1))
        _regraft(t, i, onto, int(_random(rng) * 2), _random(rng) < 0.5)
    elif move < 0.84:
        t.share[i] *= np.exp(0.5 * (_random(rng) + _random(rng) - 1))
    elif move < 0.95:  # towards the wanted areas, with what was measured last
        for leaf in range(leaves):
            ratio = p.target[t.room[leaf]] / max(z.room[t.room[leaf], 0], 0.2)
            t.share[leaf] *= min(max(ratio, 0.7), 1.4)
    else:
        s = t.stretch[0] * np.exp(0.12 * (_random(rng) - 0.5))
        t.stretch[0] = min(max(s, p.limits[0]), p.limits[1])


@njit(cache=True, nogil=True)
def anneal(p, t, best, z, rng, steps, hot, cold):
    """Anneal `t` in place; leaves in `best` the cheapest state that lacks nothing, else the cheapest.

    Returns its cost. `rng` is a (1,) uint64 seed, not 0; temperatures fall geometrically from `hot` to `cold`.
    """
    new = Tree(t.left.copy(), t.right.copy(), t.upright.copy(), t.room.copy(), t.share.copy(), t.top.copy(), t.stretch.copy())
    cost = evaluate(p, t, z)
    low, valid = cost, z.terms[13] < EPS
    _copy(t, best)
    for step in range(steps):
        temperature = hot * (cold / hot) ** (step / steps)
        _copy(t, new)
        if new.room.shape[0] > 1:
            _propose(p, new, z, rng)
        tried = evaluate(p, new, z)
        if tried < cost or _random(rng) < np.exp((cost - tried) / temperature):
            _copy(new, t)
            cost = tried
            ok = z.terms[13] < EPS
            if (ok and not valid) or (ok == valid and tried < low):
                low, valid = tried, ok
                _copy(t, best)
    evaluate(p, best, z)
    return low
