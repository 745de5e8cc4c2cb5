"""What is made of models that others bring, altered ones too, and of libraries of them, as it was."""

import json
import re
from random import Random

import numpy as np
import pytest
from digests import kept
from digests.test_brought_kept import plain
from fuzz import targets
from fuzz.spoil import spoilt_bytes
from PIL import Image
from plan.imports import homes, writers
from retrieve import test_gltf_by_hand as gltf
from retrieve import test_retrieve_owned as owned
from retrieve.test_retrieve_indexing import BAD, shop  # noqa: F401

from apartgen.schemas.errors import ApartgenError
from apartgen.stages.plan import PlanConfig, imports
from apartgen.stages.retrieve import RetrieveConfig, build, folder, furniture, simobjects
from apartgen.stages.retrieve.matching import store
from apartgen.stages.retrieve.matching.indexed import IndexedLibrary
from apartgen.stages.retrieve.shape import fields
from apartgen.stages.things.categories import TABLE

NUMBER = re.compile(r"-?\b\d+(?:\.\d+)?\b")
ATTRIBUTE = re.compile(r' \w+="[^"]*"')
OTHERS = ("0", "-1", "2", "0.5", "1e9", "nan", "x", "-0.3 4")
SDF = """<sdf version="1.7"><model name="bin"><pose>1 0 0 0 0 0.4</pose>
<link name="body"><pose>0 0 0.2 0 0 0</pose><inertial><mass>2</mass></inertial>
<visual name="v"><geometry><box><size>0.2 0.3 0.4</size></box></geometry>
<material><diffuse>.1 .2 .3 1</diffuse></material></visual>
<collision name="c"><geometry><cylinder><radius>0.1</radius><length>0.4</length></cylinder></geometry></collision>
</link><link name="lid"><pose relative_to="body">0 0 0.2 0 0.1 0</pose>
<visual name="v"><geometry><sphere><radius>0.1</radius></sphere></geometry></visual></link>
<joint name="hinge" type="revolute"><parent>body</parent><child>lid</child><pose>-0.1 0 0 0 0 0</pose>
<axis><xyz>0 -1 0</xyz><limit><lower>-0.2</lower><upper>1.2</upper></limit></axis></joint>
<link name="tray"><visual name="v"><geometry><box><size>.1 .1 .02</size></box></geometry></visual></link>
<joint name="slide" type="prismatic"><parent>body</parent><child>tray</child><axis><xyz>1 0 0</xyz>
<limit><lower>0</lower><upper>0.3</upper></limit></axis></joint></model></sdf>"""
URDF = """<robot name="cabinet"><material name="red"><color rgba="1 0 0 1"/></material>
<link name="a"><inertial><mass value="9"/></inertial><visual><origin xyz="0 0 .2" rpy="0 0 .5"/>
<geometry><cylinder radius=".2" length=".4"/></geometry><material name="red"/></visual>
<collision><geometry><box size=".4 .4 .4"/></geometry></collision></link>
<link name="b"><visual><geometry><box size=".02 .4 .4"/></geometry></visual></link>
<link name="c"><visual><geometry><sphere radius=".1"/></geometry></visual></link>
<joint name="d" type="revolute"><parent link="a"/><child link="b"/><origin xyz=".2 -.2 0" rpy="0 0 .1"/>
<axis xyz="0 0 -1"/><limit lower="-.1" upper="1.4"/></joint>
<joint name="e" type="fixed"><parent link="b"/><child link="c"/><origin xyz=".03 .1 0"/></joint></robot>"""


def models():
    """By name of the file; all of them are small."""
    boxes = {"chair.xml": owned.MJCF.replace('<include file="parts/assets.xml"/>', "").replace(
        '<geom class="hit" type="mesh" mesh="slab" mass="1"/>', ""), "bin.sdf": SDF, "cabinet.urdf": URDF}
    return targets._models() | {f"own_{name}": text.encode() for name, text in boxes.items()} | {
        f"a{k}.gltf": gltf.body(gltf.CORNERS, gltf.FACES, gap=4 * k) for k in range(2)}


def altered(data, rng):
    """A file as it is, with a number another, without an attribute, or with its bytes spoilt."""
    text, how = data.decode(), rng.randrange(4)
    if how == 0:
        return spoilt_bytes(data, rng)
    found = list((NUMBER if how < 3 else ATTRIBUTE).finditer(text)) or [re.match("", text)]
    one = rng.choice(found)
    return (text[: one.start()] + (rng.choice(OTHERS) if how < 3 else "") + text[one.end():]).encode()


