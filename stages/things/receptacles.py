"""Where things can be put on and in a piece of furniture: its tops, its shelf boards, its drawers.

Read off the collision pieces of an asset, so that it holds for made and for foreign furniture alike: every level face
with room above it is cut into rectangles, and what stands above a rectangle says how high things on it may be.
"""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from apartgen.stages.things import rectangles
from apartgen.stages.things.asset import UNTURNED, Array, Asset, Collider, Link
from apartgen.stages.things.solids import bounds, corners

Kind = Literal["top", "shelf", "inside", "drawer", "basin"]

LEAST_SIDE = 0.06
"""Narrower rectangles hold nothing, m."""
LEAST_ROOM = 0.05
"""What has less room above it is no place to put things, m."""
LEVEL = 0.0015
"""Faces that end no further below the highest are one level with it, m."""
OPEN = 3.0
"""Room above what has nothing over it, m."""
EDGE = 0.008
"""Things keep this far from the edge of a board, m."""
SEAM = 0.007
"""Half the gap between two boards that one thing may bridge, m."""
RIM, BESIDE = 0.04, 0.08
"""What rises so far above a face, so near to at least three of its sides, makes a basin of it, m."""
_THIN = 1e-3
"""Corners no further below the highest are of the top, m."""
_TICKS = 14
_MANY = 36
"""More lines than this along a side are thinned out."""
_MOST = 6
"""Rectangles that a level is cut into at most."""
_HIGHEST_TOP = 2.0
"""Higher tops are out of sight and reach, m."""


class Receptacle(NamedTuple):
    """A rectangle that things can stand on, in the asset's frame: x and y from `lo` to `hi`, at height `z`, with
    `room` above it, m.

    `part` is the joint of the drawer that it is in, or of the door before it; empty where it is open.
    """

    name: str
    kind: Kind
    lo: tuple[float, float]
    hi: tuple[float, float]
    z: float
    room: float
    part: str = ""

    @property
    def open(self) -> bool:
        """Whether it can be reached with everything shut."""
        return not self.part

    def polygon(self) -> list[tuple[float, float]]:
        """Its corners, counter-clockwise."""
        (x0, y0), (x1, y1) = self.lo, self.hi
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


class _Solids(NamedTuple):
    """Collision pieces of an asset: least and greatest corners (n, 3), and which link each belongs to (n,)."""

    lo: Array
    hi: Array
    link: NDArray[np.int64]
    pieces: list[Collider]


def receptacles(asset: Asset) -> list[Receptacle]:
    """All that the asset offers, drawers first, then from below to above."""
    solids = _solids(asset.links)
    if not len(solids.lo):
        return []
    found: list[Receptacle] = []
    for k, link in enumerate(asset.links):
        if link.joint is None or (link.joint.type == "slide" and link.joint.axis[0] > 0.9):
            found += _of_link(asset, k, solids)
    return [place._replace(name=f"{place.kind}_{i}") for i, place in enumerate(found)]


def _solids(links: Sequence[Link]) -> _Solids:
    pieces = [(piece, k) for k, link in enumerate(links) for piece in link.colliders]
    lo, hi = bounds([piece for piece, _ in pieces]).transpose(1, 0, 2)
    return _Solids(lo, hi, np.array([k for _, k in pieces], np.int64), [piece for piece, _ in pieces])


def _of_link(asset: Asset, k: int, solids: _Solids) -> list[Receptacle]:
    own = np.flatnonzero(solids.link == k)
    tops = solids.hi[own, 2]
    found = []
    for z in _levels(tops):
        at = own[(tops <= z) & (tops >= z - LEVEL)]
        if (solids.hi[at, :2] - solids.lo[at, :2]).prod(1).max() < LEAST_SIDE**2:
            continue
        if z > _HIGHEST_TOP - asset.size[2] / 2:
            continue
        for lo, hi in _rectangles(at, z, solids):
            whole = _place(asset, k, lo, hi, z, solids)
            found += [place for place in _by_door(whole, asset, solids) if place.room >= LEAST_ROOM]
    return found


def _levels(tops: Array) -> list[float]:
    """The highest of every group of tops that are one level, from below."""
    found: list[float] = []
    for z in np.unique(tops)[::-1]:
        if not found or z < found[-1] - LEVEL:
            found.append(float(z))
    return found[::-1]


