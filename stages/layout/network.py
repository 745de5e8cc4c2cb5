"""The denoising network: a permutation-equivariant set transformer over object slots, conditioned on the room."""

from dataclasses import dataclass
from typing import cast

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn.functional import scaled_dot_product_attention

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.layout.config import N_MAX, ModelConfig, T
from apartgen.stages.layout.features import DIM, HEADING, METRE
from apartgen.stages.layout.frames import OBJECT_PAIR, WALL_PAIR, FrameHead, object_pairs, wall_pairs, with_extent
from apartgen.stages.layout.rooms import UNKNOWN, Rooms, edges
from apartgen.stages.layout.schedule import alpha_bar
from apartgen.stages.things.categories import CATEGORIES

FRAME = 6

SHARP = 0.03
"""How exactly things stand against walls and at tables, in units of place."""


@dataclass
class Context:
    """A room as the network sees it, computed once a sample.

    tokens (B, K, W) of walls then openings · mask (B, K) true where real · vector (B, W) ·
    frames (B, K, 7) of [mid x, mid y, normal x, normal y, half length, is wall, kind] · present (B, N) objects that
    exist, None when all do · seen: keys and values (B, heads, K, W / heads) of the tokens in every block, None where
    they are not kept from step to step.
    """

    tokens: Tensor
    mask: Tensor
    vector: Tensor
    frames: Tensor
    present: Tensor | None = None
    seen: list[tuple[Tensor, ...]] | None = None


def wall_frames(rooms: Rooms) -> tuple[Tensor, Tensor]:
    """Frames (B, K, 7) of walls and openings in scaled units, and which are real (B, K)."""
    corners = max(4, int((~np.isnan(rooms.polygon[..., 0])).sum(1).max()))
    holes = max(1, int((~np.isnan(rooms.openings[..., 0])).sum(1).max()))
    a, b = edges(rooms.polygon)
    start = torch.from_numpy(np.concatenate([a[:, :corners], rooms.openings[:, :holes, 0:2]], 1)).float() / METRE
    end = torch.from_numpy(np.concatenate([b[:, :corners], rooms.openings[:, :holes, 2:4]], 1)).float() / METRE
    mask = ~start[..., 0].isnan()
    along = end - start
    length = along.norm(dim=-1).clamp_min(1e-6)
    normal = torch.stack([-along[..., 1], along[..., 0]], -1) / length[..., None]
    is_wall = torch.zeros_like(length)
    is_wall[:, :corners] = 1
    kind = torch.zeros_like(length)
    kind[:, corners:] = torch.from_numpy(rooms.openings[:, :holes, 4]).float()
    frames = torch.cat([(start + end) / 2, normal, torch.stack([length / 2, is_wall, kind], -1)], -1)
    return frames.nan_to_num(0.0), mask


class EncoderLayer(nn.TransformerEncoderLayer):
    """The standard layer with attention called directly: torch's own check of shapes first imports sympy, which takes
    longer than a flat's layout."""

    def _sa_block(
        self, x: Tensor, attn_mask: Tensor | None, key_padding_mask: Tensor | None, is_causal: bool = False
    ) -> Tensor:
        b, n, w = x.shape
        own = self.self_attn
        both = torch.nn.functional.linear(x, own.in_proj_weight, own.in_proj_bias)
        q, k, v = both.view(b, n, 3, own.num_heads, -1).permute(2, 0, 3, 1, 4).unbind(0)
        mask = None if key_padding_mask is None else key_padding_mask[:, None, None]
        found = torch.nn.functional.scaled_dot_product_attention(q, k, v, attn_mask=mask)
        out: Tensor = own.out_proj(found.transpose(1, 2).reshape(b, n, w))
        return out


