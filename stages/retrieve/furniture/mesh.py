"""Closed triangle shapes: bodies of revolution, lofts, tubes, cushions, prisms, in metres.

Vertices are shared where a surface is smooth and doubled along hard edges, so that averaging face normals
over shared vertices shades right; welding by position closes every shape. Faces point outward.
"""

from collections.abc import Sequence
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from apartgen.stages.things import extents

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

LATELY = 512
"""Shapes that are at hand: pieces have many of one, homes few in common."""
_SHEAR = np.array([[1.0, 0.0], [0.0, 1.0], [0.7, 0.7]])
"""Texture coordinates of smooth shapes: one linear map, so there is no seam; no axis-aligned face collapses."""


class Shape(NamedTuple):
    """`vertices` (n, 3), outward `faces` (m, 3), `uv` (n, 2) in metres."""

    vertices: Array
    faces: Faces
    uv: Array

    def moved(self, offset: ArrayLike, matrix: Array | None = None) -> "Shape":
        """Turned (or scaled) by `matrix`, then shifted; the texture stays on the shape."""
        turned = self.vertices if matrix is None else self.vertices @ matrix.T
        return Shape(turned + np.asarray(offset, float), self.faces, self.uv)

    @property
    def volume(self) -> float:
        """m³, by the divergence theorem."""
        return extents.volume(self.vertices, self.faces)


def _cross(a: Sequence[float], b: Sequence[float]) -> Array:
    """The vector product of two; numpy's own spends most of its time on axes."""
    (ax, ay, az), (bx, by, bz) = a, b
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def mapped(vertices: Array, faces: Faces) -> Shape:
    """A shape with the seamless texture map, turned outward."""
    shape = Shape(vertices, faces, vertices @ _SHEAR)
    return shape if shape.volume > 0 else Shape(vertices, faces[:, ::-1], shape.uv)


@cache
def _strip(rings: int, points: int, loop: bool, sharp: tuple[int, ...], caps: bool) -> tuple[Faces, Faces]:
    """Faces of a loft, and for every vertex the flat index of the ring point it copies."""
    copies: list[int] = []
    spans: list[tuple[int, int]] = []
    first = last = -1
    for ring in range(rings):
        own = list(range(ring * points, (ring + 1) * points))
        start = len(copies)
        copies += own
        if ring > 0:
            spans.append((last, start))
        if ring in sharp:
            start = len(copies)
            copies += own
        first, last = (0 if ring == 0 else first), start
    if loop:
        spans.append((last, len(copies)))
        copies += list(range(points))
    k = np.arange(points)
    nxt = (k + 1) % points
    faces = [np.array([[a + k, a + nxt, b + nxt], [a + k, b + nxt, b + k]]).transpose(0, 2, 1) for a, b in spans]
    every = [f.reshape(-1, 3) for f in faces]
    if caps:
        for ring, flip in ((0, True), (rings - 1, False)):
            base = len(copies)
            copies += list(range(ring * points, (ring + 1) * points)) + [-1 - ring]
            fan = np.stack([base + k, base + nxt, np.full(points, base + points)], 1)
            every.append(fan[:, ::-1] if flip else fan)
    return np.concatenate(every), np.array(copies)


def loft(rings: Array, *, caps: bool = True, sharp: Sequence[int] = ()) -> Shape:
    """A skin over `rings` (k, m, 3), capped flat, or closed into a loop when there are no caps.

    `sharp` rings are hard edges.
    """
    k, m, _ = rings.shape
    faces, copies = _strip(k, m, not caps, tuple(sharp), caps)
    flat = rings.reshape(-1, 3)
    vertices = flat[np.maximum(copies, 0)]
    for i in np.flatnonzero(copies < 0):
        vertices[i] = rings[-1 - copies[i]].mean(0)
    return mapped(vertices, faces)


@cache
def circle(points: int, phase: float = 0.0) -> Array:
    """Unit circle (points, 2), counter-clockwise."""
    t = 2 * np.pi * (np.arange(points) + phase) / points
    return np.stack([np.cos(t), np.sin(t)], 1)


def oval(points: int, exponent: float = 2.0) -> Array:
    """Unit superellipse (points, 2); 2 is round, larger is squarer."""
    c = circle(points)
    return np.sign(c) * np.abs(c) ** (2 / exponent)


def sharp_edges(profile: Array, loop: bool, angle: float = 0.6) -> tuple[int, ...]:
    """Indices of a profile (k, 2) where it turns by more than `angle` radians."""
    step = np.diff(np.vstack([profile, profile[:1]]) if loop else profile, axis=0)
    heading = np.arctan2(step[:, 1], step[:, 0])
    turn = np.abs((np.diff(heading) + np.pi) % (2 * np.pi) - np.pi)
    return tuple(int(i) + 1 for i in np.flatnonzero(turn > angle))


