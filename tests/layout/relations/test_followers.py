"""Leaders are put where their followers will find places."""

import numpy as np
import pytest
from rooms_for_tests import box, room, some_rooms

from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import followers, handy, instead, sizes
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.rooms import KINDS, Rooms

TABLE, SMALL, BED, DESK = (0.9, 1.4, 0.75), (0.9, 0.9, 0.75), (2.0, 1.6, 0.5), (0.6, 1.2, 0.75)


@pytest.mark.parametrize("y, chairs, fits", [
    (0.4, 4, True), (0.4, 6, True),     # free all round
    (1.3, 2, True), (1.3, 4, True),     # a long table whose end is near the wall
    (1.3, 6, False),                    # which leaves no place at that end
])
def test_a_table_stands_where_its_chairs_do(y: float, chairs: int, fits: bool) -> None:
    assert (followers.fit(room(), "dining_table", box(TABLE, 0, y), ["chair"] * chairs + ["plant"]) == 1) == fits


def test_a_table_along_a_wall_has_no_place_for_those_at_the_wall() -> None:
    at_wall = box(TABLE, -2 + 0.46, 0.4)
    assert followers.fit(room(), "dining_table", at_wall, ["chair"] * 6) < 1
    assert followers.fit(room(), "dining_table", at_wall, ["chair"] * 4) == 1, "one side and both ends"


@pytest.mark.parametrize("x, stands, fits", [(0.0, 2, True), (0.0, 0, True), (0.95, 2, False), (0.95, 0, False)])
def test_a_bed_of_two_leaves_both_its_sides(x: float, stands: int, fits: bool) -> None:
    """Its head at the north wall; .25 m is left beside it at one side, whether nightstands come or not."""
    assert (followers.fit(room(), "double_bed", box(BED, x, 0.98, -np.pi / 2), ["nightstand"] * stands) == 1) == fits


def test_a_nightstand_that_nobody_gets_to_is_none() -> None:
    """Between the bed and a wall there is place for it, but none to stand before its drawer."""
    narrow = box(BED, 4.0 / 2 - 0.8 - 0.5, 0.98, -np.pi / 2)
    assert followers.fit(room(), "double_bed", narrow, ["nightstand"] * 2) < 1


def test_of_a_table_it_is_told_how_many_of_its_chairs_find_a_place() -> None:
    """At a wall in the middle of six only those of one side and of the ends."""
    assert followers.fit(room(), "dining_table", box(TABLE, -2 + 0.46, 0.4), ["chair"] * 6) == pytest.approx(4 / 6)
    assert followers.fit(room(), "dining_table", box(TABLE, 0, 1.3), ["chair"] * 6) == pytest.approx(5 / 6)


def test_a_missing_wardrobe_is_worse_than_a_nightstand_that_nobody_gets_to() -> None:
    left, narrow = ["nightstand"] * 2 + ["wardrobe"], box(BED, 4.0 / 2 - 0.8 - 0.53, 0.98, -np.pi / 2)
    middle = box(BED, 0, 2.9 / 2 - 1.02, -np.pi / 2)
    assert followers.fit(room(3.2, 2.9), "double_bed", middle, left[:2]) == 1
    assert followers.fit(room(3.2, 2.9), "double_bed", middle, left) == 0.25
    assert followers.fit(room(), "double_bed", narrow, left) == 0.5


@pytest.mark.parametrize("width, depth, fits", [(4.0, 4.5, False), (4.0, 6.5, False), (4.0, 8.0, True)])
def test_a_sofa_leaves_the_floor_that_a_table_takes_with_its_chairs(width: float, depth: float, fits: bool) -> None:
    """A table for six, .9 by 1.8 m, has .78 m on both sides and they rather keep .9 m from a sofa, which in the middle
    of a room leaves 1.8, 2.8 or 3.55 m."""
    there, sofa = room(width, depth), box((0.9, 2.0, 0.8), 0, 0, np.pi / 2)
    assert (followers.fit(there, "sofa", sofa, ["dining_table", *["chair"] * 6]) == 1) == fits
    assert followers.fit(there, "sofa", sofa, ["dining_table"]) == 1


