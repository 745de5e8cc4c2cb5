"""A denoiser that keeps to common sense about what a room holds: least, most, and never without (`sense.toml`)."""

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from schemas.base import ROOM_TYPES
from stages.categories import CATEGORIES, TABLE
from stages.layout.config import T
from stages.layout.diffusion import Denoise, Prediction
from stages.layout.features import CLASS
from stages.layout.rooms import Rooms

RULES = Path(__file__).parent / "sense.toml"
SETTLED = 0.5
"""Below this share of the schedule a slot's likeliest class means something."""
BARRED = -30.0
Logits = NDArray[np.float32]


@dataclass(frozen=True)
class Sense:
    """Rules by class index: least groups of every room type, (number, group) at most, class → companions."""

    least: tuple[tuple[tuple[int, ...], ...], ...]
    most: tuple[tuple[int, tuple[int, ...]], ...]
    needs: tuple[tuple[int, tuple[int, ...]], ...]


@cache
def sense() -> Sense:
    """The rules of `sense.toml`."""
    table = tomllib.loads(RULES.read_text())

    def indices(names: list[str]) -> tuple[int, ...]:
        return tuple(CATEGORIES.index(name) for name in names)

    return Sense(
        tuple(tuple(indices(group) for group in table["least"].get(kind, [])) for kind in ROOM_TYPES),
        tuple((int(number), indices(group)) for number, groups in table["most"].items() for group in groups),
        tuple((CATEGORIES.index(name), indices(group)) for name, group in table["needs"].items()),
    )


@cache
def at_home() -> NDArray[np.bool_]:
    """Which classes belong in a room of each type, (types, C+1); an empty slot does anywhere."""
    never = tomllib.loads(RULES.read_text())["never"]
    table = np.array(
        [[kind in TABLE[name].rooms and name not in never.get(kind, ()) for name in CATEGORIES] for kind in ROOM_TYPES]
    )
    return np.pad(table, ((0, 0), (0, 1)), constant_values=True)


def sensible(denoise: Denoise, rooms: Rooms, filled: Tensor, scale: float) -> Denoise:
    """The denoiser with classes that break a rule made unlikely; `filled` (B,) slots take part."""

    foreign = torch.from_numpy(~at_home()[rooms.type] & np.pad(rooms.wanted < 0, ((0, 0), (0, 1))))

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        made = denoise(x, t)
        logits = made.logits.masked_fill(foreign[:, None], BARRED)
        for b, kind in enumerate(rooms.type if int(t[0]) <= SETTLED * T else ()):
            settle(logits[b, : int(filled[b])].numpy(), int(kind), rooms.wanted[b])
        x0 = made.x0.clone()
        x0[..., CLASS] = logits.softmax(-1) * scale
        return Prediction(x0, logits)

    return wrapped


def settle(logits: Logits, kind: int, wanted: NDArray[np.int64]) -> None:
    """Change one room's logits (N, C+1) in place until their likeliest classes keep the rules.

    Categories that were asked for by number (`wanted` not -1) are left as they are.
    """
    if not len(logits):
        return
    for number, group in sense().most:
        _at_most(logits, [c for c in group if wanted[c] < 0], number)
    for category, companions in sense().needs:
        if wanted[category] < 0 and not np.isin(logits.argmax(-1), companions).any():
            logits[:, category] = BARRED
    taken: list[int] = []
    for group in sense().least[kind]:
        if len(taken) < len(logits) and not any(wanted[c] == 0 for c in group):
            taken.append(_one_of(logits, group, taken))


def _at_most(logits: Logits, group: list[int], number: int) -> None:
    """Bar the group from all but the `number` slots that want it most."""
    if not group:
        return
    members = np.array(group)
    wins = np.flatnonzero(np.isin(logits.argmax(-1), members))
    if len(wins) > number:
        best = logits[wins][:, members].max(-1)
        losers = wins[np.argsort(-best, kind="stable")[number:]]
        logits[np.ix_(losers, members)] = BARRED


def _one_of(logits: Logits, group: tuple[int, ...], taken: list[int]) -> int:
    """A slot that takes a class of the group, made to if none does."""
    classes = logits.argmax(-1)
    holders = [i for i in np.flatnonzero(np.isin(classes, group)) if i not in taken]
    if holders:
        return int(holders[0])
    margin = logits[:, group] - logits.max(-1, keepdims=True)
    margin[taken] = -np.inf
    slot, which = divmod(int(margin.argmax()), len(group))
    logits[slot, group[which]] = logits[slot].max() + 3.0
    return slot
