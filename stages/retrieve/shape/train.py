"""Training of the shape autoencoder on the embedded library: seeded, resumable, minutes on one core."""

import json
import logging
import time
from pathlib import Path
from typing import Any, cast

import numpy as np
import torch
from numpy.typing import NDArray
from pydantic import Field
from safetensors.torch import save_file

from schemas.base import Record
from stages.retrieve.shape.designs import Maker, drawn, embedded_maker, fields
from stages.retrieve.shape.vae import ShapeVAE, loss

LOG = logging.getLogger("apartgen")


class ShapeTraining(Record):
    """How the autoencoder is trained; travels in the weights' header."""

    seed: int = 0
    variants: int = Field(12, ge=1, description="pieces of every style to learn from")
    epochs: int = Field(60, ge=1)
    batch: int = Field(64, ge=2)
    rate: float = Field(2e-3, gt=0)
    beta: float = Field(0.3, ge=0, description="weight of the divergence from the prior")
    color_weight: float = Field(4.0, ge=0)


def train(config: ShapeTraining, out: Path, work: Path | None = None, maker: Maker | None = None) -> dict[str, Any]:
    """Writes the weights to `out` and returns the training record; `work` keeps what is needed to resume."""
    started = time.process_time()
    data = _data(config, work, maker)
    model, record = _fit(config, torch.from_numpy(data), work)
    record |= {"assets": len(data), "parameters": sum(p.numel() for p in model.parameters())}
    record |= {"cpu_seconds": round(time.process_time() - started, 1)}
    _save(model, data, config, record, out)
    return record


def _data(config: ShapeTraining, work: Path | None, maker: Maker | None) -> NDArray[np.float32]:
    kept = work / "fields.npy" if work else None
    if kept and kept.exists():
        return cast(NDArray[np.float32], np.load(kept))
    if maker is None:
        maker = embedded_maker()
    LOG.info("building the pieces to learn from")
    data = fields(maker, drawn(maker, config.variants, np.random.default_rng(config.seed)))
    if kept:
        kept.parent.mkdir(parents=True, exist_ok=True)
        np.save(kept, data)
    return data


def _fit(config: ShapeTraining, data: torch.Tensor, work: Path | None) -> tuple[ShapeVAE, dict[str, Any]]:
    torch.manual_seed(config.seed)
    model = ShapeVAE()
    optimizer = torch.optim.AdamW(model.parameters(), config.rate, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, config.epochs)
    parts: dict[str, Any] = {"model": model, "optimizer": optimizer, "schedule": schedule}
    first, record = _resume(parts, work)
    for epoch in range(first, config.epochs):
        record = _epoch(model, optimizer, data, config, epoch)
        schedule.step()
        LOG.info("shape epoch %d of %d: %s", epoch + 1, config.epochs, record)
        if work:
            torch.save({name: part.state_dict() for name, part in parts.items()} | {"epoch": epoch + 1, "record": record},
                       work / "checkpoint.pt")
    return model, record


def _resume(parts: dict[str, Any], work: Path | None) -> tuple[int, dict[str, Any]]:
    if work is None or not (work / "checkpoint.pt").exists():
        return 0, {}
    state = torch.load(work / "checkpoint.pt", weights_only=True)
    for name, part in parts.items():
        part.load_state_dict(state[name])
    return int(state["epoch"]), dict(state["record"])


def _epoch(model: ShapeVAE, optimizer: torch.optim.Optimizer, data: torch.Tensor, config: ShapeTraining,
           epoch: int) -> dict[str, Any]:
    # One stream per epoch, so that a resumed run draws what an unbroken one would have.
    stream = torch.Generator().manual_seed(config.seed * 100_003 + epoch)
    sums = dict.fromkeys(("shape", "color", "divergence"), 0.0)
    batches = torch.split(torch.randperm(len(data), generator=stream), config.batch)
    for rows in batches:
        noise = torch.randn(len(rows), 32, generator=stream)
        total, terms = loss(model, data[rows], config.beta, config.color_weight, noise)
        optimizer.zero_grad()
        total.backward()  # type: ignore[no-untyped-call]
        optimizer.step()
        for name, value in terms.items():
            sums[name] += value
    return {"epochs": epoch + 1} | {name: round(value / len(batches), 3) for name, value in sums.items()}


def _save(model: ShapeVAE, data: NDArray[np.float32], config: ShapeTraining, record: dict[str, Any], out: Path) -> None:
    with torch.no_grad():
        mean, _ = model.posterior(torch.from_numpy(data))
    active = (mean.var(0) > 0.01).sum().item()
    tensors = {name: tensor.half() for name, tensor in model.state_dict().items()}
    tensors |= {"latent.mean": mean.mean(0), "latent.std": mean.std(0).clamp(min=1e-6)}
    header = {"config": config.model_dump(), "record": record | {"active_dimensions": active}}
    out.parent.mkdir(parents=True, exist_ok=True)
    save_file({name: tensor.contiguous() for name, tensor in tensors.items()}, out,
              metadata={"apartgen": json.dumps(header, sort_keys=True)})
