"""Differentiable geometry of boxes and rooms, batched over rooms and objects."""

from dataclasses import dataclass, fields
from functools import cache

import numpy as np
import torch
from torch import Tensor

from apartgen.stages.layout.diffusion import Prediction
from apartgen.stages.layout.features import CLASS, EMPTY, HEADING, place, size
from apartgen.stages.layout.rooms import DOOR_CLEARANCE, WINDOW_CLEARANCE, Rooms, edges
from apartgen.stages.things.categories import CATEGORIES, DRAWER_TRAVEL, TABLE, belong_together


@dataclass
class Boxes:
    """Oriented boxes: center, size (B, N, 3), heading (B, N, 2) of unit length, category (B, N), filled (B, N) 0/1,
    reach (B, N) of open parts in front, empty (B, N) the state's empty channel in 0 … 1."""

    center: Tensor
    size: Tensor
    heading: Tensor
    category: Tensor
    filled: Tensor
    reach: Tensor
    empty: Tensor

    def extended(self) -> "Boxes":
        """b′ of Eq. 4: grown in front to cover the sweep of every moving part."""
        forward = torch.nn.functional.pad(self.heading * (self.reach / 2)[..., None], (0, 1))
        depth = torch.stack([self.reach, torch.zeros_like(self.reach), torch.zeros_like(self.reach)], -1)
        return Boxes(
            self.center + forward,
            self.size + depth,
            self.heading,
            self.category,
            self.filled,
            torch.zeros_like(self.reach),
            self.empty,
        )


@dataclass
class Floor:
    """A room's boundary: start, end (B, E, 2) of sides, NaN-free with `real` (B, E); `zones` (B, Z, 4, 2) that must
    stay clear, with `zone_floor` (B, Z) the height above which something blocks; `height` (B,); `empty` (B, N) is T
    of Eq. 3, 1 where a slot shall be empty, and has no columns while that is undecided."""

    start: Tensor
    end: Tensor
    real: Tensor
    zones: Tensor
    zone_floor: Tensor
    height: Tensor
    empty: Tensor

    def take(self, index: Tensor) -> "Floor":
        """The floors of some rooms."""
        return Floor(**{f.name: getattr(self, f.name)[index] for f in fields(self)})


def boxes_of(made: Prediction, class_scale: float) -> Boxes:
    """The boxes a prediction stands for; gradients flow to places, sizes and headings."""
    x0 = made.x0
    heading = x0[..., HEADING] / x0[..., HEADING].norm(dim=-1, keepdim=True).clamp_min(1e-4)
    category = made.logits.detach().argmax(-1)
    filled = (category != EMPTY).float()
    sizes = size(x0)
    return Boxes(
        place(x0),
        sizes,
        heading,
        category,
        filled,
        reach(category, sizes.detach()),
        x0[..., CLASS][..., -1] / class_scale,
    )


@cache
def _reach_table() -> Tensor:
    """Per class: 1 where leaves open, widest leaf, share of depth, share of height."""
    rows = [
        [float(c.opens == "leaf"), c.leaf_max, DRAWER_TRAVEL * (c.opens == "drawer"), c.flap * (c.opens == "flap")]
        for c in (TABLE[name] for name in CATEGORIES)
    ]
    return torch.tensor([*rows, [0.0, 1.0, 0.0, 0.0]])


def reach(category: Tensor, sizes: Tensor) -> Tensor:
    """`apartgen.stages.things.categories.reach` over tensors."""
    leaf, widest, drawer, flap = _reach_table()[category].unbind(-1)
    depth, width, height = sizes.unbind(-1)
    return leaf * width / (width / widest - 1e-6).ceil().clamp_min(1) + drawer * depth + flap * height


@cache
def partners() -> Tensor:
    """(C+1, C+1) true where contact is part of use."""
    table = torch.zeros(EMPTY + 1, EMPTY + 1, dtype=torch.bool)
    for i, a in enumerate(CATEGORIES):
        for j, b in enumerate(CATEGORIES):
            table[i, j] = belong_together(a, b)
    return table


