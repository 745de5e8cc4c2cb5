"""Fits the relations model to a corpus; a run that was interrupted goes on from its checkpoint."""

import copy
import logging
import math
import pickle
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import torch
import torch.utils.data
from numpy.typing import NDArray

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.layout import curve, precision
from apartgen.stages.layout.relations import (
    contents,
    corpus,
    learning,
    losses,
    network_contents,
    order,
    trained,
    weights,
)
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.corpus import Furnished
from apartgen.stages.layout.relations.tokens import Ints
from apartgen.stages.layout.train import digest
from apartgen.stages.things.categories import CATEGORIES, TABLE

log = logging.getLogger("apartgen")
Report = Callable[[int, float], None]
FREE = {"threads", "workers", "device", "save_every", "corpus"}
"""What may change between a run and its going on."""
HUNG = np.array([TABLE[name].place in ("wall", "top") for name in CATEGORIES])
"""Whose height is spoken; the rest stand on the floor or hang from the ceiling."""


def learning_rate(step: int, config: Training) -> float:
    """Linear warm-up, then half a cosine down to 2 %."""
    if step < config.warmup:
        return config.lr * (step + 1) / config.warmup
    share = (step - config.warmup) / max(1, config.steps - config.warmup)
    return config.lr * (0.02 + 0.98 * 0.5 * (1 + math.cos(math.pi * min(1.0, share))))


class BySize(NamedTuple):
    """Rooms in the order of how many tokens they have, and how many objects they and those before them hold."""

    order: Ints
    worth: NDArray[np.float64]


def by_size(rooms: list[Furnished]) -> BySize:
    """Rooms by size."""
    order_ = np.argsort([len(room.kind) for room in rooms], kind="stable")
    return BySize(order_, np.array([rooms[i].n for i in order_], float).cumsum())


