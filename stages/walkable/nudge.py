"""Small shifts of an object and its company: what stands on it, and seats drawn up to it."""

from collections.abc import Iterator
from itertools import product

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.space import anchors, boxes
from apartgen.stages.things import categories
from apartgen.stages.things.carrying import carried
from apartgen.stages.walkable import placing
from apartgen.stages.walkable.site import Changes, Scene, Site

SHIFTS = (0.0, 0.05, -0.05, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3)
"""Along each of the object's axes, m."""
DRAWN_UP = 0.15
"""Seats this close to what they belong to go with it, m."""


def nudges(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """Shifts, short ones first; backs and sides at walls slide along them. Whether they fit is not looked at."""
    along, across = anchors.anchors(boxes.of([o]), site.floors[o.room])
    axes = boxes.axes(boxes.of([o]))[0]
    company = [o, *carried(o, scene), *_seats(scene, o)]
    shifts = [s for s in product((0.0,) if along else SHIFTS, (0.0,) if across else SHIFTS) if any(s)]
    for shift in sorted(shifts, key=lambda s: (np.hypot(*s), s)):
        by = np.asarray(shift) @ axes
        yield {p.id: placing.moved(p, by.tolist()) for p in company}


def _seats(scene: Scene, o: Furnishing) -> list[Furnishing]:
    kin = [p for p in scene if p.room == o.room and p.category in categories.TABLE
           and o.category in categories.TABLE[p.category].belongs and categories.TABLE[p.category].place == "floor"
           and not categories.TABLE[p.category].back]
    if not kin:
        return []
    close = boxes.gap(boxes.of([o]), boxes.of(kin))[0] < DRAWN_UP
    return [p for p, hit in zip(kin, close) if hit]
