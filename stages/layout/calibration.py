"""A bias on the class logits, so that furnished rooms hold every class as often as the corpus' rooms do.

Training fits each class at each noise level; rules, guidance and the projection, which has small things stand in for
what finds no place, shift what is there in the end. The bias takes that back: rooms of the corpus are furnished as by
default, their classes counted, and the log ratio of wanted to found is added, room type by room type.
"""

import logging
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.layout import furnish
from apartgen.stages.layout.batch import placed, spreading
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.corpus import Corpus
from apartgen.stages.layout.network import Denoiser
from apartgen.stages.layout.rooms import Rooms
from apartgen.stages.things.categories import CATEGORIES

log = logging.getLogger("apartgen")
GAINS = (0.8, 0.8, 0.5, 0.4, 0.3)
"""Share of the log ratio that each round adds: less and less, as its rooms are other ones and counts are few."""
SPREAD = 2.0
"""Added to every count before the ratio is taken."""
MOST = 1.2
"""Longest change of a bias in one round, in units of logits."""
Counts = NDArray[np.float64]


def calibrate(
    network: Denoiser,
    corpus: Corpus,
    rooms: int,
    seed: int,
    report: Callable[[int], None] | None = None,
    threads: int = 1,
) -> list[float]:
    """Set `network.bias` from so many rooms of the corpus a round; returns the rounds' KL divergences of classes."""
    rng, found = np.random.default_rng([seed, len(GAINS)]), []
    network.bias.zero_()
    for done, gain in enumerate(GAINS, 1):
        index = rng.choice(np.flatnonzero(corpus.count > 0), size=rooms, replace=rooms > (corpus.count > 0).sum())
        chosen = replace(corpus.rooms[index], count=corpus.count[index])
        wanted = counts(chosen.type, corpus.category[index])
        made = furnished(network, chosen, rng.spawn(rooms), threads)
        network.bias[:, :-1] += network.bias.new_tensor(gain * step(wanted, made))
        found.append(divergence(wanted.sum(0), made.sum(0)))
        if report:
            report(done)
        log.info("calibration: KL divergence of classes %.4f", found[-1])
    return found


def furnished(network: Denoiser, rooms: Rooms, lanes: list[np.random.Generator], threads: int = 1) -> Counts:
    """Counts (types, C) of the classes in rooms furnished as by default; the same on any number of cores."""
    out = np.zeros((len(ROOM_TYPES), len(CATEGORIES)))
    with spreading(threads) as spread:
        config = LayoutConfig(model="diffusion")
        made = placed(network, rooms, config, lanes, lambda _, *row: furnish.task(*row), spread)
        for i, settled, _ in made:
            np.add.at(out[rooms.type[i]], [CATEGORIES.index(item.category) for item in settled.items], 1)
    return out


def step(wanted: Counts, drawn: Counts) -> Counts:
    """What the bias lacks by counts (types, C): the log ratio, 0 on average over what is wanted in a room type.

    A type that was not seen is left alone. The mean is taken off because empty slots have no bias.
    """
    change = np.log((wanted + SPREAD) / (drawn + SPREAD)).clip(-MOST, MOST)
    total = wanted.sum(1, keepdims=True)
    change -= (wanted * change).sum(1, keepdims=True) / np.maximum(total, 1)
    return np.where(total > 0, change, 0.0)


def counts(kinds: NDArray[np.int64], category: NDArray[np.int64]) -> Counts:
    """How many objects (n, N), -1 where there is none, rooms of each type have of each class, (types, C)."""
    row, slot = np.nonzero(category >= 0)
    out = np.zeros((len(ROOM_TYPES), len(CATEGORIES)))
    np.add.at(out, (kinds[row], category[row, slot]), 1)
    return out


def divergence(wanted: Counts, drawn: Counts) -> float:
    """KL(wanted, drawn) of class counts (C,)."""
    p, q = (np.maximum(n / n.sum(), 1e-6) for n in (wanted, drawn))
    return float((p * np.log(p / q)).sum())
