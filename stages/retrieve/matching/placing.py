"""Where an asset stands once its real size is known: against its wall, inside its room, clear of the others."""

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry, Polygon
from shapely.ops import unary_union

from apartgen.schemas.carrying import CEILING, WALL
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan
from apartgen.stages.space import boxes, polygons
from apartgen.stages.space.boxes import TOLERANCE, Boxes
from apartgen.stages.things.categories import TABLE, belong_together

Array = NDArray[np.float64]

STEPS = (0.0, 0.05, -0.05, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3)
"""Shifts tried along each axis when a box had to grow, m."""


def bottom(on: str, box: Boxes, height: float) -> float:
    """Height of the underside above the floor, m, by what carries it; what stands on an object is placed later."""
    h = float(box.size[0, 2])
    if on == CEILING:
        return height - h
    if on == WALL:
        return float(np.clip(box.center[0, 2] - h / 2, 0, max(height - h, 0)))
    return 0.0


def at_height(box: Boxes, low: float) -> Boxes:
    """One box with its underside at `low`."""
    center = box.center.copy()
    center[0, 2] = low + box.size[0, 2] / 2
    return box._replace(center=center)


class Others(NamedTuple):
    """What else stands in the way, and how deep each may be entered: the contact tolerance, or as deep as before."""

    boxes: Boxes
    allowed: Array


def others(box: Boxes, category: str, stack: Boxes, categories: Sequence[str]) -> Others:
    """The objects a box must keep clear of; what it belongs with, and rugs, are none."""
    soft = TABLE[category].soft
    apart = [not (soft or TABLE[name].soft or belong_together(category, name)) for name in categories]
    kept = stack.take(np.array(apart, bool))
    before = boxes.penetration(box, kept)[0] if kept.n else np.zeros(0)
    return Others(kept, np.maximum(before, TOLERANCE) + 1e-9)


class Site(NamedTuple):
    """A room's floor, and the part of it that its doors need."""

    floor: Polygon
    doorways: Geometry


def sites(plan: Plan) -> dict[str, Site]:
    """Every room's site by id."""
    zones = {o.id: polygons.clearance(o, plan) for o in plan.openings}
    return {
        room.id: Site(polygons.floor(room), unary_union([zones[o.id] for o in plan.openings if room.id in o.rooms]))
        for room in plan.rooms
    }


def grown(box: Boxes, before: Boxes, site: Site, others: Others) -> Boxes | None:
    """The nearest place for a box that outgrew the one it had; None if there is none within `STEPS`.

    It stays in its room, keeps clear of the others, and stands no further in a doorway than `before`.
    """
    wide = site.floor.buffer(TOLERANCE, join_style="mitre")
    blocked = site.doorways.intersection(boxes.footprints(before)[0]).area + 1e-4
    axes = boxes.axes(box)[0]
    for shift in sorted(product(STEPS, STEPS), key=lambda s: (abs(s[0]) + abs(s[1]), s)):
        moved = box._replace(center=box.center + np.array([[*(np.asarray(shift) @ axes), 0.0]]))
        if others.boxes.n and (boxes.penetration(moved, others.boxes)[0] > others.allowed).any():
            continue
        footprint = boxes.footprints(moved)[0]
        if wide.covers(footprint) and site.doorways.intersection(footprint).area <= blocked:
            return moved
    return None


def one(box: Box) -> Boxes:
    """An artifact's box as an array of one."""
    return boxes.of([box])
