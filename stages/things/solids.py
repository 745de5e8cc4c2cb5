"""Simple closed meshes and convex pieces: boxes, cylinders, plan shapes; `uv` counts repeats of the texture."""

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray
from shapely import Geometry
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from apartgen.stages.things import materials
from apartgen.stages.things.asset import UNTURNED, Collider, Material, Mesh

Array = NDArray[np.float64]

_FACES = np.array([[0, 1, 2], [0, 2, 3]])
_CORNERS = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T
_ANGLES = np.linspace(0, 2 * np.pi, 16, endpoint=False)
_RING = np.stack([np.cos(_ANGLES), np.sin(_ANGLES), 0 * _ANGLES], -1)
_AREA = 1e-6  # m², what is smaller is left by rounding
_ABOVE = [(0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 1)]
_BELOW = [(x, y, 0) for x, y, _ in _ABOVE]
_ROUND = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]
_BESIDE = [(*at, z) for a, b in zip(_ROUND[:-1], _ROUND[1:], strict=True) for at, z in ((a, 0), (b, 0), (b, 1), (a, 1))]
_BOX = np.array([*_ABOVE, *_BELOW, *_BESIDE])
"""Which end of x, y and z each vertex of an extruded rectangle has, (24, 3)."""
_BOX_FACES = np.concatenate([[[0, 3, 1], [3, 0, 2], [5, 7, 4], [6, 4, 7]], *(_FACES + 4 * k for k in range(2, 6))])
_BOX_RUN = (np.array([[0, 1, 1, 0]]) + np.arange(4)[:, None]).ravel()


def box(lo: ArrayLike, hi: ArrayLike, material: Material) -> Mesh:
    """An upright box between two corners."""
    ends = np.stack([np.asarray(lo, float), np.asarray(hi, float)])
    (x0, y0, z0), (x1, y1, z1) = ends.tolist()
    if not (x0 < x1 and y0 < y1 and (x1 - x0) * (y1 - y0) > 2 * _AREA):
        return extruded(Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), z0, z1, material)
    vertices = ends[_BOX, np.arange(3)]
    spread = vertices[:, :2].copy()
    run = np.cumsum([0.0, x1 - x0, y1 - y0, x1 - x0, y1 - y0])
    spread[8:, 0], spread[8:, 1] = run[_BOX_RUN], vertices[8:, 2]
    return Mesh(vertices, _BOX_FACES.copy(), material, _repeats(spread, material))


def extruded(area: Geometry, z0: float, z1: float, material: Material) -> Mesh:
    """A closed prism over a polygonal area (holes and several parts allowed) from z0 to z1."""
    vertices, faces, uv = [], [], []
    count = 0
    for polygon in _parts(area):
        for points, triangles, coordinates in (*_caps(polygon, z0, z1), *_sides(polygon, z0, z1)):
            vertices.append(points)
            faces.append(triangles + count)
            uv.append(coordinates)
            count += len(points)
    return Mesh(np.concatenate(vertices), np.concatenate(faces).astype(np.int64), material,
                _repeats(np.concatenate(uv), material))


def _repeats(metres: Array, material: Material) -> Array:
    """Texture coordinates of a surface laid flat."""
    return np.asarray(metres / (materials.span(material.name) if material.texture else 1.0))


def _parts(area: Geometry) -> list[Polygon]:
    parts = shapely.get_parts(area)
    return [orient(p) for p in parts if p.geom_type == "Polygon" and p.area > _AREA]


Piece = tuple[Array, NDArray[np.int64], Array]


def _caps(polygon: Polygon, z0: float, z1: float) -> list[Piece]:
    triangles = shapely.get_coordinates(
        [orient(t) for t in shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))]
    ).reshape(-1, 4, 2)[:, :3]
    plan, index = np.unique(triangles.reshape(-1, 2), axis=0, return_inverse=True)
    faces = index.reshape(-1, 3)
    top, bottom = (np.column_stack([plan, np.full(len(plan), z)]) for z in (z1, z0))
    return [(top, faces, plan), (bottom, faces[:, ::-1], plan)]


def _sides(polygon: Polygon, z0: float, z1: float) -> list[Piece]:
    """A piece for each ring, of four vertices and two faces an edge."""
    pieces: list[Piece] = []
    for ring in (polygon.exterior, *polygon.interiors):
        start = shapely.get_coordinates(ring)
        run = np.concatenate([[0.0], np.cumsum(np.hypot(*(start[1:] - start[:-1]).T))])
        corners = np.empty((len(run) - 1, 4, 3))
        corners[:, [0, 3], :2], corners[:, [1, 2], :2] = start[:-1, None], start[1:, None]
        corners[:, :2, 2], corners[:, 2:, 2] = z0, z1
        spread = corners[:, :, 1:].copy()
        spread[:, [0, 3], 0], spread[:, [1, 2], 0] = run[:-1, None], run[1:, None]
        faces = _FACES + 4 * np.arange(len(corners))[:, None, None]
        pieces.append((corners.reshape(-1, 3), faces.reshape(-1, 3), spread.reshape(-1, 2)))
    return pieces


