"""A rigid part under construction: boards, bars, cushions and shells, each with its collision pieces.

Drawn in a frame with x to the front and y to the left from the middle of the footprint, z up from the floor.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.mesh import Array, Shape
from apartgen.stages.things import extents, materials
from apartgen.stages.things.asset import Collider, Mesh

_CORNER = np.array([[0, 0, 0], [0, 0, 1], [0, 1, 0], [0, 1, 1], [1, 0, 0], [1, 0, 1], [1, 1, 0], [1, 1, 1]])
_SIDES = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
_BOX = _CORNER[_SIDES.ravel()].astype(float)
_ACROSS = np.array([[1, 2], [1, 2], [2, 0], [2, 0], [0, 1], [0, 1]]).repeat(4, 0)
_TRIANGLES = (np.array([[0, 1, 2], [0, 2, 3]]) + 4 * np.arange(6)[:, None, None]).reshape(-1, 3)
_BOX_RADIUS = 0.006
"""Edges rounded by less than this still collide as a box, m."""
_BEND = 0.004
"""A turned profile's collision pieces stay this close to it, m."""


def _in_order(x: Sequence[float], y: Sequence[float], z: Sequence[float]) -> None:
    """BadInput where what is drawn between (least, greatest) has no extent, or ends before it begins."""
    for side, (least, greatest) in zip("xyz", (x, y, z), strict=True):
        if least >= greatest:
            raise BadInput(f"draws from {side} = {least:.4g} to {greatest:.4g}; give (least, greatest), least first")


