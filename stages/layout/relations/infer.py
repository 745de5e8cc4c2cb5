"""The networks of `network.py` and `network_contents.py` without torch, for the weights that these learned.

Tokens of several rooms come one after another, so that nothing is computed of what is only there to fill up. The scene
encoder is told what is new in a room and remembers the rest (`memory.py`).
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import dense, features
from apartgen.stages.layout.relations.features import METRES
from apartgen.stages.layout.relations.memory import Memory
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.tokens import Array

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]
Tensors = Mapping[str, Floats]
POINTING = ("sizes.0", "sizes.1", "sizes.2", "low", "along", "across")
"""Heads that may say that a number is that of another token."""


class Linear(NamedTuple):
    """weight (in, out), bias (out,)."""

    weight: Floats
    bias: Floats

    def __call__(self, x: Floats) -> Floats:
        return dense.product(x, self.weight, self.bias)


class Norm(NamedTuple):
    """gain, bias (W,)."""

    gain: Floats
    bias: Floats

    def __call__(self, x: Floats) -> Floats:
        return dense.normed(x, self.gain, self.bias)


def linear(tensors: Tensors, name: str) -> Linear:
    """A linear layer by its name; without a bias where it has none."""
    weight = np.ascontiguousarray(tensors[f"{name}.weight"].T)
    return Linear(weight, tensors.get(f"{name}.bias", np.zeros(weight.shape[1], np.float32)))


def norm(tensors: Tensors, name: str) -> Norm:
    """A norm by its name."""
    return Norm(tensors[f"{name}.weight"], tensors[f"{name}.bias"])


def gated(x: Floats) -> Floats:
    """GELU of what nobody else needs."""
    dense.gate(x)
    return x


class Layer(NamedTuple):
    """Attention and a perceptron, each after a norm."""

    before: Norm
    mixed: Linear
    out: Linear
    after: Norm
    up: Linear
    down: Linear
    heads: int

    def within(self, x: Floats, starts: Ints) -> None:
        """x (N, W), in place, parts of which see all of themselves and nothing else."""
        self.rest(x, dense.attend_within(self.mixed(self.before(x)), starts, self.heads))

    def rest(self, x: Floats, seen: Floats) -> None:
        """x (N, W), in place, by what was `seen` (N, W)."""
        dense.add_product(seen, *self.out, x)
        dense.add_product(gated(self.up(self.after(x))), *self.down, x)


class Rooms(NamedTuple):
    """Which tokens are rooms (R,), of what types (R,), and their facts (R, 3)."""

    at: Ints
    type: Ints
    facts: Floats


class Tokens:
    """Embeds tokens seen in some frame."""

    def __init__(self, tensors: Tensors, name: str) -> None:
        self.numbers, self.fold = linear(tensors, f"{name}.numbers"), linear(tensors, f"{name}.fold.1")
        self.kind, self.category = tensors[f"{name}.kind.weight"], tensors[f"{name}.category.weight"]
        self.swing, self.viewer = linear(tensors, f"{name}.swing"), tensors[f"{name}.viewer.weight"]
        self.type, self.facts = tensors[f"{name}.room_type.weight"], linear(tensors, f"{name}.facts")

    def __call__(self, view: Array, kind: Ints, category: Ints, swing: Floats, viewer: Ints, rooms: "Rooms") -> Floats:
        """Tokens (N, W) as seen (N, 9): kind, category (N,), swing (N, 2), `viewer` (N,) 1 for the reference."""
        x = self.numbers(features.numbers(view))
        x += self.kind[kind] + self.category[category + 1] + self.viewer[viewer]
        dense.add_product(swing, *self.swing, x)
        x = self.fold(gated(x))
        x[rooms.at] += self.type[rooms.type] + self.facts(rooms.facts)
        return x


class Head:
    """One attribute: logits of its bins, and of being that of a token in one of some ways."""

    def __init__(self, tensors: Tensors, name: str, key: int) -> None:
        self.norm, self.before = norm(tensors, f"{name}.before.0"), linear(tensors, f"{name}.before.1")
        self.bins, self.own = linear(tensors, f"{name}.bins"), tensors[f"{name}.own.weight"]
        self.ways = 0
        if f"{name}.meets.weight" in tensors:
            self.meets = linear(tensors, f"{name}.meets")
        if f"{name}.point.weight" in tensors:
            self.point, self.copying = linear(tensors, f"{name}.point"), linear(tensors, f"{name}.copying")
            self.share = float(tensors[f"{name}.share"][0])
            # Divided here instead of every score.
            self.point = Linear(*(part / np.float32(key**0.5) for part in self.point))
            self.ways = len(self.point.bias) // key

    def hidden(self, state: Floats) -> Floats:
        """What everything is said from, (R, W)."""
        return gated(self.before(self.norm(state)))

    def counts(self, hidden: Floats) -> Floats:
        """How much what is met counts, (R, meets)."""
        return self.meets(hidden) * np.float32(METRES)

    def __call__(self, state: Floats) -> Floats:
        """Logits of bins (R, bins)."""
        return self.bins(self.hidden(state))


class Places:
    """Both encoders and all heads."""

    def __init__(self, tensors: Tensors, shape: Shape) -> None:
        self.shape = shape
        self.scene_tokens, self.frame_tokens = Tokens(tensors, "scene_tokens"), Tokens(tensors, "frame_tokens")
        self.scene = [layer(tensors, f"scene.{k}", shape.heads) for k in range(shape.scene_layers)]
        self.frame = [layer(tensors, f"frame.{k}", shape.heads) for k in range(shape.frame_layers)]
        self.ask, self.place = tensors["ask.weight"], tensors["place.weight"]
        self.left = Linear(tensors["left.weight"] / np.float32(3), np.zeros(shape.width, np.float32))
        self.next_norm, self.next_ = norm(tensors, "next.0"), linear(tensors, "next.1")
        self.refer_norm, self.refer_up = norm(tensors, "refer.0"), linear(tensors, "refer.1")
        self.refer_down = linear(tensors, "refer.3")
        self.referred_norm, self.referred = norm(tensors, "referred.0"), linear(tensors, "referred.1")
        self.taken, self.fits = linear(tensors, "taken"), linear(tensors, "fits")
        self.relation_up, self.relation_down = linear(tensors, "relation.0"), linear(tensors, "relation.2")
        self.asks, self.tells = linear(tensors, "asks"), linear(tensors, "tells")
        self.normed, self.same = norm(tensors, "normed"), tensors["same"]
        self.heads = heads = {name: Head(tensors, name, shape.key) for name in (*POINTING, "heading", "side", "gap")}
        self.heading, self.side, self.gap = heads["heading"], heads["side"], heads["gap"]
        self.low, self.along, self.across = heads["low"], heads["along"], heads["across"]
        self.of_size = [heads[f"sizes.{k}"] for k in range(3)]
        keys = [linear(tensors, f"{name}.keys") for name in POINTING]
        self.all_keys = Linear(*(np.ascontiguousarray(np.concatenate(part, -1)) for part in zip(*keys, strict=True)))
        self.which_keys = {id(heads[name]): k for k, name in enumerate(POINTING)}

    def bag(self, left: Floats) -> Floats:
        """What is still to come, counts (B, C), as vectors (B, W)."""
        return self.left(left)

    def look(self, rooms: Sequence[Memory], x: Floats, asking: bool = True) -> Floats:
        """The scene encoder: of each room the tokens that are new (embedded), and then who is asking, (N, W). What the
        rooms remember is filled in; the new tokens themselves, and who is asking, (N, W)."""
        ends = np.cumsum([room.fresh + asking for room in rooms]).tolist()
        w = self.shape.width
        for k, one in enumerate(self.scene):
            mixed, seen, at = one.mixed(one.before(x)), np.empty_like(x), 0
            for room, end in zip(rooms, ends, strict=True):
                there = room.n + end - at
                room.keys[k, room.n : there], room.values[k, room.n : there] = mixed[at:end, w : 2 * w], mixed[
                    at:end, 2 * w :]
                dense.attend(mixed[at:end], room.keys[k, :there], room.values[k, :there], room.n, asking, one.heads,
                             seen[at:end])
                at = end
            one.rest(x, seen)
        return x

    def next(self, asking: Floats) -> Floats:
        """Logits (B, C) of the next category."""
        return self.next_(self.next_norm(asking))

    def known(self, tokens: Floats) -> tuple[Floats, Floats]:
        """What is asked of tokens (N, W) of the scene: (N, W) and (N, K)."""
        return self.referred(self.referred_norm(tokens)) / np.float32(self.shape.width**0.5), self.tells(tokens)

    def lies(self, relations: Floats) -> Floats:
        """What counts of how tokens lie to objects, (P, K), of numbers (P, RELATIONS)."""
        return self.relation_down(gated(self.relation_up(relations)))

    def query(self, asking: Floats, category: Ints) -> Floats:
        """What is asked of tokens that an object of a category may be described from, (B, W)."""
        return self.refer_down(gated(self.refer_up(self.refer_norm(asking + self.place[category]))))

    def view(self, x: Floats, starts: Ints) -> tuple[Floats, Floats]:
        """The frame encoder: of each frame its tokens and then who is asking, (N + R, W), from `starts` (R + 1,) on.
        The states (R, W) from which attributes are spoken, and keys (N, pointing heads * K) of the tokens."""
        for one in self.frame:
            one.within(x, starts)
        x, asking = self.normed(x), starts[1:] - 1
        return x[asking], self.all_keys(np.delete(x, asking, 0))

    def keys(self, head: Head, keys: Floats) -> Floats:
        """A head's own, (N, K)."""
        first = self.which_keys[id(head)] * self.shape.key
        return np.ascontiguousarray(keys[:, first : first + self.shape.key])


