# mypy: disable-error-code="no-untyped-def,no-untyped-call"
"""Simulated annealing over slicing trees, compiled.

A slicing tree cuts the outline by straight walls; each leaf is a rectangle of it and belongs to a room, so rooms
tile the outline without gaps or overlaps. Lengths are metres between wall centre lines ("gross"); floors lie half an
inner wall inside of that. A cost is the weighted sum of the reward terms plus `LACK` times what the requirements lack,
in metres. One file, because numba's cache does not see changes in the modules that a compiled function calls.
"""

from typing import Any, NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

# Wrappers to call a function from Python cost as much to compile as the function; only one is called so.
WITHIN: dict[str, Any] = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
inner = njit(cache=True, nogil=True, error_model="numpy", **WITHIN)

LACK = 60.0
EPS = 1e-6
TERMS = (
    "shortest_path", "typical_area", "aspect_ratio", "convexity", "conciseness", "exterior_length", "exterior_corner",
    "collinearity", "functional_room", "narrow_passage", "staircase_occupancy", "staircase_iou", "near_rooms",
    "wide_corridor",
)  # fmt: skip
PATH, AREA, ASPECT, CONVEX, CONCISE, OUTER, CORNER, LINES, FUNCTION, NARROW, _, _, NEAR, WIDE = range(14)
LACKING = 14
SPEC = ("target", "loose", "width", "joint", "aspect", "form", "corners", "face", "corridor", "functional", "outer")
S_TARGET, S_LOOSE, S_WIDTH, S_JOINT, S_ASPECT, S_FORM, S_CORNERS, S_FACE, S_CORRIDOR, S_FUNCTION, S_OUTER = range(11)
LIMITS = ("least_stretch", "greatest_stretch", "inner_wall", "link_wall", "entrance_wall")
L_SHORT, L_LONG, L_WALL, L_LINK, L_ENTRY = range(5)
R_AREA, R_X0, R_Y0, R_X1, R_Y1, R_PIECES, R_JOINTS, R_MAIN, R_WIDTH, R_LEAST, R_FACE, R_OUTER, R_GAPS = range(13)
LEFT, RIGHT, UPRIGHT = range(3)


class Problem(NamedTuple):
    """What does not change while annealing; `n` rooms, `m` links, `k` blocks, `e` edges."""

    spec: Floats  # (n, 11) of each room, by SPEC; lengths and areas net
    links: Ints  # (m, 2)
    near: Ints  # (q, 2) rooms that should be close to one another
    order: Ints  # (n, 2) rooms breadth first from the entrance, and the room before each, -1 at the start
    blocks: Floats  # (k, 4) x0 y0 x1 y1, disjoint, together the outline
    edges: Floats  # (e, 6) axis (0: x is constant), coordinate, lo, hi, window allowed, entrance allowed
    weights: Floats  # (14,) by TERMS
    limits: Floats  # (5,) by LIMITS


class Tree(NamedTuple):
    """A state. Nodes 0..L-1 are leaves, L..2L-2 cuts; row 2L-1 of `nodes` holds the root."""

    nodes: Ints  # (2L, 3) left, right, upright of a cut; the room (in `left`) of a leaf
    share: Floats  # (L + 1,) gross area wanted by each leaf, any unit; then x times this, y divided by it


class Scratch(NamedTuple):
    """Measures of the state evaluated last."""

    box: Floats  # (2L-1, 5) x0 y0 x1 y1, area wanted
    seq: Ints  # (2L,) nodes, parents first; then the number of pieces
    piece: Floats  # (P, 4) rectangles of rooms
    owner: Ints  # (P,)
    wall: Floats  # (n, n, 3) longest straight wall between two rooms, its middle
    room: Floats  # (n, 13) by the R_ columns
    terms: Floats  # (15,) by TERMS, then the lack
    entry: Floats  # (4,) entrance x, y, length of its wall, distance of its room from such a wall
    walked: Floats  # (n, 3) distance to the room's door, x, y of it


@inner
def _random(state):
    x = state[0]
    x ^= x << np.uint64(13)
    x ^= x >> np.uint64(7)
    x ^= x << np.uint64(17)
    state[0] = x
    return float(x >> np.uint64(11)) / 9007199254740992.0


@inner
def _covered(blocks, s, x0, y0, x1, y1):  # area of the outline within a box
    area = 0.0
    for k in range(blocks.shape[0]):
        w = min(x1, blocks[k, 2] * s) - max(x0, blocks[k, 0] * s)
        h = min(y1, blocks[k, 3] / s) - max(y0, blocks[k, 1] / s)
        if w > 0 and h > 0:
            area += w * h
    return area