def _rectangles(at: NDArray[np.int64], z: float, solids: _Solids) -> list[tuple[Array, Array]]:
    """Rectangles of the level made of the tops of pieces `at`, clear of all that stands there."""
    wide = at[(solids.hi[at, :2] - solids.lo[at, :2]).min(1) > 2 * SEAM]
    faces = [(solids.lo[i, :2] - SEAM, solids.hi[i, :2] + SEAM, _face(solids.pieces[i])) for i in wide]
    faces = [face for face in faces if face[2] is not False]
    if not faces:
        return []
    over = (solids.lo[:, 2] < z + LEAST_ROOM) & (solids.hi[:, 2] > z + 0.002)
    lows, highs = solids.lo[over, :2], solids.hi[over, :2]
    xs, ys = (_ticks([face[0][a] for face in faces] + [face[1][a] for face in faces]
                     + [*lows[:, a], *highs[:, a]],
                     min(face[0][a] for face in faces), max(face[1][a] for face in faces),
                     any(face[2] is not None for face in faces)) for a in (0, 1))
    free = np.zeros((len(xs) - 1, len(ys) - 1), bool)
    for lo, hi, polygon in faces:
        free |= _inside(xs, ys, lo, hi) if polygon is None else _within(xs, ys, polygon)
    free &= ~_touched(xs, ys, lows, highs)
    return list(_largest(free, xs, ys))


def _face(piece: Collider) -> "shapely.Polygon | None | Literal[False]":
    """The outline of a piece's top: None where it is the rectangle of its bounds, False where it has none."""
    if piece.kind == "box" and piece.rotation is UNTURNED and piece.size[2] > 2 * _THIN:
        return None
    points = corners(piece)
    top = points[points[:, 2] > points[:, 2].max() - _THIN, :2]
    if len(top) < 3:
        return False
    outline = shapely.convex_hull(shapely.multipoints(top))
    if piece.kind == "box" and len(top) == 4:
        sides = np.ptp(points[:, :2], axis=0)
        if abs(float(sides.prod()) - outline.area) < 1e-6:
            return None
    return outline if outline.area > LEAST_SIDE**2 else False


def _ticks(values: list[float], least: float, most: float, fine: bool) -> Array:
    inner = [v for v in values if least < v < most]
    even: list[float] = np.linspace(least, most, _TICKS).tolist() if fine else []
    every = np.unique(np.round([least, most, *inner, *even], 5))
    every = every[np.concatenate([[True], np.diff(every) > 5e-4])]
    return every if len(every) <= _MANY else np.linspace(least, most, _MANY)


def _inside(xs: Array, ys: Array, lo: Array, hi: Array) -> NDArray[np.bool_]:
    """Cells that a face covers wholly."""
    along = (xs[:-1] > lo[0] - 6e-4) & (xs[1:] < hi[0] + 6e-4)
    across = (ys[:-1] > lo[1] - 6e-4) & (ys[1:] < hi[1] + 6e-4)
    return np.asarray(along[:, None] & across[None])


def _touched(xs: Array, ys: Array, lows: Array, highs: Array) -> NDArray[np.bool_]:
    """Cells that any of the blocks (n, 2) reaches into."""
    along = (xs[1:] > lows[:, :1] + 1e-4) & (xs[:-1] < highs[:, :1] - 1e-4)
    across = (ys[1:] > lows[:, 1:] + 1e-4) & (ys[:-1] < highs[:, 1:] - 1e-4)
    return np.asarray(along.T @ across)


def _within(xs: Array, ys: Array, polygon: shapely.Polygon) -> NDArray[np.bool_]:
    """Cells with all four corners in the polygon."""
    shapely.prepare(polygon)
    wide = polygon.buffer(1e-4)
    at = shapely.contains_xy(wide, *np.meshgrid(xs, ys, indexing="ij"))
    return np.asarray(at[:-1, :-1] & at[1:, :-1] & at[:-1, 1:] & at[1:, 1:])


def _largest(free: NDArray[np.bool_], xs: Array, ys: Array) -> "list[tuple[Array, Array]]":
    """The largest rectangles of free cells, one after another, without what is too narrow to use."""
    found: list[tuple[Array, Array]] = []
    while free.any() and len(found) < _MOST:
        r0, r1, c0, c1 = rectangles.largest(free, xs, ys)
        free[r0:r1, c0:c1] = False
        lo, hi = np.array([xs[r0], ys[c0]]) + EDGE, np.array([xs[r1], ys[c1]]) - EDGE
        if (hi - lo).min() < LEAST_SIDE:
            break
        found.append((lo, hi))
    return found


