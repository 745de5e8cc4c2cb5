"""Layout: a guided set diffusion model places every object of an apartment (paper 3.2-3.4, Algorithm 1)."""

import os
from dataclasses import fields
from pathlib import Path

import numpy as np

from schemas.layout import Layout
from schemas.plan import Plan
from stages.layout.config import LayoutConfig

MANY_ROOMS = 48


def run(previous: Plan, config: LayoutConfig, rng: np.random.Generator) -> Layout:
    """Furnish one apartment, all its rooms in one batch."""
    return run_many([previous], config, [rng])[0]


def run_many(previous: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> list[Layout]:
    """Furnish several apartments, their rooms batched together; every room draws from a lane of its own."""
    import torch

    from stages.layout import rooms as room_arrays
    from stages.layout import weights
    from stages.layout.features import join
    from stages.layout.furnish import furnish
    from stages.layout.sample import draw_counts, sample

    network, record = weights.load(Path(config.weights) if config.weights else None)
    parts = [room_arrays.of_plan(plan) for plan in previous]
    rooms = room_arrays.Rooms(
        **{f.name: np.concatenate([getattr(part, f.name) for part in parts]) for f in fields(room_arrays.Rooms)}
    )
    # Few rooms are done before a second core has started.
    torch.set_num_threads(config.threads or (1 if len(rooms) < MANY_ROOMS else os.cpu_count() or 1))
    lanes = [lane for plan, rng in zip(previous, rngs, strict=True) for lane in rng.spawn(len(plan.rooms))]
    rooms.count = draw_counts(rooms, record["counts"], lanes)
    # A batch pays for its fullest room, so rooms alike share one.
    order, made = np.lexsort([rooms.tokens, rooms.count]), []
    for index in np.split(order, range(config.batch, len(order), config.batch)):
        made.append(sample(network, rooms[index], config, [lanes[i] for i in index]))
    objects = join(made).rows(np.argsort(order))
    out, first = [], 0
    for plan in previous:
        rows = slice(first, first + len(plan.rooms))
        boxes = furnish(plan, rooms[rows], objects.rows(rows), config)
        out.append(Layout(**plan.model_dump(include=set(Plan.model_fields)), objects=boxes))
        first = rows.stop
    return out
