"""An export appears whole or not at all, is the same twice, and says what it can't do."""

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from export import sample

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.stages import export, registry
from apartgen_cli.export import principal

ROOT = Path(__file__).parents[2]
FORMATS = list(export.formats())
NEED_ASSETS = [name for name in FORMATS if export.needs_assets(name)]


@pytest.fixture(scope="module")
def every(tmp_path_factory):
    """One export in every format there is."""
    out = tmp_path_factory.mktemp("every") / "scene"
    return out, export.run(sample.home(), FORMATS, out, sample.load)


def test_every_format_has_help():
    assert {"glb", "mjcf", "svg", "png"} <= set(FORMATS)
    assert all(export.formats().values())


def test_files_are_those_listed_and_hash_as_listed(every):
    out, made = every
    found = {p.relative_to(out).as_posix() for p in out.rglob("*") if p.is_file()}
    assert found == {file.path for file in made.files} | {"SHA256SUMS"}
    for file in made.files:
        assert hashlib.sha256((out / file.path).read_bytes()).hexdigest() == file.sha256
    assert {file.format for file in made.files} >= set(FORMATS)
    assert "Plain boxes, public domain" in (out / "CREDITS.txt").read_text()


def test_main_files_are_those_of_the_documents(every):
    """The command prints the file that a format names first; what they do not tell of yet, nobody looks for."""
    rows = [line.split("|")[1:3] for line in (ROOT / "docs" / "export.md").read_text().splitlines() if "|" in line]
    names = [[re.findall(r"`([^`]+)`", cell) for cell in row] for row in rows]
    documented = {name: file for formats, files in names for name, file in zip(formats, files)}
    named = {file.format: file.path for file in every[1].files if file.path in principal(every[1])}
    told = {name: documented[name] for name in FORMATS if name in documented}
    assert {"glb", "svg", "mjcf"} <= set(told) and {name: named[name] for name in told} == told


def test_sums_can_be_checked_with_coreutils(every):
    subprocess.run(["sha256sum", "-c", "--quiet", "SHA256SUMS"], cwd=every[0], check=True)


def test_no_file_names_an_absolute_path(every):
    out, made = every
    for file in made.files:
        data = (out / file.path).read_bytes()
        assert str(out).encode() not in data and os.getcwd().encode() not in data, file.path


@pytest.mark.parametrize("name", FORMATS)
def test_the_same_bytes_again(every, name, tmp_path):
    again = export.run(sample.home(), [name], tmp_path / "again", sample.load)
    first = {f.path: f.sha256 for f in every[1].files if f.format == name}
    assert {f.path: f.sha256 for f in again.files if f.format == name} == first


def test_the_same_bytes_under_another_hash_seed(every, tmp_path):
    code = (
        "import sys; from pathlib import Path; from export import sample; from apartgen.stages import export\n"
        "made = export.run(sample.home(), ['glb', 'mjcf', 'svg'], Path(sys.argv[1]), sample.load)\n"
        "print(*sorted(f.sha256 for f in made.files if f.path != 'CREDITS.txt'))"
    )
    root = Path(__file__).parents[2]
    env = {**os.environ, "PYTHONHASHSEED": "17", "PYTHONPATH": f"{root}{os.pathsep}{root / 'tests'}"}
    command = [sys.executable, "-c", code, tmp_path / "x"]
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=True)
    assert done.stdout.split() == sorted(f.sha256 for f in every[1].files if f.format in ("glb", "mjcf", "svg"))


@pytest.mark.parametrize("name", NEED_ASSETS)
def test_a_layout_without_assets_is_refused_and_leaves_nothing(name, tmp_path):
    bare = Layout(**sample.home().model_dump(exclude={"walkable"}))
    with pytest.raises(BadInput, match="apartgen retrieve"):
        export.run(bare, [name], tmp_path / "x", sample.load)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", sorted(set(FORMATS) - set(NEED_ASSETS)))
def test_what_needs_no_assets_looks_at_none(name, tmp_path):
    def broken(library, id):
        raise BadInput("no such asset")

    assert export.run(sample.home(), [name], tmp_path / "x", broken).files