@pytest.mark.parametrize("name, host, size, many", [
    ("chair", "dining_table", (0.9, 1.8, 0.75), 8), ("chair", "round_table", (1.0, 1.0, 0.75), 4),
    ("chair", "round_table", (1.36, 1.36, 0.75), 6),
    ("nightstand", "double_bed", BED, 2), ("office_chair", "desk", DESK, 1),
    ("coffee_table", "sofa", (0.9, 2.0, 0.8), 1),
])
def test_places_that_are_known_are_good_and_as_large_as_others_of_their_name(
        name: str, host: str, size: tuple[float, float, float], many: int) -> None:
    """Of something in the middle of a wide room all followers' places are free, and in nothing else."""
    there, mine = room(7.0, 7.0), box((0.44, 0.42, 0.6), 3.0, 3.0)
    there.add(host, box(size, 0, 0, np.pi / 2))
    found = followers.known(name, mine[None], there.names, there.boxes)
    assert len(found) == many and (there.prices(name, found, strict=True) == 0).all()
    assert np.allclose(found[:, 3:], mine[3:])
    there.add(name, box((0.5, 0.46, 0.55), 3.0, 3.0))
    assert np.allclose(followers.known(name, mine[None], there.names, there.boxes)[:, 3:5], (0.5, 0.46))
    assert not len(followers.known("plant", mine[None], there.names, there.boxes))


def test_leaders_may_stand_all_over_the_room_square_to_its_walls() -> None:
    there, bed, table = room(5.0, 4.0), box(BED, 0, 0), box(TABLE, 0, 0)
    beds = followers.leading("double_bed", bed[None], there.space)
    heads = beds[:, :2] - beds[:, 3:4] / 2 * np.stack([np.cos(beds[:, 2]), np.sin(beds[:, 2])], -1)
    off = np.minimum(2.5 - np.abs(heads[:, 0]), 2.0 - np.abs(heads[:, 1]))
    assert len(beds) > 20 and (np.abs(off - followers.OFF) < 1e-3).all()
    tables = followers.leading("dining_table", table[None], there.space)
    turned = np.abs(np.sin(2 * tables[:, 2]))
    assert len(tables) > 100 and (turned < 1e-3).all() and np.ptp(tables[:, 0]) > 3 and np.ptp(tables[:, 1]) > 2
    assert not len(followers.leading("desk", table[None], there.space))
    assert len(followers.leading("sofa", bed[None], there.space)) == len(beds)
    clothes = box((0.6, 1.8, 2.1), 0, 0)[None]
    found = [followers.leading("wardrobe", clothes, there.space, least)[:, 4] for least in (0.0, 1.2, 2.0)]
    widths = [sorted({round(float(wide), 3) for wide in some}) for some in found]
    assert widths == [[1.8], [1.2, 1.8], [1.8]], "no wider than said, and as narrow as is enough"


def test_a_sofa_stands_rather_at_a_wall() -> None:
    there = room(6.0, 6.0)
    rows = np.stack([box((0.9, 2.0, 0.8), -3 + 0.45 + gap, 0.5) for gap in (0.05, 2.2)])
    for strict in (False, True):
        at_wall, free = there.prices("sofa", rows, strict=strict)
        assert at_wall < free < BROKEN


