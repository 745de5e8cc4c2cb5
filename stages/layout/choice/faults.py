"""Faults of use: furniture that nobody could use where it stands."""

from apartgen.stages.use import Furnished, faults, weights


def cost(room: Furnished) -> float:
    """Sum of the weights of all faults but those with neighbours."""
    return sum(weights()[fault.name] for fault in faults(room, but=("neighbours",)))
