"""Which of four things is nearest to another."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import MOSTLY, Facts, marked

CLEARLY, MORE = 0.75, 0.2
"""The nearest is nearer than this share of the next one's distance, and by so much, m: what a chair is drawn under is
none of it away by its box."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Things of one room in one picture, most of each in sight, by the nearest points of their boxes."""
    drafts = []
    for view, numbers in facts.marks.items():
        seen = [id for id in numbers if id in facts.uncut(view, MOSTLY)]
        for anchor in seen:
            others = [id for id in seen if id != anchor and facts.objects[id].room == facts.objects[anchor].room]
            if len(others) < 3:
                continue
            four = [others[k] for k in rng.permutation(len(others))[:4]]
            far = sorted((facts.apart(anchor, id), id) for id in four)
            if far[0][0] < CLEARLY * far[1][0] - MORE:
                text = f"Which of these is nearest to {marked(numbers[anchor])}?"
                right, *wrong = (marked(numbers[id]) for _, id in far)
                drafts.append(facts.numbered(view, text, right, {"to": anchor, "objects": four}, tuple(wrong), hard=1))
    return some(drafts, rng, most)
