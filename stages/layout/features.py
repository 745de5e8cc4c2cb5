"""Between objects in metres and the diffusion state x of shape (B, N, D).

One object is o = [l, s, θ, c, f] (paper 3.2): place, log size, heading as (cos, sin), one-hot class whose last
channel is "empty", shape latent. All channels are scaled to about unit spread.
"""

from dataclasses import dataclass, fields

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.stages.layout.config import LATENT, ModelConfig
from apartgen.stages.things.categories import CATEGORIES

N_CLASSES = len(CATEGORIES) + 1
EMPTY = N_CLASSES - 1
PLACE = slice(0, 3)
SIZE = slice(3, 6)
HEADING = slice(6, 8)
CLASS = slice(8, 8 + N_CLASSES)
SHAPE = slice(8 + N_CLASSES, 8 + N_CLASSES + LATENT)
DIM = 8 + N_CLASSES + LATENT

METRE = 2.0
"""Metres a unit of place."""
PLACE_MEAN = torch.tensor([0.0, 0.0, 0.6])
SIZE_MEAN = torch.tensor([-0.75, -0.20, -0.35])
SIZE_SPREAD = torch.tensor([0.60, 0.60, 0.85])


@dataclass
class Objects:
    """Objects in metres and radians: center, size (B, N, 3), yaw, category (B, N), latent (B, N, 32)."""

    center: Tensor
    size: Tensor
    yaw: Tensor
    category: Tensor
    latent: Tensor

    def rows(self, index: slice | NDArray[np.int64]) -> "Objects":
        """Some of the rooms."""
        return Objects(*(getattr(self, f.name)[index] for f in fields(self)))


def join(parts: list[Objects]) -> Objects:
    """Batches one after another, padded with empty slots to the widest."""
    slots = max(part.category.shape[1] for part in parts)

    def wide(value: Tensor, fill: int) -> Tensor:
        shape = (value.shape[0], slots - value.shape[1], *value.shape[2:])
        return torch.cat([value, torch.full(shape, fill, dtype=value.dtype)], 1)

    return Objects(
        *(
            torch.cat([wide(getattr(part, f.name), -1 if f.name == "category" else 0) for part in parts])
            for f in fields(Objects)
        )
    )


def encode(objects: Objects, config: ModelConfig) -> Tensor:
    """The clean state x_0 (B, N, D); category -1 is an empty slot, its other channels zero."""
    category = torch.where(objects.category < 0, EMPTY, objects.category)
    onehot = torch.nn.functional.one_hot(category, N_CLASSES).float() * config.class_scale
    heading = torch.stack([objects.yaw.cos(), objects.yaw.sin()], -1)
    size = (objects.size.clamp_min(1e-3).log() - SIZE_MEAN) / SIZE_SPREAD
    rest = torch.cat([(objects.center - PLACE_MEAN) / METRE, size, heading], -1)
    latent = objects.latent * config.latent_scale
    filled = (category != EMPTY).unsqueeze(-1)
    return torch.cat([rest * filled, onehot, latent * filled], -1)


def decode(x: Tensor, config: ModelConfig) -> Objects:
    """Objects of a state; the class is the highest channel."""
    category = x[..., CLASS].argmax(-1)
    return Objects(
        center=place(x),
        size=size(x),
        yaw=torch.atan2(x[..., 7], x[..., 6]),
        category=torch.where(category == EMPTY, -1, category),
        latent=x[..., SHAPE] / config.latent_scale,
    )


def place(x: Tensor) -> Tensor:
    """Box centres in metres (..., 3)."""
    return x[..., PLACE] * METRE + PLACE_MEAN


def size(x: Tensor) -> Tensor:
    """Box sizes in metres (..., 3), kept between 1 mm and 5 m."""
    return (x[..., SIZE] * SIZE_SPREAD.to(x.device) + SIZE_MEAN.to(x.device)).clamp(-6.9, 1.6).exp()
