"""Which of the ways to hold a thing are clear where it lies: for two fingers that come, and for it to leave."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.carrying import WALL
from apartgen.schemas.populate import Grasp, Thing
from apartgen.schemas.retrieve import Furnishing, Joint, Retrieve
from apartgen.stages.populate.touching import hits
from apartgen.stages.space import polygons
from apartgen.stages.things.asset import Asset, Collider
from apartgen.stages.things.grasps import BROAD, THICK, TIP, Hold, alike, holds, unlike
from apartgen.stages.things.receptacles import Receptacle
from apartgen.stages.things.solids import bounds

Array = NDArray[np.float64]
LoadAsset = Callable[[str, str], Asset]
Offered = dict[str, tuple[Receptacle, ...]]

MOST = 4
"""So many ways are told of a thing."""
BACK, LONG, LIFT = 0.12, 0.03, 0.10
"""From how far fingers come, how long they are behind what they hold, and how far a thing is taken away, m."""
RISE = 0.01
"""How far a thing is lifted that is drawn out from under a board, m."""
SLACK, RESTS = 0.0015, 0.003
"""So much closer to a thing may be what it is not to touch, beside it and below it, m."""
_WITHIN_REACH = 0.6
"""What is further off is out of reach, m."""
_WALL = 0.1


class _Shape(NamedTuple):
    """Upright solids (n, 9) of an asset in its frame, as `touching` has them, and the joint that moves each."""

    solids: Array
    joints: tuple[str, ...]


class _Ways(NamedTuple):
    """Ways to hold a thing, and the same as arrays (k, …), in its frame; which are nearly the same, (k, k)."""

    holds: list[Hold]
    at: Array
    approach: Array
    close: Array
    width: Array
    same: list[list[bool]]


class _Place(NamedTuple):
    """Where a thing is: the furniture it is in, the part that is opened first, and whether a board is above it."""

    owner: str = ""
    joint: Joint | None = None
    under: bool = False


class _Room(NamedTuple):
    """All solids of a room, and for each whose it is, by which joint it moves, and what it lies in."""

    solids: Array
    owner: NDArray[np.str_]
    joint: NDArray[np.str_]
    within: NDArray[np.str_]


def held(before: Retrieve, things: Sequence[Thing], offered: Offered, load: LoadAsset) -> list[Thing]:
    """The things, each that is free with how a gripper takes hold of it, ways that are clear where it lies first."""
    ways = {id: _ways(load("parametric", id)) for id in sorted({o.asset.id for o in things if o.on != WALL})}
    places = _places(before, things, offered)
    clear: dict[str, Sequence[bool]] = {}
    for room in before.rooms:
        own = [o for o in things if o.room == room.id and o.on != WALL]
        found = _clear(own, [ways[o.asset.id] for o in own], _room(before, room.id, things, places, load), places)
        clear |= zip([o.id for o in own], found)
    return [o if o.on == WALL else _told(o, ways[o.asset.id], clear[o.id]) for o in things]


def _ways(asset: Asset) -> _Ways:
    found = holds(asset.links[0])
    at, approach, close = (np.array([hold[k] for hold in found]).reshape(-1, 3) for k in range(3))
    width = np.array([hold.width for hold in found])
    return _Ways(found, at, approach, close, width, alike(at, approach, close).tolist())


def _told(o: Thing, ways: _Ways, clear: Sequence[bool]) -> Thing:
    first = unlike([k for k, free in enumerate(clear) if free], ways.same, MOST)
    rest = unlike([*first, *(k for k, free in enumerate(clear) if not free)], ways.same, MOST)
    return o.model_copy(update={"grasps": [_grasp(ways.holds[k], i < len(first)) for i, k in enumerate(rest)]})


def _grasp(hold: Hold, clear: bool) -> Grasp:
    at, approach, close = (tuple(round(v, 4) + 0.0 for v in vector.tolist()) for vector in hold[:3])
    return Grasp(at=at, approach=approach, close=close, width=round(hold.width, 4), clear=clear)


def _places(before: Retrieve, things: Sequence[Thing], offered: Offered) -> dict[str, _Place]:
    joints = {(o.id, joint.name): joint for o in before.objects for joint in o.joints}
    known = {(id, place.name): place for id, found in offered.items() for place in found}
    places = {}
    for o in things:
        place = known.get((o.in_.object, o.in_.receptacle)) if o.in_ else None
        joint = joints.get((o.in_.object, place.part)) if o.in_ and place else None
        under = place is not None and place.kind in ("inside", "shelf")
        places[o.id] = _Place(o.in_.object if o.in_ else "", joint, under)
    return places


def _room(
    before: Retrieve, room: str, things: Sequence[Thing], places: dict[str, _Place], load: LoadAsset
) -> _Room:
    here: list[Furnishing] = [o for o in (*before.objects, *things) if o.room == room]
    shapes = [_shape(load, o.asset.library, o.asset.id) for o in here]
    solids = [_put(shape.solids, o.center, o.yaw) for o, shape in zip(here, shapes)]
    drawers = [_drawer(places.get(o.id)) for o in here]
    walls = _walls(before, room)
    count = [len(shape.joints) for shape in shapes]
    return _Room(
        np.concatenate([*solids, walls]),
        np.array([*np.repeat([o.id for o in here], count), *[""] * len(walls)], str),
        np.array([*(name for shape in shapes for name in shape.joints), *[""] * len(walls)], str),
        np.array([*np.repeat(drawers, count), *[""] * len(walls)], str))


def _drawer(place: _Place | None) -> str:
    slides = place is not None and place.joint is not None and place.joint.type == "slide"
    return f"{place.owner} {place.joint.name}" if slides and place and place.joint else ""


@lru_cache(maxsize=4096)
def _shape(load: LoadAsset, library: str, id: str) -> _Shape:
    asset = load(library, id)
    pieces = [(piece, link.joint.name if link.joint else "") for link in asset.links for piece in link.colliders]
    return _Shape(_solids([piece for piece, _ in pieces]), tuple(name for _, name in pieces))


def _solids(pieces: Sequence[Collider]) -> Array:
    """Middle, half of the sides, cos, sin, and whether it is round, (n, 9)."""
    lo, hi = bounds(pieces).transpose(1, 0, 2)
    round_ = [piece.kind == "cylinder" and abs(piece.rotation[2, 2]) > 0.999 for piece in pieces]
    return np.column_stack([(lo + hi) / 2, (hi - lo) / 2, np.ones(len(lo)), np.zeros(len(lo)), round_])


def _put(solids: Array, center: Sequence[float], yaw: float) -> Array:
    """Solids of a thing that stands there and is turned so."""
    c, s = np.cos(yaw), np.sin(yaw)
    found = solids.copy()
    found[:, :2] = solids[:, :2] @ np.array([[c, s], [-s, c]])
    found[:, :3] += center
    found[:, 6:8] = c, s
    return found


def _walls(before: Retrieve, room: str) -> Array:
    """Walls of a room and its floor."""
    ring = np.array(polygons.floor(next(r for r in before.rooms if r.id == room)).exterior.coords)
    a, b = ring[:-1], ring[1:]
    run = b - a
    length = np.hypot(*run.T)
    c, s = (run / length[:, None]).T
    side = 1.0 if polygons.floor(next(r for r in before.rooms if r.id == room)).exterior.is_ccw else -1.0
    middle = (a + b) / 2 + side * _WALL / 2 * np.column_stack([s, -c])
    high = np.full(len(a), before.height / 2)
    walls = np.column_stack([middle, high, length / 2, np.full(len(a), _WALL / 2), high, c, s, 0 * high])
    ground = np.array([*ring.mean(0), -_WALL / 2, 50.0, 50.0, _WALL / 2, 1.0, 0.0, 0.0])
    return np.concatenate([walls, ground[None]])


def _clear(things: Sequence[Thing], ways: Sequence[_Ways], room: _Room, places: dict[str, _Place]) -> list[list[bool]]:
    """Which ways to hold each thing of a room there is room for."""
    if not things:
        return []
    count = [len(own.holds) for own in ways]
    at, approach, close, width = (np.concatenate([own[k] for own in ways]) for k in range(1, 5))
    center, yaw = np.array([o.center for o in things]), np.array([o.yaw for o in things])
    turned = _Turned(*(np.repeat(rows, count, 0) for rows in (center, np.cos(yaw), np.sin(yaw))))
    fingers = _fingers(turned.put(at), turned.of(approach), turned.of(close), width)
    half = np.repeat(np.array([o.size for o in things]) / 2, count, 0)
    under = np.repeat([places[o.id].under for o in things], count)
    leaves = _leaving(half, approach, under, turned)
    seen: dict[tuple[str, str], _Seen] = {}
    found, starts = [], np.cumsum([0, *count])
    for o, first, last in zip(things, starts, starts[1:]):
        place = places[o.id]
        key = (place.owner, place.joint.name) if place.joint else ("", "")
        if key not in seen:
            seen[key] = _seen(room, place)
        every, others = seen[key].around(o)
        met = hits(fingers[:, first:last].reshape(-1, 15), every).reshape(2, -1)
        found.append((~(met[0] | met[1] | hits(leaves[first:last], others))).tolist())
    return found


class _Turned(NamedTuple):
    """Where things are and how they are turned, row by row: middles (k, 3), cos and sin (k,)."""

    center: Array
    c: Array
    s: Array

    def of(self, vectors: Array) -> Array:
        """Directions (k, 3) of the things in the world."""
        x, y, z = vectors.T
        return np.column_stack([self.c * x - self.s * y, self.s * x + self.c * y, z])

    def put(self, points: Array) -> Array:
        """Points (k, 3) of the things in the world."""
        return self.of(points) + self.center


class _Seen(NamedTuple):
    """Solids of a room (n, 9) as they stand with a part open, whose each is, and how far each reaches, m."""

    solids: Array
    owner: NDArray[np.str_]
    far: Array

    def around(self, o: Thing) -> tuple[Array, Array]:
        """What stands near a thing, and what of that is not itself."""
        x, y, _ = o.center
        near = np.flatnonzero(np.hypot(self.solids[:, 0] - x, self.solids[:, 1] - y) < self.far + _WITHIN_REACH)
        every = self.solids[near]
        return every, every[self.owner[near] != o.id]


def _seen(room: _Room, place: _Place) -> _Seen:
    """What there is of a room when the part before a place is open."""
    solids, keep = room.solids, slice(None)
    if place.joint is not None:
        own = (room.owner == place.owner) & (room.joint == place.joint.name)
        if place.joint.type == "slide":
            wide = max(place.joint.range, key=abs)
            axis = np.asarray(place.joint.axis, float) * wide
            solids = solids.copy()
            solids[~own & (room.within != _drawer(place)), :3] -= _turned(axis, room, place)
        else:
            keep = ~own
    return _Seen(solids[keep], room.owner[keep], np.hypot(solids[keep, 3], solids[keep, 4]))


def _turned(axis: Array, room: _Room, place: _Place) -> Array:
    """A direction of a piece of furniture in the world."""
    c, s = room.solids[np.flatnonzero(room.owner == place.owner)[0], 6:8]
    return np.array([c * axis[0] - s * axis[1], s * axis[0] + c * axis[1], axis[2]])


def _fingers(at: Array, approach: Array, close: Array, width: Array) -> Array:
    """All that the two fingers pass through, (2, k, 15)."""
    middle = at + approach * (TIP - BACK - LONG) / 2
    aside = close * (width / 2 + THICK / 2)[:, None]
    half = np.tile([THICK / 2, BROAD / 2, (TIP + BACK + LONG) / 2], (len(at), 1))
    turned = np.concatenate([close, np.cross(approach, close), approach, half], 1)
    return np.stack([np.concatenate([middle + side * aside, turned], 1) for side in (-1, 1)])


def _leaving(half: Array, approach: Array, under: NDArray[np.bool_], turned: _Turned) -> Array:
    """All that things of these half sides pass through when they are taken away, (k, 15)."""
    above = approach[:, 2:] < -0.9
    back = -LIFT * approach + np.array([0.0, 0.0, RISE])
    away = np.where(above | ~under[:, None], [0.0, 0.0, LIFT], back)
    lo = np.minimum(away, 0) - half + [SLACK, SLACK, RESTS]
    hi = np.maximum(away, 0) + half - SLACK
    c, s, zero = turned.c, turned.s, np.zeros(len(half))
    axes = np.column_stack([c, s, zero, -s, c, zero, zero, zero, zero + 1.0])
    return np.concatenate([turned.put((lo + hi) / 2), axes, np.maximum(hi - lo, 1e-4) / 2], 1)