def chosen(rooms: list[Furnished], sizes: BySize, config: Training,
           step: int) -> tuple[list[Furnished], np.random.Generator]:
    """The rooms of a step, alike in size, since all pay for the largest; each step has a generator of its own, so that
    a resumed run repeats an unbroken one."""
    window = 6 * config.batch
    rng = np.random.default_rng([config.seed, step])
    middle = int(np.searchsorted(sizes.worth, rng.random() * sizes.worth[-1]))
    first = int(np.clip(middle - window // 2, 0, max(0, len(rooms) - window)))
    some = sizes.order[first : first + window]
    picked = rng.choice(some, size=min(config.batch, len(some)), replace=False)
    return [rooms[i] for i in picked], rng


@dataclass
class Step:
    """All that one step asks of the model."""

    scene: learning.Scene
    frames: learning.Frames
    listed: network_contents.Listed


def asked(rooms: list[Furnished], objects: int, rng: np.random.Generator, hung: NDArray[np.bool_]) -> Step:
    """What a step asks of some rooms."""
    of = learning.batch(rooms, len(CATEGORIES), rng)
    rows, which = np.nonzero(of.said)
    some = np.sort(rng.choice(len(rows), size=min(objects, len(rows)), replace=False))
    held = [(room.type, _facts(room, rng), _counts(room)) for room in rooms]
    return Step(learning.scene(of), learning.frames(of, rows[some], which[some], hung),
                network_contents.listed(held, order.ranks(), rng))


def step_losses(model: trained.Model, step: Step, device: str = "cpu") -> dict[str, torch.Tensor]:
    """All losses of one step by name."""
    on = losses.onto(step, device)
    return losses.scene(model.places, on.scene) | losses.frames(model.places, on.frames) | {
        "contents": network_contents.loss(model.contents, on.listed)}


class Steps(torch.utils.data.Dataset[Step]):
    """What every step asks, by its number."""

    def __init__(self, rooms: list[Furnished], config: Training) -> None:
        self.rooms, self.config = rooms, config
        self.sizes = by_size(rooms)

    def __len__(self) -> int:
        return self.config.steps

    def __getitem__(self, step: int) -> Step:
        some, rng = chosen(self.rooms, self.sizes, self.config, step)
        return asked(some, self.config.objects, rng, HUNG)


def steps(rooms: list[Furnished], config: Training, start: int) -> Iterator[Step]:
    """What the steps from `start` ask, in order; the same whoever prepares it."""
    if config.workers:
        # A step has more tensors than a process may have open files.
        torch.multiprocessing.set_sharing_strategy("file_system")  # type: ignore[no-untyped-call]
    loader = torch.utils.data.DataLoader(Steps(rooms, config), batch_size=None, sampler=range(start, config.steps),
                                         num_workers=config.workers, prefetch_factor=4 if config.workers else None)
    return iter(loader)


def _facts(room: Furnished, rng: np.random.Generator) -> NDArray[np.float32]:
    """What its contents are told of a room, in some without who lives there and what it is for."""
    told = rng.random(1 + len(room.duties)) > learning.UNTOLD
    people, *duties = np.where(told, [room.sleepers, *room.duties], -1).tolist()
    return contents.facts(room.boxes, room.kind, room.area, people, duties)


def _counts(room: Furnished) -> Ints:
    return np.bincount(room.category[room.shell :], minlength=len(CATEGORIES))


def train(config: Training, out: Path, resume: bool = True, report: Report | None = None) -> dict[str, Any]:
    """Train and write `out`; a checkpoint beside it lets an interrupted run go on. Returns the training record.

    BadInput where the checkpoint is of other settings; Unmet where the loss is no longer finite.
    """
    torch.set_num_threads(config.threads)
    rooms, held = _parted([room for room in corpus.read(Path(config.corpus), config.workers) if room.n], config)
    model = trained.empty(config).to(config.device)
    if config.start:
        model.load_state_dict(trained.tensors(Path(config.start)), strict=False)
    average = copy.deepcopy(model).requires_grad_(False)
    optimizer = torch.optim.AdamW(model.parameters(), config.lr, betas=(0.9, 0.98), weight_decay=0.01)
    facts: dict[str, Any] = {"corpus": digest(config.corpus), "rooms": len(rooms), "held": len(held)}
    if config.start:
        facts["start"] = {"weights": digest(config.start)} | weights.history(Path(config.start))
    settings = config.model_dump(exclude=FREE) | {"corpus": facts["corpus"]}
    saved = out.with_suffix(".checkpoint")
    record: dict[str, Any] = {"losses": [], "step": 0}
    if resume and saved.exists():
        record = _resumed(saved, settings, model, average, optimizer)
    mean: dict[str, float] = record.get("by_name", {})
    for step, told in enumerate(steps(rooms, config, record["step"]), record["step"]):
        value = train_step(model, optimizer, told, config, learning_rate(step, config))
        if not math.isfinite(sum(value.values())):
            raise Unmet(f"training diverged in step {step + 1}; begin anew with a lower --lr and --fresh")
        decay = min(config.ema, (1 + step) / (10 + step))
        torch._foreach_lerp_(list(average.parameters()), list(model.parameters()), 1 - decay)
        mean = {name: 0.98 * mean.get(name, v) + 0.02 * v for name, v in value.items()} | {
            name: v for name, v in mean.items() if name not in value}
        record |= {"step": step + 1, "by_name": {name: round(v, 4) for name, v in sorted(mean.items())}}
        if report:
            report(step + 1, sum(mean.values()))
        if (step + 1) % config.save_every == 0 or step + 1 == config.steps:
            record["losses"].append([step + 1, round(sum(mean.values()), 4)] + _looked_at(average, held, config))
            state = {"model": model.state_dict(), "average": average.state_dict(), "optimizer": optimizer.state_dict(),
                     "record": record, "settings": settings}
            torch.save(state, saved.with_suffix(".part"))
            saved.with_suffix(".part").replace(saved)
            trained.save(average, out, config, record | facts)
            curve.draw(record["losses"], out)
            log.info("step %d of %d: loss %.3f", step + 1, config.steps, sum(mean.values()))
    return record


def _parted(rooms: list[Furnished], config: Training) -> tuple[list[Furnished], list[Furnished]]:
    """Rooms to learn from, and those that are only looked at: the last, which are of other homes than the rest."""
    if config.held >= len(rooms):
        raise BadInput(f"--held {config.held}: {config.corpus} has {len(rooms)} rooms; hold fewer of them out")
    return rooms[: len(rooms) - config.held], rooms[len(rooms) - config.held :]


def _looked_at(model: trained.Model, held: list[Furnished], config: Training) -> list[float]:
    """[Loss on rooms that were not learned from], the same draws every time; nothing where there are none."""
    if not held:
        return []
    alike, total, worth = sorted(held, key=lambda room: len(room.kind)), 0.0, 0
    with torch.inference_mode(), precision.autocast(config.device, config.bf16):
        for first in range(0, len(alike), config.batch):
            some = alike[first : first + config.batch]
            told = asked(some, config.objects, np.random.default_rng([config.seed, first]), HUNG)
            total += sum(value.item() for value in step_losses(model, told, config.device).values()) * len(some)
            worth += len(some)
    return [round(total / worth, 4)]


def train_step(model: trained.Model, optimizer: torch.optim.Optimizer, step: Step, config: Training,
               lr: float) -> dict[str, float]:
    """One gradient step; its losses by name."""
    with precision.autocast(config.device, config.bf16):
        found = step_losses(model, step, config.device)
    for group in optimizer.param_groups:
        group["lr"] = lr
    optimizer.zero_grad(set_to_none=True)
    each = torch.stack(list(found.values()))
    each.sum().backward()  # type: ignore[no-untyped-call]
    torch.nn.utils.clip_grad_norm_(model.parameters(), 1.0)
    optimizer.step()
    return dict(zip(found, each.tolist(), strict=True))


def _resumed(saved: Path, settings: dict[str, Any], model: trained.Model, average: trained.Model,
             optimizer: torch.optim.Optimizer) -> dict[str, Any]:
    """The record to go on from; BadInput where the checkpoint was left by other settings."""
    try:
        state: dict[str, Any] = torch.load(saved, map_location=next(model.parameters()).device, weights_only=True)
        other = [name for name, value in settings.items() if state["settings"][name] != value]
    except (OSError, RuntimeError, KeyError, EOFError, pickle.UnpicklingError) as error:
        raise BadInput(f"{saved}: no checkpoint to go on from ({error}); begin anew with --fresh") from error
    if other:
        raise BadInput(f"{saved}: left by a run with another {', '.join(other)}; begin anew with --fresh, or set --out")
    model.load_state_dict(state["model"])
    average.load_state_dict(state["average"])
    optimizer.load_state_dict(state["optimizer"])
    record: dict[str, Any] = state["record"]
    return record
