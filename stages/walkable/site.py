"""What stays the same while furniture changes: floors, doors, raster, library; and what a change must respect."""

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray
from shapely import Geometry
from shapely.ops import unary_union

from apartgen.schemas import rooms as room_kinds
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan, Program
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, footprints, polygons, sweeps
from apartgen.stages.space.boxes import Array
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.carrying import holds
from apartgen.stages.walkable.config import WalkableConfig

SLACK = 0.004
"""Contact that a change may make, m: less than half of what counts as collision."""
COMPANY = 0.25
"""What belongs together and is closer than this stays so, m."""
BACK = 0.15
"""Depth of a seat's back, in shares of the seat's."""
DRAWN_BACK = 0.5
"""Seats may be this far from their tables, m."""
BEFORE_DOOR = 0.6
"""Floor kept free on both sides of a door, m."""
BEFORE_WINDOW = 0.3
"""What is higher than the sill keeps this far from a window, m."""

Scene = tuple[Furnishing, ...]
Changes = dict[str, Furnishing | None]
"""New states by id; None takes an object away."""


class Candidates(Protocol):
    """Where smaller assets come from (any asset library, or several)."""

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None, like: str = ""
    ) -> Asset | None:
        """The asset closest in size and shape latent, none of its sides above `limit`; None if none fits.

        It looks like the one of id `like`, where it can.
        """

    def alternatives(self, category: str, size: ArrayLike, latent: ArrayLike, like: str = "") -> Iterable[Asset]:
        """Other designs of that size, the one closest in latent first; they open to the side to which `like` does."""

    def load_asset(self, library: str, id: str) -> Asset:
        """The asset of that library and id; BadInput when there is none."""


class Need(NamedTuple):
    """A room keeps at least so many objects of some categories."""

    room: str
    of: frozenset[str]
    least: int


@dataclass(frozen=True)
class Site:
    """The empty plan and everything measured on it once."""

    program: Program
    needs: tuple[Need, ...]
    config: WalkableConfig
    library: Candidates
    floors: dict[str, Geometry]
    doors: Geometry
    windows: list[tuple[Geometry, float]]
    world: reach.Space
    free: dict[Hashable, float] = field(default_factory=dict)

    def target(self, rooms: Iterable[str] | None = None) -> float:
        """Share of these rooms' floors, of all by default, that is to stay free."""
        if self.config.target is not None:
            return self.config.target
        type_of, known = {room.id: room for room in self.world.plan.rooms}, room_kinds.kinds()
        share, area = 0.0, 0.0
        for id in self.floors if rooms is None else rooms:
            kind = known.get(type_of[id].type, known[type_of[id].base])
            share, area = share + kind.free * self.floors[id].area, area + self.floors[id].area
        return float(share / area)

    def least(self, o: Furnishing) -> Array:
        """Size (3,) below which an object is not made smaller: what people have as a rule, or what there is at all
        where nothing but Algorithm 2 is asked for.
        """
        kind = categories.TABLE.get(o.category)
        if kind is None:
            return np.zeros(3)
        return np.asarray(kind.min if kind.rule is None or self.config.gentle == 0 else kind.rule)

    @property
    def area(self) -> float:
        """All floors together, m²."""
        return float(sum(floor.area for floor in self.floors.values()))


def survey(plan: Plan, config: WalkableConfig, library: Candidates, needs: tuple[Need, ...] = ()) -> Site:
    """Everything about a plan that changes of furniture are checked against."""
    doors = [polygons.clearance(o, plan, BEFORE_DOOR) for o in plan.openings if o.kind in ("door", "entrance")]
    ways = [polygons.threshold(o, plan) for o in plan.openings if o.kind == "opening"]
    glass = [o for o in plan.openings if o.kind == "window"]
    windows = [(polygons.before(o, plan, o.rooms[0], BEFORE_WINDOW), float(o.sill)) for o in glass]
    floors = dict(polygons.floors(plan))
    for floor in floors.values():
        shapely.prepare(floor)
    world = reach.space(plan, config.robot_radius, config.resolution)
    return Site(plan.program, needs, config, library, floors, unary_union([*doors, *ways]), windows, world)


def in_room(scene: Iterable[Furnishing], room: str) -> list[Furnishing]:
    """The objects of one room."""
    return [o for o in scene if o.room == room]


def swapped(scene: Scene, changes: Changes) -> Scene:
    """The scene with some objects exchanged by id."""
    every = [changes.get(o.id, o) for o in scene]
    return tuple(o for o in every if o is not None)


