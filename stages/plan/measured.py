"""Area, extents and parts of the rooms of a state, and the chains of their pieces, compiled."""

from apartgen.stages.plan.slicing import (
    EPS,
    L_ENTRY,
    L_JOG,
    L_LINK,
    L_WALL,
    NARROW,
    R_AREA,
    R_BROAD,
    R_FACE,
    R_GAPS,
    R_JOINTS,
    R_LEAST,
    R_MAIN,
    R_OUTER,
    R_PIECES,
    R_RIM,
    R_WIDTH,
    R_X0,
    R_X1,
    R_Y0,
    R_Y1,
    S_CORRIDOR,
    S_JOINT,
    Floats,
    Ints,
    Problem,
    Scratch,
    inner,
)

ROOMY = 1.5
"""Width from which no passage is narrow, m."""


@inner
def measure(p: Problem, z: Scratch, count: int) -> None:
    # each room's measures, and what is narrow
    thick, narrow = p.limits[L_WALL], 0.0
    for r in range(z.last.shape[0]):
        z.last[r] = -1
    for i in range(count):
        a, r = z.piece[i], z.owner[i]
        room = z.room[r]
        w, h = a[2] - a[0] - thick, a[3] - a[1] - thick
        area, breadth = max(w, 0.0) * max(h, 0.0), min(w, h)
        narrow += max(0.0, ROOMY - breadth) * max(w, h)
        j = z.last[r]
        z.before[i], z.last[r] = j, i
        if j < 0:
            room[R_X0], room[R_Y0], room[R_X1], room[R_Y1] = a[0], a[1], a[2], a[3]
            room[R_AREA], room[R_MAIN], room[R_PIECES] = area, area, 1.0
            room[R_WIDTH], room[R_LEAST], room[R_BROAD] = breadth, breadth, max(0.0, breadth)
            room[R_JOINTS], room[R_FACE], room[R_OUTER], room[R_GAPS], room[R_RIM] = 0.0, 0.0, 0.0, 0.0, 0.0
            continue
        room[R_AREA] += area
        room[R_X0], room[R_Y0] = min(room[R_X0], a[0]), min(room[R_Y0], a[1])
        room[R_X1], room[R_Y1] = max(room[R_X1], a[2]), max(room[R_Y1], a[3])
        room[R_PIECES] += 1
        if area >= room[R_MAIN]:
            room[R_MAIN], room[R_WIDTH] = area, breadth
        room[R_LEAST], room[R_BROAD] = min(room[R_LEAST], breadth), max(room[R_BROAD], breadth)
        _joined(p.spec[r, S_JOINT], thick, room, z.piece, z.before, i)
    if p.limits[L_JOG] > 0:
        _across_jogs(p, z)
    z.terms[NARROW] = narrow
    for r in range(z.last.shape[0]):
        if z.last[r] < 0:
            room = z.room[r]
            room[:] = 0.0
            room[R_X0], room[R_Y0], room[R_LEAST], room[R_X1], room[R_Y1] = 1e9, 1e9, 1e9, -1e9, -1e9


@inner
def _across_jogs(p: Problem, z: Scratch) -> None:
    # widths of rooms of several pieces, each piece as wide as it is with those beside it behind a shallow jog
    thick, jog = p.limits[L_WALL], p.limits[L_JOG]
    for r in range(z.last.shape[0]):
        room, last = z.room[r], z.last[r]
        if last < 0 or z.before[last] < 0:
            continue
        room[R_WIDTH], room[R_LEAST], i = 0.0, 1e9, last
        while i >= 0:
            wide = max(_breadth(z, last, i, 0, jog), _breadth(z, last, i, 1, jog)) - thick
            room[R_WIDTH], room[R_LEAST] = max(room[R_WIDTH], wide), min(room[R_LEAST], wide)
            i = z.before[i]


@inner
def _breadth(z: Scratch, last: int, i: int, axis: int, jog: float) -> float:
    # of the rectangle that a piece makes with those of its room before and behind it along an axis, gross
    q = z.piece[i]
    lo, hi, a, b = q[axis], q[axis + 2], q[1 - axis], q[3 - axis]
    best, grown = min(hi - lo, b - a), True
    while grown:
        grown, j = False, last
        while j >= 0:
            o = z.piece[j]
            u, v = max(a, o[1 - axis]), min(b, o[3 - axis])
            beside = abs(o[axis] - hi) < EPS or abs(o[axis + 2] - lo) < EPS
            if beside and u - q[1 - axis] <= jog and q[3 - axis] - v <= jog and v - u > 0:
                lo, hi, a, b, grown = min(lo, o[axis]), max(hi, o[axis + 2]), u, v, True
                best = max(best, min(hi - lo, b - a))
            j = z.before[j]
    return float(best)


