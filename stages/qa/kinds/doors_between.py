"""How many doors lie between two things."""

from itertools import combinations

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts

MANY = 600


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """On the way with fewest doors and openings, where there is only one."""
    pairs = list(combinations(facts.names, 2))
    drafts = []
    for k in rng.permutation(len(pairs))[:MANY]:
        a, b = (facts.objects[id] for id in pairs[k])
        images = facts.above()
        if a.room not in facts.rooms or b.room not in facts.rooms or not images:
            continue
        if any(not facts.shares[images[0]].get(o.id, 0) for o in (a, b)):
            continue
        way = facts.way(a.room, b.room)
        if way is not None:
            ends = f"from {facts.names[a.id]} to {facts.names[b.id]}"
            text = f"How many doors and open passages does one go through {ends}?"
            evidence = {"objects": [a.id, b.id], "doors": [o.id for o in way]}
            drafts.append(Draft(text, str(len(way)), images, evidence, hard=len(way)))
    return shared(drafts, rng, most)
