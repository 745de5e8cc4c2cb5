"""Which of four things a picture shows."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts, one


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The others are in the home, but nothing of their kind is in the picture."""
    kinds = sorted({o.category for o in facts.home.objects})
    drafts = []
    for view in facts.eyes:
        shown = {facts.objects[id].category for id in facts.shares[view.name] if id in facts.objects}
        absent = [kind for kind in kinds if kind not in shown]
        for o in facts.clear(view.name):
            if len(absent) < 3 or facts.shares[view.name][o.id] < 0.01:
                continue
            wrong = tuple(one(absent[k]) for k in rng.permutation(len(absent))[:3])
            drafts.append(Draft("Which of these does the picture show?", one(o.category), [view.name],
                                {"view": view.name, "category": o.category}, wrong))
    return some(drafts, rng, most)
