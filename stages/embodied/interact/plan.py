"""Where to stand and how to move: postures of the robot along the way a part takes.

The hand keeps hold of the handle while it turns freely in the grip, so at each of `STEPS` positions of the part any of
a few directions of the hand will do, if neighbouring positions have neighbouring directions. Where a leaf can't be
held all the way, as where it opens against a wall, it is pulled as far as it goes and pushed on from behind.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import Literal, NamedTuple

import numpy as np

from stages.boxes import Array
from stages.embodied.interact.parts import PLAY, Hold, Part
from stages.embodied.interact.probe import Probe
from stages.embodied.interact.robot import ARM, CUP, HAND, REACH, THICK, TIP, posture, tucked

OPEN = 0.8
"""Share of its range at which a part counts as open."""
GOAL = 0.86
"""Share of its range to which a part is moved."""
STEPS = 10
BACK = 0.09
"""The hand comes from and goes this far back from what it takes hold of, m."""
FINE, FREE = 0.05, 0.02
"""Held and free paths are checked at least every so much of a turn (rad) or way (m)."""
SPARE = 0.012
"""What the arm keeps of its travel for where the hand really takes hold, m."""
YAWS = np.radians([0, 35, -35, 70, -70])
PITCHES = np.radians([0, 40, 75, -40])
_LIMIT = {"pinch": 0.7, "cup": 0.5, "push": 0.6}
"""Least cosine between hand and what it acts on: of the fingers' line to the pinch, of the hand to the face."""

class Option(NamedTuple):
    """A direction of the hand: straight at the object but for a turn to the left and one down, rad.

    `follows` says whether the hand turns with the part or keeps its direction.
    """

    yaw: float
    pitch: float
    follows: bool

    @property
    def cost(self) -> float:
        """What it costs beside one for every change."""
        return 0.3 * (abs(self.yaw) + abs(self.pitch)) + 0.1 * self.follows


OPTIONS = [Option(*angles, False) for angles in product(YAWS.tolist(), PITCHES.tolist())]
OPTIONS += [Option(yaw, pitch, True) for yaw, pitch in product(YAWS[:3].tolist(), PITCHES[:2].tolist())]
_NEAR = float(np.cos(np.radians(46)))
"""Directions no further apart follow one another."""


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


def forward(part: Part, hold: Hold, value: float, option: Option) -> Array:
    """Which way the hand points (unit), the part at a position."""
    left = _cross(part.up, part.front)
    level = -np.cos(option.yaw) * part.front - np.sin(option.yaw) * left
    if hold.kind == "push":
        level = -level
    found = np.cos(option.pitch) * level - np.sin(option.pitch) * part.up
    return np.asarray(part.moved(value)[0] @ found if option.follows else found)


def turned(part: Part, hold: Hold, value: float, ahead: Array) -> Array | None:
    """The hand's axes (3, 3) when it points `ahead`; None where it would not grip, or push out of the face."""
    turn, _ = part.moved(value)
    facing = float(ahead @ (turn @ hold.out)) * (1 if hold.kind == "push" else -1)
    if hold.kind != "pinch" and facing < _LIMIT[hold.kind]:
        return None
    across = turn @ hold.across if hold.kind == "pinch" else _cross(part.up, part.front)
    across = across - (across @ ahead) * ahead
    length = float(np.linalg.norm(across))
    if length < (_LIMIT["pinch"] if hold.kind == "pinch" else 0.1):
        return None
    across = across / length
    return np.stack([ahead, across, _cross(ahead, across)], 1)


