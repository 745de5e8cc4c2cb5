"""Rooms held out are looked at and not learned from; weights say what they started from."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from apartgen.schemas.errors import BadInput
from apartgen.stages.layout.datasets import single_rooms
from apartgen.stages.layout.datasets._arrays import write_corpus
from apartgen.stages.layout.relations import corpus, train, weights
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.shape import Shape

SMALL = Shape(width=32, heads=2, scene_layers=1, frame_layers=1, key=8)


@pytest.fixture(scope="module")
def rooms(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("corpus") / "corpus.npz"
    write_corpus(path, ((home, 0) for home in single_rooms.homes(None, rooms=10)))
    return path


def settings(rooms: Path, **more: int | str) -> Training:
    own = {"corpus": str(rooms), "steps": 4, "save_every": 2, "batch": 4, "shape": SMALL}
    return Training.model_validate(own | more)


def test_the_last_rooms_are_never_learned_from(rooms: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen, chosen = [], train.chosen

    def told(*given: Any) -> Any:
        some, rng = chosen(*given)
        seen.extend(some)
        return some, rng

    monkeypatch.setattr(train, "chosen", told)
    record = train.train(settings(rooms, held=4), tmp_path / "w.safetensors")
    every = [room for room in corpus.read(rooms) if room.n]
    learned = {room.boxes.tobytes() for room in seen}
    assert learned and learned <= {room.boxes.tobytes() for room in every[:-4]}
    assert [len(row) for row in record["losses"]] == [3, 3] and np.isfinite(record["losses"]).all()


@pytest.mark.parametrize("held, loss", [(1, 1.0), (4, 4.0), (5, (4 * 4 + 1 * 1) / 5)])
def test_every_room_held_out_is_looked_at_once_and_counts_alike(
    held: int, loss: float, rooms: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four at a time, where each of a step loses as much as there are in it."""
    some, looked = [room for room in corpus.read(rooms) if room.n][:held], []
    monkeypatch.setattr(train, "asked", lambda batch, *_: looked.extend(batch) or batch)
    monkeypatch.setattr(train, "step_losses", lambda model, batch, device: {"it": torch.tensor(float(len(batch)))})
    assert train._looked_at(torch.nn.Linear(1, 1), some, settings(rooms)) == [loss]
    assert sorted(map(id, looked)) == sorted(map(id, some))


def test_without_any_the_record_has_one_loss(rooms: Path, tmp_path: Path) -> None:
    record = train.train(settings(rooms), tmp_path / "w.safetensors")
    assert [len(row) for row in record["losses"]] == [2, 2]


def test_all_cannot_be_held_out(rooms: Path, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="--held 99.*hold fewer"):
        train.train(settings(rooms, held=99), tmp_path / "w.safetensors")


def test_weights_say_what_they_started_from_but_not_where_it_lay(rooms: Path, tmp_path: Path) -> None:
    first, second = tmp_path / "first.safetensors", tmp_path / "second.safetensors"
    train.train(settings(rooms), first)
    train.train(settings(rooms, start=str(first), steps=2), second)
    _, _, record = weights.load(second)
    assert record["step"] == 2 and record["start"]["step"] == 4 and record["start"]["corpus"] == record["corpus"]
    assert record["start"]["weights"] == train.digest(str(first))
    assert str(tmp_path) not in second.read_bytes().decode("latin1")


def test_whoever_prepares_the_steps_they_are_the_same(rooms: Path, tmp_path: Path) -> None:
    alone, helped = tmp_path / "alone.safetensors", tmp_path / "helped.safetensors"
    train.train(settings(rooms), alone)
    train.train(settings(rooms, workers=2), helped)
    one, other = weights.load(alone)[2], weights.load(helped)[2]
    assert one == other and one["step"] == 4
