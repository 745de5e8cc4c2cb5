"""The USD stage reopened: validators find nothing, and bodies, joints, masses are those of the artifact."""

import numpy as np
import pytest
from export import sample

from apartgen.stages import export
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things.body import inertia

pytest.importorskip("pxr")
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdValidation  # noqa: E402


@pytest.fixture(scope="module")
def made(exported):
    out = exported("usd")
    return Usd.Stage.Open(str(out / "usd" / "apartment.usd")), Scene(sample.home(), sample.load)


def _faults(stage):
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) >= 25
    return [error.GetMessage() for error in UsdValidation.ValidationContext(validators).Validate(stage)]


def _at(stage, path):
    matrix = UsdGeom.Xformable(stage.GetPrimAtPath(path)).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    return np.array(matrix).T


def _path(body, link=None):
    group = {"ceiling": "Ceilings", "object": "Furniture"}.get(body.kind, "Shell")
    path = f"/Apartment/{group}/{body.name}"
    return path if link is None or len(body.links) == 1 else f"{path}/{link.name}"


def test_parts_say_where_to_take_hold_of_them(made):
    stage, scene = made
    held = [(body, link) for body in scene.bodies for link in body.links if link.handle is not None]
    assert {body.kind for body, _ in held} >= {"door"}
    for body, link in held:
        about = stage.GetPrimAtPath(_path(body, link)).GetCustomDataByKey("apartgen")
        assert list(about["handle"]) == pytest.approx(link.handle) and about.get("grip", "") == link.grip


def test_all_validators_are_clean(made):
    assert _faults(made[0]) == []


def test_the_validators_see_a_fault(made):
    stage = Usd.Stage.Open(made[0].Flatten())
    joint = UsdPhysics.Joint(stage.GetPrimAtPath("/Apartment/Furniture/bin_12/Joints/lid"))
    joint.GetBody1Rel().SetTargets(["/Apartment/Furniture/bin_12/nowhere"])
    assert any("non existent" in fault for fault in _faults(stage))


def test_units(made):
    stage = made[0]
    assert UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z and UsdGeom.GetStageMetersPerUnit(stage) == 1
    assert UsdPhysics.GetStageKilogramsPerUnit(stage) == 1 and stage.GetDefaultPrim().GetName() == "Apartment"


def test_bodies_stand_where_the_artifact_says(made):
    stage, scene = made
    for body in scene.bodies:
        for link in body.links:
            assert _at(stage, _path(body, link)) == pytest.approx(body.pose(), abs=1e-6)
        prim = stage.GetPrimAtPath(_path(body))
        assert list(UsdSemantics.LabelsAPI(prim, "class").GetLabelsAttr().Get()) == [body.category]
        facts = {"id": body.id, "category": body.category, "room": body.room, "asset": body.model, "kind": body.kind}
        assert prim.GetCustomDataByKey("apartgen") == {key: text for key, text in facts.items() if text}


def test_joints_have_limits_axes_and_drives(made):
    stage, scene = made
    kinds = UsdPhysics.RevoluteJoint, UsdPhysics.PrismaticJoint
    found = [prim for prim in stage.Traverse() if any(prim.IsA(kind) for kind in kinds)]
    jointed = [(body, link) for body in scene.bodies for link in body.links if link.joint]
    assert len(found) == len(jointed) == 11
    for body, link in jointed:
        joint, prim = link.joint, stage.GetPrimAtPath(f"{_path(body)}/Joints/{link.joint.name}")
        scale = np.pi / 180 if joint.type == "hinge" else 1.0
        limits = [prim.GetAttribute(f"physics:{end}Limit").Get() * scale for end in ("lower", "upper")]
        assert limits == pytest.approx(joint.range, abs=1e-4) and limits[0] < limits[1]
        made_ = UsdPhysics.Joint(prim)
        for rotation, position in ((made_.GetLocalRot0Attr(), made_.GetLocalPos0Attr()),
                                   (made_.GetLocalRot1Attr(), made_.GetLocalPos1Attr())):
            axis = Gf.Rotation(Gf.Quatd(rotation.Get())).TransformDir(Gf.Vec3d(1, 0, 0))
            assert np.array(axis) == pytest.approx(joint.axis, abs=1e-5)
            assert np.array(position.Get()) == pytest.approx(joint.origin, abs=1e-5)
        assert made_.GetBody0Rel().GetTargets() == [_path(body, body.links[0])]
        assert made_.GetBody1Rel().GetTargets() == [_path(body, link)]
        kind = "angular" if joint.type == "hinge" else "linear"
        assert UsdPhysics.DriveAPI(prim, kind).GetDampingAttr().Get() > 0


