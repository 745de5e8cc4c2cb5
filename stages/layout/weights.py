"""Weights with their configuration and training record, in one safetensors file."""

import json
from functools import lru_cache
from pathlib import Path
from typing import Any

from safetensors import SafetensorError, safe_open
from safetensors.torch import save_file
from torch import Tensor

from apartgen.schemas.errors import BadInput
from apartgen.stages.layout.config import TrainConfig
from apartgen.stages.layout.network import Denoiser
from apartgen.stages.things.categories import CATEGORIES

SHIPPED = Path(__file__).parent / "weights.safetensors"


def save(network: Denoiser, path: Path, config: TrainConfig, record: dict[str, Any]) -> None:
    """Write half-precision weights; the header holds config, categories and `record`."""
    halves = {name: value.detach().half().contiguous() for name, value in network.state_dict().items()}
    named = config.model_copy(
        update={"corpus": Path(config.corpus).name, "start": config.start and Path(config.start).name}
    )
    header = {"config": named.model_dump_json(), "categories": json.dumps(CATEGORIES), "record": json.dumps(record)}
    part = path.with_suffix(".part")
    save_file(halves, part, header)
    part.replace(path)


def load(path: Path | None = None) -> tuple[Denoiser, dict[str, Any]]:
    """The network, ready for sampling, and its training record."""
    return _load(str(path or SHIPPED))


def _remedy(known: set[str]) -> str:
    new = sorted(set(CATEGORIES) - known)
    own = f"say in categories.toml what {', '.join(new)} is like, or " if new else ""
    return f"{own}train again with `apartgen train layout`"


def tensors(path: Path) -> tuple[dict[str, Tensor], dict[str, str]]:
    """Parameters by name, and the header; BadInput where there are none for this vocabulary."""
    try:
        with safe_open(path, "pt") as file:
            header = file.metadata() or {}
            found = {name: file.get_tensor(name).float() for name in file.keys()}  # noqa: SIM118
        known = json.loads(header["categories"])
    except (OSError, SafetensorError, KeyError, ValueError) as error:
        raise BadInput(f"{path}: no layout weights ({error}); train some with `apartgen train layout`") from error
    if known != list(CATEGORIES):
        raise BadInput(f"{path}: made for another furniture vocabulary; {_remedy(set(known))}")
    return found, header


@lru_cache(maxsize=2)
def _load(path: str) -> tuple[Denoiser, dict[str, Any]]:
    found, header = tensors(Path(path))
    network = Denoiser(TrainConfig.model_validate_json(header["config"]).model)
    try:
        network.load_state_dict({"bias": network.bias} | found)  # weights may never have been calibrated
    except RuntimeError as error:
        raise BadInput(f"{path}: weights of another network; train again with `apartgen train layout`") from error
    return network.eval().requires_grad_(False), json.loads(header["record"])
