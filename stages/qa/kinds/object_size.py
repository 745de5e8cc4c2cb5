"""How long the longest side of a thing is."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, centimetres
from apartgen.stages.qa.plain import at_edge, bounded


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of its box, where one sees its ends, and no edge of the picture is in the way."""
    drafts = []
    for it in (it for it in facts.marked if bounded(facts, it.id) and not at_edge(facts, it.id, it.view)):
        size = max(facts.objects[it.id].size)
        evidence = {"object": it.id, "metres": round(size, 3)}
        text = f"How long is the longest side of {it}?"
        drafts.append(facts.numbered(it.view, text, centimetres(size), evidence, number=size))
    return shared(drafts, rng, most)
