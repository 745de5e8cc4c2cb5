"""What is seen and what is felt in an exported flat agree to 5 mm, both ways, read from the compiled MJCF."""

import mujoco
import numpy as np
import trimesh
from scipy.spatial import ConvexHull

CLOSE = 0.005 + 5e-4
"""Half a millimetre is for round things, whose meshes have sides."""
SOFT = {"plant", "planter"}
"""Leaves bend, so that an eighth of what is seen of them may be without a collider."""


class Felt:
    """Convex pieces as half-spaces and as meshes, in the world."""

    def __init__(self, model, data, geoms):
        self.pieces, meshes = [], []
        for geom in geoms:
            solid = _solid(model, geom)
            solid.apply_transform(_pose(data, geom))
            planes = ConvexHull(solid.vertices).equations
            self.pieces.append((planes[:, :3], planes[:, 3], solid.bounds))
            meshes.append(solid)
        self.mesh = trimesh.util.concatenate(meshes)

    def outside(self, points):
        """How far points are outside of every piece, m; 1 is far."""
        found = np.ones(len(points))
        for normals, offsets, (lo, hi) in self.pieces:
            near = np.flatnonzero(((points > lo - 0.1) & (points < hi + 0.1)).all(1))
            if len(near):
                found[near] = np.minimum(found[near], (points[near] @ normals.T + offsets).max(1))
        return found


def _pose(data, geom):
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
    return found


def _mesh(model, geom):
    mesh = model.mesh(model.geom_dataid[geom])
    first, face = mesh.vertadr[0], mesh.faceadr[0]
    vertices = model.mesh_vert[first : first + mesh.vertnum[0]]
    return trimesh.Trimesh(vertices, model.mesh_face[face : face + mesh.facenum[0]], process=False)


def _solid(model, geom):
    kind, size = mujoco.mjtGeom(model.geom_type[geom]), model.geom_size[geom]
    if kind == mujoco.mjtGeom.mjGEOM_BOX:
        return trimesh.creation.box(2 * size)
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        return trimesh.creation.cylinder(size[0], 2 * size[1], sections=48)
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return trimesh.creation.icosphere(3, size[0])
    return trimesh.convex.convex_hull(_mesh(model, geom).vertices)


def _seen(model, data, geoms):
    parts = [_mesh(model, geom).apply_transform(_pose(data, geom)) for geom in geoms]
    return trimesh.util.concatenate(parts)


def _deviations(seen, felt, n):
    """Of points seen from what is felt, and of bare points felt from what is seen, m."""
    points = trimesh.sample.sample_surface(seen, n, seed=0)[0]
    touch, face = trimesh.sample.sample_surface(felt.mesh, n, seed=0)
    bare = felt.outside(touch + 1e-3 * felt.mesh.face_normals[face]) > 2e-4
    away = trimesh.proximity.closest_point(seen, touch[bare])[1] if bare.any() else np.zeros(1)
    return felt.outside(points).clip(0), away


def faults(scene, folder):
    """Links of furniture and doors, and the building as one, whose surfaces are further apart than is allowed."""
    model = mujoco.MjModel.from_xml_path(str(folder / "mjcf" / "apartment.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    shown, solid = model.geom_contype == 0, model.geom_contype != 0
    found, building, done = [], [], set()
    for body in scene.bodies:
        for link in body.links:
            own = model.geom_bodyid == model.body(body.link_name(link)).id
            if body.kind != "object" and link.joint is None:
                building.append(own)
            elif link.colliders and (body.model, link.name) not in done:
                done.add((body.model or body.name, link.name))
                felt = Felt(model, data, np.flatnonzero(own & solid))
                seen, away = _deviations(_seen(model, data, np.flatnonzero(own & shown)), felt, 400)
                share = 0.125 if body.category in SOFT else 0.02
                cloth = body.category == "curtain"  # it gives way
                if (np.mean(seen > CLOSE) > share and not cloth) or np.mean(away > CLOSE) > share:
                    found.append((body.link_name(link), round(float(seen.max()), 4), round(float(away.max()), 4)))
    felt = Felt(model, data, np.flatnonzero(np.any(building, axis=0) & solid))
    for own in building:
        if (own & shown).any():
            part = _seen(model, data, np.flatnonzero(own & shown))
            beyond = felt.outside(trimesh.sample.sample_surface(part, 300, seed=0)[0]).max()
            if beyond > CLOSE:
                found.append((model.body(model.geom_bodyid[np.flatnonzero(own)[0]]).name, round(float(beyond), 4)))
    return found + _bare(model, data, np.any(building, axis=0), felt)


def _bare(model, data, building, felt):
    """Where the building can be felt and nothing is seen; below the floor slab there is nobody to feel it."""
    seen = _seen(model, data, np.flatnonzero(building & (model.geom_contype == 0)))
    touch, face = trimesh.sample.sample_surface(felt.mesh, 4000, seed=0)
    bare = (felt.outside(touch + 1e-3 * felt.mesh.face_normals[face]) > 2e-4) & (touch[:, 2] > 1e-3)
    away = trimesh.proximity.closest_point(seen, touch[bare])[1]
    bad = np.flatnonzero(away > CLOSE)
    return [("building", touch[bare][k].round(2).tolist(), round(float(away[k]), 4)) for k in bad]


def test_what_is_seen_is_felt_and_the_other_way_round(sample):
    assert not faults(sample.scene, sample.folder)
