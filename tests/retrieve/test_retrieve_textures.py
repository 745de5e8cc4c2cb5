"""Colours, roughness and images of foreign models, from their files through an index into what is exported."""

import base64
import io
import json
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from apartgen.schemas.retrieve import Retrieve
from apartgen.stages.retrieve import build, folder, simobjects
from apartgen.stages.retrieve.matching.indexed import IndexedLibrary
from apartgen.stages.retrieve.matching.textures import FOLDER
from apartgen.stages.retrieve.reading import obj, pieces
from apartgen.stages.retrieve.reading.images import encoded, linear
from apartgen.stages.retrieve.reading.limits import Broken

RED, GREEN, BLUE, WHITE = (200, 30, 30), (30, 160, 40), (40, 60, 190), (250, 250, 250)
FACES = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4],
         [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]]  # fmt: skip


def png(*rows, mode="RGB") -> bytes:
    """An image of whole rows of one colour each, the first on top."""
    pixels = np.array([[row] * 8 for row in rows for _ in range(4)], np.uint8)
    buffer = io.BytesIO()
    Image.fromarray(pixels, mode).save(buffer, "PNG")
    return buffer.getvalue()


def glb(materials, images, extra=None, name="box", extent=(0.5, 0.9, 0.4)) -> bytes:
    """A box, y up, of width, height and depth `extent`; its v runs down from 0 at its top."""
    w, h, d = extent
    low = np.array([[-w / 2, -d / 2], [w / 2, -d / 2], [w / 2, d / 2], [-w / 2, d / 2]])
    corners = np.array([[x, y, z] for y in (0, h) for x, z in low], "<f4")
    uv = np.array([[0, 1]] * 4 + [[0, 0]] * 4, "<f4")
    parts = [corners.tobytes(), uv.tobytes(), np.array(FACES, "<u2")[:, ::-1].tobytes(), *images]
    views, chunk = [], b""
    for part in parts:
        chunk += b"\0" * (-len(chunk) % 4)
        views.append({"buffer": 0, "byteOffset": len(chunk), "byteLength": len(part)})
        chunk += part
    about = {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": views, "buffers": [{"byteLength": len(chunk)}], "materials": materials,
        "images": [{"bufferView": 3 + i, "mimeType": "image/png"} for i in range(len(images))],
        "textures": [{"source": i} for i in range(len(images))],
    } | (extra or {})  # fmt: skip
    text = json.dumps(about).encode()
    text += b" " * (-len(text) % 4)
    chunk += b"\0" * (-len(chunk) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(chunk), 0x004E4942) + chunk
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def surface(factor=(1, 1, 1, 1), texture=0, **more) -> dict:
    pbr = {"baseColorFactor": factor, "metallicFactor": 0.2, "roughnessFactor": 0.6} | more.pop("pbr", {})
    return {"name": "skin", "pbrMetallicRoughness": pbr | {"baseColorTexture": {"index": texture}}} | more


@pytest.fixture
def indexed(tmp_path, monkeypatch):
    """Indexes a folder and opens it; latents are left out, as they need a trained model."""
    from apartgen.stages.retrieve.shape import encoder

    monkeypatch.setattr(encoder, "latents", lambda assets: np.zeros((1, 32)))

    def made(root: Path, kind: str = "folder", **options) -> IndexedLibrary:
        assert build(root, kind, tmp_path / "lib", **options).broken == []
        return IndexedLibrary(tmp_path / "lib")

    return made


@pytest.fixture
def models(tmp_path) -> Path:
    (tmp_path / "mine").mkdir()
    return tmp_path / "mine"


def material(library: IndexedLibrary, id: str):
    return library.load_asset(id).links[0].visuals[0].material


def test_an_embedded_image_is_kept_once_with_its_factor_baked_in(models, indexed):
    image = png(RED, BLUE)
    (models / "chair_a.glb").write_bytes(glb([surface()], [image]))
    (models / "chair_b.glb").write_bytes(glb([surface()], [image]))
    (models / "chair_half.glb").write_bytes(glb([surface((0.5, 0.5, 0.5, 1))], [image]))
    library = indexed(models)
    plain, twin, half = (material(library, f"chair_{name}") for name in ("a", "b", "half"))
    assert plain.texture == twin.texture and len(list((library.folder / FOLDER).iterdir())) == 2
    assert np.asarray(Image.open(plain.texture))[:, 0].tolist() == [list(RED)] * 4 + [list(BLUE)] * 4
    assert (plain.roughness, plain.metalness) == (0.6, 0.2)
    shown = np.asarray(Image.open(half.texture))[0, 0] / 255
    assert np.allclose(linear(shown), 0.5 * linear(np.array(RED) / 255), atol=0.01)
    mean = encoded((linear(np.array(RED) / 255) + linear(np.array(BLUE) / 255)) / 2)
    assert np.allclose(plain.color[:3], mean, atol=0.01), "renderers without textures get the mean colour"


