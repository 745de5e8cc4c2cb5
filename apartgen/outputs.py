"""What comes of an apartment: files for simulators and people, and figures."""

import hashlib
import os
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Literal

from pydantic import Field

from apartgen.kept import kept
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.export import Export
from apartgen.schemas.metrics import Metrics
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.steps import made

if TYPE_CHECKING:
    from apartgen.stages.retrieve import LibrarySet
    from apartgen.stages.things.asset import Asset


class ExportSettings(Record):
    """What is written, and where assets are found."""

    format: list[str] = Field(min_length=1)
    libraries: list[str] = Field(default_factory=list)
    colliders: Literal["exact", "primitive"] = Field("exact", description="primitive: boxes and cylinders, no hulls")
    randomize: bool = Field(False, description="masses, friction and damping are drawn within their ranges")


def export(home: Plan, settings: ExportSettings, folder: Path, seed: int = 0) -> Export:
    """Write one apartment; what is drawn hangs on the seed."""
    from apartgen.stages import export

    def load_asset(library: str, id: str) -> "Asset":
        return opened_libraries(*settings.libraries).load_asset(library, id)

    return export.run(home, settings.format, folder, load_asset, seed if settings.randomize else None,
                      settings.colliders, processes=min(2, os.cpu_count() or 1))


def opened_libraries(*folders: str) -> "LibrarySet":
    """Opened when the first asset is needed; a picture of a bare plan needs none."""
    from apartgen.stages import retrieve

    return retrieve.shared_libraries(RetrieveConfig(libraries=list(folders)))


def finished(read: Artifact[Plan], settings: ExportSettings, folder: Path, seed: int | None = None) -> Export:
    """Write one apartment and the list of its files beside them; the seed is the apartment's own without another."""
    used, began = read.made.seed if seed is None else seed, perf_counter()
    files = export(read.body, settings, folder, used)
    text, _ = artifact.finish(files, made("export", used, settings, read, perf_counter() - began))
    artifact.write(text, folder / "export.json")
    return files


def intact(read: Artifact[Plan], settings: ExportSettings, folder: Path, seed: int | None = None) -> Export | None:
    """The list of an earlier export's files, where it came about just so and none is lost or changed."""
    used = read.made.seed if seed is None else seed
    old = kept(folder / "export.json", "export", made("export", used, settings, read))
    same = old is not None and all(_unchanged(folder / file.path, file.sha256) for file in old.body.files)
    return old.body if old is not None and same else None


def _unchanged(file: Path, sha256: str) -> bool:
    return file.is_file() and hashlib.sha256(file.read_bytes()).hexdigest() == sha256


def principal(files: Export) -> list[str]:
    """The main file of every format, which each format names first."""
    main = {file.format: file.path for file in reversed(files.files)}
    return list(reversed(main.values()))


class MetricsSettings(Record):
    """What is measured."""

    metric: list[str] = Field(default_factory=list, description="names of metrics; all that apply when empty")
    real_as: str | None = Field(None, description="data source that reads the real apartments; artifacts when None")
    split: str | None = Field(None, description="part of the real data set; all of it when None")
    inception_weights: str | None = Field(None, description="Inception-v3 of the image metrics; None is the packaged")



def measure(home: Plan, settings: MetricsSettings, against: Plan | Program | None = None) -> Metrics:
    """The figures of one apartment."""
    from apartgen.stages import metrics

    return metrics.run(home, settings.metric or None, against)
