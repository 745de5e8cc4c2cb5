"""What is used with something stands where it is used with it: a chair at its table, a nightstand at the head of its
bed, a coffee table before the sofa, the sofa before the television."""

from collections.abc import Callable, Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.mutual import mutual
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.use import kinds

LOOKS, WATCHES, SHOWN = np.radians(32), np.radians(18), np.radians(35)
"""Within these angles one sits at a table, watches a screen, and is a screen seen."""
FAR, FARTHEST, ASKANCE = 3.5, 4.0, np.radians(30)
"""A television stands no farther from its sofa, m; if need be, it does, and so far aside."""
TURNED, STRANDED = np.radians(68), 1.6
"""An armchair looks at a sofa within this angle, and stands no farther from it, m."""
AROUND, BY, SIGHT, EDGE_ON = np.radians(50), 0.8, np.radians(75), np.radians(70)
"""The same of the low table before the sofa, if there is one; from an armchair one sees a screen within the third, and
from no farther aside of it than the last."""
FROM_SCREEN = 0.35
"""Between an armchair and what the television stands on, m."""
PAIR, WITHIN_REACH, BESIDE_IT = 1.2, 0.65, 0.3
"""A seat so wide is for two, m; so near is the low table then at most, and so far aside of its middle."""
BEHIND, BACK_TO = np.radians(120), 0.6
"""Farther aside a dining table is behind who sits in an armchair, and so far from it at least, m."""
AT, AT_DESK, REACH, NEAR = 0.28, 0.4, 0.4, 0.55
"""So far at most from its table a chair stands, from a desk, a side table from its seat, a stool from its use, m."""
HEAD, BESIDE = 0.7, (-0.08, 0.3)
"""A nightstand's middle is so far from the head of its bed at most, and its side so far from the bed's, m."""
BEFORE, INSIDE, OVER = 1.0, 0.15, 0.35
"""A low table begins so far before a seat at most, or so deep in it, and covers such a share of its width."""
BEFORE_CHAISE = 0.25
"""The same before a chaise, from behind which one reaches it, m."""
AGAINST = 0.36
"""Between a dining table and a sofa or a low table one passes, m."""
AHEAD = (0.05, 0.5)
"""So far before a sofa nothing stands that is no low table, m."""
LEGS, ARM = 0.6, 0.08
"""So far before a seat are legs, and at either side is no seat but its arm, m."""
KNEES, ARMS = 0.25, 0.15
"""Between an armchair and a low table there are knees, between two armchairs hands, m."""
USED_AT = kinds.EASY | kinds.BEDS | kinds.DESKS | kinds.TABLE_TOPS | {"coffee_table"}
"""Where small seats are used."""
Flags = NDArray[np.bool_]
Judge = Callable[["Seen", Sequence[str]], Flags]


