"""What stands where it is at hand: coats and shoes near the entrance, towels where one washes, bins where one prepares
or washes, lamps at walls beside seats or on tables, mirrors at walls.

Places that are known without the model, and prices of others.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.relations import hung
from apartgen.stages.layout.relations.company import Seen
from apartgen.stages.layout.relations.fixtures import BIN, RAIL, THROWN, within
from apartgen.stages.layout.relations.hung import MIRROR
from apartgen.stages.layout.relations.places import Size, about, along, at_walls, likeliest
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

ARRIVAL, NEAR = {"coat_rack": 1.8, "shoe_cabinet": 3.0, "bench": 3.0}, 3.0
"""What one uses coming home, and how far from the entrance's middle at most at the first looks; where more is looked
for, m."""
SLIM, NARROW = 0.34, {"shoe_cabinet": (0.2, 0.6), "bench": (0.34, 0.75)}
"""A coat rack for a narrow hall, and other such things, depth and width, m, which are rather left out than put
farther from the entrance."""
WASHING, AT_HAND = frozenset({"shower", "bath", "vanity"}), 0.7
"""Where one washes, and how far from it a towel is, m."""
PREPARING, BESIDE = 0.75, 0.1
"""How far at most from the sink waste is thrown away, m, or else beside a unit of the run."""
LAMP, READING, AT_WALL = "floor_lamp", 0.65, 0.2
"""How far at most from a seat, a bed or a desk a lamp stands, and from a wall (as three in four of people's), m."""
LIT = kinds.EASY | kinds.BEDS | kinds.DESKS
STRAY = 0.5
"""What is slender has a wall within so much of it, m: one walks where there is none."""
READ, LANDING, ENDS = "table_lamp", {"microwave": 0.3}, 0.05
"""What one reads by in bed; what leaves so much worktop beside what cooks (NKBA kitchen guideline 17) and no window
behind it, or is left out, m; and how near the ends of a top it may stand."""
BARRED, CRAMPED, AWAY, ALONE = 20.0, 6.0, 4.0, 8.0
"""Prices: of what is not at hand, as long as there may be a place for it that is, and once nothing better was found, of
what stands on the way, and far from its use; of coats for each metre, up to so much."""
BACK = 0.1
"""So near behind a bench or a shoe cabinet is a wall, m."""
OFF = 0.02
"""Between a bin and the unit beside it, m."""
Flags = NDArray[np.bool_]


def places(name: str, boxes: Array, names: Sequence[str], there: Array, space: Space) -> Array:
    """Places (m, 7) at hand, in the likeliest size of the candidates (n, 7)."""
    kind = kinds.basic(name)
    if name in ARRIVAL and len(space.entrances):
        depth, width, height = likeliest(boxes)
        least = NARROW.get(name, (SLIM, SLIM))
        sizes = dict.fromkeys([(depth, width, height), (min(depth, least[0]), min(width, least[1]), height)])
        found = np.concatenate([along(space, size) for size in sizes])
        return np.asarray(found[space.from_entrance(found[:, :2].astype(float)) < NEAR])
    if TABLE[name].place == "top":
        return _on(_of(frozenset(TABLE[name].belongs), names, there), likeliest(boxes), name in LANDING)
    if name == MIRROR and set(TABLE[name].belongs).isdisjoint(names):
        return at_walls(boxes, space)
    if name == RAIL and (some := _of(WASHING, names, there)).size:
        found = at_walls(boxes, space)
        return np.asarray(found[(Seen(found, some).gap < AT_HAND).any(1)])
    if kind == BIN and _of(kinds.WET, names, there).size:
        size = likeliest(boxes)
        found = np.concatenate([*(_beside(unit, size) for unit in _of(kinds.RUN, names, there)), along(space, size)])
        return np.asarray(found[_for_waste(found, names, there)])
    if kind == BIN and not THROWN.keys().isdisjoint(names):
        found = along(space, likeliest(boxes))
        return np.asarray(found[within(THROWN, upright(found), names, upright(there))])
    if kind == LAMP and (some := _of(LIT, names, there)).size:
        found = along(space, likeliest(boxes))
        return np.asarray(found[(Seen(found, some).gap < READING).any(1)])
    return boxes[:0]


def _on(hosts: Array, size: Size, ends: bool) -> Array:
    """In the middle of each top, or also at its ends, (k, 7)."""
    far = np.maximum((hosts[:, 4] - size[1]) / 2 - ENDS, 0.0)
    aside = np.concatenate([0 * far, far, -far]) if ends else 0 * far
    hosts = np.tile(hosts, (3 if ends else 1, 1))
    xy = hosts[:, :2] + aside[:, None] * np.stack([-np.sin(hosts[:, 2]), np.cos(hosts[:, 2])], -1)
    rest = np.broadcast_to(size[:2], (len(hosts), 2))
    return np.column_stack([xy, hosts[:, 2], rest, hosts[:, 6], hosts[:, 6] + size[2]]).astype(np.float32)


def _beside(unit: Array, size: Size) -> Array:
    """At both sides of a unit, (2, 7), backs in line."""
    back, aside = (size[0] - float(unit[3])) / 2, (size[1] + float(unit[4])) / 2 + OFF
    return about(unit, [(back, aside, 0.0), (back, -aside, 0.0)], size)


def price(name: str, boxes: Array, found: Boxes, names: Sequence[str], there: Array, space: Space,
          strict: bool, loose: bool) -> Array:
    """Of candidates (n, 7), `found` the same, beside what stands there (m, 7): of what is not at hand, (n,). A bin is
    rather left out, as it goes below the sink, too, unless it is needed: then one is `loose`."""
    total, kind = np.zeros(len(boxes)), kinds.basic(name)
    if kind in kinds.SLENDER:
        total += np.where(_wall_within(found, STRAY, space), 0.0, CRAMPED)
    if name in ARRIVAL and len(space.entrances):
        away = space.from_entrance(found.center[:, :2]) - ARRIVAL[name]
        if name in NARROW:
            away = np.where(_wall_behind(found, space), away, np.maximum(away, ALONE))
        if strict or name in NARROW and not loose and (kinds.TABLES | kinds.BEDS).isdisjoint(map(kinds.basic, names)):
            return np.asarray(total + np.where(away > 0, BARRED, 0.0))
        return np.asarray(total + np.clip(AWAY * away, 0.0, ALONE))
    far: Flags = np.zeros(len(boxes), bool)
    if kind == BIN and _of(kinds.WET, names, there).size:
        far = ~_for_waste(boxes, names, there)
    if kind == LAMP:
        lit = _of(LIT, names, there)
        far = ~_wall_within(found, AT_WALL, space)
        far |= (Seen(boxes, lit).gap > READING).all(1) if lit.size else False
    if kind == READ and (unlit := _unlit(names, there)).size:
        far = ~_above(boxes, unlit)
    if kind in LANDING and (hot := _of(kinds.HOT, names, there)).size:
        far = np.asarray((Seen(boxes, hot).gap < LANDING[kind]).any(1)) | hung.lit(boxes, space)
    spared = (kind == BIN or kind in LANDING) and not loose
    away = np.where(far, BARRED if strict or spared else AWAY, 0.0)
    return np.maximum(total, away) if kind == LAMP else total + away


def _of(some: frozenset[str], names: Sequence[str], there: Array) -> Array:
    """Boxes (k, 7) of some kinds."""
    return there[[kinds.basic(o) in some for o in names]] if len(names) else there[:0]


def _unlit(names: Sequence[str], there: Array) -> Array:
    """Tops (k, 7) beside beds that carry no lamp yet."""
    lamps = _of(frozenset({READ}), names, there)
    tops = _of(kinds.BEDSIDE, names, there) if not kinds.BEDS.isdisjoint(map(kinds.basic, names)) else there[:0]
    return tops[[not _above(lamps, top[None]).any() for top in tops]] if len(tops) else tops


def _above(boxes: Array, tops: Array) -> Flags:
    """Which boxes (n, 7) have their middles above one of some tops (k, 7), (n,)."""
    within = Seen(tops, boxes)
    return np.asarray(((np.abs(within.x) < within.half[..., 0]) & (np.abs(within.y) < within.half[..., 1])).any(0))


def _wall_within(found: Boxes, far: float, space: Space) -> Flags:
    around = found._replace(size=found.size + [2 * far, 2 * far, 0.0])
    return np.asarray(outside(around, space) > 0)


def _wall_behind(found: Boxes, space: Space) -> Flags:
    """Which have a wall right behind their backs."""
    back = np.stack([np.cos(found.yaw), np.sin(found.yaw), np.zeros(found.n)], 1) * (BACK / 2)
    further = found._replace(center=found.center - back, size=found.size + [BACK, 0.0, 0.0])
    return np.asarray(outside(further, space) > 0)


def _for_waste(boxes: Array, names: Sequence[str], there: Array) -> Flags:
    """Which bins (n, 7) are near a sink, or beside a unit of its run, not before it."""
    units = Seen(boxes, _of(kinds.RUN, names, there))
    beside = (units.gap < BESIDE) & (units.to[..., 0] <= units.host[..., 0])
    return np.asarray((Seen(boxes, _of(kinds.WET, names, there)).gap <= PREPARING).any(1) | beside.any(1))
