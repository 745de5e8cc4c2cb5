"""In which room the camera of a film is at a time."""

from dataclasses import replace

import numpy as np

from apartgen.stages.qa.drafts import Draft, balanced
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.films import stays

SURE = 0.8
"""How long before and after that it is in the same room, s."""
MOST = 4
"""Rooms to choose from."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Rooms by their types, none open to another of them, each right as often as every other; whole seconds."""
    film, drafts = facts.render.film, list[Draft]()
    if film is None:
        return []
    for room, start, end in stays(film):
        for k in range(int(end) + 1):
            if room in facts.rooms and start + SURE <= k <= end - SURE:
                text = f"In what room is the camera {k} seconds into this video of a walk through a home?"
                drafts.append(Draft(text, facts.type_of(room), [], {"room": room, "seconds": [float(k)]},
                                    videos=[film.file]))
    types = sorted({draft.answer for draft in drafts})
    chosen: list[str] = []
    for k in rng.permutation(len(types)):
        if len(chosen) < MOST and not facts.joined([*chosen, types[k]]):
            chosen.append(types[k])
    kept = [replace(draft, wrong=tuple(name for name in chosen if name != draft.answer))
            for draft in drafts if draft.answer in chosen]
    return balanced(kept, rng, most) if len(chosen) > 1 else []