class Seen:
    """Candidates (n, 7) and what stands there (m, 7) in one another's frames, (n, m): partners in the candidate's."""

    def __init__(self, boxes: Array, there: Array) -> None:
        one, two = np.asarray(boxes, float), np.asarray(there, float)
        self.at, self.to, self.extent, self.own, self.gap = mutual(one, two)
        self.sizes = one[:, None, 3:5], two[None, :, 3:5]

    def back(self) -> "Seen":
        """The same the other way round: candidates in the frames of what stands there."""
        other = object.__new__(Seen)
        other.at, other.to, other.extent, other.own, other.gap = self.to, self.at, self.own, self.extent, self.gap
        other.sizes = self.sizes[1], self.sizes[0]
        return other

    @property
    def x(self) -> Array:
        """How far ahead of a candidate what stands there is, (n, m)."""
        return self.at[..., 0]

    @property
    def y(self) -> Array:
        """How far to the left of it, (n, m)."""
        return self.at[..., 1]

    @property
    def half(self) -> NDArray[np.float64]:
        """Half extents of candidates, (n, 1, 2), or of what stands there the other way round."""
        return np.asarray(self.sizes[0] / 2)

    @property
    def host(self) -> Array:
        """Half extents of what stands there, (1, m, 2), or of candidates the other way round."""
        return np.asarray(self.sizes[1] / 2)

    @property
    def off(self) -> Array:
        """Angle between a candidate's front and the middle of what stands there, (n, m)."""
        return np.abs(np.arctan2(self.y, self.x))

    def looks_at(self) -> Flags:
        """Whether the nearest bit of what stands there lies ahead of the candidate's middle."""
        (x, y), (along, across) = (self.x, self.y), np.moveaxis(self.extent, -1, 0)
        x, y = np.clip(0, x - along, x + along), np.clip(0, y - across, y + across)
        inside = (x == 0) & (y == 0)
        return np.asarray(np.where(inside, self.off, np.abs(np.arctan2(y, x))) <= LOOKS)

    def before(self, inside: Array, reach: Array) -> Flags:
        """Whether what stands there lies across the candidate's front, its near edge within reach, m."""
        near = self.x - self.extent[..., 0] - self.half[..., 0]
        wide = np.minimum(self.extent[..., 1], self.half[..., 1])
        shared = np.minimum(self.y + self.extent[..., 1], self.half[..., 1]) - np.maximum(
            self.y - self.extent[..., 1], -self.half[..., 1])
        return np.asarray((near > -inside) & (near < reach) & (shared > OVER * 2 * wide))

    def walls_in(self) -> Flags:
        """Whether what stands there takes a tenth of the floor right before the candidate."""
        (x, y), half = np.moveaxis(self.at, -1, 0), self.half
        along, across = np.moveaxis(self.extent, -1, 0)
        low, high = (half[..., 0] + far for far in AHEAD)
        wide = 0.8 * half[..., 1]
        deep = np.minimum(x + along, high) - np.maximum(x - along, low)
        shared = np.minimum(y + across, wide) - np.maximum(y - across, -wide)
        return np.asarray(np.maximum(deep, 0) * np.maximum(shared, 0) > 0.08 * (high - low) * 2 * wide)

    def at_head(self) -> Flags:
        """Whether the candidate stands beside the head of a bed that stands there."""
        from_head = self.to[..., 0] + self.host[..., 0]
        beside = np.abs(self.to[..., 1]) - self.host[..., 1] - self.own[..., 1]
        return np.asarray((from_head < HEAD) & (beside > BESIDE[0]) & (beside < BESIDE[1]))


def alone(name: str, boxes: Array, names: Sequence[str], there: Array) -> Flags:
    """Which candidates (n, 7) could not be used with what stands there (m, 7), or keep it from being used."""
    led, rules = _of_kind(kinds.basic(name))
    others = [kinds.basic(o) for o in names] if led or rules else []
    found = np.full(len(boxes), any(partners.isdisjoint(others) for partners in led))
    for partners, wanted in rules:
        if some := [k for k, o in enumerate(others) if o in partners]:
            found |= ~wanted(Seen(boxes, there[some]), [others[k] for k in some])
    return found


@cache
def _of_kind(kind: str) -> tuple[list[frozenset[str]], list[tuple[frozenset[str], Judge]]]:
    """Without which a kind is of no use, and who judges its place by what."""
    return ([partners for mine, partners in LED if kind in mine],
            [(partners, wanted) for mine, partners, wanted in RULES if kind in mine])


def next_of(left: Sequence[str], there: Sequence[str], anew: bool = False) -> list[str]:
    """What of what is left may come next: what only serves something waits for it as long as that is to come, what one
    can do without for the wardrobe of who sleeps there, and in a room that is begun `anew` for the bed; cupboards for
    the hooks at the entrance."""
    kinds_left, kinds_there = {kinds.basic(o) for o in left}, {kinds.basic(o) for o in there}
    sleeps = not kinds.BEDS.isdisjoint(kinds_left | kinds_there)
    rows = (*LED, *FIRST, *(DRESSED if sleeps else ()), *(AFTER if anew else ()))
    waiting = [mine for mine, partners in rows if not partners.isdisjoint(kinds_left)
               and partners.isdisjoint(kinds_there)]
    return [name for name in left if not any(kinds.basic(name) in mine for mine in waiting)] if waiting else list(left)


