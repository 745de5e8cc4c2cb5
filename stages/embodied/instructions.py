"""What to ask for in words: "open the top left drawer of the chest in the bedroom".

Left and right are those of somebody who stands before the object and looks at it. Rooms and objects are called by
their type and category; of two alike in a room the words do not tell which.
"""

from math import sqrt

import numpy as np

from apartgen.schemas.plan import Room
from apartgen.stages.embodied.outcome import Outcome
from apartgen.stages.embodied.world import World
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.asset import Link
from apartgen.stages.things.body import Body
from apartgen.stages.things.categories import those
from apartgen.stages.things.names import spoken, type_of
from apartgen.stages.things.solids import corners

NOUNS = {
    "slider_drawer": "drawer", "slider_door": "door", "hinge_door": "door", "slider_lid": "lid", "hinge_lid": "lid",
    "slider_button": "button", "hinge_knob": "knob", "hinge_handle": "handle",
}
"""Of a joint's `part` (GAPartNet's classes); a door that turns about a level axis is a flap."""
VERBS = {"button": "press", "knob": "turn", "handle": "turn"}
DOORS = those(lambda kind: kind.appliance)
"""What has a flap that everybody calls a door."""
APART = 0.05
"""Parts whose middles are nearer than this in height stand in one row, m."""
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth")


def task(apartment: World, outcome: Outcome) -> str:
    """What an episode of the benchmark asks for."""
    room = next(room for room in apartment.home.rooms if room.id == outcome.room)
    if outcome.episode == "navigation":
        there = f"{spoken(outcome.category)} in the {type_of(room)}" if outcome.object else type_of(room)
        return f"go to the {there}"
    body = apartment.bodies[outcome.object]
    return instruction(body, next(k for k in body.links if k.joint is not None and k.joint.name == outcome.joint), room)


def instruction(body: Body, link: Link, room: Room) -> str:
    """The task of opening one part of an object."""
    word = noun(body, link)
    same = [other for other in body.links if other.joint is not None and noun(body, other) == word]
    middles = np.array([_middle(other) for other in same])
    before, after = _which(middles, next(k for k, other in enumerate(same) if other is link))
    what = " ".join([*before, word, *after])
    return f"{VERBS.get(word, 'open')} the {what} of the {spoken(body.category)} in the {type_of(room)}"


def noun(body: Body, link: Link) -> str:
    """What people call a part that moves."""
    assert link.joint is not None
    word = NOUNS.get(link.joint.part, link.joint.part.rpartition("_")[2])
    level = abs(link.joint.axis[2]) < sqrt(0.5) * float(np.linalg.norm(link.joint.axis))
    return "flap" if link.joint.part == "hinge_door" and level and body.category not in DOORS else word


def _middle(link: Link) -> Array:
    """Where the part's middle is, (2,): left to right, as seen from before the object, and bottom to top."""
    points = [corners(c) for c in link.colliders] or [mesh.vertices for mesh in link.visuals]
    every = np.concatenate(points)
    middle = (every.min(0) + every.max(0)) / 2
    return np.asarray(middle[1:])


def _which(middles: Array, k: int) -> tuple[list[str], list[str]]:
    """Words before and after the noun that tell part `k` from the others."""
    order = np.argsort(-middles[:, 1], kind="stable")
    new = np.diff(-middles[order, 1], prepend=-np.inf) > APART
    row = np.empty(len(middles), int)
    row[order] = np.cumsum(new) - 1
    beside = np.flatnonzero(row == row[k])
    column = int((middles[beside, 0] < middles[k, 0] - 1e-6).sum())
    before, after = _place(int(row[k]), int(row.max()) + 1, ("top", "middle", "bottom"))
    more, last = _place(column, len(beside), ("left", "middle", "right"))
    return before + more, after + last


def _place(k: int, n: int, words: tuple[str, str, str]) -> tuple[list[str], list[str]]:
    """Where the k-th of n is: at an end, in the middle of three, or counted from the first end."""
    if n == 1:
        return [], []
    if k in (0, n - 1):
        return [words[0] if k == 0 else words[2]], []
    if n == 3:
        return [words[1]], []
    return [_ORDINALS[k] if k < len(_ORDINALS) else f"{k + 1}th"], ["from the", words[0]]
