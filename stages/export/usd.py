"""OpenUSD with physics: rigid bodies, colliders, limited and damped joints, articulations, semantics, materials.

One crate file in metres, z up, with its textures beside it. What never moves has colliders and no rigid body; what
has joints is an articulation whose links lie side by side, its base fixed to the world unless it is loose.
"""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.stages.export._obj import Files
from apartgen.stages.export._readback import Refused
from apartgen.stages.export._rotation import about_z, from_x, quaternion
from apartgen.stages.scene.pieces import names, pieces
from apartgen.stages.scene.scene import Scene, identifier
from apartgen.stages.things.asset import Array, Link
from apartgen.stages.things.body import Body, Light, counterbalanced, inertia

try:
    from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdPhysics, UsdSemantics

    from apartgen.stages.export._usd_looks import Looks
    from apartgen.stages.export._usd_shapes import collider, extent, place, show, visuals
except ImportError as error:
    raise BadInput("format usd needs the package usd-core; pip install 'apartgen[usd]'") from error

FOLDER = "usd"
ROOT = "/Apartment"
GROUPS = {"ceiling": "Ceilings", "object": "Furniture"}
LAMP = 0.05
"""Radius of a light's sphere, m."""


def write(scene: Scene, out: Path) -> list[Path]:
    """usd/apartment.usd and usd/textures."""
    folder = out / FOLDER
    files = Files(folder / "textures")
    stage = Usd.Stage.CreateInMemory()
    _Writer(stage, scene, Looks(stage, f"{ROOT}/Looks", files)).all()
    path = folder / "apartment.usd"
    stage.GetRootLayer().Export(str(path))
    return [path, *files.written]


def read_back(files: list[Path]) -> None:
    """By OpenUSD."""
    stage = Usd.Stage.Open(str(files[0]))
    if errors := stage.GetCompositionErrors():
        raise Refused(str(errors[0]))
    if not stage.GetDefaultPrim() or not all(prim.IsDefined() for prim in stage.TraverseAll()):
        raise Refused(f"{files[0].name} has prims that are not defined")


class _Writer:
    """The stage as it is filled."""

    def __init__(self, stage: Any, scene: Scene, looks: Looks) -> None:
        self.stage, self.scene, self.looks = stage, scene, looks
        used = (m.material for body in scene.bodies for link in body.links for m in link.visuals)
        self.names = names(used)

    def all(self) -> None:
        UsdGeom.SetStageUpAxis(self.stage, UsdGeom.Tokens.z)
        UsdGeom.SetStageMetersPerUnit(self.stage, 1.0)
        UsdPhysics.SetStageKilogramsPerUnit(self.stage, 1.0)
        root = UsdGeom.Xform.Define(self.stage, ROOT)
        self.stage.SetDefaultPrim(root.GetPrim())
        Usd.ModelAPI(root).SetKind("assembly")
        root.GetPrim().SetAssetInfoByKey("credits", "; ".join(self.scene.credits))
        physics = UsdPhysics.Scene.Define(self.stage, f"{ROOT}/PhysicsScene")
        physics.CreateGravityDirectionAttr(Gf.Vec3f(0, 0, -1))
        physics.CreateGravityMagnitudeAttr(9.81)
        for group in ("Shell", "Ceilings", "Furniture", "Lights"):
            Usd.ModelAPI(UsdGeom.Xform.Define(self.stage, f"{ROOT}/{group}")).SetKind("group")
        for body in self.scene.bodies:
            self._body(body)
        for light in self.scene.lights:
            self._light(light)

    def _body(self, body: Body) -> None:
        path = _path(body)
        top = UsdGeom.Xform.Define(self.stage, path)
        place(top, body.position, about_z(body.yaw))
        prim = top.GetPrim()
        Usd.ModelAPI(prim).SetKind("component")
        UsdSemantics.LabelsAPI.Apply(prim, "class").CreateLabelsAttr([body.category])
        facts = {"id": body.id, "category": body.category, "room": body.room, "asset": body.model, "kind": body.kind}
        said = {k: " ".join(v) if isinstance(v, list) else v for k, v in body.says.items()}
        prim.SetCustomDataByKey("apartgen", {k: v for k, v in (facts | said).items() if v})
        if len(body.links) == 1:
            if body.free:
                _rigid(prim, body.links[0])
            self._link(path, body.links[0])
        else:
            self._articulation(path, body)
        if body.within:
            others = [felt for other in self.scene.bodies if other.name in body.within for felt in _felt(other)]
            for felt in _felt(body):
                pairs = UsdPhysics.FilteredPairsAPI.Apply(self.stage.GetPrimAtPath(felt))
                pairs.CreateFilteredPairsRel().SetTargets(others)

    def _articulation(self, path: str, body: Body) -> None:
        UsdPhysics.ArticulationRootAPI.Apply(self.stage.GetPrimAtPath(path))
        base = body.links[0]
        for link in body.links:
            own = _link_path(body, link)
            prim = UsdGeom.Xform.Define(self.stage, own).GetPrim()
            _rigid(prim, link)
            if link.handle is not None:
                grip = {"grip": link.grip} if link.grip else {}
                prim.SetCustomDataByKey("apartgen", {"handle": Gf.Vec3d(*map(float, link.handle)), **grip})
            self._link(own, link)
        UsdGeom.Scope.Define(self.stage, f"{path}/Joints")
        if not body.free:
            fixed = UsdPhysics.FixedJoint.Define(self.stage, f"{path}/Joints/to_world")
            # Held by its own place, not by a point of the world, so that it follows a stage referenced elsewhere.
            fixed.CreateBody0Rel().SetTargets([path])
            fixed.CreateBody1Rel().SetTargets([_link_path(body, base)])
            _frames(fixed, (np.zeros(3), about_z(0.0)), (np.zeros(3), about_z(0.0)))
        for link in body.links[1:]:
            self._joint(path, body, link)

    def _joint(self, path: str, body: Body, link: Link) -> None:
        joint = link.joint
        assert joint is not None
        hinge = joint.type == "hinge"
        kind = UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint
        made = kind.Define(self.stage, f"{path}/Joints/{identifier(joint.name)}")
        made.CreateBody0Rel().SetTargets([_link_path(body, body.links[0])])
        made.CreateBody1Rel().SetTargets([_link_path(body, link)])
        made.CreateAxisAttr("X")
        frame = np.array(joint.origin), from_x(np.array(joint.axis, float))
        _frames(made, frame, frame)
        made.CreateCollisionEnabledAttr(False)
        scale = 180 / np.pi if hinge else 1.0
        made.CreateLowerLimitAttr(joint.range[0] * scale)
        made.CreateUpperLimitAttr(joint.range[1] * scale)
        drive = UsdPhysics.DriveAPI.Apply(made.GetPrim(), "angular" if hinge else "linear")
        drive.CreateTypeAttr("force")
        drive.CreateStiffnessAttr(0.0)
        drive.CreateDampingAttr(body.motion(link).damping / scale)
        drive.CreateTargetVelocityAttr(0.0)
        own = body.motion(link)
        # Another PhysX extension; an engine that does not know it has the part damped only.
        made.GetPrim().AddAppliedSchema("PhysxJointAPI")
        made.GetPrim().CreateAttribute("physxJoint:jointFriction", Sdf.ValueTypeNames.Float).Set(own.friction)
        facts = {"part": joint.part, "friction": own.friction}
        held = {name: value for name, value in (("catch", own.catch), ("rest", own.rest)) if value}
        made.GetPrim().SetCustomDataByKey("apartgen", facts | held)

    def _link(self, path: str, link: Link) -> None:
        """Shapes that show, and under `Colliders` those that don't."""
        shown = [(piece.material, surface) for piece in pieces(link) for surface in visuals(piece)]
        for k, (material, surface) in enumerate(shown):
            made = show(self.stage, f"{path}/visual_{k}", surface)
            self.looks.bind(made.GetPrim(), material, identifier(self.names[material]))
        if link.colliders:
            group = UsdGeom.Scope.Define(self.stage, f"{path}/Colliders")
            group.CreatePurposeAttr(UsdGeom.Tokens.guide)
            self.looks.bind_friction(group.GetPrim(), link.friction)
        for k, solid in enumerate(link.colliders):
            shape = collider(self.stage, f"{path}/Colliders/collider_{k}", solid)
            UsdPhysics.CollisionAPI.Apply(shape.GetPrim())

    def _light(self, light: Light) -> None:
        lamp = UsdLux.SphereLight.Define(self.stage, f"{ROOT}/Lights/{light.name}")
        lamp.AddTranslateOp().Set(Gf.Vec3d(*map(float, light.position)))
        lamp.CreateRadiusAttr(LAMP)
        lamp.CreateExtentAttr(extent(np.array([[-LAMP] * 3, [LAMP] * 3])))
        lamp.CreateColorAttr(Gf.Vec3f(1.0, 0.93, 0.82))
        # Luminance of an even sphere that gives so many lumens.
        lamp.CreateIntensityAttr(light.lumens / (4 * np.pi**2 * LAMP**2))


