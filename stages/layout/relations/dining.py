"""Tables no longer than those who eat there need, where a longer one leaves them no place."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.places import all_over, likeliest
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

CHAIR, ROUND = "chair", "round_table"
ELBOW, CORNERS, FOUR = 0.6, 0.2, 4
"""Of the edge each diner has, and more of it where two sit at the ends, as they do where more than so many eat, m."""
DEEP = 0.85
"""From one side to the other, m."""


def smaller(name: str, boxes: Array, space: Space, left: Sequence[str]) -> Array:
    """Places (m, 7) all over the room for a table that is just as long as the chairs `left` to come need; none where
    candidates (n, 7) are no longer."""
    chairs = left.count(CHAIR)
    if kinds.basic(name) not in kinds.TABLES - {ROUND} or not chairs:
        return boxes[:0]
    depth, width, height = likeliest(boxes)
    ends = chairs > FOUR
    least = max(ELBOW * -(-(chairs - 2 * ends) // 2) + CORNERS * ends, float(TABLE[name].min[1]))
    if least > width - CORNERS / 2:
        return boxes[:0]
    return np.asarray(all_over(space, (min(depth, DEEP), least, height)))