@cache
def on_floor() -> Tensor:
    """(C+1,) true for what stands on the floor."""
    return torch.tensor([*(TABLE[name].place == "floor" for name in CATEGORIES), False])


@cache
def obstructs() -> Tensor:
    """(C+1,) true for what cannot share its place with another body: all but rugs and curtains."""
    return torch.tensor([*(not TABLE[name].soft for name in CATEGORIES), False])


def corners(boxes: Boxes) -> Tensor:
    """Footprint corners (B, N, 4, 2), counter-clockwise."""
    c, s = boxes.heading.unbind(-1)
    front = torch.stack([c, s], -1) * (boxes.size[..., 0:1] / 2)
    left = torch.stack([-s, c], -1) * (boxes.size[..., 1:2] / 2)
    at = boxes.center[..., :2]
    return torch.stack([at + front - left, at + front + left, at - front + left, at - front - left], -2)


def cross(a: Tensor, b: Tensor) -> Tensor:
    """z of the cross product of plane vectors (..., 2)."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def overlap_area(p: Tensor, q: Tensor) -> Tensor:
    """Area shared by convex counter-clockwise quadrilaterals p, q (M, 4, 2), differentiable, (M,).

    The corners of the intersection are corners of one inside the other and crossings of sides; sorted about
    their mean they give the area by the shoelace formula.
    """

    def inside(points: Tensor, quad: Tensor) -> Tensor:
        side = torch.roll(quad, -1, 1) - quad
        return (cross(side[:, None], points[:, :, None] - quad[:, None]) >= -1e-9).all(-1)

    d, e = torch.roll(p, -1, 1) - p, torch.roll(q, -1, 1) - q
    between = q[:, None] - p[:, :, None]
    turn = cross(d[:, :, None], e[:, None])
    safe = torch.where(turn.abs() < 1e-9, torch.ones_like(turn), turn)
    u, v = cross(between, e[:, None]) / safe, cross(between, d[:, :, None]) / safe
    hit = (turn.abs() >= 1e-9) & (u >= 0) & (u <= 1) & (v >= 0) & (v <= 1)
    crossing = p[:, :, None] + u[..., None] * d[:, :, None]
    points = torch.cat([p, q, crossing.flatten(1, 2)], 1)
    real = torch.cat([inside(p, q), inside(q, p), hit.flatten(1)], 1)
    weight = real[..., None].float()
    mean = (points * weight).sum(1, keepdim=True) / weight.sum(1, keepdim=True).clamp_min(1)
    arm = torch.where(real[..., None], points - mean, torch.zeros_like(points))
    # Unreal points collapse onto a real one, where they add no area.
    first = real.float().argmax(1)
    stand_in = arm[torch.arange(len(arm)), first][:, None]
    arm = torch.where(real[..., None], arm, stand_in)
    angle = torch.atan2(arm[..., 1].detach(), arm[..., 0].detach())
    arm = arm.gather(1, angle.argsort(1)[..., None].expand(-1, -1, 2))
    area = cross(arm, torch.roll(arm, -1, 1)).sum(1) / 2
    return torch.where(real.any(1), area.clamp_min(0), torch.zeros_like(area))


@torch.no_grad()
def meeting(p: Tensor, q: Tensor) -> Tensor:
    """Which of the rectangles p, q (M, 4, 2) are parted by none of their own axes, (M,)."""
    axes = torch.cat([p[:, 1:3] - p[:, :2], q[:, 1:3] - q[:, :2]], 1)
    one, two = (axes @ corners.transpose(1, 2) for corners in (p, q))
    return ((one.amax(-1) > two.amin(-1)) & (two.amax(-1) > one.amin(-1))).all(-1)


def iou(a: Boxes, b: Boxes, pairs: Tensor) -> Tensor:
    """IoU₃D of oriented boxes a_i, b_j for `pairs` (M, 3) of [room, i, j]; (M,)."""
    r, i, j = pairs.unbind(-1)
    shared = overlap_area(corners(a)[r, i], corners(b)[r, j])
    low = torch.maximum((a.center - a.size / 2)[r, i, 2], (b.center - b.size / 2)[r, j, 2])
    high = torch.minimum((a.center + a.size / 2)[r, i, 2], (b.center + b.size / 2)[r, j, 2])
    both = shared * (high - low).clamp_min(0)
    return both / (a.size[r, i].prod(-1) + b.size[r, j].prod(-1) - both).clamp_min(1e-9)


def close_pairs(a: Boxes, b: Boxes) -> Tensor:
    """Pairs (M, 3) of [room, i, j], i ≠ j, both filled, whose footprints and heights meet."""

    def circle(boxes: Boxes) -> Tensor:
        half: Tensor = boxes.size[..., :2].norm(dim=-1) / 2
        return half

    with torch.no_grad():
        apart = torch.cdist(a.center[..., :2], b.center[..., :2])
        meet = apart < circle(a)[:, :, None] + circle(b)[:, None]
        lift = (a.center[:, :, None, 2] - b.center[:, None, :, 2]).abs()
        meet &= lift < (a.size[:, :, None, 2] + b.size[:, None, :, 2]) / 2
        meet &= (a.filled[:, :, None] * b.filled[:, None] > 0) & ~torch.eye(meet.shape[1], dtype=torch.bool)
        pairs = meet.nonzero()
        r, i, j = pairs.unbind(-1)
        return pairs[meeting(corners(a)[r, i], corners(b)[r, j])]


def floor_of(rooms: Rooms) -> Floor:
    """Boundary and clear zones of rooms, as tensors in metres."""
    a, b = edges(rooms.polygon)
    used = max(4, int((~np.isnan(rooms.polygon[..., 0])).sum(1).max()))
    start, end = torch.from_numpy(a[:, :used]).float(), torch.from_numpy(b[:, :used]).float()
    zones, low = clear_zones(rooms.openings)
    return Floor(
        start.nan_to_num(0.0),
        end.nan_to_num(0.0),
        ~start[..., 0].isnan(),
        zones,
        low,
        torch.from_numpy(rooms.height).float(),
        torch.zeros(len(rooms), 0),
    )


def clear_zones(openings: np.ndarray) -> tuple[Tensor, Tensor]:
    """Rectangles (B, Z, 4, 2) in front of openings, empty ones at one far point, and their floor heights (B, Z)."""
    rows = torch.from_numpy(openings).float()
    start, end, kind, swings = rows[..., 0:2], rows[..., 2:4], rows[..., 4], rows[..., 5]
    along = end - start
    length = along.norm(dim=-1, keepdim=True)
    inward = torch.stack([-along[..., 1], along[..., 0]], -1) / length
    window = kind == 3
    leaf = torch.where(swings > 0, length[..., 0] + 0.03, torch.tensor(DOOR_CLEARANCE))
    depth = torch.where(window, torch.tensor(WINDOW_CLEARANCE), leaf.clamp_min(DOOR_CLEARANCE))
    out = inward * depth[..., None]
    zones = torch.stack([start, end, end + out, start + out], -2)
    low = torch.where(window, torch.tensor(1.0), torch.tensor(0.03))
    return zones.nan_to_num(1e3), low


def outside(points: Tensor, floor: Floor) -> Tensor:
    """How far points (B, M, 2) lie outside their room, metres, 0 inside; differentiable."""
    along = floor.end - floor.start
    offset = points[:, :, None] - floor.start[:, None]
    share = ((offset * along[:, None]).sum(-1) / along.square().sum(-1).clamp_min(1e-9)[:, None]).clamp(0, 1)
    away = (offset - share[..., None] * along[:, None]).square().sum(-1).add(1e-12).sqrt()
    nearest = away.masked_fill(~floor.real[:, None], torch.inf).amin(-1)
    with torch.no_grad():
        y = points[..., 1, None]
        spans = (floor.start[:, None, :, 1] > y) != (floor.end[:, None, :, 1] > y)
        turn = cross(along[:, None], offset)
        right = torch.where(floor.end[:, None, :, 1] > floor.start[:, None, :, 1], turn > 0, turn < 0)
        within = (spans & right & floor.real[:, None]).sum(-1) % 2 == 1
    return torch.where(within, torch.zeros_like(nearest), nearest)
