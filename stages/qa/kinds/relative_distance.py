"""Which of four things is nearest to another."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import MOSTLY, Facts, marked
from apartgen.stages.qa.plain import bounded, overhead, rests_on

CLEARLY, MORE = 0.7, 0.2
"""The nearest is nearer than this share of the next one's distance, and by so much, m: what a chair is drawn under is
none of it away by its box."""
FOURS = 8
"""How many fours of things are tried about each."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Things of one room in one picture, most of each in sight, by the nearest points of their boxes; none of them is
    on another, and none hangs overhead, where one does not see how far away it is.
    """
    drafts = []
    for view, numbers in facts.marks.items():
        seen = [id for id in numbers if id in facts.uncut(view, MOSTLY) and bounded(facts, id)
                and not overhead(facts.objects[id])]
        for anchor in seen:
            others = [id for id in seen if id != anchor and facts.objects[id].room == facts.objects[anchor].room]
            four = _four(facts, anchor, others, rng) if len(others) >= 3 else []
            if four:
                text = f"Which of these is nearest to {marked(numbers[anchor])}?"
                right, *wrong = (marked(numbers[id]) for id in four)
                drafts.append(facts.numbered(view, text, right, {"to": anchor, "objects": sorted(four)}, tuple(wrong),
                                             hard=1))
    return some(drafts, rng, most)


def _four(facts: Facts, anchor: str, others: Sequence[str], rng: np.random.Generator) -> list[str]:
    """Four things, or three where there are no more, the one that is plainly nearest first; empty where no four has
    one.
    """
    for _ in range(FOURS):
        four = [others[k] for k in rng.permutation(len(others))[:4]]
        far = sorted((facts.apart(anchor, id), id) for id in four)
        if far[0][0] < CLEARLY * far[1][0] - MORE and not rests_on(facts, [anchor, *four]):
            return [id for _, id in far]
    return []
