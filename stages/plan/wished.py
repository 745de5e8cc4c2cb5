"""What an arrangement lacks of the places, neighbours and lengths asked for, compiled.

A wish is a row: what kind it is, a room, another one, a direction, two lengths or the most and least of one or of an
area, and what it counts.
"""

from apartgen.stages.plan.slicing import (
    EPS,
    L_WALL,
    R_AREA,
    R_LEAST,
    R_WIDTH,
    R_X0,
    R_X1,
    R_Y0,
    R_Y1,
    Floats,
    Problem,
    Scratch,
    inner,
)

PLACE, CENTRE, BESIDE, NEAR_ENTRANCE, FAR_FROM_ENTRANCE, ADJACENT, APART, LENGTHS, LONG, WIDE, SERVING, SIZE = range(12)
REACH, WALL, CARRIED = 1.5, 1.0, 1.5
"""Distance from the entrance that is near, wall that neighbours share, distance of walls with doors that is near, m."""
ASIDE, MIDDLE = 0.15, 0.2
"""Half extents of the home that a room's middle lies off its middle at a side, and at most in the centre."""


@inner
def gap(a: Floats, b: Floats) -> float:
    # distance between two rooms' bounding boxes, Manhattan
    total = 0.0
    for low, high in ((R_X0, R_X1), (R_Y0, R_Y1)):
        total += max(0.0, max(a[low], b[low]) - min(a[high], b[high]))
    return total


@inner
def _shared(p: Problem, z: Scratch, r: int, o: int) -> float:
    # longest straight wall between two rooms
    longest, i = 0.0, z.last[r]
    while i >= 0:
        a, j = z.piece[i], z.last[o]
        while j >= 0:
            b = z.piece[j]
            x, y = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
            if x >= -EPS and y >= -EPS:
                longest = max(longest, max(x, y))
            j = z.before[j]
        i = z.before[i]
    return longest


@inner
def _placed(room: Floats, box: Floats, axis: int, along: float) -> float:
    # how far a room is from a side of the home, in half extents of it
    half, middle = 0.5 * (box[axis + 2] - box[axis]), 0.5 * (box[axis + 2] + box[axis])
    lo, hi = room[R_X0 + axis], room[R_X0 + axis + 2]
    off = along * (0.5 * (lo + hi) - middle) / half
    gap = (box[axis + 2] - hi if along > 0 else lo - box[axis]) / half
    return float(max(gap, 0.0) + max(0.0, ASIDE - off))


@inner
def _off_centre(room: Floats, box: Floats, axis: int) -> float:
    half, middle = 0.5 * (box[axis + 2] - box[axis]), 0.5 * (box[axis + 2] + box[axis])
    return float(max(0.0, abs(0.5 * (room[R_X0 + axis] + room[R_X0 + axis + 2]) - middle) / half - MIDDLE))


@inner
def _beside(a: Floats, b: Floats, axis: int, along: float) -> float:
    # metres that room `a` lacks of lying in a direction of room `b`
    away = along * 0.5 * (a[R_X0 + axis] + a[R_X0 + axis + 2] - b[R_X0 + axis] - b[R_X0 + axis + 2])
    half = 0.25 * (a[R_X0 + axis + 2] - a[R_X0 + axis] + b[R_X0 + axis + 2] - b[R_X0 + axis])
    return float(max(0.0, half - away))


@inner
def _from_entrance(room: Floats, entry: Floats) -> float:
    # Manhattan
    x = max(0.0, room[R_X0] - entry[0], entry[0] - room[R_X1])
    return float(x + max(0.0, room[R_Y0] - entry[1], entry[1] - room[R_Y1]))


@inner
def _lengths(p: Problem, room: Floats, a: float, b: float) -> float:
    # metres that a room's extents differ from two lengths, either way round
    w, h = room[R_X1] - room[R_X0] - p.limits[L_WALL], room[R_Y1] - room[R_Y0] - p.limits[L_WALL]
    return float(min(abs(w - a) + abs(h - b), abs(w - b) + abs(h - a)))


@inner
def _served(a: Floats, b: Floats) -> float:
    # least distance between two walls of links, Manhattan
    x = abs(a[1] - b[1]) - 0.5 * (a[3] + b[3])
    y = abs(a[2] - b[2]) - 0.5 * (a[0] * (a[3] < EPS) + b[0] * (b[3] < EPS))
    return float(max(0.0, x) + max(0.0, y))


@inner
def _limited(p: Problem, room: Floats, long: bool, at_most: float, at_least: float) -> float:
    # metres that a room's length or width is beyond a limit
    extent = max(room[R_X1] - room[R_X0], room[R_Y1] - room[R_Y0]) - p.limits[L_WALL]
    wide, least = (extent, extent) if long else (room[R_WIDTH], room[R_LEAST])
    return float(max(0.0, wide - at_most, at_least - least))


@inner
def _sized(area: float, at_most: float, at_least: float) -> float:
    # part by which an area is beyond a limit
    return float(max(0.0, area / at_most - 1, 1 - area / at_least if at_least > 0 else 0.0))


@inner
def wished(p: Problem, z: Scratch, box: Floats) -> float:
    """What the state in `z` lacks of the wishes, `box` being the home's."""
    total = 0.0
    for k in range(p.wishes.shape[0]):
        wish = p.wishes[k]
        kind, r, o = int(wish[0]), int(wish[1]), int(wish[2])
        room, x, y, lack = z.room[r], wish[3], wish[4], 0.0
        if kind == PLACE:
            lack += _placed(room, box, 0, x) if x != 0.0 else 0.0
            lack += _placed(room, box, 1, y) if y != 0.0 else 0.0
        elif kind == CENTRE:
            lack = _off_centre(room, box, 0) + _off_centre(room, box, 1)
        elif kind == BESIDE:
            lack += _beside(room, z.room[o], 0, x) if x != 0.0 else 0.0
            lack += _beside(room, z.room[o], 1, y) if y != 0.0 else 0.0
        elif kind == NEAR_ENTRANCE:
            lack = max(0.0, _from_entrance(room, z.entry) - REACH)
        elif kind == FAR_FROM_ENTRANCE:
            far = 0.35 * (box[2] - box[0] + box[3] - box[1])
            lack = max(0.0, far - _from_entrance(room, z.entry))
        elif kind == ADJACENT:
            lack = max(0.0, WALL - _shared(p, z, r, o)) + gap(room, z.room[o])
        elif kind == APART:
            lack = min(_shared(p, z, r, o), 2.0)
        elif kind == LENGTHS:
            lack = _lengths(p, room, x, y)
        elif kind == SERVING:
            lack = max(0.0, _served(z.wall[int(x)], z.wall[int(y)]) - CARRIED)
        elif kind == SIZE:
            lack = _sized(room[R_AREA], x, y)
        else:
            lack = _limited(p, room, kind == LONG, x, y)
        total += wish[5] * lack
    return total
