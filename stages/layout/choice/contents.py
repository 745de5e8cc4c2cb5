"""Contents: what those who live there miss, and what is too much; without it the emptiest room would be best."""

from apartgen.stages.use import Furnished, lacks


def cost(room: Furnished) -> float:
    """Sum of what is lacking costs."""
    return sum(lack.cost for lack in lacks(room))
