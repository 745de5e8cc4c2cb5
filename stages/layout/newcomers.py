"""Categories that a model never saw: asked of it as what they are like, then sized and named as themselves."""

from collections import Counter
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Box
from apartgen.stages.things.categories import CATEGORIES, TABLE, stand_in

Size = Sequence[float] | NDArray[np.float64]


def as_known(wished: Counter[str]) -> Counter[str]:
    """Wishes by categories that models know; those for a newcomer are for one more of what it is like."""
    known = Counter[str]()
    for category, count in wished.items():
        if category in CATEGORIES or count:
            known[stand_in(category) or category] += count
    return known


def chosen(categories: Sequence[str], sizes: Sequence[Size], wished: Counter[str]) -> dict[int, str]:
    """Which objects are the newcomers that were wished for: of what each is like, those nearest to its sizes."""
    found: dict[int, str] = {}
    for newcomer, count in sorted(wished.items()):
        if newcomer in TABLE and newcomer not in CATEGORIES:
            free = [i for i, name in enumerate(categories) if name == stand_in(newcomer) and i not in found]
            nearest = sorted(free, key=lambda i: (_off(newcomer, sizes[i]), i))
            found |= dict.fromkeys(nearest[:count], newcomer)
    return found


def _off(category: str, size: Size) -> float:
    """How far a size lies outside the category's, as a sum of logarithms of ratios."""
    within = np.clip(size, TABLE[category].min, TABLE[category].max)
    return round(float(np.abs(np.log(np.asarray(size) / within)).sum()), 6)


def named(boxes: list[Box], wished: Counter[str]) -> list[Box]:
    """The boxes, newcomers under their own names; nothing else changes its id."""
    found = chosen([box.category for box in boxes], [box.size for box in boxes], wished)
    seen, out = Counter[str](), []
    for i, box in enumerate(boxes):
        if i in found:
            seen[found[i]] += 1
            box = _as(found[i], box, f"{box.room}_{found[i]}_{seen[found[i]]}")
        out.append(box)
    return out


def _as(newcomer: str, box: Box, id: str) -> Box:
    """The box of a newcomer's height, its underside where it was."""
    (x, y, z), (d, w, h) = box.center, box.size
    tall = min(max(h, TABLE[newcomer].min[2]), TABLE[newcomer].max[2])
    center = (x, y, round(z + (tall - h) / 2, 4))
    return box.model_copy(update={"id": id, "category": newcomer, "size": (d, w, tall), "center": center})
