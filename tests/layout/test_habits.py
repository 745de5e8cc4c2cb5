"""Things stand where people put them: hoods over hobs, rugs under tables, kitchens in a row, mirrors over basins."""

from collections import Counter

import numpy as np
import pytest
from rooms_for_tests import one_room, some_rooms

from apartgen.stages.layout.projection import comfort, runs
from apartgen.stages.layout.projection.costs import BROKEN
from apartgen.stages.layout.projection.habits import habits
from apartgen.stages.layout.projection.partners import LOW_RUN, around, in_run, long_enough
from apartgen.stages.layout.projection.project import _rank, project
from apartgen.stages.layout.projection.space import Space, space_of
from apartgen.stages.layout.projection.standing import Item, Standing
from apartgen.stages.layout.sense import essentials
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import CATEGORIES, TABLE

NOTHING: tuple[Boxes, list[str]] = Boxes(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0)), []
KITCHEN = ["fridge", "kitchen_sink", "kitchen_base", "hob", "hood", "wall_unit"]


def strewn(names: list[str], rng: np.random.Generator) -> list[Item]:
    """Things of usual sizes anywhere near the middle of a room."""
    return [
        Item(name, np.array([*rng.uniform(-1.2, 1.2, 2), 0.5]), np.array(TABLE[name].size), rng.uniform(-3, 3))
        for name in names
    ]


def in_frame(item: Item, of: Item) -> np.ndarray:
    c, s = np.cos(of.yaw), np.sin(of.yaw)
    return np.array([[c, s], [-s, c]]) @ (item.center[:2] - of.center[:2])


def settled(names: list[str], seed: int, room: int = 0) -> tuple[dict[str, Item], Space]:
    space = space_of(some_rooms(8, room), seed)
    done = project(strewn(names, np.random.default_rng(seed)), space)
    return {item.category: item for item in done if item.cost < BROKEN}, space


def test_every_habit_names_furniture_that_there_is() -> None:
    for name, rows in habits().items():
        assert name in CATEGORIES
        for habit in rows:
            assert set(habit.at) <= set(CATEGORIES) and habit.worth > 0


@pytest.mark.parametrize("seed", range(8))
def test_kitchen_units_stand_in_a_row(seed: int) -> None:
    found, _ = settled(KITCHEN, seed)
    low = [item for item in found.values() if item.category in LOW_RUN]
    assert len(low) == 4
    bodies = Boxes(np.array([o.center for o in low]), np.array([o.size for o in low]), np.array([o.yaw for o in low]))
    near = boxes.gap(bodies) < 0.01
    # Two legs of a run round a corner need not touch.
    assert (near.any(1)).sum() >= 3
    cooker, hood = found["hob"], found.get("hood")
    if hood is not None and abs(in_frame(hood, cooker)[1]) < 0.01:
        assert hood.size[1] == pytest.approx(np.clip(cooker.size[1], 0.5, 0.95))


def test_a_hood_hangs_over_the_hob_and_a_mirror_over_the_basin_at_eye_level() -> None:
    over = [settled(KITCHEN, seed)[0] for seed in range(8)]
    over = [found for found in over if "hood" in found]
    assert sum(abs(in_frame(found["hood"], found["hob"])[1]) < 0.01 for found in over) >= len(over) - 2
    mirrors = [settled(["vanity", "toilet", "mirror"], seed)[0] for seed in range(8)]
    assert sum(abs(in_frame(found["mirror"], found["vanity"])[1]) < 0.01 for found in mirrors) >= 6
    assert all(found["mirror"].center[2] >= 1.5 for found in mirrors)


def test_rugs_lie_under_tables_and_lamps_hang_over_them() -> None:
    beneath = 0
    for seed in range(6):
        found, _ = settled(["dining_table", "rug", "ceiling_lamp"], seed)
        table, rug = found["dining_table"], found["rug"]
        assert np.linalg.norm(found["ceiling_lamp"].center[:2] - table.center[:2]) < 0.01
        beneath += bool(np.linalg.norm((rug.center - table.center)[:2]) < 0.01 and (rug.size > table.size)[:2].all())
    assert beneath >= 4, "a table at a wall has no room for a rug that reaches out"


