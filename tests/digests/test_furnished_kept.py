"""More rooms furnished by rule, by models otherwise set, and put right; and homes with less room than asked for."""

import boxes_library as fake
import numpy as np
import pytest
from crowded import crowded
from digests import kept
from digests.test_layout_kept import bare, single
from digests.test_walkable_kept import told, walk
from layout.rooms_for_tests import some_rooms

from apartgen import whole
from apartgen.schemas import artifact
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import AskedObjects
from apartgen.stages import layout
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.datasets import furnisher
from apartgen.stages.layout.projection.project import project
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.things.categories import CATEGORIES, TABLE

pytestmark = pytest.mark.wide

TYPES = {"living_room": 8, "kitchen": 6, "bedroom": 6, "bathroom": 6, "dining_room": 6, "hallway": 8, "study": 6,
         "utility": 6, "storage": 6, "closet": 6, "balcony": 6}
SETTINGS = {
    "noisy": {"sampler": "ddpm", "steps": 6, "count": "free", "guidance": {"walkway": 2.0}},
    "sigma": {"sampler": "ddpm", "steps": 6, "scaling": "sigma", "guidance_scale": 0.5, "guide_below": 0.5},
    "guided": {"steps": 5, "count": "guided", "guidance": {"quantity": 1.0, "inside": 2.0}, "guide_below": 0.6},
    "straight": {"sampler": "ddim", "steps": 5, "guidance_repeats": 2, "guide_below": 1.0, "projection": False},
}


@pytest.mark.parametrize("type", TYPES)
def test_furnished_by_rule(type):
    kept.same("layout", f"furnished {type} again", {
        str(seed): single(type, seed).objects for seed in range(20, 20 + TYPES[type])})


def test_furnished_as_asked():
    """So many things in a room, some of them named, some not wanted."""
    found = {}
    for seed, name in enumerate(kept.HOMES[:1]):
        plan, rng = bare(name).model_copy(deep=True), np.random.default_rng(seed)
        for room in plan.rooms:
            kinds = [kind for kind in CATEGORIES if room.base in TABLE[kind].rooms]
            plan.program.counts[room.id] = int(rng.integers(0, 9))
            plan.program.objects += [AskedObjects(room=room.id, category=str(rng.choice(kinds)), count=k)
                                     for k in (0, 2) if kinds]
        found[name] = furnisher.furnish(plan, rng)
    kept.same("layout", "furnished as asked", found)


def test_furnished_from_files(tmp_path):
    (tmp_path / "a.json").write_text(artifact.finish(bare("studio"), artifact.Made(by="test", seed=1))[0])
    (tmp_path / "b.json").write_text(bare("studio").model_dump_json())
    kept.same("layout", "furnished from files", {"homes": list(furnisher.homes(tmp_path, 3))})


@pytest.mark.parametrize("how", SETTINGS)
def test_diffused(how):
    config = LayoutConfig(threads=1, model="diffusion", **SETTINGS[how])
    found = layout.run(bare("studio"), config, kept.lane("diffused", how))
    kept.same("layout", f"diffused {how}", {
        one.id: [o for o in found.objects if o.room == one.id] for one in found.rooms})


def test_completed():
    """What stands there stays; one room alone is done anew."""
    home = kept.home("studio")
    half = Layout(**dict(bare("studio")), objects=[
        o.model_copy(update={"on": None}) for o in home.objects if not o.joints][:4])
    rooms = [one.id for one in home.rooms]
    kept.same("layout", "completed", {
        "keep": layout.run(half, LayoutConfig(threads=1, candidates=1, keep=True), kept.lane("keep")).objects,
        "room": layout.run(half, LayoutConfig(threads=1, candidates=1, room=rooms[:1]), kept.lane("room")).objects})


@pytest.mark.parametrize("seed", range(3, 10))
def test_projected(seed):
    """Things that belong together, too many of them, and things of any kind."""
    rng = np.random.default_rng(seed)
    sets = (["double_bed", "nightstand", "nightstand", "wardrobe", "rug", "table_lamp"],
            ["sofa", "tv_stand", "tv", "coffee_table", "armchair", "floor_lamp", "rug"],
            ["dining_table", *["chair"] * 4, "display_cabinet"], ["desk", "office_chair", "bookshelf", "wall_shelf"])
    kinds = [name for name in CATEGORIES if TABLE[name].place != "small"]
    names = [*sets[seed % 4], *rng.choice(kinds, 3).tolist()]
    items = [Item(name, rng.uniform(-2, 2, 3), np.array(TABLE[name].size), rng.uniform(-3, 3)) for name in names]
    found = project(items, space_of(some_rooms(1, seed), 0), (0, 3))
    kept.same("layout", f"projected {seed}", {"items": [[o.category, o.center, o.size, np.cos(o.yaw)] for o in found]})


@pytest.mark.parametrize("kind", ["bedroom", "kitchen", "living_room"])
def test_less_room_than_asked_for(kind):
    """Targets that only lesser kinds meet, or nothing; with what is asked for, and left as it is."""
    found = {}
    for seed, more in enumerate(({"target": 0.85}, {"target": 0.93, "drop": False}, {"target": 0.8, "connect": False})):
        home = crowded(40 + seed, kind)
        asked = [AskedObjects(room=o.room, category=o.category, count=1) for o in home.objects[:1]]
        home = home.model_copy(update={"program": home.program.model_copy(update={"objects": asked})})
        found[str(seed)] = told(walk(home, fake.Boxes().of(home), **more))
    kept.same("walkable", f"less room {kind}", found)


def test_settings():
    """Every setting of every stage, its bounds and what it is without being given."""
    kept.same("floor", "settings", {word: kind.model_json_schema() for word, kind in whole.KINDS.items()})
