"""Training of the shape autoencoder on the embedded library: seeded, resumable, minutes on one core."""

import json
import logging
import shutil
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import torch
from numpy.typing import NDArray
from safetensors.torch import save_file

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.shape import catalogue
from apartgen.stages.retrieve.shape.config import ShapeTraining
from apartgen.stages.retrieve.shape.designs import Maker, drawn, embedded_maker, fields
from apartgen.stages.retrieve.shape.vae import LATENT, Batch, ShapeVAE, Weights, loss
from apartgen.stages.things.latents import INDEX

LOG = logging.getLogger("apartgen")


class Pieces(NamedTuple):
    """Fields (n, FEATURES), category and style of each piece."""

    fields: NDArray[np.float32]
    category: NDArray[np.str_]
    style: NDArray[np.str_]


def train(config: ShapeTraining, out: Path, resume: bool = True, maker: Maker | None = None) -> dict[str, Any]:
    """Writes the weights to `out` and the library's index beside it; returns the training record.

    What a broken-off run left beside `out` is gone on from, or with `resume` false thrown away.
    """
    started = time.process_time()
    maker = maker or embedded_maker()
    work = out.with_name(f"{out.stem}.work")
    if not resume:
        shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True, exist_ok=True)
    pieces = _pieces(config, work, maker)
    model, record = _fit(config, _whole(pieces), work)
    record |= {"assets": len(pieces.fields), "parameters": sum(p.numel() for p in model.parameters())}
    record |= {"cpu_seconds": round(time.process_time() - started, 1)}
    _save(model, pieces, config, record, out)
    catalogue.write(maker, out.with_name(INDEX.name), out)
    shutil.rmtree(work)
    return record


def _pieces(config: ShapeTraining, work: Path, maker: Maker) -> Pieces:
    kept = work / f"pieces-{config.seed}-{config.variants}.npz"
    if kept.exists():
        with np.load(kept) as arrays:
            return Pieces(**arrays)
    LOG.info("building the pieces to learn from")
    designs = list(drawn(maker, config.variants, np.random.default_rng(config.seed)))
    made = Pieces(fields(maker, designs), np.array([d.category for d in designs]), np.array([d.style for d in designs]))
    np.savez(kept, **made._asdict())
    return made


def _whole(pieces: Pieces) -> Batch:
    """All pieces as one batch."""
    names, style = np.unique([f"{c}/{s}" for c, s in zip(pieces.category, pieces.style)], return_inverse=True)
    category = np.array([name.partition("/")[0] for name in names])
    rivals = torch.from_numpy(category[style][:, None] == category[None])
    return Batch(torch.from_numpy(pieces.fields), torch.from_numpy(style), rivals)


def _fit(config: ShapeTraining, data: Batch, work: Path) -> tuple[ShapeVAE, dict[str, Any]]:
    torch.manual_seed(config.seed)
    model = ShapeVAE(data.rivals.shape[1])
    optimizer = torch.optim.AdamW(model.parameters(), config.rate, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, config.epochs)
    parts: dict[str, Any] = {"model": model, "optimizer": optimizer, "schedule": schedule}
    kept = work / "checkpoint.pt"
    first, record = _resume(parts, kept, config)
    for epoch in range(first, config.epochs):
        record = _epoch(model, optimizer, data, config, epoch)
        schedule.step()
        LOG.info("shape epoch %d of %d: %s", epoch + 1, config.epochs, record)
        states = {name: part.state_dict() for name, part in parts.items()}
        about = {"epoch": epoch + 1, "record": record, "config": config.model_dump()}
        torch.save(states | about, kept.with_suffix(".new"))
        kept.with_suffix(".new").replace(kept)
    return model, record


def _resume(parts: dict[str, Any], kept: Path, config: ShapeTraining) -> tuple[int, dict[str, Any]]:
    if not kept.exists():
        return 0, {}
    state = torch.load(kept, weights_only=True)
    if state["config"] != config.model_dump():
        raise BadInput(f"{kept}: from a run with other settings; give those, or begin afresh with --fresh")
    for name, part in parts.items():
        part.load_state_dict(state[name])
    return int(state["epoch"]), dict(state["record"])


def _epoch(
    model: ShapeVAE, optimizer: torch.optim.Optimizer, data: Batch, config: ShapeTraining, epoch: int
) -> dict[str, Any]:
    # One stream per epoch, so that a resumed run draws what an unbroken one would have.
    stream = torch.Generator().manual_seed(config.seed * 100_003 + epoch)
    sums: dict[str, float] = {}
    weights = Weights(config.beta, config.color_weight, config.style_weight)
    batches = torch.split(torch.randperm(len(data.fields), generator=stream), config.batch)
    for rows in batches:
        noise = torch.randn(len(rows), LATENT, generator=stream)
        total, terms = loss(model, Batch(*(part[rows] for part in data)), weights, noise)
        optimizer.zero_grad()
        total.backward()  # type: ignore[no-untyped-call]
        optimizer.step()
        sums = {name: sums.get(name, 0.0) + value for name, value in terms.items()}
    return {"epochs": epoch + 1} | {name: round(value / len(batches), 3) for name, value in sums.items()}


def _save(model: ShapeVAE, pieces: Pieces, config: ShapeTraining, record: dict[str, Any], out: Path) -> None:
    with torch.no_grad():
        mean, _ = model.posterior(torch.from_numpy(pieces.fields))
    record = record | {"active_dimensions": int((mean.var(0) > 0.01).sum().item())}
    tensors = {name: tensor.half() for name, tensor in model.state_dict().items() if not name.startswith("style")}
    tensors |= {"latent.mean": mean.mean(0), "latent.std": mean.std(0).clamp(min=1e-6)}
    header = {"config": config.model_dump(), "record": record}
    out.parent.mkdir(parents=True, exist_ok=True)
    whole = {name: tensor.contiguous() for name, tensor in tensors.items()}
    save_file(whole, out, metadata={"apartgen": json.dumps(header, sort_keys=True)})
    out.chmod(0o644)
