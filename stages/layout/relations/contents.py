"""What a room holds, drawn category by category in functional order, until the model says that this is all.

What was asked for is met by masking: how many in all, and how many of a category.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.config import N_MAX
from apartgen.stages.layout.relations import filling
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


def reached(counts: Ints, least: int) -> NDArray[np.float32]:
    """Which of `least` … UP_TO counts (..., C) reach, (..., C * (UP_TO + 1 - least))."""
    found = counts[..., None] >= np.arange(least, UP_TO + 1)
    return found.reshape(*counts.shape[:-1], -1).astype(np.float32)


def draw(network: Contents, type: int, room: NDArray[np.float32], count: int, wanted: Ints, rules: Rules,
         rngs: Sequence[np.random.Generator], given: Ints | None = None) -> list[list[int]]:
    """Categories of a room's contents in functional order, beyond `given` (C,) counts of what is there already; one
    list for every generator.

    count of objects still to come, or -1; wanted (C,) of them by category, or -1. What is given comes in its turn, as
    in all that the network learned from, of which it would else think that nothing before it is to come.
    """
    n, there = len(rngs), np.zeros(len(wanted), np.int64) if given is None else given
    due = np.where(wanted >= 0, wanted + there, np.where(there > 0, there, UNKNOWN))
    more = (wanted < 0) & (there > 0)
    so_far, asked = np.zeros((n, len(due)), np.int64), np.tile(due, (n, 1))
    left, last = np.full(n, count if count < 0 else count + there.sum()), np.full(n, -1)
    found: list[list[int]] = [[] for _ in rngs]
    groups = np.full((len(rules.least), max(map(len, rules.least), default=0)), -1)
    for group, names in zip(groups, rules.least, strict=True):
        group[: len(names)] = names
    x, going = network.begun(type, room, reached(so_far, 1), reached(asked, 0)), np.arange(n)
    for _ in range(N_MAX):
        logits = network.following(x[going], np.where(left < 0, N_MAX + 1, np.minimum(left, N_MAX))[going])
        may = filling.allowed(so_far[going], asked[going], left[going], last[going], rules.rank, rules.known, groups,
                              N_MAX)
        shown = np.where(may, SHARP * logits.astype(float), SHUT_OUT)
        likely = np.exp(shown - shown.max(1, keepdims=True)).cumsum(1)
        chance = np.array([rngs[i].random() for i in going.tolist()])
        chosen = (likely < (chance * likely[:, -1])[:, None]).sum(1)
        going, chosen = going[chosen < len(wanted)], chosen[chosen < len(wanted)]
        if not len(going):
            break
        for i, c in zip(going.tolist(), chosen.tolist(), strict=True):
            found[i].append(c)
        network.one_more(x, going, chosen, so_far[going, chosen], asked[going, chosen], UP_TO)
        so_far[going, chosen] += 1
        last[going] = rules.rank[chosen]
        left[going] -= left[going] > 0
        asked[going, chosen] -= asked[going, chosen] > 0
        open_ = more[chosen] & (asked[going, chosen] == 0)
        network.no_longer_wanted(x, going[open_], chosen[open_], UP_TO)
        asked[going[open_], chosen[open_]] = UNKNOWN
    return [_beyond(there, one) for one in found]


def _beyond(given: Ints, found: list[int]) -> list[int]:
    """What is found without the first of a category that are given."""
    left, out = given.copy(), []
    for c in found:
        if left[c]:
            left[c] -= 1
        else:
            out.append(c)
    return out
