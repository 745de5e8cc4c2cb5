"""Which of two things is taller."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, either_way
from apartgen.stages.qa.facts import Facts

LEAST, MOST = 0.5, 0.85
"""Shares of the taller one's height between which the other's is: clear to see, but not from the words."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """From its underside to its top."""
    drafts = []
    for view in facts.eyes:
        for (a, one), (b, other) in combinations(facts.alone(view.name).items(), 2):
            (short, small), (tall, large) = sorted(((a, one), (b, other)), key=lambda pair: pair[1].size[2])
            if LEAST < small.size[2] / large.size[2] < MOST:
                drafts.append(Draft(f"Which of these is taller, {a} or {b}?", tall, [view.name],
                                    {"view": view.name, "objects": [one.id, other.id]}, (short,)))
    return either_way(drafts, rng, most)
