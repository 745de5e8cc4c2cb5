"""Which of two things is further to the left in a picture."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, either_way
from apartgen.stages.qa.facts import Facts

APART = 0.15
"""Share of the picture's width by which their middles differ at least."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """By the middles of what is seen of them, where their left and right ends say the same."""
    ids = {thing.number: thing.id for thing in facts.render.instances}
    drafts = []
    for view in facts.eyes:
        ends = {ids[part.number]: (part.rectangle[0], part.rectangle[0] + part.rectangle[2]) for part in view.visible}
        middle = {id: (low + high) / 2 for id, (low, high) in ends.items()}
        for (a, one), (b, other) in combinations(facts.alone(view.name).items(), 2):
            left, right = ((a, one), (b, other)) if middle[one.id] < middle[other.id] else ((b, other), (a, one))
            clear = all(x < y for x, y in zip(ends[left[1].id], ends[right[1].id], strict=True))
            if clear and middle[right[1].id] - middle[left[1].id] > APART * view.width:
                drafts.append(Draft(f"Which of these is further to the left in the picture, {a} or {b}?", left[0],
                                    [view.name], {"view": view.name, "objects": [one.id, other.id]}, (right[0],)))
    return either_way(drafts, rng, most)
