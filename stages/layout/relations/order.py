"""The order in which a room's objects are described: large and leading ones first, runs of units end to end."""

import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.tokens import Array, Ints
from apartgen.stages.space.boxes import Boxes, gap
from apartgen.stages.things.categories import CATEGORIES, TABLE

LEVELS = {"floor": 0, "flat": 1, "wall": 2, "top": 3, "ceiling": 4}
"""What stands on the floor comes before what hangs above it or stands on top."""


@cache
def _rules() -> tuple[Ints, NDArray[np.bool_], float]:
    """Rank of every category, which come in runs, and how far apart neighbours in a run may be."""
    table = tomllib.loads((Path(__file__).parent / "order.toml").read_text())
    first = {name: k for k, name in enumerate(table["first"])}
    key = {
        name: (_level(name, table), first.get(name, len(first)), -kind.size[0] * kind.size[1])
        for name, kind in TABLE.items()
    }
    order = {name: k for k, name in enumerate(sorted(CATEGORIES, key=key.__getitem__))}
    run = np.array([name in table["run"] for name in CATEGORIES])
    return np.array([order[name] for name in CATEGORIES]), run, float(table["touching"])


@cache
def runs() -> frozenset[str]:
    """Which categories come in runs."""
    return frozenset(name for name, units in zip(CATEGORIES, _rules()[1], strict=True) if units)


def built() -> NDArray[np.bool_]:
    """Which categories come with the building, (C,)."""
    table = tomllib.loads((Path(__file__).parent / "order.toml").read_text())
    return np.array([name in table["comes_with"] for name in CATEGORIES])


def _level(name: str, table: dict[str, Any]) -> int:
    """What comes with the building is before runs of units, these before what stands, that before what hangs."""
    return 0 if name in table["comes_with"] else 1 if name in table["run"] else 2 + LEVELS[TABLE[name].place]


def ranks() -> Ints:
    """Rank of every category, (C,)."""
    return _rules()[0]


def functional(category: Ints, boxes: Array) -> Ints:
    """The order of a room's objects: category (n,), boxes (n, 7)."""
    rank, in_run, touching = _rules()
    own = rank[category].astype(float)
    unit = np.flatnonzero(in_run[category])
    walk = _end_to_end(boxes[unit], touching) if len(unit) else []
    key = [(float(r), float(t)) for r, t in zip(own, _around(own, boxes), strict=True)]
    for place, k in enumerate(walk):
        key[unit[k]] = (float(own[unit].min()), float(place))
    return np.array(sorted(range(len(key)), key=key.__getitem__), np.int64)


def _around(rank: NDArray[np.float64], boxes: Array) -> NDArray[np.float64]:
    """Angle of each object about the nearest one of a lower rank, as that one looks; about the room's middle else."""
    away = np.linalg.norm(boxes[:, None, :2] - boxes[None, :, :2], axis=-1)
    away[rank[None] >= rank[:, None]] = np.inf
    host = away.argmin(1)
    alone = ~np.isfinite(away.min(1, initial=np.inf))
    offset = boxes[:, :2] - np.where(alone[:, None], 0.0, boxes[host, :2])
    facing = np.where(alone, 0.0, boxes[host, 2])
    return np.asarray((np.arctan2(offset[:, 1], offset[:, 0]) - facing + 0.1) % (2 * np.pi))


def _end_to_end(boxes: Array, touching: float) -> list[int]:
    """Units in the order of a walk along their run, from its right end as one looks at it from the room; where there
    are several runs, the longest first."""
    n = len(boxes)
    upright = Boxes(np.column_stack([boxes[:, :2], np.zeros(n)]).astype(float),
                    np.column_stack([boxes[:, 3:5], np.ones(n)]).astype(float), boxes[:, 2].astype(float))
    beside = gap(upright) < touching
    left, walks = set(range(n)), []
    while left:
        part = _part(beside, min(left))
        left -= set(part)
        walks.append(_walk(boxes, beside, part))
    walks.sort(key=lambda walk: -len(walk))
    return [k for walk in walks for k in walk]


def _part(beside: NDArray[np.bool_], start: int) -> list[int]:
    """All units that touch one, or one that does."""
    found, new = {start}, [start]
    while new:
        for j in np.flatnonzero(beside[new.pop()]).tolist():
            if j not in found:
                found.add(j)
                new.append(j)
    return sorted(found)


def _walk(boxes: Array, beside: NDArray[np.bool_], part: list[int]) -> list[int]:
    rest, walk = set(part), list[int]()
    now = min(part, key=lambda k: (int(beside[k].sum()), -_leftwards(boxes, k, beside)))
    while rest:
        walk.append(now)
        rest.discard(now)
        near = [k for k in sorted(rest) if beside[now, k]] or sorted(rest)
        now = min(near, key=lambda k: float(np.hypot(*(boxes[k, :2] - boxes[walk[-1], :2]))), default=now)
    return walk


def _leftwards(boxes: Array, k: int, beside: NDArray[np.bool_]) -> float:
    """How far to its own left a unit's neighbours lie, m."""
    near = np.flatnonzero(beside[k])
    offset = boxes[near, :2].mean(0) - boxes[k, :2] if len(near) else np.zeros(2)
    return float(offset[1] * np.cos(boxes[k, 2]) - offset[0] * np.sin(boxes[k, 2]))
