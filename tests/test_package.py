"""What is installed: every file of the program, from a wheel or a source distribution, and its licences."""

import shutil
import subprocess
import sys
import tarfile
import zipfile
from importlib.metadata import version
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PARTS = ("apartgen", "apartgen_cli", "schemas", "stages")
BUILD = "from setuptools import build_meta; build_meta.build_{}({!r})"


def built(kind: str, source: Path, out: Path) -> Path:
    out.mkdir()
    command = [sys.executable, "-c", BUILD.format(kind, str(out))]
    done = subprocess.run(command, cwd=source, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    [found] = out.iterdir()
    return found


@pytest.fixture(scope="module")
def tracked():
    """Files of the program that git knows; what is being written in a checkout is left out."""
    told = subprocess.run(["git", "ls-files", *PARTS], cwd=ROOT, capture_output=True, text=True)
    if told.returncode:
        pytest.skip("no checkout")
    return [name for name in told.stdout.split() if (ROOT / name).is_file() and not Path(name).name.startswith(".")]


@pytest.fixture(scope="module")
def distributions(tmp_path_factory, tracked):
    """The wheel of the sources, their archive, and the wheel of that."""
    if int(version("setuptools").partition(".")[0]) < 77:
        pytest.skip("setuptools is older than the build asks for")
    folder = tmp_path_factory.mktemp("package")
    source = folder / "source"
    for name in [*tracked, "pyproject.toml", "setup.py", "README.md", "LICENSE", "NOTICE"]:
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, source / name)
    archive = built("sdist", source, folder / "sdist")
    with tarfile.open(archive) as tar:
        tar.extractall(folder / "unpacked", filter="data")
    [unpacked] = (folder / "unpacked").iterdir()
    return built("wheel", source, folder / "wheel"), unpacked, built("wheel", unpacked, folder / "again")


def contents(wheel: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(wheel) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def test_a_wheel_has_every_file_of_the_program_and_no_other(distributions, tracked):
    found = contents(distributions[0])
    wanted = {name if name.startswith("apartgen") else f"apartgen/{name}": name for name in tracked}
    about = {name for name in found if ".dist-info/" in name}
    assert found.keys() - about == wanted.keys()
    assert all(found[name] == (ROOT / source).read_bytes() for name, source in wanted.items())
    assert {Path(name).name for name in about if "/licenses/" in name} == {"LICENSE", "NOTICE"}


def test_a_source_distribution_gives_the_same_wheel(distributions):
    assert contents(distributions[0]) == contents(distributions[2])
    assert (distributions[1] / "NOTICE").is_file()
