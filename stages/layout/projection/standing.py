"""The objects of a room that have a place so far."""

from collections.abc import Container
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.costs import BROKEN, HANGINGS, SOFT, Meets, grown, standing_costs
from apartgen.stages.layout.projection.kernels import Others
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE, tucks

Array = NDArray[np.float64]
TUCK_MOST = 0.28
"""How far a seat may go under its table, m."""
ROD = 1.9
"""Curtain rods hang above this, m."""


@dataclass
class Item:
    """One object: center, size (3,), yaw, category; `cost` after placing, at or above BROKEN where it breaks a
    requirement; `moved` metres from where the model put it."""

    category: str
    center: Array
    size: Array
    yaw: float
    cost: float = 0.0
    moved: float = 0.0


class Standing:
    """The room's objects as arrays; `there` tells which have a place yet."""

    def __init__(self, items: list[Item]) -> None:
        n = len(items)
        self.items: list[Item] = list(items)
        self.boxes = Boxes(np.zeros((n, 3)), np.ones((n, 3)), np.zeros(n))
        self.grown = Boxes(np.zeros((n, 3)), np.ones((n, 3)), np.zeros(n))
        self.there = np.zeros(n, bool)
        self.soft = np.array([item.category in SOFT for item in items], bool)
        self.opens = [bool(TABLE[item.category].opens) for item in items]
        self.seated = np.array([[tucks(a.category, b.category) for b in items] for a in items], bool).reshape(n, n)

    def put(self, i: int, item: Item) -> None:
        """Give object `i` its place."""
        self.items[i] = item
        one = Boxes(item.center[None], item.size[None], np.array([item.yaw]))
        for store, box in ((self.boxes, one), (self.grown, grown(item.category, one))):
            store.center[i], store.size[i], store.yaw[i] = box.center[0], box.size[0], box.yaw[0]
        self.there[i] = True

    def others(self, i: int, item: Item, besides: Container[int] = ()) -> Others:
        """All that object `i`, placed as `item`, could meet; not what carries it, nor what is `besides`."""
        index = self.there & np.array([k != i and k not in besides for k in range(len(self.there))], bool)
        if TABLE[item.category].place == "top":
            top = self.boxes.center[:, 2] + self.boxes.size[:, 2] / 2
            index &= np.abs(top - (item.center[2] - item.size[2] / 2)) > 0.02
        seated = self.seated[i][index]
        # A chair goes under its table, not into its middle, nor where it would hold drawers shut.
        shut = np.array([self.opens[i] or self.opens[k] for k in np.flatnonzero(index)], bool)
        tuck = np.where(seated & ~shut, TUCK_MOST, 0.0)
        return Others(self.boxes.take(index), self.grown.take(index), self._soft(item)[index], seated, tuck)

    def meets(self) -> Meets:
        """`others` of all objects at once."""
        n = len(self.items)
        hard = self.there[None] & ~np.eye(n, dtype=bool)
        bottom = self.boxes.center[:, 2] - self.boxes.size[:, 2] / 2
        top = self.boxes.center[:, 2] + self.boxes.size[:, 2] / 2
        for i, item in enumerate(self.items):
            hard[i] &= ~self._soft(item) & (item.category not in SOFT)
            if TABLE[item.category].place == "top":
                hard[i] &= np.abs(top - bottom[i]) > 0.02
        opens = np.array(self.opens, bool)
        shut = opens[:, None] | opens[None]
        return Meets(hard, self.seated, np.where(self.seated & ~shut, TUCK_MOST, 0.0))

    def costs(self, space: Space) -> Array:
        """What each object costs where it is, among the others, (n,)."""
        if not self.items:
            return np.zeros(0)
        names = [item.category for item in self.items]
        found = standing_costs(self.boxes, self.grown, names, self.meets(), space)
        for i, item in enumerate(self.items):
            on_top = self.there[i] and TABLE[item.category].place == "top"
            if on_top and not any(rests_on(item, o) for o in self.neighbours(i)):
                found[i] = 2 * BROKEN
        return found

    def _soft(self, item: Item) -> NDArray[np.bool_]:
        """What gives way to an item; a tall door does not pass a curtain's rod."""
        if TABLE[item.category].opens != "leaf" or item.size[2] < ROD:
            return self.soft
        return np.array([o.category in SOFT - HANGINGS for o in self.items], bool)

    def standing(self, i: int, besides: Container[int] = ()) -> tuple[Boxes, list[str]]:
        """All that has a place but object `i` and what is `besides`, and their categories."""
        index = np.array([j for j in np.flatnonzero(self.there) if j != i and j not in besides], int)
        return self.boxes.take(index), [self.items[j].category for j in index]

    def neighbours(self, i: int) -> list[Item]:
        """The other objects that have a place."""
        return [self.items[j] for j in np.flatnonzero(self.there) if j != i]


def rests_on(item: Item, under: Item) -> bool:
    """Whether an item stands on another's top, wholly above its footprint."""
    c, s = np.cos(under.yaw), np.sin(under.yaw)
    offset = np.abs(np.array([[c, s], [-s, c]]) @ (item.center[:2] - under.center[:2]))
    level = abs(under.center[2] + under.size[2] / 2 - (item.center[2] - item.size[2] / 2)) < 0.02
    return bool(level and (offset <= under.size[:2] / 2 + 0.01).all())
