"""Every format by itself: replaced whole or not at all, credits inside, nothing that leads out of its folder."""

import errno
import json
import os
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from export import readers, sample

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.scene.scene import Scene

FORMATS = [name for name in export.formats() if export.needs_assets(name) and name != "view"]
"""Formats that hold assets; drawings and plans have nothing to credit or to name."""
SIMULATORS = {"mjcf", "usd", "urdf", "sdf", "glb", "habitat"}
CREDIT = "Plain boxes, public domain"


def test_what_simulators_load_holds_assets():
    assert set(FORMATS) >= SIMULATORS


def _broken(library, id):
    if id == "bath":
        raise BadInput("no such asset")
    return sample.load(library, id)


@pytest.fixture(scope="module", params=FORMATS)
def kept(request, tmp_path_factory):
    """A format and the folder of an export in it."""
    out = tmp_path_factory.mktemp(request.param) / "scene"
    export.run(sample.home(), [request.param], out, sample.load)
    return request.param, out


def test_a_failure_half_way_leaves_the_earlier_export(kept, monkeypatch):
    def fail(_):
        raise BadInput("the lights went out")

    name, out = kept
    before = {p: p.read_bytes() for p in out.rglob("*") if p.is_file()}
    monkeypatch.setattr(Scene, "lights", property(fail))
    monkeypatch.setattr(Scene, "credits", property(fail))
    with pytest.raises(BadInput, match="lights went out"):
        export.run(sample.home(), [name], out, sample.load)
    assert {p: p.read_bytes() for p in out.rglob("*") if p.is_file()} == before
    assert [p.name for p in out.parent.iterdir()] == ["scene"]


def test_an_asset_that_is_missing_leaves_nothing(tmp_path):
    for name in FORMATS:
        with pytest.raises(BadInput, match="no such asset"):
            export.run(sample.home(), [name], tmp_path / name, _broken)
    assert list(tmp_path.iterdir()) == []


def test_a_place_that_cannot_be_written_is_an_error_that_names_it(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    for place in ("/proc/scene", tmp_path / "file" / "below" / "scene"):
        with pytest.raises(BadInput, match=rf"{place}: cannot be written \(.+\); give another folder"):
            export.run(sample.home(), ["svg"], Path(place), sample.load)

    def full(*_, **__):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(BadInput, match="No space left"):
        export.run(sample.home(), ["svg"], tmp_path / "scene", sample.load)
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


def test_credits_go_along(kept):
    _, out = kept
    assert CREDIT in (out / "CREDITS.txt").read_text()


def test_every_file_that_is_named_is_inside(kept):
    _, out = kept
    named = [(file, text) for file in out.rglob("*") if file.is_file() for text in _named(file)]
    for file, text in named:
        assert not text.startswith("/") and "://" not in text, (file.name, text)
        there = (file.parent / text).resolve()
        assert there.is_file() and out.resolve() in there.parents, (file.name, text)


def _named(file):
    """Other files that a file names, as it names them."""
    if file.suffix == ".xml":
        root = ElementTree.parse(file).getroot()
        assert not {"meshdir", "texturedir", "assetdir"} & set(root.find("compiler").attrib)
        return [e.get("file") for e in root.iter() if e.get("file")]
    if file.suffix == ".urdf":
        return [e.get("filename") for e in ElementTree.parse(file).iter() if e.get("filename")]
    if file.suffix == ".sdf":
        return [e.text for e in ElementTree.parse(file).iter() if e.tag in ("uri", "albedo_map")]
    if file.suffix in (".obj", ".mtl"):
        return re.findall(r"^(?:mtllib|map_Kd) (.+)$", file.read_text(), re.MULTILINE)
    if file.suffix == ".glb":
        made = readers.document(file)
        return [part["uri"] for part in made.get("images", []) + made["buffers"] if "uri" in part]
    if file.name.endswith("_config.json"):
        return [v for k, v in json.loads(file.read_text()).items() if k.endswith("_asset")]
    if file.suffix == ".yaml" and file.with_suffix(".pgm").exists():
        return re.findall(r"^image: (.+)$", file.read_text(), re.MULTILINE)
    if file.suffix == ".usd":
        from pxr import Sdf

        layer = Sdf.Layer.FindOrOpen(str(file))
        return [layer.GetAttributeAtPath(path).default.path for path in _assets(layer)]
    return []


def _assets(layer):
    from pxr import Sdf

    found = []
    layer.Traverse("/", lambda path: found.append(path) if path.IsPropertyPath() else None)
    return [p for p in found if isinstance(layer.GetAttributeAtPath(p) and layer.GetAttributeAtPath(p).default,
                                           Sdf.AssetPath)]