def layer(tensors: Tensors, name: str, heads: int) -> Layer:
    """A layer by its name."""
    return Layer(norm(tensors, f"{name}.before"), linear(tensors, f"{name}.mixed"), linear(tensors, f"{name}.out"),
                 norm(tensors, f"{name}.after"), linear(tensors, f"{name}.up"), linear(tensors, f"{name}.down"), heads)


class Contents:
    """Logits of the next category, the last one being the end."""

    def __init__(self, tensors: Tensors) -> None:
        self.type, self.facts = tensors["room_type.weight"], linear(tensors, "facts")
        self.so_far, self.wanted = linear(tensors, "so_far"), linear(tensors, "wanted")
        self.left = tensors["left.weight"]
        self.mix = [linear(tensors, f"mix.{k}") for k in (1, 3, 5)]

    def begun(self, type: int, facts: Floats, so_far: Floats, wanted: Floats) -> Floats:
        """What is known of a room's contents (n, W): its type and facts (FACTS,), counts that are reached so far
        (n, UP_TO * C) and that are wanted (n, (UP_TO + 1) * C)."""
        room = self.type[type] + self.facts(facts[None])[0]
        return np.asarray(self.so_far(so_far) + self.wanted(wanted) + room)

    def one_more(self, x: Floats, rows: Ints, category: Ints, so_far: Ints, wanted: Ints, up_to: int) -> None:
        """The same in rows of x (n, W), in place, when one of a category has come, counts having been so."""
        reached, asked = so_far < up_to, (wanted > 0) & (wanted <= up_to)
        x[rows[reached]] += self.so_far.weight[(category * up_to + so_far)[reached]]
        x[rows[asked]] -= self.wanted.weight[(category * (up_to + 1) + wanted)[asked]]

    def no_longer_wanted(self, x: Floats, rows: Ints, category: Ints, up_to: int) -> None:
        """The same where so many of a category as were wanted have come and more may."""
        x[rows] -= self.wanted.weight[category * (up_to + 1)]

    def following(self, x: Floats, left: Ints) -> Floats:
        """Logits (n, C + 1) of what comes next by what is known (n, W), and the rows `left` (n,) of objects to come."""
        x = x + self.left[left]
        for part in self.mix:
            x = part(gated(x))
        return x
