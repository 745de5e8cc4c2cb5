"""What may touch by masks is what may touch by lists of pairs, but for what is out of reach."""

from itertools import combinations

import mujoco
import numpy as np
import pytest
from export import sample

from apartgen.stages import export
from apartgen.stages.export._masks import masks
from apartgen.stages.scene.scene import Scene


def _model(home, load, folder, colliders):
    export.run(home, ["mjcf"], folder, load, colliders=colliders)
    return mujoco.MjModel.from_xml_path(str(folder / "mjcf" / "apartment.xml"))


@pytest.fixture(scope="module", params=["sample", "lived in"])
def models(request, tmp_path_factory):
    """The same home with pairs and with masks."""
    from inhabited import library, lived_in

    home, load = (sample.home(), sample.load) if request.param == "sample" else (lived_in(0), library().load_asset)
    folder = tmp_path_factory.mktemp("masks")
    return [_model(home, load, folder / name, name) for name in ("exact", "primitive")], Scene(home, load)


def _touching(model):
    """Pairs of bodies of which MuJoCo lets some geoms touch, but for those that are told apart by their parent."""
    apart = {(int(s) >> 16, int(s) & 0xFFFF) for s in model.exclude_signature}
    solid = {}
    for k in np.flatnonzero(model.geom_contype | model.geom_conaffinity):
        own = solid.setdefault(int(model.geom_bodyid[k]), set())
        own.add((int(model.geom_contype[k]), int(model.geom_conaffinity[k])))
    found = set()
    for a, b in combinations(sorted(solid), 2):
        still = not (model.body_weldid[a] or model.body_weldid[b])
        hangs = any(model.body_parentid[p] == q and model.body_weldid[q] for p, q in ((a, b), (b, a)))
        if not still and not hangs and not {(a, b), (b, a)} & apart and any(
                p[0] & q[1] or q[0] & p[1] for p in solid[a] for q in solid[b]):
            found.add((model.body(a).name, model.body(b).name))
    return found


def test_masks_tell_apart_only_what_is_out_of_reach_or_hangs_on_one_another(models):
    (exact, masked), scene = models
    assert exact.nexclude and not masked.nexclude
    before, after = _touching(exact), _touching(masked)
    assert after <= before
    at = {body.link_name(link): body for body in scene.bodies for link in body.links}
    data = mujoco.MjData(exact)
    mujoco.mj_forward(exact, data)
    for a, b in before - after:
        reach = sum(_reach(exact, data, at[name].name) for name in (a, b))
        assert np.linalg.norm((at[a].position - at[b].position)[:2]) > reach, (a, b)


def _reach(model, data, name):
    """How far from its place anything of a body is, each of its parts turned or pushed as it may be, one at a time."""
    body = model.body(name)
    own = [b for b in range(model.nbody) if b == body.id or model.body_parentid[b] == body.id]
    joints = [model.body_jntadr[b] for b in own[1:] if model.body_jntnum[b]]
    far = 0.0
    for joint, value in [(None, 0.0), *((j, v) for j in joints for v in np.linspace(*model.jnt_range[j], 5))]:
        mujoco.mj_resetData(model, data)
        if joint is not None:
            data.qpos[model.jnt_qposadr[joint]] = value
        mujoco.mj_kinematics(model, data)
        geoms = np.flatnonzero(np.isin(model.geom_bodyid, own) & (model.geom_contype > 0))
        for g in geoms:
            lo, hi = model.geom_aabb[g, :3] - model.geom_aabb[g, 3:], model.geom_aabb[g, :3] + model.geom_aabb[g, 3:]
            corners = np.array([[x, y, z] for x in (lo[0], hi[0]) for y in (lo[1], hi[1]) for z in (lo[2], hi[2])])
            points = corners @ data.geom_xmat[g].reshape(3, 3).T + data.geom_xpos[g]
            far = max(far, float(np.linalg.norm((points - data.xpos[body.id])[:, :2], axis=1).max()))
    return far - 0.02  # boxes of turned geoms are a little larger than these


def test_a_usual_robot_touches_all(models):
    (_, masked), _ = models
    solid = (masked.geom_contype | masked.geom_conaffinity) > 0
    assert ((masked.geom_contype[solid] & 1) | (masked.geom_conaffinity[solid] & 1)).all()


def test_no_colour_is_left_where_too_many_stand_together():
    scene = Scene(sample.home(), sample.load)
    assert masks(scene.bodies)
    crowd = [body for body in scene.bodies if len(body.links) > 1 and not body.free][:1] * 40
    assert len({mask for mask in masks(_renamed(crowd)).values()}) <= 2 * 29


def _renamed(bodies):
    from dataclasses import replace

    return [replace(body, name=f"b{k}") for k, body in enumerate(bodies)]
