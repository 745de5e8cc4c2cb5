"""What homes have and do without, whatever the model draws: fridges, daylight for plants, screens, sofas, hooks."""

from typing import Any

import numpy as np
import pytest

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import AskedObjects, Plan, Room
from apartgen.stages import layout, seeds, use
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.relations import home as relations_home
from apartgen.stages.layout.relations import living, propose
from apartgen.stages.layout.relations.infer import Contents
from apartgen.stages.layout.rooms import of_plan
from apartgen.stages.plan import build, from_polygons
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.plan.study import archetypes
from apartgen.stages.things.categories import CATEGORIES

ONE = LayoutConfig(model="relations", candidates=2, threads=1)
CORNER = {"corner_sofa": 1, "sofa": 0}


def home(seed: int) -> Plan:
    plan: Plan = build(archetypes()["one_bedroom"], PlanConfig(), np.random.default_rng(seed))
    return plan


def made(plan: Plan, seed: int = 1, config: LayoutConfig = ONE) -> Layout:
    return layout.run(plan, config, seeds.drawn(seed, "layout", seeds.plan_digest(plan)))


def chances(room: Room, rng: np.random.Generator) -> Any:
    return seeds.lane(rng, room.id + " habits").random(len(living.WAYS))


@pytest.mark.parametrize(("wide", "deep", "seed"), [(2.0, 2.2, 1), (2.0, 2.2, 2), (1.97, 2.34, 3)])
def test_a_small_kitchen_can_do_without_a_washing_machine_and_not_without_a_fridge(
    wide: float, deep: float, seed: int
) -> None:
    drawn = [
        ("living_room", [(wide, 0), (wide + 5, 0), (wide + 5, 5), (wide, 5)]),
        ("kitchen", [(0, 0), (wide, 0), (wide, deep), (0, deep)]),
        ("bathroom", [(0, deep), (wide, deep), (wide, 5), (0, 5)]),
    ]
    plan = from_polygons([Room(id=f"{name}_1", type=name, polygon=ring) for name, ring in drawn], PlanConfig())
    for config in (ONE, ONE.model_copy(update={"candidates": 4})):
        found = {o.category for o in made(plan, seed, config).objects if o.room == "kitchen_1"}
        assert {"fridge", "kitchen_sink"} <= found and {"oven", "hob"} & found, found


def test_plants_stand_where_daylight_comes() -> None:
    """Halls without a window or a room that they are open to have none, unless it is asked for."""
    halls = [(plan, room.id) for plan in map(home, range(3, 9)) for room in plan.rooms if room.type == "hallway"]
    dark = [(plan, id) for plan, id in halls if not any(o.kind in ("window", "opening") and id in o.rooms
                                                        for o in plan.openings)]
    assert dark
    for plan, id in dark:
        asked = plan.program.model_copy(update={"objects": [AskedObjects(room=id, category="plant", count=1)]})
        for these, count in ((plan, 0), (plan.model_copy(update={"program": asked}), 1)):
            found = made(these, config=ONE.model_copy(update={"room": [id]})).objects
            assert sum(o.category == "plant" for o in found if o.room == id) == count


def test_some_living_rooms_have_no_television_or_a_corner_sofa_unless_otherwise_asked() -> None:
    plan, room = next((plan, room) for plan in map(home, range(9)) for room in plan.rooms
                      if room.base == "living_room" and use.site(plan, room.id).area > 20)
    one = ONE.model_copy(update={"room": [room.id], "candidates": 1})
    drawn = {k: seeds.drawn(k, "layout", seeds.plan_digest(plan)) for k in range(400)}
    ways = {k: living.draw(plan, room, chances(room, rng)) for k, rng in drawn.items()}
    bare, round_ = ([k for k, found in ways.items() if any(some.get(name) == many for some in found)]
                    for name, many in (("tv", 0), ("corner_sofa", 1)))
    assert 0.14 < len(bare) / len(drawn) < 0.26 and 0.24 < len(round_) / len(drawn) < 0.36
    for some, asked in ((bare, "tv"), (round_, "sofa")):
        objects = [AskedObjects(room=room.id, category=asked, count=1)]
        wished = plan.program.model_copy(update={"objects": objects})
        four = one.model_copy(update={"candidates": 4})  # in a single sample one thing may find no place
        for these, config, count in ((plan, one, 0), (plan.model_copy(update={"program": wished}), four, 1)):
            found = layout.run(these, config, drawn[some[0]]).objects
            assert sum(o.category == asked for o in found if o.room == room.id) == count


