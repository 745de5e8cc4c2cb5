"""What is measured on plans and furnished rooms, and what requirements make of programmes, as it was."""

import numpy as np
import pytest
from digests import kept
from digests.test_layout_kept import single

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import Requirement
from apartgen.stages import use
from apartgen.stages.plan import check, judge, met, rehung, seen, study
from apartgen.stages.plan.wishes import DIRECTIONS
from apartgen.stages.use import habits

ROOMS = ("bedroom", "living_room", "kitchen", "dining_room", "bathroom", "hallway", "study")
SIDES = (*DIRECTIONS, "centre", "corner", "front", "back", "left", "right", "nowhere")
KINDS = ("position", "orientation", "near", "apart", "adjacent", "opposite", "dimension", "order", "no_door", "use",
         "at_least", "at_most", "other")


@pytest.mark.parametrize("type", ROOMS)
def test_habits(type):
    """Of rooms furnished by rule, of those of a home, and of both with their things put aside."""
    homes = [single(type, seed) for seed in range(3)] + [kept.home(name) for name in kept.HOMES]
    found = []
    for k, home in enumerate(homes):
        rng = np.random.default_rng(k)
        moved = [o.model_copy(update={"center": tuple(np.add(o.center, [*rng.normal(0, 0.12, 2), 0]).tolist())})
                 for o in home.objects]
        found += [habits.cases(use.of_plan(home, room.id, objects))
                  for room in home.rooms if room.base == type for objects in (home.objects, moved)]
    names = sorted({name for one in found for name in one})
    kept.same("use", f"habits {type}", {"cases": found, "typical": {
        name: habits.typical(name, [value for one in found for value in one.get(name, ())]) for name in names}})


@pytest.mark.parametrize("name", kept.HOMES)
def test_terms(name):
    """Of a home, and of the same seen in a mirror and with a door less."""
    home = kept.home(name)
    mirrored = home.model_copy(update={
        "rooms": [room.model_copy(update={"polygon": [(y, x) for x, y in room.polygon][::-1]}) for room in home.rooms],
        "openings": [o.model_copy(update={"segment": tuple((y, x) for x, y in o.segment)}) for o in home.openings]})
    kept.same("plan", f"terms {name}", {"home": seen.seen(home), "mirrored": seen.seen(mirrored),
                                        "walked": list(seen.walked(home))})


def requirement(rng, rooms, k):
    """One of any kind, of rooms or what else there is."""
    kind = str(rng.choice(KINDS))
    to = rng.choice([None, "entrance", "width", "length", "doors", *rooms])
    value = f"{rng.uniform(1.5, 6):.1f} x {rng.uniform(1.5, 6):.1f}" if kind == "dimension" else str(rng.choice(
        ["larger", "smaller", "largest", "smallest"])) if kind == "order" else str(rng.choice(SIDES))
    if kind in ("at_least", "at_most"):
        value = float(rng.choice([1, 2, 3])) if to == "doors" else round(float(rng.uniform(0.8, 18)), 1)
    return Requirement(id=f"r{k}", kind=kind, of=str(rng.choice(["home", "hall", *rooms, *rooms])), to=to, value=value)


@pytest.mark.parametrize("name", kept.HOMES)
def test_what_is_met(name):
    home, found = kept.home(name), {}
    for seed in range(6):
        rng = np.random.default_rng(seed)
        rooms = [room.id for room in home.rooms]
        rows = [requirement(rng, rooms, k) for k in range(60)]
        asked = home.program.model_copy(update={"requirements": rows})
        shut = [o for o in home.openings if o.kind != "entrance"] if seed == 5 else home.openings
        plan = met.judged(home.model_copy(update={"program": asked, "openings": shut}))
        found[str(seed)] = [[(r.kind, r.of, r.to, r.value, r.met) for r in plan.program.requirements], met.unmet(plan)]
    kept.same("plan", f"met {name}", found)


def with_room(program, rng, **fields):
    """A programme of which one room has some fields others."""
    rooms = list(program.rooms)
    k = int(rng.integers(len(rooms)))
    rooms[k] = rooms[k].model_copy(update=fields)
    return program.model_copy(update={"rooms": rooms})


