"""How a part of a model without joints moves, told from its name, its shape and its pivot (y up, front +z)."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.retrieve.reading.model import Motion
from apartgen.stages.retrieve.reading.pieces import Array, Piece
from apartgen.stages.things.categories import DRAWER_TRAVEL, those
from apartgen.stages.things.words import split

MOVING = frozenset({"door", "drawer", "lid", "flap"})
STILL = frozenset({"frame", "knob", "handle", "bed"})
FLAPS = those(lambda kind: kind.opens == "flap" and kind.appliance)
LIDS = those(lambda kind: kind.opens == "lid")
DOORS = those(lambda kind: kind.opens == "leaf" and kind.place == "top")
"""What has one part that moves, whatever it is called."""
X, Y, Z = np.eye(3)
QUARTER = float(np.pi / 2)


def moves(name: str) -> bool:
    """Whether a node's name says that it opens."""
    words = set(split(name))
    return bool(words & MOVING) and not words & STILL


def guess(name: str, category: str, pieces: Sequence[Piece], pivot: Array, middle: Array) -> Motion | None:
    """The motion of a part about its pivot, `middle` being that of the whole object; None for what only swivels."""
    points = np.concatenate([piece.vertices for piece in pieces])
    lo, hi = points.min(0), points.max(0)
    words = set(split(name))
    if "drawer" in words:
        return Motion("slide", Z, pivot, (0.0, DRAWER_TRAVEL * float(hi[2] - lo[2])), "slider_drawer")
    if "lid" in words or category in LIDS:
        return Motion("hinge", -X, pivot, (0.0, QUARTER), "hinge_lid")
    if "flap" in words or category in FLAPS:
        return Motion("hinge", X, np.array([pivot[0], lo[1], pivot[2]]), (0.0, QUARTER), "hinge_door")
    if "door" not in words and category not in DOORS:
        return None
    if pivot[1] > hi[1] - 0.1 * (hi[1] - lo[1]) and hi[0] - lo[0] > 1.5 * (hi[1] - lo[1]):
        return Motion("hinge", -X, pivot, (0.0, QUARTER), "hinge_door")
    return Motion("hinge", _upright(lo, hi, pivot, middle), pivot, (0.0, QUARTER), "hinge_door")


def _upright(lo: Array, hi: Array, pivot: Array, middle: Array) -> Array:
    """±y such that a positive turn takes the leaf's free edge outwards."""
    centre = (lo + hi) / 2
    wide = X if hi[0] - lo[0] >= hi[2] - lo[2] else Z
    along = wide * np.sign(float(wide @ (centre - pivot)) or 1.0)
    out = Z if wide is X else X * np.sign(float(centre[0] - middle[0]) or 1.0)
    return np.asarray(Y * float(np.cross(along, out) @ Y))
