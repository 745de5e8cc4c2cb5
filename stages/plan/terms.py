"""Reward terms and requirements of a state, compiled.

A cost is the weighted sum of the reward terms plus `LACK` times what the requirements lack, in metres.
"""

import numpy as np

from apartgen.stages.plan.measured import corners, measure, surplus
from apartgen.stages.plan.slicing import (
    AREA,
    ASPECT,
    CONCISE,
    CONVEX,
    CORNER,
    EPS,
    FUNCTION,
    L_ENTRY,
    L_LINK,
    L_WALL,
    LACKING,
    LINES,
    NARROW,
    NEAR,
    OUTER,
    PATH,
    PRIVACY,
    R_AREA,
    R_BROAD,
    R_FACE,
    R_GAPS,
    R_JOINTS,
    R_LEAST,
    R_OUTER,
    R_PIECES,
    R_RIM,
    R_WIDTH,
    R_X0,
    R_X1,
    R_Y0,
    R_Y1,
    S_ACROSS,
    S_ASPECT,
    S_CORNERS,
    S_CORRIDOR,
    S_FACE,
    S_FORM,
    S_FUNCTION,
    S_JOINT,
    S_LEAN,
    S_LOOSE,
    S_OUTER,
    S_PRIVATE,
    S_SHAFT,
    S_TARGET,
    S_WIDTH,
    WIDE,
    Floats,
    Problem,
    Scratch,
    Tree,
    inner,
    lay,
    once,
)
from apartgen.stages.plan.wished import gap, wished

LACK = 120.0
"""What a metre that is lacking costs."""
RISER = 1.0
"""Wall of a bathroom on the outline, where the risers are, m."""
BLIND = 1.5
"""What a metre of hallway counts that leads nowhere."""
OUTGROWN = 8.0
"""What counts, as a room that is too large, against a bedroom that is larger than the main one."""
BROADER = 2.0
"""What a metre of hallway's width counts beyond what two people pass in."""
CERTAIN = 1e-9
"""Part by which a sum must be above a bar for its terms to be above it in any order."""


@inner
def _shape(p: Problem, z: Scratch, bar: float) -> bool:
    # terms and lacks of each room's own form, all but its corners; true as soon as they are above the bar
    thick, total, wanted, terms, weights = p.limits[L_WALL], 0.0, 0.0, z.terms, p.weights
    for r in range(p.spec.shape[0]):
        total += z.room[r, R_AREA]
        wanted += p.spec[r, S_TARGET]
    area, form, convex, wide, lacking, least = 0.0, 0.0, 0.0, 0.0, 0.0, weights[NARROW] * terms[NARROW]
    for r in range(p.spec.shape[0]):
        room, want = z.room[r], p.spec[r]
        ratio = (room[R_AREA] + 0.01) * wanted / (want[S_TARGET] * total + 0.01)
        lean = want[S_LEAN] * (ratio < 1)
        area += (max(ratio, 1 / ratio) - 1) * (1 - 0.5 * want[S_CORRIDOR]) * (lean == 0)
        w, h = max(room[R_X1] - room[R_X0] - thick, 0.1), max(room[R_Y1] - room[R_Y0] - thick, 0.1)
        aspect = max(w, h) / min(w, h)
        form += want[S_FORM] * (aspect - 1) + max(0.0, room[R_BROAD] - want[S_ACROSS])
        hull = 0.5 * (1 + w * h / (room[R_AREA] + 0.01)) - 1  # exact where only corners are missing
        convex += want[S_FORM] * hull * hull
        wide += want[S_CORRIDOR] * (BROADER * max(0.0, room[R_BROAD] - 1.3) + 0.25 * max(0.0, max(w, h) - 9.0))
        lack = 3 * max(0.0, abs(ratio - 1) - max(want[S_LOOSE], lean))
        lack += 2 * max(0.0, want[S_WIDTH] - room[R_WIDTH])
        lack += 2 * max(0.0, want[S_JOINT] - room[R_LEAST]) + max(0.0, aspect - want[S_ASPECT])
        if room[R_PIECES] - 1 > room[R_JOINTS]:
            lack += 1.5 * (room[R_PIECES] - 1 - room[R_JOINTS]) + room[R_GAPS]
        lacking += lack
        cost = least + weights[AREA] * area + weights[ASPECT] * form + weights[CONVEX] * convex
        if cost + weights[WIDE] * wide + LACK * lacking > bar + CERTAIN * bar:
            return True
    terms[AREA] = area + OUTGROWN * _outgrown(p, z)
    terms[ASPECT], terms[CONVEX], terms[WIDE], terms[LACKING] = form, convex, wide, lacking
    return False


