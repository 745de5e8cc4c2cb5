"""Weights with their configuration and training record, in one safetensors file."""

import json
from functools import lru_cache
from pathlib import Path
from typing import Any

from safetensors import SafetensorError, safe_open
from safetensors.torch import save_file

from schemas.errors import BadInput
from stages.categories import CATEGORIES
from stages.layout.config import TrainConfig
from stages.layout.network import Denoiser

SHIPPED = Path(__file__).parent / "weights.safetensors"


def save(network: Denoiser, path: Path, config: TrainConfig, record: dict[str, Any]) -> None:
    """Write half-precision weights; the header holds config, categories and `record`."""
    tensors = {name: value.detach().half().contiguous() for name, value in network.state_dict().items()}
    header = {"config": config.model_dump_json(), "categories": json.dumps(CATEGORIES), "record": json.dumps(record)}
    part = path.with_suffix(".part")
    save_file(tensors, part, header)
    part.replace(path)


def load(path: Path | None = None) -> tuple[Denoiser, dict[str, Any]]:
    """The network, ready for sampling, and its training record."""
    return _load(str(path or SHIPPED))


@lru_cache(maxsize=2)
def _load(path: str) -> tuple[Denoiser, dict[str, Any]]:
    try:
        with safe_open(path, "pt") as file:
            header = file.metadata() or {}
            tensors = {name: file.get_tensor(name).float() for name in file.keys()}  # noqa: SIM118
        config = TrainConfig.model_validate_json(header["config"])
    except (OSError, SafetensorError, KeyError, ValueError) as error:
        raise BadInput(f"{path}: no layout weights ({error}); train some with `apartgen train layout`") from error
    if json.loads(header["categories"]) != list(CATEGORIES):
        raise BadInput(f"{path}: made for another furniture vocabulary; train again with `apartgen train layout`")
    network = Denoiser(config.model)
    network.load_state_dict(tensors)
    return network.eval().requires_grad_(False), json.loads(header["record"])
