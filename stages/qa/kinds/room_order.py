"""In which order a film of a walk goes through rooms."""

from itertools import combinations, permutations

import numpy as np

from apartgen.schemas.render import Film
from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.films import stays

TEXT = "The video shows a walk through a home. In which order does it first come into these rooms?"
ROOMS = 3
LEAST = 1.0
"""How long the camera is in a room at least, s."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Rooms that are the only ones of their types, none open to another of them."""
    film = facts.render.film
    if film is None:
        return []
    first = _entered(facts, film)
    drafts = []
    for some_rooms in combinations(first, ROOMS):
        if facts.joined([facts.type_of(id) for id in some_rooms]):
            continue
        orders = [", ".join(f"the {facts.type_of(id)}" for id in order) for order in permutations(some_rooms)]
        wrong = tuple(orders[k] for k in 1 + rng.permutation(len(orders) - 1)[:3])
        evidence = {"rooms": list(some_rooms), "seconds": [first[id] for id in some_rooms]}
        drafts.append(Draft(TEXT, orders[0], [], evidence, wrong, hard=1, videos=[film.file]))
    return some(drafts, rng, most)


def _entered(facts: Facts, film: Film) -> dict[str, float]:
    """When the camera first comes into each room, in that order; without rooms that it only ever brushes."""
    types = [room.type for room in facts.home.rooms]
    stayed, found = stays(film), dict[str, float]()
    long = {id for id, start, end in stayed if end - start >= LEAST}
    for id, start, _ in stayed:
        if id in long and types.count(facts.rooms[id].type) == 1:
            found.setdefault(id, start)
    return found
