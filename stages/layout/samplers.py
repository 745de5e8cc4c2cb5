"""Samplers of the reverse process; each takes `(denoise, x, steps, noise)` and returns x_0 (B, N, D).

`noise(shape)` yields unit Gaussian tensors. Guidance is in `denoise`; no sampler knows of it.
"""

from collections.abc import Callable

import torch
from torch import Tensor

from apartgen.stages.layout.config import T
from apartgen.stages.layout.diffusion import Denoise
from apartgen.stages.layout.schedule import ALPHA_BAR

Noise = Callable[[], Tensor]


def timesteps(steps: int) -> list[int]:
    """`steps` values falling from T towards 1, then 0; spaced quadratically so that half lie in the last quarter."""
    if steps >= T:
        return list(range(T, -1, -1))
    share = torch.linspace(1, 0, steps + 1).double()
    spaced = (T * share**1.5).round().long().tolist()
    return [max(t, steps - i) for i, t in enumerate(spaced)]


def sample_ddpm(denoise: Denoise, x: Tensor, steps: int, noise: Noise) -> Tensor:
    """Ancestral sampling (paper Algorithm 1, lines 8-19); with fewer steps the posterior spans the gap."""
    path = timesteps(steps)
    for t, s in zip(path, path[1:], strict=False):
        x0 = denoise(x, torch.full((len(x),), t)).x0
        mean, variance = posterior(x, x0, t, s)
        x = mean + variance.sqrt() * noise() if s > 0 else mean
    return x


def posterior(x: Tensor, x0: Tensor, t: int, s: int) -> tuple[Tensor, Tensor]:
    """Mean μ and variance Σ of q(x_s | x_t, x_0) for s < t."""
    bar_t, bar_s = ALPHA_BAR[t], ALPHA_BAR[s]
    alpha = bar_t / bar_s
    mean = (bar_s.sqrt() * (1 - alpha) * x0 + alpha.sqrt() * (1 - bar_s) * x) / (1 - bar_t)
    return mean, (1 - bar_s) / (1 - bar_t) * (1 - alpha)


def sample_ddim(denoise: Denoise, x: Tensor, steps: int, noise: Noise) -> Tensor:
    """Deterministic DDIM (η = 0), doi:10.48550/arXiv.2010.02502."""
    path = timesteps(steps)
    for t, s in zip(path, path[1:], strict=False):
        x0 = denoise(x, torch.full((len(x),), t)).x0
        eps = (x - ALPHA_BAR[t].sqrt() * x0) / (1 - ALPHA_BAR[t]).sqrt()
        x = ALPHA_BAR[s].sqrt() * x0 + (1 - ALPHA_BAR[s]).sqrt() * eps
    return x


def sample_dpmpp(denoise: Denoise, x: Tensor, steps: int, noise: Noise) -> Tensor:
    """DPM-Solver++(2M), doi:10.48550/arXiv.2211.01095: second order from two successive predictions."""
    path = timesteps(steps)
    alpha, sigma = ALPHA_BAR.sqrt(), (1 - ALPHA_BAR).sqrt()
    half_log_snr = (alpha / sigma.clamp_min(1e-6)).log()
    before: Tensor | None = None
    last = 0.0
    for t, s in zip(path, path[1:], strict=False):
        x0 = denoise(x, torch.full((len(x),), t)).x0
        h = float(half_log_snr[s] - half_log_snr[t])
        estimate = x0
        if before is not None and s > 0:
            estimate = x0 + (x0 - before) * (h / (2 * last))
        x = sigma[s] / sigma[t] * x - alpha[s] * (torch.expm1(torch.tensor(-h))) * estimate if s > 0 else x0
        before, last = x0, h
    return x


SAMPLERS = {"ddpm": sample_ddpm, "ddim": sample_ddim, "dpm++": sample_dpmpp}