@pytest.mark.parametrize("name", ["coat_rack", "shoe_cabinet", "bench", "plant"])
def test_coats_and_shoes_are_near_the_entrance(name: str) -> None:
    """It is in the middle of the south wall of a room 8 m long."""
    there = Furniture(space_of(entered(), 0))
    one = box((0.3, 0.6, 1.7), 0.0, 0.0)
    near, far = box((0.3, 0.6, 1.7), 1.0, -1.34, np.pi / 2), box((0.3, 0.6, 1.7), 3.6, -1.34, np.pi / 2)
    good = (there.prices(name, np.stack([near, far]), strict=True) < BROKEN).tolist()
    assert good == [True, name == "plant"]
    assert (there.prices(name, far[None])[0] < BROKEN) == (name in ("coat_rack", "plant"))
    assert there.prices(name, far[None], loose=True)[0] < BROKEN
    places = handy.places(name, one[None], there.names, there.boxes, there.space)
    if name == "plant":
        assert not len(places)
        return
    assert len(places) > 8 and (np.hypot(places[:, 0], places[:, 1] + 1.5) < 3.0).all()
    back = places[:, :2] - places[:, 3:4] / 2 * np.stack([np.cos(places[:, 2]), np.sin(places[:, 2])], -1)
    assert (np.minimum(4 - np.abs(back[:, 0]), 1.5 - np.abs(back[:, 1])) < 0.02).all()
    hall = Furniture(space_of(entered(KINDS["door"]), 0))
    assert not len(handy.places(name, one[None], hall.names, hall.boxes, hall.space))


@pytest.mark.parametrize("name", ["bench", "shoe_cabinet"])
def test_what_one_uses_coming_home_has_a_wall_behind_it(name: str) -> None:
    """At the south wall, where the entrance is; free of it; with its end at the wall."""
    there = Furniture(space_of(entered(), 0))
    places = ((-1.34, np.pi / 2), (-0.7, np.pi / 2), (-1.09, 0.0))
    rows = np.stack([box((0.3, 0.8, 0.46), 1.0, y, yaw) for y, yaw in places])
    for strict in (True, False):
        assert (there.prices(name, rows, strict=strict) < BROKEN).tolist() == [True, False, False]


@pytest.mark.parametrize("name, size, wide", [
    ("shoe_cabinet", (0.3, 0.9, 1.0), 1.1), ("bench", (0.4, 1.2, 0.45), 1.18)])
def test_shoes_are_kept_in_narrow_halls(name: str, size: tuple[float, float, float], wide: float) -> None:
    rooms = entered()
    rooms.polygon[0, :4, 1] = np.array([0, 0, wide, wide]) - 1.5
    there = Furniture(space_of(rooms, 0))
    places = handy.places(name, box(size, 0, 0)[None], there.names, there.boxes, there.space)
    good = places[there.prices(name, places, strict=True) < BROKEN]
    assert len(good) and (good[:, 3] < size[0]).all()


def entered(kind: int = KINDS["entrance"]) -> Rooms:
    rooms = some_rooms(1)
    rooms.polygon[0, :4] = np.array([[-4, -1.5], [4, -1.5], [4, 1.5], [-4, 1.5]], np.float32)
    rooms.openings[0] = np.nan
    rooms.openings[0, 0] = [-0.45, -1.5, 0.45, -1.5, kind, -1, 0]
    return rooms


def test_a_stand_does_not_reach_beyond_the_end_of_its_wall() -> None:
    """The walls of an L meet at a corner that stands out at (1, 1)."""
    rooms = some_rooms(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :6] = [[-3, -3], [3, -3], [3, 1], [1, 1], [1, 3], [-3, 3]]
    rooms.openings[0] = np.nan
    there = Furniture(space_of(rooms, 0))
    stands = np.stack([box((0.4, 1.6, 0.5), x, 0.79, -np.pi / 2) for x in (2.1, 1.3, 1.0)])
    assert (there.prices("tv_stand", stands, strict=True) < BROKEN).tolist() == [True, False, False]


@pytest.mark.parametrize(
    "name, size", [("wardrobe", (0.6, 1.2, 2.1)), ("bookshelf", (0.3, 0.8, 1.8)), ("double_bed", BED)])
