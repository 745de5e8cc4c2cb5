"""Batches of a corpus, and the model's loss on them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.stages.layout.relations import describe, features
from apartgen.stages.layout.relations.around import Met, beside, known_of
from apartgen.stages.layout.relations.corpus import Furnished, earlier
from apartgen.stages.layout.relations.features import ROOM_FACTS, SHUT_OUT
from apartgen.stages.layout.relations.network import Head, Known, Relations, Seen
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


def scene_losses(network: Relations, of: Batch) -> dict[str, Tensor]:
    """Cross-entropy of the next category and of its reference, a mean over objects."""
    t, q = of.tokens, of.asked.shape[1]
    here = np.zeros((len(of.n), 7), np.float32)
    real = np.arange(t)[None] < (of.shell + of.n)[:, None]
    view = as_seen(of, seen(of.boxes, here), None, real)
    left = torch.from_numpy(of.left)
    tokens, asking = network.look(view, network.bag(left), scene_mask(of.shell, of.n, t, q))
    asked, there = torch.from_numpy(of.asked), torch.from_numpy(of.asked >= 0)
    logits = network.next(asking).float().masked_fill(left == 0, SHUT_OUT)[there]
    soft = SOFT[of.category] & (of.kind == OBJECT)
    bodies, sort = solids(of.boxes, of.kind, of.swing, of.deep, soft)
    known = known_of(of.boxes, of.kind, of.category, of.asked, of.shell[:, None] + np.arange(q), bodies,
                     np.where(real, sort, 0))
    refer = network.reference(asking, asked.clamp_min(0), tokens, Known(*map(torch.from_numpy, known)))
    before = np.arange(t)[None, None] < of.shell[:, None, None] + np.arange(q)[None, :, None]
    refer = refer.masked_fill(~torch.from_numpy(before), SHUT_OUT)[there & torch.from_numpy(of.said)]
    chosen = torch.from_numpy(of.reference)[there & torch.from_numpy(of.said)]
    cross = torch.nn.functional.cross_entropy
    return {"next": cross(logits, asked[there]), "refer": cross(refer, chosen)}


def frame_losses(network: Relations, of: Batch, rows: Ints, which: Ints, hung: NDArray[np.bool_]) -> dict[str, Tensor]:
    """−log p of the attributes of objects `which` (P,) of rooms `rows` (P,); `hung` (C,) tells categories whose height
    is spoken."""
    shell, at = of.shell[rows], of.reference[rows, which]
    category = of.asked[rows, which]
    frame = of.boxes[rows, at]
    view = seen(of.boxes[rows], frame)
    own = view[np.arange(len(rows)), shell + which]
    said = describe.describe(own, frame[:, 3:5] / 2, of.kind[rows, at])
    real = np.arange(of.tokens)[None] < (shell + which)[:, None]
    seen_by = as_seen(of, view, at, real, rows)
    left = of.left[rows, which].copy()
    left[np.arange(len(rows)), category] -= 1
    state, tokens = network.view(seen_by, torch.from_numpy(category), torch.from_numpy(left))
    objects = real & (of.kind[rows] == OBJECT)
    soft = SOFT[of.category[rows]] & objects
    bodies, sort = solids(of.boxes[rows], of.kind[rows], of.swing[rows], of.deep[rows], soft)
    met = Met(seen(bodies, frame), np.where(real, sort, 0), frame[:, 3:5] / 2)
    same = objects & (of.category[rows] == category[:, None])
    taken = beside(view, frame[:, 3:5] / 2, of.kind[rows], np.where(real, sort, 0), same)
    return spoken(network, state, tokens, Heard(view, said, real, objects, hung[category], met, taken))


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


def spoken(network: Relations, state: Tensor, tokens: Tensor, heard: Heard) -> dict[str, Tensor]:
    """−log p of every attribute, each given those before it, a mean over those who have it."""
    said, view, out = heard.said, heard.view, dict[str, Tensor]()
    every = np.ones(len(said.heading), bool)
    out["heading"] = _loss(network.heading, state, every, said.heading)
    state = state + network.heading.own(torch.from_numpy(said.heading))
    same = np.zeros(heard.real.shape, np.float32)
    for k, head in enumerate(network.of_size):
        theirs, mine = view[..., 7 + k] if k < 2 else view[..., 6] - view[..., 5], said.size[..., k]
        match = np.abs(theirs - mine[:, None]) < describe.CLOSE
        extra = network.same[k] * torch.from_numpy(same)[..., None]
        bins = describe.size_bin(mine)
        out[f"size {k}"] = _loss(head, state, every, bins, tokens, describe.size_bin(theirs)[..., None],
                                 match[..., None], heard.objects, extra)
        state = state + head.own(torch.from_numpy(bins))
        same += match
    sides = network.side(state, depths=torch.from_numpy(heard.taken))[0]
    out["side"] = torch.nn.functional.cross_entropy(sides, torch.from_numpy(said.side))
    state = state + network.side.own(torch.from_numpy(said.side))
    levels = describe.levelled(view, said.size[..., 2])
    if heard.hung.any():
        bins = describe.level_bin(said.low)
        out["low"] = _loss(network.low, state, heard.hung, bins, tokens, describe.level_bin(levels),
                           np.abs(levels - said.low[:, None, None]) < describe.CLOSE, heard.real)
        own = network.low.own(torch.from_numpy(bins))
        state = state + own * torch.from_numpy(heard.hung)[:, None].to(own.dtype)
    over = said.side == describe.OVER
    out["gap"] = _loss(network.gap, state, ~over, said.gap)
    beside = network.gap.own(torch.from_numpy(said.gap))
    state = state + beside * torch.from_numpy(~over)[:, None].to(beside.dtype)
    ex, ey = describe.extents(said.heading, said.size)
    axis = describe.along_y(said.side).astype(np.int64)
    for name, head, who, way, half, value in (
        ("along", network.along, every, axis, np.where(axis == 1, ey, ex), said.along),
        ("across", network.across, over, 0 * axis, ex, said.across),
    ):
        if who.any():
            lines = describe.aligned(view, way, half)
            out[name] = _loss(head, state, who, describe.offset_bin(value), tokens, describe.offset_bin(lines),
                              np.abs(lines - value[:, None, None]) < describe.CLOSE, heard.real,
                              depths=heard.met.told(said, way))
    return out


def _loss(head: Head, state: Tensor, who: NDArray[np.bool_], bins: Ints, tokens: Tensor | None = None,
          at: Ints | None = None, match: NDArray[np.bool_] | None = None, real: NDArray[np.bool_] | None = None,
          extra: Tensor | None = None, depths: Array | None = None) -> Tensor:
    """Mean −log p of values in `bins` or where pointers `match` (P, T, ways), among rows `who`."""
    row = torch.from_numpy(np.flatnonzero(who))
    wanted = torch.from_numpy(bins)[row]
    if tokens is None or at is None or match is None or real is None:
        return torch.nn.functional.cross_entropy(head(state[row])[0], wanted)
    met = None if depths is None else torch.from_numpy(depths)[row]
    logits, points = head(state[row], head.keys(tokens[row]), torch.from_numpy(at)[row], met)
    points = points if extra is None else points + extra[row]
    there = torch.from_numpy(real)[row][..., None]
    points = points.masked_fill(~there, SHUT_OUT)
    hit = points.masked_fill(~(torch.from_numpy(match)[row] & there), SHUT_OUT).flatten(1)
    whole = torch.cat([logits, points.flatten(1)], 1).logsumexp(1)
    right = torch.cat([logits.gather(1, wanted[:, None]), hit], 1).logsumexp(1)
    return (whole - right).mean()