class RoomEncoder(nn.Module):
    """Tokens of walls, doors and windows, and one vector of type, size, count and wanted categories."""

    def __init__(self, config: ModelConfig) -> None:
        super().__init__()
        w = config.width
        self.edge = nn.Sequential(nn.Linear(FRAME + 5, w), nn.SiLU(), nn.Linear(w, w))
        self.swing = nn.Linear(2, w)
        self.kind = nn.Embedding(len(ROOM_TYPES), w)
        self.count = nn.Embedding(N_MAX + 2, w)
        self.slots = nn.Embedding(2, w)
        self.wanted = nn.Linear(2 * len(CATEGORIES), w)
        self.scalars = nn.Linear(3, w)
        layer = EncoderLayer(w, config.heads, 2 * w, 0.0, "gelu", batch_first=True, norm_first=True)
        self.layers = nn.TransformerEncoder(layer, config.encoder_layers, enable_nested_tensor=False)

    def forward(self, rooms: Rooms, all_slots: bool) -> Context:
        """Encode; `all_slots` tells that empty slots are among the objects."""
        frames, mask = wall_frames(rooms)
        holes = int((frames[0, :, 5] == 0).sum())
        frames, mask = frames.to(self.device), mask.to(self.device)
        kind = torch.nn.functional.one_hot(frames[..., 6].long().clamp(0, 3), 4) * (1 - frames[..., 5:6])
        tokens = self.edge(torch.cat([frames[..., :6], frames[..., 4:5].log1p(), kind], -1))
        swings = torch.from_numpy(rooms.openings[:, :holes, 5:7]).to(self.device).float().nan_to_num(0.0)
        tokens = torch.cat([tokens[:, :-holes], tokens[:, -holes:] + self.swing(swings)], 1)
        vector = self.vector(rooms, all_slots)
        tokens = self.layers(tokens + vector[:, None], src_key_padding_mask=~mask)
        return Context(tokens, mask, vector, frames)

    def vector(self, rooms: Rooms, all_slots: bool) -> Tensor:
        """What is known of the room as a whole, (B, W)."""
        count = torch.from_numpy(np.where(rooms.count == UNKNOWN, N_MAX + 1, rooms.count.clip(0, N_MAX)))
        wanted = torch.from_numpy(rooms.wanted)
        known = (wanted != UNKNOWN).float()
        asked = torch.cat([known, wanted.clamp_min(0).float() * known], -1)
        area = torch.from_numpy(rooms.area).float()
        extent = torch.from_numpy(np.nanmax(rooms.polygon, 1)).float()
        scalars = torch.stack([area.clamp_min(0.1).log() - 2.5, *(extent.log() - 0.6).unbind(-1)], -1)
        slots = self.slots.weight[int(all_slots)]
        kind, count, asked, scalars = (
            value.to(self.device) for value in (torch.from_numpy(rooms.type), count, asked, scalars)
        )
        total: Tensor = self.kind(kind) + self.count(count) + self.wanted(asked) + self.scalars(scalars) + slots
        return total

    @property
    def device(self) -> torch.device:
        """Where the parameters are."""
        return self.scalars.weight.device


class Block(nn.Module):
    """Self-attention among objects, cross-attention to the room, both with geometric bias, then an MLP."""

    def __init__(self, config: ModelConfig) -> None:
        super().__init__()
        w, self.heads = config.width, config.heads
        self.norms = nn.ModuleList(nn.LayerNorm(w, elementwise_affine=False) for _ in range(3))
        self.modulation = nn.Parameter(torch.randn(9, w) * 0.02)
        self.qkv = nn.Linear(w, 3 * w)
        self.query, self.key_value = nn.Linear(w, w), nn.Linear(w, 2 * w)
        self.out = nn.ModuleList(nn.Linear(w, w) for _ in range(2))
        self.mlp = nn.Sequential(nn.Linear(w, config.mlp_ratio * w), nn.GELU(), nn.Linear(config.mlp_ratio * w, w))

    def split(self, x: Tensor, parts: int) -> tuple[Tensor, ...]:
        """(B, N, parts·W) to `parts` tensors (B, heads, N, W / heads)."""
        b, n, _ = x.shape
        return x.view(b, n, parts, self.heads, -1).permute(2, 0, 3, 1, 4).unbind(0)

    def seen(self, room: Tensor) -> tuple[Tensor, ...]:
        """Keys and values (B, heads, K, W / heads) of room tokens (B, K, W)."""
        return self.split(self.key_value(room), 2)

    def forward(self, x: Tensor, room: tuple[Tensor, ...], time: Tensor, bias: tuple[Tensor, Tensor]) -> Tensor:
        """x (B, N, W), the room's keys and values, time (B, 9, W), biases (B, heads, N, N) and (B, heads, N, K)."""
        shift_a, scale_a, gate_a, shift_c, scale_c, gate_c, shift_m, scale_m, gate_m = (self.modulation + time)[
            :, :, None
        ].unbind(1)
        h = self.norms[0](x) * (1 + scale_a) + shift_a
        q, k, v = self.split(self.qkv(h), 3)
        x = x + gate_a * self.out[0](scaled_dot_product_attention(q, k, v, bias[0]).transpose(1, 2).flatten(2))
        h = self.norms[1](x) * (1 + scale_c) + shift_c
        (q,), (k, v) = self.split(self.query(h), 1), room
        x = x + gate_c * self.out[1](scaled_dot_product_attention(q, k, v, bias[1]).transpose(1, 2).flatten(2))
        out: Tensor = x + gate_m * self.mlp(self.norms[2](x) * (1 + scale_m) + shift_m)
        return out