class Body:
    """Pieces of one link; `fill` is the share of the pieces drawn next that is solid material."""

    def __init__(self) -> None:
        self.boxes: dict[str, list[tuple[float, ...]]] = {}
        self.shapes: dict[str, list[Shape]] = {}
        self.colliders: list[Collider] = []
        self.mass = 0.0
        self.fill = 1.0

    def box(
        self, material: str, x: Sequence[float], y: Sequence[float], z: Sequence[float], touch: bool = True
    ) -> None:
        """A board between (least, greatest) of x, y and z."""
        _in_order(x, y, z)
        row = (x[0], y[0], z[0], x[1], y[1], z[1])
        self.boxes.setdefault(material, []).append(row)
        sides = (x[1] - x[0], y[1] - y[0], z[1] - z[0])
        self.mass += self.fill * materials.density(material) * sides[0] * sides[1] * sides[2]
        if touch:
            self.block(x, y, z)

    def block(self, x: Sequence[float], y: Sequence[float], z: Sequence[float]) -> None:
        """A collision box alone, for pieces drawn without `touch`."""
        _in_order(x, y, z)
        lo, hi = np.array([x[0], y[0], z[0]], float), np.array([x[1], y[1], z[1]], float)
        self.colliders.append(Collider("box", (lo + hi) / 2, hi - lo))

    def add(self, material: str, shape: Shape, touch: bool = True) -> None:
        """A convex shape; without `touch` it is seen only."""
        self.show(material, shape)
        self.mass += self.fill * materials.density(material) * shape.volume
        if touch:
            self.hull(shape.vertices)

    def show(self, material: str, shape: Shape) -> None:
        """A shape that is seen only, and weighs nothing."""
        self.shapes.setdefault(material, []).append(shape)

    def take(self, other: "Body") -> None:
        """The pieces of another body as its own."""
        for material, boxes in other.boxes.items():
            self.boxes.setdefault(material, []).extend(boxes)
        for material, shapes in other.shapes.items():
            self.shapes.setdefault(material, []).extend(shapes)
        self.colliders += other.colliders
        self.mass += other.mass

    def hull(self, points: ArrayLike) -> None:
        """A collision piece: the convex hull of points (n, 3)."""
        middle, sides, local = extents.centred(np.asarray(points, float))
        self.colliders.append(Collider("hull", middle, sides, vertices=local))

    def rod(self, material: str, a: ArrayLike, b: ArrayLike, r0: float, r1: float | None = None, n: int = 12) -> None:
        """A round bar from a to b, tapering from r0 to r1."""
        shape = mesh.rod(a, b, r0, r1, n)
        self.add(material, shape, touch=r1 is not None and r1 != r0)
        if r1 is None or r1 == r0:
            start, end = np.asarray(a, float), np.asarray(b, float)
            size = np.array([r0, r0, np.linalg.norm(end - start)])
            self.colliders.append(Collider("cylinder", (start + end) / 2, size, mesh.frame_of(end - start)))

    def leg(self, material: str, foot: ArrayLike, head: ArrayLike, r0: float, r1: float, n: int = 12) -> None:
        """A leaning leg whose ends are cut level: radius r0 on the floor, r1 under what it carries."""
        rings = [
            np.column_stack([r * mesh.circle(n) + p[:2], np.full(n, p[2])])
            for p, r in ((np.asarray(foot, float), r0), (np.asarray(head, float), r1))
        ]
        shape = mesh.loft(np.array(rings))
        x, y, z = shape.vertices.T
        self.add(material, shape._replace(uv=np.stack([z, x + 0.5 * y], 1)))

    def slab(self, material: str, upper: Array, lower: Array, strips: int = 3) -> None:
        """The solid between two grids (k, m, 3); collides cell by cell along k, in `strips` across m."""
        self.add(material, mesh.slab(upper, lower), touch=False)
        edges = np.linspace(0, upper.shape[1] - 1, strips + 1).round().astype(int)
        for i in range(len(upper) - 1):
            for a, b in zip(edges[:-1], edges[1:], strict=True):
                pieces = [grid[i : i + 2, a : b + 1].reshape(-1, 3) for grid in (upper, lower)]
                self.hull(np.concatenate(pieces))

    def tube(self, material: str, path: Sequence[Sequence[float]], radius: float, n: int = 8) -> None:
        """A bent round bar with rounded bends; one collision cylinder a straight."""
        p = _bent(np.asarray(path, float), 2.5 * radius)
        self.add(material, mesh.tube(p, radius, n), touch=False)
        for a, b in zip(p[:-1], p[1:], strict=True):
            size = np.array([radius, radius, np.linalg.norm(b - a)])
            self.colliders.append(Collider("cylinder", (a + b) / 2, size, mesh.frame_of(b - a)))

    def pillow(self, material: str, x: Any, y: Any, z: Any, soft: float = 5.0, n: int = 6) -> None:
        """A cushion filling the ranges; larger `soft` is squarer."""
        _in_order(x, y, z)
        self.add(material, mesh.pillow((x[0], y[0], z[0]), (x[1], y[1], z[1]), soft, n))

    def rounded(self, material: str, x: Any, y: Any, z: Any, radius: float, n: int = 2) -> None:
        """A box with rounded edges."""
        _in_order(x, y, z)
        shape = mesh.rounded((x[0], y[0], z[0]), (x[1], y[1], z[1]), radius, n)
        self.add(material, shape, touch=radius > _BOX_RADIUS)
        if radius <= _BOX_RADIUS:
            self.block(x, y, z)

    def prism(
        self, material: str, outline: ArrayLike, lo: float, hi: float, axis: int = 2, smooth: bool = False
    ) -> None:
        """A convex outline extruded along an axis."""
        self.add(material, mesh.prism(outline, lo, hi, axis, smooth=smooth))

    def turned(
        self, material: str, profile: Sequence[tuple[float, float]], at: ArrayLike = (0, 0, 0), n: int = 16,
        along: ArrayLike | None = None,
    ) -> None:  # fmt: skip
        """A solid of revolution with its axis upward (or `along`) from `at`; collides as a stack of frusta."""
        matrix = None if along is None else mesh.frame_of(along)
        self.add(material, mesh.lathe(profile, n).moved(at, matrix), touch=False)
        for low, high in _frusta(np.asarray(profile, float)):
            self.hull(mesh.rod((0, 0, low[1]), (0, 0, high[1]), low[0], high[0], n).moved(at, matrix).vertices[: 2 * n])

    def shell(
        self, material: str, outer: Sequence[tuple[float, float]], inner: Sequence[tuple[float, float]],
        at: ArrayLike = (0, 0, 0), n: int = 24, along: ArrayLike | None = None,
    ) -> None:  # fmt: skip
        """A hollow of revolution: `outer` and `inner` from the bottom up, as many points each.

        Each pair of steps makes one ring of collision wedges.
        """
        matrix = np.eye(3) if along is None else mesh.frame_of(along)
        self.add(material, mesh.lathe([*outer, *reversed(inner)], n, caps=False).moved(at, matrix), touch=False)
        c, start = mesh.circle(n), np.asarray(at, float)
        low, high = np.asarray(outer, float), np.asarray(inner, float)
        self._wedges(low, high, c, matrix, start)

    def _wedges(self, outer: Array, inner: Array, c: Array, matrix: Array, at: Array) -> None:
        n = len(c)
        for k in range(len(outer) - 1):
            ring = np.array([outer[k], outer[k + 1], inner[k + 1], inner[k]])
            points = np.concatenate([ring[:, None, :1] * c[None], np.broadcast_to(ring[:, None, 1:], (4, n, 1))], 2)
            for i in range(n):
                self.hull(points[:, [i, (i + 1) % n]].reshape(-1, 3) @ matrix.T + at)

    def hollow(self, material: str, outer: Array, inner: Array) -> None:
        """A moulded vessel: rings (k, m, 3) of its outside from the bottom up to the rim, `inner` from rim to floor."""
        self.add(material, mesh.loft(np.concatenate([outer, inner]), sharp=(len(outer) - 1,)), touch=False)
        self.vessel_hulls(outer, inner)

    def vessel_hulls(self, outer: Array, inner: Array) -> None:
        """Collision pieces of a vessel: wedges between its skins, slabs under its floor."""
        m = outer.shape[1]
        for high, low in zip(inner[:-1], inner[1:], strict=True):
            bends = [r for r in outer if low[0, 2] < r[0, 2] < high[0, 2]]
            wall = [high, low, _at_height(outer, high), _at_height(outer, low), *bends]
            for i in range(m):
                j = [i, (i + 1) % m]
                self.hull(np.concatenate([r[j] for r in wall]))
        below = [r for r in outer if r[0, 2] < inner[-1][0, 2] - 1e-6]
        floor = [*below, _at_height(outer, inner[-1])]
        for low, high in zip(floor[:-1], floor[1:], strict=True):
            self.hull(np.concatenate([low, high]))

    def bounds(self) -> tuple[Array, Array]:
        """Least and greatest corner."""
        rows = np.array([row for rows in self.boxes.values() for row in rows]).reshape(-1, 6)
        corners = [rows[:, :3], rows[:, 3:]] + [s.vertices for group in self.shapes.values() for s in group]
        every = np.concatenate(corners)
        return every.min(0), every.max(0)

    def meshes(self, drop: float) -> list[Mesh]:
        """One mesh a material, `drop` metres lower."""
        names = sorted({*self.boxes, *self.shapes})
        return [_joined(name, self.boxes.get(name, []), self.shapes.get(name, []), drop) for name in names]


