"""Rooms drawn under constraints break none of them, whatever the weights say."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from rooms_for_tests import some_rooms

from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import AskedObjects, Plan
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.datasets import single_rooms
from apartgen.stages.layout.datasets.furnisher import furnish
from apartgen.stages.layout.projection.space import outside, space_of
from apartgen.stages.layout.relations import order, runs, trained
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.home import furnished
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.standing import BROKEN, Furniture, tuck
from apartgen.stages.layout.relations.tokens import shell
from apartgen.stages.layout.rooms import of_plan
from apartgen.stages.space import boxes
from apartgen.stages.things.categories import TABLE

TYPES = ("living_room", "bedroom", "kitchen", "bathroom", "hallway", "study")


@pytest.fixture(scope="module")
def ignorant(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Weights that have learned nothing."""
    path: Path = tmp_path_factory.mktemp("weights") / "w.safetensors"
    config = Training(shape=Shape(width=32, heads=2, scene_layers=1, frame_layers=1, key=8))
    trained.save(trained.empty(config), path, config, {})
    return str(path)


@cache
def plan(seed: int) -> Plan:
    return single_rooms.draw(np.random.default_rng(seed), TYPES[seed % len(TYPES)])


def made(file: str, plan: Plan, seed: int = 0, **given: object) -> tuple[Layout, list[str]]:
    config = LayoutConfig(model="relations", weights=file, candidates=2, **given)
    return furnished(plan, config, np.random.default_rng(seed))


def hard(home: Layout) -> list:
    return [o for o in home.objects if not TABLE[o.category].soft]


@pytest.mark.parametrize("seed", range(6))
def test_nothing_collides_leaves_the_room_or_stands_in_a_doorway(ignorant: str, seed: int) -> None:
    home, _ = made(ignorant, plan(seed), seed)
    stands = hard(home)
    deep = boxes.penetration(boxes.of(stands))
    for i, a in enumerate(stands):
        for j, b in enumerate(stands):
            assert deep[i, j] < 0.01 + tuck(a.category, b.category) * (i != j), (a.id, b.id)
    arrays = of_plan(home)
    space = space_of(arrays, 0)
    here = boxes.of(stands)
    here.center[:, :2] -= arrays.origin[0]
    assert (outside(here, space) < 0.011).all()
    assert (boxes.penetration(here, space.zones.take(~space.window)) < 0.011).all()


@pytest.mark.parametrize("seed", range(6))
def test_what_is_put_on_others_stands_on_them(ignorant: str, seed: int) -> None:
    home, _ = made(ignorant, plan(seed), seed)
    for o in home.objects:
        if TABLE[o.category].place == "top":
            low = o.center[2] - o.size[2] / 2
            assert any(abs(low - under.center[2] - under.size[2] / 2) < 0.03 for under in home.objects)


def test_without_constraints_the_same_weights_break_them(ignorant: str) -> None:
    found = [hard(made(ignorant, plan(seed), seed, constraints=False)[0]) for seed in range(12)]
    assert any((boxes.penetration(boxes.of(stands)) > 0.05).any() for stands in found if len(stands) > 1)


@pytest.mark.parametrize("seed", (0, 1, 6, 7))
def test_the_number_asked_for_is_met_or_said(ignorant: str, seed: int) -> None:
    asked = plan(seed).model_copy(deep=True)
    room = asked.rooms[0].id
    asked.program.counts[room] = 6
    asked.program.objects.append(AskedObjects(room=room, category="plant", count=2))
    home, notes = made(ignorant, asked, seed)
    short = len(home.objects) < 6 or sum(o.category == "plant" for o in home.objects) < 2
    assert not short or any("asked for" in note for note in notes)
    assert len(home.objects) <= 6


def test_given_objects_stay_as_they_are(ignorant: str) -> None:
    home, _ = made(ignorant, plan(0), 3)
    given = home.objects[:2]
    assert len(given) == 2
    config = LayoutConfig(model="relations", weights=ignorant, candidates=1, keep=True)
    again, _ = furnished(plan(0), config, np.random.default_rng(9), given)
    assert again.objects[:2] == given
    assert len({o.id for o in again.objects}) == len(again.objects)


def test_a_room_hangs_on_its_seed_alone(ignorant: str) -> None:
    one, two, other = (made(ignorant, plan(1), seed)[0] for seed in (4, 4, 5))
    assert one == two != other


def furniture(*things: tuple[str, tuple[float, ...]]) -> Furniture:
    """An empty room of 6 × 6 m about its middle with a few things (x, y, yaw, depth, width, low, high)."""
    room = Plan.model_validate({
        "prompt": "", "program": {"rooms": [{"id": "kitchen_1", "type": "kitchen"}]}, "height": 2.6, "openings": [],
        "rooms": [{"id": "kitchen_1", "type": "kitchen", "polygon": [[0, 0], [6, 0], [6, 6], [0, 6]]}]})
    there = Furniture(space_of(of_plan(room), 0))
    for name, box in things:
        there.add(name, np.array(box, np.float32))
    return there


