"""Floor for the use of chairs and shelves, in a room of 4 x 4 m about the origin, in cases by hand."""

import numpy as np
import pytest
from rooms_for_tests import box, one_room, room, some_rooms

from apartgen.stages.layout.projection.paths import walked_in
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import elbowroom
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.relations.tokens import upright
from apartgen.stages.layout.rooms import KINDS

TABLE, CHAIR, CASE, SOFA = (0.9, 1.4, 0.75), (0.5, 0.5, 0.9), (0.35, 0.8, 1.8), (0.9, 1.8, 0.8)


def taken(name: str, at: np.ndarray, *there: tuple[str, np.ndarray]) -> bool:
    boxes = np.stack([o for _, o in there]) if there else np.zeros((0, 7), np.float32)
    return bool(elbowroom.taken(name, at[None], [o for o, _ in there], boxes, room().space)[0])


@pytest.mark.parametrize("gap, barred", [(0.1, True), (0.3, True), (0.37, True), (0.43, False), (0.6, False)])
def test_a_chair_is_drawn_back_before_a_wall(gap: float, barred: bool) -> None:
    """It looks east, its back `gap` from the west wall; .46 m less what is nothing yet has to be free."""
    assert taken("chair", box(CHAIR, -2 + gap + 0.25, 0)) == barred


@pytest.mark.parametrize("name, size, barred", [
    ("sideboard", CASE, True), ("sofa", SOFA, True), ("plant", (0.3, 0.3, 1.0), False), ("chair", CHAIR, False),
    ("rug", (1.4, 1.4, 0.01), False), ("dining_table", TABLE, False), ("coat_rack", (0.4, 0.4, 1.7), True),
    ("armchair", (0.85, 0.8, 0.9), True),
])
def test_what_stands_behind_a_chair_bars_it_unless_it_is_pushed_aside_or_a_table(name: str, size, barred: bool) -> None:
    behind = box(size, -0.25 - 0.1 - size[0] / 2, 0)
    assert taken("chair", box(CHAIR, 0, 0), (name, behind)) == barred
    assert taken(name, behind, ("chair", box(CHAIR, 0, 0))) == barred, "whichever comes first"


@pytest.mark.parametrize("gap, barred", [(0.2, True), (0.35, True), (0.41, False), (0.6, False)])
def test_one_stands_before_shelves(gap: float, barred: bool) -> None:
    shelves = box(CASE, -2 + 0.18, 0)
    sofa = box(SOFA, -2 + 0.355 + gap + 0.45, 0)
    assert taken("bookshelf", shelves, ("sofa", sofa)) == barred
    assert taken("sofa", sofa, ("bookshelf", shelves)) == barred


@pytest.mark.parametrize(
    "ahead, aside, barred", [(0.2, 0.0, True), (0.35, 0.2, True), (0.6, 0.0, False), (0.2, 0.7, False)])
def test_nobody_has_to_move_the_coats_to_get_at_shelves(ahead: float, aside: float, barred: bool) -> None:
    shelves = box(CASE, -2 + 0.18, 0)
    coats = box((0.4, 0.4, 1.7), -2 + 0.355 + ahead + 0.2, aside)
    assert taken("bookshelf", shelves, ("coat_rack", coats)) == barred
    assert taken("coat_rack", coats, ("bookshelf", shelves)) == barred, "whichever comes first"


@pytest.mark.parametrize("gap, cramped", [(0.2, True), (0.35, True), (0.41, False), (0.6, False)])
def test_an_armchair_is_rather_left_out_than_put_before_shelves(gap: float, cramped: bool) -> None:
    """Unless it is asked for, and there is no other place."""
    there = room()
    there.add("bookshelf", box(CASE, -2 + 0.18, 0))
    seat = box((0.8, 0.8, 0.9), -2 + 0.355 + gap + 0.4, 0)[None]
    assert (there.prices("armchair", seat)[0] >= BROKEN) == cramped
    assert there.prices("armchair", seat, loose=True)[0] < BROKEN


def test_what_stands_beside_takes_nothing() -> None:
    shelves = box(CASE, -2 + 0.18, 0)
    assert not taken("sideboard", box(CASE, -2 + 0.18, 0.85), ("bookshelf", shelves))
    assert not taken("sofa", box(SOFA, -2 + 0.45, 1.05 + 0.4), ("bookshelf", shelves))


