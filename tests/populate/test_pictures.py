"""Which pictures hang where: one room's are no other's, none looks like another, and no wall is left bare or plain."""

from types import SimpleNamespace

import numpy as np
import pytest
from inhabited import furnished, library, lived_in, things

from apartgen.stages.populate import faces, pictures, stage
from apartgen.stages.things import small
from apartgen.stages.things.materials import PALETTE


def rooms(*bases):
    return [SimpleNamespace(id=f"{base}_{k}", base=base) for k, base in enumerate(bases)]


HOUSE = rooms("living_room", "kitchen", *["bedroom"] * 5, "bathroom", "hallway", "study", "dining_room", "balcony")


def models(seed):
    return stage._models(np.random.default_rng(seed))["picture"]


@pytest.mark.parametrize("seed", range(3))
def test_a_houses_rooms_share_no_picture_and_each_has_some(seed):
    every = models(seed)
    hands = {room.id: pictures.dealt(HOUSE, every, room) for room in HOUSE}
    dealt = [design for own in hands.values() for design in own]
    assert len(dealt) == len({id(design) for design in dealt}) > 40
    for room in HOUSE:
        high = pictures.COUNT.get(room.base, (0, 0))[1]
        assert len(hands[room.id]) >= min(high, 1) and (high or not hands[room.id]), room.id
    assert len(hands["living_room_0"]) >= 8


@pytest.mark.parametrize("seed", range(3))
def test_no_two_pictures_of_a_home_are_of_one_composition_in_the_same_colours(seed):
    """Whatever they measure and however they are framed."""
    every = models(seed)
    looks = {worn["print"] if printed(design) else (design.style, worn["art"], worn["ink"]) for design in every
             for worn in [small.worn(design.kind, design.seed)]}
    assert len(every) == len(looks) == small.TABLE["picture"].designs


def printed(design):
    return design.style in ("framed", "mounted", "canvas")


def test_a_picture_shows_the_colours_that_it_is_told_by():
    for design in models(0):
        worn = small.worn(design.kind, design.seed)
        (link,) = library().load_asset("parametric", design.id()).links
        told = {worn["print"]} if printed(design) else {worn["art"], worn["ink"]}
        assert told <= {mesh.material.name for mesh in link.visuals}


@pytest.mark.parametrize("style", ["mounted", "canvas", "poster", "landscape", "stripes", "sun", "tiles", "hills"])
def test_pictures_of_earlier_versions_can_still_be_had(style):
    (link,) = library().load_asset("parametric", f"picture/{style}/25x500x400/3").links
    assert link.visuals
    assert all(design.style not in small.TABLE["picture"].former for design in models(1))


def test_a_print_is_shown_once_and_upright():
    design = next(design for design in models(0) if design.style == "framed")
    (link,) = library().load_asset("parametric", design.id()).links
    (sheet,) = [mesh for mesh in link.visuals if mesh.material.name == small.worn(design.kind, design.seed)["print"]]
    front = np.isclose(sheet.vertices[:, 0], sheet.vertices[:, 0].max())
    across, up = sheet.vertices[front, 1], sheet.vertices[front, 2]
    assert sheet.uv[front].min(0) == pytest.approx([0, 0], abs=0.01)
    assert sheet.uv[front].max(0) == pytest.approx([1, 1], abs=0.01)
    assert np.corrcoef(sheet.uv[front, 1], up)[0, 1] > 0.99 and np.corrcoef(sheet.uv[front, 0], across)[0, 1] > 0.99


def bare(length, *swept, covered=()):
    """Where along a wall of that length pictures are wanted on what is bare; doors sweep some of it."""
    face = faces.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), length, list(covered), swept)
    assert not swept or not face.free(swept[0][0] + 0.3, 0.2, 1.4, 1.6), "nothing hangs where a leaf comes"
    return [round(s, 6) for _, s, _ in pictures.free([face], pictures.BARE, *pictures._UPRIGHT, shut=True)]


def test_a_wall_behind_a_door_is_as_bare_as_any():
    """2.2 m, of which .9 are swept: what is left is shorter than 1.5 m, and has a picture in its middle anyway."""
    assert bare(2.2, (0.0, 0.9, 0.0, 2.1)) == [1.55]
    assert bare(2.2) == [1.1] and bare(1.4) == [] and bare(2.2, covered=[(0.5, 1.0, 0.0, 1.0)]) == []


def test_no_picture_is_wanted_where_doors_sweep_all_of_it():
    assert bare(1.8, (0.0, 0.9, 0.0, 2.1), (0.85, 1.8, 0.0, 2.1)) == []


def wanted(length, *swept, covered=()):
    """Where along a wall of that length pictures are wanted, and over what height, since eyes find nothing there."""
    face = faces.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), length, list(covered), swept)
    return [(round(s, 6), low) for _, s, low in pictures.plain([face])]


