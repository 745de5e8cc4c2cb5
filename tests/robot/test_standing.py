"""Where a robot stands to use an object, against rectangles drawn by hand and by shapely."""

import handmade as h
import numpy as np
import pytest
import shapely
from shapely import affinity
from shapely.geometry import box as rectangle

from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, sweeps
from apartgen.stages.space.grid import Grid

CELLS = Grid((-3.0, -3.0), (240, 240), 0.025)


def found(o, far, radius, parts=None):
    """The cells from which it is used, over the whole raster."""
    mask = np.zeros(CELLS.shape, bool)
    window, zone = reach.standing(o, CELLS, far, radius, parts)
    mask[window] = zone
    return mask


def covered(shape):
    """Cells whose middles a shape covers; and those within a millimetre of its rim, where either may be."""
    x, y = np.meshgrid(CELLS.x, CELLS.y)
    points = shapely.points(x.ravel(), y.ravel())
    return (shapely.covers(shape, points).reshape(x.shape),
            (shapely.distance(shape.exterior, points) < 1e-3).reshape(x.shape))


def test_before_a_chest_by_hand():
    # Its face is at x 0.25; the robot of 0.25 m stands up to 0.8 m before it, 0.75 m to either side of its middle.
    mask = found(h.chest(0, 0), 0.8, 0.25)
    rows, columns = np.nonzero(mask)
    x, y = CELLS.x[columns], CELLS.y[rows]
    assert x.min() == pytest.approx(0.25, abs=0.03) and x.max() == pytest.approx(1.05, abs=0.03)
    assert y.min() == pytest.approx(-0.75, abs=0.03) and y.max() == pytest.approx(0.75, abs=0.03)
    assert mask.sum() * CELLS.cell == pytest.approx(0.8 * 1.5, rel=0.05)


@pytest.mark.parametrize("seed", range(12))
def test_the_zone_is_a_rectangle_before_the_face(seed):
    rng = np.random.default_rng(seed)
    size = tuple(rng.uniform(0.3, 1.5, 3).tolist())
    x, y = rng.uniform(-0.8, 0.8, 2).tolist()
    yaw, far, radius = float(rng.uniform(-4, 4)), float(rng.uniform(0.3, 1.0)), float(rng.uniform(0.1, 0.4))
    o = h.thing("sideboard", x, y, yaw, size=size)
    half = size[1] / 2 + radius
    zone = affinity.translate(
        affinity.rotate(rectangle(size[0] / 2, -half, size[0] / 2 + far, half), yaw, (0, 0), True), x, y)
    inside, rim = covered(zone)
    assert np.array_equal(found(o, far, radius) | rim, inside | rim)


@pytest.mark.parametrize("travel", [0.2, 0.5])
def test_before_an_open_drawer_there_is_as_much_again(travel):
    o = h.chest(0.3, -0.2, np.pi / 2, travel=travel)
    parts, _ = sweeps.opened([o])
    # It looks to +y, its face at y 0.05; beside the drawer there is room for the robot's width.
    zone = rectangle(0.3 - 0.5 - 0.5, 0.05, 0.3 + 0.5 + 0.5, 0.05 + travel + 0.8)
    inside, rim = covered(zone)
    assert np.array_equal(found(o, 0.8, 0.25, parts) | rim, inside | rim)
    # Parts that come out no further than the face change nothing ahead.
    inner = boxes.of([h.thing("chest", 0.3, -0.2, np.pi / 2, size=(0.3, 0.5, 0.3))])
    inside, rim = covered(rectangle(0.3 - 1.0, 0.05, 0.3 + 1.0, 0.85))
    assert np.array_equal(found(o, 0.8, 0.25, inner) | rim, inside | rim)


@pytest.mark.parametrize("yaw", [0.0, np.pi / 2, np.pi, -np.pi / 2])
def test_a_chest_that_looks_at_the_wall_is_not_used(yaw):
    """0.85 m of floor before the face are enough, and not 0.15 m."""
    at = {0.0: (3.65, 2.4), np.pi / 2: (2.0, 2.65), np.pi: (0.35, 2.4), -np.pi / 2: (2.0, 0.35)}[yaw]
    turned = h.chest(*at, yaw, travel=0.1, id="turned")
    facing = h.chest(*at, yaw + np.pi, travel=0.1, id="facing")
    assert reach.survey(reach.space(h.plan()), [turned]).closed == ["turned"]
    assert reach.survey(reach.space(h.plan()), [facing]).missed == []


@pytest.mark.parametrize(("far", "used"), [(0.75, False), (0.85, True)])
def test_how_far_the_robot_reaches_decides(far, used):
    """A table before a chest keeps the robot's middle 0.8 m from its face."""
    chest = h.chest(2.0, 2.75, -np.pi / 2, travel=0.1, id="chest")
    table = h.thing("coffee_table", 2.0, 2.225, np.pi / 2, size=(0.55, 2.0, 0.4))
    assert (reach.survey(reach.space(h.plan()), [chest, table], far).closed == []) is used
