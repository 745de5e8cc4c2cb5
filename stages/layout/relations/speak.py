"""Draws an object's attributes from the heads, one after another: branches of a few, each with several offsets."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.stages.layout.relations import describe
from apartgen.stages.layout.relations.around import Met
from apartgen.stages.layout.relations.clear import picked
from apartgen.stages.layout.relations.network import SHUT_OUT, Head, Relations
from apartgen.stages.layout.relations.tokens import Array, Ints

Floats = NDArray[np.floating[Any]]


@dataclass
class Asked:
    """Frames in which objects are to be described: tokens as seen (R, T, 9), which are there and which are objects
    (R, T), the references (R, 7), sizes from least to most (R, 3) each, whose height is spoken (R,), heights of those
    that are not: `low` (R,), NaN for what hangs from a ceiling of height `high` (R,); solids (R, T, 9) as seen,
    their sorts (R, T), what is at each side already (R, SIDES, SORTS)."""

    view: Array
    real: NDArray[np.bool_]
    objects: NDArray[np.bool_]
    reference: Array
    least: Array
    most: Array
    hung: NDArray[np.bool_]
    low: Array
    high: Array
    solid: Array
    sort: Ints
    taken: NDArray[np.float32]

    def repeated(self, times: int) -> "Asked":
        """Each row so many times."""
        return Asked(*(np.repeat(getattr(self, name), times, 0) for name in Asked.__dataclass_fields__))


class Lanes:
    """Chances for rows (R,) of several rooms, which come one after another; each room has a generator of its own."""

    def __init__(self, rngs: Sequence[np.random.Generator], room: Ints) -> None:
        self.rngs, self.room = rngs, room

    def chance(self, times: int) -> NDArray[np.float64]:
        """Numbers in [0, 1), (R, times)."""
        counts = np.bincount(self.room, minlength=len(self.rngs)).tolist()
        return np.concatenate([rng.random((n, times)) for rng, n in zip(self.rngs, counts, strict=True)])

    def take(self, rows: Ints) -> "Lanes":
        """Those of some rows, in their order."""
        return Lanes(self.rngs, self.room[rows])


def drawn(logits: Floats, lanes: Lanes, sharp: float = 1.0, times: int = 1) -> Ints:
    """An index of each row of logits (R, N), so many times, (R, times); none that is below a share of the likeliest."""
    found: Ints = picked(np.ascontiguousarray(logits, np.float32), lanes.chance(times), sharp, LEAST)
    return found


LEAST = 0.01
"""What is less likely than this share of the likeliest is not drawn."""


def speak(network: Relations, state: Tensor, tokens: Tensor, asked: Asked, branches: int, offsets: int,
          lanes: "Lanes", sharp: float = 1.0) -> Array:
    """Candidate boxes (R, branches * offsets, 7) of objects whose states are (R, W), among tokens (R, T, W)."""
    rows = len(state)
    pointing = (*network.of_size, network.low, network.along, network.across)
    keys = {id(head): head.keys(tokens).repeat_interleave(branches, 0) for head in pointing}
    state, asked = state.repeat_interleave(branches, 0), asked.repeated(branches)
    lanes = lanes.take(np.repeat(np.arange(rows), branches))
    heading = drawn(_numbers(network.heading(state)[0]), lanes, sharp)[:, 0]
    state = state + network.heading.own(torch.from_numpy(heading))
    state, size = _sizes(network, state, keys, asked, lanes, sharp)
    side = drawn(_numbers(network.side(state, depths=torch.from_numpy(asked.taken))[0]), lanes, sharp)[:, 0]
    walls = asked.reference[:, 3] == 0
    side = np.where(walls, describe.FRONT, side)
    state = state + network.side.own(torch.from_numpy(side))
    state, low = _heights(network, state, keys, asked, size, lanes, sharp)
    over = side == describe.OVER
    gap = drawn(_numbers(network.gap(state)[0]), lanes, sharp)[:, 0]
    state = state + network.gap.own(torch.from_numpy(gap)) * torch.from_numpy(~over)[:, None]
    said = describe.Attributes(heading, size, side, gap, 0 * low, 0 * low, low, over)
    axis = describe.along_y(side).astype(np.int64)
    along = _offsets(network.along, state, keys[id(network.along)], asked, said, axis, lanes, sharp, offsets)
    across = np.zeros_like(along)
    if over.any():
        k = np.flatnonzero(over)
        pick = torch.from_numpy(k)
        some = said.take(k)._replace(along=along[k, 0])
        along[k] = along[k, :1]
        across[k] = _offsets(network.across, state[pick], keys[id(network.across)][pick],
                             Asked(*(getattr(asked, name)[k] for name in Asked.__dataclass_fields__)), some,
                             np.zeros(len(k), np.int64), lanes.take(k), sharp, offsets)
    each = np.repeat(np.arange(len(state)), offsets)
    every = said.take(each)._replace(along=along.ravel(), across=across.ravel())
    return describe.placed(asked.reference[each], every).reshape(rows, branches * offsets, 7)


def _numbers(logits: Tensor) -> Floats:
    return logits.numpy().astype(np.float32)


def _either(head: Head, state: Tensor, keys: Tensor, at: Ints, values: Array, bins: Floats, there: NDArray[np.bool_],
            lanes: "Lanes", sharp: float, times: int = 1, extra: Array | None = None,
            depths: Array | None = None) -> Array:
    """Values (R, times): a bin's, or that of a token, of which `values` (R, T, ways) in bins `at` are there (R, T)."""
    logits, points = head(state, keys, torch.from_numpy(at), None if depths is None else torch.from_numpy(depths))
    shown = _numbers(points) + (0 if extra is None else extra)
    shown = np.where(there[..., None], shown, SHUT_OUT).reshape(len(state), -1)
    chosen = drawn(np.concatenate([_numbers(logits), shown], 1), lanes, sharp, times)
    flat = np.concatenate([np.broadcast_to(bins, (len(state), len(bins))), values.reshape(len(state), -1)], 1)
    return np.take_along_axis(flat, chosen, 1)


