"""What keeps parts from opening in the true geometry, and how it is got out of the way."""

import boxes_library as fake
import handmade as h
import numpy as np
import pytest

from apartgen.schemas.retrieve import AssetKey, Joint
from apartgen.stages import retrieve
from apartgen.stages.things.categories import TABLE
from apartgen.stages.walkable import WalkableConfig, designs, run, unblock
from apartgen.stages.walkable.leaves import building
from apartgen.stages.walkable.parts import PLACE, Check, Fault, stuck_doors
from apartgen.stages.walkable.site import survey
from apartgen.stages.walkable.solids import Solids

UP, DOWN = np.pi / 2, -np.pi / 2


def blocked(home, library=None):
    return Check(building(home), Solids(library or fake.Empty().of(home))).blocked(home.objects)


def opened(home, library=None, **config):
    config = {"target": 0.0, "connect": False} | config
    return run(home, WalkableConfig(**config), np.random.default_rng(0), library or fake.Empty().of(home))


def lidded(x, y, **more):
    """A box 0.4 m in all directions whose lid turns up about its back edge."""
    lid = Joint(name="lid", type="hinge", axis=(0, -1, 0), origin=(-0.2, 0, 0.18), range=(0, np.pi / 2),
                part="hinge_lid", extent=((-0.2, -0.2, 0.18), (0.2, 0.2, 0.2)))
    return h.thing("laundry_basket", x, y, UP, size=(0.4, 0.4, 0.4), joints=(lid,), id="basket", **more)


def steps(home):
    return [(step.action, step.object, step.reason) for step in home.walkable.steps]


@pytest.mark.parametrize("into, is_blocked", [(0.02, True), (0.0005, True), (-0.0005, True), (-0.002, False)])
def test_a_drawer_is_blocked_by_what_stands_in_its_way(into, is_blocked):
    chest = h.chest(2, 0.25, UP, id="chest")  # 0.5 deep; its drawer comes to y = 0.9
    stool = h.thing("stool", 2, 0.9 + 0.2 - into, size=(0.4, 0.4, 0.45), id="stool")
    assert blocked(h.home(chest, stool)) == ({Fault("chest", "drawer", "stool")} if is_blocked else set())


def test_what_blocks_a_drawer_by_2_cm_is_nudged():
    chest = h.chest(2, 0.25, UP, id="chest")
    stool = h.thing("stool", 2, 1.08, size=(0.4, 0.4, 0.45), id="stool")
    result = opened(h.home(chest, stool))
    assert steps(result) == [("nudge", "stool", "chest")] and result.walkable.blocked == []
    shift = np.subtract(result.walkable.steps[0].after.center, result.walkable.steps[0].before.center)
    assert np.abs(shift).max() <= 0.05 and blocked(result) == set()
    assert opened(h.home(chest, stool), unblock=False).walkable.steps == []


def test_a_lid_under_a_rail():
    rail = h.thing("towel_rail", 2, 0.1, UP, size=(0.1, 0.6, 0.1), bottom=0.7, id="rail")
    # Upright, the lid stands at y = 0.11 and ends at z = 0.78.
    basket = lidded(2, 0.31)
    assert blocked(h.home(basket, rail)) == {Fault("basket", "lid", "rail")}
    result = opened(h.home(basket, rail))
    assert result.walkable.blocked == [] and blocked(result) == set() and result.walkable.dropped == []


def test_a_lid_that_turns_past_a_rail_is_free():
    """Beyond the arc of its edge, but within the box about the arc."""
    rail = h.thing("towel_rail", 2, 0.45, UP, size=(0.04, 0.6, 0.04), bottom=0.72, id="rail")
    assert blocked(h.home(lidded(2, 0.24), rail)) == set()


def test_neighbours_pressed_3_mm_into_each_other_are_parted():
    left, right = (h.chest(x, 0.25, UP, id=name) for x, name in ((1.5, "right"), (2.497, "left")))
    home = h.home(left, right)
    assert {f.owner for f in blocked(home)} == {"left", "right"}
    result = opened(home)
    assert blocked(result) == set() and len(result.walkable.steps) == 1
    a, b = (next(o for o in result.objects if o.id == name).center[0] for name in ("right", "left"))
    assert 1.001 <= b - a <= 1.03


