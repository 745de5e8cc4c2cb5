"""Trees that annealing starts from: random ones, and rooms in two rows along a corridor and across its end."""

from collections.abc import Sequence
from itertools import accumulate, islice
from typing import NamedTuple

import numpy as np
from numpy.random import Generator

from apartgen.schemas.plan import Program
from apartgen.stages.plan.check import links
from apartgen.stages.plan.problem import areas
from apartgen.stages.plan.slicing import Floats, Ints, Tree

HUB = 4
"""Doors from which a hallway is a corridor between two rows of rooms."""
ROWS = 0.7
"""Share of runs that start from such rows where there is a corridor."""
CAPPED = 0.5
"""Share of these in which rooms lie across the corridor's end, so that it need not go on along them to the outline."""


class Known(NamedTuple):
    """What a programme says of trees: the areas of its rooms, its corridor, and the rooms that open off that."""

    wanted: list[float]
    hub: int | None
    suites: list[list[int]]


def known(program: Program) -> Known:
    """What every start of a programme needs."""
    hub = _hub(program)
    return Known(list(areas(program).values()), hub, [] if hub is None else _suites(program, hub))


def start(program: Known, parts: tuple[int, ...], stretch: tuple[float, float], rng: Generator) -> Tree:
    """A random tree over the rooms' parts, or one of two rows along a corridor."""
    share = np.array(_shares(program.wanted, parts, rng))
    grown = _Growing(len(share))
    if program.hub is None or rng.random() >= ROWS:
        grown.pair_at_random(list(rng.permutation(len(share))), rng)
    else:
        _two_rows(program, program.hub, parts, share, grown, rng)
    grown.nodes[: len(share), 0] = np.repeat(np.arange(len(parts)), parts)
    return Tree(grown.nodes, np.append(share, min(max(1.0, stretch[0]), stretch[1])))


def _shares(wanted: list[float], parts: tuple[int, ...], rng: Generator) -> list[float]:
    """Each room's area over its parts, Dirichlet (6, 6, …)."""
    drawn, out = iter(rng.standard_gamma(6.0, sum(parts)).tolist()), list[float]()
    for area, many in zip(wanted, parts, strict=True):
        mine = list(islice(drawn, many))
        *_, total = accumulate(mine)  # a sum in order, for the same bits wherever it is made
        scale = 1 / total
        out += [area * (one * scale) for one in mine]
    return out


class _Growing:
    """Nodes of a tree while cuts are added to its leaves."""

    def __init__(self, leaves: int) -> None:
        self.nodes: Ints = np.zeros((2 * leaves, 3), np.int64)
        self.next = leaves

    def cut(self, left: int, right: int, upright: int) -> int:
        """A new cut, which becomes the root until there is another."""
        self.nodes[self.next] = left, right, upright
        self.nodes[-1, 0] = self.next
        self.next += 1
        return self.next - 1

    def pair_at_random(self, loose: list[int], rng: Generator) -> None:
        """Cuts in both directions until all are under one."""
        self.nodes[-1, 0] = loose[0]
        while len(loose) > 1:
            left, right = (loose.pop(int(rng.integers(len(loose)))) for _ in range(2))
            loose.append(self.cut(left, right, int(rng.integers(2))))

    def row(self, line: Sequence[int], upright: int, rng: Generator) -> int:
        """Nodes side by side."""
        if len(line) == 1:
            return line[0]
        middle = 1 + int(rng.integers(len(line) - 1))
        return self.cut(self.row(line[:middle], upright, rng), self.row(line[middle:], upright, rng), upright)


def _hub(program: Program) -> int | None:
    """The hallway with most doors, if they are many."""
    halls = [i for i, room in enumerate(program.rooms) if room.base == "hallway"]
    doors = {i: sum(program.rooms[i].id in pair for pair in links(program)) for i in halls}
    best = max(doors, key=lambda i: doors[i], default=None)
    return best if best is not None and doors[best] >= HUB else None


def _two_rows(
    program: Known, hub: int, parts: tuple[int, ...], share: Floats, grown: _Growing, rng: Generator
) -> None:
    """Rooms of the corridor in two rows of about the same area, each with what opens off it; some across an end."""
    upright = int(rng.integers(2))
    ends = list(accumulate(parts, initial=0))
    rows: tuple[list[int], list[int]] = ([], [])
    order = [[leaf for room in program.suites[which] for leaf in range(ends[room], ends[room + 1])]
             for which in rng.permutation(len(program.suites))]
    cap = order.pop() if len(order) >= HUB and rng.random() < CAPPED else []
    for leaves in order:
        rows[_sum(share, rows[1]) < _sum(share, rows[0])].extend(leaves)
    corridor, *stubs = range(ends[hub], ends[hub + 1])
    for stub in stubs:
        row = rows[int(rng.integers(2))]
        row.insert(int(rng.integers(len(row) + 1)), stub)
    lines = [grown.row(row, upright, rng) for row in rows if row]
    body = grown.cut(corridor, lines[-1], 1 - upright)
    end, both = (grown.row(cap, 1 - upright, rng), bool(rng.integers(2))) if cap else (-1, False)
    for whole in (False, True):  # across the corridor and one row, or across both
        if whole and len(lines) > 1:
            body = grown.cut(lines[0], body, 1 - upright)
        if cap and whole == both:
            first, second = (end, body) if rng.random() < 0.5 else (body, end)
            body = grown.cut(first, second, upright)


def _sum(share: Floats, row: list[int]) -> float:
    return float(share[row].sum()) if row else 0.0


def _suites(program: Program, hub: int) -> list[list[int]]:
    """Rooms off the corridor, each with the rooms that are reached through it, and those that are not reached."""
    index = {r.id: i for i, r in enumerate(program.rooms)}
    pairs = [(index[a], index[b]) for a, b in links(program)]
    groups = [[b if a == hub else a] for a, b in pairs if hub in (a, b)]
    taken = {hub, *(g[0] for g in groups)}
    for group in groups:
        for here in group:
            for there in [b if a == here else a for a, b in pairs if here in (a, b)]:
                if there not in taken:
                    taken.add(there)
                    group.append(there)
    rest = [[i] for i in range(len(program.rooms)) if i not in taken]
    return [*groups, *rest]
