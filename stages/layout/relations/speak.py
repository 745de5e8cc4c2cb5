"""Draws an object's attributes from the heads, one after another: branches of a few, each with several offsets."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import around, clear, describe, pointing
from apartgen.stages.layout.relations.infer import Head, Places
from apartgen.stages.layout.relations.looking import Frames
from apartgen.stages.layout.relations.tokens import Array, Ints

Floats = NDArray[np.floating[Any]]
NO_TOKENS = np.zeros((0, 0), np.float32)


class Asked(NamedTuple):
    """Frames in which objects are to be described: sizes from least to most (R, 3) each, whose height is spoken (R,),
    heights of those that are not: `low` (R,), NaN for what hangs from a ceiling of height `high` (R,)."""

    frames: Frames
    least: Array
    most: Array
    hung: NDArray[np.bool_]
    low: Array
    high: Array


class Spans(NamedTuple):
    """Rows (R,) of some frames, and the tokens that each may point at: those of row r are `which` (P,) from `starts`
    (R + 1,) r on, `owner` (P,) the row of each."""

    frame: Ints
    starts: Ints
    which: Ints
    owner: Ints

    @classmethod
    def of(cls, starts: Ints, frame: Ints) -> "Spans":
        """Of all tokens of these frames, which begin at `starts`."""
        counts = np.diff(starts)[frame]
        own = np.append(0, counts.cumsum())
        owner = np.repeat(np.arange(len(frame)), counts)
        which = np.arange(own[-1]) + (starts[frame] - own[:-1])[owner]
        return cls(frame, own, which, owner)


class Lanes:
    """Chances for rows (R,) of several rooms, which come one after another; each room has a generator of its own."""

    def __init__(self, rngs: Sequence[np.random.Generator], room: Ints) -> None:
        self.rngs, self.room = rngs, room
        self.ends = np.bincount(room, minlength=len(rngs)).cumsum().tolist()

    def chance(self, times: int) -> NDArray[np.float64]:
        """Numbers in [0, 1), (R, times)."""
        found, start = np.empty((len(self.room), times)), 0
        for rng, end in zip(self.rngs, self.ends, strict=True):
            if end > start:
                rng.random(out=found[start:end])
            start = end
        return found

    def take(self, rows: Ints) -> "Lanes":
        """Those of some rows, in their order."""
        return Lanes(self.rngs, self.room[rows])


def drawn(logits: Floats, lanes: Lanes, sharp: float = 1.0, times: int = 1) -> Ints:
    """An index of each row of logits (R, N), so many times, (R, times); none that is below a share of the likeliest."""
    found: Ints = clear.picked(np.ascontiguousarray(logits, np.float32), lanes.chance(times), sharp, LEAST)
    return found


LEAST = 0.01
"""What is less likely than this share of the likeliest is not drawn."""


class _Rows(NamedTuple):
    """What is spoken of in rows: their frames and tokens, the model, what draws them, how sharply."""

    places: Places
    asked: Asked
    spans: Spans
    lanes: Lanes
    sharp: float

    def take(self, which: Ints) -> "_Rows":
        """Some rows, in their order."""
        spans = Spans.of(self.asked.frames.starts, self.spans.frame[which])
        return self._replace(spans=spans, lanes=self.lanes.take(which))

    def drawn(self, logits: Floats) -> Ints:
        """An index of each row of logits."""
        return drawn(logits, self.lanes, self.sharp)[:, 0]


def speak(places: Places, state: NDArray[np.float32], asked: Asked, branches: int, offsets: int, lanes: Lanes,
          sharp: float = 1.0) -> Array:
    """Candidate boxes (R, branches * offsets, 7) of objects whose states are (R, W)."""
    frame = np.repeat(np.arange(len(state)), branches)
    rows = _Rows(places, asked, Spans.of(asked.frames.starts, frame), lanes.take(frame), sharp)
    state = state[frame]
    heading = rows.drawn(places.heading(state))
    state += places.heading.own[heading]
    size = _sizes(rows, state)
    side = _sides(rows, state)
    low = _heights(rows, state, size)
    over = side == describe.OVER
    gap = rows.drawn(places.gap(state))
    state += places.gap.own[gap] * ~over[:, None]
    said = describe.Attributes(heading, size, side, gap, 0 * low, 0 * low, low, over)
    axis = describe.along_y(side).astype(np.int64)
    along = _offsets(rows, places.along, state, said, axis, offsets)
    across = np.zeros_like(along)
    if over.any():
        k = np.flatnonzero(over)
        some = said.take(k)._replace(along=along[k, 0])
        along[k] = along[k, :1]
        across[k] = _offsets(rows.take(k), places.across, state[k], some, np.zeros(len(k), np.int64), offsets)
    each = np.repeat(np.arange(len(state)), offsets)
    every = said.take(each)._replace(along=along.ravel(), across=across.ravel())
    return describe.placed(asked.frames.reference[frame[each]], every).reshape(-1, branches * offsets, 7)


def _either(rows: _Rows, head: Head, hidden: NDArray[np.float32], values: Array, at: Ints, bins: Array,
            there: NDArray[np.bool_], times: int = 1, extra: NDArray[np.float32] = NO_TOKENS,
            met: NDArray[np.float32] = NO_TOKENS) -> Array:
    """Values (R, times): a bin's, or that of a token, of which `values` (P, ways) in bins `at` are there (P,)."""
    spans, logits = rows.spans, head.bins(hidden)
    if len(met):
        logits += met
    keys = rows.places.keys(head, rows.asked.frames.keys)
    points = pointing.scores(head.point(hidden), head.copying(hidden)[:, 0], keys, spans.which, spans.starts, head.ways)
    chosen = pointing.picked(logits, met, points, head.share, at, extra, there, spans.starts, rows.lanes.chance(times),
                             rows.sharp, LEAST)
    return np.concatenate([bins, values.ravel()])[chosen]


