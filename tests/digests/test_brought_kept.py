"""What is made of files and replies that others write, sound ones and spoilt ones, as it was."""

import dataclasses
import json
from pathlib import Path
from random import Random

import numpy as np
import pytest
from digests import kept
from export import sample
from fuzz import spoil
from plan.imports import test_dxf_by_hand, test_ifc_by_hand
from plan.llm import test_replies
from retrieve import test_retrieve_owned as owned
from retrieve.test_retrieve_owned import future, partnet, sh3f  # noqa: F401
from walkable import test_rearrange

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.plan import PlanConfig, imports
from apartgen.stages.plan.llm import answers
from apartgen.stages.plan.llm.model import Answer
from apartgen.stages.retrieve import future3d, gapartnet, simobjects, sweethome3d
from apartgen.stages.retrieve.reading.source import Broken

pytestmark = pytest.mark.wide


def plain(source, folder):
    """An asset without the folder that its pictures lie in, or what is wrong with it."""
    try:
        asset = source.load()
    except Broken as error:
        return str(error).replace(str(folder), "")
    def bare(material):
        return dataclasses.replace(material, texture=Path(material.texture or "").name)

    links = [[dataclasses.replace(link, visuals=[]), [[mesh.vertices, mesh.faces, bare(mesh.material)]
                                                      for mesh in link.visuals]] for link in asset.links]
    return [dataclasses.replace(asset, links=[]), links]


def test_libraries(partnet, future, sh3f, tmp_path):  # noqa: F811
    found = {}
    for name, sources in (("gapartnet", gapartnet.assets(partnet)), ("future3d", future3d.assets(future)),
                          ("sweethome3d", sweethome3d.assets(sh3f))):
        found |= {f"{name} {source.id}": plain(source, tmp_path) for source in sources}
    kept.same("retrieve", "libraries", found)


@pytest.mark.parametrize("front", ["auto", "x", "-y"])
def test_simulated_things(front, tmp_path):
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "slab.stl").write_bytes(owned.stl((0, -0.02, -0.4), (0.4, 0.02, 0.4)))
    (tmp_path / "parts" / "assets.xml").write_text(
        '<mujocoinclude><asset><mesh name="slab" file="parts/slab.stl"/></asset></mujocoinclude>')
    (tmp_path / "cupboard.xml").write_text(owned.MJCF)
    options = {} if front == "auto" else {"front": front}
    kept.same("retrieve", f"simulated {front}", {
        source.id: plain(source, tmp_path) for source in simobjects.assets(tmp_path, **options)})


def read(name, data):
    """The plan, or why there is none."""
    try:
        return imports.read(name, data, PlanConfig())
    except BadInput as error:
        return str(error)


def test_drawings_by_hand():
    pytest.importorskip("ezdxf")
    pytest.importorskip("ifcopenshell")
    found = {f"dxf {unit}": read("plan.dxf", test_dxf_by_hand.flat(unit)) for unit in (0, 4)}
    found |= {f"ifc {spaces}": read("plan.ifc", test_ifc_by_hand.model(spaces)) for spaces in (False, True)}
    kept.same("plan", "drawings by hand", found)


@pytest.mark.parametrize("format", ["dxf", "ifc"])
def test_our_drawings(format, tmp_path):
    pytest.importorskip({"dxf": "ezdxf", "ifc": "ifcopenshell"}[format])
    found = {}
    for name, home, load in (("sample", sample.home(), sample.load), ("flat", kept.home("flat"), kept.load)):
        made = export.run(home, [format], tmp_path / name, load)
        (path,) = (file.path for file in made.files if file.path.endswith(f".{format}"))
        found[name] = read(f"home.{format}", (tmp_path / name / path).read_bytes())
    kept.same("plan", f"our {format}", found)


def test_replies_of_models():
    """Replies of the tests of the reader by a model, and those of them with a fault or cut off."""
    rng, found = Random(3), []
    whole = [*test_replies.GOOD, *(text for text, _ in test_replies.BROKEN), *test_replies.DECLINED]
    some = [*whole, *(text[: rng.randrange(1, len(text))] for text in whole if text.strip())]
    for _ in range(120):
        body = {"program": test_replies.flat(
            total_area=rng.choice([None, 50, -3]), counts={"kitchen_1": rng.choice([0, 60, 61])},
            weights={rng.choice([*answers.TERMS, "beauty"]): 2.0}, requirements=[{
                "id": "asked_1", "kind": rng.choice(sorted(answers.KINDS)), "text": "",
                "of": rng.choice(["home", "kitchen_1", "x"]), "to": rng.choice([None, "entrance", "bedroom_1", "x"]),
                "value": rng.choice(["north", "largest", "3 x 4", "3.5 x", 12, "bedroom", None])}])}
        some.append(json.dumps(body if rng.random() < 0.6 else spoil.spoilt(body, rng)))
    for k, text in enumerate(some):
        try:
            found.append(answers.programme(Answer(text, cut_off=k % 5 == 0)))
        except (answers.Broken, answers.Declined) as error:
            found.append([type(error).__name__, str(error)])
    kept.same("plan", "replies", {"all": found, "schema": answers.reply_schema(), "told": answers.instructions()})


@pytest.mark.parametrize("depth", [1.97, 2.02, 2.1])
def test_rooms_planned_anew(depth):
    found = {}
    for narrower in np.arange(0, 0.07, 0.03).round(2).tolist():
        result = test_rearrange.walk(test_rearrange.tight(depth, narrower))
        found[str(narrower)] = [result.objects, result.walkable]
    kept.same("walkable", f"planned anew {depth}", found)
