"""Axes: what is used together is centred on one line, and large things stand at walls or in the middle of them."""

import numpy as np

from apartgen.stages.use import Furnished
from apartgen.stages.use.kinds import DOUBLE
from apartgen.stages.use.rules.sit import before, main_sofa, shown

OFF = 0.3
"""Nobody minds less than this beside the axis, m."""
ASIDE, FLOATING, UNPAIRED = 0.3, 0.7, 0.2
"""What costs: each thing beside its axis, a sofa with its back to nothing, a bed whose nightstands are no pair."""
TURNED, FARTHEST = 0.8, 1.0
"""What each metre more costs that a screen is beside the axis, for heads are turned to it; up to so many."""
BACKED = 0.35
"""A sofa's back is at a wall or at something within this, m."""


def cost(room: Furnished) -> float:
    """Over the seats of a living room and the beds of a bedroom."""
    return _sofa(room) + sum(_bed(room, bed) for bed in room.which(DOUBLE))


def _sofa(room: Furnished) -> float:
    main = main_sofa(room)
    if main is None:
        return 0.0
    tables = [t for t in room.which("coffee_table") if before(room, main, t)]
    screens = [s for s in shown(room) if room.aside[main, s] < 60]
    far = sum(abs(room.left[main, k]) > OFF for k in tables + screens)
    turned = sum(min(max(abs(room.left[main, k]) - OFF, 0.0), FARTHEST) for k in screens)
    backed = room.back[main] < BACKED or any(
        k != main and room.gap[main, k] < BACKED and room.ahead[main, k] < 0 for k in room.upright)
    return float(ASIDE * far + TURNED * turned + FLOATING * (not backed))


def _bed(room: Furnished, bed: int) -> float:
    """Of two nightstands, mirrored about the bed's axis and of one size."""
    pair = room.which("nightstand")
    if len(pair) != 2:
        return 0.0
    i, j = pair
    mirrored = abs(room.ahead[bed, i] - room.ahead[bed, j]) < 0.1 and abs(room.left[bed, i] + room.left[bed, j]) < 0.15
    return 0.0 if mirrored and np.abs(room.boxes.size[i] - room.boxes.size[j]).max() < 0.03 else UNPAIRED
