"""MuJoCo XML: fixed and loose bodies, jointed parts, primitive colliders, textured visuals, handles as sites.

Geom groups: 2 what shows, 3 colliders, 4 ceilings (not shown unless asked for).
"""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import numpy as np

from apartgen.schemas.plan import Room
from apartgen.stages.export._obj import Files
from apartgen.stages.export._rotation import about_z, quaternion
from apartgen.stages.export._xml import Element, add, number, numbers, save
from apartgen.stages.scene.pieces import image_name, names, pieces
from apartgen.stages.scene.scene import Scene, identifier
from apartgen.stages.space import polygons
from apartgen.stages.things.asset import UNTURNED, Collider, Link, Material
from apartgen.stages.things.body import Body, Inertia, counterbalanced, inertia

if TYPE_CHECKING:
    from apartgen.stages.export._masks import Mask

FOLDER = "mjcf"
ARMATURE = 0.002
EYE, LOOKED_AT = 0.2, 0.8
"""How far below the ceiling cameras of rooms are, over what stands there, and the height of what they look at, m."""
STRAIGHT = numbers(quaternion(UNTURNED))
GEOMS = {"box": "box", "cylinder": "cylinder", "sphere": "sphere", "hull": "mesh"}


def write(scene: Scene, out: Path) -> list[Path]:
    """mjcf/apartment.xml and its meshes and textures in mjcf/assets."""
    writer = _Writer(scene, Files(out / FOLDER / "assets"))
    return [save(writer.root, out / FOLDER / "apartment.xml"), *writer.files.written]


def read_back(files: list[Path]) -> None:
    """By MuJoCo's compiler."""
    import mujoco

    with _forgotten(mujoco):
        read = mujoco.MjSpec.from_file(str(files[0]))
        read.compiler.usethread = False  # threads take more of the processor, and on few cores no less time
        read.compile()


@contextmanager
def _forgotten(mujoco: Any) -> Iterator[None]:
    """Without what MuJoCo keeps of the files it reads: 40 MB a home, up to 500 MB, none of which is read again."""
    if not hasattr(mujoco, "mj_setCacheCapacity"):
        yield
        return
    kept = mujoco.mj_getCache()
    capacity = mujoco.mj_getCacheCapacity(kept)
    mujoco.mj_setCacheCapacity(kept, 0)
    try:
        yield
    finally:
        mujoco.mj_setCacheCapacity(kept, capacity)


def _masks(scene: Scene) -> "dict[str, Mask]":
    """What has other masks than usual, where bits say what touches; they are drawn by a heavy package."""
    if not scene.masked:
        return {}
    from apartgen.stages.export._masks import masks

    return masks(scene.bodies)


