"""Batches of a corpus, and all that the model is told and asked of them: numbers alone, before any network."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.stages.layout.relations import describe, features
from apartgen.stages.layout.relations.around import Met, beside, known_of
from apartgen.stages.layout.relations.corpus import Furnished, earlier
from apartgen.stages.layout.relations.features import ROOM_FACTS
from apartgen.stages.layout.relations.network import Known, Seen
from apartgen.stages.layout.relations.tokens import OBJECT, Array, Ints, mirrored, seen, solids, turned
from apartgen.stages.things.categories import CATEGORIES, TABLE

LOCKED = 0.15
"""Share of rooms of which some objects come first, as they do where they are given."""
SOFT = np.array([*(TABLE[name].soft or TABLE[name].place == "flat" for name in CATEGORIES), False])
"""What gives way, by category; the last for what is no object."""
UNTOLD = 0.3
"""Share of rooms that do not tell how many sleep in the home."""


@dataclass
class Batch:
    """Rooms padded to T tokens and Q objects: boxes (B, T, 7), kind, category (B, T), swing (B, T, 2), shell, n (B,),
    type (B,), facts (B, 3), asked category (B, Q) -1 past the last, reference (B, Q), said (B, Q) whether it has one,
    left (B, Q, C) to come, the object itself included, deep (B, T) behind walls."""

    boxes: Array
    kind: Ints
    category: Ints
    swing: Array
    shell: Ints
    n: Ints
    type: Ints
    facts: Array
    asked: Ints
    reference: Ints
    said: NDArray[np.bool_]
    left: Array
    deep: Array

    @property
    def tokens(self) -> int:
        """T."""
        return int(self.kind.shape[1])


def batch(rooms: Sequence[Furnished], categories: int, rng: np.random.Generator) -> Batch:
    """Rooms, each mirrored and turned at random, some with given objects first."""
    t, q = max(len(room.kind) for room in rooms), max(room.n for room in rooms)
    b = len(rooms)
    out = Batch(
        np.zeros((b, t, 7), np.float32), np.zeros((b, t), np.int64), np.full((b, t), -1),
        np.zeros((b, t, 2), np.float32),
        np.array([room.shell for room in rooms]), np.array([room.n for room in rooms]),
        np.array([room.type for room in rooms]), np.zeros((b, ROOM_FACTS), np.float32), np.full((b, q), -1),
        np.zeros((b, q), np.int64), np.zeros((b, q), bool), np.zeros((b, q, categories), np.float32),
        np.zeros((b, t), np.float32))
    for i, room in enumerate(rooms):
        place = np.arange(room.n)
        if rng.random() < LOCKED:
            given = rng.random(room.n) < rng.random()
            place = np.argsort(~given, kind="stable")
        order = np.concatenate([np.arange(room.shell), room.shell + place])
        boxes, swing = room.boxes[order], room.swing[order]
        if rng.random() < 0.5:
            boxes, swing = mirrored(boxes), swing * [1, -1] + _flipped(room, order)
        n = len(order)
        out.boxes[i, :n], out.swing[i, :n] = turned(boxes, int(rng.integers(4))), swing
        out.kind[i, :n], out.category[i, :n] = room.kind[order], room.category[order]
        out.deep[i, :n] = room.deep[order]
        told = room.sleepers if rng.random() > UNTOLD else -1
        out.facts[i] = features.room_facts(room.area, float(room.boxes[0, 6]), told)
        out.asked[i, : room.n] = room.category[room.shell :][place]
        out.reference[i, : room.n], out.said[i, : room.n] = earlier(room, place)
        coming = np.eye(categories, dtype=np.float32)[out.asked[i, : room.n]]
        out.left[i, : room.n] = coming[::-1].cumsum(0)[::-1]
    return out


def _flipped(room: Furnished, order: Ints) -> Array:
    """What turns the mirrored hinges of openings to the other end: one where there is an opening."""
    return np.stack([np.zeros(len(order)), (room.kind[order] >= 2) & (room.kind[order] < OBJECT)], -1)


def as_seen(of: Batch, viewed: Array, viewer: Ints | None, real: NDArray[np.bool_], rows: Ints | None = None) -> Seen:
    """Tensors of tokens (B, T, 9) as seen in some frames; `rows` of the batch where not all."""
    pick = np.arange(len(of.kind)) if rows is None else rows
    marked = np.zeros(real.shape, np.int64)
    if viewer is not None:
        marked[np.arange(len(pick)), viewer] = 1
    arrays = (features.numbers(viewed), of.kind[pick], of.category[pick], of.swing[pick].astype(np.float32), marked,
              real, of.type[pick], of.facts[pick])
    return Seen(*(torch.from_numpy(np.ascontiguousarray(a)) for a in arrays))


def scene_mask(shell: Ints, n: Ints, tokens: int, asking: int) -> Tensor:
    """What may attend to what, (B, T + Q, T + Q): the shell to itself, objects to what came before, and who asks for
    the next object to all that is there by then."""
    b = len(shell)
    index = np.arange(tokens)[None]
    rank = np.where(index < shell[:, None], 0, index - shell[:, None] + 1)
    real = index < (shell + n)[:, None]
    sees = np.zeros((b, tokens + asking, tokens + asking), bool)
    sees[:, :tokens, :tokens] = real[:, None, :] & (rank[:, None, :] <= rank[:, :, None])
    sees[:, tokens:, :tokens] = real[:, None, :] & (rank[:, None, :] <= np.arange(asking)[None, :, None])
    sees[:, np.arange(tokens + asking), np.arange(tokens + asking)] = True
    return torch.from_numpy(sees)


@dataclass
class Scene:
    """What is asked of rooms in their own frames, of Q objects each: tokens, what is `left` to come (B, Q, C), what may
    attend to what (B, T + Q, T + Q), the category that comes (B, Q) and whether there is one, what is `known` of
    tokens, which of them came `before` (B, Q, T), and those that `told` (B, Q) objects are described from (n,)."""

    view: Seen
    left: Tensor
    mask: Tensor
    asked: Tensor
    there: Tensor
    known: Known
    before: Tensor
    told: Tensor
    reference: Tensor


def scene(of: Batch) -> Scene:
    """What is asked of a batch in the rooms' own frames."""
    t, q = of.tokens, of.asked.shape[1]
    here = np.zeros((len(of.n), 7), np.float32)
    real = np.arange(t)[None] < (of.shell + of.n)[:, None]
    soft = SOFT[of.category] & (of.kind == OBJECT)
    bodies, sort = solids(of.boxes, of.kind, of.swing, of.deep, soft)
    known = known_of(of.boxes, of.kind, of.category, of.asked, of.shell[:, None] + np.arange(q), bodies,
                     np.where(real, sort, 0))
    before = np.arange(t)[None, None] < of.shell[:, None, None] + np.arange(q)[None, :, None]
    told = (of.asked >= 0) & of.said
    return Scene(
        as_seen(of, seen(of.boxes, here), None, real), torch.from_numpy(of.left),
        scene_mask(of.shell, of.n, t, q), torch.from_numpy(of.asked), torch.from_numpy(of.asked >= 0),
        Known(*map(torch.from_numpy, known)), torch.from_numpy(before), torch.from_numpy(told),
        torch.from_numpy(of.reference[told]))


