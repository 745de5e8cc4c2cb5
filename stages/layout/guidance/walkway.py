"""Walkway: what stands on the floor is flush with walls and neighbours, or far enough away to walk between."""

import torch
from torch import Tensor

from apartgen.stages.layout.geometry import Boxes, Floor, corners, obstructs, on_floor, partners

FLUSH, PASS = 0.03, 0.55
"""Gaps between these are of no use, m."""


def energy(boxes: Boxes, room: Floor) -> Tensor:
    """Σ over useless gaps g of 4 (g - FLUSH)(PASS - g) / (PASS - FLUSH)²: at most 1 each, 0 at either end."""
    stands = on_floor()[boxes.category] & obstructs()[boxes.category] & (boxes.filled > 0)
    pairs = stands[:, :, None] & stands[:, None] & ~partners()[boxes.category[:, :, None], boxes.category[:, None]]
    between = _useless(_apart(boxes)) * torch.triu(pairs.float(), 1)
    return between.sum((1, 2)) + (_useless(_from_walls(boxes, room)) * stands[:, :, None]).sum((1, 2))


def _useless(gap: Tensor) -> Tensor:
    return (4 * (gap - FLUSH) * (PASS - gap) / (PASS - FLUSH) ** 2).clamp_min(0)


def _apart(boxes: Boxes) -> Tensor:
    """Gap (B, N, N) along the best separating axis in plan: exact where faces are parallel and overlap."""
    front = boxes.heading
    axes = torch.stack([front, torch.stack([-front[..., 1], front[..., 0]], -1)], -2)
    half = boxes.size[..., :2] / 2
    offset = boxes.center[:, None, :, :2] - boxes.center[:, :, None, :2]

    def along(own: Tensor, own_half: Tensor, other: Tensor, other_half: Tensor) -> Tensor:
        """Gaps on the two axes of `own`."""
        reach = (own[..., :, None, :] * other[..., None, :, :]).sum(-1).abs() @ other_half[..., None]
        return ((offset[..., None, :] * own).sum(-1).abs() - own_half - reach[..., 0]).amax(-1)

    mine, yours = axes[:, :, None], axes[:, None]
    by_mine = along(mine, half[:, :, None], yours.expand(-1, axes.shape[1], -1, -1, -1), half[:, None])
    by_yours = along(yours, half[:, None], mine.expand(-1, -1, axes.shape[1], -1, -1), half[:, :, None])
    return torch.maximum(by_mine, by_yours)


def _from_walls(boxes: Boxes, room: Floor) -> Tensor:
    """Gap (B, N, E) to every wall that an object stands beside; far for the others."""
    side = room.end - room.start
    length = side.norm(dim=-1).clamp_min(1e-6)
    along = side / length[..., None]
    normal = torch.stack([-along[..., 1], along[..., 0]], -1)
    offset = corners(boxes)[:, :, None] - room.start[:, None, :, None]
    gap = (offset * normal[:, None, :, None]).sum(-1).amin(-1)
    at = (offset * along[:, None, :, None]).sum(-1)
    beside = (at.amax(-1) > 0) & (at.amin(-1) < length[:, None]) & room.real[:, None]
    return torch.where(beside, gap, torch.full_like(gap, 9.0))
