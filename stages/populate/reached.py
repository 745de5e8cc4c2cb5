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
from apartgen.stages.things.grasps import BROAD, THICK, TIP, Hold, holds, unlike
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
_NEAR = 0.6
"""What is further off is out of reach, m."""
_WALL = 0.1


class _Shape(NamedTuple):
    """Upright solids (n, 9) of an asset in its frame, as `touching` has them, and the joint that moves each."""

    solids: Array
    joints: tuple[str, ...]


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
    ways = {id: holds(load("parametric", id).links[0]) for id in sorted({o.asset.id for o in things if o.on != WALL})}
    places = _places(before, things, offered)
    rooms = {room.id: _room(before, room.id, things, places, load) for room in before.rooms}
    return [o if o.on == WALL else _told(o, ways[o.asset.id], rooms[o.room], places[o.id]) for o in things]


def _told(o: Thing, ways: list[Hold], room: _Room, place: _Place) -> Thing:
    clear = _clear(o, ways, room, place)
    first = unlike([hold for hold, free in zip(ways, clear) if free], MOST)
    rest = unlike([*first, *(hold for hold, free in zip(ways, clear) if not free)], MOST)
    return o.model_copy(update={"grasps": [_grasp(hold, k < len(first)) for k, hold in enumerate(rest)]})


def _grasp(hold: Hold, clear: bool) -> Grasp:
    at, approach, close = (tuple(round(float(v), 4) + 0.0 for v in vector) for vector in hold[:3])
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


def _clear(o: Thing, ways: list[Hold], room: _Room, place: _Place) -> NDArray[np.bool_]:
    """Which ways there is room for, (k,)."""
    if not ways:
        return np.zeros(0, bool)
    solids = _around(o, room, place)
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    at, approach, close = (np.array([hold[k] for hold in ways]) for k in range(3))
    width = np.array([hold.width for hold in ways])
    fingers = hits(_fingers(at @ turn.T + o.center, approach @ turn.T, close @ turn.T, width), solids.every)
    leaves = hits(_leaving(o, approach, turn, place), solids.others)
    return np.asarray(~(fingers[: len(ways)] | fingers[len(ways):] | leaves))


class _Around(NamedTuple):
    """Solids near a thing (n, 9), with its own and without."""

    every: Array
    others: Array


def _around(o: Thing, room: _Room, place: _Place) -> _Around:
    """What stands near a thing, the part before it open, and what of that is not itself."""
    solids, keep = room.solids, np.ones(len(room.solids), bool)
    if place.joint is not None:
        own = (room.owner == place.owner) & (room.joint == place.joint.name)
        if place.joint.type == "slide":
            wide = max(place.joint.range, key=abs)
            axis = np.asarray(place.joint.axis, float) * wide
            solids = solids.copy()
            solids[~own & (room.within != _drawer(place)), :3] -= _turned(axis, room, place)
        else:
            keep = ~own
    far = np.hypot(solids[:, 3], solids[:, 4])
    keep &= np.hypot(solids[:, 0] - o.center[0], solids[:, 1] - o.center[1]) < far + _NEAR
    return _Around(solids[keep], solids[keep & (room.owner != o.id)])


def _turned(axis: Array, room: _Room, place: _Place) -> Array:
    """A direction of a piece of furniture in the world."""
    c, s = room.solids[np.flatnonzero(room.owner == place.owner)[0], 6:8]
    return np.array([c * axis[0] - s * axis[1], s * axis[0] + c * axis[1], axis[2]])


def _fingers(at: Array, approach: Array, close: Array, width: Array) -> Array:
    """All that the fingers pass through, (2k, 15)."""
    middle = at + approach * (TIP - BACK - LONG) / 2
    aside = close * (width / 2 + THICK / 2)[:, None]
    half = np.tile([THICK / 2, BROAD / 2, (TIP + BACK + LONG) / 2], (len(at), 1))
    turned = np.concatenate([close, np.cross(approach, close), approach, half], 1)
    return np.concatenate([np.concatenate([middle + side * aside, turned], 1) for side in (-1, 1)])


def _leaving(o: Thing, approach: Array, turn: Array, place: _Place) -> Array:
    """All that the thing passes through when it is taken away, (k, 15)."""
    above = approach[:, 2:] < -0.9
    back = -LIFT * approach + np.array([0.0, 0.0, RISE])
    away = np.where(above | (not place.under), [0.0, 0.0, LIFT], back)
    half = np.asarray(o.size) / 2
    lo = np.minimum(away, 0) - half + [SLACK, SLACK, RESTS]
    hi = np.maximum(away, 0) + half - SLACK
    axes = np.tile(turn.T.reshape(1, 9), (len(approach), 1))
    return np.concatenate([(lo + hi) / 2 @ turn.T + o.center, axes, np.maximum(hi - lo, 1e-4) / 2], 1)
