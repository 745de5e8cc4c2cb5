"""How much floor furniture takes: footprints, walkable area, standing on and behind.

An obstacle is what people walk around: higher than 3 cm (no rugs), hanging lower than 1.8 m, not from the ceiling.
"""

from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from shapely import Geometry
from shapely.ops import unary_union

from apartgen.schemas.carrying import CEILING
from apartgen.schemas.layout import Box
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Mask
from apartgen.stages.things import categories
from apartgen.stages.things.carrying import by_another

FLAT = 0.03
"""What is no higher is walked on, m."""
HEADROOM = categories.LEAST_CLEARANCE_HEIGHT
"""What hangs above is walked under, m."""


def is_obstacle(o: Box) -> bool:
    """Whether one walks around it."""
    bottom, top = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
    return top > FLAT and bottom < HEADROOM and not _hangs_above(o)


def _hangs_above(o: Box) -> bool:
    if o.on is not None:
        return o.on == CEILING
    return o.category in categories.TABLE and categories.TABLE[o.category].place == CEILING


def gives_way(o: Box) -> bool:
    """Whether it is no hindrance to what touches it: a rug, a curtain."""
    kind = categories.TABLE.get(o.category)
    return is_flat(o) or (kind is not None and kind.soft)


def is_flat(o: Box) -> bool:
    """Whether it is part of the floor: a rug or anything as thin."""
    return o.center[2] + o.size[2] / 2 <= FLAT


def obstacles(objects: Sequence[Box]) -> Mask:
    """Which objects one walks around, (n,)."""
    return np.array([is_obstacle(o) for o in objects], bool)


def area(o: Box) -> float:
    """Area of its footprint, m²."""
    return o.size[0] * o.size[1]


def covered(objects: Iterable[Box]) -> Geometry:
    """Union of the footprints of all obstacles."""
    standing = [o for o in objects if is_obstacle(o)]
    return unary_union(list(boxes.footprints(boxes.of(standing))))


def walkable_ratio(floor: Geometry, objects: Iterable[Box]) -> float:
    """Share of a floor that no obstacle covers; overlapping footprints count once."""
    return 1.0 - float(shapely.area(shapely.intersection(floor, covered(objects)))) / float(floor.area)


def plain_ratio(floor: Geometry, objects: Iterable[Box]) -> float:
    """Eq. 12 as printed: floor area less the sum of all footprints, over floor area; may be negative.

    What stands on other furniture has no footprint on the floor.
    """
    standing = [o for o in objects if is_obstacle(o) and not by_another(o)]
    return 1.0 - sum(area(o) for o in standing) / float(floor.area)
