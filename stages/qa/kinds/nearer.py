"""Which of two things is nearer to the camera."""

from itertools import combinations
from math import hypot

import numpy as np
from shapely.geometry import Point

from apartgen.schemas.render import View
from apartgen.stages.qa.drafts import Draft, either_way
from apartgen.stages.qa.facts import Facts


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """By the nearest points of their boxes."""
    drafts = []
    for view in facts.eyes:
        for (a, one), (b, other) in combinations(facts.alone(view.name).items(), 2):
            far = {name: _far(facts, view, o.id) for name, o in ((a, one), (b, other))}
            near, away = sorted(far, key=lambda name: far[name])
            if far[near] < 0.7 * far[away] - 0.2:
                drafts.append(Draft(f"Which of these is nearer to the camera, {a} or {b}?", near, [view.name],
                                    {"view": view.name, "objects": [one.id, other.id]}, (away,)))
    return either_way(drafts, rng, most)


def _far(facts: Facts, view: View, id: str) -> float:
    x, y, z = view.eye
    o = facts.objects[id]
    return hypot(facts.print(id).distance(Point(x, y)), max(0.0, abs(o.center[2] - z) - o.size[2] / 2))
