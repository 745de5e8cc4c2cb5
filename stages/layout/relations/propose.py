"""What the network says of rooms that are being furnished: which object is next, and candidates for its box.

All rooms are seen together, one token after another, each drawing from a generator of its own.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import clear, company, looking, sizes
from apartgen.stages.layout.relations.features import SHUT_OUT
from apartgen.stages.layout.relations.memory import Memory
from apartgen.stages.layout.relations.speak import LEAST, Asked, Lanes, drawn, speak
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import Array, Ints, Shell
from apartgen.stages.layout.relations.weights import Model, Vocabulary
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

Floats = NDArray[np.float32]
APART = np.array([1.0, np.e, np.pi, np.sqrt(7), np.sqrt(11), np.sqrt(13), np.sqrt(17)])
"""Numbers of which no candidates have the same sum."""


@dataclass
class Particle:
    """A room on its way: what stands there, names still to come, notes on what found no place; what the encoder
    remembers of it, as long as that is of the same furniture."""

    furniture: Furniture
    left: list[str]
    notes: list[str] = field(default_factory=list)
    tries: int = 0
    begun: int = 1
    memory: tuple[Furniture, Memory] | None = None


@dataclass(frozen=True)
class Speaker:
    """The model before a room: its shell, type and facts, and how much is drawn of an object: `frames` references at
    most, `branches` of each, `offsets` of each branch; what logits of attributes (`sharp`) and of references (`sure`)
    are multiplied with. What is `large` is at least so large at one look after another, of any size at a later one."""

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
    large: sizes.Sizes = field(default_factory=dict)

    @cached_property
    def empty(self) -> Memory:
        """What the encoder remembers of the room without objects."""
        places = self.model.places
        memory = Memory(self.shell, self.type, self.facts, places.shape)
        looking.look(places, [memory])
        return memory


class Ask(NamedTuple):
    """Particles of one room, of each of which the next object is asked for, and what draws it."""

    speaker: Speaker
    particles: Sequence[Particle]
    rng: np.random.Generator


Said = tuple[str, Array, Array]
"""The next object's name, candidate boxes (n, 7), and their weights (n,)."""


def propose(asks: Sequence[Ask]) -> list[list[Said]]:
    """What is said of each particle of each room; the model and how much is drawn are those of the first."""
    return _Rooms(asks).propose() if asks else []


@cache
def _soft(name: str) -> bool:
    """Whether a category gives way to others."""
    return TABLE[name].soft or TABLE[name].place == "flat"


class _Rooms:
    """Particles of several rooms, and what is remembered of each."""

    def __init__(self, asks: Sequence[Ask]) -> None:
        self.asks = asks
        self.speaker, self.known = asks[0].speaker, asks[0].speaker.known
        self.places = self.speaker.model.places
        self.particles = [p for ask in asks for p in ask.particles]
        self.rooms = [ask.speaker for ask in asks for _ in ask.particles]
        self.lanes = Lanes([ask.rng for ask in asks], np.repeat(np.arange(len(asks)), [len(a.particles) for a in asks]))
        self.memories = [self._recalled(p, room) for p, room in zip(self.particles, self.rooms, strict=True)]

    def _recalled(self, p: Particle, room: Speaker) -> Memory:
        """What is remembered of a particle, with what has come since."""
        names = p.furniture.names
        if p.memory is None or p.memory[0] is not p.furniture:
            p.memory = p.furniture, room.empty.with_space(len(names) + len(p.left))
        memory = p.memory[1]
        known = memory.there - memory.shell
        if new := names[known:]:
            memory.add(p.furniture.boxes[known:], np.array([self.known.category(name) for name in new]),
                       np.array([_soft(name) for name in new]))
        return memory

    def propose(self) -> list[list[Said]]:
        """What is said of each particle, room by room."""
        names, refer = self._next()
        rows, reference, weight = self._frames(refer)
        found = self._candidates(names, rows, reference)
        slim = np.array([kinds.basic(name) in kinds.SLENDER for name in names])[rows]
        found[slim, :, 3:5] = found[slim, :, 3:5].min(-1, keepdims=True)  # as deep as wide
        each = found.shape[1]
        said = [(names[i], found[rows == i].reshape(-1, 7), np.repeat(weight[rows == i] / each, each))
                for i in range(len(names))]
        ends = np.cumsum([len(ask.particles) for ask in self.asks])
        return [said[end - len(ask.particles) : end] for ask, end in zip(self.asks, ends, strict=True)]

    def _left(self, lefts: Sequence[Sequence[str]]) -> Floats:
        counts = np.zeros((len(lefts), len(self.known.categories)), np.float32)
        for i, names in enumerate(lefts):
            for name in names:
                counts[i, self.known.category(name)] += 1
        return counts

    def _next(self) -> tuple[list[str], Array]:
        """The next object of each particle, and logits (B, T) of its references."""
        left = self.places.bag(self._left([p.left for p in self.particles]))
        asking = looking.look(self.places, self.memories, left)
        may = self._left([company.next_of(p.left, p.furniture.names, p.begun > 1) for p in self.particles])
        chosen = drawn(np.where(may == 0, SHUT_OUT, self.places.next(asking)), self.lanes)[:, 0]
        names = [next(name for name in p.left if self.known.category(name) == c)
                 for p, c in zip(self.particles, chosen.tolist(), strict=True)]
        return names, self.speaker.sure * looking.references(self.places, self.memories, asking, chosen)

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
        asked_for = np.array([self.known.category(name) for name in names])
        rest = self._left([p.left for p in self.particles])
        rest[np.arange(len(rest)), asked_for] -= 1
        asking = self.places.ask[asked_for] + self.places.bag(rest)
        state, seen = looking.framed(self.places, self.memories, rows, reference, asking[rows], asked_for[rows])
        asked = Asked(seen, *self._kinds(names, rows))
        speaker = self.speaker
        return speak(self.places, state, asked, speaker.branches, speaker.offsets, self.lanes.take(rows), speaker.sharp)

    def _kinds(self, names: list[str], rows: Ints) -> tuple[Array, Array, NDArray[np.bool_], Array, Array]:
        """Sizes from least to most, whose height is spoken, low and high, of the objects `names` in rows (R,)."""
        kinds = [TABLE[names[i]] for i in rows.tolist()]
        height = np.array([room.shell.boxes[0, 6] for room in self.rooms], float)[rows]
        most = np.array([k.max for k in kinds], np.float32)
        most[:, 2] = np.minimum(most[:, 2], height)
        most[:, :2] = np.minimum(most[:, :2], [sizes.most(k.lineage[-1]) for k in kinds])
        least = np.array([k.min for k in kinds], np.float32)
        large = [sizes.at_look(self.rooms[i].large, names[i], self.particles[i].tries) for i in rows.tolist()]
        least[:, :2] = np.minimum(np.maximum(least[:, :2], large), most[:, :2])
        return (least, most, np.array([k.place in ("wall", "top") for k in kinds]),
                np.array([np.nan if k.place == "ceiling" else 0.0 for k in kinds]), height)


def merged(boxes: Array, weight: NDArray[np.floating[Any]]) -> tuple[Array, NDArray[np.floating[Any]]]:
    """Candidates that are the same taken together."""
    key = boxes @ APART
    first, total = clear.summed(key, key.argsort(kind="stable"), np.asarray(weight, float))
    return boxes[first], total
