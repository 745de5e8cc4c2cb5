"""How long the longest side of a thing is."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, centimetres


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of its box."""
    drafts = []
    for id, name in facts.names.items():
        size = max(facts.objects[id].size)
        if images := facts.pictures([id], 1, 0.01):
            text = f"How long is the longest side of {name}?"
            evidence = {"object": id, "metres": round(size, 3)}
            drafts.append(Draft(text, centimetres(size), images, evidence, number=size))
    return shared(drafts, rng, most)
