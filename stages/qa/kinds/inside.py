"""What is on or inside a thing."""

from collections import defaultdict
from typing import Any

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, spoken

LEAST = 6e-4
"""Share of a picture from which small things can be told."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of homes with small things, where all that a thing holds is seen."""
    held: dict[str, list[Box]] = defaultdict(list)
    for o in facts.home.objects:
        put: Any = getattr(o, "in_", None)
        if put is not None:
            held[put.object].append(o)
    drafts = []
    for id, things in held.items():
        if id in facts.names and (images := facts.pictures([id, *(o.id for o in things)], 3, LEAST)):
            answer = ", ".join(sorted({spoken(o.category) for o in things}))
            drafts.append(Draft(f"What is on or inside {facts.names[id]}?", answer, images, {"object": id}, hard=1))
    return shared(drafts, rng, most)