TABLE = (0.0, 3.0, 0.0, 0.75)


def test_a_wall_behind_low_furniture_is_plain():
    assert wanted(3.0, covered=[TABLE]) == [(1.5, 0.75)]
    assert wanted(3.0, covered=[TABLE, (1.2, 1.8, 1.2, 1.8)]) == []
    assert wanted(1.3) == [(0.65, 0.0)] and wanted(1.1) == []


def test_a_short_stretch_beside_something_is_not():
    assert wanted(3.0, covered=[(0.0, 1.1, 0.0, 2.1)]) == [] != wanted(3.2, covered=[(0.0, 1.1, 0.0, 2.1)])


def test_a_long_plain_wall_gets_one_after_another():
    face = faces.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), 6.0, [])
    room = SimpleNamespace(id="living_room_1", base="living_room")
    hung = pictures.hung(room, [face], [], models(0), 0.01, np.random.default_rng(0))
    assert len(hung) >= 2 and not pictures.plain([face])


def test_a_plain_wall_whose_middle_has_no_room_gets_one_beside():
    """A television reaches to just below the height of eyes, and over its edge no picture of the usual height fits."""
    cabinet, stand, wardrobe = (1.5, 2.44, 0.0, 1.86), (4.08, 5.88, 0.0, 0.58), (6.03, 7.53, 0.0, 2.2)
    seen, socket = (4.38, 5.58, 0.58, 1.3), (3.94, 4.02, 0.26, 0.34)
    face = faces.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), 7.53,
                      [(0.0, 1.5, 0.0, 2.2), cabinet, stand, seen, socket, wardrobe])
    room = SimpleNamespace(id="living_room_1", base="living_room")
    ((_, (x, _, z), _),) = pictures.hung(room, [face], [], models(0), 0.01, np.random.default_rng(0))
    assert 2.94 <= x <= 3.88 and z == pictures.EYE and not pictures.plain([face])


@pytest.mark.parametrize("seed", range(3))
def test_no_wall_of_a_living_room_is_plain(seed):
    home = lived_in(seed)
    room = next(room for room in home.rooms if room.base == "living_room")
    here = [o for o in home.objects if o.room == room.id and o.category not in ("light_switch", "socket")]
    assert not [s for face, s, _ in pictures.plain(faces.faces_of(home, room, here)) if 0.6 < s < face.length - 0.6]


@pytest.mark.parametrize("seed", range(3))
def test_a_clock_hangs_apart_from_pictures(seed):
    hung = [o for o in things(lived_in(seed)) if o.category in ("picture", "wall_clock")]
    for clock in (o for o in hung if o.category == "wall_clock"):
        for o in hung:
            if o is not clock and o.room == clock.room:
                apart = np.hypot(*np.subtract(o.center[:2], clock.center[:2])) - (o.size[1] + clock.size[1]) / 2
                above = abs(o.center[2] - clock.center[2]) - (o.size[2] + clock.size[2]) / 2
                assert max(apart, above) >= 0.3 - 1e-3


def test_nothing_hangs_in_bathrooms_that_steam_would_spoil():
    assert not [o for seed in range(3) for o in things(lived_in(seed)) if o.category == "picture"
                and o.room in {room.id for room in furnished().rooms if room.base == "bathroom"}]


def test_a_frame_is_seen_on_a_white_wall():
    brightest = max(max(PALETTE[name].color[:3]) for name in small.TABLE["picture"].looks["frame"])
    assert brightest < 0.9 < min(PALETTE["white"].color[:3])


@pytest.mark.parametrize("base, counts", [
    ("bedroom", {1, 2, 3}), ("hallway", {1, 2}), ("study", {1, 2}), ("dining_room", {1, 2}), ("kitchen", {0, 1})])
def test_so_many_pictures_hang_where_walls_have_room(base, counts):
    room, every = SimpleNamespace(id=f"{base}_1", base=base), models(0)
    found = set()
    for seed in range(12):
        walls = [faces.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), 4.0, []) for _ in range(4)]
        found.add(len(pictures.hung(room, walls, [], every, 1.0, np.random.default_rng(seed))))
    assert found == counts


@pytest.mark.parametrize(("span", "bare"), [
    ((0.0, 1.29), True), ((0.0, 1.31), False), ((1.69, 2.2), False), ((1.71, 2.2), True)])
def test_what_is_below_or_above_where_eyes_look_leaves_the_wall_free(span, bare):
    """A cabinet a metre long in the middle of three: the eyes see from 1.3 to 1.7 m."""
    face = SimpleNamespace(covered=[(1.0, 2.0, *span)], swept=[], length=3.0)
    found = sorted((s, low) for _, s, low in pictures.free([face], 0.9))
    assert found == ([(1.5, span[1] if span[1] < 1.5 else 0.0)] if bare else [(0.5, 0.0), (2.5, 0.0)])
