"""Where to stand and how to move: postures of the robot along the way a part takes.

The hand keeps hold of the handle while it turns freely in the grip, so at each of `STEPS` positions of the part any of
a few directions of the hand will do, if neighbouring positions have neighbouring directions. Where a leaf can't be
held all the way, as where it opens against a wall, it is pulled as far as it goes and pushed on from behind.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np
import shapely
from shapely import Geometry

from apartgen.stages.embodied.interact.aim import directions, grasps
from apartgen.stages.embodied.interact.chains import GOAL, SPARE, STEPS, Chains
from apartgen.stages.embodied.interact.parts import PLAY, Hold, Part
from apartgen.stages.embodied.interact.probe import Probe
from apartgen.stages.embodied.interact.robot import REACH, posture, postures, tucked
from apartgen.stages.embodied.interact.ways import turning, unfolding, withdrawn
from apartgen.stages.space.boxes import Array

BACK = 0.09
"""The hand comes from and goes this far back from what it takes hold of, m."""
AJAR = 2
"""The first of the part's positions at which it can be pushed on."""
FINE, FREE = 0.05, 0.02
"""Held and free paths are checked at least every so much of a turn (rad) or way (m)."""


class Stop(NamedTuple):
    """Posture of the robot (13,) and position of the part that belong together; `turn` are the hand's axes (3, 3)."""

    posture: Array
    value: float
    turn: Array | None = None


@dataclass
class Phase:
    """A stretch of a plan: free motion, or motion with the part held; `hold` says how."""

    kind: Literal["move", "hold"]
    stops: list[Stop]
    hold: Hold | None = None


@dataclass
class Plan:
    """Where the base stands (x, y, heading) and what the arm does."""

    base: Array
    phases: list[Phase] = field(default_factory=list)


class Planner:
    """Plans for one part, with the probe's collision test."""

    def __init__(self, probe: Probe, part: Part) -> None:
        self.probe, self.part = probe, part
        self.chains = Chains(probe, part)
        self.values = self.chains.values

    def at(self, base: Array, hold: Hold, value: float, ahead: Array, near: Array, back: float = 0.0) -> Array | None:
        """The posture `back` metres before acting on the part, fingers open; None out of reach."""
        values, ahead = np.array([value]), ahead[None]
        turns, able = grasps(self.part, hold, self.part.moves(values)[0], ahead)
        if not able[0]:
            return None
        opening = hold.opening + (PLAY if hold.kind == "pinch" else 0.0)
        return posture(base, self.chains.points(hold, values, ahead, back)[0], turns[0], opening, near, SPARE)

    def follow(self, base: Array, hold: Hold, start: int, chain: list[int], near: Array) -> Phase | None:
        """The held motion along a chain, on from a posture, checked closely; None where it meets something."""
        legs = self.values[start : start + len(chain)]
        each = np.ceil(np.abs(np.diff(legs)) / FINE).astype(int) + 1
        along = np.concatenate([*(k + np.arange(n) / n for k, n in enumerate(each)), [len(each)]])
        k = np.minimum(along.astype(int), len(each) - 1)
        share = (along - k)[:, None]
        values = np.interp(along, np.arange(len(legs)), legs)
        turns, _ = self.part.moves(values)
        options, rows = np.array(chain), np.arange(len(along))
        ways = directions(self.part, hold, turns)
        ahead = (1 - share) * ways[rows, options[k]] + share * ways[rows, options[k + 1]]
        ahead /= np.linalg.norm(ahead, axis=1)[:, None]
        axes, able = grasps(self.part, hold, turns, ahead)
        found, within = postures(base, self.chains.points(hold, values, ahead), axes, hold.opening, SPARE, near)
        if not (able & within).all():
            return None
        if any(self.probe.hit(found[i], self.part, float(values[i]), hold) >= 0 for i in spread(len(found))):
            return None
        return Phase("hold", [Stop(*stop) for stop in zip(found, values.tolist(), axes, strict=True)], hold)

    def reach(self, base: Array, hold: Hold, k: int, o: int, near: Array, on: bool = False) -> Phase | None:
        """The way from arm in to the hold (its last stop), the part standing at the k-th position; None without.

        With `on` it begins where the arm is, at `near`, else wherever suits.
        """
        value, ahead = float(self.values[k]), self.chains.aheads(hold)[k, o]
        ready = self.at(base, hold, value, ahead, near)
        before = self.at(base, hold, value, ahead, near, BACK)
        if ready is None or before is None:
            return None
        for middle in unfolding(base, before):
            for first in turning(near, middle[0]) if on else [[]]:
                stops = [Stop(p, value) for p in (*first, *middle, before, ready)]
                if self._clear(stops, hold):
                    return Phase("move", stops)
        return None

    def _clear(self, stops: list[Stop], hold: Hold) -> bool:
        """Whether the robot meets nothing between stops; the last stretch may touch the part with the fingers.

        Looks first at points far from each other: what is in the way is found sooner so.
        """
        points: list[tuple[Array, Hold | None]] = []
        for k, (a, b) in enumerate(zip(stops[:-1], stops[1:], strict=True)):
            step = np.abs(b.posture - a.posture) * [1, 1, 0.5, 1, 0.5, 3, 0, 0, 0.15, 0.15, 0, 1, 1]
            shares = np.linspace(0, 1, max(2, int(np.ceil(step.max() / FREE)) + 1))[:, None]
            held = hold if k == len(stops) - 2 else None
            points += [(here, held) for here in a.posture + shares * (b.posture - a.posture)]
        value = stops[0].value
        return all(self.probe.hit(points[i][0], self.part, value, points[i][1]) < 0 for i in spread(len(points)))

    def plan(self, base: Array, holds: Sequence[Hold], push: bool) -> Plan | None:
        """All that opens the part from one place, taking hold as one of `holds` says; None if nothing does.

        With `push` the part is pulled ajar and pushed on, else pulled all the way.
        """
        if push and not self.part.pushes:
            return None
        for hold in holds:
            for chain in self._partial(base, hold) if push else self.chains.found(base, hold, 0):
                phases = self._pulled(base, hold, chain)
                if phases is not None and push:
                    phases = self._pushed(base, phases, len(chain) - 1)
                if phases is not None:
                    return Plan(base, phases)
        return None

    def _partial(self, base: Array, hold: Hold) -> list[list[int]]:
        """The ways as far as the hand can follow, none if that is all the way."""
        for end in range(STEPS, AJAR - 1, -1):
            found = list(self.chains.found(base, hold, 0, end))
            if found:
                return found if end < STEPS else []
        return []

    def _pulled(self, base: Array, hold: Hold, chain: list[int]) -> list[Phase] | None:
        came = self.reach(base, hold, 0, chain[0], tucked(base, 0, 0))
        if came is None:
            return None
        held = self.follow(base, hold, 0, chain, came.stops[-1].posture)
        return None if held is None else [came, held]

    def _pushed(self, base: Array, pulled: list[Phase], furthest: int) -> list[Phase] | None:
        """The pull cut short where the part can be pushed on from behind, and the push."""
        grip = pulled[1].hold
        assert grip is not None
        for k in range(furthest, AJAR - 1, -1):
            ways = [(hold, chain) for hold in self.part.pushes for chain in self.chains.found(base, hold, k)]
            if not ways:
                continue
            cut = [stop for stop in pulled[1].stops if stop.value <= self.values[k] + 1e-9]
            away = self._leave(base, cut[-1], grip)
            for hold, chain in ways if away is not None else []:
                assert away is not None
                came = self.reach(base, hold, k, chain[0], away.stops[-1].posture, on=True)
                pushed = None if came is None else self.follow(base, hold, k, chain, came.stops[-1].posture)
                if came is not None and pushed is not None:
                    return [pulled[0], Phase("hold", cut, grip), away, came, pushed]
        return None

    def _leave(self, base: Array, stop: Stop, hold: Hold) -> Phase | None:
        """The way from a hold back to arm in."""
        wide = stop.posture.copy()
        wide[11:] += PLAY if hold.kind == "pinch" else 0.0
        back = withdrawn(wide, BACK)
        if back is None:
            return None
        for middle in unfolding(base, back):
            stops = [Stop(p, stop.value) for p in (*middle, back, wide)]
            if self._clear(stops, hold):
                return Phase("move", stops[::-1])
        return None


