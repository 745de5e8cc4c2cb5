"""Holes of a drawing put into the walls between its rooms."""

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import LineString, Polygon

from apartgen.stages.plan.drawing import Hole

Array = NDArray[np.float64]
Floors = dict[str, Polygon]
REACH = 1.0
"""A hole is looked for in walls up to this far from where it is drawn, m."""
THICKEST = 0.9
"""No wall is thicker, m."""
OFF_ITS_WALL = 0.35
"""A hole lies no further outside the wall it is drawn at, m."""
EVEN = 0.03
"""Walls are of one thickness to this, m."""
SAMPLES = 41
LEAST = 0.3
"""Least width of what is left of a hole, m."""
SLANT = np.cos(np.radians(12))


class Cut(NamedTuple):
    """A hole in a wall: its ends on the wall's centre line and the rooms on both sides, the one if it leads outside."""

    hole: Hole
    ends: Array
    rooms: tuple[str, ...]


class _Gap(NamedTuple):
    """A wall crossed by a line: from where to where, and the rooms before and behind."""

    lo: float
    hi: float
    before: str | None
    behind: str | None


def cut(hole: Hole, floors: Floors, outer: float) -> Cut | str:
    """The hole in the wall it is drawn at, or why it has none. Outside walls are `outer` thick."""
    ends = np.asarray(hole.ends, float)
    middle, width = ends.mean(0), float(np.hypot(*(ends[1] - ends[0])))
    if width < LEAST:
        return f"is only {width:.2f} m wide"
    near = {name: floor for name, floor in floors.items() if floor.distance(LineString(ends)) < REACH}
    along = _aligned((ends[1] - ends[0]) / width, middle, near)
    normal = np.array([-along[1], along[0]])
    at = (np.arange(SAMPLES) + 0.5) / SAMPLES - 0.5
    found = [_crossed(middle + share * width * along, normal, near, outer) for share in at]
    core = _core(found)
    if core is None:
        return "is in no wall of a room"
    lo, hi, gap = core
    center = middle + 0.5 * (gap.lo + gap.hi) * normal
    left, right = ((k / SAMPLES - 0.5) * width for k in (lo, hi))
    if right - left < LEAST:
        return "has no straight wall on both sides"
    rooms = tuple(room for room in (gap.before, gap.behind) if room is not None)
    return Cut(hole, np.array([center + left * along, center + right * along]), rooms)


def _aligned(along: Array, middle: Array, floors: Floors) -> Array:
    """The direction of the nearest room's edge that runs almost the same way; else the hole's own."""
    best, least = along, REACH
    for floor in floors.values():
        ring = shapely.get_coordinates(floor.exterior)
        for a, b in zip(ring, ring[1:]):
            unit = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
            away = float(LineString([a, b]).distance(shapely.Point(middle)))
            if abs(float(unit @ along)) > SLANT and away < least:
                best, least = unit * np.sign(unit @ along), away
    return best


def _crossed(point: Array, normal: Array, floors: Floors, outer: float) -> _Gap | None:
    """The wall nearest to a point, looked for along a normal."""
    line = LineString([point - REACH * normal, point + REACH * normal])
    spans = []
    for name, floor in floors.items():
        for part in shapely.get_parts(floor.intersection(line)):
            if isinstance(part, LineString) and part.length > 0.02:
                reach = (shapely.get_coordinates(part) - point) @ normal
                spans.append((float(reach.min()), float(reach.max()), name))
    spans.sort()
    gaps = [_Gap(a[1], b[0], a[2], b[2]) for a, b in zip(spans, spans[1:]) if b[0] - a[1] < THICKEST and a[2] != b[2]]
    walled = {room for gap in gaps for room in ((gap.before, "hi"), (gap.behind, "lo"))}
    gaps += [
        _Gap(hi, hi + outer, name, None)
        for lo, hi, name in spans[-1:]
        if hi < REACH - 1e-6 and (name, "hi") not in walled
    ]
    gaps += [
        _Gap(lo - outer, lo, None, name)
        for lo, hi, name in spans[:1]
        if lo > 1e-6 - REACH and (name, "lo") not in walled
    ]
    at_wall = (gap for gap in gaps if _off(gap) < OFF_ITS_WALL)
    return min(at_wall, key=lambda gap: (round(_off(gap), 3), gap.lo), default=None)


def _off(gap: _Gap) -> float:
    return max(gap.lo, -gap.hi, 0.0)


def _core(found: list[_Gap | None]) -> tuple[int, int, _Gap] | None:
    """The longest run of samples that cross the same wall where it is even, and that wall."""
    best: tuple[int, int, _Gap] | None = None
    for start, first in enumerate(found):
        if first is None or (start and _same(found[start - 1], first)):
            continue
        stop = next((k for k in range(start, len(found)) if not _same(found[k], first)), len(found))
        if best is None or stop - start > best[1] - best[0]:
            best = start, stop, first
    return best


def _same(one: _Gap | None, other: _Gap) -> bool:
    if one is None or (one.before, one.behind) != (other.before, other.behind):
        return False
    return abs(one.lo - other.lo) < EVEN and abs(one.hi - other.hi) < EVEN
