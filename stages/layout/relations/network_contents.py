"""The network that says what a room holds, as it is trained."""

from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from apartgen.stages.layout.config import N_MAX
from apartgen.stages.layout.relations.contents import FACTS, UNKNOWN, UP_TO
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.tokens import Ints

ASKED, SILENT, COUNTED = 0.6, 0.5, 0.4
"""While training: share of categories that may be told, of rooms that tell none, of rooms that tell their count."""


class Contents(nn.Module):
    """Logits of the next category, the last one being the end."""

    def __init__(self, shape: Shape, categories: int, types: int) -> None:
        super().__init__()
        w = shape.width
        self.room_type, self.facts = nn.Embedding(types, w), nn.Linear(FACTS, w)
        self.so_far, self.wanted = nn.Linear(UP_TO * categories, w), nn.Linear((UP_TO + 1) * categories, w)
        self.left = nn.Embedding(N_MAX + 2, w)
        self.mix = nn.Sequential(
            nn.GELU(approximate="tanh"), nn.Linear(w, 2 * w), nn.GELU(approximate="tanh"), nn.Linear(2 * w, w),
            nn.GELU(approximate="tanh"), nn.Linear(w, categories + 1))

    def forward(self, type: Tensor, facts: Tensor, so_far: Tensor, left: Tensor, wanted: Tensor) -> Tensor:
        """Logits (..., C + 1): room types (...,), facts (..., FACTS), counts so far (..., C), objects left (...,) or
        -1, counts still wanted (..., C) or -1."""
        x = self.room_type(type) + self.facts(facts)
        x = x + self.so_far(reached(so_far, 1)) + self.wanted(reached(wanted, 0))
        found: Tensor = self.mix(x + self.left(torch.where(left < 0, N_MAX + 1, left.clamp_max(N_MAX))))
        return found.float()


def reached(counts: Tensor, least: int) -> Tensor:
    """Which of `least` … UP_TO counts (..., C) reach, (..., (UP_TO + 1 - least) * C)."""
    steps = torch.arange(least, UP_TO + 1, dtype=counts.dtype, device=counts.device)
    return (counts[..., None] >= steps).float().flatten(-2)


@dataclass
class Listed:
    """What is asked of lists of contents, a step each of n: room types, facts (n, FACTS), counts so far (n, C), objects
    left or -1, counts still wanted (n, C) or -1, and what comes next, C for the end."""

    type: Tensor
    facts: Tensor
    so_far: Tensor
    left: Tensor
    wanted: Tensor
    next: Tensor


def listed(rooms: "list[tuple[int, NDArray[np.float32], Ints]]", rank: Ints, rng: np.random.Generator) -> Listed:
    """What is asked of rooms (type, facts, counts by category), of which some do not tell how many objects they hold,
    and most not which."""
    order = np.argsort(rank)
    c = len(rank)
    kinds, told, so_fars, lefts, wants, nexts = [], [], [], [], [], []
    for type, room, counts in rooms:
        drawn = np.repeat(order, counts[order])
        n = len(drawn)
        steps = np.zeros((n + 1, c), np.int64)
        steps[np.arange(1, n + 1), drawn] = 1
        so_far = steps.cumsum(0)
        asked = (rng.random(c) < rng.random() * ASKED) & ((counts > 0) | (rng.random(c) < 0.05))
        if rng.random() < SILENT:
            asked[:] = False
        lefts.append(n - np.arange(n + 1) if rng.random() < COUNTED else np.full(n + 1, UNKNOWN))
        wants.append(np.where(asked, counts - so_far, UNKNOWN))
        kinds.append(np.full(n + 1, type))
        told.append(np.broadcast_to(room, (n + 1, FACTS)))
        so_fars.append(so_far)
        nexts.append(np.append(drawn, c))
    type_, facts_, so_far_, left_, wanted_, next_ = (
        torch.from_numpy(np.concatenate(part)) for part in (kinds, told, so_fars, lefts, wants, nexts))
    return Listed(type_, facts_, so_far_.float(), left_, wanted_.float(), next_)


def loss(network: Contents, of: Listed) -> Tensor:
    """Mean cross-entropy of what comes next."""
    logits = network(of.type, of.facts, of.so_far, of.left, of.wanted)
    return torch.nn.functional.cross_entropy(logits, of.next)