def price(there: Furniture, name: str, *box: float) -> float:
    return float(there.prices(name, np.array([box], np.float32))[0])


@pytest.mark.parametrize("category, size", [("dining_table", (0.9, 1.6)), ("desk", (0.7, 1.4))])
def test_a_seat_is_drawn_under_a_table_forwards_only(category: str, size: tuple[float, float]) -> None:
    there = furniture((category, (0.0, 0.0, 0.0, *size, 0.0, 0.75)))
    x = size[0] / 2 + 0.1
    assert price(there, "chair", x, 0.2, np.pi, 0.5, 0.45, 0.0, 0.9) < BROKEN, "facing the table"
    for yaw in (0.0, np.pi / 2, -np.pi / 2):
        assert price(there, "chair", x, 0.2, yaw, 0.5, 0.45, 0.0, 0.9) >= BROKEN
    assert price(there, "chair", 0.0, size[1] / 2 + 0.1, -np.pi / 2, 0.5, 0.45, 0.0, 0.9) < BROKEN, "at its end"
    apart = np.array([[x + 0.5, 0.2, np.pi / 2, 0.5, 0.45, 0.0, 0.9]], np.float32)
    assert there.prices("chair", apart)[0] >= BROKEN, "apart it is of no use"
    assert there.prices("chair", apart, loose=True)[0] < BROKEN, "and breaks nothing"


def test_units_of_a_run_stand_side_by_side() -> None:
    base = (-2.695, 0.0, 0.0, 0.6, 0.6, 0.0, 0.9)
    there = furniture(("kitchen_base", base))
    flush = price(there, "hob", -2.695, 0.6, 0.0, 0.6, 0.6, 0.0, 0.9)
    apart = price(there, "hob", -2.695, 0.9, 0.0, 0.6, 0.6, 0.0, 0.9)
    turned = price(there, "hob", -2.695, 0.605, np.pi, 0.6, 0.6, 0.0, 0.9)
    assert flush < min(apart, turned)
    assert price(there, "dining_table", 1.0, 0.0, 0.0, 0.9, 2.0, 0.0, 0.8) == 0, "others need no neighbour"


def test_a_hood_hangs_above_what_cooks() -> None:
    there = furniture(("hob", (-2.695, 0.0, 0.0, 0.6, 0.6, 0.0, 0.9)))
    over = price(there, "hood", -2.745, 0.0, 0.0, 0.5, 0.6, 1.6, 2.2)
    assert over < price(there, "hood", -2.745, 1.0, 0.0, 0.5, 0.6, 1.6, 2.2)


def test_units_of_furnished_kitchens_are_in_their_runs_round_corners_too() -> None:
    wished = []
    for seed in range(12):
        rng = np.random.default_rng([5, seed])
        home = single_rooms.draw(rng, "kitchen")
        units = [o for o in furnish(home, rng) if o.category in order.runs()]
        rows = [(o.category, (*o.center[:2], o.yaw, *o.size[:2], 0.0, o.size[2])) for o in units]
        for k, (name, row) in enumerate(rows):
            others = rows[:k] + rows[k + 1 :]
            there = np.array([row for _, row in others], np.float32).reshape(-1, 7)
            wished.append(runs.touching(name, np.array([row], np.float32), [other for other, _ in others], there)[0])
    assert len(wished) > 50 and np.mean(wished) > 0.9


def test_places_that_continue_a_run_are_flush_with_it() -> None:
    there = furniture(("kitchen_base", (-2.695, -2.08, 0.0, 0.6, 0.6, 0.0, 0.9)))
    room = Plan.model_validate({
        "prompt": "", "program": {"rooms": [{"id": "kitchen_1", "type": "kitchen"}]}, "height": 2.6, "openings": [],
        "rooms": [{"id": "kitchen_1", "type": "kitchen", "polygon": [[0, 0], [6, 0], [6, 6], [0, 6]]}]})
    said = np.array([[1.0, 1.0, 0.3, 0.6, 0.6, 0.0, 0.9], [2.0, 1.0, 0.3, 0.6, 0.8, 0.0, 0.9]], np.float32)
    found = runs.further("hob", said, there.names, there.boxes, shell(of_plan(room), 0))
    assert runs.touching("hob", found, there.names, there.boxes).sum() >= 4, "both sides, in both sizes, and the corner"
    assert {tuple(np.round(size, 2)) for size in found[:, 3:5].tolist()} == {(0.6, 0.6), (0.6, 0.8)}
    assert any(abs(box[2] - np.pi / 2) < 0.01 and abs(box[1] + 2.695) < 0.01 for box in found), "round the corner"
    assert not len(runs.further("sofa", said, there.names, there.boxes, shell(of_plan(room), 0)))


