"""Tables no longer than those who eat there need, where a longer one, or a round one, leaves them no place."""

from collections.abc import Sequence

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.places import all_over, likeliest
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

CHAIR, ROUND, LONG = "chair", "round_table", "dining_table"
ELBOW, CORNERS, FOUR = 0.6, 0.2, 4
"""Of the edge each diner has, and more of it where two sit at the ends, as they do where more than so many eat, m."""
DEEP = 0.85
"""From one side to the other, m."""


def others(name: str, boxes: Array, space: Space, left: Sequence[str]) -> list[tuple[str, Array]]:
    """Tables that do where one as large as candidates (n, 7) finds no place, and places (m, 7) of them all over the
    room: one that is just as long as the chairs `left` to come need; none where candidates are no longer."""
    chairs = left.count(CHAIR)
    if kinds.basic(name) not in kinds.TABLES or not chairs:
        return []
    depth, width, height = likeliest(boxes)
    ends, other = chairs > FOUR, LONG if kinds.basic(name) == ROUND else name
    least = max(ELBOW * -(-(chairs - 2 * ends) // 2) + CORNERS * ends, float(TABLE[other].min[1]))
    if least > width - CORNERS / 2 and other == name:
        return []
    return [(other, all_over(space, (min(depth, DEEP), least, height)))]
