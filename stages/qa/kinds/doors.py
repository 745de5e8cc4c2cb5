"""How many doors a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of the room of a panorama; the entrance and open passages are counted, too."""
    drafts = []
    for room in facts.rooms:
        images = [*facts.room_pictures(room), *facts.above()]
        if len(images) == 2:
            text = ("The first picture shows a room all around, the second its home from above. "
                    "How many doors and open passages does the room have, the entrance counted?")
            drafts.append(Draft(text, str(len(facts.passages(room))), images, {"room": room}, hard=1))
    return shared(drafts, rng, most)