def test_what_cooks_stands_rather_beside_a_window_than_before_it() -> None:
    room = Plan.model_validate({
        "prompt": "", "program": {"rooms": [{"id": "kitchen_1", "type": "kitchen"}]}, "height": 2.6,
        "openings": [{"id": "window_1", "kind": "window", "rooms": ["kitchen_1"], "segment": [[-0.15, 4], [-0.15, 2]],
                      "sill": 0.95, "head": 2.2}],
        "rooms": [{"id": "kitchen_1", "type": "kitchen", "polygon": [[0, 0], [6, 0], [6, 6], [0, 6]]}]})
    there = Furniture(space_of(of_plan(room), 0))
    before, beside = ((-2.695, y, 0.0, 0.6, 0.6, 0.0, 0.9) for y in (0.0, 2.0))
    assert price(there, "hob", *beside) < price(there, "hob", *before) < BROKEN
    assert price(there, "kitchen_sink", *beside) == price(there, "kitchen_sink", *before)


def test_a_unit_takes_the_place_of_one_that_a_run_can_do_without() -> None:
    assert runs.spare("dishwasher") and runs.spare("kitchen_drawers") and not runs.spare("hob")
    assert not runs.spare("kitchen_sink") and not runs.spare("fridge") and not runs.spare("sofa")
    box = np.array([-2.695, 0.5, 0.0, 0.6, 0.6, 0.0, 0.9], np.float32)
    said = np.array([[0, 0, 1.0, 0.66, 0.8, 0, 0.9], [1, 0, 2.0, 0.66, 0.8, 0, 0.9], [1, 0, 2.0, 0.6, 0.55, 0, 1.8]])
    found = runs.in_place("fridge", said.astype(np.float32), box)
    assert sorted(found[:, 4].tolist()) == pytest.approx([0.55, 0.6]), "no wider than what stood there"
    assert found[:, 0] - found[:, 3] / 2 == pytest.approx(np.full(2, box[0] - box[3] / 2)), "backs in line"
    above = np.array([[-2.7, 0.45, 0.0, 0.3, 0.4, 0.9, 1.2], [-2.7, 0.45, 0.0, 0.3, 0.6, 1.4, 2.0],
                      [-2.7, 1.5, 0.0, 0.3, 0.4, 0.9, 1.2]], np.float32)
    assert runs.carried(np.concatenate([box[None], above]), 0).tolist() == [True, True, False, False]


@pytest.mark.parametrize("lane, used", [(0.40, False), (0.49, False), (0.62, True), (0.80, True)])
def test_a_drawer_is_used_from_a_lane_that_the_robot_gets_into(lane: float, used: bool) -> None:
    """A nightstand between a bed and a wall: the robot is .5 m wide and stands before the drawer."""
    rooms = some_rooms(1)
    rooms.polygon[0, :4] = np.array([[-1.8, -2], [1.8, -2], [1.8, 2], [-1.8, 2]], np.float32)
    rooms.openings[0, 0] = [-1.6, -2, -0.8, -2, 0, -1, 0]
    rooms.openings[0, 1] = [0.6, 2, -0.6, 2, 3, 0, 0]
    room = Furniture(space_of(rooms, 0))
    room.add("double_bed", np.array([1.8 - lane - 0.8, 1.0, -np.pi / 2, 2.0, 1.6, 0, 0.5]))  # head at the north wall
    stand = np.array([1.8 - 0.19, 1.8, -np.pi / 2, 0.4, 0.36, 0, 0.5])
    assert (room.shuts("nightstand", stand) < 0.25) == used
    assert room.shuts("nightstand", stand, loose=True) < 0.25


@pytest.mark.parametrize("under, stands", [("nightstand", True), ("chair", False), ("sofa", False), ("cot", False)])
def test_a_lamp_stands_on_no_seat_and_no_bed(under: str, stands: bool) -> None:
    there = furniture((under, (0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.5)))
    assert (price(there, "table_lamp", 0.0, 0.0, 0.0, 0.2, 0.2, 0.5, 0.9) < BROKEN) == stands


@pytest.mark.parametrize("under, stands", [("tv_stand", True), ("rug", False)])
def test_no_television_stands_on_a_rug(under: str, stands: bool) -> None:
    there = furniture((under, (0.0, 0.0, 0.0, 0.5, 1.6, 0.0, 0.012)))
    assert (price(there, "tv", 0.0, 0.0, 0.0, 0.06, 1.1, 0.012, 0.7) < BROKEN) == stands


@pytest.mark.parametrize("names, widths, gone", [
    (["kitchen_base", "kitchen_drawers", "kitchen_sink"], [0.6, 0.6, 0.6], [True, True, False]),
    (["kitchen_base", "kitchen_drawers", "oven"], [0.9, 0.6, 0.6], [False, True, False]),
    (["kitchen_base", "kitchen_sink", "kitchen_corner"], [0.6, 0.6, 0.9], [False, False, False]),
])
def test_a_dishwasher_takes_the_place_of_one_of_several_cupboards(names: list[str], widths: list[float],
                                                                  gone: list[bool]) -> None:
    there = np.zeros((len(names), 7), np.float32)
    there[:, 4] = widths
    assert [runs.gives_way(names, there, k, "dishwasher") for k in range(len(names))] == gone
    assert [runs.gives_way(names, there, k, "fridge") for k in range(len(names))] == [runs.spare(o) for o in names]