class Planner:
    """Plans for one part, with the probe's collision test."""

    def __init__(self, probe: Probe, part: Part) -> None:
        self.probe, self.part = probe, part
        self.values = part.travel * GOAL * np.linspace(0, 1, STEPS + 1)
        self.met: Counter[int] = Counter()
        self._ahead: dict[tuple[bool, int, int], Array] = {}

    def at(self, base: Array, hold: Hold, value: float, ahead: Array, near: Array | None = None, wide: bool = False,
           back: float = 0.0) -> Array | None:  # fmt: skip
        """The posture that acts on the part; with `wide` the fingers are open, `back` metres before it."""
        turn = turned(self.part, hold, value, ahead)
        if turn is None:
            return None
        opening = hold.opening + (PLAY if wide and hold.kind == "pinch" else 0.0)
        if hold.kind == "cup":
            back += TIP + CUP
        elif hold.kind == "push":
            back += _short(turn[:, 0], self.part.moved(value)[0] @ hold.out)
        point = self.part.at(hold.point, value) - back * turn[:, 0]
        return posture(base, point, turn, opening, near, SPARE)

    def ahead(self, hold: Hold, k: int, o: int) -> Array:
        """Which way the hand points at the k-th position with the o-th option."""
        key = (hold.kind == "push", k, o)
        if key not in self._ahead:
            self._ahead[key] = forward(self.part, hold, self.values[k], OPTIONS[o])
        return self._ahead[key]

    def free(self, base: Array, hold: Hold, k: int, o: int) -> bool:
        """Whether the robot meets nothing while it holds the part at the k-th position."""
        found = self.at(base, hold, self.values[k], self.ahead(hold, k, o))
        if found is None:
            return False
        met = self.probe.hit(found, self.part, self.values[k], hold)
        self.met[met] += 1
        return met < 0

    def complaint(self) -> str:
        """What the arm met most often, or that nothing was within its reach."""
        met = Counter({k: count for k, count in self.met.items() if k >= 0})
        if not met:
            return "out of the arm's reach"
        return f"the arm meets {self.probe.name(met.most_common(1)[0][0])}"

    def chains(self, base: Array, hold: Hold, start: int) -> list[list[int]]:
        """Ways on from position `start`, as far as it goes: indices of options at each position, straightest first."""
        costs = {o: option.cost for o, option in enumerate(OPTIONS) if self.free(base, hold, start, o)}
        layers: list[dict[int, int]] = []
        every = range(len(OPTIONS))
        for k in range(start + 1, STEPS + 1):
            old, new = ([self.ahead(hold, j, o) for o in every] for j in (k - 1, k))
            near = np.array(new) @ np.array(old).T > _NEAR
            ways = {o: min((costs[p] + (o != p), p) for p in costs if near[o, p] or o == p)
                    for o in every if any(near[o, p] or o == p for p in costs)}
            ways = {o: way for o, way in ways.items() if self.free(base, hold, k, o)}
            if not ways:
                break
            layers.append({o: p for o, (_, p) in ways.items()})
            costs = {o: cost for o, (cost, _) in ways.items()}
        return [_traced(layers, o) for o in sorted(costs, key=costs.__getitem__)]

    def follow(self, base: Array, hold: Hold, start: int, chain: list[int], near: Array) -> Phase | None:
        """The held motion along a chain, on from a posture, checked closely; None where it meets something."""
        stops: list[Stop] = []
        for k, (a, b) in enumerate(zip(chain, chain[1:], strict=False), start):
            lo, hi = self.values[k], self.values[k + 1]
            for share in np.linspace(0, 1, int(np.ceil(abs(hi - lo) / FINE)) + 2)[:-1]:
                value = float(lo + share * (hi - lo))
                ways = [forward(self.part, hold, value, OPTIONS[o]) for o in (a, b)]
                if not self._stop(base, hold, value, (1 - share) * ways[0] + share * ways[1], near, stops):
                    return None
                near = stops[-1].posture
        last = start + len(chain) - 1
        if not self._stop(base, hold, float(self.values[last]), self.ahead(hold, last, chain[-1]), near, stops):
            return None
        return Phase("hold", stops, hold)

    def _stop(self, base: Array, hold: Hold, value: float, ahead: Array, near: Array, stops: list[Stop]) -> bool:
        ahead = ahead / np.linalg.norm(ahead)
        found = self.at(base, hold, value, ahead, near)
        if found is None or self.probe.hit(found, self.part, value, hold) >= 0:
            return False
        stops.append(Stop(found, value, turned(self.part, hold, value, ahead)))
        return True

    def reach(self, base: Array, hold: Hold, k: int, o: int, near: Array, on: bool = False) -> Phase | None:
        """The way from arm in to the hold (its last stop), the part standing at the k-th position; None without.

        With `on` it begins where the arm is, at `near`, else wherever suits.
        """
        value, ahead = float(self.values[k]), self.ahead(hold, k, o)
        ready = self.at(base, hold, value, ahead, near, wide=True)
        before = self.at(base, hold, value, ahead, near, wide=True, back=BACK)
        if ready is None or before is None:
            return None
        for middle in _unfolding(base, before):
            for first in _turning(near, middle[0]) if on else [[]]:
                stops = [Stop(p, value) for p in (*first, *middle, before, ready)]
                if self._clear(stops, hold):
                    return Phase("move", stops)
        return None

    def _clear(self, stops: list[Stop], hold: Hold) -> bool:
        """Whether the robot meets nothing between stops; the last stretch may touch the part with the fingers."""
        for k, (a, b) in enumerate(zip(stops[:-1], stops[1:], strict=True)):
            step = np.abs(b.posture - a.posture) * [1, 1, 0.5, 1, 0.5, 3, 0, 0, 0.15, 0.15, 0, 1, 1]
            for share in np.linspace(0, 1, max(2, int(np.ceil(step.max() / FREE)) + 1)):
                here = a.posture + share * (b.posture - a.posture)
                if self.probe.hit(here, self.part, a.value, hold if k == len(stops) - 2 else None) >= 0:
                    return False
        return True

    def plan(self, base: Array) -> Plan | None:
        """All that opens the part from one place; None if nothing does."""
        for hold in self.part.holds:
            for chain in self.chains(base, hold, 0)[:2]:
                pulled = self._pulled(base, hold, chain)
                if pulled is None:
                    continue
                if len(chain) == STEPS + 1:
                    return Plan(base, pulled)
                pushed = self._pushed(base, pulled, len(chain) - 1)
                if pushed is not None:
                    return Plan(base, pushed)
        return None

    def _pulled(self, base: Array, hold: Hold, chain: list[int]) -> list[Phase] | None:
        came = self.reach(base, hold, 0, chain[0], tucked(base, 0, 0))
        if came is None:
            return None
        held = self.follow(base, hold, 0, chain, came.stops[-1].posture)
        return None if held is None else [came, held]

    def _pushed(self, base: Array, pulled: list[Phase], furthest: int) -> list[Phase] | None:
        """The pull cut short where the leaf can be pushed on from behind, and the push."""
        for k in range(furthest, 1, -1):
            cut = [stop for stop in pulled[1].stops if stop.value <= self.values[k] + 1e-9]
            grip = pulled[1].hold
            assert grip is not None
            for hold in self.part.pushes:
                for chain in self.chains(base, hold, k)[:2]:
                    if len(chain) < STEPS + 1 - k:
                        continue
                    away = self._leave(base, cut[-1], grip)
                    if away is None:
                        continue
                    came = self.reach(base, hold, k, chain[0], away.stops[-1].posture, on=True)
                    pushed = None if came is None else self.follow(base, hold, k, chain, came.stops[-1].posture)
                    if came is not None and pushed is not None:
                        return [pulled[0], Phase("hold", cut, grip), away, came, pushed]
        return None

    def _leave(self, base: Array, stop: Stop, hold: Hold) -> Phase | None:
        """The way from a hold back to arm in."""
        wide = stop.posture.copy()
        wide[11:] += PLAY if hold.kind == "pinch" else 0.0
        back = _withdrawn(wide, BACK)
        if back is None:
            return None
        for middle in _unfolding(base, back):
            stops = [Stop(p, stop.value) for p in (*middle, back, wide)]
            if self._clear(stops, hold):
                return Phase("move", stops[::-1])
        return None


