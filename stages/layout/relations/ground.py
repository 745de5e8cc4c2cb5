"""What keeps walkers off the floor of a room: objects, as far as they are in the way, and doors that stand open."""

import numpy as np

from apartgen.stages.layout.projection.paths import HUNG, SHUT, Row
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.robot.reach import LEVER
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE, reach

IN_THE_WAY, FLAT = 1.5, 0.03
"""What hangs with its centre above, or rises no higher, is in nobody's way, m."""
ABOVE_TOPS = 0.7
"""What hangs higher at a wall may hang above a low cabinet, a basin or a bed, m."""


def with_levers(leaves: Boxes) -> Boxes:
    """Doors that stand open, as far out as the robot goes round them."""
    heading = np.stack([np.cos(leaves.yaw), np.sin(leaves.yaw), np.zeros(leaves.n)], -1)
    return Boxes(leaves.center + heading * LEVER / 2, leaves.size + [LEVER, 0.0, 0.0], leaves.yaw)


def row(box: Array, far: float) -> Row:
    """An object (7,) that opens so far, as `Paths` takes it."""
    x, y, yaw, depth, width, _, _ = box.tolist()
    return x, y, depth, width, yaw, far


def opens(name: str, box: Array) -> float:
    """How far what is opened from the floor before it does so, m; what hangs at a wall may hang above something."""
    if TABLE[name].place == "wall" and box[5] > ABOVE_TOPS:
        return HUNG
    if not TABLE[name].opens:
        return SHUT
    far = float(reach(name, np.append(box[3:5], box[6] - box[5])))
    return far if far > 0 else SHUT


def in_the_way(name: str, box: Array) -> bool:
    """Whether a walker has to go round an object (7,)."""
    kind = TABLE[name]
    return (box[5] + box[6]) / 2 < IN_THE_WAY and box[6] > FLAT and kind.place != "top"
