"""Furnishes one room: a few whole attempts, the best kept."""

from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish.household import Household
from apartgen.stages.layout.datasets._furnish.rooms import ESSENTIAL, FURNISH
from apartgen.stages.layout.datasets._furnish.shape import Shape
from apartgen.stages.layout.datasets._furnish.space import MOST, Space

ATTEMPTS = 6
EATING = (frozenset({"dining_table", "round_table"}), frozenset({"chair"}))


def furnish(shape: Shape, rng: Generator, home: Household, count: int | None = None) -> Space:
    """A furnished room with at most `count` objects; what lacks what its type cannot do without is begun again."""
    best, most = None, -1.0
    needed = ESSENTIAL[shape.type] + EATING * bool(home.table)
    for _ in range(ATTEMPTS):
        space = Space(shape, rng, min(MOST, MOST if count is None else count))
        FURNISH[shape.type](space, home)
        have = set(space.placed.name)
        worth = sum(1.0 for names in needed if have & names) + 0.01 * space.n
        if worth > most:
            best, most = space, worth
        if worth >= len(needed) and space.n:
            break
    assert best is not None
    return best
