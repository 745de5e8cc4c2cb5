"""What furniture weighs: as its materials say, brought to what such things weigh by `categories.toml`."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.things.categories import TABLE

SPREAD = 0.3
"""About the share by which a piece may be lighter or heavier than one of its size is."""


def weight(category: str, size: Sequence[float], of_materials: float) -> float:
    """kg: between the lightest and the heaviest of its kind as its volume is, and near what its materials weigh."""
    kind = TABLE.get(category)
    if kind is None or kind.mass is None:
        return of_materials
    least, most, own = (float(np.prod(side)) for side in (kind.min, kind.max, size))
    usual = float(np.interp((own - least) / (most - least), [0, 1], kind.mass))
    near = usual * np.exp(SPREAD * np.tanh(np.log(max(of_materials, 1e-6) / usual)))
    return float(np.clip(near, *kind.mass))
