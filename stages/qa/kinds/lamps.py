"""How many lamps a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.things.categories import TABLE


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """All of them are seen in the pictures."""
    drafts = []
    for room, name in facts.room_names.items():
        lamps = [o.id for o in facts.home.objects
                 if o.room == room and o.category in TABLE and TABLE[o.category].lumens > 0]
        images = facts.pictures(lamps, least=0.002) if lamps else facts.room_pictures(room)
        if images:
            drafts.append(Draft(f"How many lamps are there in {name}?", str(len(lamps)), images, {"room": room}))
    return shared(drafts, rng, most)
