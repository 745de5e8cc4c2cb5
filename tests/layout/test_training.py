"""Training: resumed as if never interrupted, all on one device, and settings that cannot work named."""

from pathlib import Path

import numpy as np
import pytest
import torch

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.layout import precision, train, weights
from apartgen.stages.layout.config import ModelConfig, TrainConfig
from apartgen.stages.layout.corpus import batch, read_corpus, shape_latents
from apartgen.stages.layout.datasets import _arrays, single_rooms
from apartgen.stages.layout.network import Denoiser

TINY = ModelConfig(width=48, layers=2, heads=4, encoder_layers=1)


@pytest.fixture(scope="module")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path: Path = tmp_path_factory.mktemp("corpus") / "c.npz"
    _arrays.write_corpus(path, [(home, 1) for home in single_rooms.homes(None, seed=4, rooms=12)])
    return path


def settings(corpus: Path, **given: object) -> TrainConfig:
    return TrainConfig(
        corpus=str(corpus), model=TINY, steps=6, batch=8, warmup=2, save_every=2, calibrate=0, device="cpu"
    ).model_copy(update=given)


class Stopped(Exception):
    """Stands for an interruption."""


def stop_at(last: int) -> train.Report:
    def report(step: int, _: float) -> None:
        if step == last:
            raise Stopped

    return report


def test_an_interrupted_run_ends_in_the_weights_of_an_unbroken_one(corpus: Path, tmp_path: Path) -> None:
    whole, broken = tmp_path / "whole.safetensors", tmp_path / "broken.safetensors"
    record = train.train(settings(corpus), whole)
    with pytest.raises(Stopped):
        train.train(settings(corpus), broken, report=stop_at(5))
    assert train.train(settings(corpus, save_every=3), broken)["step"] == record["step"] == 6
    for name, value in weights.tensors(whole)[0].items():
        assert torch.equal(value, weights.tensors(broken)[0][name]), name
    before = Denoiser(TINY).state_dict()
    assert any(not torch.equal(before[name].half().float(), value) for name, value in weights.tensors(whole)[0].items())


def test_a_checkpoint_of_other_settings_is_named_and_left_alone(corpus: Path, tmp_path: Path) -> None:
    out = tmp_path / "w.safetensors"
    train.train(settings(corpus), out)
    left = out.with_suffix(".checkpoint").read_bytes()
    with pytest.raises(BadInput, match=r"w\.checkpoint.*another lr, seed.*--fresh"):
        train.train(settings(corpus, lr=1e-3, seed=1), out)
    out.with_suffix(".checkpoint").write_bytes(left[:1000])
    with pytest.raises(BadInput, match=r"w\.checkpoint.*--fresh"):
        train.train(settings(corpus), out)
    assert train.train(settings(corpus, lr=1e-3), out, resume=False)["step"] == 6


def test_a_run_that_diverges_ends_and_leaves_the_last_checkpoint(
    corpus: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, losses = tmp_path / "w.safetensors", iter([3.0, 2.0, 1.0, float("nan")])
    monkeypatch.setattr(train, "train_step", lambda *_: next(losses))
    with pytest.raises(Unmet, match=r"step 4 is not finite.*--lr"):
        train.train(settings(corpus), out)
    state = torch.load(out.with_suffix(".checkpoint"), weights_only=True)
    assert state["record"]["step"] == 2 and all(v.isfinite().all() for v in weights.tensors(out)[0].values())


def test_a_step_whose_gradient_is_not_finite_says_so(corpus: Path) -> None:
    found, network = read_corpus(corpus), Denoiser(TINY)
    next(network.parameters()).register_hook(lambda grad: grad * torch.inf)
    optimizer = torch.optim.AdamW(network.parameters())
    rng = np.random.default_rng(0)
    loss = train.train_step(network, optimizer, found, np.arange(4), 5, rng, shape_latents(), settings(corpus), 1e-4)
    assert np.isnan(loss)


def test_the_curve_lies_beside_the_weights(corpus: Path, tmp_path: Path) -> None:
    train.train(settings(corpus), tmp_path / "w.safetensors")
    assert (tmp_path / "w.png").read_bytes().startswith(b"\x89PNG")
    assert {file.suffix for file in tmp_path.iterdir()} == {".safetensors", ".checkpoint", ".png"}


@pytest.mark.skipif(torch.cuda.is_available(), reason="there is a GPU")
def test_a_gpu_that_is_not_there_is_named(corpus: Path, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="--device cuda: torch finds no GPU"):
        train.train(settings(corpus, device="cuda"), tmp_path / "w.safetensors")
    assert train.device_of(settings(corpus, device="auto")).type == "cpu" and not list(tmp_path.iterdir())


@pytest.mark.parametrize("slots", [5, 24])
def test_every_tensor_of_a_step_is_on_the_networks_device(corpus: Path, slots: int) -> None:
    """The meta device has shapes and no values, and its tensors refuse to meet others: no GPU is needed."""
    found, rng = read_corpus(corpus), np.random.default_rng(0)
    objects, rooms = batch(found, np.arange(4), slots, rng, shape_latents(), settings(corpus))
    assert objects.category.shape == (4, slots)
    network = Denoiser(TINY).to("meta")
    loss = train.step_loss(network, objects, rooms, rng, settings(corpus))
    loss.backward()
    assert loss.is_meta and all(p.grad is not None and p.grad.is_meta for p in network.blocks.parameters())


def test_bfloat16_is_computed_in_only_where_the_processor_has_it() -> None:
    cpuinfo = Path("/proc/cpuinfo")
    if not cpuinfo.exists():
        pytest.skip("says what a processor can under Linux")
    flags = set(next((line for line in cpuinfo.read_text().splitlines() if line.startswith("flags")), "").split())

    def computed(wanted: bool) -> torch.dtype:
        with precision.autocast("cpu", wanted):
            return (torch.ones(2, 2) @ torch.ones(2, 2)).dtype

    assert computed(False) == torch.float32
    if {"avx512_bf16", "amx_bf16"} & flags:
        assert computed(True) == torch.bfloat16
    elif not any(flag.startswith("avx512") or flag == "avx_ne_convert" for flag in flags):
        assert computed(True) == torch.float32
