"""Candidates that are known without the model: exact, so that nothing is missed for want of one."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import across, followers, handy, hung, runs
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import Array, Shell

KNOWN, STRAIGHT = 0.02, 0.3
"""Weight of all of them together, and of those of a television straight across from its sofa, where the model's
candidates weigh 1."""
Floats = NDArray[np.floating]


def further(there: Furniture, name: str, boxes: Array, weight: Floats, shell: Shell) -> tuple[Array, Floats]:
    """Candidates (n, 7), and weights, with those that continue a run, hang over something, follow it, are at hand or
    across from it."""
    some = np.concatenate([
        runs.further(name, boxes, there.names, there.boxes, shell),
        hung.over(name, boxes, there.names, there.boxes),
        followers.known(name, boxes, there.names, there.boxes),
        handy.places(name, boxes, there.names, there.boxes, there.space)])
    straight = across.places(name, boxes, there.names, there.boxes, there.space)
    shares = [np.full(len(more), share * weight.sum() / max(len(more), 1))
              for more, share in ((some, KNOWN), (straight, STRAIGHT))]
    return np.concatenate([boxes, some, straight]), np.concatenate([weight, *shares])
