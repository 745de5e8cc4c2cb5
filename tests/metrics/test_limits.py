"""Rules of figures at their limits, on either side of them."""

import handmade as h
import numpy as np
import pytest
from shapely.geometry import Polygon

from apartgen.schemas.metrics import Value
from apartgen.stages.metrics import outside, relations
from apartgen.stages.metrics._table import averaged


def is_out(off, depth):
    """R_out of a sideboard 0.5 m wide in the 4 m living room, its front `off` metres beyond the east wall's face."""
    value, *_ = outside.measure(h.home(h.thing("sideboard", 4.0 + off - depth / 2, 2.5, size=(depth, 0.5, 0.8))))
    assert (value.name, value.version, value.of) == ("R_out", "ours", "apartment")
    return value.value == 1


@pytest.mark.parametrize(("off", "depth", "out"), [
    (0.009, 3.0, False), (0.011, 3.0, True),  # a centimetre, of which neither is 1 % of the footprint
    (0.0038, 0.4, False), (0.0042, 0.4, True),  # 1 % of the footprint, of which neither is a centimetre
    (0.0, 2.0, False), (-0.5, 2.0, False), (0.5, 2.0, True),
])
def test_a_centimetre_or_one_per_cent_is_outside(off, depth, out):
    assert is_out(off, depth) is out


def test_outside_is_outside_of_its_own_room():
    """What stands in the next room's floor, wall and all."""
    through = h.thing("sideboard", 5.0, 2.5, size=(0.4, 0.5, 0.8), room=h.LIVING)
    assert [v.value for v in outside.measure(h.home(through)) if v.of == "apartment"] == [1, 1]
    at_home = through.model_copy(update={"room": h.BEDROOM})
    assert [v.value for v in outside.measure(h.home(at_home)) if v.of == "apartment"] == [0, 0]


def aligned(floor, yaw):
    (found,) = relations.of_room(floor, [h.thing("sofa", 2.0, 1.0, yaw)])["yaw_aligned"]
    return bool(found)


@pytest.mark.parametrize("way", [1, -1])
def test_yaws_are_aligned_to_a_quarter_turn(way):
    """In a room with walls at 0° and 60°, whichever way round its corners are given."""
    corners = [(0, 0), (6, 0), (6 + 2 / np.sqrt(3), 2), (2 / np.sqrt(3), 2)][::way]
    floor = Polygon(corners)
    straight = {0, 60, 90, 150, 180, 240, 270, 330}
    for degrees in range(-360, 361, 30):
        assert aligned(floor, np.deg2rad(degrees)) is (degrees % 360 in straight), degrees
    for degrees in straight:
        assert aligned(floor, np.deg2rad(degrees + 4.9)) and aligned(floor, np.deg2rad(degrees - 4.9))
        assert not aligned(floor, np.deg2rad(degrees + 5.1)) and not aligned(floor, np.deg2rad(degrees - 5.1))


def test_a_back_is_at_a_wall_that_it_is_parallel_and_near_to():
    floor = Polygon([(0, 0), (4, 0), (4, 3), (0, 3)])

    def at_wall(x, y, yaw):
        (found,) = relations.of_room(floor, [h.thing("bookshelf", x, y, yaw, size=(0.8, 2.0, 0.8))])["back_to_wall"]
        return bool(found)

    assert at_wall(0.4, 1.5, 0.0) and at_wall(0.51, 1.5, 0.0) and not at_wall(0.53, 1.5, 0.0)
    assert at_wall(0.42, 1.5, np.deg2rad(4)) and not at_wall(0.42, 1.5, np.deg2rad(6))
    assert not at_wall(0.4, 1.5, np.pi), "its front is at the wall"
    assert not at_wall(1.0, 0.4, 0.0), "its side is"
    assert at_wall(2.0, 0.4, np.pi / 2) and at_wall(2.0, 2.6, -np.pi / 2) and at_wall(3.6, 1.5, np.pi)


@pytest.mark.parametrize(("apart", "together"), [(0.0, True), (0.34, True), (0.36, False), (0.6, False)])
def test_companions_stand_a_third_of_a_metre_apart_at_most(apart, together):
    """A nightstand beside a bed, a chair before a table."""
    floor = Polygon([(0, 0), (6, 0), (6, 6), (0, 6)])
    bed = h.thing("double_bed", 3.0, 3.0, size=(2.0, 1.6, 0.5))
    stand = h.thing("nightstand", 3.0, 3.0 + 0.8 + apart + 0.2, size=(0.4, 0.4, 0.5))
    assert relations.of_room(floor, [bed, stand])["nightstand_at_bed"] == [together]
    table = h.thing("dining_table", 3.0, 3.0, size=(0.8, 1.6, 0.74))
    chair = h.thing("chair", 3.0 - 0.4 - apart - 0.25, 3.0, size=(0.5, 0.45, 0.9))
    assert relations.of_room(floor, [table, chair])["seat_at_table"] == [together]


def test_a_mean_over_one_room_has_no_interval():
    figure = Value(name="figure", value=None)
    assert averaged(figure, []) == figure
    assert averaged(figure, [(0.25, 3.0)]) == figure.model_copy(update={"value": 0.25})
    two = averaged(figure, [(0.25, 3.0), (0.75, 1.0)])
    assert two.value == 0.375 and two.low is not None and two.high is not None and two.low <= 0.375 <= two.high
