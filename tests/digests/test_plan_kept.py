"""Plans, what sentences are read as, and files of other programs, as they were."""

import json
from pathlib import Path

import numpy as np
import pytest
from digests import kept
from plan.imports import homes, writers

from apartgen.planning import PlanSettings, draw
from apartgen.schemas.plan import Plan
from apartgen.stages import check, plan
from apartgen.stages.plan import PlanConfig, imports, judge, reader, study

pytestmark = pytest.mark.wide

SENTENCES = Path(__file__).parent.parent / "sentences" / "sentences.jsonl"
PARTS = 10
DRAWN = {
    "two facades": ("two-bedroom flat of 80 m2, kitchen next to the dining room", {"facades": 2}),
    "large": ("three-bedroom house with two bathrooms, a laundry, a study facing north and a walk-in closet", {}),
    "party walls": ("studio with a separate bathroom", {"party_walls": ["west", "east"], "entrance": "south"}),
    "outline": ("one-bedroom flat with a balcony", {"outline": [(0, 0), (10, 0), (10, 5), (6, 5), (6, 9), (0, 9)]}),
    "wishes": ("flat with two bedrooms, the second bedroom larger than the first, the bathroom far from the kitchen, a "
               "4 m wide living room with a sofa and two armchairs", {}),
}


@pytest.mark.parametrize("case", DRAWN)
def test_plans(case):
    prompt, settings = DRAWN[case]
    found, _ = draw(prompt, PlanSettings(**settings), 4)
    kept.same("plan", case, {"program": found.program, "rooms": found.rooms, "openings": found.openings,
                             "finishes": found.finishes, "judged": judge.faults(found)})


@pytest.mark.parametrize("part", range(PARTS))
def test_sentences(part):
    lines = [json.loads(line) for line in SENTENCES.read_text(encoding="utf-8").splitlines()][part::PARTS]
    kept.same("plan", f"sentences {part}", {
        str(k): reader.read(line["prompt"], np.random.default_rng(k))
        for k, line in enumerate(lines)})


def test_variants():
    program = study.archetypes()["two_bedroom"]
    found = plan.build_variants(program, PlanConfig(), np.random.default_rng(2), 3)
    kept.same("plan", "variants", {str(k): one for k, one in enumerate(found)})


@pytest.mark.parametrize("name", kept.HOMES)
def test_drawn_by_hand(name):
    """Walls, doors and windows for the rooms of a plan, and what is wrong with it and with one put out of order."""
    home = kept.home(name)
    found = plan.from_polygons(home.rooms, PlanConfig(), home.program)
    bare = plan.from_polygons(home.rooms, PlanConfig())
    less = Plan.model_validate(dict(home) | {"openings": home.openings[::2]})
    kept.same("plan", f"drawn {name}", {"programme": found, "bare": bare, "right": judge.faults(home),
                                        "wrong": judge.faults(less), "judge": check.run(less, strict=True)})


@pytest.mark.parametrize("name", homes.NAMES)
def test_imports(name):
    home = homes.furnished(name, 1)
    files = {"sh3d": ("home.sh3d", writers.sh3d(home)), "roomplan": ("scan.json", writers.roomplan(home)),
             "procthor": ("house.json", writers.procthor(home))}
    kept.same("plan", f"imports {name}", {form: imports.read(*file, PlanConfig()) for form, file in files.items()})
