"""Trees that annealing starts from: random ones, and rooms in two rows along a corridor."""

from collections.abc import Sequence

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


def start(program: Program, parts: tuple[int, ...], stretch: tuple[float, float], rng: Generator) -> Tree:
    """A random tree over the rooms' parts, or one of two rows along a corridor."""
    wanted = list(areas(program).values())
    room = np.repeat(np.arange(len(parts)), parts)
    share = np.concatenate([wanted[i] * rng.dirichlet(np.full(k, 6.0)) for i, k in enumerate(parts)])
    hub = _hub(program)
    grown = _Growing(len(room))
    if hub is None or rng.random() >= ROWS:
        grown.pair_at_random(list(rng.permutation(len(room))), rng)
    else:
        _two_rows(program, hub, room, share, grown, rng)
    grown.nodes[: len(room), 0] = room
    return Tree(grown.nodes, np.append(share, np.clip(1.0, *stretch)))


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


def _two_rows(program: Program, hub: int, room: Ints, share: Floats, grown: _Growing, rng: Generator) -> None:
    """Rooms of the corridor in two rows of about the same area, each with what opens off it beside it."""
    upright = int(rng.integers(2))
    rows: tuple[list[int], list[int]] = ([], [])
    for group in _suites(program, hub, rng):
        leaves = [int(leaf) for i in group for leaf in np.flatnonzero(room == i)]
        thin = int(np.argmin([share[row].sum() if row else 0.0 for row in rows]))
        rows[thin].extend(leaves)
    corridor, *stubs = (int(leaf) for leaf in np.flatnonzero(room == hub))
    for stub in stubs:
        row = rows[int(rng.integers(2))]
        row.insert(int(rng.integers(len(row) + 1)), stub)
    lines = [grown.row(row, upright, rng) for row in rows if row]
    below = grown.cut(corridor, lines[-1], 1 - upright)
    if len(lines) > 1:
        grown.cut(lines[0], below, 1 - upright)


def _suites(program: Program, hub: int, rng: Generator) -> list[list[int]]:
    """Rooms off the corridor in any order, each with the rooms that are reached through it."""
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
    return [([*groups, *rest])[int(k)] for k in rng.permutation(len(groups) + len(rest))]
