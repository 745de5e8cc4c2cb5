"""Where an armchair completes the group of a sofa: at an end of the low table, or somewhat before it, so that the
screen is seen past it, square to the sofa or turned to it."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.relations.company import Seen
from apartgen.stages.layout.relations.places import Place, Size, about
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.use import kinds

SEAT, LOW = "armchair", "coffee_table"
GAPS, AHEAD, TURNS = (0.32, 0.5, 0.75), (0.0, 0.25, 0.5, 0.8), (0.0, 0.35, 0.7)
"""From the end of the low table, before its middle, m, and how far turned to the sofa from across it, rad."""
LONG = 1.2
"""Wider, for two, it stands square, m."""
VIEW = 0.42
"""Of a sofa's width to either side of its middle one sees the screen past an armchair."""
REACH, USUAL = 0.36, (0.6, 0.9)
"""Where there is no low table: how far before a sofa it would be, and how deep and wide, m."""


def places(names: Sequence[str], there: Array, size: Size) -> Array:
    """Places (n, 7) of armchairs of a size about each sofa."""
    sofas = there[[kinds.basic(o) in kinds.SOFAS for o in names]] if names else there[:0]
    tables = there[[kinds.basic(o) == LOW for o in names]] if names else there[:0]
    found = [about(sofa, _at_ends(sofa, _extent(sofa, tables), size), size) for sofa in sofas]
    return np.concatenate([there[:0], *found])


def _extent(sofa: Array, tables: Array) -> tuple[float, float, float, float]:
    """The middle (x, y) of the nearest low table in the sofa's frame, or of where one would be, and half its extent."""
    if not len(tables):
        depth, width = USUAL
        return float(sofa[3]) / 2 + REACH + depth / 2, 0.0, depth / 2, width / 2
    seen = Seen(sofa[None], tables)
    k = int(seen.gap[0].argmin())
    return float(seen.x[0, k]), float(seen.y[0, k]), float(seen.extent[0, k, 0]), float(seen.extent[0, k, 1])


def _at_ends(sofa: Array, table: tuple[float, float, float, float], size: Size) -> list[Place]:
    """Places at both ends of a table (x, y, half depth, half width), all in the sofa's frame."""
    x, y, _, wide = table
    out = []
    for turn in TURNS if size[1] < LONG else TURNS[:1]:
        half = (size[0] * np.cos(turn) + size[1] * np.sin(turn)) / 2
        for gap in GAPS:
            for side in (1.0, -1.0):
                inner = max(side * y + wide + gap, VIEW * float(sofa[4]))
                out += [(x + ahead, side * (inner + half), -side * (np.pi / 2 + turn)) for ahead in AHEAD]
    return out
