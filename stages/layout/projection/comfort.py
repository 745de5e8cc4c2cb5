"""What makes a place pleasant that breaks no requirement: seats look into the room, beds have sides to get in from."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.partners import SOFAS
from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.space.boxes import Boxes, penetration
from apartgen.stages.things.categories import SEATS, TABLE, those

Array = NDArray[np.float64]
FACED = 2.0
"""A seat before a wall is worth a way of this many metres, elsewhere."""
SIDE = 1.5
"""Nowhere to get into a bed from at one side is worth as much, m."""
OPEN = 2.5
"""What stands aside as a rule costs as much in the open, m."""
DAZZLED = 1.5
"""What has a mirror or a screen above it costs as much below a window, m."""
KEPT_OFF = those(lambda kind: kind.is_for("dine", "work") and not kind.back)
"""What does not stand between a sofa and what it looks at, LOUNGE m deep; there it costs as much as OPEN."""
LOUNGE = 1.3
ELBOW = 0.85
"""A seat nearer than this to another, m, costs as much as OPEN: two people sit across a table, not side by side."""
BEFORE = {name: kind.stands.before for name, kind in TABLE.items() if kind.stands.before}
CRAMPED = 2.0
"""A place without the floor before it, or behind it to draw it back, costs as much, m."""
ABOVE = those(lambda kind: kind.run == "hung" and kind.articulated)
"""What hangs above something that stands on the floor; elsewhere it costs BARE metres."""
BARE = 2.5
WORKTOP = 1.3
"""What is lower has something hung above it, m."""
CROWD = 1.5
"""Another lamp on the ceiling this near, m, costs as much."""


def price(category: str, found: Boxes, space: Space, standing: Boxes, names: list[str]) -> Array:
    """What each place (n,) lacks, in metres of shifting."""
    total, stands = np.zeros(found.n), TABLE[category].stands
    if stands.view:
        total += FACED * (outside(_before(found, stands.view), space) > 0.05)
    if stands.sides:
        for sign in (1.0, -1.0):
            total += SIDE * _taken(_aside(found, stands.sides, sign), space, standing)
    if stands.before:
        total += CRAMPED * _taken(_before(found, stands.before), space, standing)
    if stands.drawn:
        turned = Boxes(found.center, found.size, found.yaw + np.pi)
        total += CRAMPED * _taken(_before(turned, stands.drawn), space, standing)
    for name, depth in BEFORE.items():
        kept = _before(standing.take(np.array([other == name for other in names], bool)), depth)
        if kept.n and TABLE[category].place == "floor":
            total += CRAMPED * (penetration(found, kept) > 0.05).any(1)
    if category in ABOVE:
        total += BARE * ~_over(found, standing, names)
    if stands.dazzled and space.window.any():
        tall = Boxes(found.center * [1, 1, 0] + [0, 0, 1.0], found.size * [1, 1, 0] + [0, 0, 2.0], found.yaw)
        total += DAZZLED * (penetration(tall, space.zones.take(space.window)) > 0.01).any(1)
    if stands.aside:
        total += OPEN * (space.away(found.center[:, :2]) > found.size[:, :2].min(1) / 2 + 0.25)
    if category in KEPT_OFF:
        sofas = standing.take(np.array([name in SOFAS for name in names], bool))
        if sofas.n:
            total += OPEN * (penetration(found, _before(sofas, LOUNGE)) > 0.05).any(1)
    if category in SEATS:
        seats = standing.take(np.array([name in SEATS for name in names], bool))
        apart = np.linalg.norm(found.center[:, None, :2] - seats.center[None, :, :2], axis=-1)
        total += OPEN * (apart < ELBOW).any(1)
    if stands.bare_below and standing.n:
        flat = [Boxes(b.center * [1, 1, 0], b.size * [1, 1, 0] + [0, 0, 1], b.yaw) for b in (found, standing)]
        total += OPEN * (penetration(*flat) > 0.05).any(1)
    if TABLE[category].place == "ceiling":
        lamps = standing.take(np.array([TABLE[name].place == "ceiling" for name in names], bool))
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
