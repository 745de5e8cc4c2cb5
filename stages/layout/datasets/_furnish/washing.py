"""Washing: bathrooms by the clearances of their fixtures, utility rooms with their machines."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors, dressing, storing
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone
from apartgen.stages.layout.datasets._furnish.household import Household
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array

BEFORE, BEFORE_SMALL, BEFORE_LEAST = 0.76, 0.62, 0.54
"""Floor before basin and toilet: wanted, wanted in small rooms, and the least, m."""
AMPLE = 0.5
"""In this share of attempts more floor is wanted everywhere."""
BATH_BEFORE, SHOWER_BEFORE = (0.76, 0.62, 0.55), (0.76, 0.68, 0.62)
"""Floor before baths and showers, the most wanted first, m."""
AXIS, AXIS_LEAST = 0.43, 0.385
"""From a toilet's axis to what stands beside it, m."""


def bathroom(space: Space, home: Household) -> None:
    """Shower or bath first, then toilet and basin, each with its floor; then what else there is place for."""
    rng, area = space.rng, space.shape.area
    ample = rng.random() < AMPLE
    before = BEFORE if area > 4.5 and ample else BEFORE_SMALL if area > 4.5 or ample else BEFORE_LEAST
    powder = area < 2.3
    first = rng.random() < 0.5
    if first:
        _toilet(space, before)
    if not powder:
        space.need(_tub(space, ample), 5)
    if not first:
        _toilet(space, before)
    space.need(_basin(space, before, 2 if area > 7 and space.wants("two basins", 0.25) else 1))
    if space.lost:
        return
    if area > 6.5 and space.has("bath"):
        space.wish("shower", 0.4, lambda: _shower(space, ample))
    laundry = home.laundry if home.laundry is not None else space.wants("laundry", 0.5)
    if laundry and area > 3.6 and (powder or space.has("shower", "bath")):
        space.need(machine(space, space.wants("dryer", 0.15)))
    dressing.ceiling_lamps(space)
    if not powder:
        space.wish("rail", 0.8, lambda: dressing.on_wall(space, "towel_rail", ("shower", "bath")))
    space.wish("bin", 0.6, lambda: storing.loose(space, "bin", -0.7, ("toilet", "vanity")))
    if area > 4.5:
        space.wish("basket", 0.4, lambda: storing.loose(space, "laundry_basket"))
    dressing.radiators(space, 0.15)
    if area > 5:
        space.wish("plant", 0.12, lambda: storing.plant(space, small=True))
    space.wish("shelf", 0.15, lambda: dressing.on_wall(space, "wall_shelf", ("vanity",), -0.7))
    if not laundry:
        space.wish("heater", 0.08, lambda: dressing.on_wall(space, "water_heater", (), corner=0.8))


def _tub(space: Space, ample: bool) -> bool:
    bath = space.shape.area > 3.4 and space.rng.random() < 0.45
    return _bath(space, ample) or _shower(space, ample) if bath else _shower(space, ample) or _bath(space, ample)


def _bath(space: Space, ample: bool) -> bool:
    """In a corner, rather from wall to wall."""
    walls = [float(x) - 0.006 for x in space.shape.length if 1.4 <= x <= 1.906]
    for width in (*walls, float(space.rng.choice([1.6, 1.7, 1.7, 1.8])), 1.5, 1.4):
        size = draw("bath", space.rng, width=width)
        for before in BATH_BEFORE if ample else BATH_BEFORE[-1:]:
            group = Group((Part("bath", size[0] / 2, 0.0, size),), (Zone(size[0], size[0] + before, -0.4, 0.4),))
            at = anchors.walls(space, group)
            at = at.take(anchors.cornered(at, group, space) > 0.5) if len(at) else at
            if not len(at):
                continue
            liking = 0.6 * (np.abs(space.shape.length[at.side] - size[1]) < 0.25)
            liking = liking + 0.3 * np.minimum(anchors.to_doors(at.xy, space), 3)
            if space.put(group, at, liking, 0.25) >= 0:
                return True
    return False


def _shower(space: Space, ample: bool) -> bool:
    rng = space.rng
    for width, depth in ((float(rng.choice([0.9, 1.0, 1.2])), float(rng.choice([0.8, 0.9]))), (0.9, 0.9), (0.8, 0.8)):
        size = draw("shower", rng, 0.0, width=width, depth=depth)
        size[2], half = min(size[2], space.shape.height - 0.1), min(size[1] / 2, 0.45)
        for before in SHOWER_BEFORE if ample else SHOWER_BEFORE[-1:]:
            group = Group((Part("shower", size[0] / 2, 0.0, size),), (Zone(size[0], size[0] + before, -half, half),))
            at = anchors.walls(space, group)
            at = at.take(anchors.cornered(at, group, space) > 0) if len(at) else at
            if not len(at):
                continue
            liking = 0.35 * np.minimum(anchors.to_doors(at.xy, space), 3) - 1.0 * anchors.windowed(at, group, space)
            if space.put(group, at, liking, 0.25) >= 0:
                return True
    return False