def test_a_format_says_in_its_file_that_it_needs_no_assets(tmp_path, monkeypatch):
    monkeypatch.setattr(registry, "_folders", lambda package: (tmp_path,))
    for name, text in (("tally", "NEEDS_ASSETS = False\n"), ("whole", "")):
        (tmp_path / f"{name}.py").write_text(f'"""How many there are."""\n{text}')
    assert not export.needs_assets("tally") and export.needs_assets("whole")


def test_what_shows_boxes_is_not_imported_to_know_that():
    code = ("import sys; from apartgen.stages import export; found = [*map(export.needs_assets, export.formats())]\n"
            "print({'ezdxf', 'ifcopenshell', 'matplotlib', 'apartgen.stages.export.svg'} & set(sys.modules), found)")
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("set()") and "False" in done.stdout


def test_a_layout_and_a_plan_can_be_drawn(tmp_path):
    bare = Layout(**sample.home().model_dump(exclude={"walkable"}))
    assert len(export.run(bare, ["svg", "png"], tmp_path / "layout", sample.load).files) == 3
    assert len(export.run(sample.plan(), ["svg", "png", "glb", "mjcf"], tmp_path / "plan", sample.load).files) > 4


def test_a_failed_export_leaves_the_earlier_one(every, tmp_path):
    out = tmp_path / "scene"
    export.run(sample.home(), ["svg"], out, sample.load)
    before = {p.name: p.read_bytes() for p in out.iterdir()}

    def broken(library, id):
        raise BadInput("no such asset")

    with pytest.raises(BadInput):
        export.run(sample.home(), ["svg", "mjcf"], out, broken)
    assert {p.name: p.read_bytes() for p in out.iterdir()} == before
    assert [p.name for p in tmp_path.iterdir()] == ["scene"]


def test_an_interrupt_while_folders_change_places_keeps_the_earlier_one(tmp_path, monkeypatch):
    out = tmp_path / "scene"
    export.run(sample.home(), ["svg"], out, sample.load)
    before = {p.name: p.read_bytes() for p in out.iterdir()}
    rename, calls = os.rename, []

    def interrupted(source, target):
        calls.append(source)
        if len(calls) == 2:
            raise KeyboardInterrupt
        rename(source, target)

    monkeypatch.setattr(os, "rename", interrupted)
    with pytest.raises(KeyboardInterrupt):
        export.run(sample.home(), ["svg", "png"], out, sample.load)
    assert {p.name: p.read_bytes() for p in out.iterdir()} == before
    assert [p.name for p in tmp_path.iterdir()] == ["scene"]


def test_an_export_is_replaced_whole(tmp_path):
    out = tmp_path / "scene"
    export.run(sample.home(), ["svg", "png"], out, sample.load)
    (out / "export.json").write_text("{}")
    export.run(sample.home(), ["svg"], out, sample.load)
    assert sorted(p.name for p in out.iterdir()) == ["CREDITS.txt", "SHA256SUMS", "plan.svg"]


def test_a_folder_with_other_things_is_never_replaced(tmp_path):
    out = tmp_path / "scene"
    export.run(sample.home(), ["svg"], out, sample.load)
    (out / "notes.md").write_text("mine")
    with pytest.raises(BadInput, match="notes.md"):
        export.run(sample.home(), ["svg"], out, sample.load)
    assert (out / "notes.md").read_text() == "mine"
    file = tmp_path / "file"
    file.write_text("mine")
    with pytest.raises(BadInput, match="not a folder"):
        export.run(sample.home(), ["svg"], file, sample.load)


def test_an_unknown_format_is_named_before_anything_is_written(tmp_path):
    with pytest.raises(BadInput, match="did you mean 'mjcf'"):
        export.run(sample.home(), ["svg", "mjfc"], tmp_path / "x", sample.load)
    with pytest.raises(BadInput, match="no format"):
        export.run(sample.home(), [], tmp_path / "x", sample.load)
    assert list(tmp_path.iterdir()) == []


def test_formats_are_listed_without_heavy_imports():
    heavy = "{'matplotlib', 'mujoco', 'pxr', 'trimesh', 'torch', 'embreex', 'PIL'}"
    code = f"import sys; from apartgen.stages import export; export.formats(); print({heavy} & set(sys.modules))"
    root = Path(__file__).parents[2]
    done = subprocess.run([sys.executable, "-c", code], cwd=root, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


def test_members_are_public_modules():
    assert set(registry.members(export.PACKAGE)) == set(FORMATS)
    assert not any(name.startswith("_") for name in FORMATS)
