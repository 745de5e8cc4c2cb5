"""Furnishes one room: a few whole attempts, the best kept."""

from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish.household import Household
from apartgen.stages.layout.datasets._furnish.rooms import ESSENTIAL, FURNISH
from apartgen.stages.layout.datasets._furnish.shape import Shape
from apartgen.stages.layout.datasets._furnish.space import MOST, Space

ATTEMPTS = 14
STRICT = 0.6
"""In this share of attempts what lacks something that matters is given up at once."""
ESSENTIAL_WORTH = 10.0
EATING = (frozenset({"dining_table", "round_table"}), frozenset({"chair"}))


def furnish(shape: Shape, rng: Generator, home: Household, count: int | None = None) -> Space:
    """A furnished room with at most `count` objects; what lacks what its type cannot do without is begun again."""
    best, most = None, -1e9
    needed = ESSENTIAL[shape.type] + EATING * bool(home.table)
    taste: dict[str, float] = {}
    for nth in range(ATTEMPTS):
        space = Space(shape, rng, min(MOST, MOST if count is None else count), taste, nth < STRICT * ATTEMPTS)
        FURNISH[shape.type](space, home)
        have = set(space.placed.name)
        lacking = sum(not have & names for names in needed)
        worth = 100.0 - ESSENTIAL_WORTH * lacking - space.missed + 0.05 * space.n
        if worth > most:
            best, most = space, worth
        if not lacking and space.missed <= nth // 5 and space.n:
            break
    assert best is not None
    return best