def _toilet(space: Space, before: float) -> bool:
    size = draw("toilet", space.rng)
    tight = space.shape.area < 4.5 and before == BEFORE_LEAST
    for axis, free in ((AXIS_LEAST if tight else AXIS, before), (AXIS_LEAST, before), (AXIS_LEAST, BEFORE_LEAST)):
        group = Group((Part("toilet", size[0] / 2, 0.0, size),),
                      (Zone(0.02, size[0], -axis, axis), Zone(size[0], size[0] + free, -0.3, 0.3)))
        at = anchors.walls(space, group, (0.005,))
        if not len(at):
            continue
        near = np.minimum(at.s, space.shape.length[at.side] - at.s)
        liking = 0.3 * np.minimum(anchors.to_doors(at.xy, space), 2.0) - 0.8 * np.minimum(near - axis, 1.2)
        liking -= 0.6 * anchors.seen_from_doors(at, 0.4, space) + 0.3 * anchors.windowed(at, group, space)
        if space.put(group, at, liking, 0.25) >= 0:
            return True
    return False


def _basin(space: Space, before: float, count: int) -> bool:
    rng, area = space.rng, space.shape.area
    wide = 0.5 if area < 2.5 else float(rng.choice([0.6, 0.6, 0.8] if area < 5 else [0.6, 0.8, 0.8, 1.0, 1.2]))
    for width, free, n in ((wide, before, count), (wide, before, 1), (0.6, before, 1), (0.5, before, 1),
                           (0.5, BEFORE_LEAST, 1), (0.45, BEFORE_LEAST, 1)):
        size = draw("vanity", rng, -0.2, width=width)
        size[0] = size[0] if width > 0.5 else 0.36
        group = _basins(space, size, n, free)
        at = anchors.walls(space, group, (0.005,))
        if not len(at):
            continue
        liking = -0.3 * np.minimum(anchors.to_doors(at.xy, space), 2.5) - 1.5 * anchors.windowed(at, group, space)
        liking += 0.3 * anchors.cornered(at, group, space) * (rng.random() < 0.4)
        if space.put(group, at, liking, 0.3) >= 0:
            return True
    return False


def _basins(space: Space, size: Array, n: int, free: float) -> Group:
    mirror = draw("mirror", space.rng, 0.0)
    mirror[1] = round(float(np.clip(size[1] * space.rng.uniform(0.75, 1.0), 0.35, 1.4)), 3)
    mirror[2] = round(float(min(mirror[2], 1.0)), 3)
    parts: list[Part] = []
    for k in range(n):
        y = (k - (n - 1) / 2) * (size[1] + 0.08)
        parts.append(Part("vanity", size[0] / 2, y, size))
        parts.append(Part("mirror", mirror[0] / 2 + 0.002, y, mirror, z=round(float(size[2]) + 0.15, 3), at=2 * k))
    half = max((n * size[1] + 0.08 * (n - 1)) / 2, 0.39 if free > BEFORE_LEAST else 0.33)
    return Group(tuple(parts), (Zone(0.02, size[0] + free, -half, half),))


def machine(space: Space, dryer: bool) -> bool:
    """A washing machine, a dryer beside it where there is one."""
    rng = space.rng
    for size in (draw("washing_machine", rng, 0.0), draw("washing_machine", rng, -1.0)):
        for n in (2, 1) if dryer else (1,):
            group = storing.row("washing_machine", size)
            if n == 2:
                other = np.array([size[0] + 0.02, 0.6, size[2]])
                group = Group((*group.parts, Part("dryer", other[0] / 2, size[1] / 2 + 0.32, other, at=0)), group.zones)
            if storing.against_wall(space, group, 0.8, -0.2, gaps=(0.02,)) >= 0:
                return True
    return False


def utility(space: Space, home: Household) -> None:
    """Machines, shelves, an ironing board."""
    rng, area = space.rng, space.shape.area
    space.need(machine(space, space.wants("dryer", 0.5)), 2)
    space.wish("sink", 0.55, lambda: _sink(space))
    space.wish("shelving", 0.78, lambda: storing.cabinet(space, "shelving", 1 + int(area > 5 and rng.random() < 0.4)))
    for name, share in (("ironing_board", 0.4), ("laundry_basket", 0.7), ("bin", 0.3)):
        space.wish(name, share, lambda name=name: storing.loose(space, name))  # type: ignore[misc]
    space.wish("heater", 0.35, lambda: dressing.on_wall(space, "water_heater", corner=0.8))
    if area > 3:
        space.wish("shelf", 0.25, lambda: dressing.on_wall(space, "wall_shelf"))
    dressing.ceiling_lamps(space)


def _sink(space: Space) -> bool:
    size = draw("kitchen_sink", space.rng, -0.5)
    group = Group((Part("kitchen_sink", size[0] / 2, 0.0, size),),
                  (Zone(size[0], size[0] + 0.6, -size[1] / 2, size[1] / 2),))
    return storing.against_wall(space, group, 0.4, 0.2, ("washing_machine",), (0.006,)) >= 0
