"""Which ways to turn from the entrance to where a picture was taken."""

from itertools import pairwise, product
from math import atan2, degrees

import numpy as np

from apartgen.schemas.plan import Opening
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import tells_its_place
from apartgen.stages.space import polygons

SIDES = (("straight on", -20.0, 20.0), ("left", 50.0, 130.0), ("right", -130.0, -50.0))
"""Turns by the direction of the next goal, degrees; what lies between is not asked for."""
ENTRANCE = 0.001
"""Share of the view from above that the entrance's door covers where one finds it."""
ABOUT = 0.35
"""Nobody tells more exactly where a picture was taken, m."""
FARTHEST = 3
"""Doors behind the entrance."""
TEXT = ("The second picture shows a home from above. You come in through the entrance and go to where the first one "
        "was taken, by the fewest doors. Where is each next door, and at last the goal, as you come through the one "
        "before?")


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Seen on coming through the entrance and through each door, square to the wall."""
    drafts = []
    for entrance in (o for o in facts.home.openings if o.kind == "entrance" and _seen(facts, o)):
        for view in (view for view in facts.eyes if tells_its_place(facts, view)):
            way = facts.way(entrance.rooms[0], view.room) if view.room in facts.rooms else None
            if not way or len(way) > FARTHEST or not facts.above():
                continue
            turns = _sure(facts, [entrance, *way], view.eye[:2], entrance.rooms[0])
            if turns:
                evidence = {"view": view.name, "doors": [o.id for o in way]}
                drafts.append(Draft(TEXT, ", ".join(map(str, turns)), [view.name, *facts.above()], evidence,
                                    hard=len(way)))
    found: list[Draft] = []
    for doors in range(1, FARTHEST + 1):
        far = [draft for draft in drafts if draft.hard == doors]
        found += shared(far, rng, most - len(found)) if len(found) < most else []
    return found


def _seen(facts: Facts, entrance: Opening) -> bool:
    """Whether the view from above shows where one comes in."""
    return any(facts.shares[view].get(entrance.id, 0) > ENTRANCE for view in facts.above())


def _sure(facts: Facts, way: list[Opening], goal: tuple[float, float], room: str) -> list[str]:
    """The turns, where they are the same for every place about the goal; none where any of them is not told."""
    about = [(goal[0] + ABOUT * dx, goal[1] + ABOUT * dy) for dx, dy in product((-1, 0, 1), repeat=2)]
    first, *others = ([str(turn) for turn in _turns(facts, way, place, room)] for place in about)
    return first if "None" not in first and all(turns == first for turns in others) else []


def _turns(facts: Facts, way: list[Opening], goal: tuple[float, float], room: str) -> list[str | None]:
    """The turn behind every door of the way, towards the next door and at last the goal."""
    middles = [((o.segment[0][0] + o.segment[1][0]) / 2, (o.segment[0][1] + o.segment[1][1]) / 2) for o in way]
    found = []
    for o, (here, there) in zip(way, pairwise([*middles, goal])):
        room = room if len(o.rooms) == 1 else next(r for r in o.rooms if r != room)
        normal, _ = polygons.face(o, facts.home, room)
        angle = degrees(atan2(there[1] - here[1], there[0] - here[0]) - atan2(normal[1], normal[0]))
        angle = (angle + 180) % 360 - 180
        found.append(next((name for name, low, high in SIDES if low < angle < high), None))
    return found
