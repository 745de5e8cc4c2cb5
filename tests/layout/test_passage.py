"""Nothing cuts the floor of a room in two when a shift, a tuck or a narrower thing would join it."""

import numpy as np
import pytest
import shapely
from rooms_for_tests import some_rooms
from test_projection import random_items

from apartgen.stages.layout.projection import moves, passage
from apartgen.stages.layout.projection.costs import BROKEN
from apartgen.stages.layout.projection.paths import SLIVER, Paths
from apartgen.stages.layout.projection.project import project
from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.projection.standing import Item, Standing
from apartgen.stages.space import boxes, grid
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE

RADIUS = 0.16


def space(width: float, depth: float) -> Space:
    """An empty rectangular room with a door in the middle of its south wall."""
    start = np.array([[0, 0], [width, 0], [width, depth], [0, depth]], float)
    side = np.roll(start, -1, 0) - start
    length = np.linalg.norm(side, axis=1)
    along = side / length[:, None]
    normal = np.stack([-along[:, 1], along[:, 0]], -1)
    mid = start + side / 2 - normal * 0.15
    slabs = Boxes(
        np.column_stack([mid, np.full(4, 1.3)]),
        np.column_stack([np.full(4, 0.3), length, np.full(4, 2.6)]),
        np.arctan2(normal[:, 1], normal[:, 0]),
    )
    zone = Boxes(np.array([[width / 2, 0.4, 1.0]]), np.array([[0.8, 0.8, 2.0]]), np.array([np.pi / 2]))
    span = np.array([[[width / 2 - 0.4, 0], [width / 2 + 0.4, 0]]])
    return Space(start, start, along, normal, length, slabs, zone, np.array([False]), span, 2.6)


def cut_share(items: list[Item], room: Space) -> float:
    """Share of the free floor apart from its largest part, by shapely, for a walker of RADIUS."""
    floor = shapely.Polygon(room.corners).buffer(-RADIUS, join_style="mitre")
    low = [o for o in items if o.center[2] < 1.5 and o.center[2] + o.size[2] / 2 > 0.03]
    found = Boxes(np.array([o.center for o in low]), np.array([o.size for o in low]), np.array([o.yaw for o in low]))
    free = floor.difference(shapely.union_all(boxes.footprints(found)).buffer(RADIUS))
    parts = [part.area for part in shapely.get_parts(free)]
    return 1 - max(parts) / sum(parts) if parts else 0.0


def standing(items: list[Item]) -> Standing:
    room = Standing(items)
    for i, item in enumerate(items):
        room.put(i, item)
    return room


def test_a_bed_off_the_wall_by_a_hand_gives_way() -> None:
    """A bed across the room leaves gaps too narrow to pass on both sides; shifted, one is wide enough."""
    room = space(2.2, 4.0)
    bed = Item("double_bed", np.array([1.1, 2.4, 0.25]), np.array([2.0, 1.6, 0.5]), np.pi / 2)
    assert cut_share([bed], room) > 0.1
    there = standing([bed])
    passage.join(there, room)
    assert cut_share(there.items, room) < SLIVER
    assert np.linalg.norm(there.items[0].center[:2] - bed.center[:2]) < 0.6


def test_what_belongs_moves_along() -> None:
    """A nightstand stays at its bed, the lamp on the nightstand."""
    room = space(3.4, 4.0)
    bed = Item("double_bed", np.array([1.5, 2.98, 0.25]), np.array([2.0, 1.8, 0.5]), -np.pi / 2)
    stand = Item("nightstand", np.array([2.63, 3.78, 0.25]), np.array([0.4, 0.45, 0.5]), -np.pi / 2)
    lamp = Item("table_lamp", np.array([2.63, 3.78, 0.65]), np.array([0.2, 0.2, 0.3]), -np.pi / 2)
    there = standing([bed, stand, lamp])
    assert set(moves.group(0, there)) == {0, 1, 2}
    move = moves.moves(0, there, room)[0]
    gaps = move.boxes[1].center - move.boxes[0].center
    assert np.allclose(gaps, gaps[0]) and np.allclose(move.boxes[2].center - move.boxes[1].center, [0, 0, 0.4])


def test_a_room_in_one_piece_is_left_alone() -> None:
    room = space(4.0, 5.0)
    items = [Item("wardrobe", np.array([0.31, 3.0, 1.0]), np.array([0.6, 1.2, 2.0]), 0.0)]
    there = standing(items)
    passage.join(there, room)
    assert there.items == items