def follows(name: str) -> bool:
    """Whether something is of no use where nothing else stands."""
    return kinds.basic(name) in FOLLOWERS


def _any(good: Flags) -> Flags:
    return np.asarray(good.any(1))


def _at(seen: Seen, hosts: Sequence[str]) -> Flags:
    far = np.array([AT if o in kinds.TABLE_TOPS else AT_DESK for o in hosts])
    return _any((seen.gap <= far) & seen.looks_at())


def _bedside(seen: Seen, hosts: Sequence[str]) -> Flags:
    return _any(seen.at_head())


def _before_seat(seen: Seen, hosts: Sequence[str]) -> Flags:
    chaise = np.array([o == "corner_sofa" for o in hosts])
    return _any(seen.back().before(np.where(chaise, 0.9, INSIDE), np.where(chaise, BEFORE_CHAISE, BEFORE)))


def _watched(seen: Seen, hosts: Sequence[str]) -> Flags:
    """A screen is seen from every sofa, or from a bed where there is none, and by nobody from aside or afar."""
    good = (seen.back().off < WATCHES) & (seen.off < SHOWN) & (seen.gap < FAR)
    sofas = np.array([o in kinds.SOFAS for o in hosts])
    return np.asarray(good[:, sofas].all(1) if sofas.any() else good.any(1))


def _seen(seen: Seen, hosts: Sequence[str]) -> Flags:
    """A screen that is seen from a sofa at all: better than none."""
    return _any((seen.back().off < ASKANCE) & (seen.off < ASKANCE) & (seen.gap < FARTHEST))


def _watches(seen: Seen, hosts: Sequence[str]) -> Flags:
    return _any((seen.off < WATCHES) & (seen.back().off < SHOWN) & (seen.gap < FAR))


def _in_group(seen: Seen, hosts: Sequence[str]) -> Flags:
    """An armchair looks at the low table, or the sofa, and into nobody's arm or back; who shares a seat for two has the
    table right before it, and is not between the sofa and its screen."""
    low = np.array([o == "coffee_table" for o in hosts])
    shared = (seen.half[..., 1] < PAIR / 2) | (seen.gap < WITHIN_REACH) & (np.abs(seen.y) < BESIDE_IT)
    near = np.where(low, (seen.off < AROUND) & (seen.gap < BY) & shared,
                    (seen.off < TURNED) & (seen.gap < STRANDED))
    return np.asarray(near[:, low if low.any() else ~low].any(1) & ~seen.walls_in()[:, ~low].any(1))


def _in_sight(seen: Seen, hosts: Sequence[str]) -> Flags:
    """A screen that one sits no nearer to than its doors and drawers need, and not beside."""
    return _any((seen.off < SIGHT) & (seen.back().off < EDGE_ON)) & (seen.gap >= FROM_SCREEN).all(1)


def _knees(seen: Seen, hosts: Sequence[str]) -> Flags:
    return np.asarray((seen.gap >= KNEES).all(1))


def _abreast(seen: Seen, hosts: Sequence[str]) -> Flags:
    """Neither armchair is before the other, nor against it."""
    return _leaves_open(seen, hosts) & _open_before(seen, hosts) & (seen.gap >= ARMS).all(1)


def _not_behind(seen: Seen, hosts: Sequence[str]) -> Flags:
    return np.asarray(~((seen.off > BEHIND) & (seen.gap < BACK_TO)).any(1))


def _apart(seen: Seen, hosts: Sequence[str]) -> Flags:
    return np.asarray((seen.gap >= AGAINST).all(1))


def _beside_legs(seen: Seen, hosts: Sequence[str]) -> Flags:
    """What stands not where those who sit in what is there have their legs."""
    near, far = (seen.to[..., 0] + sign * seen.own[..., 0] - seen.host[..., 0] for sign in (-1, 1))
    aside = np.abs(seen.to[..., 1]) - seen.own[..., 1] - seen.host[..., 1]
    return np.asarray(~((near < LEGS) & (far > 0) & (aside < -ARM)).any(1))


