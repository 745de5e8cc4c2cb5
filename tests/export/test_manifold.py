"""Meshes parted where they only touch, told by trimesh and counted by hand."""

import numpy as np
import pytest
import trimesh

from apartgen.stages.export._manifold import manifold


def of(groups: list[np.ndarray]) -> list[int]:
    """How many triangles each group has."""
    return sorted(len(group) for group in groups)


def test_a_closed_solid_stays_whole() -> None:
    faces = np.asarray(trimesh.creation.icosphere(subdivisions=1).faces)
    (one,) = manifold(faces)
    assert one.tolist() == faces.tolist()


@pytest.mark.parametrize("shared", [1, 2])
def test_two_that_meet_in_a_vertex_or_along_an_edge_are_told_apart(shared: int) -> None:
    """Two tetrahedra; along an edge, four triangles meet, of which no two are neighbours for sure."""
    one = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    other = np.where(one < shared, one, one + 4 - shared)
    groups = manifold(np.concatenate([one, other]))
    every = sorted(map(tuple, np.concatenate(groups).tolist()))
    assert every == sorted(map(tuple, [*one.tolist(), *other.tolist()])), "no triangle is lost or doubled"
    if shared == 1:
        assert of(groups) == [4, 4]
    for group in groups:  # in no group are there two fans of triangles about a vertex
        for vertex in np.unique(group):
            about = group[(group == vertex).any(1)]
            edges = [sorted(set(face) - {vertex}) for face in about.tolist()]
            assert len(trimesh.graph.connected_components(np.array(edges), min_len=1)) == 1
