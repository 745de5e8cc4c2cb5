"""Articulated collision (Eq. 4): Σ IoU₃D(b′_i, b_j), b′ grown to cover what its moving parts sweep."""

import torch
from torch import Tensor

from apartgen.stages.layout.geometry import Boxes, Floor, close_pairs, iou, obstructs, partners


def energy(boxes: Boxes, room: Floor) -> Tensor:
    """Summed over ordered pairs; things that belong together and rugs are left out."""
    grown = boxes.extended()
    pairs = close_pairs(grown, boxes)
    r, i, j = pairs.unbind(-1)
    a, b = boxes.category[r, i], boxes.category[r, j]
    counts = obstructs()[a] & obstructs()[b] & ~partners()[a, b]
    pairs = pairs[counts]
    return torch.zeros(len(boxes.center)).index_add(0, pairs[:, 0], iou(grown, boxes, pairs))
