"""What a thing stands or hangs on."""

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import on_a_rug

EITHER = {"radiator", "shower"}
"""What as often has feet as brackets, and what stands on its tray."""
ALL = 0.93
"""Share of its width and height of which a thing shows at least where its underside is in sight."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The floor, a wall, the ceiling or another thing; a rug is both of these."""
    drafts = []
    for it in facts.marked:
        on, hidden = facts.objects[it.id].on, it.id not in facts.uncut(it.view, ALL)
        if on and not hidden and facts.objects[it.id].category not in EITHER and not on_a_rug(facts, it.id):
            carrier = f"the {on}" if on in ("floor", "wall", "ceiling") else "another thing"
            drafts.append(facts.numbered(it.view, f"What carries {it}?", carrier, {"object": it.id, "on": on}))
    return shared(drafts, rng, most)