def _short(forward: Array, out: Array) -> float:
    """How far before a face closed fingers stop that come at a slant, so that their corners touch it first, m."""
    cosine = max(abs(float(forward @ out)), 0.2)
    return TIP + THICK * float(np.sqrt(1 - min(cosine, 1.0) ** 2)) / cosine


def _cross(a: Array, b: Array) -> Array:
    """Of two vectors; numpy's is slow for one pair."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _traced(layers: list[dict[int, int]], last: int) -> list[int]:
    found = [last]
    for layer in layers[::-1]:
        found.append(layer[found[-1]])
    return found[::-1]


def _withdrawn(at: Array, by: float) -> Array | None:
    """The posture with the hand that much further back along its own direction."""
    bearing = at[2] + at[4]
    pitch, yaw = at[9], bearing + at[8]
    forward = np.array([np.cos(yaw) * np.cos(pitch), np.sin(yaw) * np.cos(pitch), -np.sin(pitch)])
    out = ARM[0] + at[5:8].sum()
    wrist = np.array([at[0] + out * np.cos(bearing), at[1] + out * np.sin(bearing), at[3]])
    roll = at[10]
    flat = np.array([-np.sin(yaw), np.cos(yaw), 0])
    up = _cross(forward, flat)
    across = np.cos(roll) * flat + np.sin(roll) * up
    turn = np.stack([forward, across, _cross(forward, across)], 1)
    return posture(at[:3], wrist + (HAND - by) * forward, turn, at[11], at)


def _unfolding(base: Array, before: Array) -> Iterator[list[Array]]:
    """Ways from arm in to a posture: hand down first then out, both at once, out first then down."""
    start = tucked(base, before[3], before[4])
    folded = before.copy()
    folded[5:8] = 0.0
    upright = before.copy()
    upright[8:11] = start[8:11]
    start[11:] = folded[11:] = upright[11:] = before[11:]
    yield [start, folded]
    yield [start]
    yield [start, upright]


def _turning(start: Array, end: Array) -> Iterator[list[Array]]:
    """Ways from one posture with the arm in to another: straight, or up or down on the side away from the part."""
    yield [start]
    for turn in (np.pi, -np.pi):
        low, high = start.copy(), end.copy()
        low[4] = high[4] = start[4] + turn
        yield [start, low, high]


def spots(part: Part, cells: Array) -> Array:
    """Those of the floor's points (n, 2) from which the arm might do, best first, one in each 0.1 m square; (m, 2)."""
    path = np.array([part.at(part.holds[0].point, v)[:2] for v in part.travel * GOAL * np.linspace(0, 1, 5)])
    cells = cells[(np.abs(cells - path[0]) <= REACH).all(1)]
    apart = np.linalg.norm(cells[:, None] - path[None], axis=2)
    able = (apart[:, 0] <= REACH) & (apart[:, 0] >= 0.3) & (apart[:, 2] <= REACH + 0.1)
    cells, apart = cells[able], apart[able]
    cost = np.abs(apart - 0.55).mean(1) + 0.5 * (0.32 - apart).clip(0).max(1) + (apart - REACH).clip(0).max(1)
    order = np.argsort(cost, kind="stable")
    _, first = np.unique(np.floor(cells[order] / 0.1), axis=0, return_index=True)
    return np.asarray(cells[order[np.sort(first)]])
