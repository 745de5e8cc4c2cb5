"""What stands in a room so far, and what a candidate for the next object would break: φ of Eq. 2 to 4, exactly."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection import kernels
from apartgen.stages.layout.projection.paths import RADII, SHUT, Paths
from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.projection.standing import Standing
from apartgen.stages.layout.relations import (
    company,
    distances,
    elbowroom,
    fixtures,
    handy,
    hung,
    nooks,
    order,
    runs,
    views,
)
from apartgen.stages.layout.relations.ground import in_the_way, opens, row, with_levers
from apartgen.stages.layout.relations.mutual import askew, grown
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.space.boxes import Boxes, penetration, stand_in
from apartgen.stages.things.categories import TABLE, reach, tucks
from apartgen.stages.use import kinds
from apartgen.stages.use.kinds import BEDS, CHAIRS, CLOSED, COLD, EASY, HOT, SMALL_SEATS, WARDROBES, WET, basic
from apartgen.stages.use.rules.cook import JOINED, PUT_DOWN

SLACK = 0.008
"""Contact that is none, m; below what metrics allow."""
BROKEN = 10.0
"""From this price on a candidate breaks a requirement; what is below it is undesired only."""
CUT = 0.25
"""What an object may cut off of the floor, in metres of way."""
TUCK_MOST = 0.30
"""How far a seat may go under its table, m."""
LEVEL = 0.02
SEATS = BEDS | EASY | CHAIRS | SMALL_SEATS
NO_TOP, MONITOR = SEATS | kinds.SLENDER, "monitor"
"""On which nothing is put, and what stands where one works."""
OFF_WALL = 0.025
"""What hangs, and a unit of a run, has its back no farther from a wall, m: more is called hung on nothing."""
AT_WALLS, BEHIND, END = kinds.CASES | WARDROBES | BEDS | {"tv_stand", "piano"}, 0.2, 0.1
"""What has its back at a wall, no farther from it, m, with a radiator between, up to so near its ends."""
NEVER_OFF = {**dict.fromkeys(WARDROBES | {"piano"}, END), "tv_stand": 0.3}
"""What is rather left out than put elsewhere, and how near its ends its back has to be at a wall."""
FREE = 8.0
"""Price of a sofa that turns its back to the room."""
EYES = 1.1
"""Nothing to look at and no lamp stands on what is higher, m: the eyes of who sits are at 1.1 to 1.2."""
APART = 6.0
"""Price of a hood that is not above what cooks, and where nothing better is left of a unit apart from its run."""
ALONE = 8.0
"""Price of a leader that is not where it is used with what stands there, once nothing better was found; what follows
is rather left out."""
CRAMPED = 6.0
"""Price of what has no floor for its use, or takes that of others, once nothing better was found."""
ABOVE = 0.25
"""A hood is above what is no farther from its middle, m."""
WIDE = 0.58
"""Worktop between sink and hob, if there is a place with so much of it, m."""
JUTS = 0.7
"""Deeper, a unit in a corner stands out before its neighbours, m."""
ASKEW = np.cos(np.pi / 4)
"""A seat that is drawn under a table looks at it within this cosine."""
Floats = NDArray[np.float64]


@cache
def tuck(a: str, b: str) -> float:
    """How far two may be drawn into one another, m: a seat under what is dined, worked or dressed at."""
    host = b if TABLE[a].is_for("sit") else a
    return TUCK_MOST if tucks(a, b) and not TABLE[host].is_for("sleep", "sit") else 0.0


class Furniture:
    """The objects of a room that has begun to be furnished, and the free floor between them."""

    def __init__(self, space: Space, radii: Mapping[float, float] = RADII) -> None:
        self.space = space
        self.names: list[str] = []
        self.boxes: Array = np.zeros((0, 7), np.float32)
        self.far: tuple[float, ...] = ()
        self.paths = Paths(Standing([]), replace(space, leaves=with_levers(space.leaves)), radii)
        self._cut: float | None = None
        self._stood: tuple[Boxes, Boxes] | None = None

    @property
    def cut(self) -> float:
        """What is cut off of the floor already, in metres of way."""
        if self._cut is None:
            self._cut = self.paths.cut_off()
        return self._cut

    @property
    def stood(self) -> tuple[Boxes, Boxes]:
        """What stands there, and b′ of it: grown in front by what its open parts sweep."""
        if self._stood is None:
            found = upright(self.boxes)
            center, size = np.empty_like(found.center), np.empty_like(found.size)
            grown(found.center, found.size, np.cos(found.yaw), np.sin(found.yaw), np.array(self.far), center, size)
            self._stood = found, Boxes(center, size, found.yaw)
        return self._stood

    @property
    def upright(self) -> Boxes:
        """What stands there."""
        return self.stood[0]

    def fork(self) -> "Furniture":
        """A copy to go on from."""
        other = self._copied()
        other.paths = self.paths.fork()
        return other

    def besides(self, name: str, box: Array) -> "Furniture":
        """A copy with an object more, in which ways are as they were."""
        other = self._copied()
        other._stand(name, box)
        return other

    def _copied(self) -> "Furniture":
        other = object.__new__(Furniture)
        other.__dict__.update(self.__dict__, names=list(self.names))
        return other

    def add(self, name: str, box: Array) -> None:
        """An object stands there from now on."""
        if in_the_way(name, box):
            self.paths.add(len(self.names), upright(box[None]), opens(name, box))
            self._cut = None
        self._stand(name, box)

    def _stand(self, name: str, box: Array) -> None:
        self.names.append(name)
        self.boxes, self._stood = np.concatenate([self.boxes, box[None]]), None
        self.far += (float(reach(name, upright(box[None]).size[0])) if TABLE[name].opens else 0.0,)

    def prices(self, name: str, boxes: Array, loose: bool = False, strict: bool = False) -> Floats:
        """What candidates (n, 7) for an object break: φ of sweeps, bodies, walls, openings, runs and use, (n,)."""
        found, kind = upright(boxes), TABLE[name]
        total = np.zeros(found.n)
        if kind.place == "top":
            total += np.where(self._carried(name, boxes), 0.0, 2 * BROKEN)
        if kind.place == "wall":
            total += np.where(self.space.behind(found) > OFF_WALL, 2 * BROKEN, 0.0)
        total += self._away(name, boxes, found, strict, loose)
        total += np.where(found.center[:, 2] + found.size[:, 2] / 2 > self.space.height + SLACK, 2 * BROKEN, 0.0)
        if kind.soft:
            return total + self._soft(name, found)
        soft, seated, tucked = _others(name, tuple(self.names))
        others = kernels.Others(*self.stood, soft, seated, tucked)
        total += kernels.prices(found, reach(name, found.size), np.zeros(found.n), others, self.space.kept_clear,
                                self.space.walls, SLACK, BROKEN)
        good = np.flatnonzero(total < BROKEN)
        if len(good):  # what is broken already is not asked for more
            total[good] += self._in_use(name, boxes[good], found.take(good), tucked, loose, strict)
        return total

    def _in_use(self, name: str, boxes: Array, found: Boxes, tucked: Floats, loose: bool, strict: bool) -> Floats:
        """What candidates break that can stand there: doors, use with what stands there and of that, runs, fixtures."""
        total = np.zeros(found.n)
        total += np.where(hung.spoils(name, found, self.names, self.upright), 2 * BROKEN, 0.0)
        total += np.where(self._meets_leaves(name, found), 2 * BROKEN if strict else ALONE, 0.0)
        useless = 2 * BROKEN if strict or (company.follows(name) and not loose) else ALONE
        total += np.where(company.alone(name, boxes, self.names, self.boxes), useless, 0.0)
        barred = views.barred(name, boxes, self.names, self.boxes, self.space.leaves)
        barred |= nooks.shut(name, boxes, self.names, self.boxes, self.space)
        total += np.where(barred, ALONE if loose else 2 * BROKEN, 0.0)
        cramped = elbowroom.taken(name, boxes, self.names, self.boxes, self.space)
        spared = not loose and elbowroom.spared(name, self.names, self.space)
        total += np.where(cramped, 2 * BROKEN if strict or spared else CRAMPED, 0.0)
        total += 0.0 if loose else distances.price(name, boxes, found, self.names, self.boxes, self.space)
        total += fixtures.prices(name, found, self.names, self.upright, self.space, strict, loose)
        return total + self._sideways(found, tucked) + self.in_run(name, boxes, loose, strict)

    def _away(self, name: str, boxes: Array, found: Boxes, strict: bool, loose: bool) -> Floats:
        """What has a back has all of it at a wall, a sofa rather than not; what one reaches for is at hand."""
        total, kind = np.zeros(found.n), basic(name)
        if kind in AT_WALLS:
            total += np.where(self._off_wall(found, END), 2 * BROKEN if strict else ALONE, 0.0)
            total += np.where(self._off_wall(found, NEVER_OFF[kind]), BROKEN, 0.0) if kind in NEVER_OFF else 0.0
        if kind in kinds.SOFAS:
            total += np.where(self.space.behind(found) > BEHIND, FREE, 0.0)
        return total + handy.price(name, boxes, found, self.names, self.boxes, self.space, strict, loose)

    def _off_wall(self, found: Boxes, end: float) -> NDArray[np.bool_]:
        """Which candidates have no wall behind them up to so near their ends, m."""
        ends = np.maximum(found.size[:, 1] / 2 - end, 0.0)
        return np.asarray(np.maximum(self.space.behind(found, ends), self.space.behind(found, -ends)) > BEHIND)

    def _meets_leaves(self, name: str, found: Boxes) -> NDArray[np.bool_]:
        """Which candidates have parts that would open into a door that stands open."""
        if not self.space.leaves.n or TABLE[name].place == "wall" or not TABLE[name].opens:
            return np.zeros(found.n, bool)
        far = np.broadcast_to(reach(name, found.size), found.n)
        heading = np.stack([np.cos(found.yaw), np.sin(found.yaw), np.zeros(found.n)], -1)
        ahead = Boxes(found.center + heading * (found.size[:, :1] + far[:, None]) / 2,
                      np.column_stack([far, found.size[:, 1:]]), found.yaw)
        return stand_in(ahead, self.space.leaves, SLACK)

    def _sideways(self, found: Boxes, tucked: Floats) -> Floats:
        """A seat is drawn under a table forwards only."""
        total = np.zeros(found.n)
        for k in np.flatnonzero(tucked > 0).tolist() if found.n else ():
            host = Boxes(*(part[k : k + 1] for part in self.upright))
            yaw = float(host.yaw[0])
            turn = found.yaw - yaw
            away = askew(found.center, np.cos(turn), np.sin(turn), host.center[0], host.size[0], np.cos(yaw),
                         np.sin(yaw), ASKEW)
            total += np.where(away & stand_in(found, host, SLACK), 2 * BROKEN, 0.0)
        return total

    def in_run(self, name: str, boxes: Array, loose: bool = False, strict: bool = False) -> Floats:
        """Units of a run stand side by side at walls, or round a corner; a hood hangs above what cooks."""
        if name == "hood":
            heat = [box for o, box in zip(self.names, self.boxes, strict=True) if TABLE[o].is_for("cook")]
            near = [np.hypot(*(boxes[:, :2] - box[:2]).T) < ABOVE for box in heat]
            return np.where(np.any(near, axis=0), 0.0, APART) if near else np.zeros(len(boxes))
        if name not in order.runs():
            return np.zeros(len(boxes))
        away = self.space.behind(upright(boxes)) > OFF_WALL
        if name in CLOSED:
            away |= ~runs.in_corner(upright(boxes), self.space.behind)
        alone = ~runs.touching(name, boxes, self.names, self.boxes)
        total = np.where(away, 2 * BROKEN, 0.0) + np.where(alone, APART if loose else BROKEN, 0.0)
        worse = 2 * BROKEN if strict else APART
        total += np.where(boxes[:, 3] > JUTS, worse, 0.0) if name in CLOSED else 0.0
        total += np.where(self._ill_beside(name, boxes, strict), worse, 0.0)
        return total + (np.where(hung.lit(boxes, self.space), worse, 0.0) if TABLE[name].is_for("cook") else 0.0)

    def _ill_beside(self, name: str, boxes: Array, strict: bool) -> NDArray[np.bool_]:
        """Which candidates leave no worktop between sink and hob, or put a hob in a corner or beside what is tall."""
        kind, others = basic(name), list(map(basic, self.names))
        if kind not in HOT | WET | COLD:
            return np.zeros(len(boxes), bool)
        seen, ill = company.Seen(boxes, self.boxes), np.zeros(len(boxes), bool)
        for some, far in ((WET, WIDE if strict else PUT_DOWN), (COLD, JOINED)):
            met = [o in some if kind in HOT else kind in some and o in HOT for o in others]
            ill |= (seen.gap[:, met] < far).any(1)
        return np.asarray(ill | hung.cornered(boxes, self.space) if kind in HOT else ill)

    def shuts(self, name: str, box: Array, loose: bool = False) -> float:
        """What an object there would cut off of the floor, in metres of way: doors, ways, things out of reach; its own
        use does not count where one is `loose`."""
        return self.shut_by([(name, box)], loose)

    def shut_by(self, some: Sequence[tuple[str, Array]], loose: bool = False) -> float:
        """The same of several objects together."""
        standing = [(name, box) for name, box in some if in_the_way(name, box)]
        if not standing:
            return 0.0
        rows = [row(box, SHUT if loose else opens(name, box)) for name, box in standing]
        return max(0.0, self.paths.cut_off_with(rows) - self.cut)

    def _soft(self, name: str, found: Boxes) -> Floats:
        beyond = outside(found, self.space)
        total = np.where(beyond > SLACK, 40 + 100 * beyond, 0.0)
        clear = {"wall": self.space.zones.take(~self.space.window), "flat": self.space.leaves}.get(TABLE[name].place)
        if clear is not None and clear.n:
            met = penetration(found._replace(size=np.maximum(found.size, [0, 0, LEVEL])), clear).max(1) > SLACK
            total += np.where(met, 3 * BROKEN, 0.0)
        return np.asarray(total)

    def _carried(self, name: str, boxes: Array) -> NDArray[np.bool_]:
        """Whether candidates stand on the top of something, wholly, that nobody sits, lies or walks on, that has no lid
        and is no plant or lamp itself, what belongs on tops not above where one looks, a monitor on desks alone."""
        found = np.zeros(len(boxes), bool)
        for o, under in zip(self.names, self.boxes, strict=True):
            if basic(o) in NO_TOP or TABLE[o].soft or TABLE[o].opens == "lid":
                continue
            if under[6] > EYES and TABLE[name].place == "top" or name == MONITOR and basic(o) not in kinds.DESKS:
                continue
            offset = boxes[:, :2] - under[:2]
            c, s = np.cos(under[2]), np.sin(under[2])
            x, y = offset[:, 0] * c + offset[:, 1] * s, offset[:, 1] * c - offset[:, 0] * s
            turn = boxes[:, 2] - under[2]
            ex = np.abs(np.cos(turn)) * boxes[:, 3] / 2 + np.abs(np.sin(turn)) * boxes[:, 4] / 2
            ey = np.abs(np.sin(turn)) * boxes[:, 3] / 2 + np.abs(np.cos(turn)) * boxes[:, 4] / 2
            found |= ((np.abs(boxes[:, 5] - under[6]) < LEVEL) & (np.abs(x) + ex < under[3] / 2 + 2 * LEVEL)
                      & (np.abs(y) + ey < under[4] / 2 + 2 * LEVEL))
        return found


@lru_cache(4096)
def _others(name: str, names: tuple[str, ...]) -> tuple[NDArray[np.bool_], NDArray[np.bool_], Floats]:
    """Of what stands there, what gives way to a category, which may be drawn into it or it into that, and how far."""
    tall_leaf = TABLE[name].opens == "leaf"
    soft = np.array([TABLE[o].soft and not (tall_leaf and o == "curtain") for o in names], bool)
    tucked = np.array([tuck(name, o) for o in names], float)
    return soft, tucked > 0, tucked
