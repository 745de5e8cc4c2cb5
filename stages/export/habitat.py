"""Habitat scene dataset: a stage, objects, articulated objects as URDF, and the scene instance that places them.

Habitat's world is y up: (x, y, z) here is (x, z, -y) there. Objects' files are y up; URDF files stay z up and their
placing turns them. A rigid object's colliders are a GLB of their own, one node each, of which Habitat makes one convex
shape each; of the visual's nodes it would make a single hull, with no room under a table.

Every template has its category's `semantic_id`, which a semantic sensor shows; the lexicon names them.
"""

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

from apartgen.stages.export._gltf import packed
from apartgen.stages.export._hull import hull
from apartgen.stages.export._obj import Files
from apartgen.stages.export._readback import read_glb, read_json, read_urdf
from apartgen.stages.export._rotation import y_up
from apartgen.stages.export._urdf import body_links
from apartgen.stages.export._xml import save
from apartgen.stages.scene.scene import Scene, identifier, untaken
from apartgen.stages.things.asset import Link, Material, Mesh
from apartgen.stages.things.body import Body, Light, inertia
from apartgen.stages.things.categories import CATEGORIES, those

FOLDER = "habitat"
NAME = "apartment"
LEXICON = f"semantics/{NAME}.semantic_lexicon.json"
UPRIGHT = 0.5**0.5
MARGIN = 0.001
"""Shell that Bullet puts about a shape, m; by Habitat's own, things would hover 4 cm above the floor."""
NEWCOMERS = sorted(those(lambda kind: kind.like != ""))
SEMANTIC_IDS = {name: k for k, name in enumerate(("unknown", *CATEGORIES, "door", "entrance", *NEWCOMERS))}
"""By category; 0 is the stage and whatever has no name here."""
Config = dict[str, Any]


def write(scene: Scene, out: Path) -> list[Path]:
    """habitat/apartment.scene_dataset_config.json and what it names."""
    folder = out / FOLDER
    writer = _Writer(folder, scene.credits)
    fixed = [body for body in scene.bodies if body.kind not in ("object", "door")]
    writer.stage(fixed)
    for body in scene.bodies:
        if body.kind in ("object", "door"):
            writer.place(body)
    writer.lights(scene.lights)
    writer.lexicon()
    writer.instance()
    writer.dataset()
    *others, dataset = writer.written
    return [dataset, *others, *writer.files.written]


def read_back(files: list[Path]) -> None:
    """By the parsers of JSON, glTF and URDF."""
    read_json(file for file in files if file.suffix == ".json")
    read_glb(file for file in files if file.suffix == ".glb")
    read_urdf([file for file in files if file.suffix == ".urdf"])


