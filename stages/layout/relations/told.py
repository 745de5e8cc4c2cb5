"""What contents keep to that are told: in the indices of the weights, of categories that these never saw, too."""

from collections import Counter
from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.relations import contents, weights
from apartgen.stages.layout.rooms import UNKNOWN
from apartgen.stages.things.categories import CATEGORIES
from apartgen.stages.use.kinds import basic


class Rules:
    """What contents keep to in a room: things of `never` come only if they are wanted, `likes` as what is like them."""

    def __init__(self, known: weights.Vocabulary, least: tuple[frozenset[str], ...], wanted: Counter[str],
                 never: frozenset[str]) -> None:
        n = len(known.categories)
        here = np.array([name in CATEGORIES and name not in never for name in known.categories])
        index = {name: k for k, name in enumerate(known.categories)}
        groups = tuple(tuple(index[name] for name in sorted(group) if name in index) for group in least)
        self.drawn = contents.Rules(known.rank, here, tuple(group for group in groups if group))
        self.wanted = np.full(n, UNKNOWN)
        for name, count in wanted.items():
            if name in index:
                self.wanted[index[name]] = count
        self.likes: list[str] = [name for name, count in wanted.items() if name not in index for _ in range(count)]


def as_asked(names: list[str], likes: Sequence[str]) -> list[str]:
    """Contents in which so many things are what is like them, the last of their kind."""
    for like in likes:
        k = max((k for k, name in enumerate(names) if name == basic(like)), default=len(names))
        names[k : k + 1] = [like]
    return names