def test_the_image_lies_the_right_way_up(models, indexed):
    (models / "chair.glb").write_bytes(glb([surface()], [png(RED, BLUE)]))
    library = indexed(models)
    (mesh,) = library.load_asset("chair").links[0].visuals
    top = mesh.vertices[:, 2] > 0
    # v is counted upwards here: the image's red upper edge belongs to the object's top.
    assert np.allclose(mesh.uv[top, 1], 1) and np.allclose(mesh.uv[~top, 1], 0)


def test_a_colour_factor_is_linear_light_and_opaque_means_opaque(models, indexed):
    factor = {"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.2, 0.05, 0.3], "metallicFactor": 0}}
    (models / "chair.glb").write_bytes(glb([factor], []))
    (models / "lamp.glb").write_bytes(glb([factor | {"alphaMode": "BLEND"}], []))
    library = indexed(models)
    assert np.allclose(material(library, "chair").color, (*encoded([0.5, 0.2, 0.05]), 1.0))
    assert material(library, "lamp").color[3] == 0.3


def test_roughness_and_metalness_maps_count_by_their_means(models, indexed):
    both = surface(pbr={"metallicRoughnessTexture": {"index": 1}, "roughnessFactor": 0.5, "metallicFactor": 1.0})
    (models / "chair.glb").write_bytes(glb([both], [png(RED), png((0, 204, 51))]))
    found = material(indexed(models), "chair")
    assert found.roughness == pytest.approx(0.5 * 0.8) and found.metalness == pytest.approx(0.2)


def test_texture_transforms_and_second_coordinates_are_followed(models, indexed):
    moved = surface()
    moved["pbrMetallicRoughness"]["baseColorTexture"] |= {
        "extensions": {"KHR_texture_transform": {"offset": [0.25, 0.5], "scale": [2, 0.5]}}
    }
    (models / "chair.glb").write_bytes(glb([moved], [png(RED)]))
    (mesh,) = indexed(models).load_asset("chair").links[0].visuals
    top = mesh.vertices[:, 2] > 0
    assert np.allclose(mesh.uv[top], [0.25, 0.5]) and np.allclose(mesh.uv[~top], [0.25, 0.0])


def test_a_mask_cuts_out_and_other_alpha_is_dropped(models, indexed):
    image = png((*GREEN, 255), (*GREEN, 0), mode="RGBA")
    (models / "plant.glb").write_bytes(glb([surface(alphaMode="MASK")], [image]))
    (models / "chair.glb").write_bytes(glb([surface()], [image]))
    library = indexed(models)
    assert Image.open(material(library, "plant").texture).mode == "RGBA"
    assert Image.open(material(library, "chair").texture).mode == "RGB"


def test_what_is_no_image_leaves_the_asset_plain_and_says_so(models, indexed, caplog):
    (models / "chair.glb").write_bytes(glb([surface()], [b"no image at all"]))
    with caplog.at_level("WARNING", "apartgen"):
        found = material(indexed(models), "chair")
    assert found.texture is None and "chair: material skin" in caplog.text


def test_an_image_bomb_is_refused_before_it_is_decoded(models, indexed, caplog):
    header = struct.pack(">IIBBBBB", 9_000, 12_000, 8, 2, 0, 0, 0)
    small = png(RED)
    bomb = small[:16] + header + struct.pack(">I", zlib.crc32(b"IHDR" + header)) + small[33:]
    (models / "chair.glb").write_bytes(glb([surface()], [bomb]))
    with caplog.at_level("WARNING", "apartgen"):
        assert material(indexed(models), "chair").texture is None
    assert "9000 x 12000" in caplog.text


def test_obj_materials_bring_images_with_blanks_in_their_names_and_physical_values(models, indexed):
    (models / "oak light.png").write_bytes(png(GREEN, WHITE))
    (models / "chair.mtl").write_text(
        "newmtl a\nKd 0.1 0.1 0.1\nPr 0.3\nPm 0.9\nmap_Kd -s 2 2 1 -clamp on oak light.png\n"
    )
    box = [(x, y, z) for x in (0, 0.5) for y in (0, 0.9) for z in (0, 0.5)]
    lines = ["mtllib chair.mtl", *(f"v {x} {y} {z}" for x, y, z in box), "vt 0 0", "vt 1 1", "usemtl a"]
    quads = [[1, 2, 4, 3], [5, 7, 8, 6], [1, 5, 6, 2], [3, 4, 8, 7], [1, 3, 7, 5], [2, 6, 8, 4]]
    (models / "chair.obj").write_text("\n".join([*lines, *("f " + " ".join(f"{i}/1" for i in q) for q in quads)]))
    found = material(indexed(models), "chair")
    assert (found.roughness, found.metalness) == (0.3, 0.9)
    assert np.asarray(Image.open(found.texture))[0, 0].tolist() == list(GREEN), "the map is not darkened by Kd"


def test_sweet_home_keeps_the_images_within_its_archive(tmp_path, indexed):
    import zipfile

    catalogue = "id#1=chair\nname#1=Chair\nmodel#1=/m/chair.obj\nwidth#1=50\ndepth#1=50\nheight#1=90\n"
    corners = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
    faces = "".join(
        f"f {' '.join(f'{i}/1' for i in q)}\n" for q in ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7))
    )
    with zipfile.ZipFile(tmp_path / "shop.sh3f", "w") as archive:
        archive.writestr("PluginFurnitureCatalog.properties", catalogue)
        archive.writestr("m/chair.obj", f"mtllib chair.mtl\n{corners}vt 0 0\nusemtl a\n{faces}")
        archive.writestr("m/chair.mtl", "newmtl a\nmap_Kd cloth.png\n")
        archive.writestr("m/cloth.png", png(BLUE))
    found = material(indexed(tmp_path / "shop.sh3f", "sweethome3d"), "shop/chair")
    assert np.asarray(Image.open(found.texture))[0, 0].tolist() == list(BLUE)


