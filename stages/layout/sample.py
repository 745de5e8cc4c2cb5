"""From rooms to objects: sampling with guidance, then projection."""

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.consistency import FARTHEST
from apartgen.schemas.errors import Unmet
from apartgen.stages.layout import guided, samplers
from apartgen.stages.layout.config import N_MAX, LayoutConfig
from apartgen.stages.layout.diffusion import Denoise, predict
from apartgen.stages.layout.features import DIM, Objects, decode
from apartgen.stages.layout.geometry import floor_of
from apartgen.stages.layout.network import Denoiser
from apartgen.stages.layout.rooms import UNKNOWN, Rooms

AREA_BINS = (0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 21, 25, 30, 36, 45)
"""Lower edges of the floor-area classes (m²) for which the training record counts objects."""
EARLY = 0.10
"""Quantity guidance acts below this share of the schedule (Fig. 4)."""
SPARSE = 0.25
"""Share of the emptiest rooms in the training record that homes don't draw from: they look as if someone moved out."""
QUANTITY = 100.0
"""Its weight γ; a mean over slots has small gradients, and settled classes hold on to their evidence."""


def count_table(rooms: Rooms, count: NDArray[np.int64]) -> list[list[list[int]]]:
    """How often a room of each type and area class held each number of objects: (types, areas, N_MAX + 1)."""
    table = np.zeros((len(ROOM_TYPES), len(AREA_BINS), N_MAX + 1), int)
    np.add.at(table, (rooms.type, np.digitize(rooms.area, AREA_BINS) - 1, count), 1)
    nested: list[list[list[int]]] = table.tolist()
    return nested


def draw_counts(
    rooms: Rooms, table: list[list[list[int]]], lanes: list[np.random.Generator], at_home: NDArray[np.bool_]
) -> NDArray[np.int64]:
    """The number of objects of every room: as asked, else drawn from what rooms of its type and area hold.

    `at_home` (B,): rooms of a home, not by themselves; these are drawn from the fuller ones.
    """
    asked = np.where(rooms.wanted > 0, rooms.wanted, 0).sum(1)
    out = np.zeros(len(rooms), np.int64)
    for i, (kind, area, rng) in enumerate(zip(rooms.type, rooms.area, lanes, strict=True)):
        sparse = SPARSE if at_home[i] else 0.0
        share = sparse + (1 - sparse) * rng.random()
        if rooms.count[i] != UNKNOWN:
            out[i] = min(int(rooms.count[i]), N_MAX)
            continue
        rows = np.array(table[kind], float)
        near = np.exp(-np.abs(np.arange(len(AREA_BINS)) - (np.digitize(area, AREA_BINS) - 1)) * 3.0)
        weight = (rows * near[:, None]).sum(0) + 1e-9
        out[i] = np.searchsorted(np.cumsum(weight) / weight.sum(), share)
    return np.asarray(np.minimum(np.maximum(out, asked), N_MAX))


def sample(
    network: Denoiser,
    rooms: Rooms,
    config: LayoutConfig,
    lanes: list[np.random.Generator],
) -> Objects:
    """Objects (B, N) of a batch of rooms of known count; one generator a room, so that none hangs on another's."""
    count = torch.from_numpy(rooms.count)
    exact = config.count == "exact"
    slots = max(1, int(count.max())) if exact else N_MAX
    with torch.no_grad():
        context = network.encoder(rooms, not exact)
        context.seen = network.seen(context)
    if exact:
        context.present = torch.arange(slots)[None] < count[:, None]
    denoise: Denoise = lambda x, t: predict(network, x, t, context)  # noqa: E731
    denoise = guided.biased(denoise, network.bias[torch.from_numpy(rooms.type), None])
    denoise = _wrapped(denoise, network, rooms, count, config, exact)
    noise = _noise(lanes, slots)
    with torch.no_grad():
        x0 = samplers.SAMPLERS[config.sampler](denoise, noise(), config.steps, noise)
    objects = decode(x0, network.config)
    if exact:
        objects.category[~context.present] = -1
    _check(objects)
    return objects


def _check(objects: Objects) -> None:
    """Unmet where an object is nowhere near its room: guidance too strong for the sampler's steps."""
    there = objects.category >= 0
    reach = torch.cat([objects.center, objects.size], -1)[there].abs()
    if not (reach < FARTHEST).all():
        raise Unmet("sampling diverged: objects lie over a kilometre away; lower --guidance-scale, or let guidance act "
                    "later (--guide-below 0.01) in smaller steps (--sampler ddpm --steps 1000)")


def _wrapped(
    denoise: Denoise, network: Denoiser, rooms: Rooms, count: Tensor, config: LayoutConfig, exact: bool
) -> Denoise:
    """The denoiser with everything that steers it, innermost first."""
    model, room, wanted = network.config, floor_of(rooms), torch.from_numpy(rooms.wanted)
    filled = count if exact else torch.full_like(count, N_MAX)
    if exact:
        denoise = guided.without_empty(denoise, count)
    denoise = guided.fixed_categories(denoise, wanted, filled, model)
    denoise = guided.sensible(denoise, rooms, filled, model.class_scale)
    if config.count == "guided":
        gamma = config.guidance.get("quantity", QUANTITY)
        denoise = guided.quantity_guided(
            denoise, count, wanted, guided.energies({"quantity": gamma}), room, model, config, EARLY
        )
    weights = {name: gamma for name, gamma in config.guidance.items() if name != "quantity"}
    return guided.guided(denoise, guided.energies(weights), room, model, config, config.guide_below)


def _noise(lanes: list[np.random.Generator], slots: int) -> samplers.Noise:
    """Unit Gaussian states (B, slots, D), every room from its own lane."""

    def draw() -> Tensor:
        rows = [lane.standard_normal((N_MAX, DIM), np.float32)[:slots] for lane in lanes]
        return torch.from_numpy(np.stack(rows))

    return draw
