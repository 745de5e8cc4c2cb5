"""Boards: the receptacles of a home's furniture where they stand, and what of each is taken."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry, Polygon
from shapely.ops import unary_union

from apartgen.schemas.plan import Plan
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.stages.populate import rules
from apartgen.stages.space import polygons, sweeps
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.receptacles import OPEN, Receptacle, receptacles
from apartgen.stages.things.solids import bounds

Array = NDArray[np.float64]
LoadAsset = Callable[[str, str], Asset]

HEADROOM = 0.012
"""What stays free above a thing under a board, m."""
BESIDE = (0.30, 0.26)
"""Depth and width of the floor beside a piece of furniture that things stand on, m."""
_CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], bool)
_GRID = (9, 15)
"""Places that are looked at along x and y."""
_CROWDED = 80
"""What has more collision pieces stands in the way as its box."""
_CLOTH = categories.those(lambda kind: kind.soft and kind.place == "wall")
"""What hangs in folds, which are no collision pieces; nothing is put into them."""


class Spot(NamedTuple):
    """Where a thing is on a board, in the frame of the board's owner: its middle, what it stands on, and its turn."""

    x: float
    y: float
    z: float
    yaw: float


class Board:
    """A receptacle of a placed piece of furniture. `blocks` (n, 5) are x0, y0, x1, y1 and how high each begins."""

    def __init__(self, owner: Furnishing, place: Receptacle, blocks: Array) -> None:
        self.owner, self.place, self.blocks = owner, place, blocks
        turn = np.array([[np.cos(owner.yaw), -np.sin(owner.yaw)], [np.sin(owner.yaw), np.cos(owner.yaw)]])
        self.turn = turn

    def claim(self, dx: float, dy: float, h: float, where: str, rng: np.random.Generator) -> tuple[float, float] | None:
        """The middle of a free rectangle for something that high, which is taken from now on; None where none is."""
        (x0, y0), (x1, y1) = self.place.lo, self.place.hi
        if h + HEADROOM > self.place.room or dx > x1 - x0 or dy > y1 - y0:
            return None
        spots = np.stack(np.meshgrid(np.linspace(x0 + dx / 2, x1 - dx / 2, _GRID[0]),
                                     np.linspace(y0 + dy / 2, y1 - dy / 2, _GRID[1]), indexing="ij"), -1).reshape(-1, 2)
        free = self._free(spots, np.array([dx, dy]) / 2, h)
        if not free.any():
            return None
        cost = self._cost(spots, where) + rng.uniform(0, 0.3 if where != "any" else 1.0, len(spots))
        x, y = spots[int(np.where(free, cost, np.inf).argmin())]
        self.take(x - dx / 2, y - dy / 2, x + dx / 2, y + dy / 2)
        return float(x), float(y)

    def take(self, x0: float, y0: float, x1: float, y1: float) -> None:
        """From now on this rectangle is not free."""
        self.blocks = np.concatenate([self.blocks, [[x0, y0, x1, y1, 0.0]]])

    def _free(self, spots: Array, half: Array, h: float) -> NDArray[np.bool_]:
        low = self.blocks[self.blocks[:, 4] < h + HEADROOM]
        apart = (spots[:, None] + half <= low[None, :, :2] + 1e-9) | (spots[:, None] - half >= low[None, :, 2:4] - 1e-9)
        return np.asarray(np.all(np.any(apart, axis=2), axis=1))

    def _cost(self, spots: Array, where: str) -> Array:
        lo, hi = np.asarray(self.place.lo), np.asarray(self.place.hi)
        share = (spots - lo) / np.maximum(hi - lo, 1e-9)
        along = np.abs(share - 0.5).sum(1)
        return np.asarray({"back": share[:, 0], "front": 1 - share[:, 0], "middle": 2 * along}.get(where, 0 * along))

    def world(self, spot: Spot, height: float) -> tuple[tuple[float, float, float], float]:
        """Centre and yaw in the world of a thing that high."""
        x, y = self.turn @ [spot.x, spot.y] + self.owner.center[:2]
        yaw = (self.owner.yaw + spot.yaw + np.pi) % (2 * np.pi) - np.pi
        return (float(x), float(y), self.owner.center[2] + spot.z + height / 2), float(yaw)


class _Pieces(NamedTuple):
    """Bounds of what an asset is solid with, of all that its parts pass through, and of what those pass through that
    slide sideways before what is inside (n, 2, 3), its frame. Cloth is solid here.
    """

    solid: Array
    swept: Array
    sideways: Array


@lru_cache(maxsize=2048)
def _offers(load: LoadAsset, library: str, id: str) -> tuple[Receptacle, ...]:
    return tuple(receptacles(load(library, id)))


@lru_cache(maxsize=2048)
def _pieces(load: LoadAsset, library: str, id: str) -> _Pieces:
    asset = load(library, id)
    half = np.asarray(asset.size) / 2
    felt = [c for link in asset.links for c in link.colliders]
    solid = bounds(felt) if 0 < len(felt) <= _CROWDED else np.array([[-half, half]])
    if asset.category in _CLOTH:
        seen = [mesh.vertices for link in asset.links for mesh in link.visuals]
        solid = np.array([[p.min(0), p.max(0)] for p in seen])
    parts = np.array([sweeps.swept(joint) for joint in asset.joints]).reshape(-1, 2, 3)
    slide = np.array([joint.type == "slide" and abs(joint.axis[0]) < 0.5 for joint in asset.joints], bool)
    return _Pieces(solid, parts, parts[slide])


