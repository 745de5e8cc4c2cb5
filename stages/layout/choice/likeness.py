"""Likeness: several of one kind are of one size, and every thing stands square to a wall."""

import numpy as np

from apartgen.stages.space.boxes import Array
from apartgen.stages.use import Furnished
from apartgen.stages.use.kinds import CHAIRS

SETS = ("chair", "nightstand", "balcony_chair", "stool")
"""What is bought in sets."""
SAME = 0.03
"""Sizes that differ by no more are one, m."""
UNLIKE, CROOKED = 0.25, 0.15
"""What each piece costs that is unlike the others of its kind, or stands askew."""
ROUND = frozenset({"armchair", "plant", "stool", "pouffe", "floor_lamp", "bin", "round_table"})
SQUARE = np.radians(4)


def cost(room: Furnished) -> float:
    """Over all pieces."""
    return UNLIKE * sum(map(_unlike, [room.boxes.size[room.which(frozenset({name}))] for name in SETS])) + (
        CROOKED * _crooked(room))


def _unlike(sizes: Array) -> int:
    """How many of sizes (n, 3) are not of the commonest one."""
    if len(sizes) < 2:
        return 0
    alike = (np.abs(sizes[:, None] - sizes[None]) < SAME).all(-1).sum(1)
    return int(len(sizes) - alike.max())


def _crooked(room: Furnished) -> int:
    """How many things on the floor stand square to no wall; seats may, and what is round."""
    turned = [room.boxes.yaw[i] for i in room.upright if room.names[i] not in ROUND | CHAIRS]
    walls = np.arctan2(room.site.along[:, 1], room.site.along[:, 0])
    off = (np.array(turned, float)[:, None] - walls + np.pi / 4) % (np.pi / 2) - np.pi / 4
    return int((np.abs(off).min(1) > SQUARE).sum()) if turned else 0
