"""Sizes as people own them: within the category's range, in the steps things are sold in."""

import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.random import Generator

from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import TABLE

SPREAD = 0.45
LEVEL = {"depth": 0, "width": 1, "height": 2}


@cache
def steps() -> dict[str, dict[str, Any]]:
    """Steps in which things are sold, by category."""
    return tomllib.loads((Path(__file__).parent / "sizes.toml").read_text())


def draw(name: str, rng: Generator, lean: float | None = None, **fixed: float) -> Array:
    """[depth, width, height]; `lean` fixes how large it is, −1 least … 1 greatest; sides may be given."""
    kind = TABLE[name]
    base, lo, hi = (np.array(v) for v in (kind.size, kind.min, kind.max))
    shared = lean if lean is not None else float(rng.normal(0, SPREAD))
    t = np.clip(0.75 * shared + 0.4 * rng.normal(0, SPREAD, 3), -1, 1)
    size = np.where(t > 0, base + t * (hi - base), base + t * (base - lo))
    row = steps().get(name, {})
    for side, k in LEVEL.items():
        if side in row:
            sold = np.array(row[side])
            near = np.abs(sold - size[k])
            size[k] = sold[np.argsort(near, kind="stable")[min(len(sold) - 1, int(rng.geometric(0.6)) - 1)]]
        if side in fixed:
            size[k] = fixed[side]
    if row.get("square"):
        size[0] = size[1]
    return np.asarray(np.round(np.clip(size, lo, hi), 3))
