"""How many doors lie between two places."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import tells_its_place

TEXT = ("The first two pictures were taken in two places of a home, the third shows all of it from above. "
        "How many doors and open passages does one go through from the first place to the second?")


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """On the way with fewest doors and openings, where there is only one."""
    drafts = []
    places = [view for view in facts.eyes if view.room in facts.rooms and tells_its_place(facts, view)]
    above = facts.above()
    for a, b in combinations(places if above else [], 2):
        way = facts.way(a.room, b.room)
        if way is not None:
            images = [a.name, b.name, *above]
            evidence = {"views": images[:2], "doors": [o.id for o in way]}
            drafts.append(Draft(TEXT, str(len(way)), images, evidence, hard=len(way)))
    return shared(drafts, rng, most)
