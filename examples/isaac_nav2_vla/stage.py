"""Makes an exported USD stage ready for a robot: holds the doors open and adds the benchmark's base.

Only OpenUSD (`pxr`), so that it is tested without Isaac Sim. Metres, kilograms, z up; drives in USD's units (degrees).
The base is that of `stages/embodied/base.py`: two driven wheels, two casters, a column of 0.25 m radius.
"""

from math import degrees, pi
from typing import Any

from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics, UsdShade

ROBOT, BASE = "/Robot", "/Robot/base_link"
COLUMN = f"{BASE}/column"
RADIUS, HEIGHT, MASS = 0.25, 1.4, 24.5
WHEEL, TRACK, TYRE, TORQUE = 0.08, 0.36, 0.015, 6.0
LIDAR = 0.2
"""Height of the lidar, m; what shows of the robot leaves a slot there, so that it does not see itself."""
DRIVES = ("left_axle", "right_axle")
GAIN = 20.0
"""Of the wheels' velocity drives, N·m·s/rad."""
STIFF, DAMPED, STRONGEST = 1000.0, 200.0, 200.0
"""Of the drives that hold doors, N·m/rad, N·m·s/rad and N·m; it takes some seconds until they stand open."""
SLOT = 0.03


def open_doors(stage: Usd.Stage) -> list[str]:
    """Drive room doors to the end of their range and the entrance's to shut; paths of the joints that open.

    The exported drives only damp: their stiffness is 0, and a target alone would do nothing.
    """
    found = []
    for body in stage.GetPrimAtPath("/Apartment/Shell").GetChildren():
        facts = body.GetCustomDataByKey("apartgen") or {}
        hinges = [prim for prim in Usd.PrimRange(body) if prim.IsA(UsdPhysics.RevoluteJoint)]
        if facts.get("kind") != "door" or not hinges:
            continue
        opens = "door" in body.GetAttribute("semantics:labels:class").Get()
        for hinge in hinges:
            joint, drive = UsdPhysics.RevoluteJoint(hinge), UsdPhysics.DriveAPI(hinge, "angular")
            drive.CreateStiffnessAttr(STIFF * pi / 180)
            drive.CreateDampingAttr(DAMPED * pi / 180)
            drive.CreateMaxForceAttr(STRONGEST)
            drive.CreateTargetPositionAttr(joint.GetUpperLimitAttr().Get() if opens else 0.0)
            found += [str(hinge.GetPath())] if opens else []
    return found


def add_base(stage: Usd.Stage, x: float, y: float, yaw: float) -> str:
    """The base at a pose, as an articulation; its path."""
    top = UsdGeom.Xform.Define(stage, ROBOT)
    top.AddTranslateOp().Set(Gf.Vec3d(x, y, 0.0))
    top.AddRotateZOp().Set(degrees(yaw))
    UsdPhysics.ArticulationRootAPI.Apply(top.GetPrim())
    link = _link(stage, BASE, (0.0, 0.0, 0.0), MASS - 2, (1.6, 1.6, 0.7), (0.0, 0.0, 0.2))
    slick, rough = _material(stage, "slick", 0.0, "min"), _material(stage, "tyre", 0.9, "max")
    solid = _cylinder(stage, COLUMN, RADIUS, 0.02, HEIGHT, slick)
    UsdGeom.Imageable(solid).MakeInvisible()
    for name, low, high in (("skirt", 0.02, LIDAR - SLOT), ("mast", LIDAR + SLOT, HEIGHT)):
        _cylinder(stage, f"{BASE}/{name}", RADIUS, low, high)
    for k, ahead in enumerate((0.18, -0.18)):
        ball = UsdGeom.Sphere.Define(stage, f"{BASE}/caster_{k}")
        ball.CreateRadiusAttr(0.03)
        ball.AddTranslateOp().Set(Gf.Vec3d(ahead, 0.0, 0.03))
        _solid(ball.GetPrim(), slick)
    for axle, side in zip(DRIVES, (1, -1), strict=True):
        _wheel(stage, link, axle, side, rough)
    return ROBOT


def _wheel(stage: Usd.Stage, base: Any, axle: str, side: int, material: Any) -> None:
    path = f"{ROBOT}/{axle.replace('axle', 'wheel')}"
    place = (0.0, side * TRACK / 2, WHEEL)
    # A disc of 1 kg.
    _link(stage, path, place, 1.0, (WHEEL**2 / 4, WHEEL**2 / 2, WHEEL**2 / 4))
    tyre = UsdGeom.Cylinder.Define(stage, f"{path}/tyre")
    tyre.CreateAxisAttr("Y")
    tyre.CreateRadiusAttr(WHEEL)
    tyre.CreateHeightAttr(2 * TYRE)
    _solid(tyre.GetPrim(), material)
    joint = UsdPhysics.RevoluteJoint.Define(stage, f"{ROBOT}/{axle}")
    joint.CreateBody0Rel().SetTargets([base.GetPath()])
    joint.CreateBody1Rel().SetTargets([path])
    joint.CreateLocalPos0Attr(Gf.Vec3f(*place))
    joint.CreateAxisAttr("Y")
    drive = UsdPhysics.DriveAPI.Apply(joint.GetPrim(), "angular")
    drive.CreateTypeAttr("force")
    drive.CreateStiffnessAttr(0.0)
    drive.CreateDampingAttr(GAIN * pi / 180)
    drive.CreateMaxForceAttr(TORQUE)


def _link(
    stage: Usd.Stage, path: str, place: tuple[float, float, float], mass: float, inertia: tuple[float, float, float],
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> Any:
    made = UsdGeom.Xform.Define(stage, path)
    made.AddTranslateOp().Set(Gf.Vec3d(*place))
    prim = made.GetPrim()
    UsdPhysics.RigidBodyAPI.Apply(prim)
    weight = UsdPhysics.MassAPI.Apply(prim)
    weight.CreateMassAttr(mass)
    weight.CreateCenterOfMassAttr(Gf.Vec3f(*centre))
    weight.CreateDiagonalInertiaAttr(Gf.Vec3f(*inertia))
    weight.CreatePrincipalAxesAttr(Gf.Quatf(1.0))
    return prim


def _cylinder(stage: Usd.Stage, path: str, radius: float, low: float, high: float, material: Any = None) -> Any:
    made = UsdGeom.Cylinder.Define(stage, path)
    made.CreateAxisAttr("Z")
    made.CreateRadiusAttr(radius)
    made.CreateHeightAttr(high - low)
    made.AddTranslateOp().Set(Gf.Vec3d(0.0, 0.0, (low + high) / 2))
    if material is not None:
        _solid(made.GetPrim(), material)
    return made.GetPrim()


def _solid(prim: Any, material: Any) -> None:
    UsdPhysics.CollisionAPI.Apply(prim)
    binding = UsdShade.MaterialBindingAPI.Apply(prim)
    binding.Bind(material, UsdShade.Tokens.weakerThanDescendants, "physics")


def _material(stage: Usd.Stage, name: str, friction: float, combine: str) -> Any:
    made = UsdShade.Material.Define(stage, f"{ROBOT}/Materials/{name}")
    physics = UsdPhysics.MaterialAPI.Apply(made.GetPrim())
    physics.CreateStaticFrictionAttr(friction)
    physics.CreateDynamicFrictionAttr(friction)
    # A PhysX extension: whose friction counts where two materials meet.
    made.GetPrim().AddAppliedSchema("PhysxMaterialAPI")
    made.GetPrim().CreateAttribute("physxMaterial:frictionCombineMode", Sdf.ValueTypeNames.Token).Set(combine)
    return made
