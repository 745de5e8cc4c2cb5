"""How many things of a kind there are in a room."""

from collections import Counter

import numpy as np

from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import countable, side_by_side
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.names import alike, spoken

OVERLOOKED = {"bin", "dressing_table", "laundry_basket", "mirror", "radiator", "vanity"}
"""What one sees only by what it shows; what others call something else, as a table to dress at, or take for something
else, as a bin for a basket; what may be behind a sofa."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Of the rooms of panoramas that show all of them, none of another room, and nothing that one may take for them;
    each kind has several answers. Cloth is not counted, a curtain may be two, nor what is part of a kitchen, a
    dishwasher may look like a cabinet, nor mirrors, which one overlooks where they show tiles before tiles, nor what
    has its name of two things, nor what is named by how it opens, nor two that
    stand close together.
    """
    known = {o.category for o in facts.home.objects if o.category in TABLE}
    kinds = sorted({spoken(name) for name in known if _plain(name)})
    asked = [_of(facts, kinds[k]) for k in rng.permutation(len(kinds))]
    found: list[Draft] = []
    for drafts in sorted(asked, key=lambda some: -len({draft.answer for draft in some})):
        if len(found) < most:
            found += shared(drafts, rng, most - len(found))
    return found


def _plain(name: str) -> bool:
    return not (TABLE[name].soft or TABLE[name].run or TABLE[name].opens == "sliding" or name in OVERLOOKED)


def _called(facts: Facts, kind: str) -> set[str]:
    """Categories of the home that are called so."""
    return {o.category for o in facts.home.objects if spoken(o.category) == kind}


def _of(facts: Facts, kind: str) -> list[Draft]:
    drafts = []
    for room in facts.rooms:
        for image in facts.room_pictures(room):
            seen = {id for id, share in facts.shares[image].items()
                    if id in facts.objects and kind in spoken(facts.objects[id].category)}
            there = {o.id for o in facts.home.objects if o.room == room and kind in spoken(o.category)}
            if any(spoken(other) != kind and alike(one, other) for one in _called(facts, kind)
                   for other in {facts.objects[id].category for id in facts.shares[image] if id in facts.objects}):
                continue
            names = Counter(spoken(facts.objects[id].category) for id in there)
            plain = countable(facts, image, there) and not side_by_side(facts, there)
            if seen == there and set(names) <= {kind} and plain:
                text = f"How many things of this kind are there in the room that this picture shows all around: {kind}?"
                evidence = {"room": room, "kind": kind}
                drafts.append(Draft(text, str(len(there)), [image], evidence, hard=len(there) // 3))
    return drafts
