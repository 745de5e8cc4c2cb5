"""Training batches: rooms of one object count and about as many sides, the same after a resumed run."""

from itertools import islice

import numpy as np
from rooms_for_tests import some_rooms

from apartgen.stages.layout.config import N_MAX, TrainConfig
from apartgen.stages.layout.corpus import Corpus
from apartgen.stages.layout.train import TOKEN_BINS, indices


def corpus(n: int = 60) -> Corpus:
    rooms, rng = some_rooms(n), np.random.default_rng(0)
    more = rng.integers(1, 15, n)
    for i, k in enumerate(more):
        rooms.openings[i, 2 : 2 + k] = rooms.openings[i, 1]
    category = np.where(np.arange(N_MAX)[None] < rng.integers(3, 9, n)[:, None], 1, -1)
    zeros = np.zeros((n, N_MAX, 3), np.float32)
    return Corpus(rooms, category, zeros, zeros, zeros[..., 0], np.zeros(n, np.int64))


def test_batches_hold_rooms_alike_and_repeat() -> None:
    found, config = corpus(), TrainConfig(steps=60, batch=16, slots_share=0.3)
    batches = list(indices(found, config, 0))
    for index, slots, _ in batches:
        assert len(np.unique(np.digitize(found.rooms.tokens[index], TOKEN_BINS))) == 1
        assert slots == N_MAX or (found.count[index] == slots).all()
    assert 6 <= sum(slots == N_MAX for _, slots, _ in batches) <= 32
    resumed = list(islice(indices(found, config, 40), 20))
    for (a, n, _), (b, m, _) in zip(batches[40:], resumed, strict=True):
        assert n == m and (a == b).all()


def test_every_room_is_drawn_about_equally() -> None:
    found, config = corpus(), TrainConfig(steps=1500, batch=12, slots_share=0.2)
    drawn = np.zeros(60)
    for index, _, _ in indices(found, config, 0):
        np.add.at(drawn, index, 1 / len(index))
    assert drawn.min() > 0 and drawn.max() < 4 * drawn.mean()
