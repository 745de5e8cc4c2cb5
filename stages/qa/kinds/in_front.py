"""What stands before a thing."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.fronts import before


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The first thing straight ahead of its front, over its whole width."""
    drafts = []
    for id, name in facts.names.items():
        _, met = before(facts, id)
        others = [k for k in facts.named_in(facts.objects[id].room) if k not in (id, met)]
        if met not in facts.names or len(others) < 2:
            continue
        wrong = [others[k] for k in rng.permutation(len(others))[:3]]
        if images := facts.pictures([id, met], 2):
            names = tuple(facts.names[k] for k in wrong)
            text = f"What does one meet first straight ahead of the front of {name}?"
            drafts.append(Draft(text, facts.names[met], images, {"object": id, "met": met}, names, hard=1))
    return some(drafts, rng, most)
