"""One wall with a worktop before it: where a socket above it goes."""

from types import SimpleNamespace

import handmade as h
import numpy as np
import pytest

from apartgen.stages.populate import faces, walls

SOCKET = SimpleNamespace(size=(0.01, 0.08, 0.08))


def above(top, *more):
    """The sockets above a worktop from .5 to 2.5 m along a wall of 3 m, whose top is so high; `more` covers it, too."""
    face = walls.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), 3.0, [(0.5, 2.5, 0.0, top), *more])
    return list(walls._above_worktops([face], SOCKET, np.random.default_rng(0)))


@pytest.mark.parametrize(("top", "found"), [(0.79, 0), (0.81, 1), (0.9, 1), (0.99, 1), (1.01, 0), (2.0, 0)])
def test_a_socket_hangs_over_what_is_as_high_as_a_worktop(top, found):
    hung = above(top)
    assert len(hung) == found
    for one in hung:
        assert one.center[1:] == pytest.approx((0.0055, walls.COUNTER)) and 0.58 <= one.center[0] <= 2.42
        assert one.yaw == pytest.approx(np.pi / 2)


@pytest.mark.parametrize(("low", "found"), [(1.20, 1), (1.18, 0), (0.95, 0)])
def test_not_where_something_else_begins_just_above(low, found):
    """Three centimetres are left about it, whose upper edge is at 1.16 m."""
    assert len(above(0.9, (0.0, 3.0, low, 2.0))) == found


def test_it_goes_where_there_is_room():
    (one,) = above(0.9, (0.0, 2.2, 1.0, 2.0))
    assert one.center[0] - 0.04 - 0.03 >= 2.2


@pytest.mark.parametrize(("on", "hangs"), [("stand", False), ("floor", True)])
def test_nothing_hangs_behind_what_stands_on_something(on, hangs):
    """A television 20 cm before the south wall, from .5 to 1.2 m; what stands on the floor there is no hindrance."""
    stand = h.thing("tv_stand", 2.0, 0.25, np.pi / 2, size=(0.4, 1.6, 0.5), id="stand")
    screen = h.thing("tv", 2.0, 0.25, np.pi / 2, size=(0.1, 1.2, 0.7), bottom=0.5).model_copy(update={"on": on})
    home = h.home(stand, screen)
    south = faces.faces_of(home, home.rooms[0], home.objects)[0]
    assert south.free(2.0, 0.4, 0.8, 1.1) is hangs and south.free(2.0, 0.4, 1.4, 1.8)


@pytest.mark.parametrize("x, y, yaw, wanted", [
    (0.25, 2.3, 0.0, [(0, 1.8), (0, 2.8)]), (2.0, 0.25, np.pi / 2, [(1.5, 0), (2.5, 0)]),
    (3.75, 2.0, np.pi, [(4, 1.5), (4, 2.5)]), (1.0, 2.75, -np.pi / 2, [(0.5, 3), (1.5, 3)])])
def test_a_socket_is_beside_what_wants_one_on_the_wall_behind_it(x, y, yaw, wanted):
    """A television's stand 80 cm wide with its back to each wall of the living room: a hand from its end, at 30 cm."""
    home = h.home(h.thing("tv_stand", x, y, yaw, size=(0.5, 0.8, 0.5)))
    room = home.rooms[0]
    found = list(walls._sockets(room, faces.faces_of(home, room, home.objects), home.objects, [SOCKET],
                                np.random.default_rng(0)))
    assert len(found) == 1 and found[0].center[2] == walls.SOCKET
    assert min(np.hypot(*np.subtract(found[0].center[:2], at)) for at in wanted) < 0.01


def test_a_room_without_a_door_has_its_switch_beside_the_way_in_and_none_at_a_window():
    """The bedroom lies open to the living room between y 1.0 and 1.9; its window is named first."""
    entrance, door, window = h.openings()
    way = door.model_copy(update={"kind": "opening", "into": None})
    home = h.home().model_copy(update={"openings": [window, way, entrance]})
    bedroom = next(room for room in home.rooms if room.id == h.BEDROOM)
    found = list(walls._switches(home, bedroom, faces.faces_of(home, bedroom, []), [SOCKET]))
    assert len(found) == 1 and found[0].center[2] == walls.SWITCH
    assert found[0].center[0] == pytest.approx(4.1, abs=0.01)
    assert min(abs(found[0].center[1] - 1.0), abs(found[0].center[1] - 1.9)) < 0.4 and not 1 < found[0].center[1] < 1.9


@pytest.mark.parametrize("first, last, covers", [
    (-0.6, 0.0, False), (-0.6, 0.01, True), (2.99, 3.5, True), (3.0, 3.5, False)])
def test_what_ends_where_a_wall_begins_covers_none_of_it(first, last, covers):
    face = faces.Face(np.zeros(2), np.array([1.0, 0.0]), np.array([0.0, 1.0]), 3.0, [])
    corners = np.array([[first, 0.0], [last, 0.0], [last, 0.5], [first, 0.5]])
    assert list(faces._strip(face, corners, 0.0, 0.9)) == ([(first, last, 0.0, 0.9)] if covers else [])
