# mypy: disable-error-code="no-untyped-def,no-untyped-call"
"""Reward terms and requirements of a state, compiled.

A cost is the weighted sum of the reward terms plus `LACK` times what the requirements lack, in metres.
"""

from stages.plan.slicing import (
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
    R_AREA,
    R_FACE,
    R_GAPS,
    R_JOINTS,
    R_LEAST,
    R_MAIN,
    R_OUTER,
    R_PIECES,
    R_WIDTH,
    R_X0,
    R_X1,
    R_Y0,
    R_Y1,
    S_ASPECT,
    S_CORNERS,
    S_CORRIDOR,
    S_FACE,
    S_FORM,
    S_FUNCTION,
    S_JOINT,
    S_LOOSE,
    S_OUTER,
    S_TARGET,
    S_WIDTH,
    WIDE,
    inner,
    lay,
)

LACK = 60.0


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
        z.terms[WIDE] += want[S_CORRIDOR] * (max(0.0, room[R_WIDTH] - 1.3) + 0.25 * max(0.0, max(w, h) - 9.0))
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
    count = z.seq[z.seq.shape[0] - 1] = lay(p, t, z)
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
