"""What the base is told to do, and the ways it is told to take: worked out by hand, without a simulator."""

from itertools import product
from math import atan2, cos, hypot, pi, sin
from types import SimpleNamespace

import networkx
import numpy as np
import pytest
from embodied import blocks

from apartgen.stages.embodied import base, drive, goals, planner, pursuit
from apartgen.stages.embodied.floor import Field, clearance_at
from apartgen.stages.embodied.pursuit import Pursuit
from apartgen.stages.space.grid import Grid

SIZE = 0.05


def slope(of, left=-2.0, below=-2.0, cells=80):
    """A field whose clearance at x, y is `of(x, y)`."""
    at = (np.arange(cells) + 0.5) * SIZE
    x, y = np.meshgrid(left + at, below + at)
    return Field(np.ascontiguousarray(of(x, y)), left, below, SIZE)


def floor(of=lambda x, y: 1.0 + 0 * x):
    field = slope(of)
    return SimpleNamespace(field=field, near=lambda x, y: clearance_at(field, x, y),
                           beside=lambda points: np.array([clearance_at(field, *p) for p in points]))


def along(length=1.5, y=0.0, **more):
    """A controller on a straight path along x."""
    path = np.stack([np.arange(0, length + 1e-9, planner.SPACING), np.full(int(length / planner.SPACING + 1.5), y)], 1)
    return Pursuit(more.pop("floor", floor()), path, **{"heading": 0.0, **more})


def test_clearance_between_cells_is_that_of_a_plane_and_beyond_the_edge_that_of_the_edge():
    field = slope(lambda x, y: 0.3 * x - 0.2 * y + 0.1)
    for x, y in ((0.0, 0.0), (0.513, -1.207), (-1.9, 1.7)):
        assert clearance_at(field, x, y) == pytest.approx(0.3 * x - 0.2 * y + 0.1)
    assert clearance_at(field, -9.0, 0.0) == pytest.approx(0.3 * (-2 + SIZE / 2) + 0.1)
    assert clearance_at(field, 9.0, 9.0) == pytest.approx(0.3 * (2 - SIZE / 2) - 0.2 * (2 - SIZE / 2) + 0.1, abs=1e-3)


@pytest.mark.parametrize("yaw, bend, run", [(0.0, 1e-6, 1.0), (0.0, 1.0, 1.0), (0.0, -1.0, 1.2), (1.1, 0.7, 0.8),
                                            (-2.0, -1.3, 0.9)])
def test_an_arc_ends_where_a_circle_does(yaw, bend, run):
    """Clearance falls evenly towards where the arc ends, so that its end decides."""
    middle = -sin(yaw) / bend, cos(yaw) / bend
    end = middle[0] + sin(yaw + bend * run) / bend, middle[1] - cos(yaw + bend * run) / bend
    toward = np.array(end) / hypot(*end)
    field = slope(lambda x, y: 3 - toward[0] * x - toward[1] * y)
    least = 3 - hypot(*end)
    assert pursuit._arc_clear(field, 0.0, 0.0, yaw, bend, run, least - 0.003)
    assert not pursuit._arc_clear(field, 0.0, 0.0, yaw, bend, run, least + 0.003)


def test_angles_are_turned_the_shorter_way():
    for angle, same in ((3.0, 3.0), (pi + 0.1, 0.1 - pi), (-pi - 0.1, pi - 0.1), (7.0, 7.0 - 2 * pi)):
        assert pursuit._wrapped(angle) == pytest.approx(same)
    assert pursuit._off((1.0, 1.0), pi / 2, (0.0, 1.0)) == pytest.approx(pi / 2)
    assert pursuit._off((0.0, 0.0), 3.0, (-1.0, -0.1)) == pytest.approx(atan2(-0.1, -1.0) + 2 * pi - 3.0)


def test_the_nearest_point_and_the_first_beyond():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0]])
    places = ((0.4, 9.0), (0.5, 0.0), (1.6, -1.0), (2.0, 0.6))
    assert [pursuit._nearest(points, *place) for place in places] == [3, 0, 2, 3], "the first of equals"
    assert [pursuit._beyond(points, 0, 0.0, 0.0, r) for r in (0.0, 0.9, 1.0, 1.1, 2.1, 9.0)] == [0, 1, 1, 2, 3, 3]
    assert pursuit._beyond(points, 2, 0.0, 0.0, 0.5) == 2


