"""Faults of use: by hand, by name, under every symmetry, and rooms put out of order."""

import ast
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from lived_in import EAST, NORTH, ROOMS, SOUTH, WEST, room, thing
from syntax import tree_of

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan, Room
from apartgen.stages import use
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.site import Hole


def names(place: use.Furnished) -> set[str]:
    return {fault.name for fault in use.faults(place)}


@pytest.mark.parametrize("kind", ROOMS)
def test_rooms_in_order_have_no_fault(kind: str) -> None:
    width, depth, things = ROOMS[kind]
    assert names(room(kind, width, depth, *things())) == set()


def wishes(place: use.Furnished) -> list[tuple[str, float, float]]:
    return [(lack.name, round(lack.number, 6), round(lack.cost, 6)) for lack in use.lacks(place)]


def turned(things: list[Box], by: float) -> list[Box]:
    c, s = np.cos(by), np.sin(by)
    return [o.model_copy(update={"center": (o.center[0] * c - o.center[1] * s, o.center[0] * s + o.center[1] * c,
                                            o.center[2]), "yaw": o.yaw + by}) for o in things]


@pytest.mark.parametrize("kind", ROOMS)
def test_faults_and_lacks_do_not_hang_on_the_frame(kind: str) -> None:
    """A room turned by any angle, its objects in any order, is the same room."""
    rng = np.random.default_rng(7)
    width, depth, things = ROOMS[kind]
    for _ in range(6):
        out = [o.model_copy(update={"center": tuple(np.add(o.center, [*rng.normal(0, 0.4, 2), 0]))}) for o in things()]
        here = room(kind, width, depth, *out)
        by = float(rng.uniform(0, 2 * np.pi))
        corners = turned([thing("plant", x, y) for x, y in here.site.corners], by)
        polygon = [(o.center[0], o.center[1]) for o in corners]
        order = rng.permutation(len(out))
        there = use.Furnished(use.alone(Room(id="r_1", type=kind, polygon=polygon)),  # type: ignore[arg-type]
                              [turned(out, by)[k] for k in order])
        # What lies within rounding of a threshold may fall on either side of it: samples of floor, one in 36.
        assert len(names(here) ^ names(there)) <= 1
        assert wishes(here) == wishes(there)


def test_every_fault_has_a_weight_and_every_weight_a_fault() -> None:
    said = set()
    for file in (Path(use.__file__).parent / "rules").glob("*.py"):
        for node in ast.walk(tree_of(file.read_text())):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Fault":
                text = ast.unparse(node.args[0])
                said |= {w for w in use.weights() if repr(w) in text} or {
                    w for w in use.weights() if text.startswith("f'") and w.startswith(text[2:].partition("{")[0])}
    assert said == set(use.weights()) and all(0 < weight <= 2 for weight in use.weights().values())
    assert set(use.activities().values()) == set(use.rules())


SPOILED = [
    ("living_room", "tv_stand", (4.75, 0.5, WEST), "sofa not facing the television"),
    ("living_room", "tv_stand", (2.5, 3.77, NORTH), "television that nobody watches"),
    ("living_room", "coffee_table", (4.2, 3.0, NORTH), "coffee table not before the sofa"),
    ("living_room", "coffee_table", (2.5, 2.0, NORTH), "coffee table out of reach"),
    ("living_room", "sofa", (2.5, 0.47, SOUTH), "sofa looks at a near wall"),
    ("living_room", "armchair", (0.5, 3.5, WEST), "armchair looks at nothing"),
    ("living_room", "armchair", (2.5, 1.3, NORTH), "something right before the sofa"),
    ("living_room", "armchair", (0.8, 1.9, WEST), "armchair turned from the group"),
    ("kitchen", "hob", (3.96, 0.31, NORTH), "hob in the corner"),
    ("kitchen", "hob", (2.85, 0.31, NORTH), "no worktop between sink and hob"),
    ("kitchen", "fridge", (2.9, 0.31, NORTH), "tall unit between sink and hob"),
    ("bedroom", "double_bed", (1.6, 2.0, EAST), "bed head off the wall"),
    ("bedroom", "double_bed", (1.06, 0.85, EAST), "one side to get into double bed"),
    ("bedroom", "nightstand", (2.5, 3.7, SOUTH), "nightstand away from bed"),
    ("bedroom", "wardrobe", (3.0, 2.0, WEST), "wardrobe off the wall"),
    ("bedroom", "wardrobe", (2.5, 2.0, WEST), "no floor before the wardrobe"),
    ("bedroom", "wardrobe", (3.24, 3.2, NORTH), "wardrobe off the wall"),
    ("dining_room", "chair", (0.4, 0.4, WEST), "chair at nothing"),
    ("dining_room", "chair", (1.6, 0.9, SOUTH), "chair at nothing"),
    ("kitchen", "hood", (1.5, 0.25, NORTH), "hood not above the hob"),
    ("kitchen", "hob", (3.5, 2.5, SOUTH), "kitchen unit alone"),
    ("kitchen", "fridge", (3.9, 2.5, WEST), "fridge apart from the run"),
    ("kitchen", "kitchen_sink", (2.2, 2.5, SOUTH), "little worktop beside sink and hob"),
    ("bathroom", "vanity", (1.2, 1.0, WEST), "no floor before the toilet"),
    ("bathroom", "shower", (0.46, 1.65, EAST), "no elbow room at the toilet"),
    ("bathroom", "mirror", (1.2, 2.97, SOUTH), "mirror not above the basin"),
]


