"""How many windows a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import countable


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of the room of a panorama, which shows all of them; of balconies, one could count those of the home, and of rooms
    that lead to one its door.
    """
    drafts = []
    for room in facts.rooms:
        windows = [o.id for o in facts.home.openings if o.kind == "window" and room in o.rooms]
        images = facts.room_pictures(room)
        about = {room, *(id for o in facts.passages(room) for id in o.rooms if id in facts.rooms)}
        if any(facts.rooms[id].base == "balcony" for id in about) or not images:
            continue
        if countable(facts, images[0], windows):
            text = "How many windows does the room have that this picture shows all around?"
            drafts.append(Draft(text, str(len(windows)), images, {"room": room}))
    return shared(drafts, rng, most)
