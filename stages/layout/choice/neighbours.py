"""Neighbours: the way of a door, the sun on a screen, the group that a way leads through."""

from apartgen.stages.use import Furnished, rules, weights


def cost(room: Furnished) -> float:
    """Sum of the weights of faults with doors and windows."""
    return sum(weights()[fault.name] for fault in rules()["neighbours"].faults(room))
