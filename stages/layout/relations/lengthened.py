"""Wardrobes and small basins of a finished room grow along their wall into floor that nothing else took, runs that are
complete by base units where they lack worktop: what is drawn before all else stands cannot know how much is left."""

from collections.abc import Callable, Collection, Container

import numpy as np

from apartgen.stages.layout.relations import exchange, order, runs, turned
from apartgen.stages.layout.relations.exchange import BASE, filled
from apartgen.stages.layout.relations.places import resized
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.relations.tokens import Array, Shell
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

WIDTHS, SIDES = (2.0, 1.8, 1.6, 1.4), (0.0, 1.0, -1.0)
"""What is tried, m: one metre for each of two is usual; to both sides, or to one."""
BASIN, BASINS = "vanity", ((0.46, 0.6), (0.42, 0.6), (0.36, 0.6), (0.36, 0.55))
"""What one washes at, and depths and widths that are tried where it is narrower, m."""
LITTLE = 0.05
"""What is no gain, m."""
MORE, BASES = 2, (0.9, 0.6, 0.45, 0.3)
"""So many base units come to a run that lacks worktop, at most, as wide as they are sold, m."""
WIDEST = 3
"""So many places, for the widest, are looked at with others changing theirs."""


def grown(there: Furniture, names: Collection[str], fixed: int, empty: Callable[[], Furniture]) -> Furniture:
    """The furniture with wardrobes of these names as wide as breaks nothing, up to 2 m together, and basins of .6 m if
    so; the first `fixed` are given and stay."""
    for k in range(fixed, len(there.names)):
        if there.names[k] in names and kinds.basic(there.names[k]) in kinds.WARDROBES:
            there = _as_large(there, k, _wider(there, k), empty)
        elif there.names[k] in names and there.names[k] == BASIN:
            there = _as_large(there, k, _basins(there.boxes[k]), empty)
    return there


def _wider(there: Furniture, k: int) -> Array:
    """A wardrobe in all widths that are more, to both sides and to either, (n, 7)."""
    name, box = there.names[k], there.boxes[k]
    have = sum(float(b[4]) for o, b in zip(there.names, there.boxes, strict=True) if kinds.basic(o) in kinds.WARDROBES)
    most = min(float(TABLE[name].max[1]), WIDTHS[0] - have + float(box[4]))
    return np.array([resized(box, box[3], wide, side) for wide in WIDTHS if box[4] + LITTLE < wide <= most + LITTLE
                     for side in SIDES], np.float32).reshape(-1, 7)


def _basins(box: Array) -> Array:
    """A basin in all sizes in which it is wider and no less deep, (n, 7)."""
    return np.array([resized(box, max(deep, float(box[3])), wide, side) for deep, wide in BASINS
                     if box[4] + LITTLE / 2 < wide for side in SIDES], np.float32).reshape(-1, 7)


def _as_large(there: Furniture, k: int, tries: Array, empty: Callable[[], Furniture]) -> Furniture:
    """The furniture with something as the first of the tries (n, 7) that breaks nothing."""
    if not len(tries):
        return there
    name, others = there.names[k], np.arange(len(there.names)) != k
    rest = filled(empty(), [there.names[i] for i in np.flatnonzero(others)], there.boxes[others])
    good = rest.prices(name, tries, strict=True) < BROKEN
    found = next((new for new in tries[good] if rest.shuts(name, new) < CUT), None)
    if found is None:
        return there
    boxes = there.boxes.copy()
    boxes[k] = found
    return filled(empty(), there.names, boxes)


def run_on(there: Furniture, shell: Shell, fixed: int, empty: Callable[[], Furniture],
           asked: Container[str] = ()) -> Furniture:
    """The furniture with base units more in its run while it lacks worktop beside sink and hob, where they break
    nothing, or round a corner, of which nothing was `asked`; then the units are put in order anew, the first `fixed`
    as they are."""
    there = _longer(there, shell, fixed, empty)
    if turned.CORNER in asked or not exchange.lacks_worktop(there.names, there.boxes):
        return there
    round_ = turned.round_corner(there, shell, fixed, empty)
    return there if round_ is there else exchange.settled(_longer(round_, shell, fixed, empty), fixed, empty)


def _longer(there: Furniture, shell: Shell, fixed: int, empty: Callable[[], Furniture]) -> Furniture:
    longer = there
    for _ in range(MORE):
        found = _another(longer, shell, fixed)
        if found is None:
            break
        longer = longer.fork()
        longer.add(BASE, found)
    if longer is there:
        return there
    longer = exchange.settled(longer, fixed, empty)
    before, after = (exchange.cost(one.names, one.boxes, one.space) for one in (there, longer))
    return longer if after < before - exchange.LEAST else there


def _another(there: Furniture, shell: Shell, fixed: int) -> Array | None:
    """Where one more base unit does most for who cooks there, if need be once others have changed places; None where it
    does nothing."""
    now = exchange.cost(there.names, there.boxes, there.space)
    if now < exchange.LEAST or order.runs().isdisjoint(there.names):
        return None
    sizes = np.repeat(runs.usual(BASE)[None], len(BASES), 0)
    sizes[:, 4] = BASES
    places = runs.further(BASE, sizes, there.names, there.boxes, shell)
    good = places[there.prices(BASE, places, strict=True) < BROKEN]
    names = [*there.names, BASE]
    costs = np.array([exchange.cost(names, np.concatenate([there.boxes, box[None]]), there.space) for box in good])
    if not (costs < now - exchange.LEAST).any():
        good = np.unique(good, axis=0)
        good = good[np.argsort(-good[:, 4], kind="stable")][:WIDEST]
        costs = np.array([exchange.at_best(there.besides(BASE, box), fixed) for box in good])
    better = (good[k] for k in np.argsort(costs, kind="stable").tolist() if costs[k] < now - exchange.LEAST)
    return next((box for box in better if there.shuts(BASE, box) < CUT), None)