@pytest.mark.parametrize("turn", range(4))
def test_it_does_not_hang_on_how_things_are_turned(turn: int) -> None:
    a, (c, s) = turn * np.pi / 2, (round(np.cos(turn * np.pi / 2)), round(np.sin(turn * np.pi / 2)))

    def at(x: float, y: float) -> tuple[float, float]:
        return c * x - s * y, s * x + c * y

    sofa = box(SOFA, *at(-0.25 - 0.2 - 0.45, 0), yaw=a)
    assert taken("chair", box(CHAIR, 0, 0, yaw=a), ("sofa", sofa))
    assert not taken("chair", box(CHAIR, 0, 0, yaw=a + np.pi), ("sofa", sofa))


def test_a_table_draws_no_chairs_to_a_wall_at_first() -> None:
    """The price of a place without room to draw the chair back: none at a strict look, a bad one later."""
    there = room()
    there.add("dining_table", box(TABLE, -2 + 0.5 + 0.33 + 0.45, 0))
    at_wall = box(CHAIR, -2 + 0.27 + 0.05, 0)[None]
    assert there.prices("chair", at_wall, strict=True)[0] >= BROKEN
    assert there.prices("chair", at_wall)[0] < BROKEN


@pytest.mark.parametrize("x, away, barred", [(0.0, 0.0, True), (1.0, 0.0, True), (1.2, 0.0, False), (0.0, 0.5, False)])
def test_no_bed_has_its_head_at_a_window(x: float, away: float, barred: bool) -> None:
    """A window from -.6 to .6 in the north wall; a bed 1.6 m wide of one, at `x`, so far off the wall."""
    rooms = some_rooms(1, 4)
    north = float(rooms.polygon[0, :4, 1].max())
    bed = box((2.0, 1.6, 0.9), x, north - 1.02 - away, -np.pi / 2)
    space = space_of(rooms, 0)
    assert bool(elbowroom.taken("single_bed", bed[None], [], np.zeros((0, 7)), space)[0]) == barred
    beside = box((0.6, 1.6, 0.75), x, north - 0.32, -np.pi / 2)
    assert not elbowroom.taken("desk", beside[None], [], np.zeros((0, 7)), space)[0], "a desk has light there"


@pytest.mark.parametrize("gap, turned, met", [(0.3, 0.0, True), (0.5, 0.0, False), (0.3, np.pi, False)])
def test_nothing_opens_into_a_door_that_stands_open(gap: float, turned: float, met: bool) -> None:
    """A shower, whose leaf of .8 m sweeps .4 m, before a leaf that stands along the room, `gap` from it."""
    space = space_of(some_rooms(1, 4), 0)
    leaf = space.leaves.center[0]
    long = np.array([np.cos(space.leaves.yaw[0]), np.sin(space.leaves.yaw[0])])
    thick = space.leaves.size[0, :2]
    across = long if thick[0] < thick[1] else np.array([-long[1], long[0]])
    middle = leaf[:2] + across * (min(thick) / 2 + gap + 0.4)
    yaw = float(np.arctan2(-across[1], -across[0])) + turned
    shower = box((0.8, 0.8, 2.0), *middle, yaw)
    there = Furniture(space)
    assert bool(there._meets_leaves("shower", upright(shower[None]))[0]) == met


@pytest.mark.parametrize("name, barred", [("plant", True), ("coat_rack", True), ("bin", False)])
def test_what_stands_before_a_wardrobe_bars_it_unless_it_is_light(name: str, barred: bool) -> None:
    wardrobe, before = box((0.6, 1.5, 2.1), -2 + 0.305, 0), box((0.3, 0.3, 1.0), -2 + 0.61 + 0.3, 0)
    assert taken("wardrobe", wardrobe, (name, before)) == taken(name, before, ("wardrobe", wardrobe)) == barred


@pytest.mark.parametrize("gap, barred", [(0.1, True), (0.36, True), (0.44, False), (0.6, False)])
def test_nobody_sits_where_a_door_opens(gap: float, barred: bool) -> None:
    """The chair looks north, its back so far from what the door in the south wall needs, .46 m of which it takes."""
    zone = room().space.zones
    clear = float(zone.center[0, 1] + zone.size[0, 0] / 2)
    assert taken("chair", box(CHAIR, 0, clear + gap + 0.25, yaw=np.pi / 2)) == barred


