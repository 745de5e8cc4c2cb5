"""Category and scale of a model without units: the furniture whose real proportions it comes nearest to."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.retrieve.reading.pieces import Array
from apartgen.stages.things.categories import TABLE


def fitted(extents: Array, candidates: Sequence[str]) -> tuple[str, float]:
    """The best candidate for extents [depth, width, height] of any unit, and metres per unit.

    The scale is the one that brings the sides closest to the category's usual ones (in logarithms), moved as
    little as needed for them to lie in its range; what is left out of range counts ten times.
    """
    raw = np.log(np.maximum(np.asarray(extents, float), 1e-9))
    best = []
    for name in candidates:
        usual, lo, hi = (np.log(side) for side in (TABLE[name].size, TABLE[name].min, TABLE[name].max))
        shift = float(np.mean(usual - raw))
        low, high = float((lo - raw).max()), float((hi - raw).min())
        shift = float(np.clip(shift, low, high)) if low <= high else (low + high) / 2
        sides = raw + shift
        outside = np.maximum(lo - sides, 0) + np.maximum(sides - hi, 0)
        best.append((float(np.square(sides - usual).sum() + 10 * outside.sum()), name, float(np.exp(shift))))
    _, name, scale = min(best)
    return name, scale