def _place(asset: Asset, k: int, lo: Array, hi: Array, z: float, solids: _Solids) -> Receptacle:
    joint = asset.links[k].joint
    far = hi.copy()
    if joint is not None:
        far[0] += joint.range[1]
    above = (solids.lo[:, 2] >= z + 0.01) & (solids.lo[:, :2] < far).all(1) & (solids.hi[:, :2] > lo).all(1)
    if joint is not None:
        above &= solids.link != k
    room = float(solids.lo[above, 2].min() - z) if above.any() else OPEN
    (x0, y0), (x1, y1) = lo.round(4).tolist(), hi.round(4).tolist()
    if joint is not None:
        return Receptacle("", "drawer", (x0, y0), (x1, y1), z, room, joint.name)
    door = _door(asset, lo, hi, z, room, solids)
    kind: Kind = "inside" if door else "shelf" if room < OPEN else "basin" if _sunk(lo, hi, z, solids) else "top"
    return Receptacle("", kind, (x0, y0), (x1, y1), z, room, door)


def _sunk(lo: Array, hi: Array, z: float, solids: _Solids) -> bool:
    """Whether a face is the bottom of a basin."""
    high = (solids.hi[:, 2] > z + RIM) & (solids.lo[:, 2] < z + RIM)
    low_side, high_side = solids.lo[high, :2], solids.hi[high, :2]
    sides = 0
    for a in (0, 1):
        along = (low_side[:, 1 - a] < hi[1 - a]) & (high_side[:, 1 - a] > lo[1 - a])
        for near in (np.abs(high_side[:, a] - lo[a]), np.abs(low_side[:, a] - hi[a])):
            sides += bool((along & (near < BESIDE)).any())
    return sides >= 3


def _door(asset: Asset, lo: Array, hi: Array, z: float, room: float, solids: _Solids) -> str:
    """The joint of the first moving part that stands before a place, empty where none does."""
    before = _before(lo, hi, z, room, solids)
    return _joint(asset, int(solids.link[before[0]])) if len(before) else ""


def _before(lo: Array, hi: Array, z: float, room: float, solids: _Solids) -> NDArray[np.int64]:
    """Pieces of moving parts that stand before a place."""
    low, high = np.array([lo[1] + 0.03, z + 0.02]), np.array([hi[1] - 0.03, z + min(room, 0.3) - 0.02])
    before = (solids.link > 0) & (solids.hi[:, 0] > hi[0] - 0.01)
    before &= (solids.lo[:, 1:] < high).all(1) & (solids.hi[:, 1:] > low).all(1)
    return np.flatnonzero(before)


def _joint(asset: Asset, link: int) -> str:
    joint = asset.links[link].joint
    return joint.name if joint is not None else ""


def _by_door(whole: Receptacle, asset: Asset, solids: _Solids) -> list[Receptacle]:
    """A place cut where two doors that stand side by side before it meet: one for each of them, which opens it."""
    if whole.kind != "inside":
        return [whole]
    lo, hi = np.array(whole.lo), np.array(whole.hi)
    pieces = _before(lo, hi, whole.z, whole.room, solids)
    doors = sorted((float(solids.lo[own, 1].min()), float(solids.hi[own, 1].max()), int(link))
                   for link in np.unique(solids.link[pieces]) for own in [pieces[solids.link[pieces] == link]])
    if len(doors) < 2 or any(a[1] > b[0] + EDGE for a, b in zip(doors, doors[1:])):
        return [whole]
    cuts = [(a[1] + b[0]) / 2 for a, b in zip(doors, doors[1:])]
    sides = zip([lo[1], *(cut + EDGE for cut in cuts)], [*(cut - EDGE for cut in cuts), hi[1]])
    return [whole._replace(lo=(whole.lo[0], round(float(y0), 4)), hi=(whole.hi[0], round(float(y1), 4)),
                           part=_joint(asset, link))
            for (y0, y1), (_, _, link) in zip(sides, doors) if y1 - y0 >= LEAST_SIDE]
