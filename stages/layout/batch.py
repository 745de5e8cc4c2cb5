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
from typing import TYPE_CHECKING

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.projection.settle import Settled, Task, settle

if TYPE_CHECKING:
    from apartgen.stages.layout.features import Objects
    from apartgen.stages.layout.furnish import Latents
    from apartgen.stages.layout.network import Denoiser
    from apartgen.stages.layout.rooms import Rooms

log = logging.getLogger("apartgen")
MANY_ROOMS = 48
"""Fewer are done before workers would have started."""
CHUNK = 4
Spread = Callable[[Callable[[Task], Settled], Iterable[Task]], Iterator[Settled]]
Described = Callable[[int, "Rooms", "Objects", int], "tuple[Task, Latents]"]
"""What is to be placed in a room, by its index, from its row of a sampled batch."""


def furnished(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> list[Layout]:
    """The apartments furnished; no room depends on how many workers there are."""
    many = sum(len(plan.rooms) for plan in plans) >= MANY_ROOMS
    workers = (config.threads or os.cpu_count() or 1) if many else 1
    with spreading(workers) as spread:
        return _furnished(plans, config, rngs, spread, 1 if many else config.threads or 1)


@contextmanager
def spreading(workers: int) -> Iterator[Spread]:
    """A `map` that starts its work at once, on so many processes.

    They are forked, so before torch has threads; where the system has no safe fork, all is done here.
    """
    if workers == 1 or sys.platform != "linux":
        yield map
        return
    with ProcessPoolExecutor(workers, multiprocessing.get_context("fork"), _quiet) as pool:
        pool.submit(int).result()
        yield partial(pool.map, chunksize=CHUNK)


def placed(
    network: "Denoiser",
    rooms: "Rooms",
    config: LayoutConfig,
    lanes: list[np.random.Generator],
    task: "Described",
    spread: Spread,
) -> "Iterator[tuple[int, Settled, Latents]]":
    """Rooms of known count, sampled and settled, in any order: index, objects and shape latents."""
    from apartgen.stages.layout import furnish
    from apartgen.stages.layout.sample import sample

    # A batch pays for its fullest room, so rooms alike share one; the fullest first, as they take longest to settle.
    order, work = np.lexsort([rooms.tokens, rooms.count])[::-1], []
    for index in np.split(order, range(config.batch, len(order), config.batch)):
        chosen = rooms[index]
        objects = sample(network, chosen, config, [lanes[i] for i in index])
        tasks = [task(int(i), chosen, objects, k) for k, i in enumerate(index)]
        place = (
            spread(settle, [one for one, _ in tasks])
            if config.projection
            else map(furnish.as_sampled, [one for one, _ in tasks])
        )
        work.append((index, [latents for _, latents in tasks], place))
    for index, latents, done in work:
        for i, shapes, settled in zip(index, latents, done, strict=True):
            yield int(i), settled, shapes


def _quiet() -> None:
    """Being interrupted is the caller's business."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _furnished(
    plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator], spread: Spread, threads: int
) -> list[Layout]:
    import torch

    from apartgen.stages.layout import furnish, weights, wishes
    from apartgen.stages.layout import rooms as room_arrays
    from apartgen.stages.layout.sample import draw_counts

    torch.set_num_threads(threads)
    network, record = weights.load(Path(config.weights) if config.weights else None)
    spawned = [rng.spawn(len(plan.rooms) + 1) for plan, rng in zip(plans, rngs, strict=True)]
    lanes = [lane for *own, _ in spawned for lane in own]
    parts = [room_arrays.of_plan(plan, home.random()) for plan, (*_, home) in zip(plans, spawned, strict=True)]
    rooms = room_arrays.Rooms(
        **{f.name: np.concatenate([getattr(part, f.name) for part in parts]) for f in fields(room_arrays.Rooms)}
    )
    whose = [(plan, room) for plan in plans for room in plan.rooms]
    at_home = np.array([len(plan.rooms) > 1 for plan, _ in whose])
    rooms.count = draw_counts(rooms, record["counts"], lanes, at_home)
    boxes = {}
    for i, settled, shapes in placed(
        network, rooms, config, lanes, lambda i, *row: furnish.of_plan(*whose[i], *row), spread
    ):
        boxes[i] = furnish.boxes(whose[i][1], settled, shapes, rooms.origin[i])
        plan, room = whose[i]
        for note in settled.notes:
            log.info("%s: %s", room.id, note, extra={"body": plan})
        if lacks := wishes.unmet(plan.program, room.id, boxes[i]):
            log.info("%s: has %s", room.id, "; ".join(lacks), extra={"body": plan})
    rows = iter(range(len(whose)))
    return [
        Layout(
            **plan.model_dump(include=set(Plan.model_fields)),
            objects=[box for _, i in zip(plan.rooms, rows) for box in boxes[i]],
        )
        for plan in plans
    ]