@lru_cache(LATELY)
def _lathe(profile: tuple[tuple[float, float], ...], points: int, caps: bool) -> Shape:
    line = np.array(profile, float)
    c = circle(points)
    rings = np.concatenate([line[:, None, :1] * c[None], np.broadcast_to(line[:, None, 1:], (len(line), points, 1))], 2)
    shape = loft(rings, caps=caps, sharp=sharp_edges(line, not caps))
    if np.ptp(line[:, 1]) < 0.6 * line[:, 0].max():
        return shape
    x, y, z = shape.vertices.T
    return shape._replace(uv=np.stack([z, np.abs(np.arctan2(y, x)) * line[:, 0].mean()], 1))


def lathe(profile: Sequence[tuple[float, float]], points: int = 16, *, caps: bool = True) -> Shape:
    """A body of revolution about z from (radius > 0, z) points; without caps the profile is a closed loop."""
    return _lathe(tuple((round(float(r), 5), round(float(z), 5)) for r, z in profile), points, caps)


def frame_of(direction: ArrayLike) -> Array:
    """A rotation (3, 3) that takes z to `direction`."""
    z = np.asarray(direction, float)
    z = z / np.sqrt(z.dot(z))
    side = (1.0, 0.0, 0.0) if abs(z[0]) < 0.7 else (0.0, 1.0, 0.0)
    y = _cross(z.tolist(), side)
    y /= np.sqrt(y.dot(y))
    return np.array([_cross(y.tolist(), z.tolist()), y, z]).T.copy()


def rod(a: ArrayLike, b: ArrayLike, r0: float, r1: float | None = None, points: int = 12) -> Shape:
    """A round bar from a to b, of radius r0 at a and r1 at b."""
    start, end = np.asarray(a, float), np.asarray(b, float)
    length = float(np.linalg.norm(end - start))
    shape = _lathe(((r0, 0.0), (r0 if r1 is None else r1, length)), points, True)
    return shape.moved(start, frame_of(end - start))


def tube(path: ArrayLike, radius: float, points: int = 8) -> Shape:
    """A bent round bar along `path` (k, 3), mitred at its corners."""
    p = np.asarray(path, float)
    step = np.diff(p, axis=0)
    step /= np.linalg.norm(step, axis=1, keepdims=True)
    frame = frame_of(step[0])
    rings = [p[0] + radius * circle(points) @ frame[:, :2].T]
    for i in range(1, len(p)):
        nxt = step[min(i, len(step) - 1)]
        plane = step[i - 1] + nxt
        ahead = ((p[i] - rings[-1]) @ plane) / (step[i - 1] @ plane)
        rings.append(rings[-1] + ahead[:, None] * step[i - 1])
    return loft(np.array(rings))


@cache
def _cube_grid(n: int) -> tuple[Array, Faces]:
    """Welded surface grid of the cube [-1, 1]³, n cells an edge: vertices and outward faces."""
    t = np.linspace(-1, 1, n + 1)
    a, b = (g.ravel() for g in np.meshgrid(t, t, indexing="ij"))
    k = (np.arange(n)[:, None] * (n + 1) + np.arange(n)[None]).ravel()
    quad = np.concatenate([np.stack([k, k + n + 1, k + n + 2], 1), np.stack([k, k + n + 2, k + 1], 1)])
    points: list[Array] = []
    faces: list[Faces] = []
    for axis in range(3):
        for side in (-1, 1):
            grid = np.empty((len(a), 3))
            grid[:, axis], grid[:, (axis + 1) % 3], grid[:, (axis + 2) % 3] = side, a, b
            faces.append((quad if side > 0 else quad[:, ::-1]) + len(points) * len(a))
            points.append(grid)
    every, index = np.unique(np.concatenate(points).round(9), axis=0, return_inverse=True)
    return every, index.ravel()[np.concatenate(faces)]


@cache
def _pillow(exponent: float, n: int) -> tuple[Array, Faces]:
    grid, faces = _cube_grid(n)
    even = np.tan(grid * np.pi / 4)
    return even / (np.abs(even) ** exponent).sum(1, keepdims=True) ** (1 / exponent), faces


def pillow(lo: ArrayLike, hi: ArrayLike, exponent: float = 5.0, n: int = 6) -> Shape:
    """A superellipsoid filling the box: 2 is an ellipsoid, 8 nearly a box; convex for any exponent >= 1."""
    low, high = np.asarray(lo, float), np.asarray(hi, float)
    unit, faces = _pillow(exponent, n)
    return mapped((low + high) / 2 + unit * (high - low) / 2, faces)