@pytest.mark.parametrize(("kind", "category", "place", "name"), SPOILED)
def test_what_is_put_out_of_order_is_named_with_what_it_is_about(kind, category, place, name) -> None:  # type: ignore
    width, depth, things = ROOMS[kind]
    out = things()
    k = next(i for i, o in enumerate(out) if o.category == category)
    out[k] = thing(category, *place, size=out[k].size)
    found = [fault for fault in use.faults(room(kind, width, depth, *out)) if fault.name == name]
    assert found and (name.startswith(("no floor", "no elbow", "something", "little"))
                      or any(out[k].id in fault.objects or category in ("kitchen_sink", "tv_stand") for fault in found))


def said(kind: str, *things: Box, size: tuple[float, float] = (6.0, 6.0)) -> set[str]:
    return names(room(kind, *size, *things))


def test_who_sits_at_a_sofas_end_sees_the_television_too() -> None:
    group = [thing("sofa", 3.0, 0.47, NORTH, (0.9, 2.2, 0.8)), thing("tv_stand", 3.0, 5.77, SOUTH)]
    barred = {x: said("living_room", *group, thing("chair", x, 2.0, NORTH)) for x in (3.0, 2.4, 1.2)}
    assert "view of the television barred" in barred[3.0]
    assert "view of the television barred in part" in barred[2.4] - barred[3.0]
    assert not any(name.startswith("view") for name in barred[1.2])


@pytest.mark.parametrize(("wide", "small"), [(1.0, True), (1.5, False)])
def test_a_screen_is_watched_from_no_further_than_three_diagonals(wide: float, small: bool) -> None:
    """4.5 m away: 3.9 times the diagonal of 1 m of width at 16 : 9, 2.6 times that of 1.5 m."""
    group = [thing("sofa", 3.0, 0.5, NORTH, (1.0, 2.0, 0.8)), thing("tv_stand", 3.0, 5.7, SOUTH, (0.4, 1.6, 0.5)),
             thing("tv", 3.0, 5.7, SOUTH, (0.1, wide, 0.6), 0.5)]
    assert ("television small for its distance" in said("living_room", *group)) == small


def test_two_hang_their_clothes_in_more_than_a_narrow_wardrobe() -> None:
    bed = thing("double_bed", 1.06, 2.0, EAST)
    for widths, little in (((0.8,), True), ((0.8, 0.8), False), ((1.2,), False)):
        robes = [thing("wardrobe", 5.69, 1.5 + 2 * k, WEST, (0.6, wide, 2.0)) for k, wide in enumerate(widths)]
        assert ("little wardrobe for two" in said("bedroom", bed, *robes)) == little
    assert "little wardrobe for two" not in said("bedroom", thing("single_bed", 1.06, 2.0, EAST),
                                                 thing("wardrobe", 5.69, 1.5, WEST, (0.6, 0.8, 2.0)))


def test_an_armchair_belongs_to_the_group_and_leaves_chairs_to_be_drawn_back() -> None:
    group = [thing("sofa", 1.0, 0.47, NORTH, (0.9, 2.0, 0.8)), thing("coffee_table", 1.0, 1.6, NORTH)]
    assert "armchair apart from the group" in said("living_room", *group, thing("armchair", 5.4, 5.4, WEST))
    table = [thing("dining_table", 4.4, 4.0, NORTH), *(thing("chair", 4.4 + dx, 4.0 + dy, SOUTH if dy > 0 else NORTH)
                                                      for dx in (-0.4, 0.4) for dy in (-0.6, 0.6))]
    chair = thing("armchair", 4.2, 2.65, WEST)
    assert "armchair against the dining table" in said("living_room", *group, *table, chair)
    assert "armchair against the dining table" not in said("living_room", *group, chair)