class Denoiser(nn.Module):
    """Raw network outputs (B, N, D) for a noisy state x_t at t in [0, 1]."""

    def __init__(self, config: ModelConfig) -> None:
        super().__init__()
        w, self.config = config.width, config
        self.encoder = RoomEncoder(config)
        self.input = nn.Linear(DIM, w)
        self.wall_pair = nn.Sequential(nn.Linear(WALL_PAIR, w // 2), nn.SiLU(), nn.Linear(w // 2, w // 2), nn.SiLU())
        self.wall_value = nn.Linear(w // 2, w)
        self.wall_bias = nn.Linear(w // 2, config.layers * config.heads)
        self.object_pair = nn.Sequential(nn.Linear(OBJECT_PAIR, w // 4), nn.SiLU())
        self.object_bias = nn.Linear(w // 4, config.layers * config.heads)
        self.time = nn.Sequential(nn.Linear(64, w), nn.SiLU(), nn.Linear(w, w))
        self.modulation = nn.Sequential(nn.SiLU(), nn.Linear(w, 9 * w))
        self.blocks = nn.ModuleList(Block(config) for _ in range(config.layers))
        self.norm = nn.LayerNorm(w)
        self.by_walls, self.by_objects = FrameHead(WALL_PAIR, w), FrameHead(OBJECT_PAIR, w)
        self.output = nn.Linear(w, DIM)
        self.bias: Tensor
        """Added to the class logits of each room type when sampling, (types, C+1); set by calibration."""
        self.register_buffer("bias", torch.zeros(len(ROOM_TYPES), len(CATEGORIES) + 1))
        nn.init.zeros_(self.output.weight)
        nn.init.zeros_(self.output.bias)

    def seen(self, room: Context) -> list[tuple[Tensor, ...]]:
        """What every block reads of the room, which is the same at every step of a sample."""
        return [cast(Block, block).seen(room.tokens) for block in self.blocks]

    def forward(self, x: Tensor, t: Tensor, room: Context) -> Tensor:
        """x (B, N, D), t (B,)."""
        b, n, _ = x.shape
        seen = room.seen or self.seen(room)
        walls, objects = wall_pairs(x, room.frames), object_pairs(x)
        near = self.wall_pair(walls)
        near = near * room.mask[:, None, :, None]
        heads, layers = self.config.heads, self.config.layers
        to_walls = self.wall_bias(near).view(b, n, -1, layers, heads).permute(3, 0, 4, 1, 2)
        to_walls = to_walls.masked_fill(~room.mask[None, :, None, None], -1e4)
        to_objects = self.object_bias(self.object_pair(objects))
        to_objects = to_objects.view(b, n, n, layers, heads).permute(3, 0, 4, 1, 2)
        if room.present is not None:
            to_objects = to_objects.masked_fill(~room.present[None, :, None, None], -1e4)
        h = self.input(x) + self.wall_value(near.amax(2)) + room.vector[:, None]
        time = self.modulation(self.time(fourier(t, 64)) + room.vector).view(b, 9, -1)
        for i, block in enumerate(self.blocks):
            h = block(h, seen[i], time, (to_objects[i], to_walls[i]))
        h = self.norm(h)
        out: Tensor = self.output(h).float()
        present = torch.ones(b, n, dtype=torch.bool, device=x.device) if room.present is None else room.present
        moved = self.by_walls(with_extent(walls, x), h, room.tokens, room.frames[..., 2:4], room.mask)
        moved = moved + self.by_objects(with_extent(objects, x), h, h, x[..., HEADING], present)
        # Where x_0 lies SHARP about a frame's target, the best guess goes σ²/(σ²+s²) of the way, which is σ v.
        variance = (1 - alpha_bar((t * T).round().long()))[:, None, None]
        moved = moved * variance.sqrt() / (variance + SHARP**2)
        plane, heading = moved.split(2, -1)
        return out + torch.cat([plane, zeros(out, 4), heading, zeros(out, DIM - 8)], -1)


def zeros(like: Tensor, channels: int) -> Tensor:
    """(B, N, channels) of 0."""
    return like.new_zeros(*like.shape[:2], channels)


def fourier(t: Tensor, width: int) -> Tensor:
    """Sines and cosines of t (B,) at geometric frequencies, (B, width)."""
    angle = t[:, None] * torch.exp(torch.linspace(0, 6.9, width // 2, device=t.device))
    return torch.cat([angle.sin(), angle.cos()], -1)
