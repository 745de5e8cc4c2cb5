"""How large a room is."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import SEEN, in_sight
from apartgen.stages.space import polygons


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The clear floor of the room of a panorama, nothing of it round a corner."""
    drafts = []
    for room in facts.rooms:
        area = polygons.floor(facts.rooms[room]).area
        images = facts.room_pictures(room)
        if images and in_sight(facts, room, facts.views[images[0]]) > SEEN:
            text = "How large is the floor of the room that this picture shows all around?"
            evidence = {"room": room, "area": round(area, 2)}
            drafts.append(Draft(text, f"{area:.0f} m²", images, evidence, number=area, hard=1))
    return shared(drafts, rng, most)
