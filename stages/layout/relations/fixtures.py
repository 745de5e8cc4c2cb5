"""Floor before the fixtures of a bathroom: φ of what would take it, and of fixtures that turn their backs to the room.

A requirement at first; where no place keeps it, a weight for fixtures, which stand all the same.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.relations.hung import MIRROR
from apartgen.stages.space.boxes import Boxes, gap, stand_in
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.kinds import FIXTURES

TAKEN, BROKEN = 9.5, 20.0
"""Prices of taken floor, just below what breaks a requirement, and of what does."""
OFF_WALL = 0.06
"""A fixture's back is no farther from its wall, m."""
ASIDE, BEYOND = 0.3, 0.1
"""Half the width of the floor before a fixture, and how much wider than the fixture it may be on each side, m."""
AXIS = 0.385
"""From the axis of a toilet or a basin to what stands beside it, m (NKBA bathroom guidelines 5, 6)."""
SQUEEZED = 4.0
"""Price of no elbow room at a basin, until nothing better was found."""
BASINS, RAIL, BIN, TUBS = frozenset({"vanity"}), "towel_rail", "bin", {"bath"}
OVER, HIGH = {"bath", "toilet", "bin"}, 4.0
"""Over these a mirror hangs wherever they are; what one reaches for, and not over these; what is not under that; more
than rooms are high, m."""
BEFORE = 0.4
"""How far before it no tub is and no door's leaf stands, m."""
THROWN = {"toilet": 0.4, "vanity": 0.4}
"""How far from these a bin stands at most, m, where there is one."""
FAR = HIDDEN = 4.0
"""Price of one that stands farther, and of a mirror behind a door, once nothing better was found."""
OFF, MORE, SLACK = 0.02, 0.01, 0.008
"""Where floor before a fixture begins, how much more than the least it is, and contact that is none, m."""
Floats = NDArray[np.float64]


def prices(name: str, found: Boxes, names: list[str], there: Boxes, space: Space,
           strict: bool, loose: bool = False) -> Floats:
    """Of candidates (n,) for an object, among those that stand there."""
    total = np.zeros(found.n)
    if name == RAIL:
        return _out_of_reach(found, names, there, space)
    if name == MIRROR:
        return np.where(_out_of_sight(found, names, there, space), BROKEN if strict else HIDDEN, 0.0)
    if TABLE[name].place != "floor":
        return total
    if name == BIN:
        total += np.where(_columns(there.take(np.array([k for k, o in enumerate(names) if o == RAIL], int)), found),
                          BROKEN, 0.0)
        total += np.where(within(THROWN, found, names, there), 0.0, BROKEN if strict else FAR)
    if name not in FIXTURES and FIXTURES.keys().isdisjoint(names):
        return total
    stands = np.array([TABLE[o].place == "floor" for o in names], bool)
    taken, tight = np.zeros(found.n, bool), np.zeros(found.n, bool)
    if name in FIXTURES:
        total += np.where(space.behind(found) > OFF_WALL, BROKEN, 0.0)
        others = there.take(np.flatnonzero(stands))
        for zone in kept(name, found):
            taken |= outside(zone, space) > SLACK
            taken |= stand_in(zone, others, SLACK)
        for zone in elbows(name, found):
            fast = others.take(np.array([not TABLE[o].loose for o, on in zip(names, stands, strict=True) if on], bool))
            tight |= (outside(zone, space) > SLACK) | stand_in(zone, fast, SLACK)
    for k in (k for k, o in enumerate(names) if o in FIXTURES):
        for zone in kept(names[k], there.take(np.array([k]))):
            taken |= stand_in(found, zone, SLACK)
        for zone in [] if TABLE[name].loose else elbows(names[k], there.take(np.array([k]))):
            tight |= stand_in(found, zone, SLACK)
    total += np.where(tight, BROKEN if strict else 0.0 if loose else SQUEEZED, 0.0)
    return total + np.where(taken, BROKEN if strict or name not in FIXTURES else TAKEN, 0.0)


def kept(name: str, some: Boxes) -> list[Boxes]:
    """Floor that each fixture wants: before it, and for a toilet at its sides."""
    far, half = FIXTURES[name] + MORE, np.minimum(ASIDE, some.size[:, 1] / 2 + BEYOND)
    front = _strip(some, some.size[:, 0] / 2 + OFF, some.size[:, 0] / 2 + far, half)
    if name != "toilet":
        return [front]
    return [front, _strip(some, OFF - some.size[:, 0] / 2, some.size[:, 0] / 2, np.full(some.n, AXIS))]


def _out_of_reach(found: Boxes, names: list[str], there: Boxes, space: Space) -> Floats:
    """Of what hangs, reached over a tub or a bin, in the way of who sits below, or behind a door that stands open."""
    below, before = (there.take(np.array([k for k, o in enumerate(names) if o in some], int)) for some in (OVER, TUBS))
    met = [_columns(below, found), _columns(before, _front(found)), _behind_leaf(found, space)]
    return np.where(np.any(met, axis=0), BROKEN, 0.0)


def _front(found: Boxes) -> Boxes:
    """What is right before each of what hangs."""
    return _strip(found, found.size[:, 0] / 2, found.size[:, 0] / 2 + BEFORE, found.size[:, 1] / 2)


def _behind_leaf(found: Boxes, space: Space) -> NDArray[np.bool_]:
    """Before which a door stands that is open."""
    return stand_in(_front(found), space.leaves, SLACK)


def _out_of_sight(found: Boxes, names: list[str], there: Boxes, space: Space) -> NDArray[np.bool_]:
    """Which mirrors are behind a door that stands open, but for those over a basin, where they belong anyway."""
    basins = there.take(np.array([k for k, o in enumerate(names) if o in BASINS], int))
    return np.asarray(_behind_leaf(found, space) & ~_columns(basins, found))


def within(far: Mapping[str, float], found: Boxes, names: Sequence[str], there: Boxes) -> NDArray[np.bool_]:
    """Which boxes (n,) are no farther than so from any of those that stand there; all where none of these does."""
    near = [k for k, o in enumerate(names) if o in far]
    if not near:
        return np.ones(found.n, bool)
    return np.asarray((gap(found, there.take(np.array(near))) <= [far[names[k]] for k in near]).any(1))


def _columns(some: Boxes, found: Boxes) -> NDArray[np.bool_]:
    """Which boxes (n,) are above or below any of some."""
    columns = Boxes(some.center.copy(), some.size.copy(), some.yaw)
    columns.center[:, 2], columns.size[:, 2] = HIGH / 2, HIGH
    return stand_in(found, columns, SLACK)


def elbows(name: str, some: Boxes) -> list[Boxes]:
    """Floor beside the front half of each basin."""
    return [_strip(some, np.zeros(some.n), some.size[:, 0] / 2, np.full(some.n, AXIS))] if name == "vanity" else []


def _strip(some: Boxes, near: Floats, far: Floats, half: Floats) -> Boxes:
    """Boxes from `near` to `far` ahead of the middle of each, `half` to both sides, as high."""
    center, size = some.center.copy(), some.size.copy()
    center[:, :2] += ((near + far) / 2)[:, None] * np.stack([np.cos(some.yaw), np.sin(some.yaw)], -1)
    size[:, 0], size[:, 1] = far - near, 2 * half
    return Boxes(center, size, some.yaw.copy())
