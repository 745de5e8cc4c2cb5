"""How much room there is before the front of a thing that opens."""

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts, metres
from apartgen.stages.qa.fronts import before, parted
from apartgen.stages.qa.plain import fronted


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Straight ahead up to the first thing or wall without a door in it, the same over its whole width; the room is
    shown all around, too.
    """
    drafts = []
    for it in facts.marked:
        o = facts.objects[it.id]
        if not isinstance(o, Furnishing) or not o.joints or not fronted(facts, it.id):
            continue
        ahead = before(facts, it.id)
        if ahead is None:
            continue
        far, met = round(ahead[0], 3), ahead[1]
        if parted(facts, it.id, far):
            continue
        images = facts.room_pictures(o.room)
        if far > 0.25 and images and (not met or facts.shares[images[0]].get(met, 0) > 0):
            text = f"How far is it from the front of {it} straight ahead to the first thing or wall?"
            evidence = {"object": it.id, "met": met, "metres": far}
            drafts.append(facts.numbered(it.view, text, metres(far), evidence, number=far, hard=1, more=images))
    return shared(drafts, rng, most)
