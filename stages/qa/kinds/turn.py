"""Which way the camera turned between two pictures."""

from itertools import pairwise
from math import atan2, degrees

import numpy as np

from apartgen.schemas.render import View
from apartgen.stages.qa.drafts import Draft, balanced
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.plain import shifted

LEAST, LARGEST = 20.0, 75.0
"""Degrees between which the turn can be told from the pictures."""
WORDS = ("to the left", "to the right")


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """Between frames on the robot's way that follow one another, where what both show moves the other way."""
    drafts = []
    for a, b in pairwise(view for view in facts.render.views if view.kind == "route"):
        by = (_heading(b) - _heading(a) + 180) % 360 - 180
        move = shifted(facts, a, b)
        if LEAST < abs(by) < LARGEST and move is not None and (move > 0) == (by > 0):
            left, right = WORDS if by > 0 else WORDS[::-1]
            drafts.append(Draft("Which way did the camera turn from the first picture to the second?", left,
                                [a.name, b.name], {"views": [a.name, b.name], "degrees": round(by, 1)}, (right,)))
    return balanced(drafts, rng, most)


def _heading(view: View) -> float:
    """Yaw of what lies ahead of the camera, degrees."""
    return degrees(atan2(view.pose[1][2], view.pose[0][2]))
