"""What hangs over a kitchen run: the hood over what cooks, wall units, a microwave on a worktop."""

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish import corners, kernels
from apartgen.stages.layout.datasets._furnish.group import Part
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import TOUCH
from apartgen.stages.space.boxes import Array


@dataclass(frozen=True)
class Style:
    """What the units of a kitchen share."""

    depth: float
    height: float
    wall: Array
    hang: float


def lit(p: Part, windows: Array, height: float) -> bool:
    """Whether something of that height there would stand before a window."""
    if not len(windows):
        return False
    row = np.array([[[p.x, p.y, height / 2, p.size[0], p.size[1], height, np.cos(p.yaw), np.sin(p.yaw)]]], float)
    return bool(kernels.clash(row, np.ascontiguousarray(windows), np.ones((1, len(windows)), bool), TOUCH)[0])


def over_units(
    parts: list[Part], style: Style, rng: Generator, windows: Array, left: int, ceiling: float
) -> list[Part]:
    """The hood over what cooks, wall units over low units, a microwave on a worktop."""
    out: list[Part] = []
    low = [i for i, p in enumerate(parts) if p.size[2] < 1.2]
    for i in low:
        if parts[i].name == "hob" or (parts[i].name == "oven" and not any(p.name == "hob" for p in parts)):
            size = draw("hood", rng, width=float(np.clip(parts[i].size[1], 0.5, 0.95)))
            size[2] = round(min(float(size[2]), ceiling - 1.62), 3)
            out.append(_over(parts[i], i, "hood", size, 1.55))
    if rng.random() < 0.88:
        for i in low:
            p = parts[i]
            size = np.array([style.wall[0], p.size[1], style.wall[2]])
            if p.name in ("hob", "oven", corners.NAME) or len(out) >= left - 1 or lit(p, windows, style.hang + 0.3):
                continue
            out.append(_over(p, i, "wall_unit", size, style.hang))
    tops = [i for i in low if parts[i].name in ("kitchen_base", "kitchen_drawers") and parts[i].size[1] >= 0.55]
    if tops and len(out) < left and rng.random() < 0.75:
        i = int(rng.choice(tops))
        size = draw("microwave", rng)
        size[1], size[2] = min(size[1], parts[i].size[1] - 0.02), min(size[2], style.hang - style.height - 0.04)
        out.append(_over(parts[i], i, "microwave", np.round(size, 3), float(parts[i].size[2])))
    return out


def _over(p: Part, i: int, name: str, size: Array, z: float) -> Part:
    """Something at the wall above a unit, its middle over the unit's."""
    back = -p.size[0] / 2 + size[0] / 2
    return Part(name, p.x + back * float(np.cos(p.yaw)), p.y + back * float(np.sin(p.yaw)), size, p.yaw, z, i)
