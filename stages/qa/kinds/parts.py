"""How many parts of a thing can be opened."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import blank, may_open
from apartgen.stages.things.categories import TABLE


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Doors, drawers, flaps and lids, each by its joint; an oven's drawer looks like its plinth."""
    drafts = []
    for it in facts.marked:
        o = facts.objects[it.id]
        oven = o.category in TABLE and TABLE[o.category].is_for("bake")
        if isinstance(o, Furnishing) and facts.fine(it) and not blank(o) and not oven and not may_open(o):
            text = f"How many doors, drawers, flaps and lids of {it} can be opened?"
            drafts.append(facts.numbered(it.view, text, str(len(o.joints)), {"object": it.id}))
    return shared(drafts, rng, most)
