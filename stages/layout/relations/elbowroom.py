"""Floor that the use of something takes: a chair is drawn back, one stands before shelves and drawers, two walk round
the bed that they share; nobody gets to a window over the head of a bed."""

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.relations.company import Seen
from apartgen.stages.layout.relations.distances import ahead
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.space.boxes import Boxes, stand_in
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

BACK, BEFORE = 0.46, 0.45
"""Behind a chair, .81 from its table (NKBA planning guideline 8), and before what is used from its front, m."""
COOKING = 1.13
"""Behind a chair before a kitchen's units, m: one cooks in .9 behind who sits .55 from the table."""
COOKED_AT = kinds.RUN - kinds.CLOSED
CORRIDOR, PASSAGE = 1.9, 0.86
"""What is no wider, from wall to wall, one walks through, and needs so much for it beside what stands there, m: .8 is
left."""
TURN = 0.8
"""From what has a front to the corner of a wall round which one walks beside it, m."""
SHARE = 0.8
"""Of the width that has to be free."""
LOW, HIGH = 0.05, 0.9
"""Between these heights, m: what lies flat or hangs above takes nothing."""
SHALLOW = 0.06
"""So deep in it something is no hindrance yet, m."""
ROUND, ALONG, PILLOWS = 0.66, 0.6, 0.6
"""Beyond the foot of a bed of two, and along its sides but for so much of them at its head, m: .6 and .54 are left."""
HEAD, SILL = 0.35, 0.3
"""A window is behind the head of a bed that is no farther from it and has so much of it behind, m."""
MOVED = kinds.MOVED - {"armchair"} | kinds.CHAIRS | kinds.SMALL_SEATS
"""What one pushes aside; what is slender only to draw a chair back. Nobody moves an armchair for either."""
CASES = kinds.CASES | {"dressing_table"}
PLANT = "plant"
"""What stands in the way of one half of a sliding wardrobe, too."""
SPARED = CASES - kinds.WARDROBES | {"bench", "armchair", PLANT}
"""What is rather left out than put where it takes such floor."""
RADIATOR, WARM = "radiator", 0.12
"""What hangs so low that two who share a bed walk past it, and no bed stands so near, m."""
SEATS = kinds.CHAIRS - {"balcony_chair"}
USED = SEATS | CASES | {"bench"} | kinds.DOUBLE
Flags = NDArray[np.bool_]


def taken(name: str, boxes: Array, names: Sequence[str], there: Array, space: Space) -> Flags:
    """Which candidates (n, 7) lack floor for their use among what stands there (m, 7), or take that of the others."""
    kind, found = kinds.basic(name), np.zeros(len(boxes), bool)
    if kind not in kinds.ON_THE_FLOOR:
        return found
    if kind in kinds.BEDS:
        found |= _at_window(boxes, space) | _at_radiator(boxes, names, there)
    if kind in kinds.COATS - kinds.HANGING:
        found |= _narrows(boxes, space)
    if kind in CASES:
        found |= _at_turn(boxes, space)
    others = [kinds.basic(o) for o in names]
    if kind in USED or _own(name):
        zones = _zones(kind, boxes, space, own=_own(name))
        found |= _any_of(np.asarray(outside(zones, space) > SHALLOW), len(boxes))
        if kind in SEATS and space.doors.n:
            found |= stand_in(zones, space.doors, SHALLOW)
        units = [k for k, o in enumerate(others) if o in COOKED_AT] if kind in SEATS else []
        if units:
            found |= stand_in(_zones(kind, boxes, space, COOKING), upright(there[units]), SHALLOW)
        solid = [k for k, o in enumerate(others) if _bars(o, kind)]
        if solid:
            found |= _any_of(stand_in(zones, upright(there[solid]), SHALLOW), len(boxes))
    used = [k for k, o in enumerate(others) if (o in USED or _own(names[k])) and _bars(kind, o)]
    if used:
        share = 1.0 if kind == PLANT else SHARE
        theirs = _joined([_zones_of(names[k], there[k], space, share) for k in used])
        found |= stand_in(upright(boxes), theirs, SHALLOW)
    return found


def _zones_of(name: str, box: Array, space: Space, share: float = SHARE) -> Boxes:
    """The floor that the use of one thing takes that stands there; what was found once is kept."""
    what = "zones", name, share, box.tobytes()
    found: Boxes | None = space.known.get(what)
    return found or space.known.setdefault(
        what, _zones(kinds.basic(name), box[None], space, own=_own(name), share=share))


@cache
def _own(name: str) -> float:
    """The floor before a newcomer that its facts ask for, m."""
    return TABLE[name].stands.before if name in TABLE and TABLE[name].like else 0.0


def _any_of(zones: Flags, n: int) -> Flags:
    """Of zones (k n,) of n things, the first of each, then the second, which things have one."""
    return np.asarray(zones.reshape(-1, n).any(0)) if n else np.zeros(0, bool)


def spared(name: str, names: Sequence[str], space: Space) -> bool:
    """Whether it is rather left out than put where it takes such floor: where one comes in and nobody sleeps, where
    hooks do instead, a wardrobe, too."""
    kind, bare = kinds.basic(name), kinds.BEDS.isdisjoint(map(kinds.basic, names))
    return kind in SPARED or (kind in kinds.WARDROBES and bare and len(space.entrances) > 0)