def test_a_curtain_leaves_the_swing_of_a_door():
    curtain = h.thing("curtain", 0.06, 0.7, 0.0, size=(0.12, 0.7, 2.3), id="curtain")  # 5 cm into the entrance's way
    home = h.home(curtain)
    assert Fault("entrance_1", "way", "curtain") in blocked(home)
    result = opened(home)
    assert blocked(result) == set() and result.walkable.dropped == []


def test_a_door_that_turns_into_furniture_is_freed():
    plant = h.thing("plant", 0.75, 1.5, size=(0.3, 0.3, 1.0), id="plant")
    assert {f.owner for f in blocked(h.home(plant))} == {"entrance_1"}
    result = opened(h.home(plant))
    assert blocked(result) == set() and result.walkable.dropped == []


def test_a_part_that_turns_into_a_wall_or_above_the_ceiling():
    def leaf(**more):
        return Joint(name="leaf", type="hinge", range=(0, np.pi / 2), part="hinge_door", **more)
    left = leaf(axis=(0, 0, 1), origin=(0.25, 0.5, 0), extent=((0.23, -0.5, -0.4), (0.25, 0.5, 0.4)))
    case = h.thing("wardrobe", 2, 2.5, DOWN, size=(0.5, 1.0, 0.8), joints=(left,), id="case")
    assert blocked(h.home(case)) == set()
    turned = case.model_copy(update={"center": (0.26, 2.4, 0.4), "yaw": np.pi})
    assert {f.by for f in blocked(h.home(turned))} == {"wall"}
    up = leaf(axis=(0, -1, 0), origin=(-0.25, 0, 0.4), extent=((-0.25, -0.5, 0.38), (0.25, 0.5, 0.4)))
    high = case.model_copy(update={"center": (2.0, 2.5, h.plan().height - 0.41), "joints": [up]})
    assert {f.by for f in blocked(h.home(high))} == {"ceiling"}


@pytest.mark.parametrize("behind, back", [(0.4, 0.2), (0.1, 0.0)])
def test_a_chair_that_stands_in_its_table_is_drawn_back_where_there_is_room(behind, back):
    table = h.thing("dining_table", 2, 0.4, UP, size=(0.8, 1.2, 0.75), id="table")
    chair = h.thing("chair", 2, 0.8 - 0.2 + 0.25, DOWN, size=(0.5, 0.5, 0.8), id="chair")
    chest = h.thing("sideboard", 2, 1.1 + behind + 0.2, UP, size=(0.4, 1.2, 0.8), id="sideboard")
    home = h.home(table, chair, chest)
    assert blocked(home) == {Fault("chair", PLACE, "table")}
    result = opened(home)
    moved = np.subtract(result.objects[1].center, chair.center)
    assert moved == pytest.approx([0, back, 0], abs=1e-6)
    # It neither goes nor counts as blocked where it has to stay.
    assert len(result.objects) == 3 and result.walkable.blocked == []


def test_what_cannot_be_freed_is_named():
    """A drawer longer than the room, in what the room does not do without."""
    chest = h.chest(5.35, 1.5, 0, h.BEDROOM, travel=4.0, id="chest").model_copy(update={"category": "wardrobe"})
    result = opened(h.home(chest))
    assert [tuple(fault.model_dump().values()) for fault in result.walkable.blocked] == [("chest", "drawer", "wall")]
    assert result.walkable.dropped == []


def test_the_least_important_goes_when_nothing_else_helps():
    size = (2.9, 2.98, 0.8)
    chest = h.thing("wardrobe", 1.5, 1.5, 0, size=size, id="chest", joints=(h.drawer(size, 0.9),))
    plant = h.thing("plant", 3.8, 1.5, size=(0.3, 2.9, 1.0), id="plant")
    home = h.home(chest, plant).model_copy(update={"openings": []})
    result = opened(home)
    assert result.walkable.dropped == ["plant"] and result.walkable.blocked == []
    kept = opened(home, drop=False)
    assert kept.walkable.dropped == [] and kept.walkable.blocked


def test_doors_of_the_flat_itself_turn_freely():
    assert stuck_doors(building(h.plan())) == set()


