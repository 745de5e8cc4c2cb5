"""Where the hand points, how it draws back and when servos are told what: by hand and by scipy's rotations."""

from collections import Counter
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from apartgen.schemas.retrieve import Joint
from apartgen.stages.embodied.interact import aim, near, parts, timing, ways
from apartgen.stages.embodied.interact.chains import Chains
from apartgen.stages.embodied.interact.robot import ARM, HAND, LIFT, posture, postures, tucked
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Link
from apartgen.stages.things.body import Body


def test_a_path_is_run_at_even_speed_between_two_parabolas():
    """Along 0, 1, 3 in one second and two: a metre a second, gathered and lost within half a second each."""
    path = np.array([[0.0], [1.0], [3.0]])
    at = timing.timed(path, np.array([1.0, 2.0]), 0.01, 0.5)[:, 0]
    t = np.arange(1, 351) * 0.01
    assert len(at) == 350 and at[-1] == pytest.approx(3.0)
    assert at[t <= 0.5] == pytest.approx(t[t <= 0.5] ** 2)
    middle = (t > 0.5) & (t < 3.0)
    assert at[middle] == pytest.approx(t[middle] - 0.25)
    assert at[t >= 3.0] == pytest.approx(3 - (3.5 - t[t >= 3.0]) ** 2)


def test_a_short_path_gathers_speed_all_the_time():
    at = timing.timed(np.array([[0.0], [1.0]]), np.array([0.2]), 0.01, 0.5)[:, 0]
    assert len(at) == 40 and np.diff(at).argmax() in (18, 19) and at[-1] == pytest.approx(1.0)
    assert len(timing.timed(np.array([[0.0], [1.0]]), np.array([0.0]), 0.01, 0.5)) == 2, "no time at all: three points"


def test_targets_are_means_over_both_sides():
    found = timing.smoothed(np.array([[0.0], [0.0], [0.0], [1.0], [1.0], [1.0]]), 1)
    assert found[:, 0].tolist() == [0, 0, 0, 0.5, 1, 1, 1, 1]
    line = timing.smoothed(np.arange(20.0)[:, None], 3)[:, 0]
    assert line[0] == 0 and line[-1] == 19 and np.diff(line)[6:-6] == pytest.approx(1.0)


TURN = Rotation.from_euler("zyx", [0.4, -0.2, 0.9])
PART = SimpleNamespace(front=TURN.apply([1.0, 0, 0]), up=TURN.apply([0, 0, 1.0]))
"""A part whose front looks along +x of a frame that is turned any way."""


@pytest.mark.parametrize("kind, side", [("pinch", -1), ("cup", -1), ("push", 1)])
def test_the_hand_points_at_the_object_but_for_a_turn_and_a_tilt(kind, side):
    opened = Rotation.from_rotvec(0.8 * PART.up)
    turns = np.stack([np.eye(3), opened.as_matrix()])
    found = aim.directions(PART, SimpleNamespace(kind=kind), turns)
    assert found.shape == (2, len(aim.OPTIONS), 3)
    for option, shut, open_ in zip(aim.OPTIONS, *found):
        level = Rotation.from_rotvec(option.yaw * PART.up).apply(side * PART.front)
        tilt = Rotation.from_rotvec(option.pitch * np.cross(PART.up, level)).apply(level)
        assert shut == pytest.approx(tilt)
        assert open_ == pytest.approx(opened.apply(tilt) if option.follows else tilt)


@pytest.mark.parametrize("kind, degrees, able", [
    ("pinch", 46, True), ("pinch", 44, False), ("cup", 59, True), ("cup", 61, False), ("push", 52, True),
    ("push", 54, False),
])
def test_a_hold_is_good_within_its_angle(kind, degrees, able):
    """Of fingers to what they pinch (90 is square to it), of the hand to the face that it sucks or pushes."""
    across = TURN.apply([0, 1.0, 0])
    hold = SimpleNamespace(kind=kind, across=across, out=PART.front)
    if kind == "pinch":
        ahead = Rotation.from_rotvec(np.radians(degrees) * PART.up).apply(across)
    else:
        ahead = Rotation.from_rotvec(np.radians(degrees) * PART.up).apply(PART.front * (1 if kind == "push" else -1))
    axes, good = aim.grasps(PART, hold, np.eye(3)[None], ahead[None])
    assert good.tolist() == [able]
    assert axes[0].T @ axes[0] == pytest.approx(np.eye(3), abs=1e-9) and np.linalg.det(axes[0]) == pytest.approx(1.0)
    assert axes[0, :, 0] == pytest.approx(ahead)