def test_it_turns_no_faster_than_it_can_stop():
    for off in (0.05, -0.2, 0.4):
        turn = along()._turn_to(off)
        assert np.sign(turn) == np.sign(off)
        assert turn**2 / (2 * 0.6 * base.TURN_ACCELERATION) == pytest.approx(abs(off)), "the way it takes to stop"
    assert along()._turn_to(-3.0) == -base.TURN


def test_speeds_change_by_what_motors_give_in_a_period():
    it = along()
    it._limited(9.0, -9.0)
    assert (it.speed, it.turn) == pytest.approx((1.0 * 0.05, -3.2 * 0.05))
    it.speed, it.turn = 0.3, 0.3
    it._limited(0.29, 0.0)
    assert (it.speed, it.turn) == pytest.approx((0.29, 0.14))


def test_the_arc_is_pure_pursuits():
    """Through the robot, along its heading, to the carrot: curvature 2 y / d², y being how far it lies to the left."""
    it = along(speed=0.4)
    x, y, yaw = 0.2, 0.08, 0.1
    reach = 0.4 * 1.5
    carrot = next(p for p in it.path if p[0] >= x and hypot(p[0] - x, p[1] - y) >= reach)
    dx, dy = carrot - (x, y)
    speed, turn = it._wanted((x, y), yaw, 1.3)
    assert turn / speed == pytest.approx(2 * (-sin(yaw) * dx + cos(yaw) * dy) / (dx * dx + dy * dy))
    assert speed == base.SPEED


@pytest.mark.parametrize("near, curvature, left, speed", [
    (1.0, 0.0, 2.0, 0.5), (0.45, 0.0, 2.0, 0.375), (0.2, 0.0, 2.0, 0.25), (1.0, 2.0, 2.0, 0.5 / 1.8),
    (1.0, -2.0, 2.0, 0.5 / 1.8), (1.0, 9.0, 2.0, 0.25), (1.0, 0.0, 0.3, 0.25), (1.0, 0.0, 0.06, 0.05),
    (1.0, 0.0, 0.001, 0.05), (0.45, 0.0, 0.3, 0.1875),
])
def test_it_slows_beside_things_in_curves_and_before_the_goal(near, curvature, left, speed):
    assert along(floor=floor(lambda x, y: near + 0 * x))._regulated((0.0, 0.0), curvature, left) == pytest.approx(speed)


def test_what_lies_far_aside_is_turned_to_on_the_spot():
    it = along(speed=0.4)
    assert it._wanted((0.0, 0.0), 0.7, 1.5)[0] > 0 and not it.turning
    speed, turn = it._wanted((0.0, 0.0), 0.9, 1.5)
    assert speed == 0.0 and turn == pytest.approx(it._turn_to(-0.9)) and it.turning
    assert it._wanted((0.0, 0.0), 0.3, 1.5)[0] == 0.0, "it goes on turning until a quarter of that is left"
    assert it._wanted((0.0, 0.0), 0.15, 1.5)[0] > 0 and not it.turning


def test_narrow_places_are_driven_slowly_and_heeded_half_a_metre_ahead():
    it = along(floor=floor(lambda x, y: np.where(x > 0.8, base.RADIUS + 0.08, 1.0)), speed=0.5)
    narrow = [k for k, room in enumerate(it.tightest) if room < base.RADIUS + 0.1]
    assert 0.8 - 0.5 - 0.05 <= it.points[narrow[0]][0] <= 0.8 - 0.5 + 0.1
    it._advance((1.0, 0.0))
    assert it._wanted((1.0, 0.0), 0.0, 2.0)[0] == pytest.approx(0.2)
    assert it._wanted((1.0, 0.0), 0.3, 2.0)[0] == 0.0, "and turned in sooner"


def test_in_the_tightest_it_goes_from_point_to_point():
    it = along(floor=floor(lambda x, y: base.RADIUS + 0.02 + 0 * x))
    it._advance((0.5, 0.0))
    speed, turn = it._wanted((0.5, 0.0), 0.1, 1.0)
    assert speed == 0.1 and turn < 0
    assert it._wanted((0.5, 0.0), 0.2, 1.0)[0] == 0.0 and it.turning
    assert it._wanted((0.5, 0.0), 0.1, 1.0)[0] == 0.0, "until it heads for the next point closely"
    assert it._wanted((0.5, 0.0), 0.05, 1.0)[0] == 0.1


