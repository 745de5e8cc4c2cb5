"""How many doors a room has."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The entrance and open passages are counted, too."""
    drafts = []
    for room, name in facts.room_names.items():
        doors = facts.passages(room)
        images = [*facts.room_pictures(room), *facts.above()]
        if len(images) == 2:
            text = f"How many doors and open passages does {name} have, the entrance counted?"
            drafts.append(Draft(text, str(len(doors)), images, {"room": room}, hard=1))
    return shared(drafts, rng, most)
