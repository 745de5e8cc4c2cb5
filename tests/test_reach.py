"""What a robot gets to in a flat worked out by hand."""

import handmade as h
import numpy as np
import pytest
from shapely.geometry import box as rectangle

from stages import footprints, reach


def survey(*objects, radius=0.25):
    return reach.survey(reach.space(h.plan(), radius), objects)


def test_an_empty_flat_is_all_reached():
    got = survey()
    assert got.missed == []
    g = reach.space(h.plan()).grid
    inside = 3.5 * 2.5 + 2.5 * 2.5
    assert got.cells.sum() * g.cell == pytest.approx(inside, abs=0.4)


def test_a_wide_robot_does_not_pass_a_narrow_door():
    assert survey(radius=0.46).missed == ["door_1", "bedroom_1"]


def test_a_wardrobe_before_the_door_cuts_the_bedroom_off():
    got = survey(h.thing("bookshelf", 3.8, 1.5, np.pi, size=(0.3, 2.4, 2.0)))
    assert got.doors == ["door_1"] and got.rooms == ["bedroom_1"]


def test_a_chest_needs_its_front_free():
    assert survey(h.chest(2, 2.75, -np.pi / 2)).missed == []
    away = survey(h.chest(2, 2.70, np.pi / 2, id="turned"))
    assert away.closed == ["turned"] and away.opened == []


def test_an_open_drawer_needs_room_beyond_it():
    # Opposite the entrance, 1.05 m away: with its drawer out by 0.8 the robot can't come in any more.
    facing = h.chest(1.3, 1.45, np.pi, travel=0.8, id="chest")
    got = survey(facing)
    assert got.closed == [] and got.opened == ["chest"]
    assert survey(h.chest(1.3, 1.45, np.pi, travel=0.4)).missed == []
    # Between a chest and a sofa 0.45 m away there is no standing at all.
    wall_to_wall = h.thing("sofa", 2.0, 1.65, size=(0.8, 3.9, 0.8), yaw=np.pi / 2)
    assert survey(h.chest(2, 2.75, -np.pi / 2, id="chest"), wall_to_wall).closed == ["chest"]


def test_beside_an_open_drawer_is_good_enough():
    # The sofa leaves 0.65 m before the chest: less than the drawer and the robot, but the robot may stand beside it.
    sofa = h.thing("sofa", 2.6, 1.45, size=(0.8, 2.6, 0.8), yaw=np.pi / 2)
    assert survey(h.chest(2, 2.75, -np.pi / 2), sofa).opened == []


@pytest.mark.parametrize("seed", range(8))
def test_a_look_around_decides_as_the_whole_flat_does(seed, monkeypatch):
    rng = np.random.default_rng(seed)
    chests = [h.chest(*rng.uniform((0.4, 0.4), (3.6, 2.6)), float(rng.integers(4) * np.pi / 2),
                      travel=float(rng.uniform(0.2, 0.8)), id=f"c{i}") for i in range(3)]
    far = [h.chest(*rng.uniform((4.5, 0.4), (6.7, 2.6)), float(rng.integers(4) * np.pi / 2), h.BEDROOM,
                   travel=float(rng.uniform(0.2, 0.8)), id=f"f{i}") for i in range(2)]
    looked = []
    local = reach._locally
    monkeypatch.setattr(reach, "_locally", lambda *args: looked.append(local(*args)) or looked[-1])
    near = survey(*chests, *far)
    monkeypatch.setattr(reach, "_locally", lambda *args: None)
    assert near.missed == survey(*chests, *far).missed


def test_what_hangs_high_is_passed_under():
    lamps = [h.thing("wall_lamp", 2, y, size=(0.14, 0.35, 0.3), bottom=1.6) for y in np.arange(0.2, 3, 0.4)]
    assert survey(*lamps).missed == []
    low = [h.thing("wall_lamp", 2, y, size=(0.14, 0.35, 0.3), bottom=1.2) for y in np.arange(0.2, 3, 0.4)]
    assert survey(*low).rooms == [h.LIVING, h.BEDROOM]


def test_a_room_of_which_much_is_cut_off_is_not_reached():
    # A wall of shelves leaves the bedroom's far end 0.4 m deep, where no robot stands, or 1.2 m.
    def shelves(left):
        return h.thing("shelving", 7.1 - left - 0.15, 1.5, np.pi, h.BEDROOM, size=(0.3, 3.0, 1.8))

    assert survey(shelves(0.4)).rooms == []
    assert survey(shelves(1.2)).rooms == [h.BEDROOM]



def test_rugs_and_lamps_are_no_obstacles():
    rug, lamp = h.thing("rug", 2, 1.5), h.thing("ceiling_lamp", 2, 1.5, bottom=2.1)
    assert footprints.obstacles([rug, lamp, h.thing("sofa", 2, 1)]).tolist() == [False, False, True]
    assert survey(rug, lamp).missed == []


def test_ratios_by_hand():
    floor = rectangle(0, 0, 4, 3)
    a, b = h.thing("sofa", 1, 1, size=(1, 2, 1)), h.thing("sofa", 1, 1, size=(1, 2, 1))
    assert footprints.walkable_ratio(floor, [a, b]) == pytest.approx(10 / 12)
    assert footprints.plain_ratio(floor, [a, b]) == pytest.approx(8 / 12)
    outside = h.thing("sofa", 0, 1, size=(1, 2, 1))
    assert footprints.walkable_ratio(floor, [outside]) == pytest.approx(11 / 12)
    assert footprints.walkable_ratio(floor, []) == 1
