"""How many parts of a thing can be opened."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import blank


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Doors, drawers, flaps and lids, each by its joint."""
    drafts = []
    for it in facts.marked:
        o = facts.objects[it.id]
        if isinstance(o, Furnishing) and facts.fine(it) and not blank(o):
            text = f"How many doors, drawers, flaps and lids of {it} can be opened?"
            drafts.append(facts.numbered(it.view, text, str(len(o.joints)), {"object": it.id}))
    return shared(drafts, rng, most)
