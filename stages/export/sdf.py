"""SDFormat world for Gazebo: one model a body, static shell, furniture fixed or loose, lights.

Links' frames are their body's; joints say where they are on the base.
"""

from pathlib import Path
from xml.etree import ElementTree

from apartgen.stages.export._hull import hull
from apartgen.stages.export._obj import Files
from apartgen.stages.export._readback import Refused, read_xml, refuse_doubles
from apartgen.stages.export._rotation import roll_pitch_yaw
from apartgen.stages.export._xml import Element, add, number, numbers, save
from apartgen.stages.scene.pieces import pieces
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things.asset import Collider, Link, Material, Mesh
from apartgen.stages.things.body import Body, Light, counterbalanced, inertia

FOLDER = "sdf"


def write(scene: Scene, out: Path) -> list[Path]:
    """sdf/apartment.sdf and its meshes in sdf/meshes."""
    files = Files(out / FOLDER / "meshes")
    root = ElementTree.Element("sdf", version="1.9")
    world = add(root, "world", name="apartment")
    physics = add(world, "physics", name="default", type="ode", default="true")
    add(physics, "max_step_size", "0.002")
    add(physics, "real_time_factor", "1.0")
    add(world, "gravity", "0 0 -9.81")
    for light in scene.lights:
        _light(world, light)
    for body in scene.bodies:
        _model(world, body, files)
    return [save(root, out / FOLDER / "apartment.sdf"), *files.written]


def read_back(files: list[Path]) -> None:
    """By the parser of XML; names are unique where they have to be, and meshes are there."""
    world = read_xml(files[0], ("uri", "albedo_map")).find("world")
    if world is None:
        raise Refused(f"{files[0].name} has no world")
    refuse_doubles(files[0], [*world.iter("model"), *world.iter("light")])
    for model in world.iter("model"):
        refuse_doubles(files[0], [*model.iter("link"), *model.iter("joint")])


def _light(world: Element, light: Light) -> None:
    element = add(world, "light", name=light.name, type="point")
    add(element, "pose", numbers([*light.position, 0, 0, 0]))
    add(element, "diffuse", "1 0.93 0.82 1")
    add(element, "intensity", number(light.lumens / 1100))
    falloff = add(element, "attenuation")
    for name, value in (("range", "12"), ("constant", "0.3"), ("linear", "0.1"), ("quadratic", "0.05")):
        add(falloff, name, value)


def _model(world: Element, body: Body, files: Files) -> None:
    model = add(world, "model", name=body.name)
    add(model, "pose", numbers([*body.position, 0, 0, body.yaw]))
    fixed = not body.free
    if fixed and len(body.links) == 1:
        add(model, "static", "true")
    for link in body.links:
        _link(model, body, link, files)
    if fixed and len(body.links) > 1:
        joint = add(model, "joint", name=f"{body.name}__world", type="fixed")
        add(joint, "parent", "world")
        add(joint, "child", body.name)
    for link in body.links[1:]:
        _joint(model, body, link)


def _joint(model: Element, body: Body, link: Link) -> None:
    joint = link.joint
    assert joint is not None
    kind = "revolute" if joint.type == "hinge" else "prismatic"
    element = add(model, "joint", name=body.joint_name(joint), type=kind)
    pose = add(element, "pose", numbers([*joint.origin, 0, 0, 0]))
    pose.set("relative_to", body.name)
    add(element, "parent", body.name)
    add(element, "child", body.link_name(link))
    axis = add(element, "axis")
    add(axis, "xyz", numbers(joint.axis))
    limit = add(axis, "limit")
    add(limit, "lower", number(joint.range[0]))
    add(limit, "upper", number(joint.range[1]))
    add(add(axis, "dynamics"), "damping", number(body.motion(link).damping))


def _link(model: Element, body: Body, link: Link, files: Files) -> None:
    name = body.link_name(link)
    element = add(model, "link", name=name)
    if counterbalanced(link):
        add(element, "gravity", "false")
    mass, center, tensor = inertia(link)
    inertial = add(element, "inertial")
    add(inertial, "pose", numbers([*center, 0, 0, 0]))
    add(inertial, "mass", number(mass))
    moments = add(inertial, "inertia")
    for key, at in {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}.items():
        add(moments, key, number(tensor[at]))
    for k, piece in enumerate(pieces(link)):
        visual = add(element, "visual", name=f"visual_{k}")
        file = files.mesh(f"{name}_{k}", piece, None, files.surface(piece.material))
        add(add(add(visual, "geometry"), "mesh"), "uri", f"meshes/{file}")
        _material(visual, piece.material, files)
    for k, collider in enumerate(link.colliders):
        _collider(element, name, k, collider, link.friction, files)


def _material(visual: Element, m: Material, files: Files) -> None:
    if m.color[3] < 1:
        add(visual, "transparency", number(1 - m.color[3]))
    element = add(visual, "material")
    color = [1.0, 1.0, 1.0, 1.0] if m.texture else m.color
    for name in ("ambient", "diffuse"):
        add(element, name, numbers(color))
    metal = add(add(element, "pbr"), "metal")
    if m.texture:
        add(metal, "albedo_map", f"meshes/{files.texture(m.texture)}")
    add(metal, "roughness", number(m.roughness))
    add(metal, "metalness", number(m.metalness))


def _collider(element: Element, name: str, k: int, c: Collider, friction: float, files: Files) -> None:
    collision = add(element, "collision", name=f"collider_{k}")
    if c.kind == "hull":
        # A hull's own mesh is convex, so that it is a collider as it is.
        file = files.mesh(f"{name}__c{k}", Mesh(*hull(c), Material("hull")))
        add(add(add(collision, "geometry"), "mesh"), "uri", f"meshes/{file}")
    else:
        add(collision, "pose", numbers([*c.center, *roll_pitch_yaw(c.rotation)]))
        geometry = add(collision, "geometry")
        if c.kind == "box":
            add(add(geometry, "box"), "size", numbers(c.size))
        else:
            shape = add(geometry, c.kind)
            add(shape, "radius", number(c.size[0]))
            if c.kind == "cylinder":
                add(shape, "length", number(c.size[2]))
    slip = add(add(add(collision, "surface"), "friction"), "ode")
    add(slip, "mu", number(friction))
    add(slip, "mu2", number(friction))
