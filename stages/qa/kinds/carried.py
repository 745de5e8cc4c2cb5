"""What a thing stands or hangs on."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The floor, a wall, the ceiling or another thing."""
    drafts = []
    for it in facts.marked:
        on = facts.objects[it.id].on
        if on:
            carrier = f"the {on}" if on in ("floor", "wall", "ceiling") else "another thing"
            drafts.append(facts.numbered(it.view, f"What carries {it}?", carrier, {"object": it.id, "on": on}))
    return shared(drafts, rng, most)
