"""How the hand may follow a part: at every position one of a few directions, neighbours at neighbouring positions."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled
from apartgen.stages.embodied.interact.aim import ALIKE, OPTIONS, directions, grasps
from apartgen.stages.embodied.interact.parts import Hold, Part
from apartgen.stages.embodied.interact.probe import Probe
from apartgen.stages.embodied.interact.robot import CUP, THICK, TIP, postures
from apartgen.stages.space.boxes import Array, Mask

OPEN = 0.8
"""Share of its range at which a part counts as open."""
GOAL, LOOSE_GOAL = 0.83, 0.93
"""Share of its range to which a part is moved; that of an object which stands loose, and may give way a little."""
STEPS = 10
SPARE = 0.012
"""What the arm keeps of its travel for where the hand really takes hold, m."""
_COST = np.array([option.cost for option in OPTIONS])
_CHANGE = 1.0 - np.eye(len(OPTIONS))


@dataclass
class _Known:
    """From one place with one hold: postures (STEPS + 1, n, 13) by position and option, which are any good, and which
    of them have been found to touch nothing."""

    postures: Array
    able: Mask
    free: Mask


class Chains:
    """Of one part, at `STEPS` + 1 positions (`values`) up to its goal.

    `reached` says whether the hand got to the part from anywhere, `met` counts what the arm met, by geom.
    """

    def __init__(self, probe: Probe, part: Part) -> None:
        self.probe, self.part = probe, part
        goal = LOOSE_GOAL if probe.loose(part) else GOAL
        self.values = part.travel * goal * np.linspace(0, 1, STEPS + 1)
        self.turns, _ = part.moves(self.values)
        self.met: Counter[int] = Counter()
        self.reached = False
        self._aheads: dict[bool, Array] = {}
        self._prices: dict[bool, Array] = {}
        self._grips: dict[int, tuple[Array, Array, Mask]] = {}
        self._known: dict[tuple[bytes, int], _Known] = {}

    def found(self, base: Array, hold: Hold, start: int, end: int = STEPS, most: int = 2) -> Iterator[list[int]]:
        """Ways on from position `start` to `end`: indices of options at each position, straightest first.

        Those after the first end with other options. The cheapest way is tested for collisions where there is least
        choice, what touches something is struck out, and so on until a way is free.
        """
        known = self.known(base, hold)
        able, prices = known.able[start : end + 1].copy(), self.prices(hold)[start:end]
        for _ in range(most):
            while (chain := _cheapest(able, prices)) is not None:
                at = self._touches(known, able, chain, start, hold)
                if at is None:
                    break
                able[at, chain[at]] = known.able[start + at, chain[at]] = False
            if chain is None:
                return
            yield chain
            able[-1, chain[-1]] = False

    def _touches(self, known: _Known, able: Mask, chain: list[int], start: int, hold: Hold) -> int | None:
        """At which position of a chain the robot touches something, None for nowhere."""
        for at in np.argsort(able.sum(1), kind="stable").tolist():
            k, o = start + at, chain[at]
            if known.free[k, o]:
                continue
            if not self.meets_nothing(known.postures[k, o], k, hold):
                return int(at)
            known.free[k, o] = True
        return None

    def known(self, base: Array, hold: Hold) -> _Known:
        """What is known of a place and a hold."""
        key = (base.tobytes(), id(hold))
        if key not in self._known:
            points, turns, able = self.grips(hold)
            found, within = postures(base, points, turns, hold.opening, SPARE)
            able = able & within.reshape(able.shape)
            self.reached |= bool(able[0].any())
            self._known[key] = _Known(found.reshape(*able.shape, 13), able, np.zeros_like(able))
        return self._known[key]

    def prices(self, hold: Hold) -> Array:
        """What it costs to go on from option to option at the next position, (STEPS, n, n); infinite if impossible."""
        key = hold.kind == "push"
        if key not in self._prices:
            ahead = self.aheads(hold)
            near = (ahead[:-1] @ ahead[1:].transpose(0, 2, 1) > ALIKE) | (_CHANGE == 0)
            self._prices[key] = np.where(near, _CHANGE, np.inf)
        return self._prices[key]

    def meets_nothing(self, found: Array, k: int, hold: Hold) -> bool:
        """Whether the robot meets nothing in a posture with the part at the k-th position; else notes what."""
        met = self.probe.hit(found, self.part, float(self.values[k]), hold)
        self.met[met] += 1
        return met < 0

    def aheads(self, hold: Hold) -> Array:
        """Which way the hand points at every position with every option, (STEPS + 1, n, 3)."""
        key = hold.kind == "push"
        if key not in self._aheads:
            self._aheads[key] = directions(self.part, hold, self.turns)
        return self._aheads[key]

    def grips(self, hold: Hold) -> tuple[Array, Array, Mask]:
        """Which options hold (STEPS + 1, n), and the hand's points and axes with each, in rows."""
        if id(hold) not in self._grips:
            n = len(OPTIONS)
            values, ahead = self.values.repeat(n), self.aheads(hold).reshape(-1, 3)
            turns, able = grasps(self.part, hold, self.turns.repeat(n, 0), ahead)
            self._grips[id(hold)] = self.points(hold, values, ahead), turns, able.reshape(-1, n)
        return self._grips[id(hold)]

    def points(self, hold: Hold, values: Array, ahead: Array, back: float = 0.0) -> Array:
        """Where the hand is (n, 3) that acts on the part at positions (n,), pointing ahead (n, 3).

        Or `back` metres before that.
        """
        turns, shifts = self.part.moves(values)
        short = np.full(len(ahead), TIP + CUP if hold.kind == "cup" else 0.0)
        if hold.kind == "push":
            short = _short((ahead * (turns @ hold.out)).sum(1))
        return np.asarray(turns @ hold.point + shifts - (back + short)[:, None] * ahead)

    def complaint(self) -> str:
        """What the arm met most often; or, if it never met anything, that no motion was found."""
        met = Counter({k: count for k, count in self.met.items() if k >= 0})
        if not met:
            return "out of the arm's reach before it is open"
        return f"the arm meets {self.probe.name(met.most_common(1)[0][0])}"


def _cheapest(able: Mask, prices: Array) -> list[int] | None:
    """The cheapest way through layers of options (k, n), prices (k - 1, n, n) from layer to layer; None without."""
    if not able.any(1).all():
        return None
    cost, came = _costs(able, prices, np.where(able[0], _COST, np.inf))
    o = int(cost.argmin())
    if cost[o] == np.inf:
        return None
    chain = [o]
    for best in came[::-1].tolist():
        chain.append(best[chain[-1]])
    return chain[::-1]


@compiled()
def _costs(able: Mask, prices: Array, cost: Array) -> tuple[Array, NDArray[np.int64]]:
    """What it costs to get to every option of the last layer, and from which option every one is come to."""
    layers, n = able.shape
    came = np.zeros((layers - 1, n), np.int64)
    for k in range(1, layers):
        here = np.full(n, np.inf)
        for p in range(n):
            if able[k, p]:
                for o in range(n):
                    total = cost[o] + prices[k - 1, o, p]
                    if total < here[p]:
                        here[p], came[k - 1, p] = total, o
        cost = here
    return cost, came


def _short(cosine: Array) -> Array:
    """How far before a face closed fingers stop that come at a slant, so that their corners touch it first, m.

    `cosine` is that of the angle between hand and face's normal.
    """
    steep = np.abs(cosine).clip(0.2, 1.0)
    return np.asarray(TIP + THICK * np.sqrt(1 - steep**2) / steep)