def test_it_looks_for_the_nearest_point_ahead_only_and_loses_patience():
    it = along()
    it._advance((1.2, 0.0))
    assert it.points[it.at][0] == pytest.approx(0.95), "no further than a metre"
    it._advance((0.3, 0.0))
    assert it.points[it.at][0] == pytest.approx(0.95), "nor back"
    for _ in range(59):
        it._advance((0.95, 0.0))
    assert it.inching == 0 and it.waited == 60
    it._advance((0.95, 0.0))
    assert it.inching == 20 and it.waited == 0


def test_it_has_arrived_near_the_goal_once_it_looks_where_it_should():
    it = along(heading=1.0)
    assert not it.command(1.5 - 0.2, 0.0, 0.0)[2] and not it.arrived
    speed, turn, done = along(heading=1.0).command(1.5 - 0.18, 0.0, 0.0)
    assert (speed, done) == (0.0, False) and turn == pytest.approx(3.2 * 0.05)
    assert along(heading=1.0).command(1.5 - 0.18, 0.0, 0.76)[2] and not along(heading=1.0).command(1.4, 0.0, 0.74)[2]
    assert not along(heading=1.0, speed=0.2).command(1.4, 0.0, 1.0)[2], "still rolling"


@pytest.mark.parametrize("yaw", [0.0, 0.4, -2.5, 3.1])
def test_the_pose_is_the_joints(yaw):
    qpos = np.array([1.0, 2.0, 0.1, cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)])
    x, y, found = drive._pose(qpos)
    assert (x, y, pursuit._wrapped(found - yaw)) == pytest.approx((1.0, 2.0, 0.0))


@pytest.mark.parametrize("push, done, still, seconds, reason", [
    (15.1, True, 0, 1, "ran against chair"), (15.0, True, 9, 99, ""), (0, False, 2.0, 1, ""),
    (0, False, 2.1, 1, "stuck"), (0, False, 0, 60.0, ""), (0, False, 0, 60.1, "too slow"),
])
def test_how_drives_end(push, done, still, seconds, reason):
    out = drive.Drive(seconds=seconds, push=push, touched="chair", done=done)
    assert drive._ended(out, still, 60.0) == reason


def passed(down, right):
    """Cells that the segment from one centre to another goes through, but for its ends."""
    steps = np.linspace(0.01, 0.99, 99)
    return {(round(down * t), round(right * t)) for t in steps if abs(down * t % 1 - 0.5) > 0.02
            and abs(right * t % 1 - 0.5) > 0.02} - {(0, 0), (down, right)}


@pytest.mark.parametrize("seed", range(4))
def test_costs_of_ways_are_those_of_a_graph_drawn_cell_by_cell(seed):
    rng = np.random.default_rng(seed)
    weight = np.where(rng.random((9, 8)) < 0.3, np.inf, 1 + rng.random((9, 8)))
    weight[0, 0] = 1.0
    graph = networkx.Graph()
    graph.add_node((0, 0))
    for (i, j), own in np.ndenumerate(weight):
        near = product(range(-2, 3), repeat=2)
        for down, right in ((a, b) for a, b in near if {abs(a), abs(b)} in ({0, 1}, {1}, {1, 2})):
            on = [(i + a, j + b) for a, b in [*passed(down, right), (down, right)]]
            inside = all(0 <= a < 9 and 0 <= b < 8 for a, b in on)
            if np.isfinite(own) and inside and all(np.isfinite(weight[at]) for at in on):
                graph.add_edge((i, j), on[-1], weight=hypot(down, right) * (own + weight[on[-1]]) / 2)
    cost, before = planner._dijkstra(weight, (0, 0))
    known = networkx.single_source_dijkstra_path_length(graph, (0, 0))
    for at, found in np.ndenumerate(cost.reshape(9, 8)):
        assert found == pytest.approx(known.get(at, np.inf))
    assert before[0] == -1 and all((before[k] >= 0) == (np.isfinite(cost[k]) and k > 0) for k in range(72))


