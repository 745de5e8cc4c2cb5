"""How large a room is."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.space import polygons


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Its clear floor."""
    drafts = []
    for room, name in facts.room_names.items():
        area = polygons.floor(facts.rooms[room]).area
        if images := facts.room_pictures(room):
            text = f"How large is the floor of {name}?"
            evidence = {"room": room, "area": round(area, 2)}
            drafts.append(Draft(text, f"{area:.0f} m²", images, evidence, number=area, hard=1))
    return shared(drafts, rng, most)