@cache
def _round(n: int) -> tuple[Array, Array, Faces]:
    """Directions and signs of a rounded box whose corners have n cells an edge."""
    t = np.concatenate([np.linspace(-1, 0, n + 1), np.linspace(0, 1, n + 1)])
    grid, faces = _cube_grid(2 * n + 1)
    cells = np.rint((grid + 1) / 2 * (2 * n + 1)).astype(int)
    even = np.tan(t[cells] * np.pi / 4)
    return even / np.linalg.norm(even, axis=1, keepdims=True), np.where(cells <= n, -1.0, 1.0), faces


def rounded(lo: ArrayLike, hi: ArrayLike, radius: float, n: int = 2) -> Shape:
    """A box with every edge rounded; `radius` at most half the shortest side."""
    low, high = np.asarray(lo, float), np.asarray(hi, float)
    r = min(radius, float((high - low).min()) / 2 * 0.999)
    direction, sign, faces = _round(n)
    return mapped((low + high) / 2 + sign * ((high - low) / 2 - r) + r * direction, faces)


def ribbon(outline: Array, lo: float, hi: float) -> Shape:
    """A long bent sheet standing from lo to hi; `outline` (2k, 2) runs along its front and back along its back."""
    m = len(outline)
    k, nxt = np.arange(m), (np.arange(m) + 1) % m
    points = [np.column_stack([outline, np.full(m, z)]) for z in (lo, hi, lo, hi)]
    wall = np.concatenate([np.stack([k, nxt, nxt + m], 1), np.stack([k, nxt + m, k + m], 1)])
    i = np.arange(m // 2 - 1)
    cap = np.concatenate([np.stack([i, i + 1, m - 2 - i], 1), np.stack([i, m - 2 - i, m - 1 - i], 1)])
    return mapped(np.concatenate(points), np.concatenate([wall, cap[:, ::-1] + 2 * m, cap + 3 * m]))


def slab(upper: Array, lower: Array) -> Shape:
    """The solid between two grids of points (k, m, 3), such as a moulded seat or a folded cloth."""
    k, m = upper.shape[:2]
    i = (np.arange(k - 1)[:, None] * m + np.arange(m - 1)[None]).ravel()
    sheet = np.concatenate([np.stack([i, i + m, i + m + 1], 1), np.stack([i, i + m + 1, i + 1], 1)])
    along, across = np.arange(k) * m, np.arange(m)
    rim = np.concatenate([across[:-1], along[:-1] + m - 1, across[:0:-1] + (k - 1) * m, along[:0:-1]])
    nxt, n = np.roll(rim, -1), k * m
    wall = np.concatenate([np.stack([rim, nxt, nxt + n], 1), np.stack([rim, nxt + n, rim + n], 1)])
    both = np.concatenate([upper.reshape(-1, 3), lower.reshape(-1, 3)])
    return mapped(np.concatenate([both, both]), np.concatenate([sheet, sheet[:, ::-1] + n, wall + 2 * n]))


@cache
def _facets(k: int, m: int) -> tuple[NDArray[np.int64], Faces]:
    """For every vertex of a loft with flat sides the flat index of its ring's point, and the faces."""
    flat = np.arange(k * m).reshape(k, m)
    nxt = np.roll(flat, -1, axis=1)
    quads = np.stack([flat[:-1], nxt[:-1], nxt[1:], flat[1:]], 2).ravel()
    base = 4 * np.arange((k - 1) * m)[:, None]
    sides = np.concatenate([base + [0, 1, 2], base + [0, 2, 3]])
    fan = np.stack([np.zeros(m - 2, int), np.arange(1, m - 1), np.arange(2, m)], 1) + len(quads)
    return np.concatenate([quads, flat[0], flat[-1]]), np.concatenate([sides, fan[:, ::-1], fan + m])


def facets(rings: Array) -> Shape:
    """A loft whose every side is flat, for outlines with corners; `rings` is (k, m, 3)."""
    copies, faces = _facets(*rings.shape[:2])
    return mapped(rings.reshape(-1, 3)[copies], faces)


def prism(outline: ArrayLike, lo: float, hi: float, axis: int = 2, *, smooth: bool = False) -> Shape:
    """A convex outline (m, 2) extruded along `axis`; the outline's plane is the two axes after it."""
    flat = np.asarray(outline, float)
    rings = np.empty((2, len(flat), 3))
    rings[:, :, axis] = np.array([[lo], [hi]])
    rings[:, :, (axis + 1) % 3], rings[:, :, (axis + 2) % 3] = flat[:, 0], flat[:, 1]
    return loft(rings) if smooth else facets(rings)
