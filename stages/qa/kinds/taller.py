"""Which of two things is taller."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts, marked

MOST = 0.85
"""Share of the taller one's height that the other's is at most."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of things that stand on the floor, from their undersides to their tops, both seen nearly whole."""
    drafts = []
    for view, numbers in facts.marks.items():
        uncut = facts.uncut(view)
        for a, b in combinations((id for id in numbers if facts.stands(id) and id in uncut), 2):
            short, tall = sorted((a, b), key=lambda id: facts.objects[id].size[2])
            if facts.objects[short].size[2] < MOST * facts.objects[tall].size[2]:
                one, other = sorted((numbers[a], numbers[b]))
                text = f"Which of these is taller, {marked(one)} or {marked(other)}?"
                drafts.append(facts.numbered(view, text, marked(numbers[tall]), {"objects": [a, b]},
                                             (marked(numbers[short]),)))
    return some(drafts, rng, most)
