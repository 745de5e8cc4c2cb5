"""What hangs over something: a hood over what cooks, wall units over low units, mirrors over what they belong to.

Such places are known exactly, so that they are among the candidates, with little weight where the model says them.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.relations import order
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.space.boxes import Boxes, penetration, stand_in
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.kinds import CASES, CHAIRS, CLOSED, SMALL_SEATS, basic
from apartgen.stages.use.rules.cook import CORNER

LOW = 1.2
"""Units with a worktop are no higher, m."""
ABOVE = 0.1
"""What hangs keeps at least so far above what it hangs over, m."""
HEAD, CONTACT = 2.0, 0.008
"""Up to here a hood or a mirror hangs, and contact that is none, m."""
HOOD = (1.5, 2.1)
"""Between these heights a hood hangs, m."""
MIRROR, STANDS, MIDDLE = "mirror", 0.6, 0.5
"""Before what one looks into one stands, so far at most, before so much of its middle, m."""
ALONG = np.cos(np.pi / 8)
"""What looks the same way does so within this cosine."""
SIZES = 2
"""Sizes that are tried, the likeliest of what the model says."""


def carries(name: str, other: str, top: float) -> bool:
    """Whether the one hangs over the other, whose top is so high."""
    kind = TABLE[name]
    if kind.run != "hung":
        return kind.place == "wall" and other in kind.belongs
    if not kind.articulated:
        return TABLE[other].is_for("cook")
    return other in order.runs() - CLOSED and top < LOW and not TABLE[other].is_for("cook")


def over(name: str, boxes: Array, names: list[str], there: Array) -> Array:
    """Places (m, 7) for what hangs above what it hangs over, backs in line, in sizes of the candidates (n, 7)."""
    hosts = [box for o, box in zip(names, there, strict=True) if carries(name, o, float(box[6]))]
    if not hosts or not len(boxes):
        return boxes[:0]
    sizes, counts = np.unique(np.round(boxes[:, 3:], 3), axis=0, return_counts=True)
    alike = [box[3:] for o, box in zip(names, there, strict=True) if o == name]
    some = [*alike[:1], *sizes[np.argsort(-counts, kind="stable")[:SIZES]]]
    return np.array([_above(name, host, size) for size in some for host in hosts], np.float32).reshape(-1, 7)


def _above(name: str, host: Array, size: Array) -> Array:
    kind, (depth, width, low, high) = TABLE[name], size
    width = host[4] if kind.family else min(width, host[4])
    width = float(np.clip(width, kind.min[1], kind.max[1]))
    lift = max(0.0, float(host[6]) + ABOVE - low)
    back = (depth - host[3]) / 2
    xy = host[:2] + back * np.array([np.cos(host[2]), np.sin(host[2])])
    return np.array([*xy, host[2], depth, width, low + lift, high + lift])


def spoils(name: str, found: Boxes, names: list[str], there: Boxes) -> NDArray[np.bool_]:
    """Which candidates (n,) would hang where the hood is to be over what cooks, or the mirror over a basin, or are what
    cooks below a unit that hangs, or stand before a mirror."""
    taken, kind = np.zeros(found.n, bool), TABLE[name]
    if kind.is_for("cook"):
        return _below_units(found, names, there)
    if name == MIRROR:
        taken |= _hidden(found, names, there).any(1)
    elif kind.place == "floor" and MIRROR in names:
        mirrors = there.take(np.array([o == MIRROR for o in names], bool))
        taken |= _hidden(mirrors, [name] * found.n, found).any(0)
    if kind.place != "wall" or kind.soft or kind.run == "hung" and not kind.articulated:
        return taken
    for k, o in enumerate(names):
        top = float(there.center[k, 2] + there.size[k, 2] / 2)
        if o not in kind.belongs and (TABLE[o].is_for("wash") or TABLE[o].is_for("cook") and top < LOW):
            over = there.take(np.array([k]))
            over.center[:, 2], over.size[:, 2] = (top + HEAD) / 2, HEAD - top
            taken |= stand_in(found, over, CONTACT)
    return taken


def _hidden(found: Boxes, names: list[str], there: Boxes) -> NDArray[np.bool_]:
    """Before which mirrors (n,) which things (m,) stand, (n, m): what they belong to, and low cabinets, do not where
    one stands before these."""
    heading = np.stack([np.cos(found.yaw), np.sin(found.yaw)], -1)
    center, size = found.center.copy(), found.size.copy()
    center[:, :2] += heading * (found.size[:, :1] + STANDS) / 2
    size[:, 0], size[:, 1] = STANDS, np.minimum(size[:, 1], MIDDLE)
    center[:, 2], size[:, 2] = HEAD / 2, HEAD
    solid = np.array([TABLE[o].place == "floor" and basic(o) not in CHAIRS | SMALL_SEATS for o in names], bool)
    low = there.center[:, 2] + there.size[:, 2] / 2 < TABLE[MIRROR].z
    with_it = np.array([o in TABLE[MIRROR].belongs or basic(o) in CASES | {"bench"} for o in names], bool) & low
    turned = np.cos(found.yaw[:, None] - there.yaw[None]) < ALONG
    bars = solid[None] & (turned | ~with_it[None])
    return np.asarray((penetration(Boxes(center, size, found.yaw), there) > CONTACT) & bars)


def _below_units(found: Boxes, names: list[str], there: Boxes) -> NDArray[np.bool_]:
    units = there.take(np.array([TABLE[o].run == "hung" and TABLE[o].articulated for o in names], bool))
    tops = found.center[:, 2] + found.size[:, 2] / 2
    center, size = found.center.copy(), found.size.copy()
    center[:, 2], size[:, 2] = (tops + HEAD) / 2, np.maximum(HEAD - tops, 0.0)
    if not units.n:
        return np.zeros(found.n, bool)
    return np.asarray(stand_in(Boxes(center, size, found.yaw), units, CONTACT) & (tops < LOW))


def cornered(boxes: Array, space: Space) -> NDArray[np.bool_]:
    """Which candidates for a hob have a wall close at one side."""
    found = upright(boxes)
    return outside(found._replace(size=found.size + [0.0, 2 * CORNER, 0.0]), space) > CORNER / 2


def lit(boxes: Array, space: Space) -> NDArray[np.bool_]:
    """Above which candidates a hood would hang before a window."""
    above, windows = boxes.copy(), space.zones.take(space.window)
    above[:, 5:] = HOOD
    if not windows.n:
        return np.zeros(len(boxes), bool)
    return stand_in(upright(above), windows, CONTACT)
