"""Which of two things is nearer to the camera."""

from itertools import combinations
from math import hypot

import numpy as np
from shapely.geometry import Point

from apartgen.schemas.render import View
from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import MOSTLY, Facts, marked
from apartgen.stages.qa.plain import bounded, edgewise, overhead

CLEARLY, MORE = 0.6, 0.4
"""The one is nearer than this share of the other's distance, and by so much, m."""


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """By the nearest points of the boxes of things that are mostly in sight, neither overhead nor edge-on at a wall."""
    drafts = []
    for view, numbers in facts.marks.items():
        here, seen = facts.views[view], facts.uncut(view, MOSTLY)
        plain = [id for id in numbers if id in seen and bounded(facts, id) and not overhead(facts.objects[id])
                 and not edgewise(facts.objects[id], here)]
        for a, b in combinations(plain, 2):
            (near, id), (far, other) = sorted((_far(facts, here, id), id) for id in (a, b))
            if near < CLEARLY * far - MORE:
                one, two = sorted((numbers[a], numbers[b]))
                text = f"Which of these is nearer to the camera, {marked(one)} or {marked(two)}?"
                drafts.append(facts.numbered(view, text, marked(numbers[id]), {"objects": [a, b]},
                                             (marked(numbers[other]),)))
    return some(drafts, rng, most)


def _far(facts: Facts, view: View, id: str) -> float:
    x, y, z = view.eye
    o = facts.objects[id]
    return hypot(facts.print(id).distance(Point(x, y)), max(0.0, abs(o.center[2] - z) - o.size[2] / 2))
