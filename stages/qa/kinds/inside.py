"""What is on or inside a thing."""

from collections import defaultdict
from typing import Any

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.names import spoken

LEAST = 6e-4
"""Share of a picture from which small things can be told."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of homes with small things, where all that a thing holds or carries is seen and holds nothing itself; not of what
    stands under a worktop that goes on over others.
    """
    held = _held(facts)
    drafts = []
    for it in facts.marked:
        things = held.get(it.id, [])
        unseen = [o.id for o in things if facts.shares[it.view].get(o.id, 0) <= LEAST]
        more = facts.pictures(unseen, 2, LEAST)
        category = facts.objects[it.id].category
        plain = things and not any(o.id in held for o in things)
        if plain and (more or not unseen) and category in TABLE and not TABLE[category].run:
            answer = ", ".join(sorted({spoken(o.category) for o in things}))
            drafts.append(facts.numbered(it.view, f"What is on or inside {it}?", answer, {"object": it.id}, hard=1,
                                         more=more))
    return shared(drafts, rng, most)


def _held(facts: Facts) -> dict[str, list[Box]]:
    """What each thing holds, small things and such as stand on it, a lamp or a television."""
    held: dict[str, list[Box]] = defaultdict(list)
    for o in facts.home.objects:
        put: Any = getattr(o, "in_", None)
        holder = put.object if put is not None else o.on
        if holder in facts.objects:
            held[holder].append(o)
    return held
