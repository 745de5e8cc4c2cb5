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
    # A sofa leaves 0.65 m before the chest (y 1.85 to 2.5), entered from the left: enough with the drawer shut only.
    sofa = h.thing("sofa", 2.6, 1.45, size=(0.8, 2.6, 0.8), yaw=np.pi / 2)
    got = survey(h.chest(2, 2.75, -np.pi / 2, id="chest"), sofa)
    assert got.closed == [] and got.opened == ["chest"]
    wall_to_wall = h.thing("sofa", 2.0, 1.45, size=(0.8, 3.9, 0.8), yaw=np.pi / 2)
    assert survey(h.chest(2, 2.75, -np.pi / 2, id="chest"), wall_to_wall).closed == ["chest"]


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
