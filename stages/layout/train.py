"""Training of the layout model from a corpus (paper Algorithm 1, lines 1-7); seeded and resumable."""

import copy
import hashlib
import logging
import math
import os
import pickle
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.layout import curve, diffusion, precision, weights
from apartgen.stages.layout.calibration import calibrate
from apartgen.stages.layout.config import N_MAX, T, TrainConfig
from apartgen.stages.layout.corpus import Corpus, batch, read_corpus, shape_latents
from apartgen.stages.layout.features import Objects, encode
from apartgen.stages.layout.network import Denoiser
from apartgen.stages.layout.rooms import Rooms
from apartgen.stages.layout.sample import count_table

log = logging.getLogger("apartgen")
Report = Callable[[int, float], None]
FREE = {"steps", "calibrate", "device", "threads", "save_every"}
"""Settings that may differ when an interrupted run goes on."""
TOKEN_BINS = (9, 11, 14, 18)
"""Lower edges of the classes of rooms by sides and openings, which share batches."""


def learning_rate(step: int, config: TrainConfig) -> float:
    """Linear warm-up, then half a cosine down to 2 %."""
    if step < config.warmup:
        return config.lr * (step + 1) / config.warmup
    share = (step - config.warmup) / max(1, config.steps - config.warmup)
    return config.lr * (0.02 + 0.98 * 0.5 * (1 + math.cos(math.pi * min(1.0, share))))


def indices(
    corpus: Corpus, config: TrainConfig, start: int
) -> Iterator[tuple[NDArray[np.int64], int, np.random.Generator]]:
    """Room indices and slots of every step from `start`: one object count a batch, or all slots with empty ones.

    A batch has rooms of about as many sides and openings, since all pay for the most. Each step has its own
    generator, so that a resumed run repeats an unbroken one.
    """
    count, sides = corpus.count, np.digitize(corpus.rooms.tokens, TOKEN_BINS)
    groups = [(N_MAX, np.flatnonzero(sides == k)) for k in np.unique(sides)]
    shares = [config.slots_share * len(group) / len(corpus) for _, group in groups]
    for n, k in np.unique(np.stack([count, sides], 1)[count > 0], axis=0):
        groups.append((int(n), np.flatnonzero((count == n) & (sides == k))))
        shares.append((1 - config.slots_share) * len(groups[-1][1]) / (count > 0).sum())
    for step in range(start, config.steps):
        rng = np.random.default_rng([config.seed, step])
        n, group = groups[int(rng.choice(len(groups), p=np.array(shares) / sum(shares)))]
        # Fewer objects leave room for more rooms at the same cost.
        rooms = max(8, round(config.batch * min(2.0, 12 / n)))
        yield rng.choice(group, size=rooms), n, rng


def train(config: TrainConfig, out: Path, resume: bool = True, report: Report | None = None) -> dict[str, Any]:
    """Train and write `out`; a checkpoint beside it lets an interrupted run go on. Returns the training record.

    `report` is told of every step, then of every round of the calibration as further steps, with the mean loss.
    BadInput where there is no such device, or where the checkpoint is of other settings; Unmet where the loss is no
    longer finite, which leaves the last checkpoint as it was.
    """
    torch.set_num_threads(config.threads or 1)
    torch.manual_seed(config.seed)
    device = device_of(config)
    corpus, shapes = read_corpus(Path(config.corpus)), shape_latents()
    network = Denoiser(config.model).to(device)
    if config.start:
        network.load_state_dict(weights.tensors(Path(config.start))[0], strict=False)
        network.bias.zero_()
    average = copy.deepcopy(network).requires_grad_(False)
    optimizer = torch.optim.AdamW(network.parameters(), config.lr, betas=(0.9, 0.99), weight_decay=0.01)
    saved = out.with_suffix(".checkpoint")
    facts = {"corpus": digest(config.corpus), "rooms": len(corpus), "counts": count_table(corpus.rooms, corpus.count)}
    settings = config.model_dump(exclude=FREE) | {"corpus": facts["corpus"]}
    record: dict[str, Any] = {"losses": [], "step": 0}
    if resume and saved.exists():
        state = _checkpoint(saved, settings, device)
        network.load_state_dict(state["network"])
        average.load_state_dict(state["average"])
        optimizer.load_state_dict(state["optimizer"])
        record = state["record"]
    mean = record["losses"][-1][1] if record["losses"] else None
    for step, (index, slots, rng) in enumerate(indices(corpus, config, record["step"]), record["step"]):
        value = train_step(network, optimizer, corpus, index, slots, rng, shapes, config, learning_rate(step, config))
        if not math.isfinite(value):
            raise Unmet(f"training diverged: loss or gradient of step {step + 1} is not finite; what the last "
                        "checkpoint left is kept; begin anew with a lower --lr and --fresh")
        decay = min(config.ema, (1 + step) / (10 + step))
        torch._foreach_lerp_(list(average.parameters()), list(network.parameters()), 1 - decay)
        mean = value if mean is None else 0.99 * mean + 0.01 * value
        record["step"] = step + 1
        if report:
            report(step + 1, mean)
        if (step + 1) % config.save_every == 0 or step + 1 == config.steps:
            record["losses"].append([step + 1, round(mean, 5)])
            state = {
                "network": network.state_dict(),
                "average": average.state_dict(),
                "optimizer": optimizer.state_dict(),
                "record": record,
                "settings": settings,
            }
            torch.save(state, saved.with_suffix(".part"))
            saved.with_suffix(".part").replace(saved)
            weights.save(average, out, config, record | facts)
            curve.draw(record["losses"], out)
            log.info("step %d of %d: loss %.4f", step + 1, config.steps, mean)
    if config.calibrate:
        told = (lambda done: report(config.steps + done, mean or 0.0)) if report else None
        cores = config.threads or os.cpu_count() or 1
        calibrate(average.cpu().eval(), corpus, config.calibrate, config.seed, told, cores)
        weights.save(average, out, config, record | facts)
    return record


