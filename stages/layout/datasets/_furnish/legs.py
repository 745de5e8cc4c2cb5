"""Where kitchen runs can go: free stretches of wall, joined round corners."""

from typing import NamedTuple

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors, kernels
from apartgen.stages.layout.datasets._furnish.shape import SWING
from apartgen.stages.layout.datasets._furnish.space import TOUCH, Space
from apartgen.stages.space.boxes import Mask

PROBE = 0.05
OPENS = 0.6
"""How far units open, m."""
VOID = 0.02
"""A leg begins so far beyond the depth of the one that it meets in a corner, m."""


class Leg(NamedTuple):
    """A stretch of wall `side` from `low` to `high`, m along it."""

    side: int
    low: float
    high: float


def stretches(space: Space, depth: float, height: float) -> list[Leg]:
    """Stretches of wall where low units can stand."""
    found = []
    for k, far in enumerate(space.shape.length):
        good = _probe(space, k, float(far), depth, height)
        edges = np.flatnonzero(np.diff(np.concatenate([[0], good.astype(int), [0]])))
        for a, b in edges.reshape(-1, 2):
            if (b - a) * PROBE > 0.5:
                high = float(far) if b == len(good) else b * PROBE
                found.append(Leg(k, a * PROBE, high))
    return found


def _probe(space: Space, side: int, far: float, depth: float, height: float) -> Mask:
    shape = space.shape
    n = max(1, int(np.ceil(far / PROBE - 1e-9)))
    s = (np.arange(n) + 0.5) * PROBE
    s[-1] = min(s[-1], far - PROBE / 2)
    normal = shape.normal[side]
    row = np.empty((n, 1, 8))
    row[:, 0, :2] = shape.start[side] + s[:, None] * shape.along[side] + normal * (depth / 2 + anchors.OFF)
    row[:, 0, 2:] = [height / 2, depth, PROBE - 0.004, height, *normal]
    bad = kernels.leaves(row, np.ones(1, bool), shape.start, 2e-3)
    some = [*shape.zone_rows, *space.placed.row]
    if some:
        bad |= kernels.clash(row, np.ascontiguousarray(np.stack(some)), np.ones((1, len(some)), bool), TOUCH)
    swings = shape.zone_rows[shape.zone_kind == SWING]
    if len(swings):  # what opens must not meet a door's leaf either
        row[:, 0, :2] += normal * OPENS / 2
        row[:, 0, 3] += OPENS
        bad |= kernels.clash(row, np.ascontiguousarray(swings), np.ones((1, len(swings)), bool), TOUCH)
    return np.asarray(~bad)


def paths(space: Space, free: list[Leg], depth: float) -> list[list[Leg]]:
    """Ways a run can go: along one stretch, round a corner, round two; those that go further come more often."""
    shape, n = space.shape, len(space.shape.length)
    ends = {leg.side: leg for leg in free if leg.high >= shape.length[leg.side] - 1e-6}
    begins = {leg.side: leg for leg in free if leg.low <= 1e-6}
    cut = depth + VOID
    found = [[leg] for leg in free]
    pairs = [(k, (k + 1) % n) for k in range(n) if k in ends and (k + 1) % n in begins
             and float(shape.along[k] @ shape.normal[(k + 1) % n]) < -0.99]
    for a, b in pairs:
        one, two = ends[a]._replace(high=ends[a].high - cut), begins[b]._replace(low=cut)
        if one.high - one.low > 0.6 and two.high - two.low > 0.6:
            found += [[one, two]] * 2
        for c, d in pairs:
            whole = begins[b]
            if c == b and whole == ends[b] and d != a:
                mid, last = whole._replace(low=cut, high=whole.high - cut), begins[d]._replace(low=cut)
                if mid.high - mid.low > 0.6 and min(one.high - one.low, last.high - last.low) > 0.6:
                    found.append([one, mid, last])
    return [p for p in found for _ in range(1 if length(p) < 2.4 else 2)]


def length(path: list[Leg]) -> float:
    """Of all its legs, m."""
    return sum(leg.high - leg.low for leg in path)
