"""The bias on class logits: what it adds by hand-made counts, and that it brings a skewed network back."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.layout import calibration, weights
from apartgen.stages.layout.corpus import Corpus, read_corpus
from apartgen.stages.layout.datasets import _arrays, single_rooms
from apartgen.stages.layout.features import CLASS
from apartgen.stages.layout.network import Denoiser
from apartgen.stages.things.categories import CATEGORIES

SHAPE = (len(ROOM_TYPES), len(CATEGORIES))
PLANT = CATEGORIES.index("plant")


def test_classes_drawn_half_as_often_gain_what_others_lose() -> None:
    wanted, drawn = np.zeros(SHAPE), np.zeros(SHAPE)
    wanted[2, [4, 7]], drawn[2, [4, 7]] = (998, 998), (498, 1498)
    change = calibration.step(wanted, drawn)
    assert change[2, 4] - change[2, 7] == pytest.approx(np.log(2) + np.log(1.5))
    assert (wanted * change).sum() == pytest.approx(0, abs=1e-9), "beside the empty class nothing moves on average"
    assert not change[[k for k in range(len(ROOM_TYPES)) if k != 2]].any(), "room types without rooms stay as they are"


def test_a_class_drawn_where_none_belongs_sinks_by_a_bounded_step() -> None:
    wanted, drawn = np.zeros(SHAPE), np.zeros(SHAPE)
    wanted[0, 1], drawn[0, [1, 5]] = 1e4, (1e4, 1e6)
    change = calibration.step(wanted, drawn)
    assert change[0, 5] == pytest.approx(-calibration.MOST) and change[0, 1] == pytest.approx(0)


def test_counts_leave_out_empty_slots() -> None:
    found = calibration.counts(np.array([3, 3, 0]), np.array([[5, 5, -1], [5, 2, -1], [-1, -1, 2]]))
    assert found[3, 5] == 3 and found[3, 2] == 1 and found[0, 2] == 1 and found.sum() == 5


@pytest.mark.wide
def test_a_network_that_loves_plants_is_brought_back(corpus: Corpus) -> None:
    network = Denoiser(weights.load()[0].config)
    network.load_state_dict(weights.load()[0].state_dict())
    network.eval().requires_grad_(False).bias.zero_()
    network.output.bias[CLASS][PLANT] += 1.5
    skewed = _plants(network, corpus)
    calibration.calibrate(network, corpus, len(corpus), seed=0)
    wanted = (corpus.category == PLANT).sum()
    # What finds no place may still become a plant, so the bias is looked at, not what stands in the end.
    assert skewed > 2 * wanted and (network.bias[:, PLANT] < -0.4).sum() >= len(ROOM_TYPES) // 2
    assert not network.bias[:, -1].any(), "empty slots have none"


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Corpus:
    path: Path = tmp_path_factory.mktemp("corpus") / "c.npz"
    _arrays.write_corpus(path, [(home, 1) for home in single_rooms.homes(None, seed=3, rooms=12)])
    return read_corpus(path)


def _plants(network: Denoiser, corpus: Corpus) -> float:
    rooms = replace(corpus.rooms, count=corpus.count)
    return float(calibration.furnished(network, rooms, np.random.default_rng(5).spawn(len(rooms)))[:, PLANT].sum())


def test_training_starts_from_no_bias_and_sampling_heeds_it() -> None:
    network, _ = weights.load()
    fresh = Denoiser(network.config)
    assert not fresh.bias.any() and "bias" in fresh.state_dict() and not fresh.bias.requires_grad
    assert torch.isfinite(network.bias).all() and network.bias[:, :-1].any(), "the shipped weights are calibrated"
