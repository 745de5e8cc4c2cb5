"""What judges say of homes of which some values lie about where judges draw their lines, as it was."""

import numpy as np
import pytest
from digests import kept
from pydantic import ValidationError

from apartgen.schemas import artifact, carrying, consistency
from apartgen.schemas.retrieve import Retrieve
from apartgen.stages import check, use

pytestmark = pytest.mark.wide

STEPS = (-1.0, -0.3, -0.06, -0.04, -0.012, -0.005, 0.005, 0.012, 0.02, 0.04, 0.06, 0.2, 0.5)
"""By which lengths are longer, m."""
SHARES = (0.2, 0.32, 0.5, 0.9, 1.1, 2.0, 3.1, 6.0)
BUILDING = (*carrying.BUILDING, None)


def thing(body, rng):
    """One value of an object."""
    o, k = rng.choice(body["objects"]), int(rng.integers(3))
    what = str(rng.choice(["center", "center", "size", "yaw", "on", "category", "room", "id"]))
    if what == "center":
        o["center"][k] += float(rng.choice(STEPS))
    elif what == "size":
        o["size"][k] *= float(rng.choice(SHARES))
    elif what == "yaw":
        o["yaw"] += float(rng.choice([np.pi / 2, np.pi, 0.1]))
    elif what == "on":
        o["on"] = rng.choice([*BUILDING, *(other["id"] for other in body["objects"]), "nobody"])
    else:
        o[what] = rng.choice(body["objects"])[what]


def part(body, rng):
    """One value of what opens."""
    joints = [joint for o in body["objects"] for joint in o["joints"]]
    joint, k = joints[rng.integers(len(joints))], int(rng.integers(3))
    what = str(rng.choice(["range", "origin", "axis", "extent", "type", "name"]))
    if what == "range":
        joint["range"][k % 2] = float(rng.choice([-0.5, 0.0, 0.04, 0.06, 1.0, 3.0, 11.0]))
    elif what == "extent" and joint["extent"]:
        joint["extent"][k % 2][k] += float(rng.choice([*STEPS, 12.0]))
    elif what in ("origin", "axis"):
        joint[what][k] += float(rng.choice([*STEPS, -11.0]))
    elif what in ("type", "name"):
        joint[what] = joints[rng.integers(len(joints))][what]


def opening(body, rng):
    """One value of a door or a window."""
    o, k = rng.choice(body["openings"]), int(rng.integers(2))
    what = str(rng.choice(["sill", "head", "kind", "into", "hinge", "segment", "rooms"]))
    if what in ("sill", "head"):
        o[what] += float(rng.choice(STEPS))
    elif what == "segment":
        a, b = np.array(o["segment"], float)
        o["segment"][k] = (a + (b - a) * rng.choice([*SHARES, 0.0])).tolist()
    elif what == "hinge":
        o["hinge"] = 1 - o["hinge"]
    elif what == "into":
        o["into"] = rng.choice([None, *o["rooms"], "nowhere"])
    else:
        o[what] = rng.choice(body["openings"])[what]


def building(body, rng):
    """One value of the rooms, the walls, or of what was asked for."""
    asked, room, what = body["program"], rng.choice(body["rooms"]), int(rng.integers(8))
    if what == 0:
        body["height"] = float(rng.choice([1.85, 1.95, 2.2, 9.9, 10.1, 21.0]))
    elif what == 1:
        body["walls"][str(rng.choice(["inner", "outer"]))] = float(rng.choice([0.02, 0.4, 0.9, 1.2]))
    elif what == 2:
        point = room["polygon"][rng.integers(len(room["polygon"]))]
        point[rng.integers(2)] += float(rng.choice([*STEPS, 300.0, 1100.0]))
    elif what == 3:
        asked["objects"].append({"room": room["id"], "category": rng.choice(body["objects"])["category"],
                                 "count": int(rng.integers(3))})
    elif what == 4:
        asked["counts"][room["id"]] = sum(o["room"] == room["id"] for o in body["objects"]) + int(rng.integers(-1, 2))
    elif what == 5:
        asked["links"].append([room["id"], rng.choice(body["rooms"])["id"]])
        body["relaxed"] = body["relaxed"] or ["a link"] * int(rng.integers(2))
    elif what == 6:
        rng.choice(asked["rooms"])["private_to"] = rng.choice([None, room["id"], "nowhere"])
    else:
        room["id"] = rng.choice(body["rooms"])["id"]


EDITS = (thing, thing, thing, part, part, opening, opening, building)


@pytest.mark.parametrize("name", kept.HOMES[:2])
def test_homes_about_the_limits(name):
    """Each with one to six values others: what does not hang together, what the judge refuses, what use lacks."""
    whole, found = kept.home(name).model_dump(mode="json"), {}
    for seed in range(120 if name == "studio" else 40):
        rng, body = np.random.default_rng(seed), artifact.json.loads(artifact.json.dumps(whole))
        for _ in range(1 + seed % 6):
            EDITS[rng.integers(len(EDITS))](body, rng)
        try:
            home = Retrieve.model_validate(body)
        except ValidationError as error:
            found[str(seed)] = artifact.first_fault(error)
            continue
        wrong = list(consistency.faults(home))
        rooms = [] if wrong else [use.of_plan(home, room.id, home.objects) for room in home.rooms]
        found[str(seed)] = [wrong, check.quick(home), check.run(home, strict=seed % 2 == 0), [
            [list(use.faults(room)), list(use.lacks(room))] for room in rooms]]
    kept.same("check", f"about the limits {name}", found)


def test_what_carries_what():
    """Of boxes by chance, some of them on others."""
    found, places = {}, ("floor", "flat", "wall", "ceiling", "top", "")
    for seed in range(60):
        rng = np.random.default_rng(seed)
        bodies = []
        for k in range(8):
            size = rng.uniform(0.1, 1.2, 3).round(2)
            below = bodies[rng.integers(len(bodies))].high if bodies and k % 2 else rng.choice([0.0, 0.0, 0.04, 1.0])
            low = below + rng.choice([-0.06, -0.01, 0.0, 0.0, 0.04, 0.06])
            low = 2.6 - size[2] - rng.choice([0.0, 0.04, 0.06]) if k == 5 else low
            bodies.append(carrying.Body(f"b{k}", str(rng.choice(["r", "r", "s"])), str(rng.choice(places)), (
                *rng.uniform(0, 1.5, 2).round(2).tolist(), float(low + size[2] / 2)), tuple(size.tolist()),
                float(rng.uniform(-3, 3))))
        found[str(seed)] = [carrying.carriers(bodies, 2.6), [
            [carrying.over(a, b) for a in bodies] for b in bodies]]
    kept.same("schemas", "what carries what", found)
