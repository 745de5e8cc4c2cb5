"""What annealing seldom comes upon by chance, tried on every arrangement that lacks nothing."""

from functools import partial

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.plan import kernel
from apartgen.stages.plan.capped import capped
from apartgen.stages.plan.problem import copy
from apartgen.stages.plan.slicing import CONCISE, EPS, LACKING, LINES, Floats, Problem, Scratch, Tree
from apartgen.stages.plan.straight import straightened

WARM, COLD = 10.0, 1.0
"""Temperatures between which rooms are fitted in anew after one was laid elsewhere, in units of cost."""
ASKED = 2.0
"""Weight of a line of walls from which walls are brought onto others for that alone."""
SMOOTH = 12.0
"""What surplus corners count beside what they cost, since annealing weighs them against walls that it cannot align."""


def bettered(
    tree: Tree, cost: float, p: Problem, z: Scratch, seed: NDArray[np.uint64], steps: int
) -> tuple[Tree, float]:
    """A tree no worse than one that lacks nothing, and its cost; `z` has the measures of the one, then of the other.

    Each hallway's idle end is tried with other rooms across it in `steps` steps of annealing, from a `seed` (1,).
    """
    best, tries = tree, list(capped(tree, p, z))
    for moved in tries:
        found = copy(moved)
        price = kernel.anneal(p, copy(moved), copy(moved), found, z, seed, steps, WARM, COLD)
        if z.terms[LACKING] < EPS and price < cost:
            best, cost = found, float(price)
    if tries:
        _priced(p, z, best)
    if z.terms[CONCISE] > 0 or p.weights[LINES] >= ASKED:
        best = straightened(best, z.block.copy(), partial(_priced, p, z))
        cost, _ = _priced(p, z, best)
    return best, cost


def _priced(p: Problem, z: Scratch, tree: Tree) -> tuple[float, Floats]:
    """What a tree costs, infinite where it lacks something, and its boxes; its measures are in `z`."""
    cost = kernel.anneal(p, copy(tree), copy(tree), copy(tree), z, np.ones(1, np.uint64), 0, WARM, COLD)
    return (np.inf if z.terms[LACKING] > EPS else float(cost + SMOOTH * z.terms[CONCISE])), z.box.copy()
