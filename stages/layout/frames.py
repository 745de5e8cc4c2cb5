"""How objects lie to walls and to one another, and displacements spoken in those frames."""

import torch
from torch import Tensor, nn

from apartgen.stages.layout.features import HEADING, METRE, PLACE, SIZE, size

OBJECT_PAIR = 8
WALL_PAIR = 9
EXTENT = 2
"""True half depth and half width, in units of place."""


class FrameHead(nn.Module):
    """Moves and turns each object by what it reads in the frames of others: Σ_k w_ik (a_ik e_k + b_ik e_k⊥).

    Standing against a wall or facing a table is a number in that frame and a product in the room's; a network that
    speaks in frames need not learn the product. It starts as no displacement at all.
    """

    def __init__(self, pair: int, width: int) -> None:
        super().__init__()
        hidden = width // 2
        self.pair, self.own, self.other = (
            nn.Linear(pair + EXTENT, hidden),
            nn.Linear(width, hidden),
            nn.Linear(width, hidden),
        )
        self.mix = nn.Sequential(nn.SiLU(), nn.Linear(hidden, hidden), nn.SiLU())
        self.weight = nn.Linear(hidden, 1)
        self.coefficients = nn.Linear(hidden + pair + EXTENT, 4)
        nn.init.zeros_(self.coefficients.weight)
        nn.init.zeros_(self.coefficients.bias)

    def forward(self, pair: Tensor, own: Tensor, other: Tensor, axes: Tensor, mask: Tensor) -> Tensor:
        """[Δl_xy, Δθ] (B, N, 4) of pair (B, N, M, P), own (B, N, W), other (B, M, W), axes e (B, M, 2), mask (B, M)."""
        hidden = self.mix(self.pair(pair) + self.own(own)[:, :, None] + self.other(other)[:, None])
        weight = self.weight(hidden)[..., 0].float().masked_fill(~mask[:, None], -1e4).softmax(-1)
        a, b, c, d = self.coefficients(torch.cat([hidden, pair.to(hidden.dtype)], -1)).float().unbind(-1)
        side = torch.stack([-axes[..., 1], axes[..., 0]], -1)

        def sum_of(along: Tensor, across: Tensor) -> Tensor:
            return torch.einsum("bnm,bmi->bni", weight * along, axes) + torch.einsum(
                "bnm,bmi->bni", weight * across, side
            )

        return torch.cat([sum_of(a, b), sum_of(c, d)], -1)


def with_extent(pairs: Tensor, x: Tensor) -> Tensor:
    """Pair features with the half depth and half width of the first object, (B, N, M, P + 2)."""
    extent = (size(x)[..., :EXTENT] / 2 / METRE)[:, :, None]
    return torch.cat([pairs, extent.expand(*pairs.shape[:-1], EXTENT)], -1)


def wall_pairs(x: Tensor, frames: Tensor) -> Tensor:
    """How each object lies to each wall or opening, (B, N, K, 9), in that wall's own frame."""
    mid, normal, half = frames[:, None, :, 0:2], frames[:, None, :, 2:4], frames[:, None, :, 4]
    offset = x[:, :, None, 0:2] - mid
    away = (offset * normal).sum(-1)
    along = offset[..., 1] * normal[..., 0] - offset[..., 0] * normal[..., 1]
    heading = x[:, :, None, HEADING]
    facing = (heading * normal).sum(-1)
    aside = heading[..., 1] * normal[..., 0] - heading[..., 0] * normal[..., 1]
    past = along.abs() - half
    depth, width = (x[:, :, None, i].expand_as(away) for i in (SIZE.start, SIZE.start + 1))
    return torch.stack(
        [away, along, past, facing, aside, away.exp().reciprocal().clamp_max(4), depth, width, half.expand_as(away)], -1
    )


def object_pairs(x: Tensor) -> Tensor:
    """How objects lie to one another, (B, N, N, 8): offset in the first's frame, distance, relative heading."""
    offset = x[:, None, :, PLACE] - x[:, :, None, PLACE]
    c, s = x[:, :, None, 6], x[:, :, None, 7]
    front = offset[..., 0] * c + offset[..., 1] * s
    left = offset[..., 1] * c - offset[..., 0] * s
    far = offset[..., :2].square().sum(-1).add(1e-6).sqrt()
    u, v = x[:, None, :, 6], x[:, None, :, 7]
    return torch.stack([front, left, offset[..., 2], far, (-far).exp(), c * u + s * v, c * v - s * u, far * 0 + 1], -1)
