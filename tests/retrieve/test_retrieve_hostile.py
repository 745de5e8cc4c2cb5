"""Files made to fill memory or lead astray are refused by every reader, by name, without a traceback."""

import json
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest

from apartgen.stages.retrieve.reading import limits, pieces
from apartgen_cli.main import status

STL = b"by hand".ljust(80) + struct.pack("<I", 20) + struct.pack("<12fH", 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0) * 20
NAN = b"by hand".ljust(80) + struct.pack("<I", 1) + struct.pack("<12fH", 0, 0, 0, np.nan, 0, 0, 1, 0, 0, 0, 1, 0.5, 0)
LAUGHS = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10 if i else "lol"}">' for i in range(12))
BOMB = "<?xml version='1.0'?><!DOCTYPE x [" + LAUGHS + "]><{}>&l11;</{}>"
CATALOGUE = "id#1=a\nname#1=a\nmodel#1=/{}\nwidth#1=10\ndepth#1=10\nheight#1=10\n"


def told(root: Path, kind: str, capsys) -> str:
    """What `assets check` says of a folder in which all is broken."""
    assert status(["assets", "check", str(root), "--as", kind]) == 1
    said = capsys.readouterr().err
    assert "Traceback" not in said and "0 assets can be indexed" in said
    return said


def robot(mesh: str, times: int = 1) -> str:
    shown = f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>' * times
    return f'<robot name="a"><link name="b">{shown}</link></robot>'


def gltf(**about) -> str:
    return json.dumps({"asset": {"version": "2.0"}} | about)


def archive(path: Path, **members: bytes | str) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, data in members.items():
            file.writestr(name, data)


@pytest.mark.parametrize("name, text", [
    ("a.urdf", BOMB.format("robot", "robot")), ("a.sdf", BOMB.format("sdf", "sdf")),
    ("a.xml", BOMB.format("mujoco", "mujoco")),
    ("a.urdf", '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot>&x;</robot>'),
])  # fmt: skip
def test_xml_bombs_and_outside_entities(tmp_path, capsys, name, text):
    (tmp_path / name).write_text(text)
    assert "document type or entities" in told(tmp_path, "simobjects", capsys)


