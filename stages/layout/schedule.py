"""The noise schedule: linear β, T = 1000 (DDPM, doi:10.48550/arXiv.2006.11239)."""

from functools import cache

import numpy as np
import torch
from torch import Tensor

from apartgen.stages.layout.config import T

BETAS = np.linspace(1e-4, 0.02, T)
ALPHA_BAR = torch.from_numpy(np.concatenate([[1.0], np.cumprod(1 - BETAS)])).float()
"""ᾱ_t for t = 0 … T; ᾱ_0 = 1."""


def alpha_bar(t: Tensor) -> Tensor:
    """ᾱ_t of steps t, on their device."""
    return _on(t.device)[t]


@cache
def _on(device: torch.device) -> Tensor:
    return ALPHA_BAR.to(device)