@inner
def _cut(p, s, box, upright, share):  # where a cut leaves `share` of the covered area before it
    a, b = (box[0], box[2]) if upright else (box[1], box[3])
    if p.blocks.shape[0] == 1:
        return a + share * (b - a)
    goal = share * _covered(p.blocks, s, box[0], box[1], box[2], box[3])
    lo, hi = a, b
    for _ in range(18):
        c = 0.5 * (lo + hi)
        x1, y1 = (c, box[3]) if upright else (box[2], c)
        if _covered(p.blocks, s, box[0], box[1], x1, y1) < goal:
            lo = c
        else:
            hi = c
    for e in range(p.edges.shape[0]):  # follow a nearby corner of the outline
        if (p.edges[e, 0] == 0) == (upright == 1):
            line = p.edges[e, 1] * s if upright else p.edges[e, 1] / s
            if abs(line - c) < 0.45 and line - a > 0.9 and b - line > 0.9:
                return line
    return c


@inner
def _lay(p, t, z):  # boxes of all nodes, pieces of all rooms; returns the number of pieces
    leaves = t.share.shape[0] - 1
    s, nodes, box, seq = t.share[leaves], t.nodes, z.box, z.seq
    top = nodes[2 * leaves - 1, 0]
    seq[0], count = top, 1
    for i in range(2 * leaves - 1):
        node = seq[i]
        if node >= leaves:
            seq[count], seq[count + 1] = nodes[node, LEFT], nodes[node, RIGHT]
            count += 2
    for i in range(2 * leaves - 2, -1, -1):
        node = seq[i]
        box[node, 4] = t.share[node] if node < leaves else box[nodes[node, LEFT], 4] + box[nodes[node, RIGHT], 4]
    box[top, 0], box[top, 1], box[top, 2], box[top, 3] = 1e9, 1e9, -1e9, -1e9
    for k in range(p.blocks.shape[0]):
        box[top, 0] = min(box[top, 0], p.blocks[k, 0] * s)
        box[top, 1] = min(box[top, 1], p.blocks[k, 1] / s)
        box[top, 2] = max(box[top, 2], p.blocks[k, 2] * s)
        box[top, 3] = max(box[top, 3], p.blocks[k, 3] / s)
    count -= count
    for i in range(2 * leaves - 1):
        node = seq[i]
        if node < leaves:
            count = _part(p.blocks, s, box[node], nodes[node, 0], z.piece, z.owner, count)
            continue
        left, right, upright = nodes[node, LEFT], nodes[node, RIGHT], nodes[node, UPRIGHT]
        c = _cut(p, s, box[node], upright, box[left, 4] / (box[node, 4] + 1e-12))
        for j in range(4):
            box[left, j] = box[right, j] = box[node, j]
        box[left, 3 - upright] = box[right, 1 - upright] = c
    return count


@inner
def _part(blocks, s, box, room, piece, owner, count):  # the pieces of the outline within a leaf's box
    one = blocks.shape[0] == 1
    one = one or _covered(blocks, s, box[0], box[1], box[2], box[3]) > (box[2] - box[0]) * (box[3] - box[1]) - EPS
    for k in range(1 if one else blocks.shape[0]):
        x0, y0, x1, y1 = box[0], box[1], box[2], box[3]
        if not one:
            x0, x1 = max(x0, blocks[k, 0] * s), min(x1, blocks[k, 2] * s)
            y0, y1 = max(y0, blocks[k, 1] / s), min(y1, blocks[k, 3] / s)
        if x1 - x0 > EPS and y1 - y0 > EPS:
            piece[count, 0], piece[count, 1], piece[count, 2], piece[count, 3] = x0, y0, x1, y1
            owner[count] = room
            count += 1
    return count