def fits(site: Site, scene: Scene, changes: Changes) -> bool:
    """Whether a change breaks nothing that was whole: room, doors, windows, what carries things, collisions, sweeps of
    moving parts.
    """
    now = {o.id: o for o in scene}
    changed = [o for o in changes.values() if o is not None]
    if not all(_stands_well(site, now[o.id], o) for o in changed):
        return False
    after = swapped(scene, changes)
    there = {o.id: o for o in after}
    if not all(holds(there[o.on], o) for o in changed if o.on in there):
        return False
    rooms = sorted({o.room for o in changed})
    return all(_meets_nothing(in_room(scene, room), in_room(after, room), set(changes)) for room in rooms)


def _stands_well(site: Site, old: Box, new: Box) -> bool:
    before, after = boxes.footprints(boxes.of([old, new]))
    floor = site.floors[new.room]
    if shapely.difference(after, floor).area > shapely.difference(before, floor).area + SLACK**2:
        return False
    if not footprints.is_obstacle(new):
        return True
    zones = [site.doors, *(zone for zone, sill in site.windows if new.center[2] + new.size[2] / 2 > sill + 0.05)]
    return all(shapely.intersection(after, zone).area <= shapely.intersection(before, zone).area + SLACK**2
               for zone in zones)


def _meets_nothing(before: Sequence[Furnishing], after: Sequence[Furnishing], changed: set[str]) -> bool:
    """Whether no changed object of a room stands or opens deeper into another than it did, or leaves its company."""
    before = [o for o in before if not footprints.gives_way(o)]
    after = [o for o in after if not footprints.gives_way(o)]
    index = {o.id: i for i, o in enumerate(before)}
    rows = np.array([i for i, o in enumerate(after) if o.id in changed], int)
    if not len(rows):
        return True
    old = np.array([index[o.id] for o in after], int)
    new = [after[i] for i in rows.tolist()]
    apart = np.array([[not categories.tucks(a.category, b.category) for b in after] for a in new], bool)
    kin = np.array([[categories.belong_together(a.category, b.category) for b in after] for a in new], bool)
    kin[np.arange(len(rows)), rows] = False
    company = np.flatnonzero(kin.any(0))
    kin, close = kin[:, company], np.where(apart, COMPANY, DRAWN_BACK)[:, company]
    apart[np.arange(len(rows)), rows] = False
    if _backs_meet(before, after, old, set(rows.tolist())):
        return False
    for shapes in (boxes.of, sweeps.extended):
        ours, theirs = shapes(after), shapes(before)
        was = boxes.penetration(theirs.take(old[rows]), theirs)[:, old]
        now = boxes.penetration(ours.take(rows), ours)
        if ((now > np.maximum(was, SLACK) + 1e-6) & apart).any():
            return False
    if not len(company):
        return True
    left = (_gaps(after, rows, company) > close) & (_gaps(before, old[rows], old[company]) <= close)
    return not (left & kin).any()


def _backs_meet(before: Sequence[Furnishing], after: Sequence[Furnishing], old: NDArray[np.int64],
                changed: set[int]) -> bool:
    """Whether the back of a seat stands deeper in what the seat is drawn under than it did; seats alone go under it."""
    pairs = [(i, j) for i, a in enumerate(after) if a.category in categories.SEATS for j, b in enumerate(after)
             if i != j and (i in changed or j in changed) and a.size[2] > b.size[2]
             and categories.tucks(a.category, b.category)]
    if not pairs:
        return False
    seat, under = np.array(pairs).T
    was, now = (_depths(scene, some, others) for scene, some, others in
                ((before, old[seat], old[under]), (after, seat, under)))
    return bool((now > np.maximum(was, SLACK) + 1e-6).any())


def _depths(scene: Sequence[Furnishing], seat: NDArray[np.int64], under: NDArray[np.int64]) -> Array:
    """How deep the back of each seat is in what it is drawn under, m."""
    every = boxes.of(scene)
    own = every.take(seat)
    behind = -(1 - BACK) / 2 * own.size[:, :1] * boxes.axes(own)[:, 0]
    center = own.center + np.pad(behind, ((0, 0), (0, 1)))
    backs = boxes.Boxes(center, own.size * [BACK, 1.0, 1.0], own.yaw)
    deep: Array = np.diagonal(boxes.penetration(backs, every.take(under)))
    return deep


def _gaps(objects: Sequence[Furnishing], some: NDArray[np.int64], others: NDArray[np.int64]) -> boxes.Array:
    every = boxes.of(objects)
    return boxes.gap(every.take(some), every.take(others))
