"""The two encoders of the relations model, and the heads that speak an object's attributes one after another.

`Scene` sees a room in its own frame: what is placed next, and from where it is described. `Frame` sees it anew from
that reference, where places are numbers that repeat from room to room.
"""

from dataclasses import dataclass
from typing import cast

import torch
from torch import Tensor, nn

from apartgen.stages.layout.relations import describe, features
from apartgen.stages.layout.relations.clear import FITS, MEETS, SORTS
from apartgen.stages.layout.relations.features import METRES, ROOM_FACTS, SHUT_OUT
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.tokens import N_KINDS

RELATIONS = 11
"""Numbers that say how one token lies to another."""


class Layer(nn.Module):
    """Attention and a perceptron, each after a norm."""

    def __init__(self, shape: Shape) -> None:
        super().__init__()
        w = shape.width
        self.heads, self.scale = shape.heads, (shape.heads / w) ** 0.5
        self.before, self.after = nn.LayerNorm(w), nn.LayerNorm(w)
        self.mixed, self.out = nn.Linear(w, 3 * w), nn.Linear(w, w)
        self.up, self.down = nn.Linear(w, shape.ratio * w), nn.Linear(shape.ratio * w, w)

    def forward(self, x: Tensor, mask: Tensor) -> Tensor:
        """x (B, T, W), mask (B, 1, T or 1, T) added to the scores."""
        b, t, w = x.shape
        q, k, v = self.mixed(self.before(x)).view(b, t, 3, self.heads, -1).permute(2, 0, 3, 1, 4).unbind(0)
        # Of so few tokens; torch's own attention takes most of a step for it.
        seen = (q @ (k * self.scale).transpose(-1, -2) + mask.to(q.dtype)).softmax(-1).to(v.dtype) @ v
        x = x + self.out(seen.transpose(1, 2).reshape(b, t, w))
        out: Tensor = x + self.down(nn.functional.gelu(self.up(self.after(x)), approximate="tanh"))
        return out


class Tokens(nn.Module):
    """Embeds tokens seen in some frame."""

    def __init__(self, shape: Shape, categories: int, types: int) -> None:
        super().__init__()
        w = shape.width
        self.numbers = nn.Linear(features.WIDTH, w)
        self.kind, self.category = nn.Embedding(N_KINDS, w), nn.Embedding(categories + 1, w)
        self.swing, self.viewer = nn.Linear(features.SWING, w, bias=False), nn.Embedding(2, w)
        self.room_type, self.facts = nn.Embedding(types, w), nn.Linear(ROOM_FACTS, w)
        self.fold = nn.Sequential(nn.GELU(approximate="tanh"), nn.Linear(w, w))

    def forward(self, seen: "Seen") -> Tensor:
        """(B, T, W)."""
        x = self.numbers(seen.numbers) + self.kind(seen.kind) + self.category(seen.category + 1)
        x = x + self.swing(seen.swing) + self.viewer(seen.viewer)
        x = self.fold(x)
        room = self.room_type(seen.type) + self.facts(seen.facts)
        return torch.cat([x[:, :1] + room[:, None], x[:, 1:]], 1)


@dataclass
class Seen:
    """Tokens in a frame: numbers (B, T, F), kind, category (B, T) -1 for the shell, swing (B, T, 2), viewer (B, T) 1
    for the reference, real (B, T); the room's type (B,) and facts (B, 3)."""

    numbers: Tensor
    kind: Tensor
    category: Tensor
    swing: Tensor
    viewer: Tensor
    real: Tensor
    type: Tensor
    facts: Tensor


@dataclass
class Known:
    """What is known of tokens before a reference is chosen: `alike` (B, Q, T), how near others of the category asked
    for are to each; `relations` (B, J, T, RELATIONS), how each lies to each; `there` (B, Q, J), objects that stand."""

    alike: Tensor
    relations: Tensor
    there: Tensor
    lacks: Tensor


class Head(nn.Module):
    """One attribute: logits of its bins, and of being that of a token in one of some ways, of which the value's own bin
    tells part."""

    def __init__(self, shape: Shape, bins: int, ways: int = 0, meets: int = 0) -> None:
        super().__init__()
        w = shape.width
        self.ways, self.key_width = ways, shape.key
        self.before = nn.Sequential(nn.LayerNorm(w), nn.Linear(w, w), nn.GELU(approximate="tanh"))
        self.bins = nn.Linear(w, bins)
        self.own = nn.Embedding(bins, w)
        if ways:
            self.point, self.keys = nn.Linear(w, ways * shape.key), nn.Linear(w, shape.key)
            self.share = nn.Parameter(torch.full((1,), 0.3))
            self.copying = nn.Linear(w, 1)
        self.meets = nn.Linear(w, meets) if meets else None

    def forward(self, state: Tensor, keys: Tensor | None = None, at: Tensor | None = None,
                depths: Tensor | None = None) -> tuple[Tensor, Tensor]:
        """Logits of bins (R, bins) and of pointers (R, T, ways) for states (R, W), `keys` of tokens (R, T, K), the bins
        `at` (R, T, ways) of what they point at, and `depths` (R, bins, meets) of what would be met there."""
        hidden = self.before(state)
        bins = self.bins(hidden).float()
        if self.meets is not None and depths is not None:
            met = (depths @ self.meets(hidden).float()[..., None])[..., 0] * METRES
            bins = bins + met
        if not self.ways or keys is None or at is None:
            return bins, bins.new_zeros(len(bins), 0, 0)
        query = self.point(hidden).view(len(state), self.ways, self.key_width)
        points = torch.einsum("rak,rtk->rta", query, keys).float() / self.key_width**0.5
        likely = (self.share * bins).gather(1, at.flatten(1)).view_as(at)
        if self.meets is not None and depths is not None:
            likely = likely + met.gather(1, at.flatten(1)).view_as(at)
        return bins, points + likely + self.copying(hidden).float()[..., None]