def test_what_has_a_back_stands_at_a_wall(name: str, size: tuple[float, float, float]) -> None:
    there, off = room(6.0, 6.0), np.array([0.01, 0.12, 0.5])
    rows = np.stack([box(size, -3 + size[0] / 2 + gap, 0.0) for gap in off])
    assert (there.prices(name, rows, strict=True) < BROKEN).tolist() == [True, True, False]
    plain = there.prices(name, rows)
    assert plain[2] > plain[0] + 5 and (plain[2] >= BROKEN) == (name == "wardrobe")


def test_a_desk_faces_where_one_sits() -> None:
    facing = box(DESK, 0, 1.68, -np.pi / 2)
    assert followers.fit(room(), "desk", facing, ["office_chair"])
    there = room()
    there.add("wardrobe", box((0.6, 1.8, 2.1), 0, 0.85, -np.pi / 2))
    assert followers.fit(there, "desk", facing, ["office_chair"]) < 1


@pytest.mark.parametrize("y, tables, fits", [(0.0, 1, True), (1.0, 1, False), (1.0, 0, True)])
def test_a_sofa_leaves_the_floor_before_it_to_its_low_table(y: float, tables: int, fits: bool) -> None:
    """It looks north; at the latter place .55 m are left before it."""
    sofa = box((0.9, 2.0, 0.8), 0, y, np.pi / 2)
    assert (followers.fit(room(), "sofa", sofa, ["coffee_table"] * tables) == 1) == fits


@pytest.mark.parametrize(
    "depth, clothes, fits", [(4.0, ["wardrobe"], True), (2.9, ["wardrobe"], False), (2.9, [], True)])
def test_a_bed_leaves_a_wall_to_a_wardrobe_of_two(depth: float, clothes: list[str], fits: bool) -> None:
    """A bed in the middle of a room of 3 m: .9 m before its foot are too little for a wardrobe and its doors, and
    beside it there are .7 m."""
    bed = box(BED, 0, depth / 2 - 1.02, -np.pi / 2)
    assert (followers.fit(room(3.0, depth), "double_bed", bed, clothes) == 1) == fits


@pytest.mark.parametrize("width, fits", [(3.6, True), (2.4, False)])
def test_a_bed_of_one_leaves_a_wall_to_a_smaller_wardrobe(width: float, fits: bool) -> None:
    """Beside a bed in the middle of the end wall are 1.35 m, or .75 m, which are too little to stand before it."""
    bed = box((2.0, 0.9, 0.5), 0, 2.9 / 2 - 1.02, -np.pi / 2)
    assert (followers.fit(room(width, 2.9), "single_bed", bed, ["wardrobe"]) == 1) == fits


@pytest.mark.parametrize("width, fits", [(3.0, True), (4.0, True), (6.5, False)])
def test_a_sofa_leaves_a_wall_before_it_to_the_television(width: float, fits: bool) -> None:
    """Where that is no farther off than one watches from."""
    sofa = box((0.9, 2.0, 0.8), 0.46 - width / 2, 0.5)
    assert (followers.fit(room(width, 4.0), "sofa", sofa, ["tv_stand"]) == 1) == fits
    assert followers.fit(room(width, 4.0), "sofa", sofa, []) == 1


def test_what_comes_beside_a_bed_is_tried_from_wide_to_narrow() -> None:
    """The narrowest of each kind still holds a lamp, .3 m."""
    for kind in {name for name, _ in instead.BESIDE}:
        wide = [size[1] for name, size in instead.BESIDE if name == kind]
        assert wide == sorted(set(wide), reverse=True) and wide[-1] > 0.3