def test_urdf_sdf_and_mjcf_materials(tmp_path):
    mesh = "\n".join(["v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 0 1", "vt 0 0", "vt 1 0", "vt 1 1",
                      "f 1/1 3/2 2/3", "f 1/1 2/2 4/3", "f 2/1 3/2 4/3", "f 3/1 1/2 4/3"])  # fmt: skip
    (tmp_path / "wedge.obj").write_text(mesh)
    (tmp_path / "wood.png").write_bytes(png(RED))
    seen = '<visual name="v"><geometry><mesh{}</geometry>{}</visual>'
    (tmp_path / "stool_a.urdf").write_text(
        '<robot name="a"><link name="base">' + seen.format(' filename="wedge.obj"/>',
        '<material name="w"><texture filename="wood.png"/></material>') + "</link></robot>"
    )  # fmt: skip
    (tmp_path / "stool_b.sdf").write_text(
        '<sdf version="1.9"><model name="stool_b"><link name="base">' + seen.format("><uri>wedge.obj</uri></mesh>",
        "<material><diffuse>1 1 1 1</diffuse><pbr><metal><albedo_map>wood.png</albedo_map><roughness>0.25</roughness>"
        "<metalness>0.5</metalness></metal></pbr></material>") + "</link></model></sdf>"
    )  # fmt: skip
    (tmp_path / "stool_c.xml").write_text(
        '<mujoco><asset><texture name="t" type="2d" file="wood.png"/><texture name="f" builtin="flat" rgb1="0 .5 1"/>'
        '<material name="w" texture="t" roughness=".4" metallic=".1"/><material name="g" texture="f" rgba="1 .5 .5 1"/>'
        '<mesh name="m" file="wedge.obj"/></asset><worldbody><body name="stool_c">'
        '<geom type="mesh" mesh="m" material="w"/>'
        '<geom type="box" size=".1 .1 .1" material="g"/></body></worldbody></mujoco>'
    )
    found = {s.id: [m.material for m in s.load().links[0].visuals] for s in simobjects.assets(tmp_path)}
    image = str(tmp_path / "wood.png")
    assert found["stool_a"][0].texture == image
    assert (found["stool_b"][0].texture, found["stool_b"][0].roughness, found["stool_b"][0].metalness) == (
        image,
        0.25,
        0.5,
    )
    skin, plain = found["stool_c"]
    assert (skin.texture, skin.roughness, skin.metalness) == (image, 0.4, 0.1)
    assert plain.texture is None and plain.color == (0.0, 0.25, 0.5, 1.0)


def test_a_library_file_names_no_image_outside_its_folder(models, indexed, tmp_path):
    (models / "chair.glb").write_bytes(glb([surface()], [png(RED)]))
    library = indexed(models)
    file = next((library.folder / "assets").iterdir())
    data = file.read_bytes()
    name = Path(material(library, "chair").texture).name
    away = "../../secret.png".ljust(len(name))[: len(name)]
    file.write_bytes(data.replace(name.encode(), away.encode()))
    assert Path(material(library, "chair").texture).parent == (library.folder / FOLDER).resolve()


