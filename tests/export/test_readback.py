"""What a format's own reader refuses is no export: an error says so, and nothing is left or lost."""

import io
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from export import sample
from PIL import Image

from apartgen.schemas.errors import BadInput
from apartgen.stages import export, registry
from apartgen.stages.export import _readback
from apartgen.stages.things.asset import Material, Mesh

FORMATS = list(export.formats())
load = registry.load


def _spoilt(name, spoil):
    """A format that spoils the first of its files, before it is read."""
    own = load(export.PACKAGE, name)

    def write(scene, out):
        files = own.write(scene, out)
        spoil(files[0])
        return files

    return SimpleNamespace(write=write, read_back=own.read_back)


def _halved(file: Path):
    data = file.read_bytes()
    file.write_bytes(data[:len(data) // 2])


@pytest.mark.parametrize("name", FORMATS)
def test_a_file_that_breaks_off_is_refused_and_the_earlier_export_stays(name, tmp_path, monkeypatch):
    if not hasattr(load(export.PACKAGE, name), "read_back"):
        pytest.skip("brings no reader of its own")
    out = tmp_path / "scene"
    export.run(sample.home(), ["svg"], out, sample.load)
    before = {path: path.read_bytes() for path in out.rglob("*") if path.is_file()}
    monkeypatch.setattr(export.registry, "load", lambda package, wanted: _spoilt(wanted, _halved))
    with pytest.raises(BadInput, match=rf"format {name}: its own reader refuses .*leave the format out") as caught:
        export.run(sample.home(), [name], out, sample.load)
    assert str(tmp_path) not in str(caught.value) and "\n" not in str(caught.value)
    assert {path: path.read_bytes() for path in out.rglob("*") if path.is_file()} == before
    assert [path.name for path in tmp_path.iterdir()] == ["scene"]


@pytest.mark.parametrize("name", ["dxf", "glb", "ifc", "mjcf", "nav2", "png", "sdf", "svg", "urdf", "usd"])
def test_what_other_programs_load_is_read_back(name):
    assert callable(load(export.PACKAGE, name).read_back)


@pytest.mark.parametrize("name,old,new", [
    ("mjcf", 'type="hinge"', 'type="henge"'), ("urdf", '<parent link="', '<parent link="no_'),
    ("sdf", '<uri>meshes/', '<uri>no/'), ("sdf", 'model name="chair_7"', 'model name="bin_12"'),
    ("nav2", "resolution:", "size:"),
])
def test_what_is_whole_but_wrong_is_refused(name, old, new, tmp_path, monkeypatch):
    def spoil(file):
        text = file.read_text()
        assert old in text
        file.write_text(text.replace(old, new))

    monkeypatch.setattr(export.registry, "load", lambda package, wanted: _spoilt(wanted, spoil))
    with pytest.raises(BadInput, match=f"format {name}: its own reader refuses"):
        export.run(sample.home(), [name], tmp_path / "scene", sample.load)
    assert not list(tmp_path.iterdir())


def test_a_format_of_another_package_needs_no_reader(tmp_path, monkeypatch):
    def write(scene, out):
        (out / "plain.txt").write_text(f"{len(scene.home.rooms)} rooms")
        return [out / "plain.txt"]

    monkeypatch.setattr(export.registry, "load", lambda package, wanted: SimpleNamespace(write=write))
    monkeypatch.setattr(export.registry, "stated", lambda package, name, fact, usual: usual)
    made = export.run(sample.home(), ["plain"], tmp_path / "scene", sample.load)
    assert "plain.txt" in {file.path for file in made.files}


@pytest.mark.parametrize("name", ["mjcf", "usd", "glb", "urdf", "sdf"])
def test_two_libraries_may_have_one_image(name, tmp_path):
    """Under two paths, and another image under the same file name besides."""
    for folder, shade in (("a", 90), ("b", 90), ("c", 200)):
        (tmp_path / folder).mkdir()
        Image.fromarray(np.full((8, 8, 3), shade, np.uint8)).save(tmp_path / folder / "wood.png")
    images = {"sofa": "a", "coffee_table": "b", "chair": "c"}

    def painted(library, id):
        asset = sample.load(library, id)
        if id not in images:
            return asset
        wood = Material("wood", texture=str(tmp_path / images[id] / "wood.png"))
        base, *parts = asset.links
        seen = [Mesh(mesh.vertices, mesh.faces, wood, mesh.vertices[:, :2]) for mesh in base.visuals]
        return replace(asset, links=[replace(base, visuals=seen), *parts])

    made = export.run(sample.home(), [name], tmp_path / "scene", painted)
    pictures = [file for file in made.files if Path(file.path).name.startswith("texture_")]
    assert name == "glb" or len(pictures) == len({file.sha256 for file in pictures}) == 2


@pytest.mark.parametrize("last, sound", [(2, True), (3, False), (7, False)])
def test_faces_name_vertices_that_there_are(last, sound):
    """Three vertices; in the bytes of the file the last index of the one face is another."""
    corners, face = np.eye(3), np.array([0, 1, 2], np.uint32)
    data = bytearray(trimesh.Trimesh(corners, face[None], process=False).export(file_type="glb"))
    at = data.rindex(face.tobytes())
    data[at:at + 12] = np.array([0, 1, last], np.uint32).tobytes()
    if sound:
        _readback.read_glb([io.BytesIO(bytes(data))])
    else:
        with pytest.raises(_readback.Refused, match="without vertices"):
            _readback.read_glb([io.BytesIO(bytes(data))])


@pytest.mark.parametrize("error, told", [
    (ValueError("no such joint\nin line 3"), "(no such joint)"), (ValueError(), "(ValueError)"),
])
def test_what_a_reader_minds_is_told_by_its_first_line_or_its_name(error, told):
    def refuse(files):
        raise error

    with pytest.raises(BadInput) as found:
        export._read_back("mine", SimpleNamespace(read_back=refuse), [], Path("nowhere"))
    assert told in str(found.value) and found.value.__cause__ is error


def test_what_nothing_defines_is_refused(tmp_path):
    """A prim that is only written over; whoever opens the stage would not see it."""
    usd = pytest.importorskip("pxr.Usd")
    stage = usd.Stage.CreateInMemory()
    stage.SetDefaultPrim(stage.DefinePrim("/Home", "Xform"))
    stage.GetRootLayer().Export(str(tmp_path / "whole.usda"))
    load(export.PACKAGE, "usd").read_back([tmp_path / "whole.usda"])
    stage.OverridePrim("/Home/chair")
    stage.GetRootLayer().Export(str(tmp_path / "over.usda"))
    with pytest.raises(_readback.Refused, match="not defined"):
        load(export.PACKAGE, "usd").read_back([tmp_path / "over.usda"])