@inner
def _joined(joint: float, thick: float, room: Floats, pieces: Floats, before: Ints, i: int) -> None:
    # how a piece meets those of its room before it
    a, j = pieces[i], before[i]
    while j >= 0:
        b = pieces[j]
        x, y = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
        if x < -EPS or y < -EPS:
            room[R_GAPS] += 0.3 * (max(0.0, -x) + max(0.0, -y))
        else:
            wide = max(x, y) - thick
            room[R_AREA] += thick * max(wide, 0.0)
            room[R_JOINTS] += wide >= joint
            deep = (a[3] - a[1] + b[3] - b[1] if x > y else a[2] - a[0] + b[2] - b[0]) - thick
            room[R_BROAD] = max(room[R_BROAD], min(wide, deep))
        j = before[j]


@inner
def _sides(lo: float, hi: float, at: float) -> int:
    # on how many sides of a coordinate, right beside it, an interval is
    before, after = at - 1e-3, at + 1e-3
    return int(lo < before) * int(before < hi) + int(lo < after) * int(after < hi)


@inner
def corners(pieces: Floats, before: Ints, last: int) -> int:  # of a room whose pieces chain from `last` on
    found, i = 0, last
    while i >= 0:
        for corner in range(4):
            x, y = pieces[i, 2 * (corner & 1)], pieces[i, (corner & 2) + 1]
            quadrants, seen, j = 0, False, last
            while j >= 0:
                b = pieces[j]
                quadrants += _sides(b[0], b[2], x) * _sides(b[1], b[3], y)
                on = (abs(b[0] - x) < EPS or abs(b[2] - x) < EPS) and (abs(b[1] - y) < EPS or abs(b[3] - y) < EPS)
                seen = seen or (j < i and on)
                j = before[j]
            found += (quadrants & 1) == 1 and not seen
        i = before[i]
    return found


@inner
def _span(q: Floats, axis: int, x0: float, y0: float, x1: float, y1: float) -> tuple[float, float]:
    # from where to where along a piece a box has it beside it; the second before the first where it has not
    if min(q[2], x1) - max(q[0], x0) < -EPS or min(q[3], y1) - max(q[1], y0) < -EPS:
        return 1e9, -1e9
    return (max(q[0], x0), min(q[2], x1)) if axis == 0 else (max(q[1], y0), min(q[3], y1))


@inner
def _needed(p: Problem, z: Scratch, r: int, i: int, axis: int) -> float:
    # the length of a hallway's piece from the first of its doors, joints and the entrance to the last, at the nearest
    q, first, last, half = z.piece[i], 1e9, -1e9, 0.5 * p.limits[L_ENTRY]
    for k in range(p.links.shape[0]):
        if (p.links[k, 0] == r or p.links[k, 1] == r) and z.wall[k, 0] > 0:
            x, y, dx = z.wall[k, 1], z.wall[k, 2], 0.5 * z.wall[k, 3]
            dy = 0.5 * z.wall[k, 0] if dx < EPS else 0.0
            lo, hi = _span(q, axis, x - dx, y - dy, x + dx, y + dy)
            wide = min(p.limits[L_LINK], hi - lo)
            if hi >= lo - EPS:
                first, last = min(first, hi - wide), max(last, lo + wide)
    if r == p.order[0, 0]:
        x, y = z.entry[0], z.entry[1]
        if q[0] - EPS < x < q[2] + EPS and q[1] - EPS < y < q[3] + EPS:
            lo, hi = _span(q, axis, x - half, y - half, x + half, y + half)
            first, last = min(first, lo), max(last, hi)
    j = z.last[r]
    while j >= 0:
        if j != i:
            b = z.piece[j]
            lo, hi = _span(q, axis, b[0], b[1], b[2], b[3])
            first, last = min(first, lo), max(last, hi)
        j = z.before[j]
    return float(max(p.limits[L_LINK], last - first))


@inner
def surplus(p: Problem, z: Scratch) -> float:
    """Metres that the pieces of hallways are longer than what opens off them needs."""
    total = 0.0
    for r in range(p.spec.shape[0]):
        i = z.last[r] if p.spec[r, S_CORRIDOR] > 0 else -1
        while i >= 0:
            q = z.piece[i]
            axis = int(q[3] - q[1] > q[2] - q[0])
            long = q[axis + 2] - q[axis]
            total += max(0.0, long - _needed(p, z, r, i, axis))
            i = z.before[i]
    return total
