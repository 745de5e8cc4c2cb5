"""After projection nothing collides, leaves its room or blocks a door, whatever came in."""

import numpy as np
import pytest
from rooms_for_tests import some_rooms

from apartgen.stages.layout.projection.costs import BROKEN, SOFT
from apartgen.stages.layout.projection.project import project
from apartgen.stages.layout.projection.space import outside, space_of
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE, belong_together, reach

KINDS = [
    "double_bed",
    "nightstand",
    "wardrobe",
    "chair",
    "desk",
    "plant",
    "bookshelf",
    "ceiling_lamp",
    "rug",
    "curtain",
]


def random_items(rng: np.random.Generator, n: int) -> list[Item]:
    return [
        Item(name := str(rng.choice(KINDS)), rng.uniform(-2, 2, 3), np.array(TABLE[name].size), rng.uniform(-3, 3))
        for _ in range(n)
    ]


def as_boxes(items: list[Item]) -> Boxes:
    return Boxes(
        np.array([o.center for o in items]), np.array([o.size for o in items]), np.array([o.yaw for o in items])
    )


@pytest.mark.parametrize("seed", range(12))
def test_what_costs_nothing_breaks_nothing(seed: int) -> None:
    space = space_of(some_rooms(1, seed), 0)
    done = project(random_items(np.random.default_rng(seed), 6), space)
    good = [item for item in done if item.cost < BROKEN]
    assert len(good) >= 4
    found = as_boxes(good)
    assert (outside(found, space) <= 0.01).all()
    depth = boxes.penetration(found)
    for i, a in enumerate(good):
        low, high = np.array(TABLE[a.category].min), np.array(TABLE[a.category].max)
        assert (low - 1e-9 <= a.size).all() and (a.size <= high + 1e-9).all()
        if a.category in SOFT:
            continue
        before_door = boxes.penetration(found.take([i]), space.zones)[0][~space.window]
        assert TABLE[a.category].place == "ceiling" or (before_door <= 0.01).all()
        for j, b in enumerate(good):
            if j != i and b.category not in SOFT and not belong_together(a.category, b.category):
                assert depth[i, j] <= 0.01, (a.category, b.category)


@pytest.mark.parametrize("seed", range(8))
def test_open_parts_stay_clear(seed: int) -> None:
    space = space_of(some_rooms(1, seed), 0)
    done = project(random_items(np.random.default_rng(100 + seed), 6), space)
    for a in done:
        far = float(reach(a.category, a.size))
        if a.cost >= BROKEN or far == 0:
            continue
        heading = np.array([np.cos(a.yaw), np.sin(a.yaw), 0])
        swept = Boxes(
            (a.center + heading * far / 2)[None], np.array([[a.size[0] + far, a.size[1], a.size[2]]]), np.array([a.yaw])
        )
        assert outside(swept, space)[0] <= 0.01
        for b in done:
            if (
                b is not a
                and b.category not in SOFT
                and b.cost < BROKEN
                and not belong_together(a.category, b.category)
            ):
                assert boxes.penetration(swept, as_boxes([b]))[0, 0] <= 0.01


def test_a_good_room_is_left_as_it_is() -> None:
    space = space_of(some_rooms(1, 3), 0)
    first = project(random_items(np.random.default_rng(5), 5), space)
    first = [item for item in first if item.cost < BROKEN]
    again = project(first, space)
    assert max(item.moved for item in again) < 0.05


def test_wall_furniture_has_its_back_at_a_wall() -> None:
    for seed in range(6):
        space = space_of(some_rooms(1, seed), 0)
        for item in project(
            [Item("wardrobe", np.array([0.3, 0.2, 1.0]), np.array([0.6, 1.4, 2.1]), 0.4 + seed)], space
        ):
            back = item.center[:2] - np.array([np.cos(item.yaw), np.sin(item.yaw)]) * item.size[0] / 2
            gaps = ((back - space.start) * space.normal).sum(1)
            assert np.abs(gaps).min() < 0.01


def test_things_stand_on_what_they_belong_on() -> None:
    space = space_of(some_rooms(1, 1), 0)
    desk = Item("desk", np.array([0.0, 1.0, 0.4]), np.array([0.65, 1.3, 0.75]), -1.5)
    monitor = Item("monitor", np.array([0.1, 1.1, 1.0]), np.array([0.2, 0.58, 0.45]), -1.5)
    done = project([desk, monitor], space)
    assert done[1].center[2] - done[1].size[2] / 2 == pytest.approx(done[0].center[2] + done[0].size[2] / 2)
    offset = np.abs(done[1].center[:2] - done[0].center[:2])
    assert (offset < 0.7).all()


def test_chairs_stay_at_their_table_and_the_table_with_its_chairs() -> None:
    """A table set with chairs in a free room stays where it is, its chairs about it, drawn under it a little."""
    space = space_of(some_rooms(1, 2), 0)
    table = Item("dining_table", np.array([0.0, 0.2, 0.38]), np.array([0.8, 1.2, 0.76]), 0.0)
    chairs = [
        Item("chair", np.array([x, y, 0.45]), np.array([0.5, 0.45, 0.9]), yaw)
        for x, y, yaw in ((0.55, -0.1, np.pi), (0.55, 0.5, np.pi), (-0.55, 0.2, 0.0))
    ]
    done = project([table, *chairs], space)
    assert all(item.cost < BROKEN for item in done)
    assert done[0].moved < 0.1
    for chair in done[1:]:
        gap = np.linalg.norm(chair.center[:2] - done[0].center[:2])
        toward = done[0].center[:2] - chair.center[:2]
        assert gap < 1.0 and toward @ [np.cos(chair.yaw), np.sin(chair.yaw)] > 0


def test_a_moved_table_takes_its_chair_along() -> None:
    """Where the table has to leave the doorway, the chair is at its new place."""
    space = space_of(some_rooms(1, 2), 0)
    door = space.zones.center[~space.window][0]
    table = Item("dining_table", np.array([door[0], door[1], 0.38]), np.array([0.8, 1.2, 0.76]), 0.0)
    chair = Item("chair", np.array([door[0] + 0.6, door[1], 0.45]), np.array([0.5, 0.45, 0.9]), np.pi)
    done = project([table, chair], space)
    assert all(item.cost < BROKEN for item in done) and done[0].moved > 0.2
    assert np.linalg.norm(done[1].center[:2] - done[0].center[:2]) < 1.0


def test_a_seat_leaves_drawers_free_to_push_it() -> None:
    """At a desk the chair stands before it, not in it; under a table without drawers it is drawn in."""
    space = space_of(some_rooms(1, 2), 0)
    for name in ("desk", "dining_table"):
        kind = TABLE[name]
        y = float(space.corners[:, 1].max()) - kind.size[0] / 2 - 0.01
        at = np.array([1.2, y if name == "desk" else 0.2, kind.size[2] / 2])
        table = Item(name, at, np.array(kind.size), -np.pi / 2)
        chair = Item("chair", table.center + [0.05, -0.5, 0], np.array([0.5, 0.45, 0.9]), np.pi / 2)
        done = project([table, chair], space)
        assert all(item.cost < BROKEN for item in done)
        depth = boxes.penetration(as_boxes(done))[0, 1]
        assert depth <= 1e-6 if name == "desk" else 0.1 < depth <= 0.28