@pytest.mark.parametrize("wide, gap, barred", [
    (1.2, 0.6, True), (1.2, 0.82, False), (1.8, 0.6, True), (3.0, 0.6, False),
])
def test_one_passes_what_stands_in_a_corridor(wide: float, gap: float, barred: bool) -> None:
    """A bench at the south wall of a corridor, and a coat rack `gap` before its front; in a room one goes around."""
    corridor, bench = room(6.0, wide), box((0.3, 1.0, 0.45), 1.5, -wide / 2 + 0.155, np.pi / 2)
    rack = box((0.3, 0.3, 1.7), 1.5, -wide / 2 + 0.305 + gap + 0.15)
    for name, one, other, there in (("coat_rack", rack, "bench", bench), ("bench", bench, "coat_rack", rack)):
        assert bool(elbowroom.taken(name, one[None], [other], there[None], corridor.space)[0]) == barred


@pytest.mark.parametrize("wide, size, barred", [(1.2, 0.45, True), (1.2, 0.34, False), (1.1, 0.34, True),
                                                (1.6, 0.45, False), (2.0, 0.45, False)])
@pytest.mark.parametrize("yaw", [0.0, np.pi / 2, np.pi])
def test_a_coat_rack_leaves_so_much_of_a_corridor(wide: float, size: float, barred: bool, yaw: float) -> None:
    rack, corridor = box((size, size, 1.7), 1.5, size / 2 - wide / 2 + 0.01, yaw), room(6.0, wide)
    assert bool(elbowroom.taken("coat_rack", rack[None], [], np.zeros((0, 7)), corridor.space)[0]) == barred
    assert (corridor.prices("coat_rack", rack[None], strict=True)[0] >= BROKEN) == barred
    assert corridor.prices("coat_rack", rack[None])[0] < BROKEN


def test_what_one_can_do_without_is_rather_left_out_than_put_before_a_wardrobe() -> None:
    there, chest = room(), box((0.45, 0.8, 0.8), -2 + 0.65 + 0.5, -1.775, np.pi / 2)
    assert there.prices("chest", chest[None])[0] < BROKEN
    there.add("sliding_wardrobe", box((0.6, 1.8, 2.1), -1.695, -1.0))
    assert there.prices("chest", chest[None])[0] >= BROKEN


def test_no_plant_stands_before_either_half_of_a_sliding_wardrobe() -> None:
    """Before its end, where a chest no wider would leave four fifths of it free, nor is one put there at last."""
    there = room()
    there.add("sliding_wardrobe", box((0.6, 1.8, 2.1), -1.695, -1.0))
    end, beside = (box((0.3, 0.3, 1.0), -2 + 0.61 + 0.3, y) for y in (-0.12, 0.1))
    assert taken("plant", end, ("sliding_wardrobe", there.boxes[0])) and there.prices("plant", end[None])[0] >= BROKEN
    assert not taken("shelving", end, ("sliding_wardrobe", there.boxes[0]))
    assert there.prices("plant", beside[None])[0] < BROKEN


@pytest.mark.parametrize(("kind", "wide", "there", "out"), [
    ("entrance", 1.25, (), True), ("entrance", 1.6, (), False), ("door", 1.25, (), False),
    ("entrance", 1.25, ("single_bed",), False),
])  # fmt: skip
def test_no_cupboard_narrows_the_hall_one_enters(kind: str, wide: float, there: tuple[str, ...], out: bool) -> None:
    """A wardrobe of .6 m in a corridor 6 m long: .65 or 1 m are left. Where one sleeps it is needed all the same."""
    rooms = one_room(6.0, wide)
    rooms.openings[0, 0, 4] = KINDS[kind]
    hall = Furniture(space_of(rooms, 0))
    for name in there:
        hall.add(name, box((2.0, 0.9, 0.5), -1.98, 0, 0))
    cupboard = box((0.6, 1.2, 2.1), 1.5, wide / 2 - 0.305, -np.pi / 2)
    assert (hall.prices("wardrobe", cupboard[None])[0] >= BROKEN) == out


@pytest.mark.parametrize(("base", "gap", "shut"), [
    ("hallway", 0.62, True), ("hallway", 0.8, False), ("living_room", 0.45, True), ("living_room", 0.62, False),
])
def test_between_things_at_both_walls_people_pass(base: str, gap: float, shut: bool) -> None:
    """A door in the south, floor in the north, benches at the west and the east wall across from one another."""
    there = Furniture(space_of(one_room(0.8 + gap, 6.0), 0), walked_in(base))
    there.add("bench", box((0.4, 1.0, 0.45), -(0.2 + gap / 2), 0.0))
    assert (there.shuts("bench", box((0.4, 1.0, 0.45), 0.2 + gap / 2, 0.0, np.pi)) >= CUT) == shut


