"""In which room a picture was taken."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Rooms by their types, of which the home may have several."""
    drafts = []
    for view in facts.render.views:
        if view.kind in ("eye", "panorama") and view.room in facts.rooms:
            answer = facts.rooms[view.room].type.replace("_", " ")
            text = "In what room was this picture taken?"
            drafts.append(Draft(f"{text}{'' if view.kind == 'eye' else ' It shows all around.'}", answer, [view.name],
                                {"view": view.name}))
    return shared(drafts, rng, most)
