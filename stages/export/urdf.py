"""URDF of the whole apartment, fixed to one world link, and of each object by itself to be placed at will.

URDF has no loose bodies: in the whole apartment everything stands where it is; a
simulator that wants chairs to move loads them from urdf/objects, named after their asset.
"""

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from apartgen.stages.export._obj import Files
from apartgen.stages.export._readback import read_urdf
from apartgen.stages.export._urdf import body_links, joint
from apartgen.stages.export._xml import add, save
from apartgen.stages.scene.scene import Scene, identifier, untaken

FOLDER = "urdf"


def write(scene: Scene, out: Path) -> list[Path]:
    """urdf/apartment.urdf, urdf/objects/*.urdf, and their meshes in urdf/meshes."""
    files = Files(out / FOLDER / "meshes")
    whole = ElementTree.Element("robot", name="apartment")
    add(whole, "link", name="world")
    written: list[Path] = []
    models: dict[tuple[Any, ...], str] = {}
    for body in scene.bodies:
        body_links(whole, body, files, "meshes")
        joint(whole, f"{body.name}__world", "fixed", "world", body.name, body.position, body.yaw)
        key = body.model, body.ranges, body.physics
        if body.kind == "object" and key not in models:
            name = models[key] = untaken(identifier(body.model), models.values())
            alone = ElementTree.Element("robot", name=name)
            body_links(alone, body, files, "../meshes")
            written.append(save(alone, out / FOLDER / "objects" / f"{name}.urdf"))
    return [save(whole, out / FOLDER / "apartment.urdf"), *written, *files.written]


def read_back(files: list[Path]) -> None:
    """The apartment and every object."""
    read_urdf([file for file in files if file.suffix == ".urdf"])