def test_a_lone_lamp_hangs_in_the_middle() -> None:
    found, space = settled(["ceiling_lamp"], 3)
    half = (space.corners.max(0) - space.corners.min(0)) / 2
    assert (np.abs(found["ceiling_lamp"].center[:2]) < 0.15 * half + 0.1).all()


def test_the_television_stands_across_from_the_sofa() -> None:
    met = 0
    for seed in range(8):
        found, _ = settled(["sofa", "tv_stand"], seed)
        sofa, stand = found["sofa"], found["tv_stand"]
        met += in_frame(sofa, stand)[0] > abs(in_frame(sofa, stand)[1])
    assert met >= 6


def test_the_television_stands_where_the_sofa_looks() -> None:
    aside = []
    for seed in range(8):
        found, _ = settled(["sofa", "tv_stand", "coffee_table"], seed)
        if {"sofa", "tv_stand"} <= set(found) and in_frame(found["tv_stand"], found["sofa"])[0] > 1.2:
            aside.append(abs(in_frame(found["tv_stand"], found["sofa"])[1]))
    assert len(aside) >= 6 and np.median(aside) < 0.1


def one(name: str, x: float, y: float, yaw: float) -> Boxes:
    size = np.array(TABLE[name].size)
    return Boxes(np.array([[x, y, size[2] / 2]]), size[None], np.array([yaw]))


def test_floor_before_a_toilet_is_kept_free() -> None:
    space = space_of(some_rooms(8, 0), 0)
    toilet, before, aside = one("toilet", 0, 0, 0), one("bin", 0.6, 0, 0), one("bin", 0, 0.7, 0)
    for place, least, most in ((before, 1, 9), (aside, 0, 0)):
        alone = comfort.price("bin", place, space, *NOTHING)[0]
        assert least <= comfort.price("bin", place, space, toilet, ["toilet"])[0] - alone <= most
    assert comfort.price("toilet", toilet, space, before, ["bin"])[0] > 1
    assert comfort.price("toilet", toilet, space, aside, ["bin"])[0] == 0


def test_a_chair_stands_where_it_can_be_drawn_back() -> None:
    space = space_of(some_rooms(8, 0), 0)
    east = space.corners[:, 0].max()
    tight, wide = (one("chair", east - gap, 0, np.pi) for gap in (0.35, 0.9))
    assert comfort.price("chair", tight, space, *NOTHING)[0] > 1 > comfort.price("chair", wide, space, *NOTHING)[0]


def test_a_table_is_long_enough_for_its_chairs() -> None:
    assert long_enough("dining_table", np.array([0.9, 1.0, 0.75]), 4)[1] == 1.0
    for chairs in (5, 6, 8):
        grown = long_enough("dining_table", np.array([0.9, 1.0, 0.75]), chairs)
        table = Boxes(np.zeros((1, 3)), grown[None], np.zeros(1))
        assert len(around(np.array([0.5, 0.5, 0.9]), table)) >= chairs


def test_chairs_choose_right_after_their_table() -> None:
    names = ["armchair", "chair", "coffee_table", "dining_table", "chair", "sideboard"]
    items = strewn(names, np.random.default_rng(0))
    for essential in ((), (3,), (0, 3, 5)):
        order = sorted(range(len(items)), key=lambda i: _rank(i, items, essential))
        at = order.index(3)
        assert set(order[at + 1 : at + 3]) == {1, 4}


def test_a_shower_stays_where_a_cabinet_could_go() -> None:
    names = ["vanity", "toilet", "shower", "laundry_basket"]
    kept = essentials(names, "bathroom", Counter())
    assert kept == {0, 1, 2}


def test_bins_stand_out_of_the_way() -> None:
    for seed in range(8):
        found, space = settled(["bin", "plant"], seed)
        for item in found.values():
            assert space.away(item.center[None, :2])[0] < item.size[:2].max() / 2 + 0.3


