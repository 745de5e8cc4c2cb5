"""How many windows a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts

LEAST = 2e-4


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of the room of a panorama, which shows all of them; of balconies, one could count those of the home."""
    drafts = []
    for room in facts.rooms:
        windows = [o.id for o in facts.home.openings if o.kind == "window" and room in o.rooms]
        images = facts.room_pictures(room)
        if facts.rooms[room].base == "balcony" or not images:
            continue
        if all(facts.shares[images[0]].get(id, 0) > LEAST for id in windows):
            text = "How many windows does the room have that this picture shows all around?"
            drafts.append(Draft(text, str(len(windows)), images, {"room": room}))
    return shared(drafts, rng, most, fewest=2)
