"""Rooms and frames as the encoders see them, the tokens of several one after another."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import around, clear, describe, pointing, seeing
from apartgen.stages.layout.relations.features import METRES, ROOM_FACTS, SHUT_OUT
from apartgen.stages.layout.relations.infer import Places, Rooms
from apartgen.stages.layout.relations.memory import Memory
from apartgen.stages.layout.relations.tokens import OBJECT, WALL, Array, Ints

Floats = NDArray[np.float32]
HERE = np.zeros((1, 7), np.float32)
"""Who looks from the room's own frame."""


def look(places: Places, memories: Sequence[Memory], asking: Floats | None = None) -> Floats:
    """The scene encoder: what is fresh in rooms will be remembered; the hidden states (B, W) of who is `asking`."""
    fresh = np.array([memory.fresh for memory in memories])
    boxes, kind, category, swing = (
        np.concatenate([getattr(m, name)[m.n : m.there] for m in memories])
        for name in ("boxes", "kind", "category", "swing"))
    bare = np.flatnonzero([memory.n == 0 for memory in memories])
    tokens = places.scene_tokens(
        seeing.seen(boxes, HERE, np.zeros(len(kind), np.int64)), kind, category, swing, np.zeros(len(kind), np.int64),
        _rooms([memories[k] for k in bare.tolist()], (fresh.cumsum() - fresh)[bare]))
    if asking is None:
        tokens, states = places.look(memories, tokens, False), np.zeros((0, places.shape.width), np.float32)
    else:
        x, last = _with_asking(tokens, fresh, asking)
        x = places.look(memories, x)
        tokens, states = np.delete(x, last, 0), x[last]
    _remember(places, memories, tokens)
    return states


def _rooms(memories: Sequence[Memory], at: Ints) -> Rooms:
    """Rooms whose tokens are `at` (R,) some place."""
    facts = np.array([memory.facts for memory in memories], np.float32).reshape(len(memories), ROOM_FACTS)
    return Rooms(at, np.array([memory.type for memory in memories], np.int64), facts)


def _with_asking(tokens: Floats, counts: Ints, asking: Floats) -> tuple[Floats, Ints]:
    """Tokens (N, W), so many (R,) in every part, and after each part who is asking there (R, W); where these are."""
    x = np.empty((len(tokens) + len(asking), tokens.shape[1]), np.float32)
    last = counts.cumsum() + np.arange(len(counts))
    x[last] = asking
    x[np.arange(len(tokens)) + np.repeat(np.arange(len(counts)), counts)] = tokens
    return x, last


def _remember(places: Places, memories: Sequence[Memory], tokens: Floats) -> None:
    """What is asked of fresh tokens (N, W) when references are chosen, and of how they lie to others."""
    referred, tells = places.known(tokens)
    pairs = [memory.fresh_pairs() for memory in memories]
    views = [seeing.seen(m.boxes[t], m.boxes, j) for m, (j, t) in zip(memories, pairs, strict=True)]
    lies = places.lies(around.relations(np.concatenate(views)))
    at = first = 0
    for memory, (j, t) in zip(memories, pairs, strict=True):
        some, end = slice(memory.n, memory.there), at + memory.fresh
        memory.referred[some], memory.tells[some] = referred[at:end], tells[at:end]
        memory.lies[j - memory.shell, t] = lies[first : first + len(j)]
        memory.n, memory.fresh, at, first = memory.there, 0, end, first + len(j)


def references(places: Places, memories: Sequence[Memory], asking: Floats, category: Ints) -> Array:
    """Logits (B, T) of what objects (B,) that were asked for (B, W) may be described from, shut out past the last."""
    query = places.query(asking, category)
    asks, taken, fits = places.asks(query), places.taken(query), places.fits(query)
    found = np.full((len(query), max(memory.there for memory in memories)), SHUT_OUT)
    for i, m in enumerate(memories):
        there = slice(m.there)
        one = pointing.referring(query[i], asks[i], m.referred[there], m.tells[there], m.lies, m.shell)
        one += taken[i] * pointing.alike(m.boxes[there], m.category[there], category[i], around.NEAR)
        wall = m.kind[there] == WALL
        free = clear.stretches(m.boxes[None, there], wall[None], m.solid[None, there], m.sort[None, there],
                               np.array([[m.there]]), clear.DEEP)[0, 0, wall]
        lacks = np.maximum(1 - free[..., None] / clear.LONG, 0).reshape(len(free), clear.FITS)
        one[wall] += (lacks * fits[i]).sum(-1) * METRES
        found[i, there] = one
    return found


class Frames(NamedTuple):
    """References (R, 7), and tokens seen from them, those of each from `starts` (R + 1,) on: view (N, 9), which are
    objects (N,), solids (N, 9), their sorts (N,), `keys` (N, heads * K) by which they are pointed at; what is at each
    side of the references already (R, SIDES, SORTS)."""

    reference: Array
    starts: Ints
    view: Array
    objects: NDArray[np.bool_]
    solid: Floats
    sort: Ints
    keys: Floats
    taken: Floats


def framed(places: Places, memories: Sequence[Memory], rows: Ints, reference: Ints, asking: Floats,
           category: Ints) -> tuple[Floats, Frames]:
    """The frame encoder: states (R, W) of objects of some categories (R,), `asking` (R, W) in the frames of references
    (R,) of rooms `rows` (R,)."""
    boxes, kind, of, swing, solid, sort = (
        np.concatenate([getattr(m, name)[: m.there] for m in memories])
        for name in ("boxes", "kind", "category", "swing", "solid", "sort"))
    there = np.array([memory.there for memory in memories])
    first = (there.cumsum() - there)[rows]
    counts, frame = there[rows], boxes[first + reference]
    starts = np.append(0, counts.cumsum())
    owner = np.repeat(np.arange(len(rows)), counts)
    which = np.arange(len(owner)) + (first - starts[:-1])[owner]
    view = seeing.seen(boxes[which], frame, owner)
    viewer = np.zeros(len(which), np.int64)
    viewer[starts[:-1] + reference] = 1
    kind, of, sort = kind[which], of[which], sort[which]
    tokens = places.frame_tokens(view, kind, of, swing[which], viewer,
                                 _rooms([memories[i] for i in rows.tolist()], starts[:-1]))
    state, keys = places.view(_with_asking(tokens, counts, asking)[0], starts + np.arange(len(starts)))
    near = around.at_sides(view, frame[owner, 3:5] / 2, sort, of == category[owner])
    taken = np.zeros((len(rows), describe.SIDES, clear.SORTS), np.float32)
    taken[..., : near.shape[-1]] = np.logical_or.reduceat(near, starts[:-1])
    bodies = seeing.seen(solid[which], frame, owner)
    return state, Frames(frame, starts, view, kind == OBJECT, bodies, sort, keys, taken)
