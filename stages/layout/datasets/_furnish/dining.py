"""Eating: a table with its chairs, all alike, across from one another, drawn up to it; a lamp above."""

from dataclasses import replace

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Poses, Zone
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import CATEGORIES

TABLES = ("dining_table", "round_table")
PLACE = 0.62
"""Table edge a diner has, m."""
DRAWN, DRAWN_LEAST = 0.75, 0.64
"""From the table's edge to what stands behind a chair, m; in small rooms."""
APART = 0.4
"""From sofa and coffee table to a dining table, m."""
OTHERS = frozenset(CATEGORIES) - {"sofa", "corner_sofa", "coffee_table"}
WIDTHS = {2: (0.8, 0.9, 1.2), 4: (1.2, 1.4, 1.4, 1.6, 1.6, 1.8), 6: (1.6, 1.8, 1.8, 2.0, 2.2), 8: (2.2, 2.4, 2.6)}
ROUND = {2: (0.8, 0.9), 4: (0.9, 1.0, 1.1, 1.2), 6: (1.3, 1.35, 1.5)}
ABOVE = 0.72
"""A pendant hangs so far above the table, m."""


def furnish(space: Space, seats: int, lamp: float = 0.7) -> bool:
    """A table with so many chairs, or the next fewer that find a place; whether all did."""
    chair = space.model("chair")
    for nth, n in enumerate([seats, seats, seats] + [k for k in (6, 4, 4, 2, 2) if k < seats]):
        if space.left < n + 1:
            continue
        round = n in ROUND and space.wants("round table", 0.22) and nth < 2
        if _round(space, n, chair, lamp) if round else _straight(space, n, chair, lamp, nth > 0):
            return n == seats
    return False


def _tuck(space: Space, chair: Array) -> float:
    return round(float(chair[0]) * float(space.rng.uniform(0.12, 0.4)), 3)


def _straight(space: Space, n: int, chair: Array, lamp: float, small: bool) -> bool:
    rng = space.rng
    heads = n in (6, 8) and rng.random() < 0.35
    widths = WIDTHS[n - 2 if heads else n]
    wide = float(min(widths) if small else rng.choice(widths))
    wide = max(wide, 1.6 if heads and n == 6 else 0.0)
    size = np.array([rng.choice([0.8, 0.85, 0.9, 0.9, 0.95, 1.0]) if n > 2 else rng.choice([0.7, 0.75, 0.8]), wide,
                     rng.choice([0.73, 0.74, 0.75, 0.76])])
    drawn = DRAWN if space.shape.area > 26 else DRAWN_LEAST
    free = Group((Part("dining_table", 0.0, 0.0, size), *_chairs(space, size, chair, n, heads)),
                 _zones(size, heads, drawn))
    free = _lit(space, free, lamp)
    for form in rng.permutation(["free", "free", "along", "end"]):
        if form == "free" and _put(space, free, anchors.middle(space)):
            return True
        if form == "along" and _at_wall(space, _moved(free, size[0] / 2 + drawn)):
            return True
        if form == "end" and not heads and _at_wall(space, _end_on(free, size[1] / 2)):
            return True
    return False


def _chairs(space: Space, size: Array, chair: Array, n: int, heads: bool) -> list[Part]:
    tuck, rows = _tuck(space, chair), (n - 2 * heads) // 2
    spread = max(PLACE, min(0.75, size[1] / rows)) if rows > 1 else 0.0
    x = size[0] / 2 + chair[0] / 2 - tuck
    some = [Part("chair", side * x, (k - (rows - 1) / 2) * spread, chair, np.pi if side > 0 else 0.0, at=0)
            for k in range(rows) for side in (1.0, -1.0)]
    y = size[1] / 2 + chair[0] / 2 - 0.08
    return some + [Part("chair", 0.0, side * y, chair, -side * np.pi / 2, at=0) for side in (1.0, -1.0) if heads]


def _zones(size: Array, heads: bool, drawn: float) -> tuple[Zone, ...]:
    d, w = size[0] / 2, size[1] / 2
    out = w + (drawn if heads else 0.42)
    apart = Zone(-d - APART, d + APART, -w - APART, w + APART, OTHERS, False)
    return (Zone(-d - drawn, d + drawn, -w, w, ("chair",)), apart, Zone(-d, d, -out, out, ("chair",)))


