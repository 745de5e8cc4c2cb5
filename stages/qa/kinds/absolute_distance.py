"""How far two things are from each other."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import MOSTLY, Facts, marked, metres
from apartgen.stages.qa.plain import bounded, edgewise, overhead
from apartgen.stages.things.categories import TABLE

NEAREST = 0.4
"""What is nearer is not asked for, m."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Between the nearest points of the boxes of two things in one picture and room, most of both in sight, neither
    overhead, nor edge-on at a wall, nor small, as a pan of which one may mean the handle.
    """
    drafts = []
    for view, numbers in facts.marks.items():
        seen = facts.uncut(view, MOSTLY)
        plain = [id for id in numbers if id in seen and bounded(facts, id) and facts.objects[id].category in TABLE
                 and not overhead(facts.objects[id]) and not edgewise(facts.objects[id], facts.views[view])]
        for a, b in combinations(plain, 2):
            far = facts.apart(a, b)
            if far > NEAREST and facts.objects[a].room == facts.objects[b].room:
                one, other = sorted((numbers[a], numbers[b]))
                text = f"How far is {marked(one)} from {marked(other)}, between their nearest points?"
                evidence = {"objects": [a, b], "metres": round(far, 3)}
                drafts.append(facts.numbered(view, text, metres(far), evidence, number=far))
    return shared(drafts, rng, most)
