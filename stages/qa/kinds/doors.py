"""How many doors a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts

SHOWS = 0.0005
"""Share of a panorama of which a door is at least, so that one sees it; those without leaves are seen from above."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of the room of a panorama; the entrance and open passages are counted, too."""
    drafts = []
    for room in facts.rooms:
        images = [*facts.room_pictures(room), *facts.above()]
        seen = facts.shares[images[0]] if images else {}
        doors = [door.id for door in facts.passages(room) if door.kind != "opening"]
        if len(images) == 2 and all(seen.get(id, 0) > SHOWS for id in doors):
            text = ("The first picture shows a room all around, the second its home from above. "
                    "How many doors and open passages does the room have, the entrance counted?")
            drafts.append(Draft(text, str(len(facts.passages(room))), images, {"room": room}, hard=1))
    return shared(drafts, rng, most)