class Relations(nn.Module):
    """Both encoders and all heads. `categories` and `types` are how many the weights know."""

    def __init__(self, shape: Shape, categories: int, types: int) -> None:
        super().__init__()
        w = shape.width
        self.shape = shape
        self.scene_tokens, self.frame_tokens = Tokens(shape, categories, types), Tokens(shape, categories, types)
        self.scene = nn.ModuleList(Layer(shape) for _ in range(shape.scene_layers))
        self.frame = nn.ModuleList(Layer(shape) for _ in range(shape.frame_layers))
        self.ask, self.left, self.place = nn.Embedding(categories, w), nn.Embedding(categories, w), nn.Embedding(
            categories, w)
        self.next = nn.Sequential(nn.LayerNorm(w), nn.Linear(w, categories))
        self.refer = nn.Sequential(nn.LayerNorm(w), nn.Linear(w, w), nn.GELU(approximate="tanh"), nn.Linear(w, w))
        self.referred = nn.Sequential(nn.LayerNorm(w), nn.Linear(w, w))
        self.taken, self.fits = nn.Linear(w, 1), nn.Linear(w, FITS)
        self.relation = nn.Sequential(nn.Linear(RELATIONS, 2 * shape.key), nn.GELU(approximate="tanh"), nn.Linear(
            2 * shape.key, shape.key))
        self.asks, self.tells = nn.Linear(w, shape.key), nn.Linear(w, shape.key)
        nn.init.zeros_(self.tells.weight)
        nn.init.zeros_(self.tells.bias)
        self.normed = nn.LayerNorm(w)
        self.heading = Head(shape, describe.HEADINGS)
        self.sizes = nn.ModuleList(Head(shape, describe.SIZES, 1) for _ in range(3))
        self.same = nn.Parameter(torch.zeros(3))
        self.side = Head(shape, describe.SIDES, meets=SORTS)
        self.low = Head(shape, describe.LEVELS, describe.LEVELLINGS)
        self.gap = Head(shape, len(describe.GAPS))
        self.along = Head(shape, describe.OFFSETS, describe.ALIGNMENTS, meets=MEETS)
        self.across = Head(shape, describe.OFFSETS, describe.ALIGNMENTS, meets=MEETS)

    @property
    def of_size(self) -> list[Head]:
        """The heads of depth, width and height."""
        return [cast(Head, head) for head in self.sizes]

    def bag(self, left: Tensor) -> Tensor:
        """What is still to come, counts (B, C), as a vector (B, W)."""
        return left.to(self.left.weight.dtype) @ self.left.weight / 3

    def look(self, seen: Seen, asking: Tensor, mask: Tensor) -> tuple[Tensor, Tensor]:
        """The scene encoder: tokens (B, T, W) and hidden states of asking ones (B, Q, W); mask (B, T + Q, T + Q) tells
        what may attend to what."""
        x = torch.cat([self.scene_tokens(seen), asking], 1)
        bias = x.new_zeros(mask.shape).masked_fill(~mask, SHUT_OUT)[:, None]
        for layer in self.scene:
            x = layer(x, bias)
        return x[:, : seen.kind.shape[1]], x[:, seen.kind.shape[1] :]

    def reference(self, asking: Tensor, category: Tensor, tokens: Tensor, known: "Known") -> Tensor:
        """Logits (B, Q, T) of the tokens that objects (B, Q) of a category may be described from."""
        query = self.refer(asking + self.place(category))
        found: Tensor = (query @ self.referred(tokens).transpose(-1, -2)).float() / self.shape.width**0.5
        share = self.asks(query)[:, :, None] * self.tells(tokens)[:, None] * known.there[..., None]
        related = torch.einsum("bqjh,bjth->bqt", share, self.relation(known.relations)).float()
        lacking = (known.lacks @ self.fits(query).float()[..., None])[..., 0] * METRES
        total: Tensor = found + self.taken(query).float() * known.alike + related + lacking
        return total

    def view(self, seen: Seen, category: Tensor, left: Tensor) -> tuple[Tensor, Tensor]:
        """The frame encoder: the state (B, W) from which an object's attributes are spoken, and tokens (B, T, W)."""
        asking = self.ask(category) + self.bag(left)
        x = torch.cat([self.frame_tokens(seen), asking[:, None]], 1)
        real = nn.functional.pad(seen.real, (0, 1), value=True)
        bias = x.new_zeros(real.shape).masked_fill(~real, SHUT_OUT)[:, None, None]
        for layer in self.frame:
            x = layer(x, bias)
        x = self.normed(x)
        return x[:, -1], x[:, :-1]