@pytest.mark.parametrize(("aside", "company"), [(-59.5, True), (0, True), (59.5, True), (60.5, False), (-60.5, False)])
def test_a_coffee_table_is_an_armchairs_where_it_is_no_more_than_60_degrees_aside(aside: float, company: bool) -> None:
    """A table of half a metre whose middle is 1.2 m away: at most 90 cm from the chair."""
    x, y = 1.2 * np.cos(np.radians(aside)), 1.2 * np.sin(np.radians(aside))
    found = said("living_room", thing("armchair", 3.0, 3.0, EAST),
                 thing("coffee_table", 3.0 + x, 3.0 + y, EAST, (0.5, 0.5, 0.4)))
    assert ("armchair looks at nothing" not in found) == company


def test_coats_hang_near_the_entrance() -> None:
    for x, far in ((1.0, False), (7.5, True)):
        place = room("hallway", 8.0, 2.0, thing("coat_rack", x, 1.7, SOUTH))
        place.site = replace(place.site, holes=(Hole("d", "entrance", (0.4, 0.0), (1.3, 0.0), 0.0, 2.1, True, 0),))
        assert ("coats far from the entrance" in names(place)) == far


def test_doors_and_windows_are_kept_clear() -> None:
    import handmade

    home = handmade.home(handmade.thing("bookshelf", 3.7, 1.45, WEST, id="case"),
                         handmade.thing("wardrobe", 5.5, 0.35, NORTH, handmade.BEDROOM, id="robe"),
                         handmade.thing("tv_stand", 5.5, 0.25, NORTH, handmade.BEDROOM, id="stand"))
    living, bedroom = (list(use.faults(use.of_plan(home, id, home.objects)))
                       for id in (handmade.LIVING, handmade.BEDROOM))
    assert ("stands in a doorway", ("case", "door_1")) in living
    assert ("tall before a window", ("robe", "window_1")) in bedroom
    assert ("television before a window", ("stand",)) in bedroom
    assert not any(fault.name == "tall before a window" and "stand" in fault.objects for fault in bedroom)


def test_openings_lie_on_the_rooms_own_walls_with_the_room_to_the_left() -> None:
    import handmade

    for id in (handmade.LIVING, handmade.BEDROOM):
        here = use.site(handmade.plan(), id)
        for hole in here.holes:
            x, y, c, s = hole.frame
            inside = np.array([x, y]) + 0.2 * np.array([c, s])
            assert use.kernels.within(*inside, here.start, here.end)
            assert hole.width == pytest.approx(1.0 if hole.kind == "window" else 0.9)
            middle = np.array(hole.middle)
            share = ((middle - here.start) * here.along).sum(1).clip(0, here.length)
            assert np.hypot(*(here.start + share[:, None] * here.along - middle).T).min() < 1e-9


def test_free_floor_is_the_share_of_points_outside_of_everything() -> None:
    """Against shapely, on rectangles in L-shaped rooms."""
    from shapely.affinity import rotate
    from shapely.geometry import Polygon, box

    rng, off = np.random.default_rng(0), []
    corners = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
    place = Room(id="r_1", type="bedroom", polygon=corners)
    for _ in range(40):
        out = [thing("chest", *rng.uniform(0, 4, 2), yaw=float(rng.uniform(0, 6)), id=f"c{k}") for k in range(3)]
        here = use.Furnished(use.alone(place), out)
        ahead, left = (0.3, 0.3 + rng.uniform(0.2, 1)), (-rng.uniform(0.1, 0.6), rng.uniform(0.1, 0.6))
        x, y, c, s = here.frame(0)
        zone = Polygon([(x + a * c - b * s, y + a * s + b * c) for a, b in
                        ((ahead[0], left[0]), (ahead[1], left[0]), (ahead[1], left[1]), (ahead[0], left[1]))])
        boxes = [rotate(box(o.center[0] - o.size[0] / 2, o.center[1] - o.size[1] / 2, o.center[0] + o.size[0] / 2,
                            o.center[1] + o.size[1] / 2), o.yaw, use_radians=True) for o in out[1:]]
        true = zone.intersection(Polygon(corners)).difference(boxes[0]).difference(boxes[1]).area / zone.area
        off.append(abs(here.open(0, ahead, left) - true))
    assert max(off) < 0.12 and np.mean(off) < 0.03


