"""How far two things are from each other."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, metres

NEAREST = 0.4
"""What is nearer is not asked for, m."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Between the nearest points of their boxes."""
    drafts = []
    for room in facts.rooms:
        for a, b in combinations(facts.named_in(room), 2):
            far = facts.apart(a, b)
            if far > NEAREST and (images := facts.pictures((a, b), 2)):
                text = f"How far is {facts.names[a]} from {facts.names[b]}, between their nearest points?"
                evidence = {"objects": [a, b], "metres": round(far, 3)}
                drafts.append(Draft(text, metres(far), images, evidence, number=far))
    return shared(drafts, rng, most)
