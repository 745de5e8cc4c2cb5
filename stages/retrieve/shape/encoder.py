"""Shape latents without torch: the trained encoder as plain matrix products."""

import json
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors import safe_open

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.shape.fields import FEATURES, field
from apartgen.stages.things.asset import Asset

Array = NDArray[np.float64]
WEIGHTS = Path(__file__).parent / "weights.safetensors"


@cache
def weights(path: Path = WEIGHTS) -> dict[str, Array]:
    """The tensors of a weights file by name, in double precision."""
    with safe_open(path, framework="np") as file:
        tensors = {name: file.get_tensor(name).astype(np.float64) for name in file.keys()}  # noqa: SIM118
    if tensors["encoder.0.weight"].shape[1] != FEATURES:
        raise BadInput(f"{path}: made for other fields than these; train again with `apartgen train shape`")
    return tensors


def record(path: Path = WEIGHTS) -> dict[str, Any]:
    """Config and training record kept in the header."""
    with safe_open(path, framework="np") as file:
        return dict(json.loads(file.metadata()["apartgen"]))


def _silu(x: Array) -> Array:
    return np.asarray(x / (1 + np.exp(-x)))


def encode(fields: NDArray[np.floating[Any]], path: Path = WEIGHTS) -> Array:
    """Standardised latents (n, 32) of fields (n, FEATURES): mean 0 and variance 1 over the training set."""
    w = weights(path)
    h = np.asarray(fields, float)
    for layer in ("encoder.0", "encoder.2"):
        h = _silu(h @ w[f"{layer}.weight"].T + w[f"{layer}.bias"])
    mean = (h @ w["encoder.4.weight"].T + w["encoder.4.bias"])[:, : len(w["latent.mean"])]
    return np.asarray((mean - w["latent.mean"]) / w["latent.std"])


def latents(assets: Iterable[Asset], path: Path = WEIGHTS) -> Array:
    """Latents of assets, (n, 32)."""
    return encode(np.stack([field(asset) for asset in assets]), path)