@pytest.mark.parametrize("seed", range(10))
def test_joining_breaks_nothing_and_cuts_off_no_more(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    from apartgen.stages.layout.projection.space import space_of

    room = space_of(some_rooms(1, seed), 0)
    items = random_items(np.random.default_rng(50 + seed), 8)
    with monkeypatch.context() as patch:
        patch.setattr(passage, "join", lambda *_: None)
        before = project(items, room)
    after = project(items, room)
    assert sum(o.cost >= BROKEN for o in after) <= sum(o.cost >= BROKEN for o in before)
    assert cut_share(after, room) <= cut_share(before, room) + 0.05
    for a in after:
        assert (a.size >= np.array(TABLE[a.category].min) - 1e-9).all()


def test_free_floor_agrees_with_the_raster() -> None:
    """Cells counted free are those of the shapely difference, to half a cell's width along borders."""
    room = space(3.0, 3.0)
    there = standing([Item("chest", np.array([1.5, 1.7, 0.5]), np.array([0.5, 1.0, 1.0]), 0.4)])
    paths = Paths(there, room)
    free = paths.inner[0] & (paths.count[0] == 0)
    floor = shapely.Polygon(room.corners).buffer(-RADIUS, join_style="mitre")
    exact = floor.difference(boxes.footprints(there.boxes)[0].buffer(RADIUS)).area
    assert free.sum() * grid.RESOLUTION**2 == pytest.approx(exact, abs=0.025 * (4 * 2.68 + 3.0))


def test_what_shuts_the_only_way_has_no_place() -> None:
    """In a corridor too narrow to pass furniture, what stands between its two doors goes, unless it is needed."""
    room = space(0.84, 6.0)
    room.zones = Boxes(
        np.array([[0.42, 0.4, 1.0], [0.42, 5.6, 1.0]]), np.full((2, 3), [0.8, 0.8, 2]), np.array([1, -1]) * np.pi / 2
    )
    room.window = np.array([False, False])
    chest = Item("chest", np.array([0.25, 3.0, 0.45]), np.array([0.5, 1.0, 0.9]), 0.0)
    lamp = Item("ceiling_lamp", np.array([0.5, 3.0, 2.4]), np.array([0.3, 0.3, 0.3]), 0.0)
    done = project([chest, lamp], room)
    assert done[0].cost >= BROKEN and done[1].cost < BROKEN
    assert project([chest, lamp], room, essential={0})[0].cost < BROKEN


def test_of_two_that_shut_the_way_together_one_goes() -> None:
    """Where two pairs of cabinets face each other in a corridor, taking any one away opens nothing."""
    room = space(1.2, 6.0)
    room.zones = Boxes(
        np.array([[0.6, 0.4, 1.0], [0.6, 5.6, 1.0]]), np.full((2, 3), [0.8, 0.8, 2]), np.array([1, -1]) * np.pi / 2
    )
    room.window = np.array([False, False])
    cabinets = [
        Item("sideboard", np.array([x, y, 0.45]), np.array([0.35, 0.9, 0.8]), yaw)
        for y in (2.5, 3.5) for x, yaw in ((0.18, 0.0), (1.02, np.pi))
    ]
    there = standing(cabinets)
    assert Paths(there, room).cut_off() > passage.SHUT
    assert passage.in_its_way(Paths(there, room), there, ()) in range(4)
    assert passage.in_its_way(Paths(there, room), there, range(4)) is None


def test_distances_from_the_walls_of_a_convex_room_are_those_of_any_room() -> None:
    room = space(4.0, 5.0)
    points = np.random.default_rng(3).uniform(-1, 6, (400, 2))
    square = shapely.Polygon(room.corners)
    expected = np.array([square.exterior.distance(shapely.Point(p)) for p in points])
    inside = np.array([square.contains(shapely.Point(p)) for p in points])
    away = np.where(inside, expected, 0.0)
    assert not room.reentrant.n and np.allclose(room.away(points), away)
    bodies = Boxes(np.column_stack([points, np.full(400, 0.5)]), np.full((400, 3), 1e-9), np.zeros(400))
    assert np.allclose(outside(bodies, room), np.where(inside, 0.0, expected), atol=1e-6)


def test_what_more_objects_cut_off_is_what_they_cut_off_once_they_stand_there() -> None:
    items = [Item("wardrobe", np.array([0.31, 3.0, 1.0]), np.array([0.6, 1.2, 2.0]), 0.0)]
    paths = Paths(standing(items), space(2.0, 5.0))
    wall = Boxes(np.array([[1.0, 2.0, 1.0]]), np.array([[0.3, 1.9, 2.0]]), np.array([np.pi / 2]))
    free, tried = paths.cut_off(), paths.cut_off(more={7: wall})
    assert tried > free and paths.cut_off() == free
    paths.add(7, wall)
    assert paths.cut_off() == tried
