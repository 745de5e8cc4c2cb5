"""Files that earlier versions wrote are read whole: nothing they hold is lost or turned away.

`tests/golden/vN/` has one file of each kind as version N wrote it. They are never edited; a new version adds a folder.
"""

import json
from pathlib import Path

import jsonschema
import pytest

from apartgen.schemas import artifact
from apartgen.schemas.artifact import BODIES
from apartgen.schemas.migrations import VERSION
from apartgen.stages import retrieve

SINCE = {"populate": 2, "render": 3}
"""The first version of which there is a file of a kind, where that is not the first; pictures came during the second.
"""
FILES = sorted((Path(__file__).parent / "golden").glob("v*/*.json"))


def lost(old, new, path: str = "") -> list[str]:
    """Paths of values in `old` that `new` does not have."""
    if isinstance(old, dict):
        return [fault for key, value in old.items() for fault in lost(value, (new or {}).get(key), f"{path}.{key}")]
    if isinstance(old, list):
        short = [f"{path}: {len(old)} became {len(new)}"] if len(old) != len(new) else []
        return short + [fault for i, pair in enumerate(zip(old, new)) for fault in lost(*pair, f"{path}[{i}]")]
    return [] if old == new else [f"{path}: {old!r} became {new!r}"]


def test_every_version_has_a_file_of_every_kind():
    found = {(file.parent.name, file.stem) for file in FILES}
    assert found == {(f"v{version}", kind) for version in range(1, VERSION + 1) for kind in BODIES
                     if version >= SINCE.get(kind, 1)}


@pytest.mark.parametrize("file", FILES, ids=lambda file: f"{file.parent.name}-{file.stem}")
def test_old_files_are_read(file):
    read = artifact.read(file, BODIES[file.stem])
    text, _ = artifact.finish(read.body, read.made)
    jsonschema.validate(json.loads(text), artifact.json_schema(file.stem))


@pytest.mark.parametrize("file", [file for file in FILES if file.parent.name == f"v{VERSION}"], ids=lambda f: f.stem)
def test_nothing_of_the_present_version_is_lost(file):
    raw = json.loads(file.read_text(encoding="utf-8"))
    read = artifact.read(file, BODIES[file.stem])
    assert not lost(raw, json.loads(artifact.finish(read.body, read.made)[0]))


@pytest.mark.parametrize("version", range(1, VERSION + 1))
def test_a_chain_of_files_hangs_together(version):
    folder = Path(__file__).parent / "golden" / f"v{version}"
    kinds = [kind for kind in BODIES if version >= SINCE.get(kind, 1)]
    read = {kind: artifact.read(folder / f"{kind}.json", BODIES[kind]) for kind in kinds}
    made_from = {"layout": "plan", "retrieve": "layout", "walkable": "retrieve", "populate": "walkable",
                 "metrics": "walkable", "export": "walkable"}
    for kind, source in made_from.items():
        if kind not in kinds:
            continue
        assert read[kind].made.inputs[source] == read[source].digest


@pytest.mark.parametrize("file", [file for file in FILES if file.stem in ("retrieve", "walkable", "populate")],
                         ids=lambda file: f"{file.parent.name}-{file.stem}")
def test_the_assets_of_old_files_can_still_be_built(file):
    library = retrieve.open_libraries()
    for thing in artifact.read(file, BODIES[file.stem]).body.objects:
        if thing.asset:
            assert library.load_asset(thing.asset.library, thing.asset.id).links
