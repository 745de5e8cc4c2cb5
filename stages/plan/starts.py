"""Trees that annealing starts from: random ones, and rooms in two rows along a corridor."""

from collections.abc import Sequence
from math import sqrt

import numpy as np
from numpy.random import Generator

from apartgen.schemas.plan import Program
from apartgen.stages.plan.blocks import entrance_sides
from apartgen.stages.plan.check import links
from apartgen.stages.plan.corridors import ENDS, HUB, MANY, along, doors, hub
from apartgen.stages.plan.problem import areas
from apartgen.stages.plan.slicing import Floats, Ints, Tree

ROWS = (0.7, 1.0)
"""Share of runs that start from such rows where there is a corridor, of few doors and of many."""
ALONG = 0.8
"""Share of such runs whose corridor is laid to end where one comes in."""
ENDED = 0.75
"""Share of corridors too short for the home that end at a room across it."""
SLIM, LONG = 1.25, 1.4
"""Width of a corridor, m, and the square of a home's length over its area, from which it is seen to be too short."""


def start(program: Program, parts: tuple[int, ...], stretch: tuple[float, float], rng: Generator) -> Tree:
    """A random tree over the rooms' parts, or one of two rows along a corridor."""
    wanted = list(areas(program).values())
    room = np.repeat(np.arange(len(parts)), parts)
    share = np.concatenate([wanted[i] * rng.dirichlet(np.full(k, 6.0)) for i, k in enumerate(parts)])
    middle = hub(program)
    grown = _Growing(len(room))
    if middle is None or rng.random() >= np.interp(doors(program, program.rooms[middle].id), (HUB, MANY), ROWS):
        grown.pair_at_random(list(rng.permutation(len(room))), rng)
    else:
        _two_rows(program, middle, room, share, grown, rng)
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


def _two_rows(program: Program, hall: int, room: Ints, share: Floats, grown: _Growing, rng: Generator) -> None:
    """Rooms of the corridor in two rows of about the same area, each with what opens off it beside it.

    A corridor that would not reach from end to end has a suite across its far end.
    """
    axis = along(program.envelope)
    upright = int(rng.integers(2)) if axis is None or rng.random() >= ALONG else 1 - axis
    suites = _suites(program, hall, rng)
    sizes = [float(share[_leaves(room, suite)].sum()) for suite in suites]
    private = [i for i, suite in enumerate(suites) if all(program.rooms[r].base != "living_room" for r in suite)]
    across = _across(sizes, float(share[room == hall].sum()), private) if rng.random() < ENDED else None
    rows: tuple[list[int], list[int]] = ([], [])
    filled = [0.0, 0.0]
    for i, (first, *behind) in enumerate(suites):
        if i == across:
            continue
        thin = int(np.argmin(filled))
        filled[thin] += sizes[i]
        rest = _leaves(room, behind)
        rows[thin].extend(_leaves(room, [first]))
        rows[thin].extend([grown.row(rest, 1 - upright, rng)] if len(behind) > 1 else rest)
    corridor, *stubs = _leaves(room, [hall])
    for stub in stubs:
        row = rows[int(rng.integers(2))]
        row.insert(int(rng.integers(len(row) + 1)), stub)
    lines = [grown.row(row, upright, rng) for row in rows if row]
    whole = grown.cut(corridor, lines[-1], 1 - upright)
    if len(lines) > 1:
        whole = grown.cut(lines[0], whole, 1 - upright)
    if across is not None:
        end = grown.row(_leaves(room, suites[across]), 1 - upright, rng)
        low = ENDS[upright][0] in entrance_sides(program.envelope)
        grown.cut(*((whole, end) if low else (end, whole)), upright)


def _across(areas: list[float], hall: float, private: list[int]) -> int | None:
    """The suite to lie across a corridor's end where it is too short for the home, the smallest that will do.

    Not that of the living room: one would come to all bedrooms before it.
    """
    whole = sum(areas) + hall
    spare = 1 - hall / SLIM / sqrt(LONG * whole)
    if spare <= 0 or len(areas) < 4 or not private:
        return None
    enough = [i for i in private if areas[i] >= spare * whole]
    return min(enough, key=lambda i: areas[i]) if enough else max(private, key=lambda i: areas[i])


def _leaves(room: Ints, rooms: list[int]) -> list[int]:
    return [int(leaf) for i in rooms for leaf in np.flatnonzero(room == i)]


def _suites(program: Program, hall: int, rng: Generator) -> list[list[int]]:
    """Rooms off the corridor in any order, each with the rooms that are reached through it."""
    index = {r.id: i for i, r in enumerate(program.rooms)}
    pairs = [(index[a], index[b]) for a, b in links(program)]
    groups = [[b if a == hall else a] for a, b in pairs if hall in (a, b)]
    taken = {hall, *(g[0] for g in groups)}
    for group in groups:
        for here in group:
            for there in [b if a == here else a for a, b in pairs if here in (a, b)]:
                if there not in taken:
                    taken.add(there)
                    group.append(there)
    rest = [[i] for i in range(len(program.rooms)) if i not in taken]
    return [([*groups, *rest])[int(k)] for k in rng.permutation(len(groups) + len(rest))]
