"""What stands before a thing."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.fronts import before


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The first thing straight ahead of its front, over its whole width; things of one room share their answers."""
    found: list[Draft] = []
    for room in facts.rooms:
        drafts = []
        for id in facts.named_in(room):
            _, met = before(facts, id)
            if met in facts.names and (images := facts.pictures([id, met], 2)):
                text = f"What does one meet first straight ahead of the front of {facts.names[id]}?"
                evidence = {"object": id, "met": met}
                own = frozenset({facts.names[id]})
                drafts.append(Draft(text, facts.names[met], images, evidence, hard=1, barred=own))
        if len(found) < most:
            found += shared(drafts, rng, most - len(found), fewest=2)
    return found