def test_where_nobody_opens_a_nightstand_a_small_table_stands_beside_the_bed() -> None:
    """Its head at the north wall with .5 m on its east side, where a usual nightstand leaves nobody before its drawer
    and a small table does; what stands there is within reach of who lies there."""
    there, bed = room(), box(BED, 2 - 0.8 - 0.5, 0.98, -np.pi / 2)
    there.add("double_bed", bed)
    said = box((0.42, 0.48, 0.52), 0, 0)[None]
    usual = followers.known("nightstand", said, there.names, there.boxes)
    east = usual[usual[:, 0] > bed[0]]
    assert there.prices("nightstand", east).min() >= BROKEN or there.shuts("nightstand", east[0]) >= CUT
    good = [place for name, places in instead.alternatives("nightstand", said, there, {}) for place in places
            if place[0] > bed[0] and there.prices(name, place[None], strict=True)[0] < BROKEN
            and there.shuts(name, place) < CUT]
    assert good
    for place in good:
        assert place[0] - place[4] / 2 > bed[0] + 0.8 - 0.01 and place[0] + place[4] / 2 < 2.0 + 0.008
        assert place[1] + place[3] / 2 > 2 - 0.05


@pytest.mark.parametrize("foot, shorter", [(0.5, True), (1.0, False)])
def test_a_bed_is_no_longer_than_its_mattress_where_one_hardly_gets_round_it(foot: float, shorter: bool) -> None:
    """Its head stays where it was, and so does its middle."""
    bed = box((2.2, 1.7, 0.5), 0.1, 2 - 0.02 - 1.1, -np.pi / 2)
    found = followers.snug("double_bed", bed, room(4.0, 4.0) if not shorter else room(4.0, 2.22 + foot))
    if not shorter:
        assert np.array_equal(found, bed)
        return
    bed = box((2.2, 1.7, 0.5), 0.1, (2.22 + foot) / 2 - 0.02 - 1.1, -np.pi / 2)
    found = followers.snug("double_bed", bed, room(4.0, 2.22 + foot))
    assert 2.0 <= found[3] < 2.1 and 1.6 <= found[4] < 1.7 and found[0] == bed[0]
    assert found[1] + found[3] / 2 == pytest.approx(bed[1] + 1.1, abs=1e-5)
    assert np.array_equal(followers.snug("single_bed", bed, room(4.0, 2.22 + foot)), bed)


def test_mirrors_are_looked_for_along_all_walls_unless_there_is_what_they_hang_over() -> None:
    there = room()
    said = np.tile(np.array([0, 0, 0, 0.04, 0.6, 1.05, 1.85], np.float32), (3, 1))
    places = handy.places("mirror", said, ["double_bed"], said[:1], there.space)
    assert {(round(float(np.cos(yaw))), round(float(np.sin(yaw)))) for yaw in places[:, 2]} == {
        (1, 0), (-1, 0), (0, 1), (0, -1)}
    assert np.allclose(places[:, 3:], said[0, 3:]) and np.allclose(np.abs(places[:, :2]).max(1), 2 - 0.02, atol=0.02)
    for over in ("vanity", "dressing_table"):
        assert not len(handy.places("mirror", said, [over], said[:1], there.space))
    (name, found), = instead.alternatives("mirror", said, there, {})  # as where a window is above the basin
    assert name == "mirror" and np.array_equal(found, places)


def test_others_lead_nothing() -> None:
    assert followers.fit(room(), "wardrobe", box((0.6, 1.8, 2.1), 0, 0), ["chair", "nightstand"]) == 1


def test_towels_are_looked_for_at_walls_near_where_one_washes() -> None:
    """In a room of 4 m, a shower .9 m square in its north-east corner: flush with the north and east walls, as high as
    the candidates, no farther from it than .7 m; nowhere in a room without, and nothing but rails."""
    there = room()
    said = np.tile(np.array([0, 0, 0, 0.1, 0.5, 0.7, 1.5], np.float32), (3, 1))
    shower = box((0.9, 0.9, 2.0), 1.55, 1.55, np.pi)[None]
    for name, near in (("towel_rail", []), ("bath", ["shower"])):
        assert not len(handy.places(name, said, near, shower[: len(near)], there.space))
    places = handy.places("towel_rail", said, ["shower"], shower, there.space)
    assert len(places) > 3
    assert np.allclose(places[:, 5:], [0.7, 1.5]) and np.allclose(places[:, 3:5], [0.1, 0.5])
    x, y = places[:, 0], places[:, 1]
    for east in (True, False):
        at, along = (x, y) if east else (y, x)
        mine = along < at
        assert mine.any() and np.allclose(at[mine], 2 - 0.05, atol=0.02)
        assert (1.1 - (along[mine] + 0.25) <= 0.7).all()