@pytest.mark.parametrize("part", range(3))
def test_altered_models(part, tmp_path):
    found = {}
    for name, data in sorted(models().items())[part::3]:
        rng, told = Random(name), []
        for k in range(25):
            file = tmp_path / name
            file.write_bytes(altered(data, rng) if k else data)
            reader = folder if name.endswith((".obj", ".gltf")) else simobjects
            try:
                told.append([plain(source, tmp_path) for source in reader.assets(tmp_path)])
            except ApartgenError as error:
                told.append(str(error).replace(str(tmp_path), ""))
            file.unlink()
        found[name] = told
    kept.same("retrieve", f"altered {part}", found)


def test_altered_plans(tmp_path):
    home, found = homes.furnished(homes.NAMES[0], 1), {}
    for name, data in {"roomplan.json": writers.roomplan(home), "procthor.json": writers.procthor(home)}.items():
        rng, told = Random(name), []
        for _ in range(9):
            try:
                told.append(imports.read(name, altered(data, rng), PlanConfig()))
            except ApartgenError as error:
                told.append(str(error))
        found[name] = told
    kept.same("plan", "altered", found)


def test_libraries_of_models(shop, tmp_path):  # noqa: F811
    """An index of sound and of broken models, and what is taken of it."""
    for name, (data, _) in BAD.items():
        (shop / name).write_bytes(data)
    (shop / "stool.obj").write_text(f"mtllib s.mtl\nusemtl a\n{(shop / 'wardrobe.obj').read_text()}")
    (shop / "s.mtl").write_text("newmtl a\nKd 0.2 0.3 0.4\nmap_Kd s.png\n")
    Image.new("RGB", (8, 8), (200, 100, 50)).save(shop / "s.png")
    report, out = build(shop, "folder", tmp_path / "lib"), tmp_path / "lib"
    library = IndexedLibrary(out, RetrieveConfig(libraries=[str(out)]))
    rng, asked = np.random.default_rng(2), []
    for kind in ("sofa", "wardrobe", "stool", "piano"):
        for _ in range(6):
            size = np.multiply((0.9, 1.7, 0.8) if kind == "sofa" else (0.6, 1.5, 2.0), rng.uniform(0.9, 1.15, 3))
            asked.append(library.nearest(kind, size, (), size * rng.uniform(0.95, 1.2)))
    broken = [[one.id, re.sub(r"\\S*/", "", one.reason)] for one in report.broken]
    kept.same("retrieve", "library", {"report": [report.name, report.indexed, broken], "asked": asked, "files": [
        (path.name, len(path.read_bytes()) if path.suffix == ".json" else "") for path in sorted(out.rglob("*"))]})


@pytest.mark.parametrize("name", ["sofa", "wardrobe", "table_lamp"])
def test_stored_models(name, tmp_path):
    """Written and read; and the field of colours and insides that its latent is made of."""
    found = {}
    for k, style in enumerate(furniture.styles(name)[:2]):
        asset = furniture.build(name, style, TABLE[name].size, k)
        store.write(asset, tmp_path / "a.safetensors")
        found[style] = [plain(Stored(store.read(tmp_path / "a.safetensors")), tmp_path), fields.field(asset)[::7]]
    kept.same("retrieve", f"stored {name}", found)


class Stored:
    """An asset as a source of it."""

    def __init__(self, asset):
        self.load = lambda: asset


def test_numbers_of_gltf():
    """In every type, with gaps and turned nodes."""
    found = {}
    for points in gltf.NUMBERS:
        for k in range(3):
            rng = np.random.default_rng(k)
            turn = rng.normal(size=4)
            nodes = [{"children": [1], "translation": rng.normal(size=3).tolist()},
                     {"mesh": 0, "rotation": (turn / np.linalg.norm(turn)).tolist(),
                      "scale": rng.uniform(0.5, 2, 3).tolist()}]
            data = json.loads(gltf.body(gltf.CORNERS * [2, 3, 5], gltf.FACES, points, gap=4 * k, lead=4 * (k % 2),
                                        normalized=points != 5126 and k == 2, nodes=nodes))
            try:
                tree = gltf.read(json.dumps(data | {"scenes": [{"nodes": [0]}]}).encode())
                found[f"{points} {k}"] = [[piece.vertices, piece.faces] for root in tree for piece in root.all()]
            except (ApartgenError, ValueError) as error:
                found[f"{points} {k}"] = str(error)
    kept.same("retrieve", "numbers of gltf", found)
