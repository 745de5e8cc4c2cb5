"""How the parts of a thing move."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of things that open in one way only."""
    drafts = []
    for id, name in facts.names.items():
        o = facts.objects[id]
        if isinstance(o, Furnishing) and (images := facts.pictures([id], 1, 0.01)):
            ways = {_way(joint.type, joint.axis) for joint in o.joints}
            answer = " and ".join(sorted(ways)) or "nothing of it moves"
            drafts.append(Draft(f"How do the moving parts of {name} move?", answer, images, {"object": id}))
    return shared(drafts, rng, most)


def _way(type_: str, axis: tuple[float, float, float]) -> str:
    if type_ == "slide":
        return "slide"
    return "turn about an upright hinge" if abs(axis[2]) > 0.5 else "turn about a level hinge"