@inner
def _measure(p, z, count):  # areas, extents and parts of the rooms; walls between them
    thick = p.limits[L_WALL]
    for r in range(z.room.shape[0]):
        for c in range(13):
            z.room[r, c] = 0.0
        z.room[r, R_X0] = z.room[r, R_Y0] = z.room[r, R_LEAST] = 1e9
        z.room[r, R_X1] = z.room[r, R_Y1] = -1e9
        for o in range(r):
            z.wall[r, o, 0] = z.wall[o, r, 0] = 0.0
    for i in range(count):
        a, r = z.piece[i], z.owner[i]
        room = z.room[r]
        w, h = a[2] - a[0] - thick, a[3] - a[1] - thick
        area = max(w, 0.0) * max(h, 0.0)
        room[R_AREA] += area
        room[R_X0], room[R_Y0] = min(room[R_X0], a[0]), min(room[R_Y0], a[1])
        room[R_X1], room[R_Y1] = max(room[R_X1], a[2]), max(room[R_Y1], a[3])
        room[R_PIECES] += 1
        if area >= room[R_MAIN]:
            room[R_MAIN], room[R_WIDTH] = area, min(w, h)
        room[R_LEAST] = min(room[R_LEAST], w, h)
        for j in range(i):
            b = z.piece[j]
            x0, x1, y0, y1 = max(a[0], b[0]), min(a[2], b[2]), max(a[1], b[1]), min(a[3], b[3])
            o, long = z.owner[j], max(x1 - x0, y1 - y0)
            if x1 - x0 < -EPS or y1 - y0 < -EPS:
                if r == o:
                    room[R_GAPS] += 0.3 * (max(0.0, x0 - x1) + max(0.0, y0 - y1))
            elif r == o:
                room[R_AREA] += thick * max(long - thick, 0.0)
                room[R_JOINTS] += long - thick >= p.spec[r, S_JOINT]
            elif long > z.wall[r, o, 0]:
                z.wall[r, o, 0] = z.wall[o, r, 0] = long
                z.wall[r, o, 1] = z.wall[o, r, 1] = 0.5 * (x0 + x1)
                z.wall[r, o, 2] = z.wall[o, r, 2] = 0.5 * (y0 + y1)


@inner
def _outside(p, s, z, count):  # outside walls of the rooms, and the best wall for the entrance
    z.entry[2], z.entry[3] = 0.0, 1e9
    for i in range(count):
        q, r = z.piece[i], z.owner[i]
        for e in range(p.edges.shape[0]):
            axis = int(p.edges[e, 0])
            along = 1 / s if axis == 0 else s
            at, lo, hi = p.edges[e, 1] / along, p.edges[e, 2] * along, p.edges[e, 3] * along
            long, off = min(hi, q[3 - axis]) - max(lo, q[1 - axis]), min(abs(q[axis] - at), abs(q[axis + 2] - at))
            if r == p.order[0, 0] and p.edges[e, 5] > 0:
                z.entry[3] = min(z.entry[3], off + max(0.0, -long))
            if off > 1e-4 or long < EPS:
                continue
            z.room[r, R_OUTER] += long
            if p.edges[e, 4] > 0:
                z.room[r, R_FACE] = max(z.room[r, R_FACE], long)
            if r == p.order[0, 0] and p.edges[e, 5] > 0 and long > z.entry[2]:
                z.entry[axis], z.entry[1 - axis], z.entry[2] = at, max(lo, q[1 - axis]) + 0.5 * long, long


@inner
def _corners(z, count, r):  # corners of a room of several pieces
    found = 0
    for i in range(4 * count):
        if z.owner[i >> 2] != r:
            continue
        x, y = z.piece[i >> 2, 2 * (i & 1)], z.piece[i >> 2, (i & 2) + 1]
        quadrants, seen = 0, False
        for j in range(count):
            b = z.piece[j]
            if z.owner[j] == r:
                for d in range(4):
                    u, v = x + (1e-3 if d & 1 else -1e-3), y + (1e-3 if d & 2 else -1e-3)
                    quadrants += b[0] < u < b[2] and b[1] < v < b[3]
                on = (abs(b[0] - x) < EPS or abs(b[2] - x) < EPS) and (abs(b[1] - y) < EPS or abs(b[3] - y) < EPS)
                seen = seen or (j < i >> 2 and on)
        found += (quadrants & 1) == 1 and not seen
    return found


