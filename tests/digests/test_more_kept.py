"""What judges and repairs make of rooms drawn by chance, and what is told of files that are wrong, as it was."""

import json
from pathlib import Path
from random import Random

import boxes_library as fake
import pytest
from crowded import crowded
from digests import kept
from digests.test_walkable_kept import KINDS, shaken, told, walk
from fuzz import spoil

from apartgen.outputs import opened_libraries
from apartgen.schemas import artifact
from apartgen.schemas.errors import BadInput
from apartgen.stages import check, metrics, populate, use
from apartgen.stages.layout import choice  # noqa: F401
from apartgen.stages.populate.config import PopulateConfig

pytestmark = pytest.mark.wide

GOLDEN = sorted((Path(__file__).parent.parent / "golden").glob("v*/*.json"))
SETTINGS = [{"target": 0.75, "scope": "rooms"}, {"target": 0.7, "gentle": 0.0, "top_k": 1}, {"robot_radius": 0.35},
            {"target": 0.8, "share": 0.7, "drop": False}]


@pytest.mark.parametrize("kind", KINDS)
def test_crowded_rooms(kind):
    """With other settings: what is moved, made smaller, left out; what judges say before and after."""
    found = {}
    for seed, more in enumerate(SETTINGS, 10):
        home = crowded(seed, kind)
        after = walk(home, fake.Boxes().of(home), **more)
        found[str(seed)] = [told(after), check.run(after, strict=True), [
            [list(use.faults(room)), list(use.lacks(room))] for one in (home, after)
            for room in [use.of_plan(one, one.rooms[1].id, one.objects)]]]
    kept.same("walkable", f"crowded {kind} otherwise", found)


@pytest.mark.parametrize("kind", KINDS)
def test_figures_of_crowded_rooms(kind):
    homes = [crowded(seed, kind) for seed in (20, 21)]
    kept.same("metrics", f"crowded {kind}", {str(k): [
        v for v in metrics.run(home).values if v.name not in ("fid", "kid")] for k, home in enumerate(homes)})


@pytest.mark.parametrize("name", kept.HOMES[:2])
def test_figures_out_of_order(name):
    found = metrics.run(shaken(name, 2), against=shaken(name, 0)).values
    kept.same("metrics", f"shaken {name}", {one: [v for v in found if v.name == one]
                                            for one in dict.fromkeys(v.name for v in found)})


@pytest.mark.parametrize("more", [{"density": 0.3}, {"doors_open": True, "parts": "random"}, {"density": 4.0}],
                         ids=["few", "open", "crammed"])
def test_small_things(more):
    found = populate.run(kept.home("studio"), PopulateConfig(**more), kept.lane("more"), opened_libraries())
    kept.same("populate", f"more {more}", {
        "objects": found.objects, "receptacles": found.receptacles, "states": found.states})


@pytest.mark.parametrize("file", GOLDEN, ids=lambda file: f"{file.parent.name} {file.stem}")
def test_spoilt_files(file, tmp_path):
    """What readers say of artifacts with a few faults: the values' and the text's."""
    data, found, rng = file.read_bytes(), [], Random(file.stem)
    body, path = json.loads(data), tmp_path / "a.json"
    for k in range(40):
        path.write_bytes(json.dumps(spoil.spoilt(body, rng)).encode("utf-8", "surrogatepass") if k % 3
                         else spoil.spoilt_bytes(data, rng))
        try:
            found.append(artifact.read(path, artifact.BODIES[body["apartgen"]]).body.model_dump())
        except BadInput as error:
            found.append(str(error).replace(str(tmp_path), ""))
    kept.same("schemas", f"{file.parent.name} {file.stem}", {str(k): one for k, one in enumerate(found)})
