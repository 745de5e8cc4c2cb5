"""What is used with something: candidates against the rules of use, which look at finished rooms."""

import numpy as np
import pytest
from lived_in import NORTH, room, thing
from rooms_for_tests import box

from apartgen.schemas.layout import Box
from apartgen.stages import use
from apartgen.stages.layout.relations import company, views
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE

HOSTS = {
    "chair": thing("dining_table", 3.0, 2.5, NORTH),
    "nightstand": thing("double_bed", 3.0, 1.1, NORTH),
    "coffee_table": thing("sofa", 3.0, 0.5, NORTH),
    "tv_stand": thing("sofa", 3.0, 0.5, NORTH),
    "side_table": thing("armchair", 3.0, 2.5, NORTH),
    "pouffe": thing("sofa", 3.0, 2.5, NORTH), "armchair": thing("sofa", 3.0, 0.5, NORTH),
}
FAULTS = {
    "chair": {"chair at nothing"}, "nightstand": {"nightstand away from bed"},
    "coffee_table": {"coffee table not before the sofa"},
    "tv_stand": {"sofa not facing the television", "sofa aside of the television", "television that nobody watches"},
    "side_table": {"side table at no seat"}, "pouffe": {"stool at nothing"},
    "armchair": {"armchair turned from the group", "armchair apart from the group"},
}


def token(o: Box) -> np.ndarray:
    low = o.center[2] - o.size[2] / 2
    return np.array([*o.center[:2], o.yaw, *o.size[:2], low, low + o.size[2]], np.float32)


def scattered(name: str, n: int, seed: int = 0) -> list[Box]:
    """Candidates in a room of 6 x 5 m, square to its walls."""
    rng = np.random.default_rng(seed)
    at = rng.uniform([0.4, 0.4], [5.6, 4.6], (n, 2))
    return [thing(name, float(x), float(y), float(rng.integers(4) * np.pi / 2)) for x, y in at]


@pytest.mark.parametrize("name", HOSTS)
def test_what_is_let_through_has_no_fault_of_use(name: str) -> None:
    host, candidates = HOSTS[name], scattered(name, 1500)
    alone = company.alone(name, np.stack([token(o) for o in candidates]), [host.category], token(host)[None])
    found = [{f.name for f in use.faults(room("living_room", 6, 5, host, o))} for o in candidates]
    faulty = np.array([bool(FAULTS[name] & names) for names in found])
    apart = np.array(["things stand in one another" not in names for names in found])
    assert not (faulty & ~alone).any()
    assert alone[~faulty & apart].mean() < 0.75, "much of what could be used is let through"
    assert (~faulty & apart).any() and faulty.any()


@pytest.mark.parametrize("name", HOSTS)
def test_the_same_wherever_the_room_lies(name: str) -> None:
    candidates, host = np.stack([token(o) for o in scattered(name, 200)]), token(HOSTS[name])[None]
    turn, by = 0.7, np.array([3.0, -8.0])
    c, s = np.cos(turn), np.sin(turn)

    def moved(boxes: np.ndarray) -> np.ndarray:
        out = boxes.copy()
        out[:, :2] = boxes[:, :2] @ np.array([[c, s], [-s, c]]) + by
        out[:, 2] += turn
        return out

    names = [HOSTS[name].category]
    assert (company.alone(name, candidates, names, host) == company.alone(name, moved(candidates), names,
                                                                          moved(host))).mean() > 0.99


@pytest.mark.parametrize("name, lost", [("chair", True), ("nightstand", True), ("coffee_table", True),
                                        ("side_table", False), ("balcony_chair", False)])
def test_what_only_serves_something_has_no_place_without_it(name: str, lost: bool) -> None:
    boxes = np.stack([token(o) for o in scattered(name, 50)])
    found = company.alone(name, boxes, ["wardrobe"], token(thing("wardrobe", 1, 1))[None])
    assert found.all() if lost else not found.any()


@pytest.mark.parametrize("name", [o for o in ("wardrobe", "piano", "dining_table") if o in TABLE])
def test_nothing_large_is_put_right_before_a_sofa(name: str) -> None:
    sofa = thing("sofa", 3.0, 0.5, NORTH)
    depth = TABLE["sofa"].size[0]
    right, far = thing(name, 3.0, 0.5 + depth / 2 + 0.45, NORTH), thing(name, 3.0, 4.2, NORTH)
    found = company.alone(name, np.stack([token(right), token(far)]), ["sofa"], token(sofa)[None])
    assert found.tolist() == [True, False]