@inner
def _outgrown(p: Problem, z: Scratch) -> float:  # of the largest bedroom wanted, what another one is larger
    main, most = -1, 0.0
    for r in range(p.spec.shape[0]):
        if p.spec[r, S_PRIVATE] > 0 and p.spec[r, S_TARGET] > most:
            main, most = r, p.spec[r, S_TARGET]
    other = 0.0
    for r in range(p.spec.shape[0]):
        if p.spec[r, S_PRIVATE] > 0 and p.spec[r, S_TARGET] < most:
            other = max(other, z.room[r, R_AREA])
    return max(0.0, other / (z.room[main, R_AREA] + 0.01) - 1) if main >= 0 else 0.0


@inner
def _concise(p: Problem, z: Scratch) -> None:  # corners beyond those that rooms should have
    for r in range(p.spec.shape[0]):
        if z.room[r, R_PIECES] > 1 or p.spec[r, S_CORNERS] != 4:
            surplus = max(0.0, corners(z.piece, z.before, z.last[r]) / p.spec[r, S_CORNERS] - 1)
            z.terms[CONCISE] += surplus * surplus


@inner
def _walls(p: Problem, z: Scratch) -> None:  # longest between linked rooms, its middle or theirs
    for k in range(p.links.shape[0]):
        r, o = p.links[k, 0], p.links[k, 1]
        room, other, wall = z.room[r], z.room[o], z.wall[k]
        wall[0], wall[3] = 0.0, 0.0
        wall[1] = 0.25 * (room[R_X0] + room[R_X1] + other[R_X0] + other[R_X1])
        wall[2] = 0.25 * (room[R_Y0] + room[R_Y1] + other[R_Y0] + other[R_Y1])
        i = z.last[r]
        while i >= 0:
            a, j = z.piece[i], z.last[o]
            while j >= 0:
                b = z.piece[j]
                x0, x1, y0, y1 = max(a[0], b[0]), min(a[2], b[2]), max(a[1], b[1]), min(a[3], b[3])
                if x1 - x0 >= -EPS and y1 - y0 >= -EPS and max(x1 - x0, y1 - y0) > wall[0]:
                    wall[0], wall[1], wall[2] = max(x1 - x0, y1 - y0), 0.5 * (x0 + x1), 0.5 * (y0 + y1)
                    wall[3] = x1 - x0
                j = z.before[j]
            i = z.before[i]
        z.terms[LACKING] += max(0.0, p.limits[L_LINK] - wall[0])
        if wall[0] == 0.0:
            z.terms[LACKING] += 0.3 * gap(room, other)


@inner
def _enter(wide: float, entry: Floats, axis: int, at: float, lo: float, hi: float) -> None:  # if long and near enough
    along, half = entry[6 - axis], 0.5 * min(wide, hi - lo)
    middle = min(max(along, lo + half), hi - half)
    away = abs(at - entry[5 + axis]) + abs(middle - along)
    fits = hi - lo > wide - EPS and (entry[2] < wide - EPS or away < entry[4])
    if fits or (entry[2] < wide - EPS and hi - lo > entry[2]):
        entry[axis], entry[1 - axis], entry[2], entry[4] = at, middle, hi - lo, away


@inner
def _outside(p: Problem, z: Scratch, count: int) -> None:  # of the rooms, and the best wall for the entrance
    entry, hall, first = z.entry, p.order[0, 0], z.room[p.order[0, 0]]
    entry[0], entry[1] = 0.5 * (first[R_X0] + first[R_X1]), 0.5 * (first[R_Y0] + first[R_Y1])
    entry[2], entry[3], entry[4], entry[5], entry[6] = 0.0, 1e9, 1e9, entry[0], entry[1]
    for i in range(1, p.order.shape[0]):
        if p.spec[p.order[i, 0], S_PRIVATE] < 0:
            entry[5], entry[6] = z.wall[p.order[i, 2], 1], z.wall[p.order[i, 2], 2]
    for e in range(p.edges.shape[0]):
        edge, axis, (at, lo, hi) = p.edges[e], int(p.edges[e, 0]), (z.edge[e, 0], z.edge[e, 1], z.edge[e, 2])
        i = z.last[hall] if edge[5] > 0 else -1
        while i >= 0:
            q = z.piece[i]
            long, off = min(hi, q[3 - axis]) - max(lo, q[1 - axis]), min(abs(q[axis] - at), abs(q[axis + 2] - at))
            entry[3] = min(entry[3], off + max(0.0, -long))
            i = z.before[i]
        for i in range(count):
            q = z.piece[i]
            if min(abs(q[axis] - at), abs(q[axis + 2] - at)) > 1e-4:
                continue
            long = min(hi, q[3 - axis]) - max(lo, q[1 - axis])
            if long < EPS:
                continue
            r = z.owner[i]
            room = z.room[r]
            room[R_RIM] = max(room[R_RIM], long)
            if edge[4] > 0:
                room[R_OUTER] += long
                room[R_FACE] = max(room[R_FACE], long)
            if r == hall and edge[5] > 0:
                _enter(p.limits[L_ENTRY], entry, axis, at, max(lo, q[1 - axis]), min(hi, q[3 - axis]))
    lack = max(0.0, p.limits[L_ENTRY] - entry[2]) + 0.3 * entry[3]
    for r in range(p.spec.shape[0]):
        lack += max(0.0, p.spec[r, S_FACE] - z.room[r, R_FACE])
    z.terms[LACKING] += lack


