"""Rooms laid across the end of a hallway that goes on beyond its last door, instead of along it."""

from collections.abc import Iterator

import numpy as np

from apartgen.stages.plan.slicing import (
    EPS,
    L_ENTRY,
    L_LINK,
    LEFT,
    RIGHT,
    S_CORRIDOR,
    UPRIGHT,
    Floats,
    Problem,
    Scratch,
    Tree,
)

IDLE = 0.6
"""Hallway beyond what its doors need from which it is worth while to try, m."""
ABOVE = 3
"""Cuts above a hallway within which rooms lie across its end."""


def capped(tree: Tree, p: Problem, z: Scratch) -> Iterator[Tree]:
    """Trees in which a room beside the idle end of a hallway lies across it; `z` measures the tree."""
    leaves = len(tree.share) - 1
    for hall in range(leaves):
        if not p.spec[tree.nodes[hall, 0], S_CORRIDOR]:
            continue
        box = z.box[hall]
        axis = int(box[3] - box[1] > box[2] - box[0])
        for far, idle in enumerate(_idle(tree, p, z, hall, axis)):
            if idle > IDLE:
                beside = [leaf for leaf in range(leaves) if leaf != hall and _at_end(z.box[leaf], box, axis, far)]
                yield from (moved for leaf in beside for moved in _across(tree, hall, leaf, axis, far))


def _idle(tree: Tree, p: Problem, z: Scratch, hall: int, axis: int) -> tuple[float, float]:
    """How far a hallway's rectangle goes on beyond its first and its last door, joint or entrance, m."""
    room, box, spans = tree.nodes[hall, 0], z.box[hall], list[tuple[float, float]]()
    for (a, b), (long, *middle, dx) in zip(p.links.tolist(), z.wall.tolist(), strict=True):
        half = 0.5 * (long if (dx > EPS) == (axis == 0) else 0.0)
        lo, hi = max(box[axis], middle[axis] - half), min(box[axis + 2], middle[axis] + half)
        if room in (a, b) and hi > lo - EPS:
            wide = min(p.limits[L_LINK], hi - lo)
            spans.append((hi - wide, lo + wide))
    if room == p.order[0, 0]:
        at, half = z.entry[axis], 0.5 * p.limits[L_ENTRY]
        spans.append((max(box[axis], at - half), min(box[axis + 2], at + half)))
    for other in range(len(tree.share) - 1):
        b = z.box[other]
        if other != hall and tree.nodes[other, 0] == room and _touch(b, box):
            spans.append((max(box[axis], b[axis]), min(box[axis + 2], b[axis + 2])))
    first, last = min((lo for lo, _ in spans), default=box[axis]), max((hi for _, hi in spans), default=box[axis + 2])
    return first - box[axis], box[axis + 2] - last


def _touch(a: Floats, b: Floats) -> bool:
    return bool((np.minimum(a[2:4], b[2:4]) > np.maximum(a[:2], b[:2]) - EPS).all())


def _at_end(box: Floats, hall: Floats, axis: int, far: int) -> bool:
    """Whether a box lies beside a hallway's and ends where that does."""
    return abs(box[axis + 2 * far] - hall[axis + 2 * far]) < 0.3 and _touch(box, hall)


def _across(tree: Tree, hall: int, leaf: int, axis: int, far: int) -> Iterator[Tree]:
    """Trees in which a leaf lies across the end of the hallway and of what lies beside that."""
    node = hall
    for _ in range(ABOVE):
        node = _above(tree, node)
        if node < 0:
            return
        moved = _grafted(tree, leaf, node, 1 - axis, far)
        if moved is not None:
            yield moved


def _above(tree: Tree, node: int) -> int:
    leaves = len(tree.share) - 1
    return next((up for up in range(leaves, 2 * leaves - 1) if node in tree.nodes[up, :UPRIGHT]), -1)


def _grafted(tree: Tree, leaf: int, onto: int, upright: int, after: int) -> Tree | None:
    """The tree with a leaf moved beside a node; None where it hangs there."""
    up, nodes = _above(tree, leaf), tree.nodes.copy()
    if onto == up:
        return None
    rest = nodes[up, RIGHT] if nodes[up, LEFT] == leaf else nodes[up, LEFT]
    for old, new in ((up, rest), (onto, up)):
        at = nodes[len(tree.share) - 1 :, :UPRIGHT]
        at[(at == old) & (np.arange(len(tree.share) - 1, len(nodes)) != new)[:, None]] = new
    nodes[up] = (onto, leaf, upright) if after else (leaf, onto, upright)
    return Tree(nodes, tree.share.copy())
