"""Convex collision pieces of any mesh: hulls where it is near convex, boxes along its surface where it is hollow."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull, QhullError

from apartgen.stages.retrieve.reading.pieces import Array, Piece
from apartgen.stages.things.asset import Collider

Cell = NDArray[np.signedinteger[Any]]

THIN = 0.004
"""Least thickness of a collision piece, m."""
DEEP = 0.03
"""Surface this far inside its own hull makes a part hollow, m."""
PARTS = 48
"""Most separate parts looked at one by one; the rest share one hull."""
BOXES = 40
"""Most boxes along a hollow part's surface."""
LOOKED = 5_000
"""Triangles that tell whether a part is hollow."""
CORNERS = 600
"""Most corners of a collision hull."""
CELLS = (28, 20, 14, 9, 6, 4)
"""Grids tried, cells along the longest side."""


def colliders(pieces: Sequence[Piece]) -> list[Collider]:
    """Convex pieces covering the surface, in the pieces' frame."""
    found: list[Collider] = []
    for corners in _parts(pieces):
        points = np.unique(corners.reshape(-1, 3), axis=0)
        found += _boxes(corners) if _hollow(corners, points) else [hull(points)]
    return found


def _parts(pieces: Sequence[Piece]) -> list[Array]:
    """Triangles (m, 3, 3) of each connected part, large ones first; the smallest together if there are too many."""
    corners = np.concatenate([piece.vertices[piece.faces] for piece in pieces])
    _, vertex = np.unique(np.round(corners.reshape(-1, 3), 5), axis=0, return_inverse=True)
    a, b, c = vertex.reshape(-1, 3).T
    links = coo_matrix((np.ones(2 * len(a)), (np.r_[a, b], np.r_[b, c])), shape=(vertex.max() + 1,) * 2)
    label = connected_components(links, directed=False)[1][a]
    order = np.argsort(-np.bincount(label), kind="stable")
    whole = len(order) if len(order) <= PARTS else PARTS - 1
    rest = np.isin(label, order[whole:])
    return [corners[label == i] for i in order[:whole]] + ([corners[rest]] if rest.any() else [])


def hull(points: Array) -> Collider:
    """The convex hull; a box at least `THIN` thick where the points lie in a plane."""
    lo, hi = points.min(0), points.max(0)
    center = (lo + hi) / 2
    if (hi - lo).min() >= THIN:
        try:
            corners = _fewer(points[ConvexHull(points).vertices])
            return Collider("hull", center, hi - lo, vertices=corners - center)
        except QhullError:
            pass
    return Collider("box", center, np.maximum(hi - lo, THIN))


def _fewer(corners: Array) -> Array:
    """At most `CORNERS` of a hull's corners: the farthest ones in directions spread evenly over its box."""
    if len(corners) <= CORNERS:
        return corners
    i = np.arange(CORNERS)
    height, turn = 1 - (2 * i + 1) / CORNERS, np.pi * (1 + 5**0.5) * i
    ring = np.sqrt(1 - height**2)
    ways = np.stack([ring * np.cos(turn), ring * np.sin(turn), height])
    far = np.argmax(corners / np.maximum(np.ptp(corners, axis=0), 1e-9) @ ways, axis=0)
    ends = np.concatenate([corners.argmin(0), corners.argmax(0)])
    return np.asarray(corners[np.unique(np.concatenate([far, ends]))])


def _hollow(corners: Array, points: Array) -> bool:
    """Whether much of the surface lies deep inside the part's hull."""
    if len(points) < 9 or np.ptp(points, axis=0).min() < THIN:
        return False
    try:
        # A fine mesh has thousands of planes; those of its farthest corners tell as much.
        planes = ConvexHull(_fewer(points[ConvexHull(points).vertices])).equations
    except QhullError:
        return False
    some = corners[np.linspace(0, len(corners) - 1, min(len(corners), LOOKED)).astype(np.int64)]
    a, b, c = np.moveaxis(some, 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    depth = -(some.mean(1) @ planes[:, :3].T + planes[:, 3]).max(1)
    return bool(area[depth > DEEP].sum() > 0.08 * area.sum())


def _boxes(corners: Array) -> list[Collider]:
    points = _cover(corners)
    for cells in CELLS:
        boxes = _along(points, cells)
        if len(boxes) <= BOXES:
            break
    return [Collider("box", (lo + hi) / 2, np.maximum(hi - lo, THIN)) for lo, hi in boxes]


def _cover(corners: Array, most: int = 60_000) -> Array:
    """Points on the surface, spread by area, and every corner."""
    a, b, c = np.moveaxis(corners, 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    share = np.cumsum(area)
    i = np.arange(1, most + 1)
    face = np.minimum(np.searchsorted(share, (i - 0.5) / most * share[-1]), len(area) - 1)
    u, v = np.modf(i * 0.7548776662466927)[0], np.modf(i * 0.5698402909980532)[0]
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    return np.concatenate([corners.reshape(-1, 3), a[face] + u[:, None] * (b - a)[face] + v[:, None] * (c - a)[face]])


def _along(points: Array, cells: int) -> list[tuple[Array, Array]]:
    """Boxes (lo, hi) around runs of filled cells, drawn in to the points they hold."""
    low, extent = points.min(0), np.ptp(points, axis=0)
    side = float(extent.max()) / cells
    shape = np.floor(extent / side).astype(np.int64) + 1
    cell = np.ravel_multi_index(tuple(np.minimum(((points - low) / side).astype(np.int64), shape - 1).T), shape)
    order = np.argsort(cell, kind="stable")
    filled, first = np.unique(cell[order], return_index=True)
    lo, hi = np.full((shape.prod(), 3), np.inf), np.full((shape.prod(), 3), -np.inf)
    lo[filled], hi[filled] = (reduce.reduceat(points[order], first, axis=0) for reduce in (np.minimum, np.maximum))
    lo, hi = lo.reshape(*shape, 3), hi.reshape(*shape, 3)
    runs = [tuple(slice(a, b) for a, b in zip(*run, strict=True)) for run in _runs(np.isfinite(lo[..., 0]))]
    return [(lo[run].min((0, 1, 2)), hi[run].max((0, 1, 2))) for run in runs]


def _runs(full: NDArray[np.bool_]) -> list[tuple[Cell, Cell]]:
    """Filled cells covered greedily by boxes (start, stop), widest direction first."""
    left = full.copy()
    found = []
    for start in np.argwhere(full):
        if not left[tuple(start)]:
            continue
        stop = max(
            (_extended(full, left, start, order) for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))),
            key=lambda s: int(np.prod(s - start)),
        )
        left[tuple(slice(a, b) for a, b in zip(start, stop, strict=True))] = False
        found.append((start, stop))
    return found


def _extended(full: NDArray[np.bool_], left: NDArray[np.bool_], start: Cell, order: Sequence[int]) -> Cell:
    stop = start + 1
    for axis in order:
        while stop[axis] < full.shape[axis]:
            layer = [slice(a, b) for a, b in zip(start, stop, strict=True)]
            layer[axis] = slice(int(stop[axis]), int(stop[axis]) + 1)
            if not left[tuple(layer)].all():
                break
            stop = stop + np.eye(3, dtype=stop.dtype)[axis]
    return stop


def volume(piece: Collider) -> float:
    """Volume, m³."""
    if piece.vertices is not None:
        return float(ConvexHull(piece.vertices).volume)
    x, y, z = (float(v) for v in piece.size)
    if piece.kind == "cylinder":
        return np.pi * x * x * z
    return 4 / 3 * np.pi * x**3 if piece.kind == "sphere" else x * y * z
