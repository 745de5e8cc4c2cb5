"""Many rooms at once: batches are sampled here while workers put the objects of earlier ones in their places."""

import logging
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import fields
from functools import partial
from pathlib import Path

import numpy as np

from schemas.layout import Layout
from schemas.plan import Plan
from stages.layout.config import LayoutConfig
from stages.layout.projection.settle import Settled, Task, settle

log = logging.getLogger("apartgen")
MANY_ROOMS = 48
"""Fewer are done before workers would have started."""
CHUNK = 4
Spread = Callable[[Callable[[Task], Settled], Iterable[Task]], Iterator[Settled]]


def furnished(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> list[Layout]:
    """The apartments furnished; no room depends on how many workers there are."""
    many = sum(len(plan.rooms) for plan in plans) >= MANY_ROOMS
    workers = (config.threads or os.cpu_count() or 1) if many else 1
    # Workers are forked before torch has threads; where the system has no safe fork, all is done here.
    with _spread(workers if sys.platform == "linux" else 1) as spread:
        return _furnished(plans, config, rngs, spread, 1 if many else config.threads or 1)


@contextmanager
def _spread(workers: int) -> Iterator[Spread]:
    """A `map` that starts its work at once, on so many processes."""
    if workers == 1:
        yield map
        return
    with ProcessPoolExecutor(workers, multiprocessing.get_context("fork"), _quiet) as pool:
        pool.submit(int).result()
        yield partial(pool.map, chunksize=CHUNK)


def _quiet() -> None:
    """Being interrupted is the caller's business."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _furnished(
    plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator], spread: Spread, threads: int
) -> list[Layout]:
    import torch

    from stages.layout import furnish, weights
    from stages.layout import rooms as room_arrays
    from stages.layout.sample import draw_counts, sample

    torch.set_num_threads(threads)
    network, record = weights.load(Path(config.weights) if config.weights else None)
    parts = [room_arrays.of_plan(plan) for plan in plans]
    rooms = room_arrays.Rooms(
        **{f.name: np.concatenate([getattr(part, f.name) for part in parts]) for f in fields(room_arrays.Rooms)}
    )
    lanes = [lane for plan, rng in zip(plans, rngs, strict=True) for lane in rng.spawn(len(plan.rooms))]
    whose = [(plan, room) for plan in plans for room in plan.rooms]
    at_home = np.array([len(plan.rooms) > 1 for plan, _ in whose])
    rooms.count = draw_counts(rooms, record["counts"], lanes, at_home)
    # A batch pays for its fullest room, so rooms alike share one; the fullest first, as they take longest to settle.
    order, work = np.lexsort([rooms.tokens, rooms.count])[::-1], []
    for index in np.split(order, range(config.batch, len(order), config.batch)):
        chosen = rooms[index]
        objects = sample(network, chosen, config, [lanes[i] for i in index])
        tasks = [furnish.task(whose[i][0], whose[i][1], chosen, objects, k) for k, i in enumerate(index)]
        place = spread(settle, [task for task, _ in tasks]) if config.projection else map(
            furnish.as_sampled, [task for task, _ in tasks])
        work.append((index, [latents for _, latents in tasks], place))
    boxes = {}
    for index, latents, done in work:
        for i, shapes, settled in zip(index, latents, done, strict=True):
            boxes[i] = furnish.boxes(whose[i][1], settled, shapes, rooms.origin[i])
            for note in settled.notes:
                log.info("%s: %s", whose[i][1].id, note)
    rows = iter(range(len(whose)))
    return [
        Layout(
            **plan.model_dump(include=set(Plan.model_fields)),
            objects=[box for _, i in zip(plan.rooms, rows) for box in boxes[i]],
        )
        for plan in plans
    ]
