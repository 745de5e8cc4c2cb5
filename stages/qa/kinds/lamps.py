"""How many lamps a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import countable
from apartgen.stages.things.categories import TABLE


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of the room of a panorama, which shows all of them."""
    drafts = []
    for room in facts.rooms:
        lamps = [o.id for o in facts.home.objects
                 if o.room == room and o.category in TABLE and TABLE[o.category].lumens > 0]
        images = facts.room_pictures(room)
        if images and countable(facts, images[0], lamps):
            text = "How many lamps are there in the room that this picture shows all around?"
            drafts.append(Draft(text, str(len(lamps)), images, {"room": room}))
    return shared(drafts, rng, most)
