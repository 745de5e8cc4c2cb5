"""The process, its samplers, and the network's symmetries."""

import numpy as np
import pytest
import torch
from rooms_for_tests import some_rooms

from apartgen.stages.layout import diffusion, samplers
from apartgen.stages.layout.config import ModelConfig, T
from apartgen.stages.layout.diffusion import Prediction
from apartgen.stages.layout.features import CLASS, DIM, EMPTY, N_CLASSES, Objects, decode, encode
from apartgen.stages.layout.network import Denoiser
from apartgen.stages.layout.schedule import ALPHA_BAR

TINY = ModelConfig(width=48, layers=2, heads=4, encoder_layers=1)


def network() -> Denoiser:
    torch.manual_seed(0)
    made = Denoiser(TINY).eval()
    torch.nn.init.normal_(made.output.weight, std=0.2)
    return made


def test_encoding_round_trip() -> None:
    rng = np.random.default_rng(0)
    objects = Objects(
        torch.from_numpy(rng.uniform(-2, 2, (3, 7, 3))).float(),
        torch.from_numpy(rng.uniform(0.05, 2, (3, 7, 3))).float(),
        torch.from_numpy(rng.uniform(-3, 3, (3, 7))).float(),
        torch.from_numpy(rng.integers(EMPTY, size=(3, 7))),
        torch.from_numpy(rng.normal(size=(3, 7, 32))).float(),
    )
    again = decode(encode(objects, TINY), TINY)
    for name in ("center", "size", "yaw", "category", "latent"):
        torch.testing.assert_close(getattr(again, name), getattr(objects, name), atol=1e-4, rtol=1e-4)


def test_network_is_permutation_equivariant() -> None:
    made, rooms = network(), some_rooms(2)
    x, order = torch.randn(2, 9, DIM), torch.randperm(9)
    with torch.no_grad():
        room = made.encoder(rooms, False)
        straight = made(x, torch.tensor([0.3, 0.7]), room)
        shuffled = made(x[:, order], torch.tensor([0.3, 0.7]), room)
    torch.testing.assert_close(straight[:, order], shuffled, atol=1e-4, rtol=1e-4)
    assert straight.std() > 0.01


def test_absent_objects_change_nothing() -> None:
    made, rooms = network(), some_rooms(1)
    x = torch.randn(1, 6, DIM)
    with torch.no_grad():
        alone = made(x[:, :4], torch.tensor([0.5]), made.encoder(rooms, False))
        room = made.encoder(rooms, False)
        room.present = torch.tensor([[True] * 4 + [False] * 2])
        padded = made(x, torch.tensor([0.5]), room)
    torch.testing.assert_close(alone, padded[:, :4], atol=1e-4, rtol=1e-4)


def test_class_prediction_is_bayes_optimal_without_a_network() -> None:
    """With a silent network the predicted one-hot is the posterior mean of uniform classes."""
    t = torch.tensor([300])
    alpha, sigma = diffusion.coefficients(t)
    onehot = torch.nn.functional.one_hot(torch.tensor([[5]]), N_CLASSES).float() * TINY.class_scale
    x = torch.zeros(1, 1, DIM)
    x[..., CLASS] = alpha * onehot + sigma * torch.randn(1, 1, N_CLASSES, generator=torch.Generator().manual_seed(1))
    found = diffusion.interpret(torch.zeros_like(x), x, t, TINY).x0[..., CLASS]
    each = torch.eye(N_CLASSES)[None] * TINY.class_scale
    likelihood = -((x[..., CLASS].transpose(1, 2) - (alpha * each).transpose(1, 2)) ** 2).sum(1) / (2 * sigma[0] ** 2)
    torch.testing.assert_close(found[0, 0], likelihood.softmax(-1)[0] * TINY.class_scale, atol=1e-4, rtol=1e-3)


@pytest.mark.parametrize(
    ("name", "steps"), [("ddim", 10), ("ddim", 20), ("dpm++", 10), ("dpm++", 20), ("ddpm", 100), ("ddpm", 1000)]
)
def test_samplers_reach_a_known_distribution(name: str, steps: int) -> None:
    """For Gaussian data the exact denoiser is known; samples must have the data's mean and spread."""
    mean, spread = 0.7, 0.4

    def denoise(x: torch.Tensor, t: torch.Tensor) -> Prediction:
        bar = ALPHA_BAR[t][:, None, None]
        gain = bar.sqrt() * spread**2 / (bar * spread**2 + 1 - bar)
        return Prediction(mean + gain * (x - bar.sqrt() * mean), torch.zeros(()))

    generator = torch.Generator().manual_seed(0)
    noise = lambda: torch.randn(4000, 1, 2, generator=generator)  # noqa: E731
    x = samplers.SAMPLERS[name](denoise, noise(), steps, noise)
    assert abs(x.mean() - mean) < 0.03
    assert abs(x.std() - spread) < (0.08 if steps == 10 else 0.05)


def test_thousand_steps_visit_every_t() -> None:
    assert samplers.timesteps(T) == list(range(T, -1, -1))
    for steps in (1, 5, 20, 100, 999):
        path = samplers.timesteps(steps)
        assert len(path) == steps + 1 and path[0] == T and path[-1] == 0
        assert all(a > b for a, b in zip(path, path[1:], strict=False))


def test_posterior_matches_two_step_simulation() -> None:
    """q(x_s | x_t, x_0) against a Monte-Carlo regression of x_s on x_t."""
    t, s, x0 = 400, 250, 1.3
    rng = np.random.default_rng(0)
    bar_t, bar_s = float(ALPHA_BAR[t]), float(ALPHA_BAR[s])
    x_s = np.sqrt(bar_s) * x0 + np.sqrt(1 - bar_s) * rng.standard_normal(200_000)
    x_t = np.sqrt(bar_t / bar_s) * x_s + np.sqrt(1 - bar_t / bar_s) * rng.standard_normal(200_000)
    near = np.abs(x_t - 0.5) < 0.02
    mean, variance = samplers.posterior(torch.tensor(0.5), torch.tensor(x0), t, s)
    assert abs(x_s[near].mean() - float(mean)) < 0.02
    assert abs(x_s[near].var() - float(variance)) < 0.02


@pytest.mark.parametrize("name, order", [("ddim", 1), ("dpm++", 2)])
def test_errors_of_samplers_fall_with_their_order(name: str, order: int) -> None:
    """Of Gaussian data, where x_0 follows from x_T alone: over steps of equal length in log SNR, twice as many leave a
    half of the error of first order, a quarter of the second."""
    spread = 0.4
    bars = [float(bar) for bar in ALPHA_BAR]
    snr = np.array([0.5 * np.log(bar / max(1 - bar, 1e-12)) for bar in bars])

    def denoise(x: torch.Tensor, t: torch.Tensor) -> Prediction:
        bar = ALPHA_BAR[t][:, None, None]
        return Prediction(bar.sqrt() * spread**2 / (bar * spread**2 + 1 - bar) * x, torch.zeros(()))

    def error(steps: int) -> float:
        path = [int(np.abs(snr - at).argmin()) for at in np.linspace(snr[900], snr[100], steps + 1)]
        x, last = torch.ones(1, 1, 1, dtype=torch.float64), path[-1]
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(samplers, "timesteps", lambda _: path)
            found = float(samplers.SAMPLERS[name](denoise, x, steps, lambda: x))
        true = np.sqrt((bars[last] * spread**2 + 1 - bars[last]) / (bars[path[0]] * spread**2 + 1 - bars[path[0]]))
        return abs(found - true)

    ratio = error(8) / error(32)
    assert 0.6 * 4**order < ratio < 1.8 * 4**order