def _path(body: Body) -> str:
    return f"{ROOT}/{GROUPS.get(body.kind, 'Shell')}/{body.name}"


def _link_path(body: Body, link: Link) -> str:
    return _path(body) if len(body.links) == 1 else f"{_path(body)}/{identifier(link.name)}"


def _felt(body: Body) -> list[str]:
    """What collides of it, as the schema has it: its rigid bodies, or the colliders of what never moves."""
    if body.free or len(body.links) > 1:
        return [_link_path(body, link) for link in body.links]
    path = _path(body)
    return [f"{path}/Colliders/collider_{k}" for k in range(len(body.links[0].colliders))]


def _rigid(prim: Any, link: Link) -> None:
    UsdPhysics.RigidBodyAPI.Apply(prim)
    mass, center, tensor = inertia(link)
    moments, axes = np.linalg.eigh(tensor)
    axes = axes * np.sign(np.linalg.det(axes))
    api = UsdPhysics.MassAPI.Apply(prim)
    api.CreateMassAttr(mass)
    api.CreateCenterOfMassAttr(Gf.Vec3f(*map(float, center)))
    api.CreateDiagonalInertiaAttr(Gf.Vec3f(*map(float, moments)))
    api.CreatePrincipalAxesAttr(Gf.Quatf(*map(float, quaternion(axes))))
    if counterbalanced(link):
        # A PhysX extension; an engine that does not know it lets the part fall open.
        prim.AddAppliedSchema("PhysxRigidBodyAPI")
        prim.CreateAttribute("physxRigidBody:disableGravity", Sdf.ValueTypeNames.Bool).Set(True)


def _frames(joint: Any, first: tuple[Array, Array], second: tuple[Array, Array]) -> None:
    """Where the joint is, seen from its two bodies: position and quaternion (w, x, y, z)."""
    joint.CreateLocalPos0Attr(Gf.Vec3f(*map(float, first[0])))
    joint.CreateLocalRot0Attr(Gf.Quatf(*map(float, first[1])))
    joint.CreateLocalPos1Attr(Gf.Vec3f(*map(float, second[0])))
    joint.CreateLocalRot1Attr(Gf.Quatf(*map(float, second[1])))
