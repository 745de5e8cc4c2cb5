"""Furniture of rooms by model, by rule and by projection, as they were."""

import numpy as np
import pytest
import torch
from digests import kept
from layout.rooms_for_tests import some_rooms
from lived_in import ROOMS, room

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import AskedObjects, Plan
from apartgen.stages import layout
from apartgen.stages.layout import batch, choice, corpus
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.datasets import _arrays, single_rooms
from apartgen.stages.layout.projection.project import project
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.layout.relations import corpus as tokens
from apartgen.stages.layout.relations import train, trained
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.rooms import of_plan
from apartgen.stages.things.categories import CATEGORIES, TABLE

pytestmark = pytest.mark.wide

SETTINGS = {
    "relations": LayoutConfig(threads=1, candidates=2),
    "anywhere": LayoutConfig(threads=1, places="random", candidates=1),
    "loose": LayoutConfig(threads=1, candidates=1, constraints=False),
    "diffusion": LayoutConfig(threads=1, model="diffusion", steps=4),
    "guided": LayoutConfig(threads=1, model="diffusion", steps=3, sampler="ddim", count="guided", projection=False,
                           guidance=dict.fromkeys(("articulation", "inside", "openings", "walkway", "quantity"), 1.0)),
}


def bare(name: str) -> Plan:
    home = kept.home(name)
    return Plan(**{field: getattr(home, field) for field in Plan.model_fields})


@pytest.mark.parametrize("name", kept.HOMES)
@pytest.mark.parametrize("how", SETTINGS)
def test_homes(how, name):
    if how not in ("relations", "diffusion") and name != "studio":
        return
    found = layout.run(bare(name), SETTINGS[how], kept.lane("layout", name))
    kept.same("layout", f"{how} {name}", {
        one.id: [o for o in found.objects if o.room == one.id] for one in found.rooms})


def test_wishes():
    plan = bare("flat").model_copy(deep=True)
    living = next(one.id for one in plan.rooms if one.type == "living_room")
    plan.program.objects += [AskedObjects(room=living, category="armchair", count=2),
                             AskedObjects(room=living, category="rug", count=0)]
    plan.program.counts[living] = 11
    for model in ("relations", "diffusion"):
        config = SETTINGS[model].model_copy(update={"count": "exact"} if model == "diffusion" else {})
        found = layout.run(plan, config, kept.lane("wishes"))
        kept.same("layout", f"wishes {model}", {"objects": found.objects})


@pytest.mark.parametrize("type", ROOM_TYPES)
def test_furnished_by_rule(type):
    found = {str(seed): single(type, seed) for seed in range(3)}
    kept.same("layout", f"furnished {type}", found)


def single(type: str, seed: int) -> Layout:
    rng = np.random.default_rng([seed, ROOM_TYPES.index(type)])
    from apartgen.stages.layout.datasets.furnisher import furnish

    plan = single_rooms.draw(rng, type)
    return Layout(**dict(plan), objects=furnish(plan, rng))


def test_furnished_homes():
    from apartgen.stages.layout.datasets.furnisher import furnished

    kept.same("layout", "furnished homes", {
        name: list(furnished(bare(name), kept.lane("furnished", name))) for name in kept.HOMES[:2]})


@pytest.mark.parametrize("seed", range(3))
def test_projected(seed):
    rng, kinds = np.random.default_rng(seed), [name for name in CATEGORIES if TABLE[name].place != "small"]
    items = [Item(name := str(rng.choice(kinds)), rng.uniform(-2, 2, 3), np.array(TABLE[name].size), rng.uniform(-3, 3))
             for _ in range(10)]
    found = project(items, space_of(some_rooms(1, seed), 0), (0, 3))
    kept.same("layout", f"projected {seed}", {"items": [[o.category, o.center, o.size, np.cos(o.yaw)] for o in found]})


@pytest.mark.parametrize("kind", ROOMS)
def test_energies(kind):
    width, depth, things = ROOMS[kind]
    found = {}
    for seed in range(5):
        rng = np.random.default_rng(seed)
        shaken = [o.model_copy(update={"center": tuple(np.add(o.center, [*rng.normal(0, 0.3 * seed, 2), 0]))})
                  for o in things()]
        found[str(seed)] = choice.parts(room(kind, width, depth, *shaken[seed // 2:]))
    kept.same("layout", f"energies {kind}", found)


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    path = tmp_path_factory.mktemp("corpus") / "c.npz"
    _arrays.write_corpus(path, [(home, 1) for home in single_rooms.homes(None, seed=4, rooms=10)])
    return path


def test_what_models_learn_from(rows):
    found = tokens.read(rows)
    kept.same("layout", "learned from", {"arrays": corpus.read_corpus(rows), "tokens": found,
                                         "rooms": [of_plan(kept.home(name)) for name in kept.HOMES]})


def test_steps_of_training(rows):
    torch.manual_seed(0)
    torch.set_num_threads(1)
    shape = Shape(width=32, heads=2, scene_layers=1, frame_layers=1, key=8)
    config = Training(corpus=str(rows), steps=2, batch=4, shape=shape)
    rooms = [one for one in tokens.read(rows) if one.n]
    model = trained.empty(config)
    optimizer = torch.optim.AdamW(model.parameters(), 1e-3)
    found = {}
    for step, told in enumerate(train.steps(rooms, config, 0)):
        losses = train.train_step(model, optimizer, told, config, train.learning_rate(step, config))
        found[str(step)] = {name: round(value, 2) for name, value in losses.items()}
    kept.same("layout", "steps of training", found)


def test_batches():
    plans = [bare(name) for name in kept.HOMES[:2]]
    found = list(batch.furnished(plans, LayoutConfig(threads=1, candidates=1), [kept.lane(p.prompt) for p in plans]))
    kept.same("layout", "batches", {str(k): one.objects for k, one in enumerate(found)})
