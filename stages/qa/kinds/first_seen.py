"""In which order four things first appear in a film of a walk through the home."""

from itertools import permutations

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.films import in_order, sights

TEXT = "The video shows a walk through a home. In which order do these things first appear in it?"
TRIES = 200


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Things of which each is seen clearly before there is a glimpse of the next."""
    film = facts.render.film
    alone = {o.id for o in facts.home.objects if facts.meanings[o.category] == 1}
    seen = {id: sight for id, sight in sights(facts, film).items() if id in alone} if film else {}
    ids, drafts = sorted(seen), []
    for _ in range(TRIES if film and len(ids) >= 4 else 0):
        four = sorted((ids[k] for k in rng.permutation(len(ids))[:4]), key=lambda id: seen[id].clear)
        if film and in_order([seen[id] for id in four]):
            orders = [", ".join(facts.names[id] for id in order) for order in permutations(four)]
            wrong = tuple(orders[k] for k in 1 + rng.permutation(len(orders) - 1)[:3])
            evidence = {"order": four, "seconds": [seen[id].clear for id in four]}
            drafts.append(Draft(TEXT, orders[0], [], evidence, wrong, hard=2, videos=[film.file]))
    return some(drafts, rng, most)
