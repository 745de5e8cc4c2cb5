"""Beds no wider than two need, where a wider one leaves no nightstand its place."""

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.places import STEP, along, likeliest
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.use import kinds

NARROW = (2.03, 1.42)
"""A bed for a mattress of 1.4 by 2 m, the least that is sold for two, m."""
SHARES = (0.0, 1 / 3, -1 / 3)
"""Between two places along a wall it is tried so far on, too: what is left beside it is a matter of inches."""


def narrower(name: str, boxes: Array, space: Space) -> list[tuple[str, Array]]:
    """A bed of two that is as narrow as they are, and places (m, 7) of it along all walls; none of anything else, or
    where candidates (n, 7) are no wider."""
    if kinds.basic(name) not in kinds.DOUBLE or likeliest(boxes)[1] <= NARROW[1]:
        return []
    places = along(space, (*NARROW, likeliest(boxes)[2]))
    way = np.column_stack([-np.sin(places[:, 2]), np.cos(places[:, 2]), np.zeros((len(places), 5))])
    return [(name, np.concatenate([places + share * STEP * way for share in SHARES]).astype(np.float32))]