def _bent(path: Array, radius: float) -> Array:
    """A path (k, 3) with its sharp corners replaced by three points of an arc about `radius` wide."""
    points = [path[0]]
    for before, corner, after in zip(path[:-2], path[1:-1], path[2:], strict=True):
        a, b = before - corner, after - corner
        la, lb = float(np.linalg.norm(a)), float(np.linalg.norm(b))
        if a @ b < -0.85 * la * lb:
            points.append(corner)
            continue
        cut = min(radius, 0.45 * la, 0.45 * lb)
        start, end = corner + a / la * cut, corner + b / lb * cut
        points += [start, (start + end) / 4 + corner / 2, end]
    return np.array([*points, path[-1]])


def _at_height(rings: Array, ring: Array) -> Array:
    """The skin through `rings` at the height of `ring`, point by point (m, 3)."""
    height, z = ring[:, 2].mean(), rings[:, :, 2].mean(1)
    k = int(np.clip(np.searchsorted(z, height) - 1, 0, len(z) - 2))
    share = np.clip((height - z[k]) / max(z[k + 1] - z[k], 1e-9), 0, 1)
    return np.asarray(rings[k] * (1 - share) + rings[k + 1] * share)


def _frusta(profile: Array) -> list[tuple[Array, Array]]:
    """The fewest straight stretches that stay within `_BEND` of a profile (k, 2)."""
    found, start = [], 0
    while start < len(profile) - 1:
        end = start + 1
        while end + 1 < len(profile) and _straight(profile[start : end + 2]):
            end += 1
        if profile[end][1] - profile[start][1] > 1e-6:
            found.append((profile[start], profile[end]))
        start = end
    return found


