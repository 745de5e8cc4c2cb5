"""Homes are furnished each by itself, several at once where there are cores; rooms of a corpus in batches."""

import logging
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from apartgen.schemas.errors import need_torch
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen.stages import seeds
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
Spread = Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[Any]]
Described = Callable[[int, "Rooms", "Objects", int], "tuple[Task, Latents]"]
"""What is to be placed in a room, by its index, from its row of a sampled batch."""


def furnished(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> Iterator[Layout]:
    """The apartments furnished in turn; none depends on the others, nor on how many workers there are."""
    many = len(plans) > 1 and sum(len(plan.rooms) for plan in plans) >= MANY_ROOMS
    with spreading((config.threads or os.cpu_count() or 1) if many else 1) as spread:
        for plan, (home, notes) in zip(plans, spread(partial(_furnished, config), zip(plans, rngs, strict=True))):
            for note in notes:
                log.info(note, extra={"body": plan})
            yield home


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


def _furnished(config: LayoutConfig, home: tuple[Plan, np.random.Generator]) -> tuple[Layout, list[str]]:
    """One apartment by the model that was asked for, and what is to be said about it."""
    if config.model == "diffusion":
        need_torch("--model diffusion")
        return _denoised(config, home)
    from apartgen.stages.layout.relations.home import furnished

    plan, rng = home
    given = plan.objects if isinstance(plan, Layout) and (config.keep or config.room) else []
    return furnished(plan, config, rng, given)


def _denoised(config: LayoutConfig, home: tuple[Plan, np.random.Generator]) -> tuple[Layout, list[str]]:
    """One apartment out of noise; every room draws from the lane of its name."""
    import torch

    from apartgen.stages.layout import furnish, newcomers, weights, wishes
    from apartgen.stages.layout import rooms as room_arrays
    from apartgen.stages.layout.sample import draw_counts

    torch.set_num_threads(1)  # sums over several threads are rounded differently
    plan, rng = home
    network, record = weights.load(Path(config.weights) if config.weights else None)
    lanes = [seeds.lane(rng, room.id) for room in plan.rooms]
    rooms = room_arrays.of_plan(plan, seeds.lane(rng, "home").random())
    rooms.count = draw_counts(rooms, record["counts"], lanes, np.full(len(plan.rooms), len(plan.rooms) > 1))
    boxes, notes = {}, []
    made = placed(network, rooms, config, lanes, lambda i, *row: furnish.of_plan(plan, plan.rooms[i], *row), map)
    for i, settled, shapes in made:
        room = plan.rooms[i]
        wished = wishes.of_room(plan.program, room.id)
        boxes[i] = newcomers.named(furnish.boxes(room, settled, shapes, rooms.origin[i]), wished)
        notes += [f"{room.id}: {note}" for note in settled.notes]
        if lacks := wishes.unmet(plan.program, room.id, boxes[i]):
            notes.append(f"{room.id}: has {'; '.join(lacks)}")
    objects = [box for i in range(len(plan.rooms)) for box in boxes[i]]
    return Layout(**plan.model_dump(include=set(Plan.model_fields)), objects=objects), notes
