"""What is reckoned for many at once is what each by itself gives: bounds, rectangles, heights, normals."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from apartgen.stages.things import rectangles, solids
from apartgen.stages.things.asset import Asset, Collider, Link, Material, Mesh
from apartgen.stages.things.shading import CREASE, corner_normals
from apartgen.stages.things.tops import heights

TURN = np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])
OAK = Material("oak")


def pieces(rng):
    for kind, rotation in product(("box", "cylinder", "sphere", "hull"), (None, TURN)):
        points = rng.normal(size=(7, 3)) if kind == "hull" else None
        turned = {} if rotation is None else {"rotation": rotation}
        yield Collider(kind, rng.normal(size=3), rng.uniform(0.1, 1, 3), vertices=points, **turned)


def test_bounds_of_colliders_are_those_of_their_corners():
    many = [c for seed in range(20) for c in pieces(np.random.default_rng(seed))]
    for (lo, hi), piece in zip(solids.bounds(many), many, strict=True):
        points = solids.corners(piece)
        assert np.array_equal(lo, points.min(0)) and np.array_equal(hi, points.max(0))
    assert solids.bounds([]).shape == (0, 2, 3)


@given(arrays(bool, st.tuples(st.integers(1, 5), st.integers(1, 6))), st.integers(0, 99))
def test_no_rectangle_of_free_cells_is_larger_than_the_largest(free, seed):
    rng = np.random.default_rng(seed)
    xs, ys = (np.cumsum(rng.uniform(0.1, 1, n + 1)) for n in free.shape)
    spans = [(a, b, c, d) for a, b in product(range(len(xs)), repeat=2) for c, d in product(range(len(ys)), repeat=2)
             if a < b and c < d and free[a:b, c:d].all()]
    if not spans:
        return
    a, b, c, d = rectangles.largest(free, xs, ys)
    assert free[a:b, c:d].all()
    assert (xs[b] - xs[a]) * (ys[d] - ys[c]) == pytest.approx(
        max((xs[b] - xs[a]) * (ys[d] - ys[c]) for a, b, c, d in spans))


def test_heights_are_those_of_the_highest_triangle_over_each_point():
    rng = np.random.default_rng(3)
    vertices, faces = rng.uniform(-1, 1, (60, 3)), rng.integers(0, 60, (80, 3))
    asset = Asset("own", "heap", "box", "", (2, 2, 2), [Link("base", [Mesh(vertices, faces, OAK)], [], 1.0)])
    points = rng.uniform(-1.2, 1.2, (200, 2))
    assert heights(asset, points) == pytest.approx([highest(vertices[faces], at) for at in points])


def highest(triangles, at):
    found = -np.inf
    for a, b, c in triangles:
        sides = np.column_stack([(b - a)[:2], (c - a)[:2]])
        if abs(np.linalg.det(sides)) > 1e-9:
            s, t = np.linalg.solve(sides, at - a[:2])
            if s >= 0 and t >= 0 and s + t <= 1:
                found = max(found, a[2] + s * (b - a)[2] + t * (c - a)[2])
    return found


def test_corners_are_shaded_by_the_faces_that_meet_there_smoothly():
    ball = solids.cylinder((0, 0, 0), (0, 0, 1), 0.5, OAK, 12)
    area = np.cross(*(ball.vertices[ball.faces[:, k]] - ball.vertices[ball.faces[:, 0]] for k in (1, 2)))
    flat = area / np.linalg.norm(area, axis=1, keepdims=True)
    for corner, normal in enumerate(corner_normals(ball)):
        at, own = ball.vertices[ball.faces.ravel()[corner]], corner // 3
        about = [f for f, face in enumerate(ball.faces) if (np.abs(ball.vertices[face] - at).max(1) < 1e-5).any()]
        mean = sum(area[f] for f in about if flat[f] @ flat[own] > CREASE)
        assert normal == pytest.approx(mean / np.linalg.norm(mean))
