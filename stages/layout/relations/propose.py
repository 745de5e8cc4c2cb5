"""What the network says of rooms that are being furnished: which object is next, and candidates for its box."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.stages.layout.relations import around, features, learning
from apartgen.stages.layout.relations.network import SHUT_OUT, Seen
from apartgen.stages.layout.relations.speak import Asked, drawn, speak
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import OBJECT, Array, Ints, Shell, seen, solids
from apartgen.stages.layout.relations.weights import Model, Vocabulary
from apartgen.stages.things.categories import TABLE


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
    most, `branches` of each, `offsets` of each branch."""

    model: Model
    known: Vocabulary
    shell: Shell
    type: int
    facts: Array
    frames: int
    branches: int
    offsets: int
    sharp: float

    def tokens(self, particles: Sequence[Particle]) -> tuple[Array, Ints, Ints, Array, Ints]:
        """boxes (B, T, 7), kind, category (B, T), swing (B, T, 2) and how many tokens are there, (B,)."""
        s = len(self.shell.kind)
        n = np.array([len(p.furniture.names) for p in particles])
        b, t = len(particles), s + int(n.max())
        boxes, kind = np.zeros((b, t, 7), np.float32), np.full((b, t), OBJECT)
        category, swing = np.full((b, t), -1), np.zeros((b, t, 2), np.float32)
        boxes[:, :s], kind[:, :s], swing[:, :s], _ = self.shell
        for i, p in enumerate(particles):
            boxes[i, s : s + n[i]] = p.furniture.boxes
            category[i, s : s + n[i]] = [self.known.category(name) for name in p.furniture.names]
        return boxes, kind, category, swing, s + n

    def propose(self, particles: Sequence[Particle], rng: np.random.Generator
                ) -> list[tuple[str, Array, Array]]:
        """For each room the next object's name, candidate boxes (n, 7), and their weights (n,)."""
        boxes, kind, category, swing, n = self.tokens(particles)
        with torch.inference_mode():
            names, refer = self._next(particles, boxes, kind, category, swing, n, rng)
            rows, reference, weight = self._frames(refer, rng)
            found = self._candidates(particles, names, rows, reference, boxes, kind, category, swing, n, rng)
        each = found.shape[1]
        return [(names[i], found[rows == i].reshape(-1, 7), np.repeat(weight[rows == i] / each, each))
                for i in range(len(particles))]

    def _seen(self, view: Array, kind: Ints, category: Ints, swing: Array, marked: Ints,
              real: NDArray[np.bool_]) -> Seen:
        b = len(kind)
        arrays = (features.numbers(view), kind, category, swing, marked, real, np.full(b, self.type),
                  np.broadcast_to(self.facts, (b, len(self.facts))))
        return Seen(*(torch.from_numpy(np.require(a, requirements=["C", "W"])) for a in arrays))

    def _left(self, lefts: Sequence[Sequence[str]]) -> Tensor:
        counts = np.zeros((len(lefts), len(self.known.categories)), np.float32)
        for i, names in enumerate(lefts):
            for name in names:
                counts[i, self.known.category(name)] += 1
        return torch.from_numpy(counts)

    def _next(self, particles: Sequence[Particle], boxes: Array, kind: Ints, category: Ints, swing: Array, n: Ints,
              rng: np.random.Generator) -> tuple[list[str], Array]:
        """The next object of each room, and logits (B, T) of its references."""
        network, t = self.model.places, kind.shape[1]
        b, s = len(kind), len(self.shell.kind)
        real = np.arange(t)[None] < n[:, None]
        view = self._seen(seen(boxes, np.zeros((b, 7), np.float32)), kind, category, swing, np.zeros((b, t), np.int64),
                          real)
        left = self._left([p.left for p in particles])
        mask = learning.scene_mask(np.full(b, s), n - s, t, 1)
        mask[:, t, :t] = torch.from_numpy(real)
        tokens, asking = network.look(view, network.bag(left)[:, None], mask)
        logits = network.next(asking[:, 0]).masked_fill(left == 0, SHUT_OUT)
        chosen = drawn(logits.numpy().astype(float), rng)[:, 0]
        names = [next(name for name in p.left if self.known.category(name) == c)
                 for p, c in zip(particles, chosen.tolist(), strict=True)]
        related = around.known_of(boxes, kind, category, chosen[:, None], n[:, None])
        refer = network.reference(asking, torch.from_numpy(chosen)[:, None], tokens, related)[:, 0]
        return names, np.where(real, refer.numpy(), SHUT_OUT)

    def _frames(self, refer: Array, rng: np.random.Generator) -> tuple[Ints, Ints, Array]:
        """References without repetition: their rows, tokens and weights, which sum to 1 in every row."""
        refer = refer - refer.max(1, keepdims=True)
        noisy = np.where(refer > np.log(0.01), refer + rng.gumbel(size=refer.shape), SHUT_OUT)
        order = np.argsort(-noisy, 1)[:, : self.frames]
        kept = np.take_along_axis(noisy, order, 1) > SHUT_OUT / 2
        share = np.where(kept, np.exp(np.take_along_axis(refer, order, 1)), 0.0)
        share /= share.sum(1, keepdims=True)
        rows = np.repeat(np.arange(len(refer)), order.shape[1]).reshape(order.shape)
        return rows[kept], order[kept], share[kept]

    def _candidates(self, particles: Sequence[Particle], names: list[str], rows: Ints, reference: Ints, boxes: Array,
                    kind: Ints, category: Ints, swing: Array, n: Ints, rng: np.random.Generator) -> Array:
        frame = boxes[rows, reference]
        view = seen(boxes[rows], frame)
        real = np.arange(kind.shape[1])[None] < n[rows, None]
        marked = np.zeros(real.shape, np.int64)
        marked[np.arange(len(rows)), reference] = 1
        rest = []
        for p, name in zip(particles, names, strict=True):
            others = list(p.left)
            others.remove(name)
            rest.append(others)
        left = self._left(rest)[torch.from_numpy(rows)]
        asked_for = np.array([self.known.category(name) for name in names])[rows]
        state, tokens = self.model.places.view(self._seen(view, kind[rows], category[rows], swing[rows], marked, real),
                                               torch.from_numpy(asked_for), left)
        soft = np.zeros(kind.shape, bool)
        for i, p in enumerate(particles):
            gives = [TABLE[o].soft or TABLE[o].place == "flat" for o in p.furniture.names]
            soft[i, len(self.shell.kind) : len(self.shell.kind) + len(gives)] = gives
        behind = np.zeros(kind.shape, np.float32)
        behind[:, : len(self.shell.deep)] = self.shell.deep
        bodies, sort = solids(boxes[rows], kind[rows], swing[rows], behind[rows], soft[rows])
        same = real & (category[rows] == asked_for[:, None])
        taken = around.beside(view, frame[:, 3:5] / 2, kind[rows], np.where(real, sort, 0), same)
        kinds = [TABLE[names[i]] for i in rows.tolist()]
        height = np.full(len(rows), self.shell.boxes[0, 6])
        asked = Asked(
            view, real, real & (kind[rows] == OBJECT), frame, np.array([k.min for k in kinds], np.float32),
            np.minimum(np.array([k.max for k in kinds], np.float32), [9.0, 9.0, height[0]]).astype(np.float32),
            np.array([k.place in ("wall", "top") for k in kinds]),
            np.array([np.nan if k.place == "ceiling" else 0.0 for k in kinds]), height, seen(bodies, frame),
            np.where(real, sort, 0), taken)
        return speak(self.model.places, state, tokens, asked, self.branches, self.offsets, rng, self.sharp)