def device_of(config: TrainConfig) -> torch.device:
    """The device to train on; BadInput where torch has none of that kind."""
    if config.device != "cpu" and torch.cuda.is_available():
        return torch.device("cuda")
    if config.device == "cuda":
        raise BadInput("--device cuda: torch finds no GPU here; install its CUDA build, or leave --device away")
    return torch.device("cpu")


def _checkpoint(saved: Path, settings: dict[str, Any], device: torch.device) -> dict[str, Any]:
    """The state to go on from; BadInput where it was left by other settings."""
    try:
        state: dict[str, Any] = torch.load(saved, map_location=device, weights_only=True)
        other = [name for name, value in settings.items() if state["settings"][name] != value]
    except (OSError, RuntimeError, KeyError, EOFError, pickle.UnpicklingError) as error:
        raise BadInput(f"{saved}: no checkpoint to go on from ({error}); begin anew with --fresh") from error
    if other:
        raise BadInput(f"{saved}: left by a run with another {', '.join(other)}; begin anew with --fresh, or set --out")
    return state


def train_step(
    network: Denoiser,
    optimizer: torch.optim.Optimizer,
    corpus: Corpus,
    index: NDArray[np.int64],
    slots: int,
    rng: np.random.Generator,
    shapes: NDArray[np.float32],
    config: TrainConfig,
    lr: float,
) -> float:
    """One gradient step of Eq. 1; returns its loss, NaN where its gradient is not finite."""
    objects, rooms = batch(corpus, index, slots, rng, shapes, config)
    with precision.autocast(network.encoder.device.type, config.bf16):
        loss = step_loss(network, objects, rooms, rng, config)
    for group in optimizer.param_groups:
        group["lr"] = lr
    optimizer.zero_grad(set_to_none=True)
    loss.backward()  # type: ignore[no-untyped-call]
    norm = torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
    optimizer.step()
    return loss.item() if math.isfinite(norm.item()) else math.nan


def step_loss(
    network: Denoiser, objects: Objects, rooms: Rooms, rng: np.random.Generator, config: TrainConfig
) -> Tensor:
    """Eq. 1 of a batch at drawn t and noise, on the network's device; the same draws on any."""
    x0 = encode(objects, config.model)
    t = torch.from_numpy(rng.integers(1, T + 1, len(x0)))
    noise = torch.from_numpy(rng.standard_normal(x0.shape, np.float32))
    shift = None
    if config.anticipate > 0:
        from apartgen.stages.layout.guided import anticipation

        shift = anticipation(rooms, config)
    device = network.encoder.device
    room = network.encoder(rooms, x0.shape[1] == N_MAX)
    loss, _ = diffusion.loss(network, x0.to(device), t.to(device), noise.to(device), room, shift)
    return loss


def digest(path: str) -> str:
    """sha256 of a file, for the training record."""
    return "sha256:" + hashlib.sha256(Path(path).read_bytes()).hexdigest()
