"""Distances: a screen not far from its sofa, a table where one eats not close to it."""

from apartgen.stages.layout.relations.distances import MEALS, VIEW
from apartgen.stages.use import Furnished
from apartgen.stages.use.kinds import TABLES
from apartgen.stages.use.rules.sit import main_sofa, shown

STEEP = 0.4
"""What each metre costs."""


def cost(room: Furnished) -> float:
    """Of a room with a sofa."""
    main = main_sofa(room)
    if main is None:
        return 0.0
    view = [float(room.gap[main, k]) for k in shown(room) if room.aside[main, k] < 60]
    meals = [float(room.gap[main, k]) for k in room.which(TABLES)]
    return STEEP * (max(0.0, min(view, default=VIEW) - VIEW) + max(0.0, MEALS - min(meals, default=MEALS)))
