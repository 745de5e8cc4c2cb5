"""Whether a thing has a part that opens."""

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft, balanced
from apartgen.stages.qa.facts import MOSTLY, Facts, marked
from apartgen.stages.qa.plain import blank, may_open
from apartgen.stages.qa.whole import before_front
from apartgen.stages.things.categories import TABLE

OFTEN = {"bin", "desk", "dressing_table", "hob", "island", "laundry_basket", "piano", "shower", "workbench"}
"""What as often opens as not, or in ways that one hardly sees."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of what stands on the floor, mostly in sight: what opens, from before its front, and what plainly does not."""
    drafts = []
    for view, numbers in facts.marks.items():
        for id in (id for id in numbers if id in facts.uncut(view, MOSTLY)):
            answer = _answer(facts.objects[id]) if before_front(facts.views[view], facts.objects[id]) else ""
            if answer:
                text = f"Has {marked(numbers[id])} a door, a drawer, a flap or a lid that opens?"
                wrong = "no" if answer == "yes" else "yes"
                drafts.append(facts.numbered(view, text, answer, {"object": id}, (wrong,)))
    return balanced(drafts, rng, most)


def _answer(o: Box) -> str:
    """`yes`, `no`, or empty where it is not beyond doubt."""
    kind = TABLE.get(o.category)
    if kind is None or kind.place != "floor" or o.category in OFTEN or not isinstance(o, Furnishing):
        return ""
    if kind.opens:
        return "yes" if o.joints and not blank(o) else ""
    return "no" if not o.joints and not may_open(o) else ""
