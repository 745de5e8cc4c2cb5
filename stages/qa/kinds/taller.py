"""Which of two things is taller."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts, marked
from apartgen.stages.qa.plain import bounded
from apartgen.stages.things.categories import TABLE

SEEN = 0.72
"""Share of its width and height of which a thing shows at least; the other is shorter than that."""
MOST, HEADS = 0.7, 0.5
"""Share of the taller one's height that the other's is at most, and where one is a bed, whose head is higher."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of things that stand on the floor, from their undersides to their tops, both mostly in sight."""
    drafts = []
    for view, numbers in facts.marks.items():
        uncut = facts.uncut(view, SEEN)
        for a, b in combinations((id for id in numbers if id in uncut and _whole(facts, id)), 2):
            short, tall = sorted((a, b), key=lambda id: facts.objects[id].size[2])
            least = HEADS if _is_bed(facts, a) or _is_bed(facts, b) else MOST
            if facts.objects[short].size[2] < least * facts.objects[tall].size[2]:
                one, other = sorted((numbers[a], numbers[b]))
                text = f"Which of these is taller, {marked(one)} or {marked(other)}?"
                drafts.append(facts.numbered(view, text, marked(numbers[tall]), {"objects": [a, b]},
                                             (marked(numbers[short]),)))
    return some(drafts, rng, most)


def _whole(facts: Facts, id: str) -> bool:
    """What stands on the floor and of which one sees the end; not a plant, of which the number may mean the pot."""
    return facts.stands(id) and bounded(facts, id)


def _is_bed(facts: Facts, id: str) -> bool:
    return TABLE[facts.objects[id].category].is_for("sleep")