def spread(n: int) -> list[int]:
    """0 to n - 1 in an order that comes near everywhere soon."""
    step = 1 << max(n - 1, 1).bit_length()
    order = [0]
    while step > 1:
        order += range(step // 2, n, step)
        step //= 2
    return order[:n] if n else []


def spots(part: Part, cells: Array, floor: Geometry) -> Iterator[Array]:
    """Those of the floor's points (n, 2), given in the order of y, from which the arm might do, best first.

    No wall stands between them and the handle: what is between lies within the `floor`. Those for the usual hold come
    first.
    """
    middle = part.holds[0].point
    far = 2 * REACH + abs(part.travel)
    first, last = np.searchsorted(cells[:, 1], [middle[1] - far, middle[1] + far])
    cells = cells[first:last]
    cells = cells[np.abs(cells[:, 0] - middle[0]) <= far]
    seen: set[tuple[float, float]] = set()
    for hold in (part.holds[0], *part.others):
        for place in _spots(part, hold, cells, floor):
            if (key := (place[0], place[1])) not in seen:
                seen.add(key)
                yield place


def _spots(part: Part, hold: Hold, cells: Array, floor: Geometry) -> Array:
    """Those for one hold, one in each 0.1 m square."""
    turns, shifts = part.moves(part.travel * GOAL * np.linspace(0, 1, 5))
    path = (turns @ hold.point + shifts)[:, :2]
    cells = cells[(np.abs(cells - path[0]) <= REACH).all(1)]
    apart = np.linalg.norm(cells[:, None] - path[None], axis=2)
    able = (apart[:, 0] <= REACH) & (apart[:, 0] >= 0.3) & (apart[:, 2] <= REACH + 0.1)
    cells, apart = cells[able], apart[able]
    cost = np.abs(apart - 0.55).mean(1) + 0.5 * (0.32 - apart).clip(0).max(1) + (apart - REACH).clip(0).max(1)
    x, y = np.floor(cells / 0.1).astype(int).T
    order = np.lexsort((cost, y, x))
    new = np.ones(len(order), bool)
    new[1:] = (np.diff(x[order]) != 0) | (np.diff(y[order]) != 0)
    best = order[new]
    found = cells[best[np.argsort(cost[best], kind="stable")]]
    sight = shapely.linestrings(np.stack([found, np.broadcast_to(path[0], found.shape)], 1))
    return np.asarray(found[shapely.covers(floor, sight)])
