"""What a robot gets to in a flat worked out by hand."""

import handmade as h
import numpy as np
import pytest
from shapely.geometry import box as rectangle

from apartgen.schemas.retrieve import Joint
from apartgen.stages.robot import handling, reach
from apartgen.stages.space import footprints
from apartgen.stages.space.grid import Grid


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



def test_each_part_must_be_within_an_arms_reach():
    def desk(side):
        """2 m wide against the north wall, with one drawer of 0.4 m at its left (1, east) or right (-1) end."""
        lo, hi = sorted((side * 0.95, side * 0.55))
        extent = ((-0.2, lo, 0.0), (0.25, hi, 0.2))
        joint = Joint(name="drawer_0", type="slide", axis=(1, 0, 0), origin=(0, 0, 0), range=(0, 0.35), part="drawer",
                      extent=extent)
        return h.thing("desk", 2.0, 2.75, -np.pi / 2, id="desk", size=(0.5, 2.0, 0.75), joints=(joint,))

    # A sofa fills the floor before the east half; the front is still got to beside it.
    sofa = h.thing("sofa", 3.0, 1.6, size=(2.0, 1.8, 0.8))
    east, west = survey(desk(1), sofa), survey(desk(-1), sofa)
    assert east.closed == [] and east.opened == ["desk"]
    assert "desk" not in west.missed and survey(desk(1)).missed == []


@pytest.mark.parametrize("yaw", [0.0, 0.7, -np.pi / 2])
def test_an_arm_opens_a_leaf_from_out_of_its_way(yaw):
    size = (0.5, 0.8, 2.0)
    door = Joint(name="door", type="hinge", axis=(0, 0, 1), origin=(0.25, 0.4, 0), range=(0, np.pi / 2), part="door",
                 extent=((0.23, -0.4, -1.0), (0.25, 0.4, 1.0)))
    o = h.thing("wardrobe", 2.0, 1.5, yaw, size=size, joints=(door,))
    cells, free = Grid((0.0, 0.0), (30, 40), 0.1), np.zeros((30, 40), bool)
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    hinge, edge = turn @ (0.25, 0.4) + (2.0, 1.5), turn @ (0.25, -0.4) + (2.0, 1.5)
    assert turn @ handling.handle(door)[:2] + (2.0, 1.5) == pytest.approx(edge)
    able = 0
    for row, column in np.ndindex(30, 40):
        free[:] = False
        free[row, column] = True
        if handling.standing(o, door, cells, 0.25, free):
            at = np.array([cells.x[column], cells.y[row]])
            able += 1
            assert np.hypot(*(at - edge)) <= handling.ARM
            # Before the cabinet, the leaf's quarter turn stays clear of the disc.
            ahead, aside = turn.T @ (at - hinge)
            swept = ahead > 0 > aside
            assert not swept or np.hypot(ahead, aside) > 0.8 + 0.25 - 0.15
            # Every 18 degrees of the 72 by which it must open: halfway between, its edge comes as near from 1.006 m.
            assert not swept or np.arctan2(ahead, -aside) > 0.4 * np.pi or np.hypot(ahead, aside) > 1.0
    assert able > 5


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