def test_no_table_stands_between_the_sofa_and_what_it_looks_at() -> None:
    rooms = [found for found in (settled(["sofa", "dining_table"], seed)[0] for seed in range(8)) if len(found) == 2]
    assert len(rooms) >= 6
    for found in rooms:
        ahead, aside = in_frame(found["dining_table"], found["sofa"])
        assert not (0 < ahead < 1.2 and abs(aside) < 0.8)


def test_radiators_hang_below_windows() -> None:
    below = 0
    for seed in range(8):
        found, space = settled(["radiator"], seed)
        middle = space.spans[space.window].mean(1)
        below += bool(np.abs(middle - found["radiator"].center[:2]).max() < 0.1)
    assert below >= 7


def test_a_chair_for_which_a_table_has_no_seat_does_not_stand_about() -> None:
    for seed in range(4):
        space = space_of(some_rooms(8, 0), seed)
        names = ["round_table"] + ["chair"] * 9
        done = project(strewn(names, np.random.default_rng(seed)), space, essential={0})
        placed = [item for item in done if item.cost < BROKEN]
        assert len(placed) < len(done)
        table = done[0]
        assert sum(np.linalg.norm((item.center - table.center)[:2]) < 1.4 for item in placed[1:]) >= 4


def test_two_people_sit_across_the_table() -> None:
    across = 0
    for seed in range(8):
        space = space_of(some_rooms(8, 0), seed)
        table = Item("dining_table", np.array([0.0, 0.2, 0.38]), np.array([0.9, 1.6, 0.75]), 0.0)
        chairs = [Item("chair", np.array([0.6, y, 0.45]), np.array([0.5, 0.47, 0.9]), np.pi) for y in (-0.2, 0.5)]
        one, two = project([table, *chairs], space)[1:]
        across += bool(np.linalg.norm((one.center - two.center)[:2]) > 0.9)
    assert across >= 6


@pytest.mark.parametrize(("x", "y", "yaw", "depth", "flush"), [
    (0.0, 0.6, 0.0, 0.6, True), (0.02, 0.61, 0.0, 0.6, True), (0.045, 0.6, 0.0, 0.6, False),
    (0.0, 0.63, 0.0, 0.6, False), (0.0, 0.6, np.pi, 0.6, False), (-0.05, 0.6, 0.0, 0.5, True),
    (0.05, 0.6, 0.0, 0.5, False),
])
def test_units_of_a_run_are_flush_and_have_their_backs_in_line(
    x: float, y: float, yaw: float, depth: float, flush: bool
) -> None:
    sink = Boxes(np.array([[0.0, 0.0, 0.45]]), np.array([[0.6, 0.6, 0.9]]), np.zeros(1))
    here = Boxes(np.array([[x, y, 0.45]]), np.array([[depth, 0.6, 0.9]]), np.array([yaw]))
    assert in_run("kitchen_base", here, sink, ["kitchen_sink"]).tolist() == [flush]


def test_runs_begin_at_the_same_places_of_a_room_that_is_turned() -> None:
    """Beside a door and a fridge, from corners; the walls' frame turns with the room."""
    found = []
    for by in (0.0, 0.5):
        turn = np.array([[np.cos(by), -np.sin(by)], [np.sin(by), np.cos(by)]])
        rooms = one_room()
        rooms.polygon[0] = rooms.polygon[0] @ turn.T
        for ends in (slice(0, 2), slice(2, 4)):
            rooms.openings[0, :, ends] = rooms.openings[0, :, ends] @ turn.T
        fridge = Item("fridge", np.array([*turn @ [-1.66, 0.3], 0.9]), np.array([0.65, 0.6, 1.8]), by)
        standing = Standing([fridge])
        standing.put(0, fridge)
        found.append(np.stack(runs._starts(space_of(rooms, 0), standing), -1))
    assert len(found[0]) > 8 and found[1] == pytest.approx(found[0], abs=1e-5)