def test_masses_and_no_nested_bodies(made):
    stage, scene = made
    rigid = {str(p.GetPath()) for p in stage.Traverse() if p.HasAPI(UsdPhysics.RigidBodyAPI)}
    assert not any(a != b and a.startswith(f"{b}/") for a in rigid for b in rigid)
    moving = [(b, link) for b in scene.bodies for link in b.links if b.free or len(b.links) > 1]
    assert rigid == {_path(body, link) for body, link in moving}
    for body, link in moving:
        mass = UsdPhysics.MassAPI(stage.GetPrimAtPath(_path(body, link)))
        assert mass.GetMassAttr().Get() == pytest.approx(inertia(link).mass, rel=1e-6)
        axes = np.array(Gf.Matrix3d(Gf.Rotation(Gf.Quatd(mass.GetPrincipalAxesAttr().Get())))).T
        tensor = axes @ np.diag(mass.GetDiagonalInertiaAttr().Get()) @ axes.T
        assert tensor == pytest.approx(inertia(link).tensor, rel=1e-4, abs=1e-5)


def test_articulations_are_fixed_unless_loose(made):
    stage, scene = made
    for body in scene.bodies:
        prim = stage.GetPrimAtPath(_path(body))
        assert prim.HasAPI(UsdPhysics.ArticulationRootAPI) == (len(body.links) > 1)
        fixed = stage.GetPrimAtPath(f"{_path(body)}/Joints/to_world")
        assert fixed.IsValid() == (len(body.links) > 1 and not body.free)


@pytest.mark.filterwarnings("ignore:LoadUsdPhysicsFromRange:DeprecationWarning")  # the name in all versions so far
def test_usd_s_own_reader_of_physics_takes_fixed_bases_as_held_by_the_world(made):
    """A joint to what is no rigid body is one to the world; its articulation has the base as root."""
    stage, scene = made
    read = UsdPhysics.LoadUsdPhysicsFromRange(stage, ["/"])
    held = {str(path): joint for path, joint in zip(*read[UsdPhysics.ObjectType.FixedJoint])}
    bodies = [body for body in scene.bodies if len(body.links) > 1 and not body.free]
    assert set(held) == {f"{_path(body)}/Joints/to_world" for body in bodies}
    for body in bodies:
        joint = held[f"{_path(body)}/Joints/to_world"]
        assert not joint.body0 and joint.body1 == _path(body, body.links[0]) and joint.isValid
    rooted = {str(path) for path, found in zip(*read[UsdPhysics.ObjectType.Articulation]) if found.isValid}
    assert rooted == {_path(body) for body in scene.bodies if len(body.links) > 1}


OFFSETS = {"env_0": 0.0, "env_1": 20.0}


def _twice(folder):
    """A stage that refers to the apartment where it is, and again elsewhere and turned."""
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    for name, offset in OFFSETS.items():
        env = UsdGeom.Xform.Define(stage, f"/World/{name}")
        env.AddTranslateOp().Set(Gf.Vec3d(offset, 0, 0))
        env.AddRotateZOp().Set(3 * offset)
        env.GetPrim().GetReferences().AddReference(str(folder / "usd" / "apartment.usd"))
    return stage


def _frame(cache, joint, side):
    """A joint's frame in the world, (4, 4), seen from one of its bodies; from the world where it names none."""
    turn, at, rel = (getattr(joint, f"Get{what}{side}{kind}")() for what, kind in
                     (("LocalRot", "Attr"), ("LocalPos", "Attr"), ("Body", "Rel")))
    local = Gf.Matrix4d(Gf.Rotation(Gf.Quatd(turn.Get())), Gf.Vec3d(at.Get()))
    stage, targets = joint.GetPrim().GetStage(), rel.GetTargets()
    return np.array(local * cache.GetLocalToWorldTransform(stage.GetPrimAtPath(targets[0])) if targets else local)


