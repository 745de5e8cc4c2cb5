"""Shading of meshes: what is the same is known again, and sorted as it always was."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from apartgen.stages.scene.pieces import joined, shaded
from apartgen.stages.things.asset import Material, Mesh
from apartgen.stages.things.shading import corner_normals, distinct


@given(st.tuples(st.integers(1, 40), st.integers(1, 4)).flatmap(
    lambda shape: arrays(float, shape, elements=st.sampled_from([-1.5, -0.0, 0.0, 1e-9, 2.0, 7.25]))))
def test_distinct_rows_are_in_order_and_every_row_finds_its_own(rows):
    found, which = distinct(rows)
    assert np.array_equal(found[which], rows)
    assert [tuple(row) for row in found] == sorted({tuple(row) for row in rows})


def test_a_mesh_is_shaded_by_its_own_bytes():
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    once, again = (shaded(Mesh(square.copy(), faces.copy(), Material(name))) for name in ("oak", "pine"))
    assert once is again, "whatever its material"
    moved = shaded(Mesh(square + [0, 0, 1e-4], faces, Material("oak")))
    assert moved[0][:, 2].tolist() == [1e-4] * 4
    assert np.array_equal(moved[1], [[0, 0, 1]] * 4), "its normals are up"
    assert sorted(moved[3].ravel().tolist()) == [0, 0, 1, 2, 3, 3], "the diagonal has both ends twice"
    turned = shaded(Mesh(square, faces[:, ::-1].copy(), Material("oak")))
    assert np.array_equal(turned[1], [[0, 0, -1]] * 4), "other faces are another mesh"


def test_corners_of_faces_without_an_area_have_normals_too():
    """Two faces of the floor, and one whose corners lie on a line: of it there is no normal, but a number."""
    vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [3, 0, 0], [4, 0, 0], [5, 0, 0]], float)
    found = corner_normals(Mesh(vertices, np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6]]), Material("plain")))
    assert np.isfinite(found).all() and (found[:6] == [0, 0, 1]).all()


def test_joined_meshes_have_uv_only_where_all_have_it_and_a_texture_is_there():
    points, faces = np.eye(3), np.array([[0, 1, 2]])
    uv = np.zeros((3, 2))
    oak, plain = Material("oak", texture="wood"), Material("oak")
    both = joined([Mesh(points, faces, oak, uv), Mesh(points + 1, faces, oak, uv + 1)])
    assert both.faces.tolist() == [[0, 1, 2], [3, 4, 5]] and both.uv is not None and both.uv.shape == (6, 2)
    assert joined([Mesh(points, faces, oak, uv), Mesh(points, faces, oak)]).uv is None
    assert joined([Mesh(points, faces, plain, uv), Mesh(points, faces, plain, uv)]).uv is None
    assert joined([Mesh(points, faces, plain, uv)]).uv is None