@inner
def _relations(p: Problem, z: Scratch) -> None:  # ways, shares of outside walls, what should be near
    n, terms, walked = p.spec.shape[0], z.terms, z.walked
    total, functional, outer, held = 0.0, 0.0, 0.0, 0.0
    for r in range(n):
        room, want = z.room[r], p.spec[r]
        total, functional = total + room[R_AREA], functional + room[R_AREA] * want[S_FUNCTION]
        outer, held = outer + room[R_OUTER], held + room[R_OUTER] * want[S_OUTER]
        terms[NEAR] += want[S_SHAFT] * (room[R_RIM] < RISER)
    away, unlived = held / (outer + 0.01) - 1, 1 - functional / (total + 0.01)
    terms[OUTER], terms[FUNCTION] = away * away * n, unlived * unlived * n
    for i in range(p.near.shape[0]):
        near = p.near[i]
        terms[NEAR] += near[2] * min(gap(z.room[near[0]], z.room[near[1]]), 6.0)
    ex, ey, lived = z.entry[0], z.entry[1], -1
    for i in range(n):
        if p.spec[i, S_PRIVATE] < 0:
            lived = i
    for i in range(n):
        r, o, link = p.order[i, 0], p.order[i, 1], p.order[i, 2]
        x, y, before = ex, ey, 0.0
        if o >= 0:
            x, y = z.wall[link, 1], z.wall[link, 2]
            before = walked[o, 0] + abs(x - walked[o, 1]) + abs(y - walked[o, 2])
        walked[r, 0], walked[r, 1], walked[r, 2] = before, x, y
        mx, my = 0.5 * (z.room[r, R_X0] + z.room[r, R_X1]), 0.5 * (z.room[r, R_Y0] + z.room[r, R_Y1])
        straight = abs(mx - ex) + abs(my - ey) + 0.5  # to the room's middle
        detour = max(0.0, (before + abs(mx - x) + abs(my - y)) / straight - 1)
        terms[PATH] += detour * detour
    for r in range(n):  # bedrooms that one comes to before the living room
        if p.spec[r, S_PRIVATE] > 0 and lived >= 0:
            terms[PRIVACY] += min(max(0.0, walked[lived, 0] - walked[r, 0]), 6.0)


@inner
def _lines(p: Problem, root: Floats, z: Scratch, count: int) -> None:  # lines of walls; corners of the flat's box
    held, lines, n = 0.0, 0, p.spec.shape[0]
    for i in range(count):
        q, new_x, new_y = z.piece[i], 1, 1
        side = min(q[0] - root[0], root[2] - q[2]) < EPS and min(q[1] - root[1], root[3] - q[3]) < EPS
        held += side * p.spec[z.owner[i], S_OUTER]
        for j in range(i):
            new_x &= abs(z.piece[j, 0] - q[0]) > 0.05
            new_y &= abs(z.piece[j, 1] - q[1]) > 0.05
        lines += new_x + new_y
    free = 1 - min(held, 4.0) / 4
    z.terms[CORNER] = free * free * n
    z.terms[LINES] = lines


@inner
def _weighed(weights: Floats, terms: Floats) -> float:
    cost = float(LACK * terms[LACKING])
    for i in range(weights.shape[0]):
        cost += weights[i] * terms[i]
    return cost


@once
def evaluate(p: Problem, t: Tree, z: Scratch, bar: float) -> float:
    """Cost of a tree, its measures in `z`; gives up early, with a cost above `bar`, once that is certain."""
    count = z.seq[z.seq.shape[0] - 1] = lay(p, t, z)
    z.terms[:] = 0.0
    measure(p, z, count)
    if _shape(p, z, bar):
        return np.inf
    _walls(p, z)
    cost = _weighed(p.weights, z.terms)
    if cost > bar:
        return cost
    _outside(p, z, count)
    z.terms[WIDE] += BLIND * surplus(p, z)
    _relations(p, z)
    cost = _weighed(p.weights, z.terms)
    if cost > bar:
        return cost
    root = z.box[t.nodes[t.nodes.shape[0] - 1, 0]]
    _lines(p, root, z, count)
    cost = _weighed(p.weights, z.terms)
    if cost > bar:
        return cost
    _concise(p, z)
    return _weighed(p.weights, z.terms) + wished(p, z, root)