def test_fingers_lie_along_what_they_pinch_as_far_as_the_hand_lets_them():
    across, turned = TURN.apply([0, 1.0, 0]), Rotation.from_rotvec(0.3 * PART.up)
    hold = SimpleNamespace(kind="pinch", across=across)
    axes, _ = aim.grasps(PART, hold, turned.as_matrix()[None], -PART.front[None])
    assert axes[0, :, 1] == pytest.approx(across), "square to a hand that keeps its direction"
    axes, _ = aim.grasps(PART, hold, turned.as_matrix()[None], turned.apply(-PART.front)[None])
    assert axes[0, :, 1] == pytest.approx(turned.apply(across)), "with the part where the hand turns with it"


def test_simpler_ways_to_point_cost_less():
    cost = {(round(np.degrees(o.yaw)), round(np.degrees(o.pitch)), o.follows): o.cost for o in aim.OPTIONS}
    assert len(cost) == 26 and min(cost, key=cost.__getitem__) == (0, 0, False)
    assert cost[-35, 40, False] == pytest.approx(0.3 * np.radians(75)) and cost[0, 0, True] == pytest.approx(0.1)


BASE, HEADING = (0.3, -0.2, 0.7), 0.7


def held(bearing, out, height, yaw, pitch, roll):
    """A point and axes that a hand has with these turns of its joints, by scipy."""
    turn = Rotation.from_euler("ZYX", [bearing + yaw, pitch, roll])
    wrist = np.array([BASE[0] + out * np.cos(bearing), BASE[1] + out * np.sin(bearing), height])
    return wrist + HAND * turn.apply([1.0, 0, 0]), turn.as_matrix()


CASES = [(0.2, 0.5, 0.8, 0.4, 0.3, -0.5), (-2.4, 0.7, 1.2, -1.0, -0.9, 1.2), (3.0, 0.3, 0.5, 2.0, 1.2, 0.0)]


@pytest.mark.parametrize("case", CASES)
def test_postures_are_the_turns_that_hold_the_hand_there(case):
    bearing, out, height, *wrist = case
    at, turn = held(*case)
    found = posture(BASE, at, turn, 0.02)
    turret = (bearing - HEADING + np.pi) % (2 * np.pi) - np.pi
    by_hand = [*BASE, height, turret, *[(out - ARM[0]) / 3] * 3, *wrist, 0.02, 0.02]
    assert found == pytest.approx(by_hand)
    many, within = postures(BASE, at[None], turn[None], 0.02)
    assert within.all() and many[0] == pytest.approx(by_hand)


@pytest.mark.parametrize("case", CASES)
def test_a_hand_is_drawn_back_along_its_own_direction(case):
    at, turn = held(*case)
    back = ways.withdrawn(posture(BASE, at, turn, 0.02), 0.06)
    assert back == pytest.approx(posture(BASE, at - 0.06 * turn[:, 0], turn, 0.02))


@pytest.mark.parametrize("value, lo, hi", [("out", *ARM), ("height", *LIFT)])
def test_telescope_and_lift_end_where_they_end(value, lo, hi):
    for length, spare, within in ((lo + 0.01, 0.0, True), (lo - 0.01, 0.0, False), (hi - 0.01, 0.0, True),
                                  (hi + 0.01, 0.0, False), (lo + 0.01, 0.02, False), (hi - 0.01, 0.02, False)):
        at, turn = held(0.2, *((length, 0.8) if value == "out" else (0.5, length)), 0.0, 0.0, 0.0)
        assert (posture(BASE, at, turn, 0.0, spare=spare) is not None) == within
        assert postures(BASE, at[None], turn[None], 0.0, spare)[1].tolist() == [within]


def test_turns_go_on_from_those_before():
    at, turn = held(-3.0, 0.5, 0.8, 0.0, 0.0, 3.1)
    old = np.zeros(13)
    old[4], old[10] = 2.5, -3.0
    found = posture(BASE, at, turn, 0.0, old)
    assert found[4] == pytest.approx(2 * np.pi - 3.7) and found[10] == pytest.approx(3.1 - 2 * np.pi)