@inner
def _shape(p, z, count):  # terms and lacks of each room's own form
    thick, total, wanted = p.limits[L_WALL], 0.0, 0.0
    for r in range(p.spec.shape[0]):
        total += z.room[r, R_AREA]
        wanted += p.spec[r, S_TARGET]
    for r in range(p.spec.shape[0]):
        room, want = z.room[r], p.spec[r]
        ratio = (room[R_AREA] + 0.01) * wanted / (want[S_TARGET] * total + 0.01)
        z.terms[AREA] += (max(ratio, 1 / ratio) - 1) * (1 - 0.5 * want[S_CORRIDOR])
        w, h = max(room[R_X1] - room[R_X0] - thick, 0.1), max(room[R_Y1] - room[R_Y0] - thick, 0.1)
        aspect = max(w / h, h / w)
        z.terms[ASPECT] += want[S_FORM] * (aspect - 1)
        hull = 0.5 * (1 + w * h / (room[R_AREA] + 0.01)) - 1  # exact where only corners are missing
        z.terms[CONVEX] += want[S_FORM] * hull * hull
        if room[R_PIECES] > 1 or want[S_CORNERS] != 4:
            surplus = max(_corners(z, count, r), 4) / want[S_CORNERS] - 1
            z.terms[CONCISE] += surplus * surplus
        z.terms[NARROW] += (room[R_LEAST] < 0.5) + (room[R_LEAST] < 1.0)
        z.terms[WIDE] += want[S_CORRIDOR] * max(0.0, room[R_WIDTH] - 1.3)
        lack = 3 * max(0.0, abs(ratio - 1) - want[S_LOOSE]) + 2 * max(0.0, want[S_WIDTH] - room[R_WIDTH])
        lack += 2 * max(0.0, want[S_JOINT] - room[R_LEAST]) + max(0.0, aspect - want[S_ASPECT])
        if room[R_PIECES] - 1 > room[R_JOINTS]:
            lack += 1.5 * (room[R_PIECES] - 1 - room[R_JOINTS]) + room[R_GAPS]
        z.terms[LACKING] += lack


@inner
def _gap(z, a, b):  # distance between two rooms' bounding boxes, Manhattan
    x = max(z.room[a, R_X0], z.room[b, R_X0]) - min(z.room[a, R_X1], z.room[b, R_X1])
    y = max(z.room[a, R_Y0], z.room[b, R_Y0]) - min(z.room[a, R_Y1], z.room[b, R_Y1])
    return max(0.0, x) + max(0.0, y)


@inner
def _relations(p, t, z, count):  # ways, outside walls, rooms that should be near, wall lines
    n = p.spec.shape[0]
    total, functional, outer, held, lines = 0.0, 0.0, 0.0, 0.0, 0
    for r in range(n):
        z.terms[LACKING] += max(0.0, p.spec[r, S_FACE] - z.room[r, R_FACE])
        total += z.room[r, R_AREA]
        functional += z.room[r, R_AREA] * p.spec[r, S_FUNCTION]
        outer += z.room[r, R_OUTER]
        held += z.room[r, R_OUTER] * p.spec[r, S_OUTER]
    z.terms[OUTER] = (held / (outer + 0.01) - 1) ** 2 * n
    z.terms[FUNCTION] = (1 - functional / (total + 0.01)) ** 2 * n
    for i in range(p.near.shape[0]):
        z.terms[NEAR] += min(_gap(z, p.near[i, 0], p.near[i, 1]), 6.0)
    for i in range(n):
        r, o = p.order[i, 0], p.order[i, 1]
        x, y, before = z.entry[0], z.entry[1], 0.0
        if o >= 0:
            x, y = z.wall[r, o, 1], z.wall[r, o, 2]
            before = z.walked[o, 0] + abs(x - z.walked[o, 1]) + abs(y - z.walked[o, 2])
        z.walked[r, 0], z.walked[r, 1], z.walked[r, 2] = before, x, y
        straight = abs(x - z.entry[0]) + abs(y - z.entry[1]) + 0.5
        z.terms[PATH] += max(0.0, before / straight - 1) ** 2
    root, held = z.box[t.nodes[t.nodes.shape[0] - 1, 0]], 0.0
    for i in range(count):
        q, new_x, new_y = z.piece[i], 1, 1
        side = min(q[0] - root[0], root[2] - q[2]) < EPS and min(q[1] - root[1], root[3] - q[3]) < EPS
        held += side * p.spec[z.owner[i], S_OUTER]
        for j in range(i):
            new_x &= abs(z.piece[j, 0] - q[0]) > 0.05
            new_y &= abs(z.piece[j, 1] - q[1]) > 0.05
        lines += new_x + new_y
    z.terms[CORNER] = (min(held, 4.0) / 4 - 1) ** 2 * n
    z.terms[LINES] = lines


@inner
def _weighed(p, z):
    cost = LACK * z.terms[LACKING]
    for i in range(14):
        cost += p.weights[i] * z.terms[i]
    return cost


@inner
def evaluate(p, t, z, bar):
    """Cost of a tree, its measures in `z`; gives up early, with a partial cost above `bar`, once that is certain."""
    count = z.seq[z.seq.shape[0] - 1] = _lay(p, t, z)
    for i in range(15):
        z.terms[i] = 0.0
    _measure(p, z, count)
    _shape(p, z, count)
    for i in range(p.links.shape[0]):
        a, b = p.links[i, 0], p.links[i, 1]
        z.terms[LACKING] += max(0.0, p.limits[L_LINK] - z.wall[a, b, 0])
        if z.wall[a, b, 0] == 0.0:
            z.terms[LACKING] += 0.3 * _gap(z, a, b)
    cost = _weighed(p, z)
    if cost > bar:
        return cost
    _outside(p, t.share[t.share.shape[0] - 1], z, count)
    z.terms[LACKING] += max(0.0, p.limits[L_ENTRY] - z.entry[2]) + 0.3 * z.entry[3]
    _relations(p, t, z, count)
    return _weighed(p, z)