SOFA, SCREEN = (0.0, 0.0, 0.0, 0.9, 2.0, 0.0, 0.8), (3.5, 0.0, np.pi, 0.4, 1.6, 0.0, 0.5)


@pytest.mark.parametrize("x, y, yaw, bars", [
    (2.0, 0.0, 0.0, True), (2.0, 0.6, 0.0, True),  # .9 x 1.6 m: its long half reaches .2 m past the middle
    (2.0, 0.9, 0.0, False), (2.0, 0.6, np.pi / 2, False),  # beside the view, and so when it is turned
    (-1.5, 0.0, 0.0, False), (5.0, 0.0, 0.0, False),  # behind the sofa, behind the screen
])
def test_no_table_stands_between_sofa_and_television_whichever_comes_last(
    x: float, y: float, yaw: float, bars: bool
) -> None:
    things = {"sofa": SOFA, "tv_stand": SCREEN, "dining_table": (x, y, yaw, 0.9, 1.6, 0.0, 0.75)}
    for last in things:
        there = [name for name in things if name != last]
        boxes = np.array([things[name] for name in there])
        assert views.barred(last, np.array([things[last]]), there, boxes).tolist() == [bars]
    assert not views.barred("bookshelf", np.array([things["dining_table"]]), list(things)[:2], boxes).any()


@pytest.mark.parametrize("x, y, yaw, seen", [
    (3.5, 0.0, np.pi, True), (4.2, 0.5, np.pi, True),     # afar and a little aside, better than none
    (5.4, 0.0, np.pi, False), (3.0, 2.5, np.pi, False),   # too far; 40 degrees aside
    (3.5, 0.0, 0.0, False), (-3.0, 0.0, 0.0, False),      # turned away; behind the sofa
])
def test_a_television_is_seen_from_the_sofa_or_left_out(x: float, y: float, yaw: float, seen: bool) -> None:
    television = np.array([(x, y, yaw, 0.1, 1.2, 0.5, 1.2)])
    assert company.alone("tv", television, ["sofa"], np.array([SOFA])).tolist() == [not seen]
    assert not company.alone("tv", television, ["double_bed"], np.array([SOFA])).any() and company.follows("tv")


@pytest.mark.parametrize("left, there, may", [
    (["chair", "dining_table", "plant"], [], {"dining_table", "plant"}),
    (["chair", "plant"], [], {"chair", "plant"}),                       # there is none to wait for
    (["chair", "dining_table"], ["desk"], {"chair", "dining_table"}),   # it may be the desk's
    (["nightstand", "coffee_table", "double_bed"], ["sofa"], {"coffee_table", "double_bed"}),
])
def test_what_only_serves_something_waits_for_it(left: list[str], there: list[str], may: set[str]) -> None:
    assert set(company.next_of(left, there)) == may


def test_where_one_sleeps_the_wardrobe_comes_before_shelves_and_armchairs() -> None:
    left = ["armchair", "wardrobe", "bookshelf"]
    assert set(company.next_of(left, ["double_bed"])) == set(company.next_of(left, ["cot"])) == {"wardrobe"}
    assert set(company.next_of(left, ["sofa"])) == set(left), "nobody sleeps there"
    assert set(company.next_of(["armchair", "bookshelf"], ["double_bed"])) == {"armchair", "bookshelf"}
    assert set(company.next_of(left, ["double_bed", "sliding_wardrobe"])) == set(left)


def test_in_a_room_begun_anew_the_bed_comes_before_what_one_can_do_without() -> None:
    left = ["tv_stand", "double_bed", "sofa", "armchair"]
    assert set(company.next_of(left, [])) == set(left)
    assert set(company.next_of(left, [], anew=True)) == {"double_bed", "sofa"}
    assert set(company.next_of(["tv_stand", "armchair"], ["double_bed"], anew=True)) == {"tv_stand", "armchair"}


