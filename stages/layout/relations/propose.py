"""What the network says of rooms that are being furnished: which object is next, and candidates for its box.

Rooms that are alike in size are seen together, each drawing from a generator of its own.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from apartgen.stages.layout.relations import around, company, features, learning
from apartgen.stages.layout.relations.network import SHUT_OUT, Seen
from apartgen.stages.layout.relations.speak import LEAST, Asked, Lanes, drawn, speak
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import OBJECT, Array, Ints, Shell, seen, solids
from apartgen.stages.layout.relations.weights import Model, Vocabulary
from apartgen.stages.things.categories import TABLE

ALIKE = 1.5
"""Rooms are seen together whose tokens are not so many times as many as those of others."""


@dataclass
class Particle:
    """A room on its way: what stands there, names still to come, notes on what found no place."""

    furniture: Furniture
    left: list[str]
    notes: list[str] = field(default_factory=list)
    tries: int = 0
    begun: int = 1


@dataclass(frozen=True)
class Speaker:
    """The model before a room: its shell, type and facts, and how much is drawn of an object: `frames` references at
    most, `branches` of each, `offsets` of each branch; what logits of attributes (`sharp`) and of references (`sure`)
    are multiplied with. What is `wide` is at least so wide, unless it finds no place at two looks."""

    model: Model
    known: Vocabulary
    shell: Shell
    type: int
    facts: Array
    frames: int
    branches: int
    offsets: int
    sharp: float
    sure: float = 1.0
    wide: Mapping[str, float] = field(default_factory=dict)


class Ask(NamedTuple):
    """Particles of one room, of each of which the next object is asked for, and what draws it."""

    speaker: Speaker
    particles: Sequence[Particle]
    rng: np.random.Generator

    def tokens(self) -> int:
        """How many tokens the largest of them has."""
        return len(self.speaker.shell.kind) + max(len(p.furniture.names) for p in self.particles)


Said = tuple[str, Array, Array]
"""The next object's name, candidate boxes (n, 7), and their weights (n,)."""


def propose(asks: Sequence[Ask]) -> list[list[Said]]:
    """What is said of each particle of each room; the model and how much is drawn are those of the first."""
    order = sorted(range(len(asks)), key=lambda k: asks[k].tokens())
    together: list[list[int]] = []
    for k in order:
        if together and asks[k].tokens() <= ALIKE * asks[together[-1][0]].tokens():
            together[-1].append(k)
        else:
            together.append([k])
    found: dict[int, list[Said]] = {}
    with torch.inference_mode():
        for group in together:
            found |= dict(zip(group, _Rooms([asks[k] for k in group]).propose(), strict=True))
    return [found[k] for k in range(len(asks))]


