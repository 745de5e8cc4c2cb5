"""What belongs to one set: equal things of a room look equal, and a kitchen or a room's cabinets share one style."""

from collections import defaultdict
from collections.abc import Callable, Hashable, Sequence
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Box
from apartgen.stages.retrieve.matching.embedded import Embedded
from apartgen.stages.things.categories import OVEN_TOWER, TABLE, fitted_ovens, those, used_for

Array = NDArray[np.float64]
Size = tuple[float, float, float]
Design = tuple[str, int]
Name = TypeVar("Name", str, int)

CLOSED = those(lambda kind: kind.run == "unit" and not kind.articulated)
"""Units that fill corners."""
KITCHEN = "kitchen"
"""The family of kitchen units, whose styles fitted ovens have, too."""
CLOSE = 1.15
"""Sides within this ratio are made equal."""
FILLING = 0.03
"""What fills a corner keeps what it is deeper than its neighbours by more than this, m: there units round the corner
begin farther off."""
LACKING = 4.0
"""Cost of a style that a member's category does not come in; that member then takes its own nearest."""


class Wish(NamedTuple):
    """What is looked for in place of a box: never larger than it, with the latent of its set."""

    size: Size
    latent: Array


def wishes(objects: Sequence[Box], height: float) -> list[Wish]:
    """Sizes and latents, those of a set made equal where they nearly are."""
    size = np.array([o.size for o in objects], float).reshape(-1, 3)
    size[:, 2] = np.minimum(size[:, 2], height)
    latent: list[Array] = [np.asarray(o.latent, float) for o in objects]
    for rows in _grouped(objects, lambda o: (o.room, o.category)):
        same = [i for i in rows if latent[i].size]
        mean = np.mean([latent[i] for i in same], axis=0) if same else None
        for i in same:
            latent[i] = np.asarray(mean)
        _level(size, rows, [objects[i].category for i in rows], (0, 1, 2))
    fitted = fitted_ovens(objects)
    run = {o.id for o in objects if TABLE[o.category].run == "unit" or (o.id in fitted and o.size[2] < OVEN_TOWER)}
    for rows in _grouped(objects, lambda o: (o.room, "run" if o.id in run else o.id)):
        _level(size, rows, [objects[i].category for i in rows], (0, 2))
    return [Wish((s[0], s[1], s[2]), z) for s, z in zip(size.tolist(), latent, strict=True)]


def _level(size: Array, rows: list[int], names: list[str], axes: Sequence[int]) -> None:
    """Brings sides that are close to each other down to the least, but not below what is real."""
    least = np.max([TABLE[name].min for name in names], axis=0)
    for axis in axes:
        sides = size[rows, axis]
        if len(rows) > 1 and sides.max() <= CLOSE * sides.min():
            level = np.minimum(sides, max(float(sides.min()), float(least[axis])))
            fills = np.array([axis == 0 and name in CLOSED for name in names]) & (sides - level > FILLING)
            size[rows, axis] = np.where(fills, sides, level)


def _grouped(objects: Sequence[Box], key: Callable[[Box], Hashable]) -> list[list[int]]:
    groups: dict[Hashable, list[int]] = defaultdict(list)
    for i, box in enumerate(objects):
        groups[key(box)].append(i)
    return list(groups.values())


def designs(objects: Sequence[Box], wished: Sequence[Wish], embedded: Embedded) -> list[Design]:
    """Style and seed of each object: within a family of a room those that cost all its members least."""
    chosen: list[Design] = [("", 0)] * len(objects)
    fitted = fitted_ovens(objects)
    of_kitchens = {style for name in used_for("fry") for style in embedded.styles(name)}

    def family(o: Box) -> tuple[str, str]:
        return o.room, KITCHEN if o.id in fitted else TABLE[o.category].family or o.category

    def costs_of(o: Box, wish: Wish) -> dict[Design, float]:
        found = embedded.costs(o.category, wish.size, wish.latent)
        rest = {d: cost for d, cost in found.items() if (d[0] in of_kitchens) == (o.id in fitted)}
        return rest or found if o.category in used_for("bake") else found

    for rows in _grouped(objects, family):
        costs = [costs_of(objects[i], wished[i]) for i in rows]
        style = _cheapest([_by_style(cost) for cost in costs])
        seed = _cheapest([{own: c for (name, own), c in cost.items() if name == style} for cost in costs])
        for i, cost in zip(rows, costs, strict=True):
            own = min(cost, key=lambda design: (cost[design], design))
            chosen[i] = (style, seed) if (style, seed) in cost else own
    return chosen


def _by_style(cost: dict[Design, float]) -> dict[str, float]:
    best: dict[str, float] = {}
    for (style, _), value in cost.items():
        best[style] = min(value, best.get(style, np.inf))
    return best


def _cheapest(costs: Sequence[dict[Name, float]]) -> Name:
    """The name of least total cost over all members; one that a member lacks costs it its own best and `LACKING`."""
    names = sorted({name for cost in costs for name in cost})

    def total(name: Name) -> float:
        return sum(cost[name] if name in cost else min(cost.values(), default=0.0) + LACKING for cost in costs)

    return min(names, key=lambda name: (round(total(name), 9), name))
