"""What a thing stands or hangs on."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The floor, a wall, the ceiling or another thing."""
    drafts = []
    for id, name in facts.names.items():
        on = facts.objects[id].on
        carrier = f"the {on}" if on in ("floor", "wall", "ceiling") else facts.names.get(on or "")
        if carrier and (images := facts.pictures([id], 1)):
            drafts.append(Draft(f"What carries {name}?", carrier, images, {"object": id, "on": on}))
    return shared(drafts, rng, most)
