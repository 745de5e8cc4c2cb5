"""Homes with room to walk, their small things, and their faults, as they were."""

import boxes_library as fake
import numpy as np
import pytest
from check import injections
from crowded import crowded
from digests import kept

from apartgen.outputs import opened_libraries
from apartgen.schemas.walkable import Walkable
from apartgen.stages import check, populate, use, walkable
from apartgen.stages.layout import choice  # noqa: F401
from apartgen.stages.populate.config import PopulateConfig
from apartgen.stages.walkable import WalkableConfig

pytestmark = pytest.mark.wide

KINDS = ("bedroom", "bathroom", "kitchen", "living_room", "study", "dining_room")


def walk(home, library, **config):
    return walkable.run(home, WalkableConfig(write_anyway=True, **config), np.random.default_rng(0), library)


def told(found):
    return {"walkable": found.walkable, "objects": found.objects}


@pytest.mark.parametrize("name", kept.HOMES)
@pytest.mark.parametrize("more", [{}, {"target": 0.6}, {"target": 0.5, "scope": "rooms", "robot_radius": 0.3}],
                         ids=["usual", "wide", "rooms"])
def test_homes(name, more):
    found = walk(kept.home(name), opened_libraries(), **more)
    kept.same("walkable", f"{name} {more}", told(found))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(3))
def test_crowded_rooms(seed, kind):
    home = crowded(seed, kind)
    kept.same("walkable", f"crowded {kind} {seed}", told(walk(home, fake.Boxes().of(home))))


@pytest.mark.parametrize("name", kept.HOMES)
@pytest.mark.parametrize("more", [{}, {"density": 2.5}, {"walls": False, "grasps": False}],
                         ids=["usual", "full", "bare walls"])
def test_small_things(name, more):
    found = populate.run(kept.home(name), PopulateConfig(**more), kept.lane("populate", name), opened_libraries())
    kept.same("populate", f"{name} {more}", {
        "objects": found.objects, "receptacles": found.receptacles, "states": found.states})


def shaken(name, seed):
    home, rng = kept.home(name), np.random.default_rng(seed)
    return home.model_copy(update={"objects": [
        o.model_copy(update={"center": tuple(np.add(o.center, [*rng.normal(0, 0.15 * seed, 2), 0]).tolist()),
                             "yaw": o.yaw + float(rng.choice([0, 0, 0, np.pi / 2, 0.2]))}) for o in home.objects]})


@pytest.mark.parametrize("name", kept.HOMES)
def test_faults(name):
    """Of homes in order, and more and more out of it: the judge's, and those of use."""
    homes = {seed: shaken(name, seed) for seed in range(4)}
    kept.same("check", name, {str(seed): check.run(home, strict=True) for seed, home in homes.items()})
    rooms = {(seed, room.id): use.of_plan(home, room.id, home.objects) for seed, home in homes.items()
             for room in home.rooms}
    kept.same("use", name, {f"{seed} {id}": [list(use.faults(room)), list(use.lacks(room))]
                            for (seed, id), room in rooms.items()})


@pytest.mark.parametrize("kind", sorted(injections.KINDS))
def test_faults_put_in(kind):
    _, inject = injections.KINDS[kind]
    found = {}
    for seed, name in enumerate(kept.HOMES):
        home = kept.home(name)
        body = Walkable(**dict(home), walkable={"target": 0.2, "before": 0.3, "after": 0.3}).model_dump(mode="json")
        if inject(body, np.random.default_rng(seed)) is not None:
            try:
                found[name] = check.run(Walkable.model_validate(body))
            except ValueError:
                continue
    kept.same("check", f"put in: {kind}", found)
