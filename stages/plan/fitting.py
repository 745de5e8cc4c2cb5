"""Cuts of an arrangement brought to where they give rooms their shares of the true outline, slanting walls and all."""

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.stages.plan.slicing import LEFT, RIGHT, UPRIGHT, Floats, Tree

CLOSE = 0.002
"""Shares are met to this part of what is cut."""
TRIES = 16
STRAIGHT = 1e-6


def fitted(tree: Tree, boxes: Floats, outline: Polygon) -> Floats:
    """Boxes of the leaves (L, 4); `boxes` (2L-1, 6) are those that the annealing had, in the straightened outline.

    Where all of an outline is upright they stay as they are.
    """
    leaves = len(tree.share) - 1
    steps = np.abs(np.diff(shapely.get_coordinates(outline.exterior), axis=0)).min(axis=1)
    if steps.max() < STRAIGHT:
        return boxes[:leaves, :4]
    x0, y0, x1, y1 = outline.bounds
    out = boxes[:, :4].copy()
    top = int(tree.nodes[2 * leaves - 1, 0])
    out[top] = x0, y0, x1, y1
    waiting = [top]
    while waiting:
        node = waiting.pop()
        if node < leaves:
            continue
        left, right, upright = (int(v) for v in tree.nodes[node, [LEFT, RIGHT, UPRIGHT]])
        share = boxes[left, 4] / (boxes[node, 4] + 1e-12)
        at = _cut(outline, out[node], bool(upright), float(share), float(boxes[right, 1 - upright]))
        out[left], out[right] = out[node], out[node]
        out[left, 3 - upright] = out[right, 1 - upright] = at
        waiting += [left, right]
    return out[:leaves]


def _cut(outline: Polygon, box: Floats, upright: bool, share: float, first: float) -> float:
    """Where a cut leaves a share of the outline within a box before it; `first` is a good guess."""
    x0, y0, x1, y1 = (float(v) for v in box)
    inside = outline.intersection(shapely.box(x0, y0, x1, y1))
    goal, whole = share * inside.area, inside.area
    lo, hi = (x0, x1) if upright else (y0, y1)
    at = min(max(first, lo), hi)
    for _ in range(TRIES):
        before = inside.intersection(shapely.box(x0, y0, at, y1) if upright else shapely.box(x0, y0, x1, at)).area
        if abs(before - goal) < CLOSE * whole:
            break
        lo, hi = (at, hi) if before < goal else (lo, at)
        at = 0.5 * (lo + hi)
    return round(at, 2)
