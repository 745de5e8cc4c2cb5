"""Hulls as boxes, cylinders and spheres: as high and as large as they were, and nothing stands in anything for it."""

import numpy as np
import pytest
from export import sample
from export.conftest import EXAMPLE
from scipy.spatial import ConvexHull

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable
from apartgen.stages import export
from apartgen.stages.export._primitive import primitive, simple
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things.asset import Collider
from apartgen.stages.things.solids import corners

RINGS = np.linspace(0, 2 * np.pi, 48, endpoint=False)


def _hull(points, center=(0.3, -0.2, 0.5), turn=None):
    return Collider("hull", np.array(center), np.ptp(points, axis=0), np.eye(3) if turn is None else turn,
                    np.asarray(points, float))


def _block(x, y, z):
    return np.array([[a, b, c] for a in (-x, x) for b in (-y, y) for c in (-z, z)]) / 2


def _volume(c):
    return np.prod(c.size) * {"box": 1.0, "cylinder": np.pi, "sphere": 4 / 3 * np.pi}[c.kind]


def _heights(c):
    """Lowest and highest point."""
    if c.kind in ("box", "hull"):
        z = corners(c)[:, 2]
        return z.min(), z.max()
    up = abs(c.rotation[2, 2])
    reach = c.size[0] if c.kind == "sphere" else c.size[0] * np.sqrt(1 - min(up * up, 1)) + up * c.size[2] / 2
    return c.center[2] - reach, c.center[2] + reach


@pytest.mark.parametrize("yaw", [0.0, 0.4, 1.2])
def test_a_block_stays_what_it_is_however_it_is_turned(yaw):
    c, s = np.cos(yaw), np.sin(yaw)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    found = simple(_hull(_block(0.4, 0.2, 0.1) @ turn.T))
    assert found.kind == "box" and np.allclose(np.sort(found.size), [0.1, 0.2, 0.4])
    assert np.allclose(np.sort(corners(found), axis=0), np.sort(corners(_hull(_block(0.4, 0.2, 0.1) @ turn.T)), axis=0))


def test_what_is_round_becomes_a_cylinder_or_a_sphere():
    disc = np.array([[0.2 * np.cos(a), 0.2 * np.sin(a), z] for a in RINGS for z in (-0.01, 0.01)])
    found = simple(_hull(disc))
    assert found.kind == "cylinder" and np.allclose(found.size, [0.2, 0.2, 0.02], rtol=0.01)
    assert np.allclose(np.abs(found.rotation[2]), [0, 0, 1])
    lying = simple(_hull(disc[:, [2, 0, 1]]))
    assert lying.kind == "cylinder" and np.allclose(np.abs(lying.rotation[:, 2]), [1, 0, 0])
    ball = np.random.default_rng(0).normal(size=(300, 3))
    round_ = simple(_hull(0.1 * ball / np.linalg.norm(ball, axis=1, keepdims=True)))
    assert round_.kind == "sphere" and round_.size == pytest.approx([0.1] * 3, rel=0.05)


def test_any_hull_keeps_its_heights_and_about_its_volume():
    rng, shares = np.random.default_rng(4), []
    for _ in range(60):
        points = rng.normal(size=(12, 3)) * rng.uniform(0.02, 0.3, 3)
        c = _hull(points, rng.normal(size=3))
        found = simple(c)
        assert found.kind != "hull" and (found.size > 0).all()
        assert np.allclose(found.rotation @ found.rotation.T, np.eye(3)) and np.linalg.det(found.rotation) > 0
        assert _heights(found) == pytest.approx(_heights(c), abs=1e-9)
        shares.append(_volume(found) / ConvexHull(points).volume)
        bounds = corners(c)[:, :2]
        assert (found.center[:2] > bounds.min(0)).all() and (found.center[:2] < bounds.max(0)).all()
    assert 0.8 < np.median(shares) < 1.05 and 0.4 < min(shares) and max(shares) < 1.6


def test_a_flat_hull_has_a_thickness():
    found = simple(_hull(_block(0.4, 0.2, 0.0)))
    assert (found.size > 0).all()


def test_furniture_keeps_links_masses_and_what_is_no_hull(library):
    scene = Scene(artifact.read(EXAMPLE, Walkable).body, library, shown=False)
    after = primitive(scene.bodies)
    kinds = {c.kind for body in after for link in body.links for c in link.colliders}
    assert "hull" not in kinds and {"box", "cylinder"} <= kinds
    for a, b in zip(scene.bodies, after, strict=True):
        assert [link.mass for link in a.links] == [link.mass for link in b.links]
        for one, two in zip(a.links, b.links, strict=True):
            pairs = list(zip(one.colliders, two.colliders, strict=True))
            assert all(p is q for p, q in pairs if p.kind != "hull")
            assert all(_heights(q) == pytest.approx(_heights(p), abs=1e-6) for p, q in pairs if p.kind == "hull")


def test_a_simulator_meets_no_mesh_and_nothing_starts_in_anything(tmp_path, library):
    import mujoco

    home = artifact.read(EXAMPLE, Walkable).body
    export.run(home, ["mjcf"], tmp_path / "scene", library, colliders="primitive")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene" / "mjcf" / "apartment.xml"))
    felt = model.geom_contype != 0
    assert felt.sum() > 100 and not (model.geom_type[felt] == mujoco.mjtGeom.mjGEOM_MESH).any()
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    assert data.contact.dist.min(initial=0) > -1e-3
    before = data.xpos.copy()
    for _ in range(250):
        mujoco.mj_step(model, data)
    free = [model.jnt_bodyid[j] for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    assert len(free) > 5 and np.linalg.norm(data.xpos - before, axis=1)[free].max() < 0.01


def test_exact_colliders_are_what_is_written_unasked(tmp_path):
    for name, colliders in (("a", "exact"), ("b", "primitive")):
        export.run(sample.home(), ["urdf"], tmp_path / name, sample.load, colliders=colliders)
    export.run(sample.home(), ["urdf"], tmp_path / "c", sample.load)
    texts = [(tmp_path / name / "urdf" / "apartment.urdf").read_bytes() for name in "abc"]
    assert texts[0] == texts[2] != texts[1]
