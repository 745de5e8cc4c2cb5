"""Parts for training and testing, drawn so that homes that are nearly the same are in one part."""

from collections import defaultdict
from collections.abc import Iterable

import numpy as np
from scipy.spatial import cKDTree

from apartgen.dataset.rows import Row
from apartgen.schemas.errors import BadInput
from apartgen.stages import seeds

PARTS = {"train": 0.8, "val": 0.1, "test": 0.1}
TWINS_WITHIN = 0.15
"""Twins have the same graph of rooms; the sides of their rooms' boxes differ by less than this, root mean square, m."""


def assigned(rows: Iterable[Row], parts: dict[str, float], seed: int) -> dict[str, str]:
    """The part of every home that was made; twins go together, each group by the seed and its first id."""
    names, ends = list(parts), np.cumsum(list(parts.values()))
    return {id: names[min(int(np.searchsorted(ends, _share(seed, group[0]), "right")), len(names) - 1)]
            for group in twins(rows) for id in group}


def twins(rows: Iterable[Row]) -> list[list[str]]:
    """Groups of homes that are nearly the same as another of their group; most have a group of their own."""
    alike: dict[tuple[str, int], tuple[list[str], list[list[float]]]] = defaultdict(lambda: ([], []))
    for row in rows:
        if "shard" in row:
            ids, sides = alike[row["signature"], len(row["sides"])]
            ids.append(row["id"])
            sides.append(row["sides"])
    return [group for ids, sides in alike.values() for group in _groups(ids, np.array(sides))]


def _groups(ids: list[str], sides: np.ndarray) -> list[list[str]]:
    """Ids joined where their vectors are near, in the order of the first of each."""
    first = list(range(len(ids)))

    def root(i: int) -> int:
        while first[i] != i:
            first[i] = first[first[i]]
            i = first[i]
        return i

    for i, j in cKDTree(sides).query_pairs(TWINS_WITHIN * np.sqrt(sides.shape[1])):
        one, other = sorted((root(i), root(j)))
        first[other] = one
    groups: dict[int, list[str]] = defaultdict(list)
    for i, id in enumerate(ids):
        groups[root(i)].append(id)
    return list(groups.values())


def _share(seed: int, id: str) -> float:
    return float(seeds.drawn(seed, "split", id).random())


def parts_of(text: str) -> dict[str, float]:
    """Shares by name, as `train=0.8,val=0.1,test=0.1`; they are made to add up to one."""
    pairs = [word.partition("=") for word in text.split(",")]
    try:
        found = {name.strip(): float(value) for name, _, value in pairs}
    except ValueError:
        found = {}
    if not found or not all(name and 0 < value < float("inf") for name, value in found.items()):
        raise BadInput(f"--parts {text}: give shares above zero, as train=0.8,val=0.1,test=0.1")
    return {name: value / sum(found.values()) for name, value in found.items()}