def test_ways_of_living_are_as_many_as_they_say_and_of_rooms_one_lives_in() -> None:
    plan = home(3)
    room = next(room for room in plan.rooms if room.base == "living_room")
    floor, rng = use.site(plan, room.id).area, np.random.default_rng(0)
    drawn = [living.draw(plan, room, rng.random(len(living.WAYS))) for _ in range(1500)]
    for way in living.WAYS:
        share = np.mean([way.counts in found for found in drawn])
        assert abs(share - way.share * (floor >= way.floor and not way.people)) < 0.05, way
    never = [0.0] * len(living.WAYS)
    others = [other for other in plan.rooms if other.base not in ("living_room", "bathroom", "bedroom", "utility")]
    assert others and not any(living.draw(plan, other, never) for other in others)
    studio: Plan = build(archetypes()["studio"], PlanConfig(), np.random.default_rng(3))
    (lived,) = (other for other in studio.rooms if other.base == "living_room")
    assert living.draw(studio, lived, never) == [living.NO_SCREEN.counts], "one may do without a screen there, too"


@pytest.mark.parametrize("beds, wide, more", [(2, 6.0, True), (1, 6.0, False), (2, 4.6, False)])
def test_many_people_have_two_armchairs_in_a_wide_living_room(beds: int, wide: float, more: bool) -> None:
    """Of 30 m² where four sleep; not where two do, nor in one of 22 m²."""
    rooms = [("living_room", [(0, 0), (wide, 0), (wide, 5), (0, 5)])]
    rooms += [("bedroom", [(wide, 4 * k), (wide + 4, 4 * k), (wide + 4, 4 * k + 4), (wide, 4 * k + 4)])
              for k in range(beds)]
    plan = from_polygons([Room(id=f"{name}_{k}", type=name, polygon=ring) for k, (name, ring) in enumerate(rooms)],
                         PlanConfig())
    rng = np.random.default_rng(0)
    drawn = [living.draw(plan, plan.rooms[0], rng.random(len(living.WAYS))) for _ in range(400)]
    share = np.mean([living.unless_told(found, set()).get("armchair") == 2 for found in drawn])
    assert share == pytest.approx((1 - 0.75 * 0.4 if more else 0.25) * (1 - 0.2), abs=0.06), "none by a second sofa"


def test_what_one_does_without_costs_what_it_would_if_missed() -> None:
    plan = home(3)
    place = use.site(plan, next(room.id for room in plan.rooms if room.base == "living_room"))
    screen, corner, none = {"tv_stand": 0, "tv": 0}, {"corner_sofa": 1, "sofa": 0}, {"plant": 0}
    assert living.forgone(place, []) == living.forgone(place, [corner, {"armchair": 2}]) == 0
    assert living.forgone(place, [screen]) == pytest.approx(1.3), "wants.toml"
    assert living.forgone(place, [none, screen, corner]) == pytest.approx(1.4)


def test_what_is_told_goes_before_ways_of_living() -> None:
    ways = [{"tv_stand": 0, "tv": 0}, {"armchair": 2}, {"side_table": 0}, {"side_table": 2}]
    assert living.unless_told(ways, set()) == {"tv_stand": 0, "tv": 0, "armchair": 2, "side_table": 2}
    assert living.unless_told(ways, {"tv"}) == {"armchair": 2, "side_table": 2}
    assert living.unless_told(ways, {"side_table", "armchair", "bed"}) == {"tv_stand": 0, "tv": 0}


def test_a_hall_one_enters_has_hooks_beside_a_cupboard_unless_it_is_counted_or_none_are_wanted() -> None:
    for seed in range(3, 9):
        plan = home(seed)
        door = next(o for o in plan.openings if o.kind == "entrance")
        room = next(room for room in plan.rooms if room.id in door.rooms)
        if room.base != "hallway":
            continue
        one = ONE.model_copy(update={"room": [room.id]})
        none = {"objects": [AskedObjects(room=room.id, category="coat_rack", count=0)]}
        for change, counts in (({}, {1}), (none, {0}), ({"counts": {room.id: 2}}, {0, 1})):
            program = plan.program.model_copy(update=change)
            found = made(plan.model_copy(update={"program": program}), config=one).objects
            there = [o.category for o in found if o.room == room.id]
            assert there.count("coat_rack") in counts
            assert "counts" not in change or len(there) == 2


def test_half_of_main_bedrooms_are_to_have_a_television_before_the_bed_and_no_child_has() -> None:
    plan = home(4)
    bed = next(room for room in plan.rooms if room.base == "bedroom")
    drawn = [seeds.drawn(k, "layout", seeds.plan_digest(plan)) for k in range(400)]
    site = use.site(plan, bed.id)
    assert site.main and site.area >= living.FLOOR
    watched = [rng for rng in drawn if living.SCREEN in living.draw(plan, bed, chances(bed, rng))]
    assert 0.48 < len(watched) / len(drawn) < 0.62
    rooms = [room.model_copy(update={"children": 2 if room.id == bed.id else None}) for room in plan.program.rooms]
    theirs = plan.model_copy(update={"program": plan.program.model_copy(update={"rooms": rooms})})
    assert not any(living.SCREEN in living.draw(theirs, bed, chances(bed, rng)) for rng in drawn)
    config = ONE.model_copy(update={"room": [bed.id], "candidates": 4})
    seen = []
    for rng in watched[:6]:
        found = {o.category: o for o in layout.run(plan, config, rng).objects if o.room == bed.id}
        if "tv_stand" in found:
            stand, sleeper = found["tv_stand"], found["double_bed"]
            ahead = np.subtract(stand.center[:2], sleeper.center[:2]) @ (np.cos(sleeper.yaw), np.sin(sleeper.yaw))
            turned = np.cos(stand.yaw - sleeper.yaw)
            seen.append(ahead > sleeper.size[0] / 2 and turned < -0.9)
    assert len(seen) >= 3 and all(seen)


