"""The best matching of two room graphs: as many nodes of equal type as possible, then as many edges.

Exact by branch and bound, so that the order of equal rooms does not matter.
"""

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

Edge = tuple[int, int]
LIMIT = 200_000
"""Nodes of the search after which the best matching found so far is taken."""


def matched(
    types_a: Sequence[str], edges_a: Collection[Edge], types_b: Sequence[str], edges_b: Collection[Edge]
) -> tuple[dict[int, int], int]:
    """Nodes of `a` to nodes of `b`, and how many edges of `a` have their counterpart in `b`."""
    search = _Search(list(types_a), _neighbours(types_a, edges_a), list(types_b), _neighbours(types_b, edges_b))
    search.most = min(len(set(edges_a)), len(set(edges_b)))
    search.run()
    return search.best, search.best_edges


def _neighbours(types: Sequence[str], edges: Collection[Edge]) -> list[set[int]]:
    around: list[set[int]] = [set() for _ in types]
    for i, j in edges:
        around[i].add(j)
        around[j].add(i)
    return around


@dataclass
class _Search:
    types_a: list[str]
    near_a: list[set[int]]
    types_b: list[str]
    near_b: list[set[int]]
    most: int = 0
    best: dict[int, int] = field(default_factory=dict)
    best_edges: int = -1
    visited: int = 0

    def run(self) -> None:
        """Find the best matching; nodes with many neighbours already placed come first."""
        self.order = self._ordered()
        spare = Counter(self.types_a)
        spare.subtract(Counter(self.types_b))
        self._place(0, {}, 0, sum(len(n) for n in self.near_a) // 2, {t: max(k, 0) for t, k in spare.items()})

    def _ordered(self) -> list[int]:
        order: list[int] = []
        rest = set(range(len(self.types_a)))
        while rest:
            following = min(rest, key=lambda i: (-len(self.near_a[i].intersection(order)), -len(self.near_a[i]), i))
            order.append(following)
            rest.remove(following)
        return order

    def _place(self, depth: int, done: dict[int, int], edges: int, open_: int, spare: dict[str, int]) -> None:
        """Match the next node; `open_` edges are still undecided, `spare` nodes of each type may stay unmatched."""
        self.visited += 1
        if depth == len(self.order):
            if edges > self.best_edges:
                self.best, self.best_edges = dict(done), edges
            return
        a = self.order[depth]
        decided = [n for n in self.near_a[a] if n in done or n in self.order[:depth]]
        for gain, b in self._options(a, done):
            if min(edges + gain + open_ - len(decided), self.most) <= self.best_edges or self.visited > LIMIT:
                break
            self._place(depth + 1, {**done, a: b}, edges + gain, open_ - len(decided), spare)
        if spare.get(self.types_a[a], 0) and edges + open_ - len(decided) > self.best_edges and self.visited <= LIMIT:
            less = {**spare, self.types_a[a]: spare[self.types_a[a]] - 1}
            self._place(depth + 1, done, edges, open_ - len(decided), less)

    def _options(self, a: int, done: dict[int, int]) -> list[tuple[int, int]]:
        """(edges won, node of b), best first; of interchangeable nodes only one."""
        used = set(done.values())
        options: dict[frozenset[int], tuple[int, int]] = {}
        for b, kind in enumerate(self.types_b):
            if kind == self.types_a[a] and b not in used:
                gain = sum(done[n] in self.near_b[b] for n in self.near_a[a] if n in done)
                options.setdefault(frozenset(self.near_b[b]), (gain, b))
        return sorted(options.values(), key=lambda option: (-option[0], option[1]))
