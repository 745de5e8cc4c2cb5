"""Shape latents of the embedded library by category and style, read without torch.

A latent's 32 numbers have mean 0 and variance 1 over the shape model's training set.
"""

import json
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from safetensors import safe_open

from apartgen.schemas.errors import BadInput

Array = NDArray[np.float64]

DIMENSIONS = 32
INDEX = Path(__file__).parents[1] / "retrieve" / "shape" / "index.safetensors"


class Index(NamedTuple):
    """One row per indexed piece, sorted by category, style, size and seed; sizes in metres."""

    category: tuple[str, ...]
    style: tuple[str, ...]
    seed: NDArray[np.int64]
    size: Array
    latent: Array
    record: dict[str, Any]


@cache
def index(path: Path = INDEX) -> Index:
    """The index of the embedded library."""
    if not path.exists():
        raise BadInput(f"{path}: no index of the embedded library; make it with `apartgen train shape`")
    with safe_open(path, framework="np") as file:
        header = json.loads(file.metadata()["apartgen"])
        seed, size = file.get_tensor("seed").astype(np.int64), file.get_tensor("size").astype(np.float64)
        latent = file.get_tensor("latent").astype(np.float64)
    category, style = tuple(header["category"]), tuple(header["style"])
    return Index(category, style, seed, size, latent, header["record"])


@cache
def latents(category: str) -> tuple[list[str], Array]:
    """Style of every indexed piece of a category, length k, and its latent (k, 32).

    A style comes back once for each indexed size and variant; no pieces give ([], (0, 32)).
    """
    table = index()
    rows = [i for i, name in enumerate(table.category) if name == category]
    return [table.style[i] for i in rows], table.latent[rows]


@cache
def style_latents(category: str) -> tuple[list[str], Array]:
    """Each style of a category once, length k, and the mean of its pieces' latents (k, 32)."""
    styles, latent = latents(category)
    names = sorted(set(styles))
    means = [latent[[i for i, style in enumerate(styles) if style == name]].mean(0) for name in names]
    return names, np.asarray(means).reshape(-1, DIMENSIONS)