def furnished(seed, libraries):
    """The flat with real assets as they stand in many homes: a desk with its chair drawn up, a basket under a rail."""
    rng = np.random.default_rng(seed)

    def piece(category, x, y, yaw, bottom=0.0, room=h.LIVING):
        found = list(libraries.alternatives(category, TABLE[category].size, np.zeros(32)))
        asset = found[int(rng.integers(len(found)))]
        about = {"size": asset.size, "bottom": bottom, "joints": tuple(asset.joints), "id": category}
        made = h.thing(category, x, y, yaw, room, **about)
        return made.model_copy(update={"asset": AssetKey(library=asset.library, id=asset.id)})

    desk = piece("desk", 2.6, 0.36 + rng.uniform(0, 0.02), UP)
    chair = piece("office_chair", 2.6 + rng.uniform(-0.3, 0.3), 0.75 + rng.uniform(0, 0.2), DOWN)
    basket = piece("laundry_basket", 3.0, 2.75, DOWN)
    rail = piece("towel_rail", 3.0 + rng.uniform(-0.1, 0.1), 2.9, DOWN, 0.6 + rng.uniform(0, 0.3))
    return h.home(desk, chair, basket, rail)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_the_simulator_agrees(seed, tmp_path):
    """Every joint turns through its range in MuJoCo, once repaired."""
    mujoco = pytest.importorskip("mujoco")
    from test_acceptance import driven

    from apartgen.stages import export

    libraries = retrieve.open_libraries()
    result = opened(furnished(seed, libraries), libraries)
    assert result.walkable.blocked == []
    export.run(result, ["mjcf"], tmp_path / "scene", libraries.load_asset)
    world = mujoco.MjModel.from_xml_path(str(tmp_path / "scene/mjcf/apartment.xml"))
    faults = [driven(mujoco, world, j) for j in range(world.njnt) if world.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE]
    assert [fault for fault in faults if fault] == []


def test_some_of_these_flats_are_blocked_before():
    libraries = retrieve.open_libraries()
    assert sum(bool(blocked(furnished(seed, libraries), libraries)) for seed in range(6)) >= 3


def test_another_design_is_of_the_same_style_and_material_and_brings_its_latent():
    libraries = retrieve.open_libraries()
    usual = TABLE["wardrobe"].size
    for asset in list(libraries.alternatives("wardrobe", usual, np.zeros(0)))[:4]:
        old = h.thing("wardrobe", 2, 2.6, DOWN, size=asset.size, joints=tuple(asset.joints), id="wardrobe")
        old = old.model_copy(update={"asset": AssetKey(library=asset.library, id=asset.id),
                                     "latent": np.round(asset.latent, 4).tolist()})
        home = h.home(old)
        site = survey(home, WalkableConfig(), libraries)
        found = [to["wardrobe"] for to in designs.redesigned(site, tuple(home.objects), old)]
        made = [libraries.load_asset(o.asset.library, o.asset.id) for o in found]
        unlike = [(a.style != asset.style) + (designs.main_material(a) != designs.main_material(asset)) for a in made]
        assert len(made) > 4 and unlike == sorted(unlike) and min(unlike) < 2
        assert old.asset not in [o.asset for o in found]
        for o, a in zip(found, made, strict=True):
            own = next(iter(libraries.alternatives("wardrobe", o.size, np.asarray(o.latent))))
            assert own.style == a.style


def test_a_smaller_one_keeps_the_design():
    libraries = retrieve.open_libraries()
    for asset in libraries.alternatives("sofa", TABLE["sofa"].size, np.zeros(0)):
        less = np.asarray(asset.size) * 0.9
        found = libraries.nearest("sofa", less, asset.latent, less, asset.id)
        assert found.style == asset.style and found.id.split("/")[-1] == asset.id.split("/")[-1]


def test_what_is_in_the_way_gets_another_design_before_it_gets_smaller_or_goes():
    libraries = retrieve.open_libraries()
    units = []
    for k, (name, wide) in enumerate((("kitchen_sink", 0.6), ("kitchen_base", 0.3))):
        asset = next(iter(libraries.alternatives(name, (0.6, wide, 0.9), np.zeros(0))))
        made = h.thing(name, 1 + 0.45 * k, 2.7, DOWN, size=asset.size, joints=tuple(asset.joints), id=name)
        units.append(made.model_copy(update={"asset": AssetKey(library=asset.library, id=asset.id)}))
    sink, base = units
    site = survey(h.home(*units), WalkableConfig(), libraries)
    tried = [change for change in unblock._changes(site, tuple(units), Fault(sink.id, "door", base.id), sink, base)
             if change.object.id == base.id and change.action != "nudge"]
    new = [change.to[base.id] for change in tried]
    as_large = [o is not None and np.allclose(o.size, base.size, atol=0.02) for o in new]
    assert as_large == sorted(as_large, reverse=True), "then smaller ones, at last none"
    assert any(o is not None and o.size == base.size and o.asset != base.asset for o in new)