def _lit(space: Space, group: Group, chance: float) -> Group:
    if space.rng.random() > chance or len(group.parts) >= space.left:
        return group
    table = group.parts[0].size
    lamp = draw("ceiling_lamp", space.rng)
    lamp[2] = np.clip(space.shape.height - table[2] - ABOVE, 0.3, 1.0)
    lamp[:2] = np.minimum(lamp[:2], min(table[0], 0.7))
    lamp = np.round(lamp, 3)
    return group.with_part(Part("ceiling_lamp", 0.0, 0.0, lamp, z=round(space.shape.height - float(lamp[2]), 4), at=0))


def _put(space: Space, group: Group, at: Poses) -> bool:
    if not len(at):
        return False
    xy = at.xy
    liking = -0.3 * anchors.to_windows(xy, space) + 0.25 * np.minimum(anchors.to_doors(xy, space), 2.0)
    sofa = anchors.to_things(xy, space, "sofa", "corner_sofa")
    liking -= 1.2 * np.maximum(2.9 - sofa, 0.0)
    tables = anchors.to_things(xy, space, "tv_stand")
    liking -= 0.5 * np.maximum(1.8 - tables, 0.0) + 0.25 * _apart(space, xy)
    return space.put(group, at, liking, 0.3) >= 0


def _apart(space: Space, xy: Array) -> Array:
    """How far from the way to a kitchen or an opening, m; 0 without one."""
    wide = space.shape.doors[space.shape.doors[:, 4] > 0.5] if len(space.shape.doors) else space.shape.doors
    if not len(wide):
        return np.zeros(len(xy))
    return np.asarray(np.minimum(np.hypot(*np.moveaxis(xy[:, None] - wide[:, :2], -1, 0)).min(1), 4.0))


def _at_wall(space: Space, group: Group) -> bool:
    return _put(space, group, anchors.walls(space, group, (anchors.OFF, anchors.BESIDE)))


def _moved(free: Group, x: float) -> Group:
    """A long side along the wall, with place for the chairs between."""
    parts = tuple(replace(p, x=p.x + x) for p in free.parts)
    return Group(parts, tuple(replace(z, x0=z.x0 + x + 1e-3, x1=z.x1 + x) for z in free.zones))


def _end_on(free: Group, x: float) -> Group:
    """A short side at the wall: turned by a right angle."""
    return Group(tuple(_turned(p, x) for p in free.parts), tuple(_turned_zone(z, x) for z in free.zones[:2]))


def _turned(p: Part, x: float) -> Part:
    return Part(p.name, x + p.y, -p.x, p.size, p.yaw - np.pi / 2, p.z, p.at)


def _turned_zone(z: Zone, x: float) -> Zone:
    low = max(x + z.y0, 0.01) if z.inside else x + z.y0
    return Zone(low, x + z.y1, -z.x1, -z.x0, z.friends, z.inside)


def _round(space: Space, n: int, chair: Array, lamp: float) -> bool:
    rng = space.rng
    wide = float(rng.choice(ROUND[n]))
    size = np.array([wide, wide, 0.75])
    tuck = min(_tuck(space, chair), 0.14)
    first = float(rng.choice([0.0, np.pi / 4])) if n == 4 else 0.0
    r = wide / 2 + chair[0] / 2 - tuck + (0.06 if n == 6 else 0.0)
    turns = [first + 2 * np.pi * k / n for k in range(n)]
    if first:
        r += 0.04
    chairs = [Part("chair", r * np.cos(t), r * np.sin(t), chair, t + np.pi, at=0) for t in turns]
    out = wide / 2 + (DRAWN if space.shape.area > 26 else DRAWN_LEAST)
    across = out if n > 2 else wide / 2 + 0.2
    near = wide / 2 + APART
    apart = Zone(-near, near, -near, near, OTHERS, False)
    group = Group((Part("round_table", 0.0, 0.0, size), *chairs), (Zone(-out, out, -across, across, ("chair",)), apart))
    at = anchors.middle(space)
    return _put(space, _lit(space, group, lamp), at)


def seats_for(space: Space, sleepers: int) -> int:
    """Chairs for those who live there, now and then two more, as far as the floor allows."""
    n = 2 * ((max(sleepers, 2) + 1) // 2)
    if n == 2 and space.wants("four chairs", 0.8):
        n = 4
    if space.shape.area > 27 and space.wants("two more chairs", 0.2):
        n += 2
    return int(min(n, 8))
