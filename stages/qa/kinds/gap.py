"""Whether a robot fits between two things."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, balanced
from apartgen.stages.qa.facts import Facts

WIDTH = 0.5
NARROW, WIDE = 0.4, 0.65
"""Gaps between these are not asked for, m."""
HIGHEST = 1.2
"""What hangs higher is in no robot's way, m."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Between things that stand on the floor of one room, not farther apart than one would ask for."""
    drafts = []
    for room in facts.rooms:
        low = [id for id in facts.named_in(room) if _low(facts, id)]
        for a, b in combinations(low, 2):
            wide = float(facts.print(a).distance(facts.print(b)))
            if not (0.05 < wide < NARROW or WIDE < wide < 1.6):
                continue
            if images := facts.pictures((a, b), 2):
                answer = "yes" if wide > WIDTH else "no"
                text = (f"Could a robot {WIDTH * 100:.0f} cm wide pass between {facts.names[a]} and {facts.names[b]}, "
                        "if nothing else stood there?")
                drafts.append(Draft(text, answer, images, {"objects": [a, b], "metres": round(wide, 3)},
                                    ("no" if answer == "yes" else "yes",)))
    return balanced(drafts, rng, most)


def _low(facts: Facts, id: str) -> bool:
    o = facts.objects[id]
    return o.on in (None, "floor") and o.center[2] - o.size[2] / 2 < HIGHEST and o.size[2] > 0.1