@pytest.mark.parametrize("x, y, yaw, good", [
    (3.0, 2.9, -NORTH, True),      # across the low table from the sofa
    (4.5, 1.4, np.pi, True),       # beside it, looking at it
    (4.6, 0.5, NORTH, False),      # in line with the sofa, looking past all of it
    (4.55, 0.5, np.pi, False),     # looking into the arm of the sofa
    (3.0, 3.05, -NORTH, True),     # farther off
    (3.0, 3.2, -NORTH, False),     # out of reach of the table
])
def test_an_armchair_stands_about_the_low_table_and_looks_into_no_arm(x: float, y: float, yaw: float,
                                                                      good: bool) -> None:
    sofa, table = thing("sofa", 3.0, 0.5, NORTH), thing("coffee_table", 3.0, 1.6, NORTH)
    chair = token(thing("armchair", x, y, yaw))[None]
    there = np.stack([token(sofa), token(table)])
    assert bool(company.alone("armchair", chair, ["sofa", "coffee_table"], there)[0]) != good


@pytest.mark.parametrize("ahead, good", [(0.45, False), (0.7, False), (1.3, True)])
def test_a_side_table_stands_beside_a_seat(ahead: float, good: bool) -> None:
    """Not where the feet of who sits there are, m from the seat's middle; a low table is reached over them."""
    seat = thing("armchair", 3.0, 2.5, NORTH)
    before = token(thing("side_table", 3.0, 2.5 + ahead + 0.2, NORTH))[None]
    judges = [wanted for mine, _, wanted in company.RULES if "side_table" in mine]
    assert all(bool(wanted(company.Seen(before, token(seat)[None]), ["armchair"])[0]) for wanted in judges[1:]) == good


def test_cupboards_wait_for_the_hooks_at_the_entrance() -> None:
    left = ["wardrobe", "shoe_cabinet", "bench", "coat_rack", "mirror"]
    assert company.next_of(left, []) == ["coat_rack"]
    assert company.next_of(left[:-1], ["coat_rack"]) == left[:-1] and company.next_of(left[:3], []) == left[:3]


@pytest.mark.parametrize("wardrobe", ["wardrobe", "sliding_wardrobe"])
def test_mirrors_wait_for_what_may_stand_before_them(wardrobe: str) -> None:
    left = [wardrobe, "shoe_cabinet", "mirror"]
    assert company.next_of(left, []) == left[:2]
    assert company.next_of(left, [wardrobe]) == left and company.next_of(left[1:], []) == left[1:]


def test_lamps_wait_for_what_they_stand_on() -> None:
    left = ["table_lamp", "nightstand", "rug"]
    assert company.next_of(left, ["single_bed"]) == ["nightstand", "rug"]
    assert company.next_of(left, ["single_bed", "nightstand"]) == left
    assert company.next_of(["table_lamp", "rug"], ["single_bed"]) == ["table_lamp", "rug"]


@pytest.mark.parametrize("x, y, good", [
    (0.3, 1.25, True),      # at its end
    (0.62, 0.75, False),    # before its last seat, beside the low table
    (0.62, 1.25, True),     # past its arm
    (1.4, 0.75, True),      # at the far side of the low table
])
@pytest.mark.parametrize("turn", [0.0, 2.0])
def test_a_lamp_stands_where_nobody_has_his_legs(x: float, y: float, good: bool, turn: float) -> None:
    """Of a sofa 2 m wide about the origin, .9 m deep; mirrored, too."""
    sofa = box((0.9, 2.0, 0.8), 0, 0, turn)[None]
    for side in (1, -1):
        at = x * np.cos(turn) - side * y * np.sin(turn), x * np.sin(turn) + side * y * np.cos(turn)
        lamp = box((0.4, 0.4, 1.6), *at, turn)[None]
        assert company.alone("floor_lamp", lamp, ["sofa"], sofa)[0] == (not good)
    assert company.follows("floor_lamp"), "it is left out rather than put there"


@pytest.mark.parametrize("gap, good", [(0.2, False), (0.5, True)])
def test_a_lamp_keeps_from_the_table_where_one_eats(gap: float, good: bool) -> None:
    table, lamp = box((0.9, 1.6, 0.75), 0, 0)[None], box((0.4, 0.4, 1.6), 0.45 + gap + 0.2, 0)[None]
    assert company.alone("floor_lamp", lamp, ["dining_table"], table)[0] == (not good)


