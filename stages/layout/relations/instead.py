"""What does for something that found no place: as much of it as there is floor for, or another thing."""

import numpy as np

from apartgen.stages.layout.relations import gathered
from apartgen.stages.layout.relations.fixtures import RAIL
from apartgen.stages.layout.relations.followers import LOW, STAND, known, leading, stands
from apartgen.stages.layout.relations.hung import MIRROR, over
from apartgen.stages.layout.relations.places import about, along, at_walls, likeliest
from apartgen.stages.layout.relations.sizes import Sizes, narrowest
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

BESIDE = ((STAND, (0.42, 0.40, 0.52)), (STAND, (0.40, 0.34, 0.52)),
          *(("side_table", (wide, wide, 0.55)) for wide in (0.45, 0.38, 0.32)))
"""What stands at the head of a bed, m, the best first: before a small table nobody has to stand to open it."""
SMALL_DESK = (0.55, 0.9, 0.74)
"""A desk for a small room, m."""
RUG, RUGS = "rug", ((1.6, 2.3), (1.4, 2.0), (1.2, 1.7))
"""Rugs as they are sold, m."""
BELOW = tuple((0.0, aside, 0.0) for aside in (0.0, 0.2, -0.2, 0.4, -0.4))
"""Where one lies below a low table, m from its middle: aside of a door that opens over it."""
LOW_TABLES = ((0.5, 0.9), (0.45, 0.6))
"""Low tables where a usual one finds no place, m."""
NARROW = (1.0, 0.8, 0.7)
"""Wardrobes where one sleeps and none of two finds a place, m."""


def alternatives(name: str, boxes: Array, there: Furniture, large: Sizes) -> list[tuple[str, Array]]:
    """What does for something that found no place, the best first, and places (m, 7) for it: towels, mirrors and
    wardrobes of another kind and narrow ones at all walls, armchairs about sofas, small low tables before them, rugs
    below these, narrower nightstands and small tables beside the heads of beds."""
    kind = kinds.basic(name)
    beds = [box for o, box in zip(there.names, there.boxes, strict=True) if kinds.basic(o) in kinds.BEDS]
    if name == RAIL:
        narrow = boxes.copy()
        narrow[:, 4] = TABLE[name].min[1]
        return [(name, at_walls(some, there.space)) for some in (boxes, narrow)]
    if kind == LOW:
        return [(name, known(name, _sized(boxes, size), there.names, there.boxes)) for size in LOW_TABLES]
    if name == MIRROR:
        above = over(name, boxes, there.names, there.boxes)
        open_ = len(above) > 0 and bool((there.prices(name, above) < BROKEN).any())
        return [] if open_ else [(name, at_walls(boxes, there.space))]
    if kind == gathered.SEAT:
        return [(name, gathered.places(there.names, there.boxes, likeliest(boxes)))]
    if kind == RUG:
        low = [box for o, box in zip(there.names, there.boxes, strict=True) if kinds.basic(o) == LOW]
        return [(name, np.concatenate([about(box, BELOW, (*size, likeliest(boxes)[2])) for box in low]))
                for size in RUGS if low]
    if kind in kinds.DESKS:
        return [(name, along(there.space, size)) for size in (likeliest(boxes), SMALL_DESK)]
    if kind in kinds.WARDROBES:
        depth, _, height = likeliest(boxes)
        slim = [("wardrobe", along(there.space, (depth, width, height))) for width in NARROW if beds]
        return [(other, leading(other, _real(other, boxes), there.space, narrowest(large, other)))
                for other in TABLE[name].instead] + slim
    if kind != STAND or not beds:
        return []
    return [(other, np.concatenate([about(bed, stands(kind, bed, size), size) for bed in beds]))
            for other, size in BESIDE]


def _real(name: str, boxes: Array) -> Array:
    """Candidates (n, 7) as deep and wide as things of a name are at least and at most."""
    found = boxes.copy()
    found[:, 3:5] = np.clip(boxes[:, 3:5], TABLE[name].min[:2], TABLE[name].max[:2])
    return found


def _sized(boxes: Array, size: tuple[float, float]) -> Array:
    """Candidates (n, 7) no deeper and wider than a size, m."""
    found = boxes.copy()
    found[:, 3:5] = np.minimum(boxes[:, 3:5], size)
    return found
