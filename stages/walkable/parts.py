"""Which moving parts meet something on their way: those of furniture, and the leaves of room doors.

Boxes tell what can meet; only then are colliders looked at, which costs more.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import shapely

from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.robot.wedged import DEPTH, overlap
from apartgen.stages.space import boxes, convex, footprints, sweeps
from apartgen.stages.things import categories
from apartgen.stages.walkable.leaves import LEVERS, Building
from apartgen.stages.walkable.solids import Solids

CLEAR = 0.001
"""Least distance of a part from all that is not its own object, m."""
IN_THE_WAY = 1e-4
"""Floor of a doorway that may be taken, m²."""
WALL, CEILING, WAY, LEAF, PLACE = "wall", "ceiling", "way", "leaf", "place"


class Fault(NamedTuple):
    """A part of an object or room door that does not move freely, and the object, door or wall that it meets.

    The part is `place` where a seat stands in what it is drawn up to, so that nobody could draw it back.
    """

    owner: str
    part: str
    by: str


@dataclass(frozen=True)
class Check:
    """Tells what is blocked among some objects in a building."""

    building: Building
    solids: Solids

    def blocked(self, scene: Sequence[Furnishing], changed: Collection[str] | None = None) -> set[Fault]:
        """Everything that does not open freely; with `changed`, only what has to do with those objects."""
        things = [o for o in scene if not _flat(o)]
        asked = np.array([changed is None or o.id in changed for o in things], bool)
        some = [o for o, own in zip(things, asked) if own]
        found = _among(self.solids, things, asked)
        found |= _of_doors(self.building, self.solids, some)
        found |= at_building(self.building, self.solids, some)
        found |= _in_place(self.solids, things, asked)
        return found

    def still(self, faults: Collection[Fault], some: Sequence[Furnishing]) -> bool:
        """Whether any of these faults is there among some objects, as far as these have to do with it."""
        known = {o.id: o for o in some}
        for fault in sorted(faults):
            o, other = known.get(fault.owner), known.get(fault.by)
            if fault.part == PLACE:
                hit = o is not None and other is not None and _stands_in(self.solids, o, other)
            elif o is not None and other is not None:
                hit = _meets(self.solids, o, fault.part, other)
            elif o is not None:
                hit = fault in at_building(self.building, self.solids, [o])
            else:
                hit = other is not None and fault in _of_doors(self.building, self.solids, [other])
            if hit:
                return True
        return False


def _flat(o: Furnishing) -> bool:
    return o.category in categories.TABLE and categories.TABLE[o.category].place == "flat"


def _moving(objects: Sequence[Furnishing]) -> tuple[list[tuple[Furnishing, Joint]], boxes.Boxes, list[int]]:
    """Every part with an extent, the box that it sweeps (k), and the index of its object."""
    rows = [(i, o, joint) for i, o in enumerate(objects) for joint in o.joints if joint.extent is not None]
    bounds = [sweeps.swept(joint) for _, _, joint in rows]
    lo, hi = (np.array([b[k] for b in bounds], float).reshape(-1, 3) for k in (0, 1))
    owner = [i for i, _, _ in rows]
    base = boxes.of(objects).take(np.array(owner, int))
    return [(o, joint) for _, o, joint in rows], boxes.spread(base, lo, hi), owner


def _among(solids: Solids, things: list[Furnishing], asked: boxes.Mask) -> set[Fault]:
    """Parts that meet other objects."""
    parts, swept, owner = _moving(things)
    if not parts:
        return set()
    near = boxes.penetration(swept, boxes.of(things)) > -CLEAR
    own = np.array(owner, int)
    near[np.arange(len(own)), own] = False
    near &= asked[own][:, None] | asked[None]
    found = set()
    for i, j in np.argwhere(near).tolist():
        (o, joint), other = parts[i], things[j]
        if _meets(solids, o, joint.name, other):
            found.add(Fault(o.id, joint.name, other.id))
    return found


def _meets(solids: Solids, o: Furnishing, part: str, other: Furnishing) -> bool:
    sweep = solids.of(o).parts.get(part)
    return sweep is not None and convex.meet(sweep.placed(o.center, o.yaw), solids.rest(other), CLEAR)


def _in_place(solids: Solids, things: list[Furnishing], asked: boxes.Mask) -> set[Fault]:
    """Seats that stand in what they belong to."""
    seats = [i for i, o in enumerate(things) if o.category in categories.SEATS]
    if not seats:
        return set()
    where = boxes.of(things)
    near = boxes.penetration(where.take(np.array(seats)), where) > DEPTH
    near &= asked[seats][:, None] | asked[None]
    pairs = ((things[seats[i]], things[j]) for i, j in np.argwhere(near).tolist() if seats[i] != j)
    return {Fault(o.id, PLACE, other.id) for o, other in pairs
            if categories.tucks(o.category, other.category) and _stands_in(solids, o, other)}


def _stands_in(solids: Solids, o: Furnishing, other: Furnishing) -> bool:
    return overlap(solids.prisms(o), solids.prisms(other))


def _of_doors(building: Building, solids: Solids, some: list[Furnishing]) -> set[Fault]:
    """Room doors that meet objects, and doorways that objects stand in."""
    if not some:
        return set()
    marks = boxes.footprints(boxes.of(some))
    low, high = (np.array([o.center[2] + side * o.size[2] / 2 for o in some]) for side in (-1, 1))
    walked = (high > footprints.FLAT) & (low < footprints.HEADROOM)
    found = set()
    for name, way in building.ways.items():
        for i in np.flatnonzero(walked & shapely.intersects(way, marks)).tolist():
            if way.intersection(marks[i]).area > IN_THE_WAY:
                found.add(Fault(name, WAY, some[i].id))
    at_levers = (low < LEVERS[1]) & (high > LEVERS[0])
    for name, leaf in building.leaves.items():
        near = (low < leaf.opening.head) & shapely.intersects(leaf.swing, marks)
        near |= at_levers & shapely.intersects(leaf.zone, marks)
        for i in np.flatnonzero(near).tolist():
            if convex.meet(leaf.sweep, solids.rest(some[i]), CLEAR):
                found.add(Fault(name, LEAF, some[i].id))
    return found


def at_building(building: Building, solids: Solids, some: list[Furnishing]) -> set[Fault]:
    """Parts that meet walls, ceilings, or doors that are shut or open."""
    parts, swept, _ = _moving(some)
    if not parts:
        return set()
    marks = boxes.footprints(swept)
    low, high = swept.center[:, 2] - swept.size[:, 2] / 2, swept.center[:, 2] + swept.size[:, 2] / 2
    near = {WALL: ~shapely.covers(building.free, marks), CEILING: high > building.height}
    near |= {name: shapely.intersects(leaf.ends, marks) & (low < leaf.opening.head)
             for name, leaf in building.leaves.items()}
    found = set()
    for by, hit in near.items():
        for i in np.flatnonzero(hit).tolist():
            o, joint = parts[i]
            sweep = solids.of(o).parts.get(joint.name)
            if sweep is not None and _at(building, sweep.placed(o.center, o.yaw), by):
                found.add(Fault(o.id, joint.name, by))
    return found


def _at(building: Building, sweep: convex.Hulls, by: str) -> bool:
    if by == WALL:
        return building.in_wall(sweep)
    if by == CEILING:
        return bool((sweep.points[..., 2] > building.height).any())
    return convex.meet(sweep, building.leaves[by].still, CLEAR)


def stuck_doors(building: Building) -> set[Fault]:
    """Room doors that meet walls or one another, which no furniture can help."""
    leaves = building.leaves
    found = {Fault(name, LEAF, WALL) for name, leaf in leaves.items()
             if leaf.zone.difference(leaf.about).difference(building.free).area > IN_THE_WAY
             and building.in_wall(leaf.sweep)}
    for name, leaf in leaves.items():
        near = (key for key, other in leaves.items() if key != name and leaf.zone.intersects(other.ends))
        found |= {Fault(name, LEAF, key) for key in near if convex.meet(leaf.sweep, leaves[key].still, CLEAR)}
    return found
