"""How many windows a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts

LEAST = 2e-4


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """All of them are seen."""
    drafts = []
    for room, name in facts.room_names.items():
        windows = [o.id for o in facts.home.openings if o.kind == "window" and room in o.rooms]
        images = facts.room_pictures(room)
        if images and all(facts.shares[images[0]].get(id, 0) > LEAST for id in windows):
            drafts.append(Draft(f"How many windows does {name} have?", str(len(windows)), images, {"room": room}))
    return shared(drafts, rng, most)
