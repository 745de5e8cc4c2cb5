"""Places at random, for what finds none among those that are likely."""

import numpy as np

from apartgen.stages.layout.relations.followers import leading
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import Array, Shell
from apartgen.stages.things.categories import TABLE

MANY = 600
"""So many places at random are tried."""


def anywhere(there: Furniture, name: str, boxes: Array, shell: Shell, rng: np.random.Generator) -> Array:
    """Boxes (n, 7) of the same sizes at random: along walls what has a back, on tops what stands there, else anywhere.
    """
    kind, n, out = TABLE[name], len(boxes), boxes.copy()
    walls = np.flatnonzero((shell.boxes[:, 3] == 0) & (shell.kind == 1))
    length = shell.boxes[walls, 4].astype(float)
    wall = shell.boxes[walls[rng.choice(len(walls), n, p=length / length.sum())]]
    away = boxes[:, 3] / 2 + np.where(kind.back or kind.place == "wall", 0.005, rng.random(n) * 3)
    along = (rng.random(n) - 0.5) * np.maximum(wall[:, 4] - boxes[:, 4], 0)
    c, s = np.cos(wall[:, 2]), np.sin(wall[:, 2])
    out[:, 0], out[:, 1] = wall[:, 0] + away * c - along * s, wall[:, 1] + away * s + along * c
    quarter = 0 if kind.back or kind.place == "wall" else rng.integers(4, size=n)
    out[:, 2] = wall[:, 2] + quarter * np.pi / 2
    height = boxes[:, 6] - boxes[:, 5]
    low = {"wall": max(kind.z, 0.0), "ceiling": np.nan}.get(kind.place, 0.0)
    out[:, 5] = np.where(np.isnan(low), shell.boxes[0, 6] - height, low)
    under = [box for o, box in zip(there.names, there.boxes, strict=True) if o in kind.belongs]
    if kind.place == "top" and under:
        which = np.array(under)[rng.integers(len(under), size=n)]
        out[:, :3], out[:, 5] = which[:, :3], which[:, 6]
    out[:, 6] = out[:, 5] + height
    return out


def somewhere(there: Furniture, name: str, scale: float, shell: Shell, rng: np.random.Generator) -> Array:
    """Boxes (m, 7) of a share of a thing's usual size: at random, and along all walls or all over the room, if such
    things lead a group."""
    size = np.maximum(np.array(TABLE[name].size) * scale, TABLE[name].min)
    start = np.zeros((MANY, 7), np.float32)
    start[:, 3:5], start[:, 6] = size[:2], size[2]
    return np.concatenate([anywhere(there, name, start, shell, rng), leading(name, start[:1], there.space)])
