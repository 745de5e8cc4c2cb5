"""A television straight across from its sofa, or from the bed where there is none: places, and what others cost."""

from collections import Counter
from collections.abc import Callable, Sequence

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.company import FAR, Seen, alone
from apartgen.stages.layout.relations.distances import GLARE, ahead
from apartgen.stages.layout.relations.places import OFF, about, along, likeliest
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.use import kinds

SCREEN, SIZE, TURN = "tv_stand", (0.4, 1.2, 0.5), float(np.pi)
"""What a television stands on, the least of it, m, and how it is turned from who watches."""
TELEVISION = "tv"
ASIDES = (0.0, 0.15, -0.15)
"""So far beside the sofa's axis it may be, too, m."""
FREE, MOST, EACH = 0.2, 1.0, 20.0
"""Nobody minds so much, m; what each metre more costs, up to that."""
ON_IT = 0.15
"""Nearer to its middle, m, something above the floor is on it, or hangs over it."""
ACROSS = -0.9
"""What looks back at one does within this cosine."""


def places(name: str, boxes: Array, names: Sequence[str], there: Array, space: Space) -> Array:
    """Places (m, 7) for what a television stands on at the wall across, in the likeliest size of candidates (n, 7)."""
    seats = _watching(names, there) if kinds.basic(name) == SCREEN else boxes[:0]
    if not len(seats):
        return boxes[:0]
    deep, wide, high = likeliest(boxes)
    far = seats[:, 3] / 2 + ahead(upright(seats), space) - OFF - deep / 2
    return np.concatenate([about(seat, [(float(x), aside, TURN) for aside in ASIDES], (deep, wide, high))
                           for seat, x in zip(seats, far, strict=True)])


def price(there: Furniture, name: str, boxes: Array, left: Sequence[str]) -> Array:
    """Of candidates (n, 7) for it, or for the sofa before it is put there: what they are beside the axis of who
    watches, (n,)."""
    aside = np.zeros(len(boxes))
    if kinds.basic(name) == SCREEN and len(seats := _watching(there.names, there.boxes)):
        aside = np.abs(Seen(boxes, seats[:1]).to[:, 0, 1])
    elif kinds.basic(name) in kinds.SOFAS and SCREEN in map(kinds.basic, left) and len(shown := _shown(there)):
        seen = Seen(boxes, shown)
        facing = np.cos(boxes[:, None, 2] - shown[None, :, 2]) < ACROSS
        aside = np.where(facing & (seen.x > 0) & (seen.gap < FAR), np.abs(seen.y), np.inf).min(1)
        aside[~np.isfinite(aside)] = 0.0
    return np.asarray(EACH * np.clip(aside - FREE, 0.0, MOST - FREE))


def watched(there: Furniture, fixed: int, empty: Callable[[], Furniture], asked: Counter[str]) -> Furniture:
    """The furniture without what a television stands on that nobody sees from bed where there is no sofa, and without
    what is on it; the first `fixed` are given and stay, as does what is asked for, and what carries it.

    A bed comes after it, as in what the model learned, and finds its place elsewhere in one room of five."""
    names = [kinds.basic(o) for o in there.names]
    if asked[TELEVISION]:
        return there
    unseen = [k for k in range(fixed, len(names)) if names[k] == SCREEN and not asked[there.names[k]]
              and alone(SCREEN, there.boxes[k][None], there.names, there.boxes)[0]]
    if not unseen or not kinds.SOFAS.isdisjoint(names):
        return there
    off = np.abs(there.boxes[:, None, :2] - there.boxes[None, unseen, :2]).max(-1) < ON_IT
    on = off.any(1) & (there.boxes[:, 5] > 0.1)
    rest = empty()
    for k in (k for k in range(len(names)) if k < fixed or not (k in unseen or on[k])):
        rest.add(there.names[k], there.boxes[k])
    return rest


def _shown(there: Furniture) -> Array:
    """Places (m, 7) of a screen at walls, rather not before windows."""
    found = along(there.space, SIZE)
    cost = there.prices(SCREEN, found, strict=True)
    return np.asarray(found[cost < GLARE])


def _watching(names: Sequence[str], there: Array) -> Array:
    """Sofas, or beds where there is none, (m, 7)."""
    some = (there[[kinds.basic(o) in seats for o in names]] for seats in (kinds.SOFAS, kinds.BEDS) if names)
    return next((found for found in some if len(found)), there[:0])
