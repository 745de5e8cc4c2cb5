"""Volumes that boxes share, boxes in another size, and the outline of a flat, against shapely and by hand."""

import handmade as h
import numpy as np
import pytest
import shapely

from apartgen.schemas.plan import Walls
from apartgen.stages.space import anchors, boxes, polygons
from apartgen.stages.space.boxes import Boxes


@pytest.mark.parametrize("seed", range(8))
def test_shared_volumes_are_footprints_times_heights(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (Boxes(rng.uniform(0, 1.5, (6, 3)), rng.uniform(0.2, 2, (6, 3)), rng.uniform(-4, 4, 6)) for _ in range(2))
    plan = shapely.area(shapely.intersection(boxes.footprints(a)[:, None], boxes.footprints(b)[None]))
    tops = [box.center[:, 2] + box.size[:, 2] / 2 for box in (a, b)]
    lows = [box.center[:, 2] - box.size[:, 2] / 2 for box in (a, b)]
    tall = np.minimum(tops[0][:, None], tops[1]) - np.maximum(lows[0][:, None], lows[1])
    common = plan * np.maximum(tall, 0)
    union = a.size.prod(1)[:, None] + b.size.prod(1) - common
    assert (common > 0.05).sum() > 5 and (tall > a.size[:, None, 2] - 1e-9).any()
    assert boxes.iou(a, b) == pytest.approx(common / union, abs=1e-6)


FLOOR = shapely.box(0, 0, 4, 3)


def resized(x: float, y: float, yaw: float, size, new):
    """Middle of a box and of that box in another size."""
    box = Boxes(np.array([[x, y, 0.5]]), np.array([size], float), np.array([yaw]))
    return anchors.resized(box, new, FLOOR)


@pytest.mark.parametrize(("x", "y", "yaw", "middle"), [
    (0.5, 1.5, 0.0, (0.35, 1.5)),  # its back at the west wall
    (0.6, 1.5, 0.0, (0.45, 1.5)),  # 0.1 m before it
    (0.63, 1.5, 0.0, (0.63, 1.5)),  # 0.13 m before it, free
    (3.5, 1.5, 0.0, (3.65, 1.5)),  # its front at the east wall
    (2.0, 1.0, 0.0, (2.0, 0.8)),  # its right end at the south wall
    (2.0, 2.0, 0.0, (2.0, 2.2)),  # its left end at the north wall
    (2.0, 0.5, np.pi / 2, (2.0, 0.35)),  # looking north, its back at the south wall
    (1.0, 2.5, -np.pi / 2, (0.8, 2.65)),  # looking south in the north-west corner: back and right stay
])
def test_ends_at_walls_stay(x: float, y: float, yaw: float, middle: tuple[float, float]) -> None:
    """A box 1 m deep and 2 m wide becomes one of 0.7 m by 1.6 m, 0.2 m lower."""
    found = resized(x, y, yaw, (1.0, 2.0, 1.0), (0.7, 1.6, 0.8))
    assert found.center[0] == pytest.approx([*middle, 0.4])
    assert found.size[0].tolist() == [0.7, 1.6, 0.8] and found.yaw[0] == yaw


def test_between_two_walls_the_middle_stays() -> None:
    found = resized(2.0, 1.5, 0.0, (1.0, 3.0, 1.0), (1.0, 2.0, 1.0))
    assert found.center[0] == pytest.approx([2.0, 1.5, 0.5])


def test_the_outline_of_a_flat_by_hand() -> None:
    plan = h.plan().model_copy(update={"walls": Walls(inner=0.1, outer=0.3)})
    shell = polygons.shell(plan)
    assert shell.equals(shapely.box(-0.3, -0.3, 7.4, 3.3)) or shell.symmetric_difference(
        shapely.box(-0.3, -0.3, 7.4, 3.3)).area < 1e-9
    # Walls less the entrance, the inner door and both floors.
    doors = 0.9 * 0.3 + 0.9 * 0.1
    assert polygons.walls(plan).area == pytest.approx(7.7 * 3.6 - 21 - doors, abs=1e-6)
    assert polygons.free_floor(plan).area == pytest.approx(21 + 0.9 * 0.1)


def test_a_balcony_has_a_railing_and_no_wall() -> None:
    plan = h.plan().model_copy(update={"walls": Walls(inner=0.1, outer=0.3)})
    bedroom = next(room for room in plan.rooms if room.id == h.BEDROOM)
    balcony = bedroom.model_copy(update={"id": "balcony_1", "type": "balcony", "polygon": h.rectangle(7.4, 0, 1.5, 3)})
    shell = polygons.shell(plan.model_copy(update={"rooms": [*plan.rooms, balcony]}))
    assert shell.bounds == pytest.approx((-0.3, -0.3, 8.95, 3.3))
    assert shell.area == pytest.approx(7.7 * 3.6 + 1.55 * 3.1)


def test_boxes_meet_whatever_their_numbers_are() -> None:
    """Two cubes of 2 m whose middles are 1 m apart along x stand 1 m in one another: of whole numbers, in a batch."""
    whole = Boxes(np.array([[0, 0, 0], [1, 0, 0]]), np.full((2, 3), 2), np.zeros(2, int))
    some = Boxes(*(np.broadcast_to(part, (3, *part.shape)) for part in whole))
    assert boxes.penetration(whole)[0, 1] == 1
    assert boxes.penetration(some, whole).shape == (3, 2, 2) and (boxes.penetration(some, whole)[:, 0, 1] == 1).all()
