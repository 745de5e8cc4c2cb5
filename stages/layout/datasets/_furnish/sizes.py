"""Sizes as people own them: within the category's range, in the steps things are sold in, one model a room."""

import numpy as np
from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish.step import sizes
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import TABLE

SPREAD = 0.45
LEVEL = {"depth": 0, "width": 1, "height": 2}


def draw(name: str, rng: Generator, lean: float | None = None) -> Array:
    """[depth, width, height]; `lean` fixes how large it is, −1 least … 1 greatest."""
    kind = TABLE[name]
    base, lo, hi = (np.array(v) for v in (kind.size, kind.min, kind.max))
    shared = lean if lean is not None else float(rng.normal(0, SPREAD))
    t = np.clip(0.75 * shared + 0.4 * rng.normal(0, SPREAD, 3), -1, 1)
    size = np.where(t > 0, base + t * (hi - base), base + t * (base - lo))
    row = sizes().get(name, {})
    for side, k in LEVEL.items():
        if side in row:
            steps = np.array(row[side])
            near = np.abs(steps - size[k])
            size[k] = steps[np.argsort(near, kind="stable")[min(len(steps) - 1, int(rng.geometric(0.6)) - 1)]]
    if row.get("square"):
        size[1] = size[0]
    return np.asarray(np.round(np.clip(size, lo, hi), 3))
