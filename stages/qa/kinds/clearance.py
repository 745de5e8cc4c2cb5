"""How much room there is before the front of a thing that opens."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, metres
from apartgen.stages.qa.fronts import before


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Straight ahead, over its whole width, up to the first thing or wall."""
    drafts = []
    for id, name in facts.names.items():
        o = facts.objects[id]
        if not isinstance(o, Furnishing) or not o.joints:
            continue
        far, met = before(facts, id)
        if far > 0.25 and (images := facts.pictures([id, *([met] if met else [])], 2)):
            text = f"How far is it from the front of {name} straight ahead to the first thing or wall?"
            evidence = {"object": id, "met": met, "metres": round(far, 3)}
            drafts.append(Draft(text, metres(far), images, evidence, number=far, hard=1))
    return shared(drafts, rng, most)