@dataclass
class Asked:
    """One attribute of P objects: the rows that have it (R,) and its bins there (R,); who it is told afterwards (P, 1)
    and as which bins (P,). Where it may be that of a token: the bins of tokens (R, T, ways), which of them are right
    (R, T, ways) and there (R, T, 1), and how often sizes were theirs so far (R, T, 1); what would be met (R, ...)."""

    name: str
    rows: Tensor
    wanted: Tensor
    told: Tensor
    bins: Tensor
    at: Tensor | None = None
    match: Tensor | None = None
    real: Tensor | None = None
    same: Tensor | None = None
    depths: Tensor | None = None


@dataclass
class Frames:
    """What is asked of P objects in the frames of their references, attribute after attribute."""

    view: Seen
    category: Tensor
    left: Tensor
    asked: list[Asked]


def frames(of: Batch, rows: Ints, which: Ints, hung: NDArray[np.bool_]) -> Frames:
    """What is asked of objects `which` (P,) of rooms `rows` (P,); `hung` (C,) tells categories whose height is
    spoken."""
    shell, at = of.shell[rows], of.reference[rows, which]
    category = of.asked[rows, which]
    frame = of.boxes[rows, at]
    view = seen(of.boxes[rows], frame)
    own = view[np.arange(len(rows)), shell + which]
    said = describe.describe(own, frame[:, 3:5] / 2, of.kind[rows, at])
    real = np.arange(of.tokens)[None] < (shell + which)[:, None]
    left = of.left[rows, which].copy()
    left[np.arange(len(rows)), category] -= 1
    objects = real & (of.kind[rows] == OBJECT)
    soft = SOFT[of.category[rows]] & objects
    bodies, sort = solids(of.boxes[rows], of.kind[rows], of.swing[rows], of.deep[rows], soft)
    met = Met(seen(bodies, frame), np.where(real, sort, 0), frame[:, 3:5] / 2)
    same = objects & (of.category[rows] == category[:, None])
    taken = beside(view, frame[:, 3:5] / 2, of.kind[rows], np.where(real, sort, 0), same)
    return Frames(as_seen(of, view, at, real, rows), torch.from_numpy(category), torch.from_numpy(left),
                  _attributes(Heard(view, said, real, objects, hung[category], met, taken)))


