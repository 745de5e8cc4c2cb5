"""Runs of units, in kitchens and where clothes are washed: side by side along a wall, round a corner, gap by gap flush.

What continues a run is known exactly, so that it is among the candidates of every further unit, with little weight
where the model itself says it.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import order, seeing
from apartgen.stages.layout.relations.tokens import WALL, Array, Shell
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.kinds import CLOSED

FLUSH, CORNER = 0.02, 0.66
"""Gap between units side by side, and from a corner to the nearer edge of the first unit round it, m."""
ASIDE = 0.06
"""How far a side may be off the wall beside it, m."""
IN_LINE = 0.05
"""How far backs of neighbours may be off one line, m."""
OFF, BETWEEN = 0.005, 0.003
"""From a wall to a unit's back, and between units, m."""
WIDTHS, USUAL, TURN = 3, 0.6, 1.1
"""Sizes that are tried, the likeliest of what the model says; widths in which every unit is sold, and in which one that
fills a corner keeps units round it from opening into one another, m."""
CUPBOARDS, DISHES, WIDEST = frozenset({"kitchen_base", "kitchen_drawers"}), "dishwasher", 0.66
"""Of several of these one gives way to that if it is no wider, m."""
MORE = 0.017
"""A unit in a corner is so much deeper than its neighbours, m."""


def local(xy: Array, at: Array, yaw: float) -> tuple[Array, Array]:
    """Points (n, 2) in the frame of a place."""
    offset = xy - at
    c, s = np.cos(yaw), np.sin(yaw)
    return offset[:, 0] * c + offset[:, 1] * s, offset[:, 1] * c - offset[:, 0] * s


def units(names: list[str], boxes: Array) -> Array:
    """Those boxes (m, 7) that are of units."""
    return boxes[[name in order.runs() for name in names]]


def touching(name: str, boxes: Array, names: list[str], there: Array) -> NDArray[np.bool_]:
    """Which candidates (n, 7) for a unit are flush with another one; all of the first unit, and of what is no unit."""
    some = units(names, there) if name in order.runs() else there[:0]
    return seeing.beside(_floats(boxes), _floats(some), FLUSH, CORNER, IN_LINE) if len(some) else np.ones(
        len(boxes), bool)


def further(name: str, boxes: Array, names: list[str], there: Array, shell: Shell) -> Array:
    """Places (m, 7) at which a unit continues the run, in sizes of the candidates (n, 7)."""
    some = units(names, there) if name in order.runs() else there[:0]
    if not len(some):
        return boxes[:0]
    walls = shell.boxes[shell.kind == WALL]
    if name in CLOSED:
        out = [place for size in _sizes(name, boxes) for box in some for place in _turns(name, box, size, walls)]
        return np.array(out, np.float32).reshape(-1, 7)
    sizes = np.ascontiguousarray(_sizes(name, boxes), float)
    return seeing.continued(_floats(some), sizes, _floats(walls), BETWEEN, OFF)


def _floats(boxes: Array) -> NDArray[np.float32]:
    return np.ascontiguousarray(boxes, np.float32)


def _sizes(name: str, boxes: Array) -> Array:
    """The likeliest sizes (k, 4) of candidates, and the likeliest in the usual width."""
    sizes, counts = distinct(np.round(boxes[:, 3:].astype(float), 3))
    some = sizes[np.argsort(-counts, kind="stable")[:WIDTHS]]
    return distinct(np.concatenate([some, [[some[0, 0], _width(name), *some[0, 2:]]]]))[0]


def distinct(rows: Array) -> tuple[Array, NDArray[np.int64]]:
    """Rows (n, k) in order, each once, and how often each is there: `np.unique` of an axis, in a tenth of its time."""
    rows = rows[np.lexsort(rows.T[::-1])]
    first = np.flatnonzero(np.append(True, (rows[1:] != rows[:-1]).any(1)))
    return rows[first], np.diff(np.append(first, len(rows)))


def _width(name: str) -> float:
    return TURN if name in CLOSED else max(USUAL, TABLE[name].min[1])


def usual(name: str) -> Array:
    """Somewhere, a unit in the usual size."""
    depth, _, height = TABLE[name].size
    return np.array([0.0, 0.0, 0.0, depth, _width(name), 0.0, height], np.float32)


def _turns(name: str, box: Array, size: Array, walls: Array) -> list[Array]:
    """Into the corner that a unit stands beside: along its wall as far as the corner, or along the other wall."""
    out, kind = [], TABLE[name]
    heading = np.array([np.cos(box[2]), np.sin(box[2])])
    back = box[:2] - heading * box[3] / 2
    for wall in walls:
        normal = np.array([np.cos(wall[2]), np.sin(wall[2])])
        room = float((box[:2] - wall[:2]) @ normal) - box[4] / 2 - BETWEEN - OFF
        if abs(float(normal @ heading)) > 0.01 or not kind.min[0] <= room <= kind.max[1]:
            continue
        aside = (float(wall[:2] @ normal) + OFF + room / 2) * normal
        deep = float(box[3]) + MORE
        xy = aside + (float(back @ heading) + deep / 2) * heading
        out.append(np.concatenate([xy, [box[2], deep, room], size[2:]]))
        if room <= kind.max[0]:
            along = (float(back @ heading) + size[1] / 2) * heading
            out.append(np.concatenate([aside + along, [wall[2], room], size[1:]]))
    return out


def in_corner(found: Boxes, behind: Callable[[Boxes], NDArray[np.float64]]) -> NDArray[np.bool_]:
    """Which boxes have a wall at one of their sides, by the distance of backs from walls."""
    turned = Boxes(found.center, found.size[:, [1, 0, 2]], found.yaw + np.pi / 2)
    return np.minimum(behind(turned), behind(Boxes(turned.center, turned.size, found.yaw - np.pi / 2))) < ASIDE


def spare(name: str) -> bool:
    """Whether it is a unit that a run can do without."""
    return name in order.runs() and not TABLE[name].is_for("rinse", "cook", "cool")


def gives_way(names: Sequence[str], there: Array, k: int, name: str) -> bool:
    """Whether a unit is left out for another one: where that is a dishwasher, a cupboard about as wide beside others,
    else what a run can do without."""
    cupboards = [i for i, o in enumerate(names) if o in CUPBOARDS]
    return spare(names[k]) if name != DISHES else k in cupboards and len(cupboards) > 1 and bool(there[k, 4] < WIDEST)


def in_place(name: str, boxes: Array, box: Array) -> Array:
    """Places (m, 7) for a unit where another one stands, backs in line, in those sizes of the candidates that fit."""
    sizes = np.round(boxes[:, 3:], 3)
    sizes[:, 1] = np.minimum(sizes[:, 1], box[4])
    sizes = np.unique(sizes[sizes[:, 1] >= TABLE[name].min[1]], axis=0)
    out = np.repeat(box[None], len(sizes), 0).astype(np.float32)
    ahead = (sizes[:, 0] - box[3]) / 2
    out[:, 0], out[:, 1] = box[0] + ahead * np.cos(box[2]), box[1] + ahead * np.sin(box[2])
    out[:, 3:] = sizes
    return out


def carried(boxes: Array, k: int) -> NDArray[np.bool_]:
    """A unit itself and what stands on it, of boxes (n, 7)."""
    x, y = local(boxes[:, :2], boxes[k, :2], float(boxes[k, 2]))
    over = (np.abs(x) < boxes[k, 3] / 2) & (np.abs(y) < boxes[k, 4] / 2)
    found = over & (np.abs(boxes[:, 5] - boxes[k, 6]) < IN_LINE)
    found[k] = True
    return np.asarray(found)