def _at_window(boxes: Array, space: Space) -> Flags:
    """Which beds (n, 7) have their heads at a window."""
    ends = space.spans[space.window]
    if not len(ends):
        return np.zeros(len(boxes), bool)
    offset = ends[None] - boxes[:, None, None, :2]
    c, s = np.cos(boxes[:, 2])[:, None, None], np.sin(boxes[:, 2])[:, None, None]
    x, y = offset[..., 0] * c + offset[..., 1] * s, offset[..., 1] * c - offset[..., 0] * s
    half = boxes[:, None, 4] / 2
    behind = -x - boxes[:, None, None, 3] / 2
    shared = np.minimum(y.max(-1), half) - np.maximum(y.min(-1), -half)
    found = ((behind > -HEAD) & (behind < HEAD)).all(-1) & (shared > SILL)
    return np.asarray(found.any(1))


def _at_radiator(boxes: Array, names: Sequence[str], there: Array) -> Flags:
    """Which beds (n, 7) stand at what heats the room."""
    hot = there[[kinds.basic(o) == RADIATOR for o in names]] if len(names) else there[:0]
    return np.asarray((Seen(boxes, hot).gap < WARM).any(1)) if len(hot) else np.zeros(len(boxes), bool)


def _narrows(boxes: Array, space: Space) -> Flags:
    """Which things (n, 7), to be used from any side, leave too little of a corridor at either side of them."""
    one, two = upright(boxes), upright(boxes)
    two = two._replace(size=two.size[:, [1, 0, 2]], yaw=two.yaw + np.pi / 2)
    bad = np.zeros(len(boxes), bool)
    for some in (one, two):
        free = ahead(some, space), ahead(some._replace(yaw=some.yaw + np.pi), space)
        bad |= (sum(free) + some.size[:, 0] < CORRIDOR) & (np.maximum(*free) < PASSAGE - SHALLOW)
    return bad


def _at_turn(boxes: Array, space: Space) -> Flags:
    """Between which (n, 7) and the corner of a wall round which one walks there is too little floor: there is some
    before them and beside them, but not all of it between."""
    angle, side = np.linspace(0, np.pi / 2, 5)[:, None], np.array([1.0, -1.0])[:, None, None]
    x, y = boxes[:, 3] / 2 + TURN * np.cos(angle), side * (boxes[:, 4] / 2 + TURN * np.sin(angle))  # from front corners
    c, s = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    x, y = boxes[:, 0] + c * x - s * y, boxes[:, 1] + s * x + c * y
    at = np.stack(np.broadcast_arrays(x, y, HIGH), -1).reshape(-1, 3)
    points = Boxes(at.astype(float), np.zeros(at.shape), np.zeros(len(at)))
    before, *between, beside = (outside(points, space) <= SHALLOW).reshape(2, 5, -1).swapaxes(0, 1)
    return np.asarray((before & beside & ~np.all(between, axis=0)).any(0))


@cache
def _bars(kind: str, used: str) -> bool:
    """Whether one thing before or behind another is in the way of its use."""
    own = used in SEATS and kind in kinds.TABLES | kinds.DESKS
    moved = kind in MOVED and (kind not in kinds.SLENDER or used in SEATS) and kind not in kinds.COATS
    own |= used in kinds.DOUBLE and kind in kinds.BESIDE_A_BED
    hot = kind == RADIATOR and used in kinds.DOUBLE
    return hot or kind in kinds.ON_THE_FLOOR and not moved and not own


def _zones(kind: str, boxes: Array, space: Space, back: float = BACK, own: float = 0.0, share: float = SHARE) -> Boxes:
    """The floor that the use of each takes, or who passes it, in a `share` of its width; of a seat so much at its
    `back`, before others as much as is their `own`, m."""
    if kind in kinds.DOUBLE:
        return _about_bed(boxes)
    far = np.full(len(boxes), -back if kind in SEATS else own or (BEFORE if kind in CASES else 0.0))
    if kind not in SEATS:
        narrow = boxes[:, 3] + ahead(upright(boxes), space) < CORRIDOR
        far = np.where(narrow, max(PASSAGE, own), far)
    away = np.where(far < 0, -1, 1) * boxes[:, 3] / 2 + far / 2
    c, s = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    center = np.column_stack([boxes[:, 0] + c * away, boxes[:, 1] + s * away, np.full(len(boxes), (LOW + HIGH) / 2)])
    size = np.column_stack([np.abs(far), share * boxes[:, 4], np.full(len(boxes), HIGH - LOW)])
    return Boxes(np.asarray(center, float), np.asarray(size, float), np.asarray(boxes[:, 2], float))


def _about_bed(boxes: Array) -> Boxes:
    """Beyond the foot of each, and along both its sides, (3 n,)."""
    center, size, yaw = [], [], np.asarray(boxes[:, 2], float)
    c, s = np.cos(yaw), np.sin(yaw)
    long, half, n = boxes[:, 3] - PILLOWS, boxes[:, 4] / 2, len(boxes)
    for x, y, deep, wide in (
            ((boxes[:, 3] + ROUND) / 2, np.zeros(n), np.full(n, ROUND), SHARE * boxes[:, 4]),
            (np.full(n, PILLOWS / 2), half + ALONG / 2, SHARE * long, np.full(n, ALONG)),
            (np.full(n, PILLOWS / 2), -half - ALONG / 2, SHARE * long, np.full(n, ALONG))):
        center.append(np.column_stack([boxes[:, 0] + c * x - s * y, boxes[:, 1] + s * x + c * y,
                                       np.full(n, (LOW + HIGH) / 2)]))
        size.append(np.column_stack([deep, wide, np.full(n, HIGH - LOW)]))
    return Boxes(np.concatenate(center).astype(float), np.concatenate(size).astype(float), np.tile(yaw, 3))


def _joined(some: Sequence[Boxes]) -> Boxes:
    center, size, yaw = zip(*((one.center, one.size, one.yaw) for one in some), strict=True)
    return Boxes(np.concatenate(center), np.concatenate(size), np.concatenate(yaw))