def test_a_stage_referenced_elsewhere_keeps_together(exported):
    stage = _twice(exported("usd"))
    cache = UsdGeom.XformCache()
    joints = [UsdPhysics.Joint(prim) for prim in stage.Traverse() if prim.IsA(UsdPhysics.Joint)]
    assert sum(str(joint.GetPath()).startswith("/World/env_1/") for joint in joints) == len(joints) / 2 > 10
    for joint in joints:
        assert _frame(cache, joint, 0) == pytest.approx(_frame(cache, joint, 1), abs=1e-5), joint.GetPath()


def test_newton_puts_a_stage_referenced_elsewhere_there(exported):
    warp = pytest.importorskip("warp")
    newton = pytest.importorskip("newton")
    pytest.importorskip("newton_usd_schemas")
    warp.config.quiet = True
    builder, stage = newton.ModelBuilder(), _twice(exported("usd"))
    builder.add_usd(stage)
    model = builder.finalize(device="cpu")
    state = model.state()
    newton.eval_fk(model, model.joint_q, model.joint_qd, state)
    placed = dict(zip(builder.body_label, state.body_q.numpy()[:, :3]))
    assert sum(name.startswith("/World/env_1/") for name in placed) == len(placed) / 2 > 10
    for name, found in placed.items():
        assert found == pytest.approx(_at(stage, name)[:3, 3], abs=1e-4), name


def test_what_stands_in_something_is_filtered_where_engines_look(tmp_path):
    """Pairs are on rigid bodies and colliders, the only places that the schema has for them besides articulations."""
    home = sample.home()
    placed = {o.id: o for o in home.objects}
    for chair, at in (("chair_7", "coffee_table_3"), ("bin_12", "display_cabinet_11")):
        x, y, _ = placed[at].center
        placed[chair].center = (x + placed[at].size[0] / 2, y, placed[chair].center[2])
    export.run(home, ["usd"], tmp_path / "x", sample.load)
    stage = Usd.Stage.Open(str(tmp_path / "x" / "usd" / "apartment.usd"))
    assert _faults(stage) == []
    filtered = {}
    for prim in stage.Traverse():
        if prim.HasAPI(UsdPhysics.FilteredPairsAPI):
            targets = UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel().GetTargets()
            for felt in (prim, *map(stage.GetPrimAtPath, targets)):
                assert felt.HasAPI(UsdPhysics.RigidBodyAPI) or felt.HasAPI(UsdPhysics.CollisionAPI), felt
            filtered[str(prim.GetPath())] = {str(target) for target in targets}
    wedged = [body for body in Scene(home, sample.load).bodies if body.within]
    assert {body.id for body in wedged} == {"chair_7", "bin_12"}  # one that never moves, and one with a lid
    chair, table = (f"/Apartment/Furniture/{name}/Colliders/collider_0" for name in ("chair_7", "coffee_table_3"))
    assert filtered[chair] == {table}
    cabinet = {"/Apartment/Furniture/display_cabinet_11/base", "/Apartment/Furniture/display_cabinet_11/door"}
    for link in ("base", "lid"):
        assert cabinet <= filtered[f"/Apartment/Furniture/bin_12/{link}"]


def test_colliders_are_where_they_belong(made):
    stage, scene = made
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), [UsdGeom.Tokens.guide])
    count = 0
    for body in scene.bodies:
        for link in body.links:
            for k, collider in enumerate(link.colliders):
                prim = stage.GetPrimAtPath(f"{_path(body, link)}/Colliders/collider_{k}")
                assert prim.HasAPI(UsdPhysics.CollisionAPI)
                box = cache.ComputeRelativeBound(prim, stage.GetPrimAtPath(_path(body, link))).ComputeAlignedRange()
                lo, hi = collider.center - collider.size / 2, collider.center + collider.size / 2
                if collider.kind == "hull":
                    lo, hi = (f(collider.center + collider.vertices, axis=0) for f in (np.min, np.max))
                assert np.array([box.GetMin(), box.GetMax()]) == pytest.approx(np.array([lo, hi]), abs=1e-5)
                count += 1
    assert count == sum(p.HasAPI(UsdPhysics.CollisionAPI) for p in stage.Traverse())