def test_a_room_with_a_sofa_of_its_own_gets_none_round_a_corner() -> None:
    plan, i = next((plan, i) for plan in map(home, range(9)) for i, room in enumerate(plan.rooms)
                   if room.base == "living_room" and use.site(plan, room.id).area > 20)
    x, y = np.mean(plan.rooms[i].polygon, axis=0)
    sofa = Box(id="own", room=plan.rooms[i].id, category="sofa", center=(x, y, 0.4), size=(0.9, 2.0, 0.8), yaw=0.0)
    rng = seeds.drawn(1, "layout", seeds.plan_digest(plan))
    for given, there in (([], True), ([sofa], False)):
        arrays = of_plan(plan, 0.5)
        task = relations_home._task(plan, i, arrays, ONE, given)
        _, names = relations_home._sampler(plan, task, i, arrays, ONE, 4, rng, given, [CORNER])
        assert [("corner_sofa" in some) for some in names] == [there] * 4


@pytest.mark.wide
def test_nobody_sleeps_in_a_living_room_beside_bedrooms_unless_a_bed_is_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whatever the model says: here, that a bed for two comes as soon as one may."""
    beds = {"double_bed", "single_bed", "bunk_bed"}
    said = Contents.following

    def sleepy(model: Contents, x: Any, left: Any) -> Any:
        logits = said(model, x, left).copy()
        logits[:, CATEGORIES.index("double_bed")] += 30
        return logits

    monkeypatch.setattr(Contents, "following", sleepy)
    flat, studio = home(3), build(archetypes()["studio"], PlanConfig(), np.random.default_rng(3))
    lived = next(room.id for room in flat.rooms if room.base == "living_room")
    wished = flat.program.model_copy(update={"objects": [AskedObjects(room=lived, category="single_bed", count=1)]})
    for plan, slept_in in ((flat, set()), (studio, {"double_bed"}),
                           (flat.model_copy(update={"program": wished}), {"single_bed"})):
        room = next(room for room in plan.rooms if room.base == "living_room")
        found = {o.category for o in made(plan, config=ONE.model_copy(update={"room": [room.id]})).objects
                 if o.room == room.id}
        assert found & beds == slept_in


def test_coat_racks_are_as_deep_as_wide(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the model says: here, that all things are half as wide again as deep."""
    said = propose._Rooms._candidates

    def wide(rooms: propose._Rooms, *asked: Any) -> Any:
        found = said(rooms, *asked)
        found[..., 4] = 1.5 * found[..., 3]
        return found

    monkeypatch.setattr(propose._Rooms, "_candidates", wide)
    plan = home(3)
    hall = next(room.id for room in plan.rooms if room.type == "hallway")
    wish = plan.program.model_copy(update={"objects": [AskedObjects(room=hall, category="coat_rack", count=1)]})
    found = made(plan.model_copy(update={"program": wish}), config=ONE.model_copy(update={"room": [hall]})).objects
    (rack,) = [o for o in found if o.room == hall and o.category == "coat_rack"]
    assert rack.size[0] == rack.size[1]


def test_laundry_baskets_are_where_linen_is_kept_and_in_no_bedroom_unless_asked_for() -> None:
    plan = home(6)
    bath, bed = (next(room for room in plan.rooms if room.base == kind) for kind in ("bathroom", "bedroom"))
    assert use.site(plan, bath.id).area >= 4.0
    drawn = [seeds.drawn(k, "layout", seeds.plan_digest(plan)) for k in range(200)]
    kept = [rng for rng in drawn if living.draw(plan, bath, chances(bath, rng))[0]["laundry_basket"]]
    assert 0.15 < len(kept) / len(drawn) < 0.35
    for room, asked, count in ((bath, (), 1), (bed, (), 0), (bed, (1,), 1)):
        wished = [AskedObjects(room=room.id, category="laundry_basket", count=n) for n in asked]
        these = plan.model_copy(update={"program": plan.program.model_copy(update={"objects": wished})})
        config = ONE.model_copy(update={"room": [room.id]})
        found = [[o.category for o in layout.run(these, config, rng).objects if o.room == room.id] for rng in kept[:4]]
        assert max(some.count("laundry_basket") for some in found) == count  # where it finds a place
    assert not living.draw(plan.model_copy(update={"rooms": [bed]}), bed, chances(bed, drawn[0]))
