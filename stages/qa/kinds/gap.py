"""Whether a robot fits between two things."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, balanced
from apartgen.stages.qa.facts import MOSTLY, Facts, marked
from apartgen.stages.qa.plain import bounded
from apartgen.stages.things.categories import TABLE

WIDTH = 0.5
NARROW, WIDE = 0.25, 0.85
"""Gaps between these are not asked for, m."""
HIGHEST = 1.2
"""What hangs higher is in no robot's way, m."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Between things that stand on the floor of one room, not farther apart than one would ask for."""
    drafts = []
    for view, numbers in facts.marks.items():
        seen = facts.uncut(view, MOSTLY)
        for a, b in combinations((id for id in numbers if id in seen and _low(facts, id)), 2):
            wide = float(facts.print(a).distance(facts.print(b)))
            if _apart(facts, a, b) and (0.05 < wide < NARROW or WIDE < wide < 1.6):
                one, other = sorted((numbers[a], numbers[b]))
                text = (f"Could a robot {WIDTH * 100:.0f} cm wide pass between {marked(one)} and {marked(other)}, "
                        "if nothing else stood there?")
                right, wrong = ("yes", "no") if wide > WIDTH else ("no", "yes")
                evidence = {"objects": [a, b], "metres": round(wide, 3)}
                drafts.append(facts.numbered(view, text, right, evidence, (wrong,)))
    return balanced(drafts, rng, most)


def _apart(facts: Facts, a: str, b: str) -> bool:
    """In one room, and not a table before its sofa, which hides the floor between."""
    one, other = facts.objects[a], facts.objects[b]
    kinds = [TABLE.get(o.category) for o in (one, other)]
    low = any(kind is not None and "coffee_table" in kind.lineage for kind in kinds)
    return one.room == other.room and not (low and any(kind is not None and kind.is_for("sit") for kind in kinds))


def _low(facts: Facts, id: str) -> bool:
    o = facts.objects[id]
    low = o.on in (None, "floor") and o.center[2] - o.size[2] / 2 < HIGHEST and o.size[2] > 0.1
    return low and bounded(facts, id)
