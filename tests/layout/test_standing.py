"""What stands on what, and how far things are from walls, in cases by hand."""

import numpy as np
import pytest
import shapely
from rooms_for_tests import some_rooms

from apartgen.stages.layout.projection import candidates
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.projection.standing import Item, rests_on
from apartgen.stages.space.boxes import Boxes

CHEST = Item("chest", np.array([0.0, 0.0, 0.4]), np.array([0.5, 1.0, 0.8]), np.pi / 2)
"""Turned: 1 m along x, .5 m along y, its top at .8 m."""


@pytest.mark.parametrize("x, y, bottom, stands", [
    (0.3, 0.1, 0.8, True), (0.49, 0.0, 0.8, True), (0.505, 0.0, 0.8, True), (0.515, 0.0, 0.8, False),  # 1 cm beyond
    (0.3, 0.1, 1.0, False),  # above it, in the air
    (0.3, 0.1, 0.0, False),  # in it, on the floor
    (2.0, 0.1, 0.8, False),  # as high as its top, elsewhere
    (0.1, 0.3, 0.8, False),  # beyond its narrow side
    (0.6, 0.0, 0.8, False),
])
def test_a_lamp_stands_on_a_chest_when_level_and_above_it(x: float, y: float, bottom: float, stands: bool) -> None:
    lamp = Item("table_lamp", np.array([x, y, bottom + 0.2]), np.array([0.2, 0.2, 0.4]), 0.0)
    assert rests_on(lamp, CHEST) is stands


def test_backs_are_as_far_from_the_walls_within_a_room_and_beyond() -> None:
    """Backs 1 m before the near wall, on it, 5 cm beyond it, and 3 and 4 cm beyond both walls of a corner."""
    rooms = some_rooms(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :4] = [[0, 0], [4, 0], [4, 3], [0, 3]]
    backs = np.array([[2.0, 1.0], [2.0, 0.0], [2.0, -0.05], [-0.03, -0.04]])
    center = np.column_stack([backs + [0.0, 0.25], np.full(4, 0.5)])
    found = Boxes(center, np.tile([0.5, 0.4, 1.0], (4, 1)), np.full(4, np.pi / 2))
    assert space_of(rooms, 0).behind(found) == pytest.approx([1.0, 0.0, 0.05, 0.05])


@pytest.mark.parametrize("corners", [[[0, 0], [4, 0], [4, 3], [0, 3]],
                                     [[0, 0], [5, 0], [5, 3], [3, 3], [3, 5], [0, 5]]], ids=["square", "L"])
def test_points_of_backs_are_as_far_from_the_outline_as_shapely_says(corners: list[list[float]]) -> None:
    """Beside the middle of backs that look anywhere, in the room and up to half a metre beyond it."""
    rooms, rng = some_rooms(1), np.random.default_rng(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :len(corners)] = corners
    n, outline = 300, shapely.Polygon(corners).exterior
    found = Boxes(rng.uniform(-0.5, 5.5, (n, 3)), rng.uniform(0.1, 2, (n, 3)), rng.uniform(-4, 4, n))
    for aside in (0.0, rng.uniform(-1, 1, n)):
        ahead = np.column_stack([np.cos(found.yaw), np.sin(found.yaw)])
        left = np.column_stack([-ahead[:, 1], ahead[:, 0]])
        points = found.center[:, :2] - ahead * found.size[:, :1] / 2 + left * np.reshape(aside, (-1, 1))
        far = shapely.distance(shapely.points(points), outline)
        assert space_of(rooms, 0).behind(found, aside) == pytest.approx(far, abs=1e-9)


def floor(box: np.ndarray) -> shapely.Polygon:
    (x, y, _, depth, width), (c, s) = box[:5], (np.cos(box[2]), np.sin(box[2]))
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [depth / 2, width / 2]
    return shapely.Polygon(corners @ np.array([[c, s], [-s, c]]) + [x, y])


def test_what_lies_a_little_beyond_walls_is_cut_there_and_stays_as_it_is_elsewhere() -> None:
    """Boxes square to the walls of an L-shaped room, pushed up to 8 mm beyond one or two of its walls."""
    rooms, rng = some_rooms(1), np.random.default_rng(0)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :6] = [[0, 0], [5, 0], [5, 3], [3, 3], [3, 5], [0, 5]]
    space, room = space_of(rooms, 0), shapely.Polygon(rooms.polygon[0, :6])
    seen = 0
    for _ in range(300):
        depth, width, quarter = *rng.uniform(0.3, 1.2, 2), rng.integers(4)
        x, y = (depth, width) if quarter % 2 == 0 else (width, depth)
        out = rng.choice([0.0, 0.004, 0.008], 2)
        west, south = x / 2 - out[0], y / 2 - out[1]
        place = [(west, rng.uniform(1, 4)), (west, south), (rng.uniform(1, 4), south), (3 - x / 2 + out[0], 4.2),
                 (4.2, 3 - y / 2 + out[1]), (5 - x / 2 + out[0], south)][rng.integers(6)]
        box = np.array([*place, quarter * np.pi / 2, depth, width, 0, 0.8])
        cut = space.cut(box)
        assert floor(cut).difference(room).area < 1e-9
        assert floor(cut).symmetric_difference(floor(box).intersection(room)).area < 1e-7
        seen += floor(box).difference(room).area > 1e-4
    assert seen > 100
    askew = np.array([0.34, 2.5, 0.6, 0.5, 0.5, 0, 0.8])
    moved = space.cut(askew)
    assert floor(askew).bounds[0] < -0.005 < 0 <= floor(moved).bounds[0] + 1e-9
    assert moved[3:].tolist() == askew[3:].tolist() and moved[1] == askew[1]
    far = np.array([-0.3, 2.5, 0.0, 0.5, 0.5, 0, 0.8])
    assert space.cut(far).tolist() == far.tolist(), "what is wrong stays so"


@pytest.mark.parametrize("away", [0.5, 1.5, 2.5])
def test_what_seats_look_at_stands_at_the_wall_before_them_however_near(away: float) -> None:
    """Of a room of 4 by 3 m, from a seat 1.2 m along the wall with its lower left corner at zero."""
    rooms = some_rooms(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :4] = [[0, 0], [4, 0], [4, 3], [0, 3]]
    seats = Boxes(np.array([[1.2, away, 0.4]]), np.array([[0.8, 1.6, 0.8]]), np.array([-np.pi / 2]))
    found = candidates.across(np.zeros(3), np.array([0.4, 1.0, 0.5]), space_of(rooms, 0), seats)
    assert found.center[:, :2] == pytest.approx(np.array([[1.2, 0.2 + candidates.GAP]]))
    assert found.yaw == pytest.approx([np.pi / 2])