def _within(far: float) -> Judge:
    return lambda seen, hosts: _any(seen.gap <= far)


def _leaves_open(seen: Seen, hosts: Sequence[str]) -> Flags:
    return np.asarray(~seen.back().walls_in().any(1))


def _open_before(seen: Seen, hosts: Sequence[str]) -> Flags:
    return np.asarray(~seen.walls_in().any(1))


FOLLOWERS = kinds.CHAIRS | kinds.SMALL_SEATS | {"nightstand", "coffee_table", "side_table", "tv", "armchair",
                                               "floor_lamp"}
LED: tuple[tuple[frozenset[str], frozenset[str]], ...] = (
    (kinds.CHAIRS - {"balcony_chair"}, kinds.TABLES | kinds.DESKS),
    (frozenset({"nightstand"}), kinds.BEDS),
    (frozenset({"coffee_table"}), kinds.SOFAS),
)
"""What is of no use at all where none of these stands."""
AFTER = ((frozenset({"tv_stand", "armchair", "bookshelf", "sideboard", "display_cabinet"}), kinds.BEDS),)
"""What one can do without where a bed, which one cannot, is still to come and found no place before."""
DRESSED = ((frozenset({"armchair", "bench", "bookshelf", "chest", "desk", "display_cabinet", "dressing_table", "plant",
                       "sideboard"}), kinds.WARDROBES),)
"""What one can do without where one sleeps as long as the wardrobe is still to come."""
FIRST = ((kinds.WARDROBES | {"bench", "chest", "console_table", "shoe_cabinet"}, frozenset({"coat_rack"})),
         (frozenset({"table_lamp"}), kinds.BEDSIDE | kinds.DESKS),
         (frozenset({"mirror"}), kinds.WARDROBES))
"""What may stand farther from the entrance than hooks for coats, lamps what they stand on, and mirrors what would hide
them, wait for these."""
LARGE = kinds.ON_THE_FLOOR - kinds.BEFORE_A_SEAT - kinds.SOFAS
RULES = (
    (kinds.CHAIRS - {"balcony_chair"}, kinds.TABLES | kinds.DESKS, _at),
    (frozenset({"nightstand"}), kinds.BEDS, _bedside),
    (frozenset({"coffee_table"}), kinds.SOFAS, _before_seat),
    (frozenset({"tv_stand"}), kinds.SOFAS | kinds.BEDS, _watched),
    (frozenset({"tv"}), kinds.SOFAS, _seen),
    (kinds.SOFAS, frozenset({"tv_stand"}), _watches),
    (frozenset({"armchair"}), kinds.SOFAS | {"coffee_table"}, _in_group),
    (frozenset({"armchair"}), frozenset({"coffee_table"}), _knees),
    (frozenset({"armchair"}), frozenset({"armchair"}), _abreast),
    (frozenset({"armchair"}), frozenset({"tv_stand"}), _in_sight),
    (frozenset({"armchair"}), kinds.TABLES, _not_behind),
    (kinds.TABLES, frozenset({"armchair"}), lambda seen, hosts: _not_behind(seen.back(), hosts)),
    (kinds.TABLES, kinds.SOFAS | {"coffee_table"}, _apart),
    (kinds.SOFAS | {"coffee_table"}, kinds.TABLES, _apart),
    (frozenset({"side_table"}), kinds.EASY | kinds.BEDS, _within(REACH)),
    (kinds.SMALL_SEATS, USED_AT, _within(NEAR)),
    (LARGE, kinds.SOFAS, _leaves_open),
    (kinds.BEFORE_A_SEAT & (kinds.SLENDER | {"side_table"}), kinds.EASY, _leaves_open),
    (kinds.SOFAS, LARGE, _open_before),
    (frozenset({"floor_lamp"}), kinds.EASY, _beside_legs),
    (frozenset({"floor_lamp"}), kinds.TABLES, _apart),
)
"""Whose place is judged, by whom, and what must hold for it where any of these is there."""
