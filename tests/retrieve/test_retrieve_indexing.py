"""Indexing folders: what is kept, what is refused and why, and that refusing costs little."""

import json
import struct
import tracemalloc
import zipfile
from pathlib import Path

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve import RetrieveConfig, build, check, kinds, shared_libraries
from apartgen.stages.retrieve.matching import store
from apartgen.stages.retrieve.matching.indexed import IndexedLibrary
from apartgen.stages.retrieve.matching.table import Table

SHARED = Path(__file__).parents[3] / "shared" / "data"
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
FACES = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"


def glb(about: dict, chunk: bytes = b"") -> bytes:
    text = json.dumps(about).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(chunk), 0x004E4942) + chunk
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def triangle_count(count: int) -> dict:
    return {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 0, "componentType": 5125, "count": 3 * count, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36}],
    }  # fmt: skip


BAD = {
    "nan.obj": (b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not finite"),
    "beyond.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "do not exist"),
    "words.obj": (b"v a b c\n", "line 1"),
    "empty.obj": (b"", "no faces"),
    "huge.obj": (SQUARE.replace("1", "1000").encode() + FACES.encode(), "declare the scale"),
    "cut.glb": (b"glTF\x02\x00\x00\x00\xff\xff\xff\x7f", "not valid glTF"),
    "many.glb": (glb(triangle_count(50_000_000), b"\0" * 36), "50000000 faces"),
    "short.glb": (glb(triangle_count(5), b"\0" * 36), "beyond its buffer"),
    "escape.gltf": (json.dumps({"asset": {"version": "2.0"}, "buffers": [{"uri": "../../../etc/passwd"}]}).encode(),
                    "outside its library"),
    "loop.gltf": (json.dumps({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"children": [0]}]})
                  .encode(), "refer to themselves"),
    "draco.gltf": (json.dumps({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco_mesh_compression"]})
                   .encode(), "KHR_draco"),
}  # fmt: skip


def test_each_broken_asset_is_named_with_its_reason_and_the_rest_is_indexed(tmp_path, monkeypatch):
    root = tmp_path / "mine"
    root.mkdir()
    (root / "chair_01.obj").write_text(SQUARE + FACES)
    for name, (data, _) in BAD.items():
        (root / name).write_bytes(data)
    report = check(root, "folder")
    assert report.categories == {"chair": 1}
    reasons = {failure.id: failure.reason for failure in report.broken}
    assert set(reasons) == {Path(name).stem for name in BAD}
    for name, (_, words) in BAD.items():
        assert words in reasons[Path(name).stem], name


def test_bombs_and_zeros_are_refused_with_bounded_memory(tmp_path):
    root = tmp_path / "mine"
    root.mkdir()
    with (root / "zeros.glb").open("wb") as file:
        file.truncate(10 * 2**30)
    laughs = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10 if i else "lol"}">' for i in range(10))
    (root / "bomb.urdf").write_text(f"<?xml version='1.0'?><!DOCTYPE robot [{laughs}]><robot name='x'>&l9;</robot>")
    (root / "outside.urdf").write_text(
        '<robot name="x"><link name="a"><visual><geometry><mesh filename="../../../../etc/passwd"/></geometry></visual>'
        "</link></robot>"
    )
    (root / "include.xml").write_text('<mujoco><include file="../../../../../../etc/hostname"/></mujoco>')
    with zipfile.ZipFile(root / "bomb.sh3f", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("PluginFurnitureCatalog.properties", b"#" * 50_000_000)
    with zipfile.ZipFile(root / "escape.sh3f", "w") as archive:
        archive.writestr("../../evil.obj", "")
    (root / "torn.sh3f").write_bytes(b"PK\x03\x04 and nothing")
    tracemalloc.start()
    found = [check(root, kind) for kind in ("folder", "simobjects", "sweethome3d")]
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert [report.indexed for report in found] == [0, 0, 0] and peak < 50 * 2**20
    reasons = " ".join(failure.reason for report in found for failure in report.broken)
    for words in (
        "10240 MB",
        "document type or entities",
        "outside its library",
        "refused",
        "out of the archive",
        "not a readable archive",
    ):
        assert words in reasons
    assert sum(len(report.broken) for report in found) == 7


@pytest.fixture
def shop(tmp_path) -> Path:
    root = tmp_path / "shop"
    root.mkdir()
    (root / "LICENSE").write_text("By A. Maker\nCC-BY 4.0\n")
    for name, (d, w, h) in {"sofa_a": (0.9, 2.0, 0.8), "sofa_b": (0.9, 1.6, 0.8), "wardrobe": (0.6, 1.5, 2.0)}.items():
        corners = [(x * w, y * h, z * d) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        lines = "".join(f"v {x} {y} {z}\n" for x, y, z in corners)
        (root / f"{name}.obj").write_text(lines + FACES)
    return root


def test_libraries_are_opened_once_for_all_homes_and_anew_when_indexed_anew(shop, tmp_path, trained, monkeypatch):
    from apartgen.stages.retrieve.shape import encoder

    monkeypatch.setattr(encoder.latents, "__defaults__", (trained[0],))
    out = tmp_path / "lib"
    build(shop, "folder", out)
    config = RetrieveConfig(libraries=[str(out)])
    first = shared_libraries(config)
    assert shared_libraries(config.model_copy()) is first and shared_libraries() is not first
    assert first.load_asset("shop", "wardrobe") is shared_libraries(config).load_asset("shop", "wardrobe")
    (shop / "stool.obj").write_text((shop / "wardrobe.obj").read_text())
    build(shop, "folder", out)
    assert shared_libraries(config).load_asset("shop", "stool").id == "stool"
    with pytest.raises(BadInput, match="no indexed library"):
        shared_libraries(RetrieveConfig(libraries=[str(tmp_path / "none")]))


def test_an_indexed_library_serves_its_assets_and_the_embedded_one_what_does_not_fit(
    shop, tmp_path, trained, libraries, monkeypatch
):
    from apartgen.stages.retrieve.shape import encoder

    monkeypatch.setattr(encoder.latents, "__defaults__", (trained[0],))
    out = tmp_path / "lib"
    report = build(shop, "folder", out)
    assert report.indexed == 3 and report.name == "shop"
    first = {p.name: p.read_bytes() for p in sorted(out.rglob("*")) if p.is_file()}
    build(shop, "folder", out)
    assert {p.name: p.read_bytes() for p in sorted(out.rglob("*")) if p.is_file()} == first
    config = RetrieveConfig(libraries=[str(out)])
    both = type(libraries)(libraries.embedded, [IndexedLibrary(out, config)])
    wide, narrow = (both.nearest("sofa", (0.92, w, 0.82), (), (0.92, w, 0.82)) for w in (2.05, 1.7))
    assert (wide.id, narrow.id) == ("sofa_a", "sofa_b") and wide.library == "shop"
    assert "CC-BY" in wide.credit
    assert both.load_asset("shop", "sofa_a").size == pytest.approx((0.9, 2.0, 0.8))
    # No sofa here is short enough: one is made; no asset is squeezed.
    short = both.nearest("sofa", (0.92, 1.5, 0.82), (), (0.92, 1.5, 0.82))
    assert short.library == "parametric" and short.size == (0.92, 1.5, 0.82)
    # A wardrobe that can't open is passed over only by one that can.
    assert both.nearest("wardrobe", (0.6, 1.5, 2.0), (), (0.6, 1.5, 2.0)).library == "shop"
    with pytest.raises(BadInput, match="no asset 'sofa_z'"):
        both.load_asset("shop", "sofa_z")
    with pytest.raises(BadInput, match="'elsewhere' is not open"):
        both.load_asset("elsewhere", "x")


def test_an_index_never_overwrites_what_is_no_library(shop, tmp_path):
    (tmp_path / "photos").mkdir()
    (tmp_path / "photos" / "cat.jpg").write_bytes(b"cat")
    with pytest.raises(BadInput, match="no asset library"):
        build(shop, "folder", tmp_path / "photos")
    assert (tmp_path / "photos" / "cat.jpg").read_bytes() == b"cat"


def test_unknown_kinds_and_folders_are_refused(tmp_path):
    assert set(kinds()) >= {"folder", "future3d", "gapartnet", "simobjects", "sweethome3d"}
    with pytest.raises(BadInput, match="no kind"):
        check(tmp_path, "objaverse")
    with pytest.raises(BadInput, match="no such"):
        check(tmp_path / "nowhere", "folder")
    with pytest.raises(BadInput, match="no indexed library"):
        IndexedLibrary(tmp_path)


def test_stored_assets_come_back_as_they_were(maker, tmp_path):
    asset = maker.build("chair", "legs", (0.5, 0.45, 0.9))
    store.write(asset, tmp_path / "a.safetensors")
    back = store.read(tmp_path / "a.safetensors")
    assert (back.id, back.size, back.style) == (asset.id, asset.size, asset.style)
    for mine, theirs in zip(asset.links[0].visuals, back.links[0].visuals, strict=True):
        assert np.allclose(mine.vertices, theirs.vertices, atol=1e-6) and (mine.faces == theirs.faces).all()
        assert mine.material == theirs.material
    (tmp_path / "b.safetensors").write_bytes((tmp_path / "a.safetensors").read_bytes()[:-9])
    with pytest.raises(BadInput, match="not a readable asset"):
        store.read(tmp_path / "b.safetensors")


def test_costs_are_what_the_configuration_says(maker):
    rng = np.random.default_rng(1)
    size, latent, moving = rng.uniform(0.5, 1, (40, 3)), rng.normal(size=(40, 32)), rng.random(40) < 0.5
    table = Table(["wardrobe"] * 40, size, latent, moving)
    config = RetrieveConfig()
    wanted, z = np.array([0.6, 0.8, 0.7]), rng.normal(size=32)
    by_hand = (
        np.square(np.log(size / wanted) / 0.2).sum(1) * config.size_weight
        + config.latent_weight * np.square(latent - z).mean(1)
        + config.static_cost * ~moving
    )
    assert np.allclose(table.costs("wardrobe", wanted, z, config), by_hand, rtol=1e-4)
    limit = np.array([0.7, 0.9, 0.8])
    fits = ((size <= limit + 1e-4) & (size >= 0.75 * wanted - 1e-4)).all(1)
    hit = table.nearest("wardrobe", wanted, z, limit, config)
    assert hit is not None and hit[0] == np.flatnonzero(fits)[np.argmin(by_hand[fits])]


@pytest.mark.parametrize("folder, kind, options, count", [
    pytest.param("kenney", "folder", {"scale": 2.0}, 139, marks=pytest.mark.slow),
    ("furniture_sim", "simobjects", {}, 29),
])  # fmt: skip
def test_real_sets_index_without_loss(folder, kind, options, count):
    if not (SHARED / folder).exists():
        pytest.skip("the set is not on this machine")
    report = check(SHARED / folder, kind, **options)
    assert report.broken == [] and report.indexed == count


def test_an_owned_asset_may_outgrow_its_box_where_there_is_room_and_is_made_to_measure_where_not(
    shop, tmp_path, trained, libraries, flat, monkeypatch
):
    from apartgen.stages.retrieve import run
    from apartgen.stages.retrieve.shape import encoder

    monkeypatch.setattr(encoder.latents, "__defaults__", (trained[0],))
    build(shop, "folder", tmp_path / "lib")
    config = RetrieveConfig()
    both = type(libraries)(libraries.embedded, [IndexedLibrary(tmp_path / "lib", config)])
    sofa = {"category": "sofa", "center": [2, 2.5, 0.4], "size": [0.9, 1.5, 0.8]}
    (free,) = run(flat(sofa), config, np.random.default_rng(0), both).objects
    assert free.asset.id == "sofa_b" and free.size[1] == pytest.approx(1.6)
    beside = [{"category": "armchair", "center": [2, y, 0.4], "size": [0.9, 0.84, 0.85]} for y in (1.3, 3.7)]
    packed = [{"category": "chest", "center": [x, y, 0.4], "size": [0.6, 1.6, 0.8]}
              for x in (1.2, 2.8) for y in (0.9, 2.5, 4.1)]  # fmt: skip
    home = run(flat(sofa, *beside, *packed), config, np.random.default_rng(0), both)
    assert home.objects[0].asset.library == "parametric" and home.objects[0].size[1] == pytest.approx(1.5)


def test_twenty_queries_over_a_hundred_thousand_assets_take_less_than_50_ms():
    import time

    from apartgen.stages.things.categories import CATEGORIES, TABLE

    rng = np.random.default_rng(0)
    names = [CATEGORIES[i] for i in rng.integers(len(CATEGORIES), size=100_000)]
    size = np.array([TABLE[name].size for name in names]) * rng.uniform(0.7, 1.3, (len(names), 3))
    table = Table(names, size, rng.normal(size=(len(names), 32)), rng.random(len(names)) < 0.5)
    queries = [(names[i], size[i] * 1.05, rng.normal(size=32)) for i in rng.integers(len(names), size=20)]
    spent = []
    for _ in range(3):
        began = time.process_time()
        hits = [table.nearest(name, side, z, side, RetrieveConfig()) for name, side, z in queries]
        spent.append(time.process_time() - began)
    assert all(hit is not None for hit in hits) and min(spent) < 0.05