@dataclass
class Heard:
    """What is to be spoken: tokens as seen (P, T, 9), the attributes, tokens and objects (P, T) there are, and whose
    height is spoken (P,), what keeps them away, what is at the sides already."""

    view: Array
    said: describe.Attributes
    real: NDArray[np.bool_]
    objects: NDArray[np.bool_]
    hung: NDArray[np.bool_]
    met: Met
    taken: NDArray[np.float32]


def _attributes(heard: Heard) -> list[Asked]:
    """What is asked of the attributes, in the order in which they are spoken."""
    said, view = heard.said, heard.view
    every = np.ones(len(said.heading), bool)
    out = [_asked("heading", every, said.heading)]
    same = np.zeros(heard.real.shape, np.float32)
    for k in range(3):
        theirs, mine = view[..., 7 + k] if k < 2 else view[..., 6] - view[..., 5], said.size[..., k]
        match = np.abs(theirs - mine[:, None]) < describe.CLOSE
        out.append(_asked(f"size {k}", every, describe.size_bin(mine), describe.size_bin(theirs)[..., None],
                          match[..., None], heard.objects, same=same.copy()))
        same += match
    out.append(_asked("side", every, said.side, depths=heard.taken))
    levels = describe.levelled(view, said.size[..., 2])
    if heard.hung.any():
        out.append(_asked("low", heard.hung, describe.level_bin(said.low), describe.level_bin(levels),
                          np.abs(levels - said.low[:, None, None]) < describe.CLOSE, heard.real))
    over = said.side == describe.OVER
    out.append(_asked("gap", ~over, said.gap))
    ex, ey = describe.extents(said.heading, said.size)
    axis = describe.along_y(said.side).astype(np.int64)
    for name, who, way, half, value in (("along", every, axis, np.where(axis == 1, ey, ex), said.along),
                                        ("across", over, 0 * axis, ex, said.across)):
        if who.any():
            lines = describe.aligned(view, way, half)
            out.append(_asked(name, who, describe.offset_bin(value), describe.offset_bin(lines),
                              np.abs(lines - value[:, None, None]) < describe.CLOSE, heard.real,
                              depths=heard.met.told(said, way)))
    return out


def _asked(name: str, who: NDArray[np.bool_], bins: Ints, at: Ints | None = None,
           match: NDArray[np.bool_] | None = None, real: NDArray[np.bool_] | None = None, same: Array | None = None,
           depths: Array | None = None) -> Asked:
    """One attribute of rows `who`, with what concerns these rows only."""
    rows = np.flatnonzero(who)

    def some(array: NDArray[Any] | None) -> Tensor | None:
        return None if array is None else torch.from_numpy(np.ascontiguousarray(array[rows]))

    return Asked(name, torch.from_numpy(rows), torch.from_numpy(bins[rows]), torch.from_numpy(who)[:, None],
                 torch.from_numpy(bins), some(at), some(match), some(None if real is None else real[..., None]),
                 some(None if same is None else same[..., None]), some(depths))
