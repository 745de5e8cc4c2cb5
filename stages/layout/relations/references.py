"""From what each object of a corpus is described: the reference that makes its description shortest.

The length of a description is −log of how often objects of its category are so described, counted over the corpus; as
the counts hang on the references chosen and the choice on the counts, both are found in turns.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import describe, order
from apartgen.stages.layout.relations.tokens import (
    ASKING,
    DOOR,
    ENTRANCE,
    OBJECT,
    OPENING,
    ROOM,
    WINDOW,
    Array,
    Ints,
    seen,
)
from apartgen.stages.things.categories import CATEGORIES, TABLE

ROUNDS = 4
ASIDE, AFAR = 2.0, 3.5
"""What it costs to be described from an opening or the room, or from afar, nats: walls and neighbours say it better."""
NEVER = 1e4
"""The length of what cannot be said."""
SMOOTH = 0.02
"""Added to every count."""
WIDTHS = np.diff(np.concatenate([[describe.GAPS[0] - 0.01], (describe.GAPS[1:] + describe.GAPS[:-1]) / 2,
                                 [describe.GAPS[-1] + 0.075]]))
WAYS = describe.ALIGNMENTS + 1
"""How an offset may be the reference's own; the last: not at all."""
FREE, LINES = 100.0, 6.0
"""Among so many offsets one is chosen that is nothing's, among so many one that is another object's."""


TOPS = np.array([TABLE[name].place == "top" for name in CATEGORIES])
"""What stands on other things is described from what it stands on."""


@dataclass
class Pairs:
    """All (object, token) pairs of a corpus: row of the object, token, the pair's class (category and the token's kind
    or category), bins of what it would be described by, whether it can be; `few` tokens of that class there are."""

    row: Ints
    token: Ints
    kind: Ints
    heading: Ints
    side: Ints
    gap: Ints
    way: Ints
    fit: NDArray[np.bool_]
    few: NDArray[np.float64]


def pairs(boxes: Array, kind: Ints, category: Ints, objects: Ints, row: int, of_kinds: int) -> Pairs:
    """The pairs of one room: token boxes (T, 7), kinds, categories (T,), -1 of what is no object; `objects` are the
    indices of its objects, whose rows begin at `row`; `of_kinds` kinds of token there are."""
    view = seen(boxes[None], boxes)  # (reference, token)
    looked = view[:, objects].swapaxes(0, 1)  # (object, reference)
    half = np.broadcast_to((boxes[None, :, 3:5] / 2).astype(np.float32), (*looked.shape[:2], 2))
    kinds = np.broadcast_to(kind[None], looked.shape[:2])
    said = describe.describe(looked, half, kinds)
    ex, ey = looked[..., 3], looked[..., 4]
    across = describe.along_y(said.side)
    reach, own = np.where(across, ey, ex), np.where(across, half[..., 1], half[..., 0])
    ways = np.stack([0 * own, reach - own, own - reach, own + reach, -own - reach], -1)
    way = _way(ways, said.along)
    # In line with what stands there already is short to say, too.
    middles = np.where(across[..., None], view[None, :, :, 1], view[None, :, :, 0])
    before = (kind == OBJECT)[None, None] & (np.arange(len(kind)) < objects[:, None, None])
    in_line = ((np.abs(middles - said.along[..., None]) < 0.015) & before).any(-1)
    way = np.where((way == WAYS - 1) & in_line, WAYS, way)
    outward = np.stack([0 * ex, ex - half[..., 0], half[..., 0] - ex, ex + half[..., 0], -ex - half[..., 0]], -1)
    # Over its reference an object has a second offset in place of a gap.
    gap = np.where(said.side == describe.OVER, len(describe.GAPS) + _way(outward, said.across), said.gap)
    fit = said.fit & (objects[:, None] != np.arange(len(kind)))
    on_it = (kind == OBJECT) & (np.abs(looked[..., 5] - boxes[None, :, 6]) < 0.02) & (said.side == describe.OVER) & fit
    fit &= on_it | ~(TOPS[category[objects]] & on_it.any(1))[:, None]
    token_class = np.where(category >= 0, ASKING + category, kind)
    few = (token_class[None] == token_class[:, None]).sum(0).astype(float)
    n, t = looked.shape[:2]
    shape = (n, t)
    return Pairs(
        np.broadcast_to(row + np.arange(n)[:, None], shape).ravel(),
        np.broadcast_to(np.arange(t), shape).ravel(),
        (category[objects][:, None] * of_kinds + token_class[None]).ravel(),
        (said.heading // 3).ravel(), said.side.ravel(), gap.ravel(), way.ravel(),
        fit.ravel(), np.broadcast_to(few, shape).ravel(),
    )


def _way(ways: Array, offset: Array) -> Ints:
    near = np.abs(ways - offset[..., None]) < 0.015
    return np.asarray(np.where(near.any(-1), near.argmax(-1), WAYS - 1))


def lengths(found: Pairs, earlier: NDArray[np.bool_], of_kinds: int) -> NDArray[np.float64]:
    """Length of every pair's description in nats, NEVER for what cannot be said; `earlier` pairs are those whose token
    comes before the object in the functional order, from which the counts are taken."""
    wide = np.concatenate([WIDTHS, np.full(WAYS - 1, 0.02), [0.02 * FREE]])
    length = np.log(found.few) + np.log(wide[found.gap] / 0.02)
    length += np.select([found.way == WAYS - 1, found.way == WAYS], [np.log(FREE), np.log(LINES)])
    token = found.kind % of_kinds
    hole = np.isin(token, (DOOR, OPENING, ENTRANCE, WINDOW, ROOM)) & (found.way >= WAYS - 1)
    length += ASIDE * (hole | (token == ROOM) | order.built()[np.maximum(token - ASKING, 0)] & (token >= ASKING))
    length += AFAR * (wide[found.gap] > 0.02)
    length[~found.fit] = NEVER
    usable = found.fit & earlier
    own = length.copy()
    for _ in range(ROUNDS):
        best = _best(found.row, np.where(usable, own, NEVER * 2))
        own = length + _surprise(found, best, of_kinds)
        own[~found.fit] = NEVER
    return own


def _best(row: Ints, length: NDArray[np.float64]) -> Ints:
    """Index of the shortest pair of every row."""
    order = np.lexsort([length, row])
    first = np.append(True, np.diff(row[order]) > 0)
    return np.asarray(order[first])


def _surprise(found: Pairs, best: Ints, of_kinds: int) -> NDArray[np.float64]:
    """−log of how often a category is described from such a token, and then on such a side, so turned, so far off and
    so aligned, by the pairs chosen at present."""
    category = found.kind // of_kinds
    total = -_log_share(found.kind, category, best)
    side = found.kind * describe.SIDES + found.side
    total -= _log_share(side * 24 + found.heading, found.kind, best)
    total -= _log_share(side * (len(WIDTHS) + WAYS) + found.gap, side, best)
    total -= _log_share(side * (WAYS + 1) + found.way, side, best)
    return np.asarray(total)


def _log_share(key: Ints, given: Ints, best: Ints, smooth: float = SMOOTH) -> NDArray[np.float64]:
    """log of the share of `key` among the best pairs with the same `given`."""
    _, key_of = np.unique(key, return_inverse=True)
    _, given_of = np.unique(given, return_inverse=True)
    keys = np.bincount(key_of[best], minlength=key_of.max() + 1) + smooth
    total = np.bincount(given_of[best], minlength=given_of.max() + 1) + smooth * 20
    return np.asarray(np.log(keys[key_of] / total[given_of]))
