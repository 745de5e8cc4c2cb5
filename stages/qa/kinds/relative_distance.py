"""Which of four things is nearest to another."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts

CLEARLY = 0.75
"""The nearest is nearer than this share of the next one's distance."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Things of one room, by the nearest points of their boxes."""
    drafts = []
    for room in facts.rooms:
        ids = facts.named_in(room)
        for anchor in ids:
            others = [id for id in ids if id != anchor]
            if len(others) < 3:
                continue
            four = [others[k] for k in rng.permutation(len(others))[:4]]
            far = sorted((facts.apart(anchor, id), id) for id in four)
            if far[0][0] < CLEARLY * far[1][0] - 0.1 and (images := facts.pictures([anchor, *four])):
                text = f"Which of these is nearest to {facts.names[anchor]}?"
                wrong = tuple(facts.names[id] for _, id in far[1:])
                evidence = {"to": anchor, "objects": four}
                drafts.append(Draft(text, facts.names[far[0][1]], images, evidence, wrong, hard=1))
    return some(drafts, rng, most)