def test_plans_say_who_lives_there() -> None:
    import handmade

    rooms = [("bedroom_1", 12.0), ("bedroom_2", 8.0), ("living_room_1", 20.0)]
    base = handmade.plan()

    def home(*chosen: tuple[str, float]) -> Plan:
        polygons = [{"id": id, "type": id[:-2], "polygon": handmade.rectangle(10 * k, 0, area / 2, 2)}
                    for k, (id, area) in enumerate(chosen)]
        return Plan.model_validate({**base.model_dump(), "rooms": polygons, "openings": []})

    from apartgen.stages.use.household import eats_in, sleepers

    assert sleepers(home(*rooms)) == 3 and sleepers(home(rooms[1], rooms[2])) == 1
    assert sleepers(home(rooms[2])) is None and sleepers(home(rooms[2], ("bathroom_1", 4.0))) == 1
    living, kitchen, little = ("living_room_1", 20.0), ("kitchen_1", 14.0), ("kitchen_2", 8.0)
    beds = [(f"bedroom_{k}", 12.0) for k in (1, 2, 3)]
    for chosen, where in (((living, kitchen), "kitchen_1"), ((living, little), "living_room_1"), ((living,), None),
                          ((living, kitchen, ("dining_room_1", 9.0)), "dining_room_1"),
                          ((living, kitchen, *beds), "living_room_1"), ((living, kitchen, *beds[:2]), "kitchen_1"),
                          ((living, ("kitchen_1", 13.8), *beds[:2]), "living_room_1"),
                          ((living, ("kitchen_1", 10.6), beds[0]), "kitchen_1"),
                          ((("living_room_1", 10.0), little), "kitchen_2")):
        assert eats_in(home(*chosen)) == where
        assert [use.site(home(*chosen), id).meals for id, _ in chosen] == [id == where for id, _ in chosen]


@pytest.mark.parametrize("name, x, size, dark", [
    ("wardrobe", 2.5, (0.6, 1.3, 2.1), True), ("wardrobe", 3.8, (0.6, 1.3, 2.1), False),
    ("wardrobe", 2.0, (0.6, 0.4, 2.1), False), ("wardrobe", 2.2, (0.6, 0.8, 2.1), True),
    ("chest", 2.5, (0.5, 1.2, 0.85), False),
])
def test_tall_things_take_no_more_than_a_quarter_of_a_windows_light(
        name: str, x: float, size: tuple[float, float, float], dark: bool) -> None:
    """A window a metre wide in the south wall, from 2 to 3 m."""
    window = Hole("window_1", "window", (2.0, 0.0), (3.0, 0.0), 0.9, 2.2, False, 0)
    site = replace(use.alone(Room(id="r_1", type="bedroom", polygon=[(0, 0), (5, 0), (5, 4), (0, 4)])), holes=(window,))
    place = use.Furnished(site, [thing(name, x, size[0] / 2 + 0.01, NORTH, size)])
    assert ("tall before a window" in names(place)) is dark


@pytest.mark.parametrize(("x", "yaw", "under"), [
    (2.5, NORTH, True), (1.6, NORTH, True), (1.45, NORTH, False), (2.5, EAST, False)])
def test_nobody_sleeps_with_the_head_at_a_window(x: float, yaw: float, under: bool) -> None:
    """A bed 1.6 m wide at the south wall, its window from 2 to 3 m, of which .3 m behind a bed are too much."""
    window = Hole("window_1", "window", (2.0, 0.0), (3.0, 0.0), 0.9, 2.2, False, 0)
    site = replace(use.alone(Room(id="r_1", type="bedroom", polygon=[(0, 0), (5, 0), (5, 4), (0, 4)])), holes=(window,))
    bed = thing("double_bed", x, 1.02 if yaw == NORTH else 2.0, yaw, (2.0, 1.6, 0.9))
    assert ("head of the bed at a window" in names(use.Furnished(site, [bed]))) is under


def test_one_of_several_beside_is_beside_and_none_is_not() -> None:
    place = room("living_room", 5.0, 4.0, thing("sofa", 2.5, 0.47, NORTH), thing("side_table", 3.9, 0.4),
                 thing("side_table", 0.5, 3.5), thing("plant", 4.7, 3.7))
    assert place.beside(0, frozenset({"side_table"}), 0.5) and place.beside(0, frozenset({"side_table", "plant"}), 0.5)
    assert not place.beside(0, frozenset({"plant"}), 0.5) and not place.beside(0, frozenset({"armchair"}), 0.5)


