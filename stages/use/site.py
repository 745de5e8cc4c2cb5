"""A room before it is furnished: walls, openings on them, who lives there."""

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.plan import Plan, Room
from apartgen.stages.use.household import duties, eats_in, served_by, sleepers, washes_in

Array = NDArray[np.float64]
PASSAGES = ("door", "opening", "entrance")
FEW = 2
"""Of so many bedrooms each is likely for two."""


@dataclass(frozen=True)
class Hole:
    """An opening on the room's own boundary: from `a` to `b` with the room on the left, `into` where its leaf opens
    into this room, `pivot` being the end at which it hangs."""

    id: str
    kind: str
    a: tuple[float, float]
    b: tuple[float, float]
    sill: float
    head: float
    leaf: bool
    pivot: int

    @property
    def width(self) -> float:
        """Clear width, m."""
        return float(np.hypot(self.b[0] - self.a[0], self.b[1] - self.a[1]))

    @cached_property
    def middle(self) -> tuple[float, float]:
        """Its middle on the wall's face."""
        return (self.a[0] + self.b[0]) / 2, (self.a[1] + self.b[1]) / 2

    @cached_property
    def frame(self) -> Array:
        """(x, y, cos, sin): origin in the middle, the first axis into the room, the second back along the wall."""
        wide = max(self.width, 1e-9)
        along = (self.b[0] - self.a[0]) / wide, (self.b[1] - self.a[1]) / wide
        return np.array([*self.middle, -along[1], along[0]])


@dataclass(frozen=True)
class Site:
    """A room of a home where `sleepers` people live, None for a room by itself; in one room they have their `meals`,
    one is where clothes are washed (`laundry`), one is the largest of the bedrooms (`main`), or for want of
    any is slept in (`sleeps`); of three bedrooms and more the others are children's as likely as not (`shared`). Dishes
    come by the openings `served` to where meals are."""

    id: str
    kind: str
    corners: tuple[tuple[float, float], ...]
    holes: tuple[Hole, ...]
    sleepers: int | None
    meals: bool = False
    laundry: bool = False
    main: bool = False
    sleeps: bool = False
    shared: bool = False
    served: tuple[str, ...] = ()

    @cached_property
    def start(self) -> Array:
        """Where each wall starts, (w, 2), counter-clockwise."""
        corners = np.array(self.corners, float)
        x, y = corners.T
        return corners if x @ np.roll(y, -1) >= y @ np.roll(x, -1) else np.ascontiguousarray(corners[::-1])

    @cached_property
    def end(self) -> Array:
        """Where each wall ends, (w, 2)."""
        return np.ascontiguousarray(np.roll(self.start, -1, 0))

    @cached_property
    def length(self) -> Array:
        """Of each wall, (w,)."""
        return np.asarray(np.maximum(np.hypot(*(self.end - self.start).T), 1e-9))

    @cached_property
    def along(self) -> Array:
        """Unit vector along each wall, (w, 2)."""
        return np.asarray((self.end - self.start) / self.length[:, None])

    @cached_property
    def area(self) -> float:
        """Of the floor, m²."""
        x, y = self.start.T
        return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2

    @cached_property
    def passages(self) -> tuple[Hole, ...]:
        """What one walks through."""
        return tuple(hole for hole in self.holes if hole.kind in PASSAGES)

    @cached_property
    def entered(self) -> bool:
        """Whether the home is entered here, though it is no hall."""
        return self.kind != "hallway" and any(hole.kind == "entrance" for hole in self.holes)

    @cached_property
    def windows(self) -> tuple[Hole, ...]:
        """What lets light in."""
        return tuple(hole for hole in self.holes if hole.kind == "window")

    @cached_property
    def dark(self) -> bool:
        """Whether no daylight comes in, by a window of its own or from a room that it is open to."""
        return self.kind != "balcony" and not any(hole.kind in ("window", "opening") for hole in self.holes)


def site(plan: Plan, room_id: str) -> Site:
    """The room of that id; the same one for the same walls and openings."""
    room = next(room for room in plan.rooms if room.id == room_id)
    rows = tuple((o.id, o.kind, *o.segment, o.sill, o.head, o.into == room_id, o.hinge)
                 for o in plan.openings if room_id in o.rooms)
    of = duties(plan, room)
    return _site(room.id, room.base, tuple((x, y) for x, y in room.polygon), rows, sleepers(plan),
                 (meals := eats_in(plan) == room_id), washes_in(plan) == room_id and len(plan.rooms) > 1, of.main > 0,
                 of.sleeps > 0, of.main == 0 and sum(room.base == "bedroom" for room in plan.rooms) > FEW,
                 served_by(plan, room) if meals else ())


def alone(room: Room) -> Site:
    """A room of which nothing is known but its walls."""
    return _site(room.id, room.base, tuple((x, y) for x, y in room.polygon), (), None)


@lru_cache(maxsize=256)
def _site(id: str, kind: str, corners: tuple[tuple[float, float], ...], rows: tuple[tuple[object, ...], ...],
          people: int | None, meals: bool = False, laundry: bool = False, main: bool = False,
          sleeps: bool = False, shared: bool = False, served: tuple[str, ...] = ()) -> Site:
    bare = Site(id, kind, corners, (), people)
    holes = tuple(_hole(bare, *row) for row in rows)  # type: ignore[arg-type]
    return replace(bare, holes=holes, meals=meals, laundry=laundry, main=main, sleeps=sleeps, shared=shared,
                   served=served)


def _hole(bare: Site, id: str, kind: str, a: tuple[float, float], b: tuple[float, float], sill: float, head: float,
          leaf: bool, hinge: int) -> Hole:
    """An opening moved from the middle of its wall onto the face that this room sees, along the boundary."""
    middle = (np.array(a) + np.array(b)) / 2
    share = ((middle - bare.start) * bare.along).sum(1).clip(0, bare.length)
    wall = int(np.hypot(*(bare.start + share[:, None] * bare.along - middle).T).argmin())
    places = [float(np.clip((np.array(p) - bare.start[wall]) @ bare.along[wall], 0, bare.length[wall])) for p in (a, b)]
    turned = places[0] > places[1]
    first, last = (bare.start[wall] + place * bare.along[wall] for place in sorted(places))
    return Hole(id, kind, (float(first[0]), float(first[1])), (float(last[0]), float(last[1])), sill, head, leaf,
                1 - hinge if turned else hinge)
