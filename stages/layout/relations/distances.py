"""How far people like things from one another that are not used together in reach: what is watched, where one eats;
and beds from the walls along them."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.company import Seen
from apartgen.stages.layout.relations.hung import lit
from apartgen.stages.layout.relations.mutual import free
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.use import kinds

VIEW, STAND, SCREEN = 2.1, 0.4, 0.5
"""A sofa is no farther before the wall that it looks at, but for what stands there with the television, m, which needs
so much of it on both sides."""
FARTHER = 4.0
"""What each further metre costs, up to where a screen is too far off anyway."""
TOO_FAR = 1.0
MEALS, TOGETHER = 1.9, 10.0
"""From a dining table to a sofa, m, and what each metre less costs: a metre breaks a requirement."""
FOOT, NEARER = 0.8, 6.0
"""From it to a bed, m, and what each metre less costs."""
BY_SCREEN, CLOSE = (frozenset({"tv_stand"}), 0.5), 12.0
"""The same from an armchair, or a dining table, to what the television stands on: nearer stands one armchair of fifteen
of people's."""
SEATED = ((*BY_SCREEN, CLOSE),)
APART = ((kinds.SOFAS, MEALS, TOGETHER), (kinds.BEDS, FOOT, NEARER), *SEATED)
STRIP, BED, TIGHT = (0.05, 0.5), 0.6, 12.0
"""Between a bed of one and the wall along it nothing is lost or all that one gets in by, along a bed of two so much on
either side, m, and what each metre costs that could be had by moving it; beside a sofa other things matter more."""
ARRIVAL, FOOT_TO_SOFA = 1.5, (kinds.SOFAS, 0.5, CLOSE)
"""From a bed to the middle of the door by which one enters its room, and to the sofa before it, m, and what each metre
less costs (`NEARER` of the former)."""
GLARE = 4.0
"""Price of a screen before a window."""


def price(name: str, boxes: Array, found: Boxes, names: Sequence[str], there: Array, space: Space) -> Array:
    """Of candidates (n, 7), `found` the same, beside what stands there (m, 7): sofas far from what they look at,
    screens at windows, tables where one eats near to sofas or beds, they and armchairs at the television, beds with
    little beside them, at the entrance or at the sofa, (n,)."""
    kind = kinds.basic(name)
    if kind in kinds.SOFAS:
        view = np.max([ahead(found, space, aside) for aside in (0.0, SCREEN, -SCREEN)], 0) - STAND - VIEW
        return np.asarray(FARTHER * np.clip(view, 0, TOO_FAR))
    if kind == "tv_stand":
        return np.where(lit(boxes, space), GLARE, 0.0)
    total = _at_entrance(boxes, space) if kind in kinds.BEDS else np.zeros(len(boxes))
    if kind in kinds.BEDS and kinds.SOFAS.isdisjoint(map(kinds.basic, names)):
        total += TIGHT * _beside(kind in kinds.DOUBLE, found, space)
    for some, least, each in _apart(kind):
        if others := [k for k, o in enumerate(names) if kinds.basic(o) in some]:
            total += each * np.clip(least - Seen(boxes, there[others]).gap.min(1), 0, TOO_FAR)
    return total


def _beside(double: bool, found: Boxes, space: Space) -> Array:
    """How far beds would be moved to stand at a wall with one side, or for two to get out at both, m, (n,)."""
    half = found.size[:, 0] / 4
    turned = [Boxes(found.center, found.size[:, [1, 0, 2]], found.yaw + turn) for turn in (np.pi / 2, -np.pi / 2)]
    free = [np.min([ahead(side, space, aside) for aside in (half, 0.0, -half)], 0) for side in turned]
    near, far = np.minimum(*free), np.maximum(*free)
    short = np.minimum(BED - near, far - BED) if double else np.minimum(near - STRIP[0], STRIP[1] - near)
    return np.asarray(np.where(far > BED, np.maximum(short, 0.0), 0.0))


def _apart(kind: str) -> tuple[tuple[frozenset[str], float, float], ...]:
    """From what a kind stands rather so far, m, and what each metre less costs."""
    if kind in kinds.BEDS:
        return (FOOT_TO_SOFA,)
    return APART if kind in kinds.TABLES else SEATED if kind == "armchair" else ()


def _at_entrance(boxes: Array, space: Space) -> Array:
    """Of beds (n, 7) near the door by which one enters, (n,)."""
    if not len(space.entrances):
        return np.zeros(len(boxes))
    door = np.array([[x, y, 0, 0, 0, 0, 0] for x, y in space.entrances], np.float32)
    return np.asarray(NEARER * np.clip(ARRIVAL - Seen(boxes, door).gap.min(1), 0, TOO_FAR))


def ahead(found: Boxes, space: Space, aside: Array | float = 0.0) -> Array:
    """Free length from each front, `aside` of its middle, to the wall across, m, (n,)."""
    heading = np.stack([np.cos(found.yaw), np.sin(found.yaw)], -1)
    lines = space.walls.lines
    return free(found.center, found.size, heading, np.full(found.n, aside, float), heading @ space.normal.T,
                lines.start, lines.along, lines.normal, lines.length)
