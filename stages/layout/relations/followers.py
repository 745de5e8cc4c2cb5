"""What follows a leader of a group: no table or desk is put where its chairs, no bed where its nightstands or the
wardrobe of those who sleep there, no sofa where its low table or the television before it would find no place, or would
shut a way."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations import elbowroom, facing, gathered
from apartgen.stages.layout.relations.places import (
    OFF,
    Place,
    Size,
    about,
    all_over,
    along,
    likeliest,
    resized,
)
from apartgen.stages.layout.relations.standing import BEHIND, BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

CHAIR, STAND, SEAT, LOW = "chair", "nightstand", "office_chair", "coffee_table"
ELBOW = 0.6
"""Of a table's edge each diner has, m."""
IN, LESS_IN, WIDE = 0.12, 0.05, 0.58
"""How far a chair is drawn under its table, under a round one at which six sit, and the least radius of that, m."""
ASIDE = 0.05
"""From a nightstand to its bed, m."""
BEFORE = 0.36
"""From a sofa's front to its low table, m."""
BEFORE_CHAISE, TO_SEATS = 0.21, (0.28, 0.0, -0.28)
"""The same from a chaise, and how far from the middle of it all towards the other seats, within .3, m."""
MOST = 0.3
"""What a group may cut off of the floor, in metres of way."""

ROUND = "round_table"
FEW, DRAWN = 6, (0.78, 0.55)
"""More chairs than so many stand at the ends of a table, too; each, drawn back or squeezed in, takes so much beyond its
edge, m."""

LEADERS = ((kinds.TABLES, CHAIR), (kinds.DOUBLE, STAND), ({"desk"}, SEAT), (kinds.SOFAS, LOW))
SEATED = kinds.SOFAS | {gathered.SEAT}
"""What leaves a table that is still to come its place."""
TINY, BOTH = 1e-6, 2
"""Two who share a bed get out at either side, whether or not nightstands are to come."""
LATER = (
    (kinds.DOUBLE, kinds.WARDROBES, (0.6, 1.2, 2.1)),
    (kinds.BEDS - kinds.DOUBLE, kinds.WARDROBES, (0.6, 0.8, 2.1)),
    (kinds.SOFAS, {"tv_stand"}, (0.4, 1.2, 0.5)),
    (kinds.TABLES, kinds.WARDROBES, (0.6, 1.2, 2.1)),
)
"""What comes to some wall later on: a place for one of such a size, m, is left."""
COMPACT = (2.03, 1.62)
"""A bed for a mattress of 1.6 by 2 m, m."""
SCREEN, ENOUGH, NARROWER, PAST = "tv_stand", 1.2, 0.1, BEHIND - 0.02
"""What a television stands on, how narrow it is made where its wall ends, in which steps, and so far past its ends a
wall is no farther from its back than `BEHIND` where it ends with it, m."""
SELDOM, SEAT_WIDE = 0.02, 0.42
"""Weight of a place for a table where its chairs could not all be drawn back, of that width, m."""
TRIED = 3
"""So many of the good places of what comes later on are tried for the ways they leave."""


def fit(there: Furniture, name: str, box: Array, left: Sequence[str]) -> float:
    """Of as many followers as are `left` to come and have places about a leader (7,), which share finds one, a chair
    that can't be drawn back, or one of two round a corner, being half of one; for a chair, how good it is for the other
    one of two; a quarter of that where a wardrobe, the television or the table, which come later on, find none; half of
    it where one of two in a bed gets out over the other."""
    kind, group = kinds.basic(name), [(name, box)]
    if kind == CHAIR:
        return facing.company(there, name, box, left)
    follower = next((name for leaders, name in LEADERS if kind in leaders), "")
    narrow, due, worse = False, max(left.count(follower), BOTH if follower == STAND else 0), 0
    if due:
        places = about(box, PLACES[follower](kind, box, TABLE[follower].size), TABLE[follower].size)
        good = there.besides(name, box).prices(follower, places, strict=follower == CHAIR) < BROKEN
        open_, due = places[good], min(due, len(places))
        narrow = follower == STAND and len(open_) < BOTH
        if follower == CHAIR and len(open_) < due:
            some = places[~good]
            some = some[there.besides(name, box).prices(follower, some) < BROKEN]
            worse = min(len(some), due - len(open_))
            open_ = np.concatenate([open_, some])
        elif follower == CHAIR and due == facing.TWO:
            open_, good_for = facing.best_two(box, open_)
            worse += good_for < facing.BESIDE
        group += [(follower, place) for place in open_[:due]]
    later = _later(there, kind, group, left)
    while len(group) > 1 and there.shut_by(group) >= MOST:
        fewer = (group[:k] + group[k + 1 :] for k in reversed(range(1, len(group))))
        group = next((some for some in fewer if there.shut_by(some) < MOST), group[:-1])
    share = max(len(group) - 1 - worse / 2, 0) / due * (0.5 if narrow else 1.0) if due else 1.0
    fine = later is None or any(there.shut_by([*group, one]) < MOST for one in later)
    return share * (_table_left(there, group, left) if kind in SEATED else 1.0) if fine else share / 4


