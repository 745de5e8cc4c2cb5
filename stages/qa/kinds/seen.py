"""Which of four things a picture shows."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import usual
from apartgen.stages.things.names import alike, one


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The others are in other pictures, nothing that one may take for them is in this one, and no room like those that
    it shows has any.
    """
    drafts = []
    for view in facts.eyes:
        shown, known = usual(facts, view.name), facts.known(view.name)
        barred = frozenset(one(category) for category in {o.category for o in facts.home.objects}
                           if any(alike(category, other) for other in shown))
        for o in facts.clear(view.name):
            if facts.shares[view.name][o.id] > 0.01 and o.id in known:
                drafts.append(Draft("Which of these does the picture show?", one(o.category), [view.name],
                                    {"view": view.name, "category": o.category}, barred=barred))
    return shared(drafts, rng, most)