def test_ways_to_a_hold_begin_with_the_arm_in():
    before = posture(BASE, *held(*CASES[0]), 0.03)
    together, straight, last = ways.unfolding(np.array(BASE), before)
    for way in (together, straight, last):
        start = way[0]
        assert start[:5] == pytest.approx(before[:5]) and not start[5:8].any()
        assert start[8:11] == pytest.approx([0, -np.pi / 2, 0]) and start[11:] == pytest.approx([0.03, 0.03])
    assert len(straight) == 1
    assert together[1][8:] == pytest.approx(before[8:]) and not together[1][5:8].any()
    assert last[1][5:8] == pytest.approx(before[5:8]) and last[1][8:11] == pytest.approx([0, -np.pi / 2, 0])
    start, end = tucked(BASE, 0.5, 0.2), tucked(BASE, 1.5, -2.0)
    plain, *round_ = ways.turning(start, end)
    assert [way[0].tolist() for way in (plain, *round_)] == [start.tolist()] * 3 and len(plain) == 1
    for way, turn in zip(round_, (np.pi, -np.pi)):
        assert way[1][3] == 0.5 and way[2][3] == 1.5
        assert way[1][4] == way[2][4] == pytest.approx(0.2 + turn)


@pytest.mark.parametrize("kind, axis, reach, lo, hi", [
    ("slide", (2.0, 0, 0), (0.0, 0.4), (-3, -2), (3.4, 2)), ("slide", (0, -1.0, 0), (0.0, 0.4), (-3, -2.4), (3, 2)),
    ("hinge", (0, 0, 1.0), (0.0, np.pi / 2), (-3, 2 - 52**0.5), (3 + 4, 2)),
])
def test_what_a_part_passes_through_by_hand(kind, axis, reach, lo, hi):
    """A slab of 6 by 4 m; hinged at (3, 2), its diagonal hangs down on the way, and its short side ends level."""
    size = np.array([6.0, 4.0, 1.0])
    joint = Joint(name="j", type=kind, axis=axis, origin=(3, 2, 0) if kind == "hinge" else (0, 0, 0), range=reach,
                  part="hinge_door")
    part = Link("part", [], [solids.slab(-size / 2, size / 2)], 1.0, joint=joint, handle=np.zeros(3))
    low, high = near._span(Body("b", "object", "desk", "r", np.array([10.0, 20.0, 0.5]), 0.0, [part]), part)
    assert low[:2] == pytest.approx(np.add(lo, (10 - 0.05, 20 - 0.05)), abs=0.12)
    assert high[:2] == pytest.approx(np.add(hi, (10 + 0.05, 20 + 0.05)), abs=0.12)
    assert high[2] == pytest.approx(0.5 + near.ROBOT) and low[2] == pytest.approx(0.5 - near.ROBOT)


def test_the_cup_is_set_on_the_lid_and_not_as_high_as_what_stands_behind():
    """A lid whose top is at 0.5 m, hinged at the back, where a rail on it goes up to 0.6 m."""
    lid = Joint(name="j", type="hinge", axis=(0, -1.0, 0), origin=(-0.3, 0, 0.46), range=(0, 1.5), part="hinge_lid")
    boxes = np.array([[[-0.3, -0.4, 0.46], [0.3, 0.4, 0.5]], [[-0.3, -0.4, 0.5], [-0.2, 0.4, 0.6]]])
    handle = np.array([0.3, 0.1, 0.48])
    top, front = parts._cups(Link("lid", [], [], 1.0, joint=lid), boxes, handle, np.eye(4), np.arange(2))
    assert top.point == pytest.approx([0.3 - parts.LIP, 0.1, 0.5]) and top.out.tolist() == [0, 0, 1]
    assert front.point == pytest.approx(handle) and front.out.tolist() == [1, 0, 0]


@pytest.mark.parametrize("met, free", [(-1, True), (0, False), (7, False)])
def test_whatever_geom_the_arm_meets_counts(met, free):
    """They are numbered from 0 on; -1 is none."""
    known = SimpleNamespace(probe=SimpleNamespace(hit=lambda *_: met), part=None, values=[0.5], met=Counter())
    assert Chains.meets_nothing(known, np.zeros(13), 0, None) is free and known.met == {met: 1}