@inner
def _replace(t, old, new):  # hang `new` where `old` hung
    last = t.nodes.shape[0] - 1
    if t.nodes[last, 0] == old:
        t.nodes[last, 0] = new
    for node in range(t.share.shape[0] - 1, last):
        if node != new:
            if t.nodes[node, LEFT] == old:
                t.nodes[node, LEFT] = new
            elif t.nodes[node, RIGHT] == old:
                t.nodes[node, RIGHT] = new


@inner
def _regraft(t, leaf, onto, upright, before):  # move a leaf beside another node
    up = -1
    for node in range(t.share.shape[0] - 1, t.nodes.shape[0] - 1):
        if t.nodes[node, LEFT] == leaf or t.nodes[node, RIGHT] == leaf:
            up = node
    if onto == leaf or onto == up:
        return
    _replace(t, up, t.nodes[up, RIGHT] if t.nodes[up, LEFT] == leaf else t.nodes[up, LEFT])
    _replace(t, onto, up)
    t.nodes[up, LEFT], t.nodes[up, RIGHT] = (leaf, onto) if before else (onto, leaf)
    t.nodes[up, UPRIGHT] = upright


@inner
def _propose(p, t, area, rng):
    leaves = t.share.shape[0] - 1
    move, u = _random(rng), _random(rng)
    i, j = int(_random(rng) * leaves), int(_random(rng) * leaves)
    cut = leaves + int(u * (leaves - 1))
    if move < 0.25:
        t.nodes[i, 0], t.nodes[j, 0] = t.nodes[j, 0], t.nodes[i, 0]
        t.share[i], t.share[j] = t.share[j], t.share[i]
    elif move < 0.33:
        t.nodes[cut, UPRIGHT] = 1 - t.nodes[cut, UPRIGHT]
    elif move < 0.40:
        t.nodes[cut, LEFT], t.nodes[cut, RIGHT] = t.nodes[cut, RIGHT], t.nodes[cut, LEFT]
    elif move < 0.68:
        _regraft(t, i, int(u * (2 * leaves - 1)), int(_random(rng) * 2), _random(rng) < 0.5)
    elif move < 0.84:
        t.share[i] *= np.exp(0.5 * (u + _random(rng) - 1))
    elif move < 0.95:  # towards the wanted areas
        for leaf in range(leaves):
            ratio = p.spec[t.nodes[leaf, 0], S_TARGET] / max(area[t.nodes[leaf, 0]], 0.2)
            t.share[leaf] *= min(max(ratio, 0.7), 1.4)
    else:
        t.share[leaves] = min(max(t.share[leaves] * np.exp(0.12 * (u - 0.5)), p.limits[L_SHORT]), p.limits[L_LONG])


@inner
def _copy(a, b):
    for i in range(a.nodes.shape[0]):
        for j in range(3):
            b.nodes[i, j] = a.nodes[i, j]
    for i in range(a.share.shape[0]):
        b.share[i] = a.share[i]


@njit(cache=True, nogil=True, error_model="numpy")
def anneal(p, t, new, best, z, rng, steps, hot, cold):
    """Anneal `t` in place; leaves in `best` the cheapest state that lacks nothing, else the cheapest.

    Returns its cost. `new` is room for a state, `rng` a (1,) uint64 seed, not 0; the temperature falls geometrically
    from `hot` to `cold`.
    """
    cost = low = np.inf
    valid, temperature = False, hot
    area = z.room[:, 0].copy()
    for step in range(steps + 2):  # the first looks at the start, the last measures the best
        bar = np.inf
        _copy(best if step > steps else t, new)
        if 0 < step <= steps:
            temperature *= (cold / hot) ** (1 / steps)
            bar = cost - temperature * np.log(1 - _random(rng))
            if new.share.shape[0] > 2:
                _propose(p, new, area, rng)
        tried = evaluate(p, new, z, bar)
        if tried > bar:
            continue
        _copy(new, t)
        cost = tried
        for r in range(area.shape[0]):
            area[r] = z.room[r, R_AREA]
        ok = z.terms[LACKING] < EPS
        if (ok and not valid) or (ok == valid and tried < low):
            low, valid = tried, ok
            _copy(t, best)
    return low
