"""Object quantity (Eq. 3): the wanted number of slots is filled, the rest empty."""

import torch
from torch import Tensor

from apartgen.stages.layout.geometry import Boxes, Floor

SHARPNESS = 8.0
"""Logits a unit of the empty channel, which runs from 0 (filled) to 1 (empty)."""


def energy(boxes: Boxes, room: Floor) -> Tensor:
    """BCEWithLogits between empty logits c_i and T, which is `room.empty` (B, N): 1 where a slot shall be empty."""
    logits = (boxes.empty - 0.5) * SHARPNESS
    return torch.nn.functional.binary_cross_entropy_with_logits(logits, room.empty, reduction="none").mean(-1)
