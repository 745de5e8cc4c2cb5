"""Compiled loops agree with what they stand for, written with the arrays of `apartgen.stages.space.boxes` and scipy."""

import numpy as np
import pytest
from numpy.typing import NDArray
from rooms_for_tests import some_rooms
from test_projection import random_items

from apartgen.stages.layout.projection import candidates
from apartgen.stages.layout.projection.costs import BROKEN, FARTHEST, SLACK, TURN, cost, grown
from apartgen.stages.layout.projection.paths import BESIDE, DOOR, RADII, SLIVER, UNREACHED, Paths
from apartgen.stages.layout.projection.space import Space, outside, space_of
from apartgen.stages.layout.projection.standing import Standing
from apartgen.stages.space import boxes, grid
from apartgen.stages.space.boxes import Boxes, penetration

Array = NDArray[np.float64]


def furnished(seed: int) -> tuple[Standing, Space]:
    """A room with things that nobody has put in order."""
    items = random_items(np.random.default_rng(seed), 9)
    room = Standing(items)
    for i, item in enumerate(items):
        item.center[2] = item.size[2] / 2
        room.put(i, item)
    return room, space_of(some_rooms(1, seed), 0)


def price(depth: Array, worth: float) -> Array:
    return np.where(depth > SLACK, worth + 5 * worth * depth, 0)


@pytest.mark.parametrize("seed", range(8))
def test_prices_are_those_of_depths(seed: int) -> None:
    """A place that breaks nothing costs its way; any other what it breaks, bodies alone where these are enough."""
    room, space = furnished(seed)
    i = int(np.flatnonzero(~room.soft)[0])
    item, others = room.items[i], room.others(i, room.items[i])
    found = candidates.everywhere(item.center, item.size, item.yaw, space, 0.4)
    wide, doors, windows = grown(item.category, found), *(space.zones.take(space.window == w) for w in (False, True))
    opens = wide.size[0, 0] > item.size[0] + 1e-6
    way = np.minimum(np.linalg.norm(found.center[:, :2] - item.center[:2], axis=1), FARTHEST)
    way += TURN * (1 - np.cos(found.yaw - item.yaw))
    far = np.maximum(0, boxes.distance(boxes.corners(found).reshape(-1, 2), floor(space)).reshape(-1, 4)).max(1)
    assert outside(found, space) == pytest.approx(far)
    walls = np.where(far > SLACK, 40 + 100 * far, 0)
    hard = ~others.soft
    bodies = price(penetration(found, doors).max(1), 30) + price(penetration(found, windows).max(1), 12)
    bodies += price(penetration(found, others.boxes.take(hard)) - others.tuck[hard], 20).sum(1)
    solid, swept = (each.take(hard & ~others.seated) for each in (others.boxes, others.grown))
    moving = swept.size[:, 0] > solid.size[:, 0] + 1e-6
    sweeps = price(penetration(found, swept.take(moving)), 14).sum(1)
    if opens:
        sweeps += price(outside(wide, space), 12) + price(penetration(wide, doors).max(1), 6)
        sweeps += price(penetration(wide, swept.take(moving)), 10.5).sum(1) + price(penetration(wide, solid), 14).sum(1)
    staged = way + walls
    for part in (bodies, sweeps):
        staged = np.where(staged < BROKEN, staged + part, staged)
    whole = staged if (staged < BROKEN).any() else way + walls + bodies + sweeps
    assert cost(found, item.category, item.center, item.yaw, others, space) == pytest.approx(whole)


def floor(space: Space) -> Boxes:
    """The floor of a rectangular room."""
    low, high = space.corners.min(0), space.corners.max(0)
    return Boxes(np.array([[*(low + high) / 2, 0.0]]), np.array([[*(high - low), 1.0]]), np.zeros(1))


def test_outside_a_room_with_a_corner_that_stands_out() -> None:
    """A box at home in either arm of an L; neither beyond the corner nor straddling it."""
    corners = np.array([[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]], float)
    rooms = some_rooms(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :6] = corners
    space = space_of(rooms, 0)
    at = np.array([[1, 3, 0.5], [3, 1, 0.5], [3, 3, 0.5], [1.9, 1.9, 0.5], [5, 1, 0.5]])
    found = outside(Boxes(at, np.tile([1.0, 1.0, 1.0], (5, 1)), np.zeros(5)), space)
    assert found[:2] == pytest.approx(0) and found[4] == pytest.approx(1.5)
    assert found[2] == pytest.approx(np.hypot(1.5, 1.5)) or found[2] == pytest.approx(1.5)
    assert 0.3 < found[3] < 0.5


@pytest.mark.parametrize("seed", range(8))
def test_what_is_cut_off_is_what_the_parts_of_the_floor_say(seed: int) -> None:
    room, space = furnished(seed)
    paths = Paths(room, space)
    total = UNREACHED * len(paths.unreached())
    for k, (radius, worth) in enumerate(RADII.items()):
        count = grid.near(room.boxes.take(sorted(paths.bodies)), paths.cells, radius)
        assert (paths.count[k] == count).all()
        labels, sizes, home = paths.parts(k)
        lost = 1 - sizes[home] / sizes.sum() if sizes[home] else 1.0
        total += worth * (lost > SLIVER) * lost + DOOR * worth * (labels[paths.doors[k]] != home).sum()
    assert paths.cut_off() == pytest.approx(total)
    assert paths.cut_off(total / 3) > total / 3 or total == 0
    assert BESIDE == next(iter(RADII))
