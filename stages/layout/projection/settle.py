"""The objects of a room at their places, and what to do with what fits nowhere."""

from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from apartgen.stages.layout.projection.costs import BROKEN
from apartgen.stages.layout.projection.project import project
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.layout.sense import essentials
from apartgen.stages.things.categories import TABLE

STAND_INS = sorted((name for name, kind in TABLE.items() if kind.stands.filler), key=lambda n: TABLE[n].stands.filler)
"""Small things that take the place of an object that fits nowhere when the count was asked for."""


@dataclass(frozen=True)
class Task:
    """A room to be settled: its sampled objects and type; whether the number of objects was asked for, and which by
    category."""

    items: list[Item]
    space: Space
    kind: str
    asked: bool = False
    wishes: Counter[str] = field(default_factory=Counter)


@dataclass
class Settled:
    """Projected items, which of the given ones they are, and what had to give way, in words."""

    items: list[Item]
    kept: list[int]
    notes: list[str]


def settle(task: Task) -> Settled:
    """Place everything.

    What still breaks a requirement is left out, the worst first; where the number was asked for, something small
    that fits takes its place. What the room is for, and what was wished for by category, stays as long as leaving
    out something else helps.
    """
    items, space = task.items, task.space
    kept, notes = list(range(len(items))), list[str]()
    needed = essentials([item.category for item in items], task.kind, task.wishes)
    done = project(items, space, needed)
    for _ in range(len(items)):
        broken = [k for k, item in enumerate(done) if item.cost >= BROKEN]
        if not broken:
            break
        worst = max(broken, key=lambda k: (k not in needed, done[k].cost))
        if task.asked:
            done = _stand_in(done, worst, task, notes)
            if done[worst].cost >= BROKEN:
                break
            continue
        if worst in needed:
            worst = _in_its_way(worst, done, needed)
        notes.append(f"no place for the {done[worst].category}; left out")
        kept.pop(worst)
        rest = [items[k] for k in kept]
        needed = essentials([item.category for item in rest], task.kind, task.wishes)
        done = project(rest, space, needed)
        if not done:
            break
    return Settled(done, kept, notes)


def _in_its_way(needed_one: int, items: list[Item], needed: frozenset[int]) -> int:
    """The nearest thing on the floor that is not needed, or the object itself where there is none."""
    spare = [
        k
        for k, item in enumerate(items)
        if k not in needed and TABLE[item.category].place == "floor" and not TABLE[item.category].soft
    ]
    return min(spare, key=lambda k: _apart(items[k], items[needed_one]), default=needed_one)


def _apart(a: Item, b: Item) -> float:
    return float(np.linalg.norm(a.center[:2] - b.center[:2]))


def _stand_in(items: list[Item], worst: int, task: Task, notes: list[str]) -> list[Item]:
    """The items, another kind for the same use in place of the worst, or something small that there is least of."""
    best, there = items, Counter(item.category for item in items)
    small = sorted(STAND_INS, key=there.__getitem__)
    for category in (*TABLE[items[worst].category].instead, *small):
        if task.kind not in TABLE[category].rooms:
            continue
        swap = Item(category, items[worst].center, np.array(TABLE[category].size), items[worst].yaw)
        tried = project([swap if k == worst else item for k, item in enumerate(items)], task.space)
        if tried[worst].cost < BROKEN:
            notes.append(f"no place for the {items[worst].category}; a {category} instead")
            return tried
        if sum(o.cost for o in tried) < sum(o.cost for o in best):
            best = tried
    return best
