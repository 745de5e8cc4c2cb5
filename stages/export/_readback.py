"""Files read again by the parsers of their formats, each of which raises what it likes where it refuses one."""

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, BinaryIO
from xml.etree import ElementTree

Element = ElementTree.Element


class Refused(Exception):
    """What a parser lets pass, though it is wrong."""


def read_glb(files: Iterable[Path | BinaryIO]) -> None:
    """Binary glTF."""
    import trimesh

    for file in files:
        scene: Any = trimesh.load(file, file_type="glb", process=False)
        if not all(len(shape.faces) and shape.faces.max() < len(shape.vertices) for shape in scene.geometry.values()):
            raise Refused("a mesh has faces without vertices")


def read_json(files: Iterable[Path]) -> None:
    """JSON."""
    for file in files:
        json.loads(file.read_text(encoding="utf-8"))


def read_images(files: Iterable[Path]) -> None:
    """Images of any kind."""
    from PIL import Image

    for file in files:
        with Image.open(file) as picture:
            picture.load()


def read_xml(file: Path, refers: Sequence[str] = ()) -> Element:
    """XML; files that these tags or attributes name are there."""
    root = ElementTree.parse(file).getroot()
    named = {element.get("filename") or element.text or "" for tag in refers for element in root.iter(tag)}
    if lost := sorted(name for name in named if name and not (file.parent / name).is_file()):
        raise Refused(f"{file.name} names {lost[0]}, which is not there")
    return root


def refuse_doubles(file: Path, elements: Iterable[Element]) -> None:
    """No two elements of one name."""
    known = Counter(element.get("name") for element in elements)
    if twice := sorted(str(name) for name, count in known.items() if count > 1):
        raise Refused(f"{file.name} has {twice[0]} twice")


def read_urdf(files: Sequence[Path]) -> None:
    """URDF: by yourdfpy where it is installed; else every joint is asked for its links."""
    for file in files:
        robot = read_xml(file, ("mesh",))
        links = list(robot.iter("link"))
        refuse_doubles(file, links)
        refuse_doubles(file, robot.iter("joint"))
        known = {link.get("name") for link in links}
        ends = [end.get("link") for joint in robot.iter("joint") for end in joint if end.tag in ("parent", "child")]
        if lost := [str(name) for name in ends if name not in known]:
            raise Refused(f"{file.name} has a joint of {lost[0]}, which is no link")
    try:
        from yourdfpy import URDF
    except ImportError:
        return
    for file in files:
        if not URDF.load(str(file), load_meshes=False, build_scene_graph=False).validate():
            raise Refused(f"{file.name} is not valid")
