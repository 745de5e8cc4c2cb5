"""Collision pieces and what is seen of an asset agree to 5 mm, both ways."""

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.furniture import body
from apartgen.stages.things import categories

CLOSE = 0.0055


def halfspaces(c):
    """Outward normals (k, 3) and offsets (k,) of a convex piece: inside where n·p + d <= 0."""
    if c.kind == "hull":
        planes = ConvexHull(c.vertices @ c.rotation.T + c.center).equations
        return planes[:, :3], planes[:, 3]
    if c.kind == "box":
        local, far = np.vstack([np.eye(3), -np.eye(3)]), np.concatenate([c.size, c.size]) / 2
    else:
        t = np.linspace(0, 2 * np.pi, 48, endpoint=False)
        local = np.vstack([np.column_stack([np.cos(t), np.sin(t), 0 * t]), [[0, 0, 1], [0, 0, -1]]])
        far = np.concatenate([np.full(48, c.size[0]), [c.size[2] / 2] * 2])
    normals = local @ c.rotation.T
    return normals, -(far + normals @ c.center)


def outside(points, pieces):
    """How far points are outside of all pieces, m; at least that by the nearest half-space."""
    return np.min([(points @ n.T + d).max(1) for n, d in pieces], axis=0)


def solid(c):
    if c.kind == "box":
        shape = trimesh.creation.box(c.size)
    elif c.kind == "cylinder":
        shape = trimesh.creation.cylinder(c.size[0], c.size[2], sections=24)
    else:
        shape = trimesh.convex.convex_hull(c.vertices)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = c.rotation, c.center
    return shape.apply_transform(pose)


def deviations(link):
    """Distances of seen points to the collision pieces, and of collision surfaces to what is seen."""
    seen = trimesh.util.concatenate([trimesh.Trimesh(m.vertices, m.faces) for m in link.visuals])
    pieces = [halfspaces(c) for c in link.colliders]
    points = trimesh.sample.sample_surface(seen, 400, seed=0)[0]
    felt = trimesh.util.concatenate([solid(c) for c in link.colliders])
    touch, face = trimesh.sample.sample_surface(felt, 120, seed=0)
    bare = outside(touch + 1e-3 * felt.face_normals[face], pieces) > 2e-4
    away = trimesh.proximity.closest_point(seen, touch[bare])[1] if bare.any() else np.zeros(1)
    return np.maximum(outside(points, pieces), 0), away


@pytest.mark.parametrize("category", categories.TABLE)
def test_what_is_seen_is_felt_and_the_other_way_round(category):
    like = categories.TABLE[category].lineage[-1]
    for style in furniture.styles(category)[:: 1 if like in ("bath", "toilet", "vanity", "bin") else 3]:
        asset = furniture.build(category, style, categories.TABLE[category].size, 1)
        found = [deviations(link) for link in asset.links]
        seen, felt = (np.concatenate(part) for part in zip(*found, strict=True))
        # Leaves bend and a curtain's cloth gives way; everything else is rigid stuff that a robot may touch.
        # What is felt of a row of books is up to 2 mm further out than CLOSE where one is thinner.
        share = {"plant": 0.12, "planter": 0.12, "bookshelf": 0.03}.get(like, 0.01)
        assert like == "curtain" or np.mean(seen > CLOSE) <= share, (asset.id, seen.max())
        assert np.mean(felt > CLOSE) <= share, (asset.id, felt.max())


@pytest.mark.parametrize("style", furniture.styles("mirror"))
@pytest.mark.parametrize("size", [(0.08, 0.886, 0.558), (0.04, 1.4, 0.45), (0.02, 0.35, 1.8)])
def test_mirrors_of_every_proportion_are_felt_where_they_are_seen(style, size):
    seen, felt = deviations(furniture.build("mirror", style, size, 0).links[0])
    assert max(seen.max(), felt.max()) <= CLOSE


def test_a_turned_profile_is_told_in_its_fewest_straight_stretches():
    """Radius and height: a cylinder of five rings, then a cone of three; a rim that goes in at one height is none."""
    profile = [(0.1, 0.0), (0.1, 0.1), (0.1, 0.15), (0.1, 0.3), (0.1, 0.4), (0.15, 0.5), (0.2, 0.6), (0.05, 0.6)]
    found = [(tuple(low), tuple(high)) for low, high in body._frusta(np.array(profile))]
    assert found == [((0.1, 0.0), (0.1, 0.4)), ((0.1, 0.4), (0.2, 0.6))]