def cylinder(start: ArrayLike, end: ArrayLike, radius: float, material: Material, sides: int = 16) -> Mesh:
    """A closed cylinder between two points; a texture runs down both sides of it, so that it meets itself."""
    a, b = np.asarray(start, float), np.asarray(end, float)
    axis = (b - a) / np.linalg.norm(b - a)
    first = np.cross(axis, [1.0, 0, 0] if abs(axis[0]) < 0.9 else [0, 1.0, 0])
    first /= np.linalg.norm(first)
    angles = np.linspace(0, 2 * np.pi, sides, endpoint=False)[:, None]
    ring = radius * (np.cos(angles) * first + np.sin(angles) * np.cross(axis, first))
    vertices = np.concatenate([a + ring, b + ring, [a, b]])
    i, j = np.arange(sides), (np.arange(sides) + 1) % sides
    walls = np.concatenate([np.stack([i, j, j + sides], 1), np.stack([i, j + sides, i + sides], 1)])
    ends = [np.stack([j, i, np.full(sides, 2 * sides)], 1), np.stack([i, j, np.full(sides, 2 * sides + 1)], 1)]
    ends[1] = ends[1] + np.array([sides, sides, 0])
    about = radius * np.minimum(angles, 2 * np.pi - angles)[:, 0]
    uv = np.stack([np.concatenate([about, about, [0.0, 0.0]]), (vertices - a) @ axis], 1)
    return Mesh(vertices, np.concatenate([walls, *ends]).astype(np.int64), material,
                uv / materials.span(material.name) if material.texture else None)


def slab(lo: ArrayLike, hi: ArrayLike) -> Collider:
    """The box collider between two corners."""
    a, b = np.asarray(lo, float), np.asarray(hi, float)
    return Collider("box", (a + b) / 2, b - a)


def convex(area: Geometry, z0: float, z1: float) -> list[Collider]:
    """Convex pieces that fill a prism: boxes where its sides are along x and y, else triangular prisms."""
    pieces = []
    for polygon in _parts(area):
        cells = _rectangles(polygon)
        if cells is not None:
            pieces += [slab((x0, y0, z0), (x1, y1, z1)) for x0, y0, x1, y1 in cells]
        else:
            pieces += [_prism(t, z0, z1) for t in shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))]
    return pieces


def _prism(triangle: Geometry, z0: float, z1: float) -> Collider:
    plan = shapely.get_coordinates(triangle)[:3]
    points = np.array([[x, y, z] for z in (z0, z1) for x, y in plan])
    center = (points.min(0) + points.max(0)) / 2
    return Collider("hull", center, np.ptp(points, axis=0), vertices=points - center)


def _rectangles(polygon: Polygon) -> list[tuple[float, float, float, float]] | None:
    """Rectangles that fill the polygon, longest runs first; None where its sides are not along x and y."""
    points = shapely.get_coordinates(polygon)
    xs, ys = (np.unique(points[:, k].round(6)) for k in (0, 1))
    middle_x, middle_y = (xs[:-1] + xs[1:]) / 2, (ys[:-1] + ys[1:]) / 2
    inside = shapely.contains_xy(polygon, *np.meshgrid(middle_x, middle_y))
    area = float((inside * np.outer(np.diff(ys), np.diff(xs))).sum())
    if abs(area - polygon.area) > 1e-4:
        return None
    found = []
    while inside.any():
        row0, row1, column0, column1 = _largest(inside, xs, ys)
        inside[row0:row1, column0:column1] = False
        found.append((float(xs[column0]), float(ys[row0]), float(xs[column1]), float(ys[row1])))
    return found


def _largest(inside: NDArray[np.bool_], xs: Array, ys: Array) -> tuple[int, int, int, int]:
    """The largest rectangle of marked cells: rows and columns, half open."""
    best, found = -1.0, (0, 0, 0, 0)
    rows, columns = inside.shape
    for row0 in range(rows):
        open_ = np.ones(columns, bool)
        for row1 in range(row0, rows):
            open_ = open_ & inside[row1]
            if not open_.any():
                break
            edge = np.diff(np.concatenate([[0], open_.astype(np.int8), [0]]))
            starts, ends = np.nonzero(edge == 1)[0], np.nonzero(edge == -1)[0]
            spans = xs[ends] - xs[starts]
            k = int(spans.argmax())
            area = float(spans[k] * (ys[row1 + 1] - ys[row0]))
            if area > best + 1e-12:
                best, found = area, (row0, row1 + 1, int(starts[k]), int(ends[k]))
    return found


def corners(c: Collider) -> Array:
    """Points (n, 3) in the body's frame whose convex hull is the collider, round ones by 16 sides."""
    if c.kind == "hull":
        assert c.vertices is not None
        local = c.vertices
    elif c.kind == "box":
        local = _CORNERS * c.size
    else:
        ring = _RING * c.size[0]
        height = [0, 0, c.size[2] / 2 if c.kind == "cylinder" else c.size[0]]
        local = np.concatenate([ring + height, ring - height])
    return np.asarray(local + c.center if c.rotation is UNTURNED else local @ c.rotation.T + c.center)


def bounds(pieces: Sequence[Collider]) -> Array:
    """Least and greatest corner of each collider, (n, 2, 3), in the body's frame."""
    found = np.empty((len(pieces), 2, 3))
    level = np.array([c.kind == "box" and c.rotation is UNTURNED for c in pieces], bool)
    boxes = [c for c, plain in zip(pieces, level, strict=True) if plain]
    if boxes:
        center, half = np.array([c.center for c in boxes]), 0.5 * np.array([c.size for c in boxes])
        found[level, 0], found[level, 1] = center - half, center + half
    points = [corners(c) for c, plain in zip(pieces, level, strict=True) if not plain]
    if points:
        every, starts = np.concatenate(points), np.cumsum([0, *(len(p) for p in points[:-1])])
        found[~level, 0] = np.minimum.reduceat(every, starts)
        found[~level, 1] = np.maximum.reduceat(every, starts)
    return found
