"""More plans: outlines, sides, requirements, measures; what a judge, a study and imports make of them; as they were."""

import numpy as np
import pytest
from digests import kept
from plan.imports import homes, writers

from apartgen.planning import PlanSettings, draw
from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import Plan
from apartgen.stages import check, plan
from apartgen.stages.plan import PlanConfig, imports, judge, met, study

pytestmark = pytest.mark.wide

DRAWN = {
    "long": ("two-bedroom flat of 70 m2", {"facades": 1}),
    "doors": ("one-bedroom flat with a study, no door between the bedroom and the living room, the study opens to the "
              "living room, the bathroom at most 5 m2", {"party_walls": ["north"]}),
    "sides": ("two bedrooms facing east, the kitchen north of the living room, entrance in the south", {}),
    "area": ("one-bedroom flat, the living room takes 40 % of the area, the kitchen twice the bathroom", {}),
    "tee": ("flat with one bedroom", {"outline": [(0, 0), (9, 0), (9, 4), (6, 4), (6, 9), (3, 9), (3, 4), (0, 4)]}),
    "corner": ("two-bedroom flat with two balconies and an ensuite", {"party_walls": ["north", "east"]}),
    "open": ("loft with an open kitchen, a walk-in closet and a guest WC", {"entrance": "west", "height": 3.4}),
    "walls": ("studio of 30 m2", {"walls": {"outer": 0.5, "inner": 0.2}, "whims": 5, "wave": 1}),
    "narrow": ("one-bedroom flat with a corridor at least 1.4 m wide and a bedroom at most 3 m long", {"enough": 2}),
    "unmet": ("flat with twelve bedrooms on 30 m2", {"whims": 2}),
    "order": ("one passes through the dining room into the kitchen, two bedrooms far from the entrance", {}),
}


@pytest.mark.parametrize("case", DRAWN)
def test_plans(case):
    prompt, settings = DRAWN[case]
    try:
        found, _ = draw(prompt, PlanSettings(**settings), 7)
    except (BadInput, Unmet) as error:
        kept.same("plan", f"drawn {case}", {"error": str(error)})
        return
    kept.same("plan", f"drawn {case}", {
        "rooms": found.rooms, "openings": found.openings, "programme": found.program,
        "judged": [judge.faults(found), check.run(found, strict=True)], "met": met.unmet(found)})


@pytest.mark.parametrize("kind", sorted(study.archetypes()))
def test_archetypes(kind):
    """With little time: what is found, or what is said to be in the way."""
    try:
        found = plan.build(study.archetypes()[kind], PlanConfig(whims=8, wave=1, enough=2, proposals=300),
                           np.random.default_rng(3))
        kept.same("plan", f"archetype {kind}", {"rooms": found.rooms, "openings": found.openings})
    except Unmet as error:
        kept.same("plan", f"archetype {kind}", {"error": str(error)})


@pytest.mark.parametrize("name", kept.HOMES)
def test_plans_out_of_order(name):
    """With openings moved, left out, made wider or put between other rooms: what judges say."""
    home, found = kept.home(name), {}
    for seed in range(12):
        rng, moved = np.random.default_rng(seed), []
        for o in home.openings:
            if rng.random() < 0.1:
                continue
            (a, b), by = np.asarray(o.segment, float), rng.choice([0.0, 0.0, 0.1, 0.4])
            along = (b - a) / np.linalg.norm(b - a)
            ends = np.round([a + by * along, b + by * rng.choice([0.5, 1, 2]) * along], 3)
            segment = tuple(tuple(end) for end in ends.tolist())
            moved.append(o.model_copy(update={"segment": segment}))
        body = Plan.model_construct(**dict(home) | {"openings": moved})
        found[str(seed)] = [judge.faults(body), check.run(body, strict=True)]
    kept.same("plan", f"out of order {name}", found)


@pytest.mark.parametrize("seed", (2, 3, 4))
def test_imports(seed):
    home = homes.furnished(homes.NAMES[seed % len(homes.NAMES)], seed)
    files = {"sh3d": ("home.sh3d", writers.sh3d(home)), "roomplan": ("scan.json", writers.roomplan(home)),
             "procthor": ("house.json", writers.procthor(home))}
    kept.same("plan", f"imports {seed}", {form: imports.read(*file, PlanConfig()) for form, file in files.items()})