@pytest.mark.parametrize("turn, seen", [(0, True), (70, True), (80, False), (120, False), (-70, True), (-90, False)])
def test_who_sits_in_an_armchair_sees_the_screen(turn: float, seen: bool) -> None:
    """It stands 3 m before the middle of the screen, turned so many degrees from it; 75 are too many."""
    screen, seat = box((0.4, 1.6, 0.5), 0, 0), box((0.8, 0.8, 0.9), 3, 0, np.pi + np.radians(turn))
    assert company.alone("armchair", seat[None], ["tv_stand"], screen[None])[0] != seen


@pytest.mark.parametrize(("aside", "good"), [(0, True), (66, True), (-66, True), (74, False), (-80, False)])
def test_nobody_sees_the_screen_edge_on(aside: float, good: bool) -> None:
    """2.5 m from its middle, so many degrees aside of straight before it, looking 30 degrees past it."""
    way = np.radians(aside)
    screen = box((0.4, 1.6, 0.5), 0, 0)
    seat = box((0.8, 0.8, 0.9), 2.5 * np.cos(way), 2.5 * np.sin(way), way + np.pi + np.radians(30))
    assert company.alone("armchair", seat[None], ["tv_stand"], screen[None])[0] != good


@pytest.mark.parametrize("gap, good", [(0.1, False), (0.3, False), (0.4, True), (1.0, True)])
def test_nobody_sits_right_at_the_screen(gap: float, good: bool) -> None:
    screen, seat = box((0.4, 1.6, 0.5), 0, 0), box((0.8, 0.8, 0.9), 0.2 + gap + 0.4, 0.3, np.pi)
    assert company.alone("armchair", seat[None], ["tv_stand"], screen[None])[0] != good


@pytest.mark.parametrize("gap, turn, good", [
    (0.3, 0, False), (0.55, 0, False), (0.65, 0, True), (0.3, 90, True), (0.3, 180, True), (0.3, 45, False)])
def test_no_armchair_has_its_back_to_a_near_table(gap: float, turn: float, good: bool) -> None:
    """A square seat of .8 m east of a table, looking east, or turned so many degrees from there."""
    table, seat = box((0.9, 1.6, 0.75), 0, 0), box((0.8, 0.8, 0.9), 0, 0, np.radians(turn))
    seat[0] = 0.45 + gap + 0.4 * (abs(np.cos(seat[2])) + abs(np.sin(seat[2])))
    assert company.alone("armchair", seat[None], ["dining_table"], table[None])[0] != good
    assert company.alone("dining_table", table[None], ["armchair"], seat[None])[0] != good, "whichever comes first"


TABLE_BEFORE = (0.0, 0.0, 0.0, 0.6, 1.1, 0.0, 0.4)
"""A low table about the origin, longer from south to north."""


@pytest.mark.parametrize("y, yaw, bars", [
    (1.35, -np.pi / 2, True),  # right behind the first, at the north end of the table
    (-1.35, np.pi / 2, False), (1.35, np.pi / 2, True),
])
def test_no_armchair_stands_between_another_one_and_the_low_table(y: float, yaw: float, bars: bool) -> None:
    things = {"coffee_table": TABLE_BEFORE, "armchair": (0.0, 0.55 + 0.3 + 0.4, -np.pi / 2, 0.8, 0.8, 0.0, 0.85)}
    second = np.array([(0.0, y + np.sign(y) * 0.8, yaw, 0.8, 0.8, 0.0, 0.85)])
    there = np.array(list(things.values()))
    assert views.barred("armchair", second, list(things), there).tolist() == [bars]
    front = np.array([things["armchair"]])
    assert views.barred("armchair", front, list(things), np.concatenate([there[:1], second])).tolist() == [bars]
    assert not views.barred("armchair", second, ["coffee_table"], there[:1]).any()


@pytest.mark.parametrize(("x", "behind"), [(0.5, True), (-0.9, False)])
def test_no_armchair_stands_behind_a_door_that_opens_towards_its_group(x: float, behind: bool) -> None:
    """The leaf lies along x at y = .8, its hinge at x = 1."""
    leaf = Boxes(np.array([[0.6, 0.8, 1.0]]), np.array([[0.8, 0.04, 2.1]]), np.zeros(1))
    seat = np.array([(x, 1.35, -np.pi / 2, 0.8, 0.8, 0.0, 0.85)])
    there = np.array([(0.0, 0.0, 0.0, 0.6, 1.1, 0.0, 0.4)])
    assert views.barred("armchair", seat, ["coffee_table"], there, leaf).tolist() == [behind]
    assert not views.barred("armchair", seat, ["coffee_table"], there).any()
    assert not views.barred("plant", seat, ["coffee_table"], there, leaf).any()