BED = (2.0, 1.6, 0.5)


@pytest.mark.parametrize("foot, barred", [(0.3, True), (0.58, True), (0.62, False), (1.0, False)])
def test_one_walks_round_the_foot_of_a_bed_of_two(foot: float, barred: bool) -> None:
    """.6 m before a wall or a wardrobe."""
    at_wall = box(BED, 2 - foot - 1.0, 0)
    assert taken("double_bed", at_wall) == barred
    wardrobe = box((0.6, 1.5, 2.1), 2 - 0.3, 0, np.pi)
    bed = box(BED, 2 - 0.6 - foot - 1.0, 0)
    assert taken("double_bed", bed, ("wardrobe", wardrobe)) == barred
    assert taken("wardrobe", wardrobe, ("double_bed", bed)) == barred
    assert not taken("single_bed", box((2.0, 0.9, 0.5), 2 - foot - 1.0, 0))


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("gap, barred", [(0.3, True), (0.5, True), (0.56, False)])
def test_two_get_into_their_bed_at_either_side(gap: float, barred: bool, side: int) -> None:
    assert taken("double_bed", box(BED, -0.98, side * (2 - gap - 0.8))) == barred
    chest = box((0.45, 0.8, 0.8), -0.4, side * (0.8 + gap + 0.225), -side * np.pi / 2)
    assert taken("double_bed", box(BED, -0.98, 0), ("chest", chest)) == barred


@pytest.mark.parametrize("name", ["nightstand", "side_table", "floor_lamp", "pouffe", "rug"])
def test_what_belongs_beside_a_bed_takes_nothing(name: str) -> None:
    bed = box(BED, -0.98, 0)
    assert not taken("double_bed", bed, (name, box((0.4, 0.4, 0.5), -1.2, 1.05)))
    assert not taken(name, box((0.4, 0.4, 0.5), -1.2, 1.05), ("double_bed", bed))


RADIATOR = np.array([-0.6, 1.95, -np.pi / 2, 0.1, 0.9, 0.12, 0.72], np.float32)
"""At the north wall."""


@pytest.mark.parametrize("aside, alone, beside", [(0.62, False, True), (0.66, False, False), (0.4, True, True)])
def test_two_who_share_a_bed_get_past_the_radiator(aside: float, alone: bool, beside: bool) -> None:
    """The bed is so far from its wall; .6 m less what is nothing yet have to be free."""
    bed = box((2.0, 1.6, 0.5), -1.0, 2.0 - aside - 0.8)
    assert taken("double_bed", bed) == alone and taken("double_bed", bed, ("radiator", RADIATOR)) == beside


@pytest.mark.parametrize("gap, barred", [(0.02, True), (0.1, True), (0.2, False)])
def test_no_bed_stands_at_a_radiator(gap: float, barred: bool) -> None:
    bed = box((2.0, 0.9, 0.5), -1.0, 1.9 - gap - 0.45)
    assert taken("single_bed", bed, ("radiator", RADIATOR)) == barred and not taken("single_bed", bed)


@pytest.mark.parametrize("gap, barred", [(0.45, True), (0.6, True), (0.9, False)])
@pytest.mark.parametrize("mirrored", [False, True])
def test_nothing_narrows_the_way_round_a_corner(gap: float, barred: bool, mirrored: bool) -> None:
    """A passage 1.2 m wide along the west wall comes into a hall from the south; shelves .75 m deep stand at that wall
    of the hall, their near end `gap` from where the corner of the passage's other wall is."""
    rooms, (x, y) = one_room(), (1.2 - 2, 0.0)
    rooms.polygon[0, :6] = np.array([[-2, -2], [x, -2], [x, y], [2, y], [2, 2], [-2, 2]], np.float32)
    shelves = box((0.75, 0.6, 1.8), -2 + 0.375, y + np.sqrt(max(0.0, gap**2 - 0.45**2)) + 0.3)
    if mirrored:
        rooms.polygon[0, :6, 0] *= -1
        rooms.polygon[0, :6] = rooms.polygon[0, :6][::-1].copy()
        shelves[0], shelves[2] = -shelves[0], np.pi
    found = elbowroom.taken("bookshelf", shelves[None], [], np.zeros((0, 7)), space_of(rooms, 0))[0]
    assert found == barred


def test_the_end_of_a_passage_is_no_corner_to_walk_round() -> None:
    assert not taken("bookshelf", box(CASE, -2 + 0.18, -1.6))
