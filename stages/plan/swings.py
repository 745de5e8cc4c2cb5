"""Doors that can be had together: the cheapest ways to build them in which no leaf gets in another's way."""

from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.errors import Unmet
from apartgen.stages.plan.faces import Face

TRIES = 4000
MEETING = 1e-3
"""Overlap from which boxes meet, m."""
Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Box = tuple[float, float, float, float]
"""Least x and y, greatest x and y, m."""
Depths = tuple[float, float]
"""Floor before a door over which no other leaf turns, and in which none stands open, m."""
NOWHERE: Box = (0.0, 0.0, 0.0, 0.0)


class Choice(NamedTuple):
    """One way to build a door: where it cuts its face, how its leaf turns, what floor it sweeps and needs in front.

    `stands` is where the leaf stands open; `front` and `way` are the floors of `Depths` on both sides.
    """

    face: Face
    lo: float
    hi: float
    hinge: Literal[0, 1]
    into: str | None
    cost: float
    sweep: Box
    stands: Box
    front: tuple[Box, ...]
    way: tuple[Box, ...]


class Column(NamedTuple):
    """A door to be placed and the ways to do it, cheapest first."""

    kind: Literal["door", "opening", "entrance"]
    rooms: list[str]
    choices: list[Choice]
    head: float


def _meet(some: Floats, others: Floats) -> Flags:
    """Which boxes of (n, 4) overlap which of (m, k, 4) by more than a millimetre each way, (n, m)."""
    found: Flags = np.zeros((len(some), len(others)), bool)
    own = _thick(some)
    for layer in np.ascontiguousarray(others.transpose(1, 0, 2)):
        meet = np.logical_and.outer(own, _thick(layer))
        for axis in (0, 1):
            meet &= some[:, axis + 2, None] - layer[:, axis] > MEETING
            meet &= layer[:, axis + 2] - some[:, axis, None] > MEETING
        found |= meet
    return found


def _thick(boxes: Floats) -> Flags:
    """Which of (n, 4) are more than a millimetre wide and deep, (n,)."""
    found: Flags = (boxes[:, 2] - boxes[:, 0] > MEETING) & (boxes[:, 3] - boxes[:, 1] > MEETING)
    return found


def clash(choices: list[Choice]) -> Flags:
    """Which doors get in each other's way: a leaf meets the other's, turns or stands open before its door; (n, n)."""
    sweep, stands, front, way = (np.array(boxes) for boxes in zip(*(c[-4:] for c in choices), strict=True))
    found = _meet(sweep, np.concatenate((sweep[:, None], front), axis=1)) | _meet(stands, way)
    return np.logical_or(found, found.T)


def together(columns: list[Column]) -> list[Choice]:
    """Depth-first over the columns, fewest choices first, bounded by the best cost found."""
    ranked = sorted(range(len(columns)), key=lambda i: (len(columns[i].choices), i))
    costs = [[choice.cost for choice in columns[i].choices] for i in ranked]
    fits = _fits([columns[i].choices for i in ranked])
    low, best, left = float("inf"), list[int](), TRIES

    def descend(depth: int, cost: float, open_to: list[int], taken: list[int]) -> None:
        nonlocal low, best, left
        if depth == len(ranked):
            low, best = cost, taken
            return
        after = sum(mine[_first(some)] for mine, some in zip(costs[depth + 1 :], open_to[1:], strict=True))
        some = open_to[0]
        while some:
            which = _first(some)
            some &= some - 1
            here = cost + costs[depth][which]
            left -= 1
            if left < 0 or here + after >= low - 1e-9:
                return
            still = [other & fit for other, fit in zip(open_to[1:], fits[depth][which], strict=True)]
            if all(still):
                descend(depth + 1, here, still, [*taken, which])

    descend(0, 0.0, [(1 << len(mine)) - 1 for mine in costs], [])
    if not best:
        raise Unmet("the doors get in each other's way wherever they are put")
    return [columns[i].choices[best[ranked.index(i)]] for i in range(len(columns))]


def _first(some: int) -> int:
    """The lowest of the choices that a number's bits stand for: the cheapest."""
    return (some & -some).bit_length() - 1


def _fits(columns: list[list[Choice]]) -> list[list[list[int]]]:
    """Of every choice of every column the choices that it leaves to each later column, as the bits of numbers."""
    ends = np.cumsum([0, *map(len, columns)])
    packed = ~clash([choice for column in columns for choice in column])
    bits = [np.packbits(packed[:, lo:hi], axis=1, bitorder="little") for lo, hi in pairwise(ends)]
    return [
        [[int.from_bytes(bits[later][row].tobytes(), "little") for later in range(mine + 1, len(columns))]
         for row in range(ends[mine], ends[mine + 1])]
        for mine in range(len(columns))
    ]  # fmt: skip
