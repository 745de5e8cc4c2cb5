"""How the hand may follow a part: at every position one of a few directions, neighbours at neighbouring positions."""

import heapq
from collections import Counter

import numpy as np

from stages.boxes import Array, Mask
from stages.embodied.interact.aim import NEAR, OPTIONS, directions, every_turn
from stages.embodied.interact.parts import Hold, Part
from stages.embodied.interact.probe import Probe
from stages.embodied.interact.robot import CUP, THICK, TIP, postures

OPEN = 0.8
"""Share of its range at which a part counts as open."""
GOAL = 0.83
"""Share of its range to which a part is moved."""
STEPS = 10
SPARE = 0.012
"""What the arm keeps of its travel for where the hand really takes hold, m."""


class Chains:
    """Of one part, at `STEPS` + 1 positions (`values`) up to its goal; `met` counts what the arm met, by geom."""

    def __init__(self, probe: Probe, part: Part) -> None:
        self.probe, self.part = probe, part
        self.values = part.travel * GOAL * np.linspace(0, 1, STEPS + 1)
        self.met: Counter[int] = Counter()
        self._ahead: dict[tuple[bool, int], Array] = {}
        self._grips: dict[tuple[int, int], tuple[Array, Array, Mask]] = {}
        self._near: dict[tuple[bool, int], Mask] = {}

    def found(self, base: Array, hold: Hold, start: int, most: int = 2) -> list[list[int]]:
        """Ways on from position `start`, as far as it goes: indices of options at each position, straightest first.

        Dijkstra over (position, option), each of which is tested for collisions only once it is the cheapest left.
        """
        grip = {start: self.held(base, hold, start)}
        heap: list[tuple[float, int, int, tuple[int, ...]]]
        heap = [(option.cost, start, o, (o,)) for o, option in enumerate(OPTIONS) if grip[start][1][o]]
        heapq.heapify(heap)
        seen: set[tuple[int, int]] = set()
        found: list[tuple[int, ...]] = [()]
        while heap and (len(found) < most or len(found[0]) < STEPS + 1 - start):
            cost, k, o, chain = heapq.heappop(heap)
            if (k, o) in seen:
                continue
            seen.add((k, o))
            if not self.meets_nothing(grip[k][0][o], k, hold):
                continue
            if len(chain) > len(found[0]):
                found = [chain]
            elif len(chain) == len(found[0]) and len(found) < most:
                found.append(chain)
            if k < STEPS:
                if k + 1 not in grip:
                    grip[k + 1] = self.held(base, hold, k + 1)
                for p in np.flatnonzero(grip[k + 1][1] & self.next(hold, k)[o]).tolist():
                    if (k + 1, p) not in seen:
                        heapq.heappush(heap, (cost + (o != p), k + 1, p, (*chain, p)))
        return [list(chain) for chain in found if chain]

    def held(self, base: Array, hold: Hold, k: int) -> tuple[Array, Mask]:
        """Postures (n, 13) of every option at the k-th position, and which are any good."""
        points, turns, able = self.grips(hold, k)
        found, within = postures(base, points, turns, hold.opening, SPARE)
        return found, able & within

    def next(self, hold: Hold, k: int) -> Mask:
        """Which option at position k may be followed by which at k + 1."""
        key = (hold.kind == "push", k)
        if key not in self._near:
            near = self.aheads(hold, k) @ self.aheads(hold, k + 1).T > NEAR
            self._near[key] = near | np.eye(len(OPTIONS), dtype=bool)
        return self._near[key]

    def meets_nothing(self, found: Array, k: int, hold: Hold) -> bool:
        """Whether the robot meets nothing in a posture with the part at the k-th position; else notes what."""
        met = self.probe.hit(found, self.part, float(self.values[k]), hold)
        self.met[met] += 1
        return met < 0

    def ahead(self, hold: Hold, k: int, o: int) -> Array:
        """Which way the hand points at the k-th position with the o-th option."""
        return np.asarray(self.aheads(hold, k)[o])

    def aheads(self, hold: Hold, k: int) -> Array:
        """The same with every option, (n, 3)."""
        key = (hold.kind == "push", k)
        if key not in self._ahead:
            self._ahead[key] = directions(self.part, hold, float(self.values[k]))
        return self._ahead[key]

    def grips(self, hold: Hold, k: int) -> tuple[Array, Array, Mask]:
        """The hand's point (n, 3) and axes (n, 3, 3) with every option at the k-th position, and which of them hold."""
        key = (id(hold), k)
        if key not in self._grips:
            value = float(self.values[k])
            ahead = self.aheads(hold, k)
            turns, able = every_turn(self.part, hold, value, ahead)
            back = np.array([self._back(hold, value, way) for way in ahead])
            self._grips[key] = self.part.at(hold.point, value) - back[:, None] * ahead, turns, able
        return self._grips[key]

    def point(self, hold: Hold, value: float, turn: Array, back: float) -> Array:
        """Where the hand is that acts on the part, its axes given, or `back` metres before that."""
        return self.part.at(hold.point, value) - (back + self._back(hold, value, turn[:, 0])) * turn[:, 0]

    def _back(self, hold: Hold, value: float, ahead: Array) -> float:
        """How far from what it acts on the hand is that points ahead, m."""
        if hold.kind == "push":
            return _short(ahead, self.part.moved(value)[0] @ hold.out)
        return TIP + CUP if hold.kind == "cup" else 0.0

    def complaint(self) -> str:
        """What the arm met most often; or, if it never met anything, that no motion was found."""
        met = Counter({k: count for k, count in self.met.items() if k >= 0})
        if not met:
            return "out of the arm's reach before it is open"
        return f"the arm meets {self.probe.name(met.most_common(1)[0][0])}"


def _short(forward: Array, out: Array) -> float:
    """How far before a face closed fingers stop that come at a slant, so that their corners touch it first, m."""
    cosine = max(abs(float(forward @ out)), 0.2)
    return TIP + THICK * float(np.sqrt(1 - min(cosine, 1.0) ** 2)) / cosine
