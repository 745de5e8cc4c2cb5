"""The diffusion process: noise schedule, one-step prediction, and the training loss of Eq. 1.

The network speaks v = √ᾱ ε - √(1-ᾱ) x_0 for places, sizes, headings and latents, and logits for classes; both give
ε_θ, so the loss below is Eq. 1 with each t weighted by 1/ᾱ.
"""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from torch import Tensor

from apartgen.stages.layout.config import ModelConfig, T
from apartgen.stages.layout.features import CLASS, HEADING, PLACE, SHAPE, SIZE
from apartgen.stages.layout.network import Context, Denoiser
from apartgen.stages.layout.schedule import alpha_bar

GROUPS = ((PLACE, 2.0), (SIZE, 0.5), (HEADING, 1.0), (SHAPE, 0.2))
"""Weight of each group of continuous channels in the loss; classes have cross-entropy beside."""
CLASS_WEIGHT = 0.3


@dataclass
class Prediction:
    """One-step prediction: the clean state x_0 (B, N, D) and class logits (B, N, C+1)."""

    x0: Tensor
    logits: Tensor


Denoise = Callable[[Tensor, Tensor], Prediction]
"""Maps a noisy state (B, N, D) and its step t (B,) in 0 … T to a prediction."""


def coefficients(t: Tensor) -> tuple[Tensor, Tensor]:
    """√ᾱ_t and √(1-ᾱ_t), shaped (B, 1, 1)."""
    bar = alpha_bar(t)[:, None, None]
    return bar.sqrt(), (1 - bar).sqrt()


def predict(network: Denoiser, x: Tensor, t: Tensor, room: Context) -> Prediction:
    """What the network takes the clean state to be."""
    return interpret(network(x, t.float() / T, room), x, t, network.config)


def interpret(raw: Tensor, x: Tensor, t: Tensor, config: ModelConfig) -> Prediction:
    """Turn raw network outputs into a prediction.

    A class logit starts from what the noisy one-hot itself says (its Gaussian log-likelihood); the network adds the
    rest. The predicted one-hot is its expectation.
    """
    alpha, sigma = coefficients(t)
    x0 = alpha * x - sigma * raw
    seen = x[..., CLASS] * (alpha * config.class_scale / sigma.square().clamp_min(1e-2))
    logits = raw[..., CLASS] * 4 + seen
    x0[..., CLASS] = logits.softmax(-1) * config.class_scale
    return Prediction(x0, logits)


def noised(x0: Tensor, t: Tensor, noise: Tensor) -> Tensor:
    """x_t of Algorithm 1, line 5."""
    alpha, sigma = coefficients(t)
    return alpha * x0 + sigma * noise


def loss(
    network: Denoiser,
    x0: Tensor,
    t: Tensor,
    noise: Tensor,
    room: Context,
    shift: Callable[[Prediction, Tensor], Tensor] | None = None,
) -> tuple[Tensor, Prediction]:
    """Eq. 1 over a batch; `shift` gives λΣg to be taken off ε (constraint anticipation), None is plain denoising."""
    x = noised(x0, t, noise)
    alpha, sigma = coefficients(t)
    raw = network(x, t.float() / T, room)
    made = interpret(raw.clone(), x, t, network.config)
    target = noise if shift is None else noise - shift(made, t)
    v = alpha * target - sigma * x0
    # An empty slot has no place or size: only its class is learned.
    filled = 1 - x0[..., CLASS][..., -1:].sign()
    error = (raw - v).square() * filled
    total = sum(weight * error[..., group].mean(-1).sum() for group, weight in GROUPS) / filled.sum().clamp_min(1)
    wanted = x0[..., CLASS].argmax(-1)
    classes = torch.nn.functional.cross_entropy(made.logits.flatten(0, 1), wanted.flatten())
    return total + CLASS_WEIGHT * classes, made
