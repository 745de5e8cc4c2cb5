"""Distances: a screen not far from its sofa, a table where one eats not close to it, nor far from the kitchen."""

import numpy as np

from apartgen.stages.layout.relations.distances import MEALS, VIEW
from apartgen.stages.use import Furnished
from apartgen.stages.use.kinds import TABLES
from apartgen.stages.use.rules.sit import main_sofa, shown

STEEP = 0.4
"""What each metre costs."""


CARRIED, FARTHER = 3.0, 0.25
"""Dishes are carried so far from the door to the table, m, and what each metre more costs."""


def cost(room: Furnished) -> float:
    """Of a sofa, and of the table where a home eats."""
    return _of_sofa(room) + _of_meals(room)


def _of_meals(room: Furnished) -> float:
    doors = [hole.middle for hole in room.site.passages if hole.id in room.site.served]
    tables = room.which(TABLES)
    if not doors or not tables:
        return 0.0
    far = min(np.hypot(*(room.boxes.center[k, :2] - door)) for k in tables for door in doors)
    return FARTHER * max(0.0, float(far) - CARRIED)


def _of_sofa(room: Furnished) -> float:
    main = main_sofa(room)
    if main is None:
        return 0.0
    view = [float(room.gap[main, k]) for k in shown(room) if room.aside[main, k] < 60]
    meals = [float(room.gap[main, k]) for k in room.which(TABLES)]
    return STEEP * (max(0.0, min(view, default=VIEW) - VIEW) + max(0.0, MEALS - min(meals, default=MEALS)))
