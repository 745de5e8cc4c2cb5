"""How many things of a kind there are in a room."""

from collections import defaultdict

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, spoken


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """All that is counted is seen in the pictures."""
    groups: dict[tuple[str, str], list[str]] = defaultdict(list)
    for o in facts.home.objects:
        groups[o.room, o.category].append(o.id)
    drafts = []
    for (room, category), ids in groups.items():
        if room in facts.room_names and (images := facts.pictures(ids, least=0.002)):
            text = f"How many things of this kind are there in {facts.room_names[room]}: {spoken(category)}?"
            drafts.append(Draft(text, str(len(ids)), images, {"room": room, "category": category}, hard=len(ids) // 3))
    return shared(drafts, rng, most)