def test_partnet_and_future_refuse_what_the_others_do(tmp_path, capsys):
    for name, text in (("1", BOMB.format("robot", "robot")), ("2", robot("../../../../../etc/passwd"))):
        (tmp_path / "gap" / name).mkdir(parents=True)
        (tmp_path / "gap" / name / "mobility.urdf").write_text(text)
    said = told(tmp_path / "gap", "gapartnet", capsys)
    assert "document type or entities" in said and "outside its library" in said
    (tmp_path / "future" / "a").mkdir(parents=True)
    (tmp_path / "future" / "a" / "raw_model.obj").symlink_to("/etc/passwd")
    (tmp_path / "future" / "b").mkdir()
    (tmp_path / "future" / "b" / "raw_model.obj").write_text("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    said = told(tmp_path / "future", "future3d", capsys)
    assert "outside its library" in said and "a: " in said and "b: " in said


def test_vertices_that_are_no_numbers_in_every_mesh_format(tmp_path, capsys):
    (tmp_path / "m.stl").write_bytes(NAN)
    (tmp_path / "a.urdf").write_text(robot("m.stl"))
    seen = '<visual name="v"><geometry><mesh><uri>m.stl</uri></mesh></geometry></visual>'
    (tmp_path / "b.sdf").write_text(f'<sdf version="1.6"><model name="b"><link name="l">{seen}</link></model></sdf>')
    assert told(tmp_path, "simobjects", capsys).count("not finite") == 2
    archive(tmp_path / "c.sh3f", **{"PluginFurnitureCatalog.properties": CATALOGUE.format("a.obj"),
                                    "a.obj": "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"})  # fmt: skip
    assert "not finite" in told(tmp_path, "sweethome3d", capsys)


@pytest.mark.parametrize("width", ["0", "-20"])
def test_a_piece_without_width_is_none(tmp_path, capsys, width):
    catalogue = CATALOGUE.format("a.obj").replace("width#1=10", f"width#1={width}")
    assert f"width#1={width}" in catalogue
    archive(tmp_path / "a.sh3f", **{"PluginFurnitureCatalog.properties": catalogue,
                                    "a.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"})  # fmt: skip
    assert "dimensions of" in told(tmp_path, "sweethome3d", capsys)


def test_a_small_mesh_shown_very_often_counts_as_often(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(pieces, "FACES", 100)
    (tmp_path / "m.stl").write_bytes(STL)
    (tmp_path / "a.urdf").write_text(robot("m.stl", 6))
    seen = '<visual name="v"><geometry><mesh><uri>m.stl</uri></mesh></geometry></visual>'
    links = "".join(f'<link name="l{i}">{seen}</link>' for i in range(6))
    (tmp_path / "b.sdf").write_text(f'<sdf version="1.6"><model name="b">{links}</model></sdf>')
    geoms = '<geom type="mesh" mesh="m"/>' * 6
    (tmp_path / "c.xml").write_text('<mujoco><asset><mesh name="m" file="m.stl"/></asset><worldbody><body>'
                                    f"{geoms}</body></worldbody></mujoco>")  # fmt: skip
    assert told(tmp_path, "simobjects", capsys).count("120 faces") == 3
    data = np.zeros((3, 3), "<f4").tobytes() + np.zeros(60, "<u2").tobytes()
    (tmp_path / "x.bin").write_bytes(data)
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                 {"bufferView": 1, "componentType": 5123, "count": 60, "type": "SCALAR"}]  # fmt: skip
    (tmp_path / "d.gltf").write_text(gltf(
        scenes=[{"nodes": list(range(6))}], nodes=[{"mesh": 0}] * 6, accessors=accessors,
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        buffers=[{"uri": "x.bin", "byteLength": len(data)}],
        bufferViews=[{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 120}],
    ))  # fmt: skip
    assert "120 faces" in told(tmp_path, "folder", capsys)


def test_text_with_too_many_values_or_elements_is_not_even_parsed(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(limits, "VALUES", 1000)
    monkeypatch.setattr(limits, "ELEMENTS", 1000)
    (tmp_path / "a.gltf").write_text('{"asset":[' + "[]," * 2000 + "[]]}")
    (tmp_path / "b.urdf").write_text("<robot>" + "<a/>" * 3000 + "</robot>")
    assert "1000 values" in told(tmp_path, "folder", capsys)
    assert "1000 elements" in told(tmp_path, "simobjects", capsys)


def test_deep_nesting_is_refused(tmp_path, capsys):
    (tmp_path / "a.gltf").write_text("[" * 100_000)
    assert "a: " in told(tmp_path, "folder", capsys)


@pytest.mark.parametrize("around", [
    "<mujoco><worldbody>{}</worldbody></mujoco>", "<mujoco><default>{}</default></mujoco>",
    "<robot name='r'>{}</robot>"])
@pytest.mark.parametrize("tag", ["body", "default", "link"])
def test_any_elements_a_hundred_thousand_deep(tmp_path, capsys, around, tag):
    deep = f"<{tag}>" * 100_000 + f"</{tag}>" * 100_000
    (tmp_path / "m.xml").write_text(around.format(deep))
    (tmp_path / "m.urdf").write_text(around.format(deep))
    assert "elements in one another" in told(tmp_path, "simobjects", capsys)


def test_one_file_named_as_many_buffers_counts_as_often(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(limits, "FILE_BYTES", 1000)
    (tmp_path / "x.bin").write_bytes(b"\0" * 400)
    (tmp_path / "a.gltf").write_text(gltf(buffers=[{"uri": "x.bin", "byteLength": 400}] * 10))
    assert "buffers of more than" in told(tmp_path, "folder", capsys)


def test_archives_within_archives_and_endless_lists_of_members(tmp_path, capsys, monkeypatch):
    archive(tmp_path / "inner.zip", **{"../../evil.obj": "v 0 0 0"})
    archive(tmp_path / "nested.sh3f", **{"PluginFurnitureCatalog.properties": CATALOGUE.format("a.zip"),
                                         "a.zip": (tmp_path / "inner.zip").read_bytes()})  # fmt: skip
    archive(tmp_path / "inside.sh3f", **{"PluginFurnitureCatalog.properties": CATALOGUE.format("a.obj"),
                                         "a.obj": b"\0" * 5_000_000})  # fmt: skip
    said = told(tmp_path, "sweethome3d", capsys)
    assert "out of the archive" in said and "unpacks from" in said
    monkeypatch.setattr(limits, "DIRECTORY_BYTES", 1000)
    archive(tmp_path / "nested.sh3f", **{f"m{i}": "" for i in range(100)})
    assert "lists its members in" in told(tmp_path, "sweethome3d", capsys)


def test_material_files_and_lines_of_any_length_are_not_read(tmp_path, capsys):
    (tmp_path / "long.mtl").write_bytes(b"newmtl a\n" * 600_000)
    (tmp_path / "a.obj").write_text("mtllib long.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (tmp_path / "b.obj").write_bytes(b"\0" * 3_000_000)
    said = told(tmp_path, "folder", capsys)
    assert "material file of" in said and "b.obj: line 1 is longer" in said
