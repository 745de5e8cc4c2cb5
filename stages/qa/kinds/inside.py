"""What is inside a thing."""

from collections import defaultdict
from typing import Any

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, spoken


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of homes with small things in their cupboards and drawers."""
    held: dict[str, list[str]] = defaultdict(list)
    for o in facts.home.objects:
        put: Any = getattr(o, "in_", None)
        if put is not None:
            held[put.object].append(o.category)
    drafts = []
    for id, kinds in held.items():
        if id in facts.names and (images := facts.pictures([id], 1)):
            answer = ", ".join(sorted({spoken(kind) for kind in kinds}))
            drafts.append(Draft(f"What is on or inside {facts.names[id]}?", answer, images, {"object": id}, hard=1))
    return shared(drafts, rng, most)
