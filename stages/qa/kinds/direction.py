"""Where a thing is to somebody who stands by one and faces another."""

from collections.abc import Iterable, Mapping
from itertools import combinations, permutations
from math import atan2, degrees, dist

import numpy as np
from shapely import get_coordinates
from shapely.affinity import scale

from apartgen.schemas.layout import Box
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import edgewise, flat, overhead
from apartgen.stages.qa.whole import before_front
from apartgen.stages.things.categories import TABLE

NEAREST = 0.8
"""Things nearer to where one stands have no clear direction, m."""
SLACK = 12.0
"""What is nearer to a border between quarters is not asked for, degrees."""
QUARTERS = ("ahead to the left", "behind to the left", "behind to the right", "ahead to the right")
BESIDE = 0.35
"""Somebody who stands by a thing is anywhere about it up to so far from it, m."""
MOST_OF = 0.7
"""Share of a thing's width and depth that lies to one side, at least."""
MANY = 800

Place = tuple[float, float]


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """By the middles of three things of one room, from the middle of the first, which stands on the floor, and from
    everywhere beside it, and to most of the third; the second does not hang overhead, and no rug nor curtain is
    meant, which may go on under something, or hang apart.
    """
    known = {view.name: facts.known(view.name) & {o.id for o in facts.clear(view.name)
                                                  if before_front(view, o) and not edgewise(o, view)}
             for view in facts.eyes}
    triples = [three for room in facts.rooms for three in permutations(facts.named_in(room), 3)]
    drafts = []
    for k in rng.permutation(len(triples))[:MANY]:
        at, to, of = triples[k]
        here, there, where = (facts.objects[id].center[:2] for id in triples[k])
        near = min(dist(here, there), dist(here, where)) < NEAREST
        unclear = overhead(facts.objects[to]) or any(_loose(facts.objects[id]) for id in (to, of))
        if near or unclear or not facts.stands(at):
            continue
        quarter, rest = _quarter(here, there, where)
        around = get_coordinates(facts.print(at).buffer(BESIDE, join_style="mitre"))
        ends = get_coordinates(scale(facts.print(of), MOST_OF, MOST_OF))
        if any(_quarter((x, y), there, where)[0] != quarter for x, y in around.tolist()) \
                or any(_quarter(here, there, (x, y))[0] != quarter for x, y in ends.tolist()):
            continue
        if SLACK < rest < 90 - SLACK and (images := _pictures(known, triples[k])):
            names = facts.names
            text = f"You stand by {names[at]} and face {names[to]}. Where is {names[of]}?"
            drafts.append(Draft(text, QUARTERS[int(quarter)], images, {"at": at, "facing": to, "of": of}, hard=2))
    return shared(drafts, rng, most)


def _loose(o: Box) -> bool:
    """Rugs and curtains, of which one does not see all, or sees two parts, and what may be taken for a mirror."""
    return flat(o) or o.category in TABLE and (TABLE[o.category].soft or TABLE[o.category].opens == "sliding")


def _pictures(known: Mapping[str, set[str]], three: Iterable[str]) -> list[str]:
    """One view that shows most of each thing, or two with a thing in both, which ties them; none without."""
    wanted = set(three)
    for names in (*((name,) for name in known), *combinations(known, 2)):
        seen = [known[name] for name in names]
        if wanted <= set.union(*seen) and set.intersection(*seen):
            return list(names)
    return []


def _quarter(here: Place, there: Place, where: Place) -> tuple[float, float]:
    """Which quarter about the way from here to there a place lies in, and how far it is into it, degrees."""
    angle = degrees(atan2(where[1] - here[1], where[0] - here[0]) - atan2(there[1] - here[1], there[0] - here[0]))
    return divmod(angle % 360, 90)