def _sizes(rows: _Rows, state: NDArray[np.float32]) -> Array:
    """Sizes (R, 3); the states (R, W) know of them."""
    asked, (frame, _, which, owner) = rows.asked, rows.spans
    view, there = asked.frames.view[which], asked.frames.objects[which]
    same = np.zeros(len(which), np.float32)
    size = np.zeros((len(frame), 3), np.float32)
    for k, head in enumerate(rows.places.of_size):
        theirs = view[:, 7 + k] if k < 2 else view[:, 6] - view[:, 5]
        extra = (rows.places.same[k] * same)[:, None]
        mine = _either(rows, head, head.hidden(state), theirs[:, None], describe.size_bin(theirs)[:, None],
                       np.arange(describe.SIZES) * describe.SIZE, there, 1, extra)[:, 0]
        size[:, k] = np.minimum(np.maximum(mine, asked.least[frame, k]), asked.most[frame, k])
        state += head.own[describe.size_bin(size[:, k])]
        same += np.abs(theirs - size[owner, k]) < describe.CLOSE
    return size


def _sides(rows: _Rows, state: NDArray[np.float32]) -> Ints:
    """Sides (R,); walls have one only."""
    head, frame = rows.places.side, rows.spans.frame
    hidden = head.hidden(state)
    counts = head.counts(hidden)
    side = rows.drawn(head.bins(hidden) + (rows.asked.frames.taken[frame] * counts[:, None]).sum(-1))
    side = np.where(rows.asked.frames.reference[frame, 3] == 0, describe.FRONT, side)
    state += head.own[side]
    return side


def _heights(rows: _Rows, state: NDArray[np.float32], size: Array) -> Array:
    """Heights of undersides (R,)."""
    asked, frame = rows.asked, rows.spans.frame
    high = asked.high[frame]
    low = np.where(np.isnan(asked.low[frame]), high - size[:, 2], asked.low[frame]).astype(np.float32)
    k = np.flatnonzero(asked.hung[frame])
    if len(k):
        some = rows.take(k)
        levels = describe.levelled(asked.frames.view[some.spans.which][:, None], size[k[some.spans.owner], 2])[:, 0]
        head = rows.places.low
        found = _either(some, head, head.hidden(state[k]), levels, describe.level_bin(levels),
                        np.arange(describe.LEVELS) * describe.LEVEL, np.ones(len(levels), bool))[:, 0]
        low[k] = np.clip(found, 0, np.maximum(high[k] - size[k, 2], 0))
        state[k] += head.own[describe.level_bin(low[k])]
    return low


def _offsets(rows: _Rows, head: Head, state: NDArray[np.float32], said: describe.Attributes, axis: Ints,
             times: int) -> Array:
    """Offsets (R, times) along an axis (R,)."""
    seen, (frame, _, which, owner), hidden = rows.asked.frames, rows.spans, head.hidden(state)
    place, half, unknown = around.standing(said, axis, seen.reference[frame, 3:5] / 2)
    lines = describe.aligned(seen.view[which][:, None], axis[owner], half[owner, 0].astype(float))[:, 0]
    parts = np.stack([seen.starts[frame], np.where(unknown, seen.starts[frame], seen.starts[frame + 1])], -1)
    met = clear.met(seen.solid, seen.sort, parts, axis, place, half, head.counts(hidden),
                    describe.OFFSETS, describe.OFFSET, around.SLACK)
    return _either(rows, head, hidden, lines, describe.offset_bin(lines),
                   (np.arange(describe.OFFSETS) - describe.OFFSETS // 2) * describe.OFFSET,
                   np.ones(len(which), bool), times, met=met)