class _Writer:
    """Files as they are written, and what stands where."""

    def __init__(self, folder: Path, credits: list[str]) -> None:
        self.folder, self.credits = folder, credits
        self.written: list[Path] = []
        self.files = Files(folder / "urdf" / "meshes")
        self.models: dict[tuple[Any, ...], str] = {}
        self.objects: list[Config] = []
        self.articulated: list[Config] = []

    def stage(self, bodies: list[Body]) -> None:
        """The shell, which never moves."""
        self._bytes(f"stages/{NAME}.glb", packed(bodies, [], self.credits))
        self._json(f"stages/{NAME}.stage_config.json", {
            "render_asset": f"{NAME}.glb", "collision_asset": f"{NAME}.glb", "up": [0, 1, 0], "front": [0, 0, -1],
            "units_to_meters": 1.0, "requires_lighting": True, "is_collidable": True, "friction_coefficient": 0.6,
            "margin": MARGIN,
        })  # fmt: skip

    def place(self, body: Body) -> None:
        """An object; its model's files are written once."""
        moves = len(body.links) > 1
        key = body.model or body.name, body.category, body.ranges, body.physics
        if key not in self.models:
            self.models[key] = untaken(identifier(key[0]), self.models.values())
            (self._urdf if moves else self._object)(body, self.models[key])
        into = self.articulated if moves else self.objects
        entry = {
            "template_name": self.models[key], "translation": y_up(body.position), "translation_origin": "asset_local",
            "rotation": _turned(body.yaw, z_up=moves), "motion_type": "DYNAMIC" if body.free or moves else "STATIC",
            "user_defined": {k: v for k, v in _facts(body).items() if v},
        }
        into.append(entry | ({"fixed_base": not body.free} if moves else {}))

    def _object(self, body: Body, name: str) -> None:
        link = body.links[0]
        alone = Body(body.name, "object", body.category, "", np.zeros(3), 0.0, body.links)
        self._bytes(f"objects/{name}.glb", packed([alone], [], self.credits))
        felt = f"{name}.collider.glb" if link.colliders else f"{name}.glb"
        if link.colliders:
            self._bytes(f"objects/{felt}", packed(_solids(link), [], []))
        mass, center, tensor = inertia(link)
        x, y, z = (float(v) for v in np.diag(tensor))
        self._json(f"objects/{name}.object_config.json", {
            "render_asset": f"{name}.glb", "collision_asset": felt, "join_collision_meshes": False, "margin": MARGIN,
            "requires_lighting": True, "is_collidable": bool(link.colliders), "friction_coefficient": link.friction,
            "mass": mass, "COM": y_up(center), "inertia": [x, z, y], "semantic_id": _semantic_id(body),
            "user_defined": {"category": body.category, "asset": body.model},
        })  # fmt: skip

    def _urdf(self, body: Body, name: str) -> None:
        robot = ElementTree.Element("robot", name=name)
        body_links(robot, body, self.files, "meshes")
        self.written.append(save(robot, self.folder / "urdf" / f"{name}.urdf"))
        # Found by the URDF's name, which Habitat 0.3 asks to be named here, too.
        config = {"urdf_filepath": f"{name}.urdf", "semantic_id": _semantic_id(body)}
        self._json(f"urdf/{name}.ao_config.json", config)

    def lights(self, lights: list[Light]) -> None:
        """Lamps, as Habitat's lighting layout."""
        found = {
            light.name: {
                "position": y_up(light.position), "type": "point", "color": [1.0, 0.93, 0.82],
                "intensity": light.lumens / 1100,
            }
            for light in lights
        }  # fmt: skip
        self._json(f"lighting/{NAME}.lighting_config.json", {"lights": found})

    def lexicon(self) -> None:
        """What each semantic id means."""
        classes = [{"id": k, "name": name} for name, k in SEMANTIC_IDS.items()]
        self._json(LEXICON, {"classes": classes})

    def instance(self) -> None:
        """What stands where."""
        self._json(f"scenes/{NAME}.scene_instance.json", {
            "stage_instance": {"template_name": NAME}, "default_lighting": NAME, "semantic_scene_instance": NAME,
            "object_instances": self.objects, "articulated_object_instances": self.articulated,
        })  # fmt: skip

    def dataset(self) -> None:
        """The file that a simulator is given; it names the folders of the others."""
        self._json(f"{NAME}.scene_dataset_config.json", {
            "stages": {"paths": {".json": ["stages"]}}, "objects": {"paths": {".json": ["objects"]}},
            "articulated_objects": {"paths": {".urdf": ["urdf"]}}, "scene_instances": {"paths": {".json": ["scenes"]}},
            "light_setups": {"paths": {".json": ["lighting"]}},
            "semantic_scene_descriptor_instances": {NAME: LEXICON},
        })  # fmt: skip

    def _json(self, name: str, content: Config) -> None:
        self._bytes(name, (json.dumps(content, indent=1) + "\n").encode())

    def _bytes(self, name: str, content: bytes) -> None:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        self.written.append(path)


def _solids(link: Link) -> list[Body]:
    """Each of the link's colliders as a body of its own."""
    meshes = [Mesh(*hull(c), Material("collider")) for c in link.colliders]
    return [
        Body(f"collider_{k}", "object", "collider", "", np.zeros(3), 0.0, [Link("base", [mesh], [], 0.0)])
        for k, mesh in enumerate(meshes)
    ]


def _facts(body: Body) -> Config:
    return {"name": body.name, "id": body.id, "category": body.category, "room": body.room, "asset": body.model}


def _semantic_id(body: Body) -> int:
    return SEMANTIC_IDS.get(body.category, 0)


def _turned(yaw: float, z_up: bool) -> list[float]:
    """w, x, y, z of a turn about the vertical, after one that stands a z-up model upright."""
    c, s = float(np.cos(yaw / 2)), float(np.sin(yaw / 2))
    return [c * UPRIGHT, -c * UPRIGHT, s * UPRIGHT, s * UPRIGHT] if z_up else [c, 0.0, s, 0.0]
