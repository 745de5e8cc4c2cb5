"""Exports to test: of the sample flat in one format, and of whole flats in every format, small pictures throughout."""

from pathlib import Path
from typing import NamedTuple

import pytest
from export import sample

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable
from apartgen.stages import export, retrieve
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.scene.scene import Scene

EXAMPLE = Path(__file__).parents[2] / "examples" / "two-bedroom-flat" / "walkable.json"
FILES = ("mjcf", "usd", "urdf", "sdf", "glb", "habitat", "procthor", "nav2")
"""Formats of whole flats; the others are pictures."""


class Made(NamedTuple):
    """A scene and the folder of its export."""

    scene: Scene
    folder: Path


@pytest.fixture(autouse=True, scope="session")
def _small_pictures():
    from apartgen.stages.export import view

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(view, "PIXELS", 30_000)
        yield


@pytest.fixture(scope="session")
def exported(tmp_path_factory):
    def folder(name: str):
        """The folder of the sample flat in that format."""
        out = tmp_path_factory.mktemp(name) / "scene"
        export.run(sample.home(), [name], out, sample.load)
        return out

    return folder


@pytest.fixture(scope="session")
def make(tmp_path_factory):
    def made(home, load, formats=FILES) -> Made:
        """The home in these formats."""
        out = tmp_path_factory.mktemp("whole") / "scene"
        export.run(home, list(formats), out, load)
        return Made(Scene(home, load), out)

    return made


@pytest.fixture(scope="session", name="sample")
def _sample(make) -> Made:
    """The sample flat of plain boxes."""
    return make(sample.home(), sample.load)


@pytest.fixture(scope="session")
def library():
    """The embedded furniture."""
    return retrieve.open_libraries(RetrieveConfig()).load_asset


@pytest.fixture(scope="session")
def flat(make, library) -> Made:
    """The example flat: two bedrooms, 65 objects."""
    return make(artifact.read(EXAMPLE, Walkable).body, library)
