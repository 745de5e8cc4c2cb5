"""How the parts of a thing open."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import hides_how, may_open
from apartgen.stages.things.categories import TABLE


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of things that open in one way or, but for a kitchen's, in several, and of such as do not; none that is much like
    what opens otherwise.
    """
    drafts = []
    for it in facts.marked:
        o = facts.objects[it.id]
        if isinstance(o, Furnishing) and facts.fine(it) and not hides_how(o) and not may_open(o):
            ways = {_way(joint.type, joint.axis) for joint in o.joints}
            if len(ways) > 1 and o.category in TABLE and TABLE[o.category].run:
                continue
            answer = " and ".join(sorted(ways)) or "it has none"
            text = f"How do the doors, drawers, flaps and lids of {it} open?"
            drafts.append(facts.numbered(it.view, text, answer, {"object": it.id}))
    return shared(drafts, rng, most)


def _way(type_: str, axis: tuple[float, float, float]) -> str:
    if type_ == "slide":
        return "slide"
    return "turn about an upright hinge" if abs(axis[2]) > 0.5 else "turn about a level hinge"