def _straight(points: Array) -> bool:
    z = points[:, 1]
    if z[-1] - z[0] < 1e-6 or (np.diff(z) < 0).any():
        return False
    chord = np.interp(z, [z[0], z[-1]], [points[0, 0], points[-1, 0]])
    return bool(np.abs(chord - points[:, 0]).max() < _BEND and (np.diff(z) > 1e-6).all())


def _box_shapes(rows: Array, phase: Array) -> tuple[Array, mesh.Faces, Array]:
    """Vertices, faces and texture coordinates of boxes (k, 6); the texture's u runs along each box's longest side."""
    lo, size = rows[:, None, :3], rows[:, None, 3:] - rows[:, None, :3]
    vertices = lo + _BOX * size
    k = len(rows)
    u, v = vertices[:, np.arange(24), _ACROSS[:, 0]], vertices[:, np.arange(24), _ACROSS[:, 1]]
    longest = np.argmax(rows[:, 3:] - rows[:, :3], 1)[:, None]
    turn = (_ACROSS[:, 1] == longest) | (
        (_ACROSS[:, 0] != longest) & (size[:, 0, _ACROSS[:, 1]] > size[:, 0, _ACROSS[:, 0]])
    )
    uv = np.stack([np.where(turn, v, u), np.where(turn, u, v)], 2) + phase[:, None, None]
    faces = _TRIANGLES[None] + 24 * np.arange(k)[:, None, None]
    return vertices.reshape(-1, 3), faces.reshape(-1, 3), uv.reshape(-1, 2)


def _joined(name: str, boxes: list[tuple[float, ...]], shapes: list[Shape], drop: float) -> Mesh:
    """All pieces of a material; each is shifted by another micrometre, so that welding never joins two at an edge."""
    parts = list(shapes)
    if boxes:
        k = np.arange(len(boxes))
        vertices, faces, uv = _box_shapes(np.array(boxes, float), np.asarray(0.37 * k, float))
        parts.append(Shape(vertices + 1e-6 * (0.5 + k.repeat(24)[:, None] + len(parts)), faces, uv))
    count = [len(p.vertices) for p in parts]
    nudge = -1e-6 * np.arange(len(parts))[:, None] - np.array([0, 0, drop])
    vertices = np.concatenate([p.vertices for p in parts]) + np.repeat(nudge, count, 0)
    start = np.repeat(np.cumsum([0, *count[:-1]]), [len(p.faces) for p in parts])
    faces = np.concatenate([p.faces for p in parts]) + start[:, None]
    uv = np.concatenate([p.uv for p in parts]) / materials.span(name)
    return Mesh(vertices, faces, materials.material(name), uv)