def test_a_metre_costs_one_far_off_and_more_the_nearer_things_are():
    away = np.array([[-0.01, 0.0, 0.03, 0.06, 0.2, 0.29, 0.31, 0.8]]) + 0.25
    it = SimpleNamespace(clearance=away, radius=0.25, free=away >= 0.25)
    cost = planner.costs(it)[0]
    navfn = [(50 + 0.8 * 252 * np.exp(-3 * d)) / 50 for d in (0.0, 0.03, 0.06, 0.2, 0.29)]
    assert np.isinf(cost[0]) and cost[1:] == pytest.approx(np.add([*navfn, 1, 1], [20, 10, 0, 0, 0, 0, 0]))


def test_paths_are_divided_evenly():
    found = planner._resampled(np.array([[0.0, 0.0], [0.3, 0.0], [0.3, 0.42]]))
    assert len(found) == 16 and found[0] == pytest.approx([0, 0]) and found[-1] == pytest.approx([0.3, 0.42])
    at = found[:, 0] + found[:, 1]
    assert np.diff(at) == pytest.approx(0.72 / 15)
    assert (np.abs(found[:, 1] * (found[:, 0] - 0.3)) < 1e-9).all()


def test_the_cell_that_holds_a_point_is_the_last_at_the_edge():
    it = SimpleNamespace(grid=Grid((-1.0, 2.0), (4, 6), 0.5))
    points = np.array([[-0.9, 2.1], [0.6, 3.4], [-9.0, -9.0], [9.0, 9.0]])
    assert planner.cell(it, points).tolist() == [[0, 0], [2, 3], [0, 0], [3, 5]]


def met(clearance, reached, *places, towards=(0.5, 0.5)):
    grid = Grid((0.0, 0.0), (1, len(clearance)), 1.0)
    free = np.array([clearance]) > 0.25
    it = SimpleNamespace(grid=grid, clearance=np.array([clearance]), free=free)
    found = goals._chosen(goals.Goal("r", "o", "sofa"), it, [np.array([p], bool) for p in places],
                          np.array([reached], bool), np.array(towards))
    return found


def test_goals_are_the_roomiest_cells_and_of_equal_ones_the_nearest():
    assert met([0.3, 0.4, 0.4, 0.4], [0, 1, 1, 1], [1, 1, 1, 1]).cell == (0, 1)
    assert met([0.3, 0.3, 0.4, 0.5], [0, 1, 1, 1], [1, 1, 1, 1], towards=(0.5, 9.5)).cell == (0, 3)
    assert met([0.3, 0.3, 0.35, 0.5], [0, 1, 1, 1], [1, 1, 1, 0]).cell == (0, 1), "5 cm are not worth a metre"
    assert met([0.3, 0.3, 0.42, 0.5], [0, 1, 1, 1], [1, 1, 1, 0]).cell == (0, 2), "12 cm are"
    assert met([0.3, 0.6, 0.9, 2.0], [0, 1, 1, 1], [1, 1, 1, 1]).cell == (0, 1), "more than enough is no better"
    assert met([0.3, 0.6, 0.9, 2.0], [0, 1, 1, 1], [1, 0, 0, 0], [0, 0, 0, 1]).cell == (0, 3), "the second best places"
    assert met([0.3, 0.6], [0, 1], [0, 1], towards=(1.5, 2.5)).yaw == pytest.approx(pi / 2)
    assert met([0.3, 0.6], [0, 0], [0, 1]).missing == "planner" and met([0.3], [1], [0]).missing == "no standing room"


def test_it_starts_where_most_room_is_inside_the_entrance_and_looks_in():
    home = blocks.corridor(4, 1)
    south = home.openings[0].model_copy(update={"segment": ((1.0, -0.15), (1.9, -0.15))})
    clearance = np.array([[0.3, 0.5, 0.4, 0.9]])
    space = SimpleNamespace(entry=np.array([[1, 1, 1, 0]], bool), plan=home.model_copy(update={"openings": [south]}))
    for free, cell in (([1, 1, 1, 1], (0, 1)), ([1, 0, 1, 1], (0, 2)), ([0, 0, 0, 1], None)):
        found = goals.start(SimpleNamespace(free=np.array([free], bool), clearance=clearance, space=space))
        assert found == ((cell, pytest.approx(pi / 2)) if cell else None)