def _sizes(network: Relations, state: Tensor, keys: dict[int, Tensor], asked: Asked, lanes: "Lanes",
           sharp: float) -> tuple[Tensor, Array]:
    view = asked.view
    same = np.zeros(asked.real.shape, np.float32)
    size = np.zeros((len(view), 3), np.float32)
    for k, head in enumerate(network.of_size):
        theirs = view[..., 7 + k] if k < 2 else view[..., 6] - view[..., 5]
        extra = (float(network.same[k]) * same)[..., None]
        mine = _either(head, state, keys[id(head)], describe.size_bin(theirs)[..., None], theirs[..., None],
                       np.arange(describe.SIZES) * describe.SIZE, asked.objects, lanes, sharp, 1, extra)[:, 0]
        size[:, k] = np.clip(mine, asked.least[:, k], asked.most[:, k])
        state = state + head.own(torch.from_numpy(describe.size_bin(size[:, k])))
        same += np.abs(theirs - size[:, k, None]) < describe.CLOSE
    return state, size


def _heights(network: Relations, state: Tensor, keys: dict[int, Tensor], asked: Asked, size: Array,
             lanes: "Lanes", sharp: float) -> tuple[Tensor, Array]:
    low = np.where(np.isnan(asked.low), asked.high - size[:, 2], asked.low).astype(np.float32)
    k = np.flatnonzero(asked.hung)
    if len(k):
        levels = describe.levelled(asked.view[k], size[k, 2])
        pick = torch.from_numpy(k)
        found = _either(network.low, state[pick], keys[id(network.low)][pick], describe.level_bin(levels), levels,
                        np.arange(describe.LEVELS) * describe.LEVEL, asked.real[k], lanes.take(k), sharp)[:, 0]
        low[k] = np.clip(found, 0, np.maximum(asked.high[k] - size[k, 2], 0))
        state = state.clone()
        state[pick] += network.low.own(torch.from_numpy(describe.level_bin(low[k])))
    return state, low


def _offsets(head: Head, state: Tensor, keys: Tensor, asked: Asked, said: describe.Attributes, axis: Ints,
             lanes: "Lanes", sharp: float, times: int) -> Array:
    ex, ey = describe.extents(said.heading, said.size)
    lines = describe.aligned(asked.view, axis, np.where(axis == 1, ey, ex))
    met = Met(asked.solid, asked.sort, asked.reference[:, 3:5] / 2).told(said, axis)
    middle = describe.OFFSETS // 2
    return _either(head, state, keys, describe.offset_bin(lines), lines,
                   (np.arange(describe.OFFSETS) - middle) * describe.OFFSET, asked.real, lanes, sharp, times, None, met)
