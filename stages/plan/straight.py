"""Walls of an arrangement that all but lie on one line brought onto it: annealing hits a line by no chance."""

from collections.abc import Callable, Iterator

import numpy as np

from apartgen.stages.plan.slicing import CORNERED, EPS, LEFT, RIGHT, UPRIGHT, Floats, Tree

JOG = 0.7
"""Distance up to which two lines make a jog, m."""
ROUNDS = 3
"""Walls that are brought onto lines at most."""

Priced = Callable[[Tree], tuple[float, Floats]]
"""The cost of a tree, infinite where it lacks something, and the boxes of its nodes (2L-1, 6), m."""


def straightened(tree: Tree, blocks: Floats, priced: Priced) -> Tree:
    """The cheapest tree that bringing cuts onto lines of others leads to; `blocks` (k, 4) are all of the outline, m."""
    cost, boxes = priced(tree)
    for _ in range(ROUNDS):
        moved = [(*priced(one), one) for one in _aligned(tree, boxes, blocks)]
        best = min(moved, key=lambda found: found[0], default=None)
        if best is None or best[0] > cost - EPS:
            break
        cost, boxes, tree = best
    return tree


def _aligned(tree: Tree, boxes: Floats, blocks: Floats) -> Iterator[Tree]:
    """Trees in which two cuts lie on one line: that of one, or the one amid."""
    leaves = len(tree.share) - 1
    for one in range(leaves, 2 * leaves - 1):
        for other in range(one + 1, 2 * leaves - 1):
            if tree.nodes[one, UPRIGHT] != tree.nodes[other, UPRIGHT]:
                continue
            a, b = (float(boxes[tree.nodes[cut, LEFT], 3 - tree.nodes[cut, UPRIGHT]]) for cut in (one, other))
            if EPS < abs(a - b) < JOG:
                yield from (_brought(_brought(tree, boxes, blocks, one, at), boxes, blocks, other, at)
                            for at in (a, 0.5 * (a + b), b))


def _brought(tree: Tree, boxes: Floats, blocks: Floats, cut: int, at: float) -> Tree:
    """The tree with a cut at a place within its box, m; the same where that has no room for it."""
    upright = int(tree.nodes[cut, UPRIGHT])
    box = boxes[cut, :4].copy()
    if min(at - box[1 - upright], box[3 - upright] - at) < CORNERED:
        return tree
    whole = _covered(box, blocks)
    box[3 - upright] = at
    part = _covered(box, blocks) / whole if whole > EPS else 0.0
    if not EPS < part < 1 - EPS:  # all on one side, or where the outline cuts everything off
        return tree
    share = tree.share.copy()
    left, right = (_below(tree, int(tree.nodes[cut, side])) for side in (LEFT, RIGHT))
    both = share[left].sum() + share[right].sum()
    share[left] *= part * both / share[left].sum()
    share[right] *= (1 - part) * both / share[right].sum()
    return Tree(tree.nodes, share)


def _covered(box: Floats, blocks: Floats) -> float:
    """Area of a box within disjoint blocks, m²."""
    sides = np.minimum(box[2:], blocks[:, 2:]) - np.maximum(box[:2], blocks[:, :2])
    return float(np.clip(sides, 0.0, None).prod(axis=1).sum())


def _below(tree: Tree, node: int) -> list[int]:
    """The leaves below a node."""
    if node < len(tree.share) - 1:
        return [node]
    return [leaf for side in (LEFT, RIGHT) for leaf in _below(tree, int(tree.nodes[node, side]))]
