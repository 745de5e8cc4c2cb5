"""What makes a place pleasant that breaks no requirement: seats look into the room, beds have sides to get in from."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.partners import SOFAS
from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.space.boxes import Boxes, penetration
from apartgen.stages.things.categories import SEATS, TABLE

Array = NDArray[np.float64]
VIEW = {"sofa": 1.2, "corner_sofa": 0.9, "armchair": 0.8}
"""How far a seat looks before it meets a wall, m."""
FACED = 2.0
"""A seat before a wall is worth a way of this many metres, elsewhere."""
SIDES = {"double_bed": 0.6}
"""Floor at either side to get in from, m."""
SIDE = 1.5
ASIDE = frozenset({"bin", "plant", "laundry_basket", "floor_lamp", "coat_rack", "bench", "stool"})
"""What stands at a wall, out of the way; elsewhere it costs OPEN metres."""
OPEN = 2.5
MIRRORED = frozenset({"vanity", "tv_stand"})
"""What has a mirror or a screen above it and had better not stand below a window, where it costs DAZZLED metres."""
DAZZLED = 1.5
OVERHEAD = frozenset({"water_heater"})
"""What had better not hang over anything; there it costs as much as OPEN."""
KEPT_OFF = frozenset({"dining_table", "round_table", "desk"})
"""What does not stand between a sofa and what it looks at, LOUNGE m deep; there it costs as much as OPEN."""
LOUNGE = 1.3
ELBOW = 0.85
"""A seat nearer than this to another, m, costs as much as OPEN: two people sit across a table, not side by side."""
BEFORE = {"toilet": 0.45}
"""Floor to be kept free before it, m; where it is not, a place costs CRAMPED metres."""
CRAMPED = 2.0
DRAWN = {"chair": 0.35}
"""Floor behind a seat to draw it back, m; where there is none, a place costs CRAMPED metres."""
ABOVE = frozenset({"wall_unit"})
"""What hangs above something that stands on the floor; elsewhere it costs BARE metres."""
BARE = 2.5
WORKTOP = 1.3
"""What is lower has something hung above it, m."""
CROWD = 1.5
"""Another lamp on the ceiling this near, m, costs as much."""


def price(category: str, found: Boxes, space: Space, standing: Boxes, names: list[str]) -> Array:
    """What each place (n,) lacks, in metres of shifting."""
    total = np.zeros(found.n)
    if category in VIEW:
        total += FACED * (outside(_before(found, VIEW[category]), space) > 0.05)
    if category in SIDES:
        for sign in (1.0, -1.0):
            total += SIDE * _taken(_aside(found, SIDES[category], sign), space, standing)
    if category in BEFORE:
        total += CRAMPED * _taken(_before(found, BEFORE[category]), space, standing)
    if category in DRAWN:
        turned = Boxes(found.center, found.size, found.yaw + np.pi)
        total += CRAMPED * _taken(_before(turned, DRAWN[category]), space, standing)
    for name, depth in BEFORE.items():
        kept = _before(standing.take(np.array([other == name for other in names], bool)), depth)
        if kept.n and TABLE[category].place == "floor":
            total += CRAMPED * (penetration(found, kept) > 0.05).any(1)
    if category in ABOVE:
        total += BARE * ~_over(found, standing, names)
    if category in MIRRORED and space.window.any():
        tall = Boxes(found.center * [1, 1, 0] + [0, 0, 1.0], found.size * [1, 1, 0] + [0, 0, 2.0], found.yaw)
        total += DAZZLED * (penetration(tall, space.zones.take(space.window)) > 0.01).any(1)
    if category in ASIDE:
        total += OPEN * (space.away(found.center[:, :2]) > found.size[:, :2].min(1) / 2 + 0.25)
    if category in KEPT_OFF:
        sofas = standing.take(np.array([name in SOFAS for name in names], bool))
        if sofas.n:
            total += OPEN * (penetration(found, _before(sofas, LOUNGE)) > 0.05).any(1)
    if category in SEATS:
        seats = standing.take(np.array([name in SEATS for name in names], bool))
        apart = np.linalg.norm(found.center[:, None, :2] - seats.center[None, :, :2], axis=-1)
        total += OPEN * (apart < ELBOW).any(1)
    if category in OVERHEAD and standing.n:
        flat = [Boxes(b.center * [1, 1, 0], b.size * [1, 1, 0] + [0, 0, 1], b.yaw) for b in (found, standing)]
        total += OPEN * (penetration(*flat) > 0.05).any(1)
    if category == "ceiling_lamp":
        lamps = standing.take(np.array([name == category for name in names], bool))
        if lamps.n:
            apart = np.linalg.norm(found.center[:, None, :2] - lamps.center[None, :, :2], axis=-1).min(1)
            total += 2 * np.maximum(CROWD - apart, 0)
    return total


def _taken(strip: Boxes, space: Space, standing: Boxes) -> NDArray[np.bool_]:
    """Which strips of floor (n,) are beyond the walls or stood upon."""
    taken = outside(strip, space) > 0.05
    return np.asarray(taken | (penetration(strip, standing) > 0.05).any(1) if standing.n else taken)


def _over(found: Boxes, standing: Boxes, names: list[str]) -> NDArray[np.bool_]:
    """Which places (n,) have a worktop or the like under them."""
    low = [TABLE[name].place == "floor" for name in names] & (standing.size[:, 2] < WORKTOP)
    flat = [Boxes(b.center * [1, 1, 0], b.size * [1, 1, 0] + [0, 0, 1], b.yaw) for b in (found, standing.take(low))]
    return np.asarray((penetration(*flat) > 0.1).any(1))


def _before(found: Boxes, depth: float) -> Boxes:
    """The floor in front of each box."""
    heading = np.stack([np.cos(found.yaw), np.sin(found.yaw)], -1)
    center, size = found.center.copy(), found.size.copy()
    center[:, :2] += heading * (found.size[:, :1] + depth) / 2
    size[:, 0] = depth
    return Boxes(center, size, found.yaw)


def _aside(found: Boxes, width: float, sign: float) -> Boxes:
    """The floor at the left (1) or right (-1) of each box."""
    left = np.stack([-np.sin(found.yaw), np.cos(found.yaw)], -1)
    center, size = found.center.copy(), found.size.copy()
    center[:, :2] += sign * left * (found.size[:, 1:2] + width) / 2
    size[:, 1] = width
    return Boxes(center, size, found.yaw)