@pytest.mark.parametrize("width", [2.2, 2.4, 3.0])
def test_from_a_sofa_round_a_corner_one_reaches_its_low_table(width: float) -> None:
    """It stands before the chaise, as boxes do not stand in one another, and towards the other seats, yet before the
    middle of it all; the seats are .97 m deep."""
    there, sofa = room(6.0, 6.0), box((sizes.most("corner_sofa").depth, width, 0.8), 0, -2.0, np.pi / 2)
    there.add("corner_sofa", sofa)
    found = followers.known("coffee_table", box((0.6, 1.1, 0.42), 0, 0)[None], there.names, there.boxes)
    assert len(found) == 3 and (there.prices("coffee_table", found, strict=True) == 0).all()
    front = found[:, 1] - 0.3
    assert (front - (sofa[1] - sofa[3] / 2 + 0.97) < 0.7).all() and (front - (sofa[1] + sofa[3] / 2) > 0.2).all()
    assert found[0, 0] > 0.2 and (np.abs(found[:, 0]) < 0.3).all(), "the chaise is at the left end"
    afar = box((0.6, 1.1, 0.42), 0, -2.0 + sofa[3] / 2 + 0.4 + 0.3, np.pi / 2)
    assert there.prices("coffee_table", afar[None], strict=True)[0] >= BROKEN


@pytest.mark.parametrize("name, size, chairs, good", [
    ("dining_table", TABLE, 4, [True, True, False]), ("dining_table", TABLE, 6, [True, False, False]),
    ("round_table", SMALL, 2, [True, True, False]), ("round_table", SMALL, 4, [True, False, False]),
    ("dining_table", TABLE, 0, [True, True, True]), ("bookshelf", (0.3, 0.9, 1.8), 4, [True, True, True]),
])
def test_places_where_all_chairs_are_drawn_back_come_first(name: str, size: tuple[float, float, float], chairs: int,
                                                           good: list[bool]) -> None:
    """In the middle of a room of 6 by 6 m, near the wall at its end, and near that at its side: .3 m each."""
    at_end, at_side = (3 - 0.3 - length / 2 for length in (size[1], size[0]))
    places = np.stack([box(size, 0, 0), box(size, 0, at_end), box(size, at_side, 0)])
    weight = followers.likely(room(6.0, 6.0), name, places, ["chair"] * chairs)
    assert (weight == 1).tolist() == good and (weight > 0).all()


def test_where_one_sleeps_a_narrow_wardrobe_is_better_than_none() -> None:
    """A wall of 1.1 m beside the bed's takes one of 1 m; elsewhere none is narrower than others of its kind."""
    said = np.tile(box((0.6, 1.5, 2.1), 0, 0), (3, 1))
    for names, narrow in (["double_bed"], True), ([], False):
        there = room()
        for name in names:
            there.add(name, box(BED, 0, 0.98, -np.pi / 2))
        found = [places[:, 4] for _, places in instead.alternatives("wardrobe", said, there, {}) if len(places)]
        assert any((width <= 1.0).all() for width in found) == narrow
        assert all((width >= 0.7).all() for width in found)


def test_sliding_doors_instead_of_others_are_as_wide_as_they_are_made() -> None:
    """Nothing narrower than 1.2 m and shallower than .55 m has them; where they fit, they are as wide as was said."""
    for width, wanted in (0.7, 1.2), (1.5, 1.5):
        said = np.tile(box((0.45, width, 2.0), 0, 0), (3, 1))
        (sliding,) = (places for name, places in instead.alternatives("wardrobe", said, room(), {})
                      if name == "sliding_wardrobe")
        assert len(sliding) and sliding[:, 4].tolist() == pytest.approx([wanted] * len(sliding))
        assert (sliding[:, 3] >= 0.55 - 1e-6).all()