class _Rooms:
    """Particles of several rooms as rows: boxes (B, T, 7), kind, category (B, T), swing (B, T, 2), deep (B, T), how
    many tokens are there and how many of these are the shell's (B,), type (B,), facts (B, 3)."""

    def __init__(self, asks: Sequence[Ask]) -> None:
        self.asks = asks
        self.speaker, self.known = asks[0].speaker, asks[0].speaker.known
        self.network = self.speaker.model.places
        self.particles = [p for ask in asks for p in ask.particles]
        self.rooms = rooms = [ask.speaker for ask in asks for _ in ask.particles]
        self.lanes = Lanes([ask.rng for ask in asks], np.repeat(np.arange(len(asks)), [len(a.particles) for a in asks]))
        self.s = np.array([len(room.shell.kind) for room in rooms])
        self.n = self.s + np.array([len(p.furniture.names) for p in self.particles])
        b, t = len(rooms), int(self.n.max())
        self.boxes, self.kind = np.zeros((b, t, 7), np.float32), np.full((b, t), OBJECT)
        self.category, self.swing = np.full((b, t), -1), np.zeros((b, t, 2), np.float32)
        self.deep = np.zeros((b, t), np.float32)
        self.soft = np.zeros((b, t), bool)
        self.type, self.facts = np.array([room.type for room in rooms]), np.stack([room.facts for room in rooms])
        for i, (p, room, s, n) in enumerate(zip(self.particles, rooms, self.s, self.n, strict=True)):
            self.boxes[i, :s], self.kind[i, :s], self.swing[i, :s], self.deep[i, :s] = room.shell
            self.boxes[i, s:n] = p.furniture.boxes
            self.category[i, s:n] = [self.known.category(name) for name in p.furniture.names]
            self.soft[i, s:n] = [TABLE[o].soft or TABLE[o].place == "flat" for o in p.furniture.names]
        self.real = np.arange(t)[None] < self.n[:, None]

    def propose(self) -> list[list[Said]]:
        """What is said of each particle, room by room."""
        names, refer = self._next()
        rows, reference, weight = self._frames(refer)
        found = self._candidates(names, rows, reference)
        each = found.shape[1]
        said = [(names[i], found[rows == i].reshape(-1, 7), np.repeat(weight[rows == i] / each, each))
                for i in range(len(names))]
        ends = np.cumsum([len(ask.particles) for ask in self.asks])
        return [said[end - len(ask.particles) : end] for ask, end in zip(self.asks, ends, strict=True)]

    def _seen(self, view: Array, marked: Ints, rows: Ints) -> Seen:
        arrays = (features.numbers(view), self.kind[rows], self.category[rows], self.swing[rows], marked,
                  self.real[rows], self.type[rows], self.facts[rows])
        return Seen(*(torch.from_numpy(np.require(a, requirements=["C", "W"])) for a in arrays))

    def _left(self, lefts: Sequence[Sequence[str]]) -> Tensor:
        counts = np.zeros((len(lefts), len(self.known.categories)), np.float32)
        for i, names in enumerate(lefts):
            for name in names:
                counts[i, self.known.category(name)] += 1
        return torch.from_numpy(counts)

    def _next(self) -> tuple[list[str], Array]:
        """The next object of each particle, and logits (B, T) of its references."""
        b, t = self.kind.shape
        view = self._seen(seen(self.boxes, np.zeros((b, 7), np.float32)), np.zeros((b, t), np.int64), np.arange(b))
        left = self._left([p.left for p in self.particles])
        mask = learning.scene_mask(self.s, self.n - self.s, t, 1)
        mask[:, t, :t] = torch.from_numpy(self.real)
        tokens, asking = self.network.look(view, self.network.bag(left)[:, None], mask)
        may = self._left([company.next_of(p.left, p.furniture.names) for p in self.particles])
        logits = self.network.next(asking[:, 0]).masked_fill(may == 0, SHUT_OUT)
        chosen = drawn(logits.numpy().astype(float), self.lanes)[:, 0]
        names = [next(name for name in p.left if self.known.category(name) == c)
                 for p, c in zip(self.particles, chosen.tolist(), strict=True)]
        bodies, sort = solids(self.boxes, self.kind, self.swing, self.deep, self.soft)
        related = around.known_of(self.boxes, self.kind, self.category, chosen[:, None], self.n[:, None], bodies,
                                  np.where(self.real, sort, 0))
        refer = self.network.reference(asking, torch.from_numpy(chosen)[:, None], tokens, related)[:, 0]
        return names, np.where(self.real, self.speaker.sure * refer.numpy(), SHUT_OUT)

    def _frames(self, refer: Array) -> tuple[Ints, Ints, Array]:
        """References without repetition: their rows, tokens and weights, which sum to 1 in every row."""
        rest, every = refer.copy(), np.arange(len(refer))
        order = np.zeros((len(refer), self.speaker.frames), np.int64)
        kept = np.zeros(order.shape, bool)
        likely = refer > refer.max(1, keepdims=True) + np.log(LEAST)
        for k in range(self.speaker.frames):
            order[:, k] = drawn(rest, self.lanes)[:, 0]
            kept[:, k] = likely[every, order[:, k]] & (rest[every, order[:, k]] > SHUT_OUT / 2)
            rest[every, order[:, k]] = SHUT_OUT
        share = np.where(kept, np.exp(np.take_along_axis(refer, order, 1) - refer.max(1, keepdims=True)), 0.0)
        share /= share.sum(1, keepdims=True)
        rows = np.repeat(every, order.shape[1]).reshape(order.shape)
        return rows[kept], order[kept], share[kept]

    def _candidates(self, names: list[str], rows: Ints, reference: Ints) -> Array:
        """Boxes (R, branches * offsets, 7) of the objects `names`, in the frames of references (R,) of rows (R,)."""
        frame, kind, real = self.boxes[rows, reference], self.kind[rows], self.real[rows]
        view = seen(self.boxes[rows], frame)
        marked = np.zeros(real.shape, np.int64)
        marked[np.arange(len(rows)), reference] = 1
        rest = []
        for p, name in zip(self.particles, names, strict=True):
            others = list(p.left)
            others.remove(name)
            rest.append(others)
        left = self._left(rest)[torch.from_numpy(rows)]
        asked_for = np.array([self.known.category(name) for name in names])[rows]
        state, tokens = self.network.view(self._seen(view, marked, rows), torch.from_numpy(asked_for), left)
        bodies, sort = solids(self.boxes[rows], kind, self.swing[rows], self.deep[rows], self.soft[rows])
        same = real & (self.category[rows] == asked_for[:, None])
        sort = np.where(real, sort, 0)
        taken = around.beside(view, frame[:, 3:5] / 2, kind, sort, same)
        kinds = [TABLE[names[i]] for i in rows.tolist()]
        height = self.boxes[rows, 0, 6].astype(float)
        most = np.array([k.max for k in kinds], np.float32)
        most[:, 2] = np.minimum(most[:, 2], height)
        least = np.array([k.min for k in kinds], np.float32)
        wide = [self.rooms[i].wide.get(names[i], 0.0) if self.particles[i].tries < 2 else 0.0 for i in rows.tolist()]
        least[:, 1] = np.maximum(least[:, 1], wide)
        asked = Asked(
            view, real, real & (kind == OBJECT), frame, least, most,
            np.array([k.place in ("wall", "top") for k in kinds]),
            np.array([np.nan if k.place == "ceiling" else 0.0 for k in kinds]), height,
            seen(bodies, frame), sort, taken)
        speaker = self.speaker
        return speak(self.network, state, tokens, asked, speaker.branches, speaker.offsets, self.lanes.take(rows),
                     speaker.sharp)
