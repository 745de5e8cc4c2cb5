"""What stands before a thing."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import MOSTLY, Facts, marked
from apartgen.stages.qa.fronts import THIN, before
from apartgen.stages.qa.plain import fronted
from apartgen.stages.qa.whole import before_front

WRONG = 3
MIDDLE = (0.0,)
"""The thirds of its width before which it is."""
SCRAP = 0.35
"""Of what is met, no less than this share is in sight from side to side and from end to end."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The first thing straight ahead of its front, before its middle as over its whole width, among others of the same
    picture, which shows most of it and, of what opens, the front; nothing that is drawn up under what it meets.
    """
    drafts = []
    for view, numbers in facts.marks.items():
        seen = {id for id in facts.uncut(view, MOSTLY) if before_front(facts.views[view], facts.objects[id])}
        for id in (id for id in numbers if id in seen and fronted(facts, id)):
            ahead = before(facts, id, MIDDLE) if facts.objects[id].room in facts.rooms else None
            met = ahead[1] if ahead else ""
            others = [other for other in numbers if other not in (id, met) and facts.objects[other].size[2] > THIN]
            under = met in numbers and facts.print(id).intersects(facts.print(met))
            if met in numbers and met in facts.uncut(view, SCRAP) and len(others) >= WRONG - 1 and not under:
                wrong = tuple(marked(numbers[others[k]]) for k in rng.permutation(len(others))[:WRONG])
                text = f"What does one meet first straight ahead of the front of {marked(numbers[id])}?"
                drafts.append(facts.numbered(view, text, marked(numbers[met]), {"object": id, "met": met}, wrong,
                                             hard=1))
    return some(drafts, rng, most)
