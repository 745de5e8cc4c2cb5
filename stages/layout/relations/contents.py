"""What a room holds, drawn category by category in functional order, until the model says that this is all.

What was asked for is met by masking: how many in all, and how many of a category.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.config import N_MAX
from apartgen.stages.layout.relations.features import SHUT_OUT
from apartgen.stages.layout.relations.infer import Contents
from apartgen.stages.layout.relations.tokens import DOOR, ENTRANCE, OPENING, WALL, WINDOW, Array, Ints
from apartgen.stages.use.household import OPEN

FACTS = 12 + 2 * len(OPEN)
UP_TO = 9
"""Counts are told by whether they reach 1 … so many."""
UNKNOWN = -1
SHARP = 1.25
"""What logits are multiplied with before a category is drawn."""


def facts(boxes: Array, kind: Ints, area: float, sleepers: int, duties: Sequence[int]) -> NDArray[np.float32]:
    """What of a room tells its contents, (FACTS,): tokens' boxes (T, 7) and kinds (T,), its duties (4,)."""
    long, short = max(boxes[0, 3:5]), min(boxes[0, 3:5])
    width = {k: boxes[kind == k, 4] for k in (WALL, DOOR, OPENING, ENTRANCE, WINDOW)}
    return np.array([
        np.log(area), long / 3, short / 3, area / max(long * short, 1e-6), len(width[WALL]) / 4, len(width[DOOR]) / 2,
        len(width[OPENING]), len(width[ENTRANCE]), len(width[WINDOW]) / 2, width[WINDOW].sum() / 3,
        max(sleepers, 0) / 3, float(sleepers >= 0),
        *(float(v > 0) for v in duties), *(float(v >= 0) for v in duties),
    ], np.float32)


@dataclass(frozen=True)
class Rules:
    """What contents must keep to: rank (C,) of categories, known (C,) ones that may be drawn at all, groups of which
    one is needed."""

    rank: Ints
    known: NDArray[np.bool_]
    least: tuple[tuple[int, ...], ...]


def allowed(so_far: Ints, last: int, left: int, wanted: Ints, rules: Rules) -> NDArray[np.bool_]:
    """Which categories may come next, and at last whether the room may end here, (C + 1,).

    so_far (C,), last rank drawn, left objects or -1, wanted (C,) still to come by category or -1.
    """
    rank, due = rules.rank, wanted > 0
    may = (rank >= last) & (due | ((wanted < 0) & rules.known))
    lacking = [group for group in rules.least if not so_far[list(group)].any()]
    bounds = [int(rank[due].min())] if due.any() else []
    for group in lacking:
        still = [int(rank[c]) for c in group if rank[c] >= last and (wanted[c] != 0)]
        bounds += [max(still)] if still else []
    if bounds:
        may &= rank <= min(bounds)
    open_ = [group for group in lacking if not due[list(group)].any()]
    most = N_MAX - int(so_far.sum())
    if (most if left < 0 else min(left, most)) <= int(wanted[due].sum()) + len(open_):
        needed = due.copy()
        needed[[c for group in open_ for c in group]] = True
        may &= needed if (may & needed).any() else True
    end = not bounds and left <= 0 and not (left < 0 and not so_far.any())
    if left == 0:
        may[:] = False
    return np.append(may, end or not may.any())


def reached(counts: Ints, least: int) -> NDArray[np.float32]:
    """Which of `least` … UP_TO counts (..., C) reach, (..., C * (UP_TO + 1 - least))."""
    found = counts[..., None] >= np.arange(least, UP_TO + 1)
    return found.reshape(*counts.shape[:-1], -1).astype(np.float32)


def _left(count: int) -> int:
    """The row that is learned for so many objects to come, or for an unknown number."""
    return N_MAX + 1 if count < 0 else min(count, N_MAX)


@dataclass
class _Drawing:
    """Contents that are being drawn: counts so far, what is still wanted (C,), objects left or -1, last rank."""

    so_far: Ints
    wanted: Ints
    left: int
    last: int
    found: list[int]


def draw(network: Contents, type: int, room: NDArray[np.float32], count: int, wanted: Ints, rules: Rules,
         rngs: Sequence[np.random.Generator], given: Ints | None = None) -> list[list[int]]:
    """Categories of a room's contents in functional order, beyond `given` (C,) counts of what is there already; one
    list for every generator.

    count of objects still to come, or -1; wanted (C,) of them by category, or -1.
    """
    there = np.zeros(len(wanted), np.int64) if given is None else given
    rows = [_Drawing(there.copy(), wanted.copy(), count, -1, []) for _ in rngs]
    told, going = network.told(type, room), list(range(len(rows)))
    for _ in range(N_MAX - int(there.sum())):
        some = [rows[i] for i in going]
        logits = network(
            told, reached(np.stack([row.so_far for row in some]), 1), np.array([_left(row.left) for row in some]),
            reached(np.stack([row.wanted for row in some]), 0))
        may = np.stack([allowed(row.so_far, row.last, row.left, row.wanted, rules) for row in some])
        shown = np.where(may, SHARP * logits.astype(float), SHUT_OUT)
        likely = np.exp(shown - shown.max(1, keepdims=True)).cumsum(1)
        chosen = [int(np.searchsorted(one, rngs[i].random() * one[-1])) for i, one in zip(going, likely, strict=True)]
        going = [i for i, c in zip(going, chosen, strict=True) if _further(rows[i], c, rules)]
        if not going:
            break
    return [row.found for row in rows]


def _further(row: _Drawing, chosen: int, rules: Rules) -> bool:
    """Take the next category; False where the room ends."""
    if chosen >= len(row.wanted):
        return False
    row.found.append(chosen)
    row.so_far[chosen] += 1
    row.last = int(rules.rank[chosen])
    row.left -= row.left > 0
    row.wanted[chosen] -= row.wanted[chosen] > 0
    return True
