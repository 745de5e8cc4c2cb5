"""Crowding: floor to walk on, so that the fullest room is not best either."""

import numpy as np

from apartgen.stages.use import Furnished

LEAST = {"bedroom": 0.50, "living_room": 0.55, "kitchen": 0.50, "bathroom": 0.45, "hallway": 0.70, "dining_room": 0.55}
"""Free floor below which a room is crowded; homes that people live in have .64 to .92."""
DEFAULT = 0.45
STEEP = 8.0
"""What the whole floor would cost."""


def cost(room: Furnished) -> float:
    """In proportion to the floor that is lacking; footprints are taken as they are, without their overlaps."""
    taken = float(np.prod(room.boxes.size[room.upright, :2], axis=1).sum()) if room.upright else 0.0
    return STEEP * max(0.0, LEAST.get(room.site.kind, DEFAULT) - (1 - taken / room.site.area))