@pytest.fixture
def home(models, indexed, flat) -> tuple[Retrieve, IndexedLibrary]:
    """A room with one imported chair in it."""
    (models / "chair.glb").write_bytes(glb([surface((1, 0.5, 1, 1), alphaMode="OPAQUE")], [png(WHITE, GREEN)]))
    (models / "License.txt").write_text("Chairs by A. Maker\nCC-BY 4.0\n")
    library = indexed(models)
    asset = library.load_asset("chair")
    size = list(asset.size)
    layout = flat({"category": "chair", "center": [2, 2, size[2] / 2], "size": size})
    placed = layout.objects[0].model_dump() | {"asset": {"library": library.name, "id": "chair"}, "joints": []}
    return Retrieve.model_validate(layout.model_dump() | {"objects": [placed]}), library


def test_exports_carry_image_surface_and_credit(home, tmp_path):
    from apartgen.stages import export

    written, library = home
    out = tmp_path / "scene"
    found = export.run(written, ["glb", "mjcf"], out, lambda _, id: library.load_asset(id))
    assert any("CC-BY" in credit for credit in found.credits)
    data = next(out.rglob("*.glb")).read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    about, chunk = json.loads(data[20 : 20 + length]), data[28 + length :]
    skin = next(m for m in about["materials"] if m["name"] == "skin")["pbrMetallicRoughness"]
    view = about["bufferViews"][
        about["images"][about["textures"][skin["baseColorTexture"]["index"]]["source"]]["bufferView"]
    ]
    image = np.asarray(Image.open(io.BytesIO(chunk[view["byteOffset"] :][: view["byteLength"]])))
    assert skin["roughnessFactor"] == 0.6 and skin["metallicFactor"] == 0.2
    assert np.allclose(linear(image[0, 0] / 255), linear(np.array(WHITE) / 255) * (1, 0.5, 1), atol=0.01)
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(next((out / "mjcf").glob("*.xml"))))
    assert model.ntex >= 2 and model.material("skin").texid.max() >= 0


def test_a_foreign_file_round_trips_through_our_own_export(home, tmp_path):
    from apartgen.stages import export

    written, library = home
    export.run(written, ["glb"], tmp_path / "scene", lambda _, id: library.load_asset(id))
    again = folder.assets(tmp_path / "scene")
    skins = [m.material for s in again for link in s.load().links for m in link.visuals if m.material.name == "skin"]
    assert skins and skins[0].texture.startswith("data:image")
    assert base64.b64decode(skins[0].texture.partition(",")[2])[:4] == b"\x89PNG"


@pytest.mark.parametrize("rest, name", [
    ("oak.png", "oak.png"), ("-s 2 2 1 oak light.png", "oak light.png"), ("-clamp on -odd.png", "-odd.png"), ("", ""),
])
def test_the_file_of_a_map_is_what_its_options_leave(rest, name):
    assert obj._named(rest) == name


@pytest.mark.parametrize(("said", "rough"), [
    ("", 0.6), ('shininess="0"', 1.0), ('shininess="1"', 0.2), ('roughness="0"', 0.0), ('roughness="0.7"', 0.7),
    ('roughness="1"', 1.0), ('roughness="0.3" shininess="1"', 0.3), ('roughness="-1" shininess="0.25"', 0.8),
    ('roughness="7"', 1.0)])
def test_what_mujoco_calls_rough_goes_before_what_it_calls_shiny(tmp_path, said, rough):
    """Half shiny without a word, and nothing is rougher than rough."""
    (tmp_path / "stool.xml").write_text(
        f'<mujoco><asset><material name="w" {said}/></asset><worldbody><body name="stool">'
        '<geom type="box" size=".1 .1 .1" material="w"/></body></worldbody></mujoco>')
    (source,) = simobjects.assets(tmp_path)
    assert source.load().links[0].visuals[0].material.roughness == pytest.approx(rough)


def test_vertices_and_faces_have_limits_of_their_own(monkeypatch):
    """Five vertices and two faces, where five and two are accepted."""
    monkeypatch.setattr(pieces, "VERTICES", 5)
    monkeypatch.setattr(pieces, "FACES", 2)
    data = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\n"
    (piece,) = obj.parse(data, "x.obj", lambda _: None)
    assert len(piece.faces) == 2
    for more in (b"v 0 0 2\n", b"f 1 2 5\n"):
        with pytest.raises(Broken, match="more than the 2 and 5 accepted"):
            obj.parse(data + more, "x.obj", lambda _: None)


@pytest.mark.parametrize(("shade", "light"), [
    (0, 0.0), (5, 0.001518), (10, 0.003035), (11, 0.003347), (15, 0.004777), (128, 0.215861), (255, 1.0)])
def test_shades_are_of_the_light_that_the_standard_gives_them(shade, light):
    """IEC 61966-2-1, on both sides of where its straight part ends."""
    assert float(linear(shade / 255)) == pytest.approx(light, abs=1e-6)
    assert float(encoded(light)) == pytest.approx(shade / 255, abs=1e-4)
