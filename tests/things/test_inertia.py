"""Mass, centre and inertia of links as MuJoCo and trimesh work them out, and by hand."""

import mujoco
import numpy as np
import pytest
import trimesh

from apartgen.schemas.retrieve import Joint
from apartgen.stages.things.asset import Collider, Link
from apartgen.stages.things.body import counterbalanced, inertia


def box(center, size, turn=None) -> Collider:
    return Collider("box", np.array(center, float), np.array(size, float), np.eye(3) if turn is None else turn)


def link(*colliders: Collider, mass: float = 5.0, joint: Joint | None = None) -> Link:
    return Link("part", [], list(colliders), mass, joint)


def turned(rng: np.random.Generator) -> np.ndarray:
    return trimesh.transformations.random_rotation_matrix(rng.random(3))[:3, :3]


def in_mujoco(some: Link) -> tuple[np.ndarray, np.ndarray]:
    """Centre and inertia about it along the frame's axes, by MuJoCo, of geoms of even density."""
    spec = mujoco.MjSpec()
    body = spec.worldbody.add_body(name="part")
    body.add_freejoint()
    kinds = {"box": (mujoco.mjtGeom.mjGEOM_BOX, (0.5, 0.5, 0.5)), "sphere": (mujoco.mjtGeom.mjGEOM_SPHERE, (1, 1, 1)),
             "cylinder": (mujoco.mjtGeom.mjGEOM_CYLINDER, (1, 0.5, 0))}
    for c in some.colliders:
        kind, share = kinds[c.kind]
        size = np.array([c.size[0], c.size[2], 0]) if c.kind == "cylinder" else c.size
        quat = np.zeros(4)
        mujoco.mju_mat2Quat(quat, c.rotation.ravel())
        body.add_geom(type=kind, size=size * share, pos=c.center, quat=quat, density=1000.0)
    model = spec.compile()
    mujoco.mj_setTotalmass(model, some.mass)
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, model.body_iquat[1])
    axes = turn.reshape(3, 3)
    return model.body_ipos[1], axes @ np.diag(model.body_inertia[1]) @ axes.T


def test_two_boxes_by_hand() -> None:
    # 1 kg each, 2 m apart: about the middle, m·d² is added for each across the line between them, nothing along it.
    found = inertia(link(box([1, 0, 0], [0.6, 0.6, 0.6]), box([-1, 0, 0], [0.6, 0.6, 0.6]), mass=2.0))
    own = 2 * (0.36 + 0.36) / 12
    assert found.mass == 2.0 and found.center == pytest.approx([0, 0, 0])
    assert found.tensor == pytest.approx(np.diag([own, own + 2, own + 2]), abs=1e-4)
    # Off the axes, the product of inertia is minus Σ m·x·y.
    skew = inertia(link(box([1, 1, 0], [0.6, 0.6, 0.6]), box([-1, -1, 0], [0.6, 0.6, 0.6]), mass=2.0))
    assert skew.tensor[0, 1] == pytest.approx(-2.0) and skew.tensor[2, 2] == pytest.approx(own + 4, abs=1e-4)
    # The heavier is the larger: 8 to 1 by volume.
    uneven = inertia(link(box([0, 0, 0], [2, 2, 2]), box([9, 0, 0], [1, 1, 1]), mass=9.0))
    assert uneven.center == pytest.approx([1, 0, 0])


@pytest.mark.parametrize("seed", range(6))
def test_mujoco_agrees(seed: int) -> None:
    rng = np.random.default_rng(seed)
    colliders = []
    for kind in rng.choice(["box", "cylinder", "sphere"], 1 + seed):
        x, y, z = rng.uniform(0.05, 0.6, 3)
        size = {"box": [x, y, z], "cylinder": [x, x, z], "sphere": [x, x, x]}[str(kind)]
        colliders.append(Collider(str(kind), rng.uniform(-1, 1, 3), np.array(size), turned(rng)))
    some = link(*colliders, mass=7.0)
    center, tensor = in_mujoco(some)
    found = inertia(some)
    assert found.center == pytest.approx(center, abs=1e-6)
    assert found.tensor == pytest.approx(tensor, abs=2e-4)


@pytest.mark.parametrize("seed", range(3))
def test_trimesh_agrees_on_hulls_apart(seed: int) -> None:
    rng = np.random.default_rng(seed)
    colliders, solids = [], []
    for _ in range(3):
        points, center, turn = rng.normal(size=(12, 3)) * [0.3, 0.5, 0.2], rng.uniform(-2, 2, 3), turned(rng)
        colliders.append(Collider("hull", center, np.ones(3), turn, points))
        solids.append(trimesh.convex.convex_hull(points @ turn.T + center))
    whole = trimesh.util.concatenate(solids)
    whole.density = 4.0 / whole.volume
    found = inertia(link(*colliders, mass=4.0))
    assert found.center == pytest.approx(whole.center_mass, abs=1e-6)
    assert found.tensor == pytest.approx(whole.moment_inertia, abs=1e-3)


def test_every_inertia_is_one_that_engines_take() -> None:
    sheet = inertia(link(box([0, 0, 0], [1e-6, 1e-6, 1]), mass=0.0))
    moments = np.linalg.eigvalsh(sheet.tensor)
    assert sheet.mass == 0.01 and moments[0] > 0 and moments[:2].sum() >= moments[2]


def flap(axis, where, lo=0.0, hi=np.pi / 2, kind="hinge") -> Link:
    """A part of a cabinet that looks along +x, its middle at `where` from its joint."""
    joint = Joint(name="flap", type=kind, axis=axis, origin=(0.0, 0.0, 0.0), range=(lo, hi), part="flap")
    return link(box(where, [0.02, 0.4, 0.4]), joint=joint)


def test_a_spring_carries_what_would_fall_open() -> None:
    # About +y, +z turns to +x: a flap hinged below falls outwards, one hinged above hangs shut, a door minds nothing.
    assert counterbalanced(flap((0, 1, 0), (0.01, 0, 0.2)))
    assert not counterbalanced(flap((0, -1, 0), (0.0, 0, -0.2)))
    assert not counterbalanced(flap((0, 0, 1), (0.01, 0.2, 0)))
    # A lid that leans back over its hinge falls once it is past the upright.
    assert counterbalanced(flap((0, 1, 0), (-0.1, 0, 0.2)))
    assert counterbalanced(flap((0, 0, -1), (0.2, 0, 0), 0, 0.3, "slide"))
    assert not counterbalanced(flap((1, 0, 0), (0.2, 0, 0), 0, 0.3, "slide"))
    assert not counterbalanced(link(box([0, 0, 0], [1, 1, 1])))