class _Writer:
    """The XML document as it is built."""

    def __init__(self, scene: Scene, files: Files) -> None:
        self.files = files
        self.root = ElementTree.Element("mujoco", model="apartment")
        self.height = scene.home.height
        self._settings(scene)
        self.assets = add(self.root, "asset")
        self.world = add(self.root, "worldbody")
        self.contact = add(self.root, "contact")
        self.actuators, self.sensors = add(self.root, "actuator"), add(self.root, "sensor")
        self.custom, self.initial = add(self.root, "custom"), list[float]()
        self.materials = names(m.material for body in scene.bodies for link in body.links for m in link.visuals)
        overhead = (link for body in scene.bodies if body.kind == "ceiling" for link in body.links)
        self.glowing = {mesh.material for link in overhead for mesh in link.visuals}
        self.meshes: set[str] = set()
        self.weights: dict[tuple[int, float], Inertia] = {}
        self.masks = _masks(scene)
        self.still = {body.name for body in scene.bodies if scene.masked and not body.free}
        self._materials()
        self._lights(scene)
        for body in scene.bodies:
            self._body(body)
        self._apart(scene.bodies)
        for room in scene.home.rooms:
            self._camera(room)
        add(add(self.root, "keyframe"), "key", name="initial", qpos=self.initial)

    def _camera(self, room: Room) -> None:
        """A view of a room from above in its corner that is furthest from the middle."""
        middle = np.array(polygons.floor(room).representative_point().coords[0])
        corners = np.asarray(room.polygon, float)
        corner = corners[int(np.linalg.norm(corners - middle, axis=1).argmax())]
        eye = np.array([*(corner + 0.12 * (middle - corner)), self.height - EYE])
        ahead = np.array([*middle, LOOKED_AT]) - eye
        right = np.array([ahead[1], -ahead[0], 0.0])
        add(self.world, "camera", name=f"view_{identifier(room.id)}", pos=eye, fovy=75,
            xyaxes=[*right, *np.cross(right, ahead)])

    def _says(self, body: Body) -> None:
        """What the artifact says of a body, as text under its name."""
        state = [f"{name}={number(float(value))}" for name, value in body.says.get("state", {}).items()]
        lists = [f"{name}={','.join(body.says[name])}" for name in ("affordances", "switches") if name in body.says]
        if lists or state:
            add(self.custom, "text", name=body.name, data=" ".join([*state, *lists]))

    def _settings(self, scene: Scene) -> None:
        add(self.root, "compiler", angle="radian", autolimits="true")
        add(self.root, "option", timestep=0.004, integrator="implicitfast", cone="elliptic", impratio=10)
        x, y = np.array([point for room in scene.home.rooms for point in room.polygon]).T
        middle = [(x.min() + x.max()) / 2, (y.min() + y.max()) / 2, 1.0]
        add(self.root, "statistic", center=middle, extent=max(np.ptp(x), np.ptp(y)) / 1.6)
        visual = add(self.root, "visual")
        add(visual, "headlight", ambient=[0.48] * 3, diffuse=[0.55] * 3, specular=[0.1] * 3)
        add(visual, "map", znear=0.005, zfar=10)
        add(visual, "global", offwidth=1920, offheight=1080, azimuth=-120, elevation=-55)
        default = add(self.root, "default")
        shown = add(default, "default", class_="visual")
        add(shown, "geom", group=2, contype=0, conaffinity=0, density=0)
        solid = add(default, "default", class_="collider")
        add(solid, "geom", group=3, condim=4, rgba=[0.3, 0.6, 0.9, 0.4], solref=[0.008, 1])

    def _materials(self) -> None:
        add(self.assets, "texture", type="skybox", builtin="gradient", rgb1=[0.9, 0.94, 1], rgb2=[0.6, 0.7, 0.8],
            width=256, height=256)
        # Two libraries may have one image, under two paths.
        images = {image_name(texture): texture for texture in sorted({m.texture for m in self.materials if m.texture})}
        for name, texture in images.items():
            add(self.assets, "texture", name=name, type="2d", file=f"assets/{self.files.texture(texture)}")
        for material, name in self.materials.items():
            self._material(material, name)

    def _material(self, m: Material, name: str) -> None:
        # A texture carries the colour itself; MuJoCo multiplies the two.
        rgba = [1.0, 1.0, 1.0, m.color[3]] if m.texture else m.color
        element = add(self.assets, "material", name=name, rgba=rgba, metallic=m.metalness, roughness=m.roughness,
                      specular=0.6 * (1 - m.roughness), shininess=1 - m.roughness)
        if m.texture:
            element.set("texture", image_name(m.texture))
        if m.emission:
            element.set("emission", number(m.emission))
        if m in self.glowing:
            # Only light from the floor reaches a ceiling, which MuJoCo does not trace.
            element.set("emission", "0.45")
        if m.roughness < 0.05 and m.metalness == 1:
            element.set("reflectance", "0.4")

    def _lights(self, scene: Scene) -> None:
        for light in scene.lights:
            diffuse = [light.lumens / 1100 * c * 0.25 for c in (1.0, 0.95, 0.88)]
            add(self.world, "light", name=light.name, pos=light.position, dir=[0, 0, -1], diffuse=diffuse,
                specular=[0.05] * 3, castshadow="false", cutoff=80, attenuation=[1, 0.1, 0.1])

    def _body(self, body: Body) -> None:
        element = add(self.world, "body", name=body.name, pos=body.position, quat=about_z(body.yaw))
        if body.free:
            add(element, "freejoint", name=f"{body.name}__free")
            self.initial += [*body.position, *about_z(body.yaw)]
        self._says(body)
        base, *moving = body.links
        self._link(element, body, base, self._weight(base) if body.free else None)
        for link in moving:
            part = add(element, "body", name=body.link_name(link))
            weight = self._weight(link)
            if counterbalanced(link, weight):
                part.set("gravcomp", "1")
            self._joint(part, body, link)
            self._link(part, body, link, weight)
            if not body.free or not self.still:  # MuJoCo lets no part touch what it hangs on where that moves
                self._exclude(body.name, body.link_name(link))

    def _weight(self, link: Link) -> Inertia:
        """Mass properties of a link; things of one model share them."""
        if not link.colliders:
            return inertia(link)
        key = id(link.colliders), link.mass
        if key not in self.weights:
            self.weights[key] = inertia(link)
        return self.weights[key]

    def _apart(self, bodies: list[Body]) -> None:
        """No contact between what stands in something and that."""
        known = {body.name: body for body in bodies}
        for body in bodies:
            for other in (known[name] for name in body.within):
                for a, b in product(body.links, other.links):
                    self._exclude(body.link_name(a), other.link_name(b))

    def _exclude(self, a: str, b: str) -> None:
        """No contact between two bodies, where masks do not say so and neither moves for certain."""
        found = [self.masks[name] for name in (a, b) if name in self.masks]
        told = len(found) == 2 and not found[0].meets(found[1])
        if not told and not {a, b} <= self.still:
            add(self.contact, "exclude", body1=a, body2=b)

    def _joint(self, part: Element, body: Body, link: Link) -> None:
        assert link.joint is not None
        own = body.motion(link)
        add(part, "joint", name=body.joint_name(link.joint), type=link.joint.type, axis=link.joint.axis,
            pos=link.joint.origin, range=link.joint.range, damping=own.damping, frictionloss=own.friction,
            armature=ARMATURE)
        add(self.sensors, "jointpos", name=f"{body.joint_name(link.joint)}__at", joint=body.joint_name(link.joint))
        self.initial.append(body.opened(link.joint))
        shut, wide = sorted(link.joint.range, key=abs)
        for held, word, at in ((own.catch, "catch", shut), (own.rest, "rest", wide)):
            if held:
                self._held(f"{body.joint_name(link.joint)}__{word}", body.joint_name(link.joint), at,
                           np.sign(at - (shut + wide) / 2) * held, own.travel)

    def _held(self, name: str, joint: str, at: float, force: float, travel: float) -> None:
        """What holds a part at an end: all of the force there, none `travel` away; its control has no effect."""
        slope = abs(force) / travel
        add(self.actuators, "general", name=name, joint=joint, gainprm="0", biastype="affine",
            biasprm=[force - slope * at, slope, 0.0], forcelimited="true", forcerange=sorted([force, 0.0]))

    def _link(self, element: Element, body: Body, link: Link, weight: Inertia | None) -> None:
        if weight is not None:
            mass, center, tensor = weight
            full = [tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2]]
            add(element, "inertial", pos=center, mass=mass, fullinertia=full)
        for k, piece in enumerate(pieces(link)):
            file = self.files.mesh(f"{body.link_name(link)}_{k}", piece)
            geom = add(element, "geom", class_="visual", type="mesh", mesh=self._mesh(file),
                       material=self.materials[piece.material])
            if body.kind == "ceiling":
                geom.set("group", "4")
        for k, collider in enumerate(link.colliders):
            geom = self._collider(element, f"{body.link_name(link)}__c{k}", collider, link.friction)
            if mask := self.masks.get(body.link_name(link)):
                geom.attrib.update(contype=str(mask.contype), conaffinity=str(mask.conaffinity))
        if link.handle is not None:
            add(element, "site", name=f"{body.link_name(link)}__handle", pos=link.handle, size=0.015, group=3)

    def _mesh(self, file: str) -> str:
        """Declares a mesh file once; its name is the file's."""
        name = file.removesuffix(".obj")
        if name not in self.meshes:
            self.meshes.add(name)
            # Thin and open pieces have no volume that MuJoCo could take an inertia from.
            add(self.assets, "mesh", name=name, file=f"assets/{file}", inertia="shell")
        return name

    def _collider(self, element: Element, name: str, c: Collider, friction: float) -> Element:
        geom = add(element, "geom", class_="collider", name=name, type=GEOMS[c.kind], friction=number(friction))
        if c.kind == "hull":
            assert c.vertices is not None
            add(self.assets, "mesh", name=name, vertex=(c.vertices @ c.rotation.T + c.center).ravel())
            geom.set("mesh", name)
            return geom
        geom.set("size", numbers(_extents(c)))
        geom.set("pos", numbers(c.center))
        geom.set("quat", STRAIGHT if c.rotation is UNTURNED else numbers(quaternion(c.rotation)))
        return geom


def _extents(c: Collider) -> list[float]:
    """Half sides, or radius and half the length, or radius."""
    x, y, z = c.size.tolist()
    return {"box": [x / 2, y / 2, z / 2], "cylinder": [x, z * 0.5], "sphere": [x]}[c.kind]
