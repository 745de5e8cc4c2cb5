"""Which ways to turn from the entrance to a thing behind two doors."""

from itertools import pairwise
from math import atan2, degrees

import numpy as np

from apartgen.schemas.plan import Opening
from apartgen.stages.qa.drafts import Draft, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.space import polygons

SIDES = (("straight on", -35.0, 35.0), ("left", 50.0, 130.0), ("right", -130.0, -50.0))
"""Turns by the direction of the next goal, degrees; what lies between is not asked for."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Seen on coming through the entrance and through each door, square to the wall."""
    drafts = []
    for entrance in (o for o in facts.home.openings if o.kind == "entrance"):
        for id, name in facts.names.items():
            o = facts.objects[id]
            way = facts.way(entrance.rooms[0], o.room) if o.room in facts.rooms else None
            images = facts.above()
            if not way or len(way) > 3 or not images or not facts.shares[images[0]].get(id, 0):
                continue
            turns = _turns(facts, [entrance, *way], o.center[:2], entrance.rooms[0])
            if None not in turns:
                text = (f"You come in through the entrance and go to {name} by the fewest doors. Where is each next "
                        "door, and at last the goal, as you come through the one before?")
                drafts.append(Draft(text, ", ".join(map(str, turns)), images,
                                    {"object": id, "doors": [o.id for o in way]}, hard=len(way)))
    return shared(drafts, rng, most)


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