@pytest.mark.parametrize("gap, good", [(0.0, False), (0.14, False), (0.16, True), (0.6, True)])
def test_two_armchairs_side_by_side_do_not_touch(gap: float, good: bool) -> None:
    one = np.array([(0.0, 0.0, 0.0, 0.8, 0.8, 0.0, 0.85)])
    other = np.array([(0.0, 0.8 + gap, 0.0, 0.8, 0.8, 0.0, 0.85)])
    assert company.alone("armchair", other, ["armchair"], one).tolist() == [not good]


@pytest.mark.parametrize("gap, kept", [(0.1, False), (0.24, False), (0.26, True), (0.5, True)])
def test_knees_are_between_an_armchair_and_the_low_table(gap: float, kept: bool) -> None:
    seat = np.array([(0.0, 0.55 + gap + 0.4, -np.pi / 2, 0.8, 0.8, 0.0, 0.85)])
    assert company.alone("armchair", seat, ["coffee_table"], np.array([TABLE_BEFORE])).tolist() == [not kept]


@pytest.mark.parametrize("x, yaw, good", [
    (1.0, -np.pi / 2, True),  # abreast, both looking south
    (1.0, np.pi, False),      # looks at the other one's arm
])
def test_no_armchair_looks_at_the_arm_of_another(x: float, yaw: float, good: bool) -> None:
    one, two = ((at, 0.0, turn, 0.8, 0.8, 0.0, 0.85) for at, turn in ((0.0, -np.pi / 2), (x, yaw)))
    low = (0.4, -1.1, 0.0, 1.1, 0.6, 0.0, 0.4)
    for seat, other in ((one, two), (two, one)):
        found = company.alone("armchair", np.array([seat]), ["armchair", "coffee_table"], np.array([other, low]))
        assert found.tolist() == [not good]


@pytest.mark.parametrize(("x", "y", "yaw", "there", "seen"), [
    (2.6, 0.0, np.pi, ["double_bed"], True), (2.6, 0.5, np.pi, ["double_bed"], True),  # 11 degrees aside
    (2.6, 1.2, np.pi, ["double_bed"], False), (0.0, 2.6, -np.pi / 2, ["double_bed"], False),
    (2.6, 0.0, 0.0, ["double_bed"], False), (2.6, 0.0, np.pi, ["double_bed", "sofa"], False),
])  # fmt: skip
def test_a_screen_is_before_a_bed_where_there_is_no_sofa(
    x: float, y: float, yaw: float, there: list[str], seen: bool
) -> None:
    """Beside a bed that looks along x, and a sofa that looks away from all."""
    screen = np.array([[x, y, yaw, 0.4, 1.2, 0.0, 0.5]], np.float32)
    stands = {"double_bed": [0, 0, 0, 2.0, 1.8, 0, 0.5], "sofa": [0, -3, -np.pi / 2, 0.9, 2.0, 0, 0.8]}
    hosts = np.array([stands[name] for name in there], np.float32)
    assert company.alone("tv_stand", screen, there, hosts)[0] != seen


@pytest.mark.parametrize(("ahead", "aside", "wide", "belongs"), [
    (1.2, 0.0, 1.5, True), (1.2, 0.25, 1.5, True), (1.2, 0.5, 1.5, False), (1.45, 0.0, 1.5, False),
    (1.2, 0.5, 0.8, True), (1.45, 0.0, 0.8, True),
])  # fmt: skip
def test_a_seat_for_two_has_the_low_table_right_before_it(
    ahead: float, aside: float, wide: float, belongs: bool
) -> None:
    """At the origin, looking along x at a table of .6 by 1 m; an armchair may stand farther off, and aside."""
    seat = np.array([[0, 0, 0, 0.85, wide, 0, 0.8]], np.float32)
    hosts = np.array([[ahead, aside, 0, 0.6, 1.0, 0, 0.4], [5, 5, np.pi, 0.9, 2.0, 0, 0.8]], np.float32)
    name = "loveseat" if wide > 1 else "armchair"
    assert company.alone(name, seat, ["coffee_table", "sofa"], hosts)[0] != belongs
