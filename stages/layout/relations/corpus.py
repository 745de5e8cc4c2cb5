"""A corpus as the relations model learns it: rooms as tokens, objects in functional order, a reference for each."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.batch import spreading
from apartgen.stages.layout.corpus import Corpus, read_corpus
from apartgen.stages.layout.relations import order, references
from apartgen.stages.layout.relations.tokens import ASKING, OBJECT, Array, Ints, shell
from apartgen.stages.things.categories import CATEGORIES
from apartgen.stages.use.household import OPEN

KINDS = ASKING + len(CATEGORIES)
"""Classes of what an object may be described from."""


@dataclass
class Furnished:
    """One room: tokens of the shell, then objects in functional order. boxes (T, 7), kind (T,), swing (T, 2), category
    (T,) -1 for the shell; length (n, T) of each object's description from each token; type, sleepers of its home, -1
    unknown, floor area; deep (T,) behind walls; duties (4,) of the room."""

    boxes: Array
    kind: Ints
    swing: Array
    category: Ints
    length: NDArray[np.float32]
    type: int
    sleepers: int
    area: float
    deep: Array
    duties: Ints

    @property
    def n(self) -> int:
        """How many objects it holds."""
        return int(self.length.shape[0])

    @property
    def shell(self) -> int:
        """How many tokens come before the objects."""
        return len(self.kind) - self.n


def read(path: Path, workers: int = 0) -> list[Furnished]:
    """The rooms of a corpus file; BadInput where there is none. So many processes help."""
    corpus = read_corpus(path)
    n = len(corpus)
    sleepers, duties = _told(path, "sleepers", (n,)), _told(path, "duties", (n, len(OPEN)))
    area = corpus.rooms.area
    rooms = [_tokens(corpus, i, float(area[i]), int(sleepers[i]), duties[i]) for i in range(n)]
    first = np.cumsum([0, *(room.n for room in rooms)])[:-1]
    with spreading(workers or 1) as spread:
        both = list(spread(_pairs, list(zip(rooms, first.tolist(), strict=True))))
    found, earlier = [pairs for pairs, _ in both], [came for _, came in both]
    joined = references.Pairs(*(np.concatenate([getattr(some, name) for some in found])
                                for name in references.Pairs.__dataclass_fields__))
    length = references.lengths(joined, np.concatenate(earlier), KINDS)
    at = 0
    for room in rooms:
        size = room.n * len(room.kind)
        room.length = length[at : at + size].reshape(room.n, len(room.kind)).astype(np.float32)
        at += size
    return rooms


def _pairs(numbered: tuple[Furnished, int]) -> tuple[references.Pairs, NDArray[np.bool_]]:
    """Whatever each object of a room could be described from, in rows from its first; and which of it came before the
    object."""
    room, first = numbered
    objects = np.arange(room.shell, len(room.kind))
    found = references.pairs(room.boxes, room.kind, room.category, objects, first, KINDS)
    return found, found.token < room.shell + found.row - first


def _told(path: Path, name: str, shape: tuple[int, ...]) -> Ints:
    """What a corpus says of its rooms' homes, -1 where it does not."""
    with np.load(path, allow_pickle=False) as file:
        return file[name].astype(np.int64) if name in file else np.full(shape, -1)


def _tokens(corpus: Corpus, i: int, area: float, sleepers: int, duties: Ints) -> Furnished:
    base = shell(corpus.rooms, i)
    there = np.flatnonzero(corpus.category[i] >= 0)
    category, center, size = corpus.category[i][there], corpus.center[i][there], corpus.size[i][there]
    boxes = np.column_stack([center[:, :2], corpus.yaw[i][there], size[:, :2], center[:, 2] - size[:, 2] / 2,
                             center[:, 2] + size[:, 2] / 2]).astype(np.float32)
    place = order.functional(category, boxes)
    n, s = len(there), len(base.kind)
    return Furnished(
        np.concatenate([base.boxes, boxes[place]]), np.concatenate([base.kind, np.full(n, OBJECT)]),
        np.concatenate([base.swing, np.zeros((n, 2), np.float32)]),
        np.concatenate([np.full(s, -1), category[place]]), np.zeros((n, s + n), np.float32),
        int(corpus.rooms.type[i]), sleepers, area,
        np.concatenate([base.deep, np.zeros(n, np.float32)]), duties,
    )


def earlier(room: Furnished, place: Ints) -> tuple[Ints, NDArray[np.bool_]]:
    """The reference of each object, were they described in the order `place` (n,), as tokens of that order (n,), and
    whether there is one at all."""
    s = room.shell
    length = room.length[place][:, np.concatenate([np.arange(s), s + place])]
    allowed = np.arange(s + len(place))[None] < s + np.arange(len(place))[:, None]
    shown = np.where(allowed, length, 2 * references.NEVER)
    best = shown.argmin(1)
    return best, shown[np.arange(len(place)), best] < references.NEVER
