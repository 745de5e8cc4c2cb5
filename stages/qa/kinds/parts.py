"""How many parts of a thing can be opened."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Doors, drawers, flaps and lids, each by its joint."""
    drafts = []
    for id, name in facts.names.items():
        o = facts.objects[id]
        if isinstance(o, Furnishing) and (images := facts.pictures([id], 1, 0.01)):
            text = f"How many doors, drawers, flaps and lids of {name} can be opened?"
            drafts.append(Draft(text, str(len(o.joints)), images, {"object": id}))
    return shared(drafts, rng, most)