def test_rooms_are_told_what_they_are_for() -> None:
    import handmade

    from apartgen.stages.use.household import OPEN, duties

    def told(*chosen: tuple[str, float]) -> dict[str, tuple[int, ...]]:
        polygons = [{"id": id, "type": id[:-2], "polygon": handmade.rectangle(20 * k, 0, area / 2, 2)}
                    for k, (id, area) in enumerate(chosen)]
        plan = Plan.model_validate({**handmade.plan().model_dump(), "rooms": polygons, "openings": []})
        return {room.id: tuple(duties(plan, room)) for room in plan.rooms}

    home = told(("living_room_1", 20.0), ("kitchen_1", 8.0), ("bedroom_1", 12.0), ("bedroom_2", 9.0),
                ("bathroom_1", 5.0))
    assert home == {"living_room_1": (1, 0, 0, 0), "kitchen_1": (0, 0, 0, 0), "bedroom_1": (0, 0, 0, 1),
                    "bedroom_2": (0, 0, 0, 0), "bathroom_1": (0, 0, 1, 0)}
    studio = told(("living_room_1", 22.0), ("kitchen_1", 7.0))
    assert studio == {"living_room_1": (1, 1, 0, 0), "kitchen_1": (0, 0, 1, 0)}
    apart = told(("living_room_1", 22.0), ("dining_room_1", 9.0), ("bedroom_1", 12.0))
    assert apart["living_room_1"][0] == 0 and apart["dining_room_1"][0] == 1
    assert told(("bedroom_1", 12.0)) == {"bedroom_1": tuple(OPEN)}


@pytest.mark.parametrize("x, width, before", [
    (2.5, 0.5, True), (3.59, 0.5, True), (3.61, 0.5, False), (1.41, 0.5, True), (1.39, 0.5, False), (3.3, 3.0, True),
    (4.39, 3.0, True), (4.41, 3.0, False)])
def test_a_table_is_before_a_sofa_with_three_tenths_of_the_narrower(x: float, width: float, before: bool) -> None:
    """A sofa 2 m wide, from 1.5 to 3.5 m; a table that reaches past its end, however much narrower it is."""
    sofa = thing("sofa", 2.5, 0.47, NORTH, (0.9, 2.0, 0.8))
    place = room("living_room", 8.0, 4.0, sofa, thing("coffee_table", x, 1.6, NORTH, (0.5, width, 0.4)))
    assert ("coffee table not before the sofa" not in names(place)) is before


def test_a_coffee_table_is_near_one_of_those_it_serves() -> None:
    """Of two sofas that face each other across it, one within reach is enough; from a corner sofa it never is far."""
    table, near = thing("coffee_table", 2.5, 1.6, NORTH, (0.6, 1.1, 0.4)), thing("sofa", 2.5, 0.47, NORTH)
    far = thing("sofa", 2.5, 3.25, SOUTH)
    for sofas, fault in (([near, far], False), ([near], False), ([far], True)):
        assert ("coffee table out of reach" in names(room("living_room", 5.0, 4.0, table, *sofas))) is fault


@pytest.mark.parametrize("name, size, meals, seats", [
    ("dining_table", (0.8, 1.0, 0.75), True, 4), ("dining_table", (0.8, 1.0, 0.75), False, 2),
    ("dining_table", (0.8, 1.8, 0.75), False, 4), ("round_table", (1.0, 1.0, 0.75), False, 4)])
def test_only_a_little_table_beside_the_one_where_they_eat_has_two_seats(
        name: str, size: tuple[float, float, float], meals: bool, seats: int) -> None:
    from apartgen.stages.use.wants import seats_wanted

    place = room("living_room", 5.0, 4.0, thing(name, 2.5, 2.0, NORTH, size))
    place.site = replace(place.site, sleepers=4, meals=meals)
    assert seats_wanted(place, 0) == seats


@pytest.mark.parametrize("name, minded", [
    ("rug", False), ("laundry_basket", False), ("bin", False), ("chest", True), ("shoe_cabinet", True)])
def test_what_one_steps_on_or_pushes_aside_takes_no_floor_before_a_toilet(name: str, minded: bool) -> None:
    width, depth, things = ROOMS["bathroom"]
    before = thing(name, 1.0, 1.0, WEST, (0.4, 0.7, TABLE[name].size[2]))
    assert ("no floor before the toilet" in names(room("bathroom", width, depth, *things(), before))) == minded