@pytest.mark.parametrize("depth, fits", [(3.1, False), (4.2, True)])
def test_a_table_leaves_the_wardrobe_its_wall(depth: float, fits: bool) -> None:
    """In the middle of a room 2.6 m wide, of which a bed takes the south wall: north of the table are .45 m and 1 m."""
    there = room(2.6, depth)
    there.add("single_bed", box((2.0, 0.9, 0.5), 0, -depth / 2 + 0.46))
    table = box((0.8, 1.2, 0.75), 0, 0.3, np.pi / 2)
    assert (followers.fit(there, "dining_table", table, ["wardrobe"]) == 1) == fits
    assert followers.fit(there, "dining_table", table, []) == 1


def test_before_a_sofa_a_small_low_table_stands_where_a_usual_one_finds_no_place() -> None:
    """The largest first, on the sofa's axis, its edge a walk's width before the seat."""
    there, said = room(4.0, 5.0), box((0.8, 1.3, 0.42), 1.0, 1.0)[None]
    assert not any(len(places) for _, places in instead.alternatives("coffee_table", said, there, {}))
    there.add("sofa", box((0.9, 2.0, 0.8), -1.54, 0.3))
    found = [places for _, places in instead.alternatives("coffee_table", said, there, {})]
    assert [tuple(places[0, 3:5].round(2)) for places in found] == [(0.5, 0.9), (0.45, 0.6)]
    for places in found:
        assert np.allclose(places[:, 0] - places[:, 3] / 2, -1.54 + 0.45 + followers.BEFORE, atol=1e-3)
        assert np.allclose(places[:, 1], 0.3, atol=1e-3)


def test_below_a_low_table_there_is_a_rug_for_every_room() -> None:
    """All lie below all of it, as thick as the candidates; without a table there is none."""
    said, there = np.array([[0, 0, 0, 2.0, 3.0, 0, 0.006]] * 3, np.float32), room()
    assert not instead.alternatives("rug", said, there, {})
    low = box((0.6, 1.1, 0.42), 0.5, 0.2, np.pi / 2)
    there.add("coffee_table", low)
    found = instead.alternatives("rug", said, there, {})
    assert [places[0, 3] for _, places in found] == pytest.approx([1.6, 1.4, 1.2])
    for _, places in found:
        assert np.allclose(places[:, 2], low[2]) and np.allclose(places[:, 5:], [0, 0.006])
        half = places[:, 4:2:-1] / 2 - (0.55, 0.3)  # turned by a right angle, beyond the table
        assert (np.abs(places[:, :2] - low[:2]) <= half + 0.15).all()


@pytest.mark.parametrize("x, wide, ends", [
    (0.0, 2.0, (-1.0, 1.0)), (1.0, 2.0, (0.0, 2.0)), (1.4, 2.0, (0.4, 2.0)), (-1.3, 1.8, (-2.0, -0.4)),
    (2.1, 2.0, (1.1, 3.1)),
])
def test_no_screen_stands_past_the_corner_of_its_wall(x: float, wide: float, ends: tuple[float, float]) -> None:
    """At the north wall, which ends at ± 2 m; one that would be left less than 1.2 m stays as it is, like a chest."""
    stand = box((0.4, wide, 0.5), x, 1.79, -np.pi / 2)
    found = followers.backed("tv_stand", stand, room().space)
    assert found[0] + found[4] / 2 * np.array([-1, 1]) == pytest.approx(ends, abs=0.1 + 1e-5)
    assert abs(found[0]) + found[4] / 2 < 2.0 + 1e-5 or found[4] == wide
    assert found[[1, 2, 3, 5, 6]] == pytest.approx(stand[[1, 2, 3, 5, 6]])
    assert np.array_equal(followers.backed("chest", stand, room().space), stand)