def offers(home: Retrieve, load: LoadAsset) -> dict[str, tuple[Receptacle, ...]]:
    """The receptacles of every piece of furniture that things are put on or in, by its id."""
    return {o.id: _offers(load, o.asset.library, o.asset.id) for o in home.objects if o.category in rules.bearers()}


def boards(
    home: Retrieve, room: str, offered: dict[str, tuple[Receptacle, ...]], hung: Sequence[Furnishing], load: LoadAsset
) -> list[Board]:
    """All boards of a room on whose walls this hangs, those of the floor beside furniture at the end."""
    here = _here([*(o for o in home.objects if o.room == room), *hung], load)
    found = []
    for k, o in enumerate(here.objects):
        places = offered.get(o.id, ())
        others = _seen_from(k, here) if any(place.open for place in places) else None
        found += [Board(o, place, _blocks(here.pieces[k], place, others)) for place in places]
    return [*found, *_floor_boards(home, room, here)]


class _Here(NamedTuple):
    """What stands in a room and hangs on its walls: bounds (n, 2, 3) of all pieces, each in the frame of its owner,
    whose place in `objects` is told; where the middle of each object is, and how far it reaches, m.
    """

    objects: Sequence[Furnishing]
    pieces: Sequence[_Pieces]
    bounds: Array
    owner: NDArray[np.int64]
    center: Array
    reach: Array


def _here(objects: Sequence[Furnishing], load: LoadAsset) -> _Here:
    pieces = [_pieces(load, o.asset.library, o.asset.id) for o in objects]
    own = [np.concatenate([piece.solid, piece.swept]) for piece in pieces]
    return _Here(objects, pieces, np.concatenate([*own, np.zeros((0, 2, 3))]),
                 np.repeat(np.arange(len(own)), [len(rows) for rows in own]),
                 np.array([o.center for o in objects]).reshape(-1, 3),
                 np.array([np.hypot(*o.size[:2]) for o in objects]))


def _blocks(pieces: _Pieces, place: Receptacle, others: Array | None) -> Array:
    """What stands over a place: what the parts of its own furniture pass through and, where it is open, `others`."""
    every = pieces.sideways if others is None or not place.open else np.concatenate([pieces.swept, others])
    lo, hi = every[:, 0], every[:, 1]
    over = (hi[:, 2] > place.z + 1e-3) & (lo[:, :2] < place.hi).all(1) & (hi[:, :2] > place.lo).all(1)
    low = np.maximum(lo[over, 2] - place.z, 0.0)
    return np.column_stack([lo[over, :2], hi[over, :2], low]).reshape(-1, 5)


def _seen_from(k: int, here: _Here) -> Array:
    """Bounds of other objects' pieces in the frame of this one, (n, 2, 3), but for what is far off."""
    o = here.objects[k]
    near = np.hypot(*(here.center - here.center[k])[:, :2].T) < (here.reach[k] + here.reach) / 2 + 1.0
    near[k] = False
    rows = near[here.owner]
    owner, turns = here.owner[rows], np.array([other.yaw - o.yaw for other in here.objects])
    c, s = (part[owner, None] for part in (np.cos(turns), np.sin(turns)))
    points = np.where(_CUBE[None], here.bounds[rows, 1, None], here.bounds[rows, 0, None])
    x, y = c * points[..., 0] - s * points[..., 1], s * points[..., 0] + c * points[..., 1]
    seen = np.stack([x, y, points[..., 2]], -1) + _local(o, here.center)[owner, None]
    return np.stack([seen.min(1), seen.max(1)], 1)


def _local(o: Furnishing, points: Array) -> Array:
    x, y, z = (points - o.center).T
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    return np.column_stack([c * x + s * y, c * y - s * x, z])


def _floor_boards(home: Retrieve, room: str, here: _Here) -> list[Board]:
    wanted = {name for rule in rules.table().get(_type(home, room), ()) for at in rule.at if at.endswith(" floor")
              for name in rules.spots(at).categories}
    beside = [k for k, o in enumerate(here.objects) if o.category in wanted]
    if not beside:
        return []
    area = polygons.floor(next(r for r in home.rooms if r.id == room)).buffer(-0.01)
    ways = unary_union([polygons.clearance(o, home, 0.9) for o in home.openings if room in o.rooms])
    return [board for k in beside for side in (-1, 1) if (board := _beside(k, side, area, ways, here))]


def _beside(k: int, side: int, area: Geometry, ways: Geometry, here: _Here) -> Board | None:
    """The floor on one side of a piece of furniture, along its back; None where people pass, or outside."""
    o = here.objects[k]
    d, w, h = o.size
    near, far = w / 2 + 0.03, w / 2 + 0.03 + BESIDE[1]
    lo, hi = (-d / 2 + 0.01, near if side > 0 else -far), (-d / 2 + 0.01 + BESIDE[0], far if side > 0 else -near)
    place = Receptacle(f"floor_{'left' if side > 0 else 'right'}", "top", lo, hi, -h / 2, OPEN)
    board = Board(o, place, np.zeros((0, 5)))
    outline = Polygon([board.turn @ corner + o.center[:2] for corner in place.polygon()])
    if not area.contains(outline) or ways.intersects(outline):
        return None
    board.blocks = _blocks(here.pieces[k], place, _seen_from(k, here))
    return board


def _type(home: Plan, room: str) -> str:
    return str(next(r for r in home.rooms if r.id == room).base)