def _later(there: Furniture, kind: str, group: list[tuple[str, Array]],
           left: Sequence[str]) -> list[tuple[str, Array]] | None:
    """Some places at walls of what comes there later on beside a group; None where nothing does."""
    due = ((name, size) for leaders, names, size in LATER if kind in leaders for name in left
           if kinds.basic(name) in names and not names & set(map(kinds.basic, there.names)))
    name, size = next(due, ("", (0.0, 0.0, 0.0)))
    if not name:
        return None
    for o, box in group:
        there = there.besides(o, box)
    places = along(there.space, size)
    good = places[there.prices(name, places, strict=True) < BROKEN] if len(places) else places
    return [(name, place) for place in good[:: max(1, len(good) // TRIED)]]


def _table_left(there: Furniture, group: list[tuple[str, Array]], left: Sequence[str]) -> float:
    """Whether a table that is still to come finds a place with its chairs beside a group: 1 if these are drawn back
    there, or would not be without an armchair either, a half if one squeezes in, a quarter if not."""
    name, chairs = next((o for o in left if kinds.basic(o) in kinds.TABLES), ""), left.count(CHAIR)
    if not name or not chairs:
        return 1.0
    before, best, ends = there, 1.0, 2 * (chairs > FEW)
    for o, box in group:
        there = there.besides(o, box)
    wide, (depth, _, height) = max(ELBOW * -(-(chairs - ends) // 2), TABLE[name].min[1]), TABLE[name].size
    for share, drawn in zip((1.0, 0.5), DRAWN, strict=True):
        places = all_over(there.space, (depth + 2 * drawn, wide + ends * drawn, height))
        if (there.prices(name, places, strict=True) < BROKEN).any():
            return share / best
        if kinds.basic(group[0][0]) == gathered.SEAT and (before.prices(name, places, strict=True) >= BROKEN).all():
            best = 0.5
    return 0.25


def likely(there: Furniture, name: str, places: Array, left: Sequence[str]) -> Array:
    """Weights (n,) of places for what leads a group: those of a table first about which all its chairs can be drawn
    back, so that few others are looked at in vain."""
    weight, chairs, kind = np.ones(len(places)), left.count(CHAIR), kinds.basic(name)
    if kind not in kinds.TABLES or not chairs or not len(places):
        return weight
    round_, width = kind == ROUND, float(places[0, 4])
    across, along_ = places.copy(), places.copy()
    across[:, 3] += 2 * DRAWN[0]
    across[:, 4] = SEAT_WIDE if round_ else width
    along_[:, 3], along_[:, 4] = SEAT_WIDE, width + 2 * DRAWN[0]
    ends = chairs > (2 if round_ else 2 * int((width + TINY) / ELBOW))
    for whole in (across, along_) if ends else (across,):
        weight[there.prices(name, whole, strict=True) >= BROKEN] = SELDOM
    return weight


def leading(name: str, boxes: Array, space: Space, least: float = 0.0) -> Array:
    """Places (m, 7) all over the room for what others follow: beds, sofas, wardrobes along all walls, tables anywhere
    square to these, in the likeliest size of the candidates (n, 7), and as narrow as is enough for wardrobes, and as
    short and narrow as beds of two are."""
    kind = kinds.basic(name)
    if kind in kinds.TABLES:
        return all_over(space, likeliest(boxes))
    if kind not in kinds.BEDS | kinds.WARDROBES | kinds.SOFAS:
        return boxes[:0]
    depth, width, height = likeliest(boxes)
    sizes = [(depth, width), *([(depth, least)] if kind in kinds.WARDROBES and 0 < least < width else [])]
    if kind in kinds.DOUBLE and (depth > COMPACT[0] or width > COMPACT[1]):
        sizes.append((min(depth, COMPACT[0]), min(width, COMPACT[1])))
    return np.concatenate([along(space, (deep, wide, height)) for deep, wide in sizes])


def at_ease(there: Furniture, name: str, box: Array, rng: np.random.Generator) -> Array:
    """A place (7,) as people leave it: no bed longer than there is floor for, no screen past the corner of its wall,
    most armchairs askew."""
    return facing.askew(there, name, backed(name, snug(name, box, there), there.space), rng)


def snug(name: str, box: Array, there: Furniture) -> Array:
    """A bed of two no longer and wider than its mattress, its head where it was, where it leaves too little floor
    about it; all else as it is."""
    if kinds.basic(name) not in kinds.DOUBLE or not elbowroom.taken(
            name, box[None], there.names, there.boxes, there.space)[0]:
        return box
    found = box.copy()
    found[3:5] = np.minimum(box[3:5], COMPACT)
    found[:2] -= (box[3] - found[3]) / 2 * np.array([np.cos(box[2]), np.sin(box[2])])
    return found


def backed(name: str, box: Array, space: Space) -> Array:
    """What a television stands on as wide as the wall behind it, down to a width that is enough; all else as it is."""
    if kinds.basic(name) != SCREEN:
        return box
    widths = np.arange(float(box[4]), ENOUGH - TINY, -NARROWER)
    tries = np.array([resized(box, float(box[3]), wide, side) for wide in widths for side in (0.0, 1.0, -1.0)])
    if not len(tries):
        return box
    found, half = upright(tries), tries[:, 4].astype(float) / 2 + PAST
    good = np.maximum(space.behind(found, half), space.behind(found, -half)) <= BEHIND
    return np.asarray(tries[good.argmax()] if good.any() else box)


def known(name: str, boxes: Array, names: Sequence[str], there: Array) -> Array:
    """Places (m, 7) of what follows something that stands there, as large as another one of its name or as candidates
    (n, 7) are: exact, so that a seat at a table is not missed for want of a candidate."""
    if kinds.basic(name) == gathered.SEAT:
        return gathered.places(names, there, likeliest(there[[names.index(name)]] if name in names else boxes))
    rows = [(o, box) for o, box in zip(names, there, strict=True)
            if any(follower == kinds.basic(name) and kinds.basic(o) in leaders for leaders, follower in LEADERS)]
    if not rows:
        return boxes[:0]
    size = likeliest(there[[names.index(name)]] if name in names else boxes)
    places = PLACES[kinds.basic(name)]
    return np.concatenate([about(box, places(kinds.basic(o), box, size), size) for o, box in rows])


def _chairs(kind: str, table: Array, size: Size) -> list[Place]:
    """Places of chairs, those across from one another in turn: at the long sides first, or all round."""
    far, (d, w) = size[0] / 2 - IN, table[3:5].astype(float) / 2
    if kind == ROUND:
        return _round(min(d, w) + far, 2) if min(d, w) < WIDE else _round(min(d, w) + size[0] / 2 - LESS_IN, 3)
    many = max(1, int((2 * w + TINY) / ELBOW))
    along = (np.arange(many) - (many - 1) / 2) * 2 * w / many
    out = [(s * (d + far), float(y), (s > 0) * np.pi) for y in along for s in (1.0, -1.0)]
    return out + [(0.0, s * (w + far), -s * np.pi / 2) for s in (1.0, -1.0)]


def _round(far: float, pairs: int) -> list[Place]:
    turns = [k * np.pi / pairs + half for k in range(pairs) for half in (0.0, np.pi)]
    return [(far * float(np.cos(turn)), far * float(np.sin(turn)), turn + np.pi) for turn in turns]


def stands(kind: str, bed: Array, size: Size) -> list[Place]:
    """At either side of a bed's head."""
    back, aside = OFF + (size[0] - float(bed[3])) / 2, float(bed[4]) / 2 + ASIDE + size[1] / 2
    return [(back, s * aside, 0.0) for s in (1.0, -1.0)]


def _seat(kind: str, desk: Array, size: Size) -> list[Place]:
    return [((float(desk[3]) + size[0]) / 2 - IN, 0.0, np.pi)]


def _low_table(kind: str, sofa: Array, size: Size) -> list[Place]:
    far = (float(sofa[3]) + size[0]) / 2
    if kind == "corner_sofa":
        return [(far + BEFORE_CHAISE, -aside, 0.0) for aside in TO_SEATS]
    return [(far + BEFORE, 0.0, 0.0)]


PLACES = {CHAIR: _chairs, STAND: stands, SEAT: _seat, LOW: _low_table}