def spoilt(program, rng):
    """A programme with a few things others."""
    rooms, links = [room.id for room in program.rooms], list(program.links)
    pair = tuple(rng.choice(rooms, 2).tolist())
    what = int(rng.integers(9))
    if what == 0 and links:
        links.pop(int(rng.integers(len(links))))
    elif what == 1:
        links.append(pair)
    elif what == 2:
        return program.model_copy(update={"open_links": [*program.open_links, pair]})
    elif what == 3:
        return program.model_copy(update={"total_area": float(rng.choice([0.4, 20, 45, 70, 300, 2100]))})
    elif what == 4:
        return with_room(program, rng, area=float(rng.choice([0.4, 2, 9, 30, 80])))
    elif what == 5:
        return with_room(program, rng, private_to=pair[0])
    elif what == 6:
        sides = [str(side) for side in rng.permutation(["north", "south", "east", "west"])[: rng.integers(1, 5)]]
        return program.model_copy(update={"envelope": program.envelope.model_copy(update={"party_walls": sides})})
    elif what == 7:
        w, h = (float(side) for side in rng.choice([1.2, 2.0, 4.0, 7.0, 12.0, 60.0], 2))
        ring = [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)][:: int(rng.choice([1, 1, -1]))]
        return program.model_copy(update={"envelope": program.envelope.model_copy(update={"outline": ring})})
    else:
        factor = {str(rng.choice(["privacy", "convexity", "beauty"])): float(rng.choice([-1, 0, 2]))}
        return program.model_copy(update={"weights": factor})
    return program.model_copy(update={"links": links})


@pytest.mark.parametrize("kind", sorted(study.archetypes()))
def test_programmes(kind):
    """Some spoilt, and some of which requirements move doors: what is said of them, and what becomes of them."""
    whole, found = study.archetypes()[kind], {}
    for seed in range(40):
        rng, program = np.random.default_rng(seed), whole
        for _ in range(seed % 4):
            program = spoilt(program, rng)
        rooms = [room.id for room in program.rooms]
        counted, (a, b, c) = str(rng.choice(["at_least", "at_most"])), rng.choice(rooms, 3).tolist()
        rows = [Requirement(id="r1", kind="no_door", of=a, to=b),
                Requirement(id="r2", kind=counted, of=c, to="doors", value=int(rng.integers(1, 4)))]
        try:
            check.check(program)
        except (BadInput, Unmet) as error:
            found[str(seed)] = str(error)
            continue
        moved = rehung.rehung(program.model_copy(update={"requirements": rows}))
        found[str(seed)] = [rows, moved.links, check.entrance_room(moved).id, check.links(moved)]
    kept.same("plan", f"programmes {kind}", found)


@pytest.mark.parametrize("name", kept.HOMES[:2])
def test_judged(name):
    """Of a home with other types of rooms, heights and sizes."""
    home, found = kept.home(name), {}
    for seed in range(30):
        rng = np.random.default_rng(seed)
        types = [room.type for room in home.rooms]
        k, scale = int(rng.integers(len(types))), rng.choice([1.0, 0.5, 0.8, 1.3], 2)
        turned = [types[(j + seed) % len(types)] if j == k or seed % 3 == 0 else type for j, type in enumerate(types)]
        rooms = [room.model_copy(update={"type": type, "polygon": np.multiply(room.polygon, scale).round(3).tolist()})
                 for room, type in zip(home.rooms, turned)]
        openings = [o.model_copy(update={"segment": np.multiply(o.segment, scale).round(3).tolist(),
                                         "sill": o.sill * float(rng.choice([1, 1, 0.3]))}) for o in home.openings]
        height = float(rng.choice([2.1, 2.3, 2.6, 4.5]))
        body = home.model_construct(**dict(home) | {"rooms": rooms, "openings": openings, "height": height})
        found[str(seed)] = judge.faults(body)
    kept.same("plan", f"judged {name}", found)
