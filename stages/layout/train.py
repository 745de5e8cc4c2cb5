"""Training of the layout model from a corpus (paper Algorithm 1, lines 1-7); seeded and resumable."""

import copy
import hashlib
import logging
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from stages.layout import diffusion, weights
from stages.layout.calibration import calibrate
from stages.layout.config import N_MAX, T, TrainConfig
from stages.layout.corpus import Corpus, batch, read_corpus, shape_latents
from stages.layout.features import encode
from stages.layout.network import Denoiser
from stages.layout.sample import count_table

log = logging.getLogger("apartgen")
Report = Callable[[int, float], None]
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
    """
    torch.set_num_threads(config.threads)
    torch.manual_seed(config.seed)
    corpus, shapes = read_corpus(Path(config.corpus)), shape_latents()
    network = Denoiser(config.model)
    if config.start:
        network.load_state_dict(weights.tensors(Path(config.start))[0], strict=False)
        network.bias.zero_()
    average = copy.deepcopy(network).requires_grad_(False)
    optimizer = torch.optim.AdamW(network.parameters(), config.lr, betas=(0.9, 0.99), weight_decay=0.01)
    saved = out.with_suffix(".checkpoint")
    record: dict[str, Any] = {"losses": [], "step": 0}
    if resume and saved.exists():
        state = torch.load(saved, weights_only=True)
        network.load_state_dict(state["network"])
        average.load_state_dict(state["average"])
        optimizer.load_state_dict(state["optimizer"])
        record = state["record"]
    facts = {"corpus": digest(config.corpus), "rooms": len(corpus), "counts": count_table(corpus.rooms, corpus.count)}
    mean = record["losses"][-1][1] if record["losses"] else None
    for step, (index, slots, rng) in enumerate(indices(corpus, config, record["step"]), record["step"]):
        value = train_step(network, optimizer, corpus, index, slots, rng, shapes, config, learning_rate(step, config))
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
            }
            torch.save(state, saved.with_suffix(".part"))
            saved.with_suffix(".part").replace(saved)
            weights.save(average, out, config, record | facts)
            log.info("step %d of %d: loss %.4f", step + 1, config.steps, mean)
    if config.calibrate:
        told = (lambda done: report(config.steps + done, mean or 0.0)) if report else None
        calibrate(average.eval(), corpus, config.calibrate, config.seed, told)
        weights.save(average, out, config, record | facts)
    return record


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
    """One gradient step of Eq. 1; returns its loss."""
    objects, rooms = batch(corpus, index, slots, rng, shapes, config)
    x0 = encode(objects, config.model)
    t = torch.from_numpy(rng.integers(1, T + 1, len(x0)))
    noise = torch.from_numpy(rng.standard_normal(x0.shape, np.float32))
    for group in optimizer.param_groups:
        group["lr"] = lr
    shift = None
    if config.anticipate > 0:
        from stages.layout.guided import anticipation

        shift = anticipation(rooms, config)
    with torch.autocast("cpu", torch.bfloat16, enabled=config.bf16):
        room = network.encoder(rooms, slots == N_MAX)
        value: Tensor = diffusion.loss(network, x0, t, noise, room, shift)[0]
    optimizer.zero_grad(set_to_none=True)
    value.backward()  # type: ignore[no-untyped-call]
    torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
    optimizer.step()
    return value.item()


def digest(path: str) -> str:
    """sha256 of a file, for the training record."""
    return "sha256:" + hashlib.sha256(Path(path).read_bytes()).hexdigest()
