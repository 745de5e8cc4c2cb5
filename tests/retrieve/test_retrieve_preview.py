"""Previews: pictures of assets closed and open, of the embedded library and of indexed ones."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching import indexed, store
from apartgen.stages.retrieve.matching.indexed import Entry, asset_file
from apartgen.stages.retrieve.preview import render, sheet
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset, Link, Material, Mesh
from apartgen_cli.main import status

CORNERS = np.array([[x, y, z] for x in (-0.25, 0.25) for y in (-0.25, 0.25) for z in (-0.25, 0.25)])
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


def cube(material: Material) -> Asset:
    uv = CORNERS[:, 1:] / 0.5 + 0.5
    return Asset(
        "mine", "cube", "chair", "", (0.5, 0.5, 0.5), [Link("base", [Mesh(CORNERS, FACES, material, uv)], [], 1.0)]
    )


def test_an_open_wardrobe_looks_other_than_a_closed_one_and_both_fill_their_pictures():
    asset = furniture.build("wardrobe", "shaker", categories.TABLE["wardrobe"].size, 1)
    closed, opened = render.pair(asset, 64)
    assert closed.shape == opened.shape == (64, 64, 3) and closed.dtype == np.uint8
    assert np.mean(np.abs(closed.astype(int) - opened).max(-1) > 20) > 0.05
    paper = np.median(closed[:4].reshape(-1, 3), 0)
    assert np.mean(np.abs(closed - paper).max(-1) > 15) > 0.2


def test_things_are_seen_a_little_from_above():
    """Seen from afar, 28° above the horizon and 32° aside, the top of a cube takes sin 28° of sin 28° + cos 28° (sin
    32° + cos 32°), .28 of what is seen of it; from near by, somewhat less."""
    top, rest = Material("top", (0.9, 0.05, 0.05, 1.0)), Material("rest", (0.05, 0.05, 0.9, 1.0))
    upper = np.isin(FACES, [1, 3, 5, 7]).all(1)
    meshes = [Mesh(CORNERS, FACES[upper], top, None), Mesh(CORNERS, FACES[~upper], rest, None)]
    lid = Asset("mine", "lid", "chair", "", (0.5, 0.5, 0.5), [Link("base", meshes, [], 1.0)])
    r, _, b = np.moveaxis(render.pair(lid, 96)[0].astype(int), -1, 0)
    red, blue = (r > 2 * b).sum(), (b > 2 * r).sum()
    assert 0.2 < red / (red + blue) < 0.28


def test_the_same_asset_gives_the_same_picture():
    asset = furniture.build("chair", "windsor", categories.TABLE["chair"].size, 1)
    assert all((a == b).all() for a, b in zip(render.pair(asset, 48), render.pair(asset, 48), strict=True))


def test_colours_and_images_of_any_material_are_shown(tmp_path):
    [plain] = render.pictures([render.opened(cube(Material("a", (0.1, 0.2, 0.9, 1.0))), 0.0)], 48)
    r, g, b = plain[20, 24].astype(int)
    assert b > 2 * r and b > g
    image = np.zeros((2, 2, 3), np.uint8)
    image[0], image[1] = (220, 20, 20), (20, 200, 20)
    Image.fromarray(image).save(tmp_path / "half.png")
    # Seen from the front: the image's upper half is the cube's.
    soup = render.opened(cube(Material("b", (1.0, 1.0, 1.0, 1.0), texture=str(tmp_path / "half.png"))), 0.0)
    shown = render.pictures([soup], 48, (0.0, 0.1))[0].astype(int)
    high, low = shown[14, 24], shown[36, 24]
    assert high[0] > 2 * high[1] and low[1] > 2 * low[0]


def test_a_sheet_keeps_pairs_together_and_shortens_labels():
    dark, light = (np.full((20, 20, 3), v, np.uint8) for v in (10, 200))
    cells = [sheet.Cell("a", [dark]), sheet.Cell("b" * 40, [light, dark]), sheet.Cell("c", [light, light])]
    image = np.asarray(sheet.drawn(cells, 4))
    height = len(image) // 2
    assert image.shape[1] == 80 and len(image) == 2 * height
    assert (image[height - 5, [10, 30, 50]] == [[10] * 3, [200] * 3, [10] * 3]).all()
    assert (image[height - 5, 70] == sheet.PAPER).all(), "the last pair goes to the next row whole"
    assert (image[2 * height - 5, [10, 30]] == [[200] * 3] * 2).all()


@pytest.fixture
def library(tmp_path):
    """An indexed library of two cubes."""
    folder = tmp_path / "lib"
    entries = []
    for row, (id, kind) in enumerate((("a/one", "chair"), ("two", "bin"))):
        store.write(cube(Material("m", (0.8, 0.1, 0.1, 1.0))), asset_file(folder, row))
        entries.append(Entry(id, kind, "", 0, "by me", (0.5, 0.5, 0.5)))
    indexed.write(folder, "mine", "folder", entries, np.zeros((2, 32)))
    return folder


def test_preview_writes_a_library_an_asset_or_a_category(library, tmp_path, capsys):
    out = tmp_path / "sheet.png"
    line = ["assets", "preview", "--library", str(library), "--size", "40", "-o", str(out)]
    assert status(line) == 0 and Image.open(out).width == 80
    assert status([*line, "two"]) == 0 and Image.open(out).width == 40
    assert status([*line, "--category", "chair"]) == 0 and Image.open(out).width == 40
    assert status(["assets", "preview", "--category", "bin", "--size", "40", "-o", str(out)]) == 0
    assert Image.open(out).width == 2 * 40 * len(furniture.styles("bin"))
    assert status(["assets", "preview", "stool/bar/400x400x650/1", "--size", "40", "-o", str(out)]) == 0
    assert {p.name for p in tmp_path.iterdir()} == {"lib", "sheet.png"}
    assert "wrote" in capsys.readouterr().err


@pytest.mark.parametrize("more, words", [
    (["three"], "no asset 'three'"), (["--category", "sofa"], "no asset of category 'sofa'"),
    (["--category", "throne"], "no category 'throne'"), (["two", "--category", "bin"], "one or the other"),
])  # fmt: skip
def test_preview_says_what_is_wrong_and_leaves_the_old_picture(library, tmp_path, capsys, more, words):
    out = tmp_path / "sheet.png"
    out.write_bytes(b"old")
    assert status(["assets", "preview", "--library", str(library), "-o", str(out), *more]) == 2
    told = capsys.readouterr().err
    assert words in told and "Traceback" not in told and out.read_bytes() == b"old"


def test_every_listed_asset_of_the_embedded_library_can_be_shown(capsys):
    assert status(["assets", "list"]) == 0
    rows = [line.split("\t") for line in capsys.readouterr().out.splitlines()]
    for _, size, name, id in rows[:: len(rows) // 12]:
        assert status(["assets", "show", name, id]) == 0
        assert f'"id": "{id}"' in capsys.readouterr().out
        assert furniture.load_asset(id).size == pytest.approx([float(side) for side in size.split()], abs=0.006)


def test_a_picture_does_not_hang_on_the_order_of_triangles():
    """Whichever of a cube's triangles is the first, among them all that the camera sees."""
    whole, pictures = cube(Material("a", (0.1, 0.2, 0.9, 1.0))), []
    (mesh,) = whole.links[0].visuals
    for k in range(len(FACES)):
        link = replace(whole.links[0], visuals=[replace(mesh, faces=np.roll(FACES, k, 0))])
        pictures.append(render.pictures([render.opened(replace(whole, links=[link]), 0.0)], 48)[0].astype(int))
    assert all(np.abs(one - pictures[0]).max() <= 1 for one in pictures)


@pytest.mark.parametrize(("wide", "shown"), [(66, "arm chair"), (59, "arm cha…"), (36, "arm…"), (8, "…")])
def test_a_label_is_cut_to_the_width_of_its_pictures(wide, shown):
    """Of letters six wide, beside a margin of six; what nothing fits in gets the sign of what is left out."""
    widths = iter([6 * n for n in (9, 8, 7, 6, 5, 4, 3, 2, 1)])
    draw = SimpleNamespace(textlength=lambda text, font: min(next(widths), 6 * len(text)))
    cell = SimpleNamespace(label="arm_chair", pictures=[range(wide)])
    assert sheet._cut(cell, draw, None) == shown
