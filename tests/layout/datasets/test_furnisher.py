"""Furnished rooms hold to what people need: checked with the shared geometry, over many random rooms."""

import numpy as np
import pytest
from shapely.geometry import Point, Polygon

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.layout import Box, Layout
from apartgen.stages.layout.datasets import furnisher, single_rooms
from apartgen.stages.layout.datasets._furnish import sizes
from apartgen.stages.layout.datasets._furnish.rooms import ESSENTIAL
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, polygons, sweeps
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import TABLE, belong_together

SEEDS = range(3)


def furnished(type: str, seed: int, count: int | None = None) -> Layout:
    rng = np.random.default_rng([seed, ROOM_TYPES.index(type)])
    plan = single_rooms.draw(rng, type)  # type: ignore[arg-type]
    if count is not None:
        plan.program.counts[plan.rooms[0].id] = count
    return Layout(**dict(plan), objects=furnisher.furnish(plan, rng))


@pytest.fixture(scope="module")
def homes() -> list[Layout]:
    return [furnished(type, seed) for type in ROOM_TYPES for seed in SEEDS]


def apart(objects: list[Box], depth: Array) -> list[tuple[str, str]]:
    """Pairs deeper in one another than the tolerance, but for those that belong together."""
    pairs = np.argwhere(np.triu(depth > boxes.TOLERANCE))
    named = [(objects[i].category, objects[j].category) for i, j in pairs]
    return [pair for pair in named if not belong_together(*pair)]


def test_nothing_collides_closed_or_open(homes: list[Layout]) -> None:
    for home in homes:
        assert apart(home.objects, boxes.penetration(boxes.of(home.objects))) == []
        swept = boxes.penetration(sweeps.extended(home.objects), boxes.of(home.objects))
        np.fill_diagonal(swept, -1)
        assert apart(home.objects, np.maximum(swept, swept.T)) == []


def test_all_stands_and_opens_inside_the_room(homes: list[Layout]) -> None:
    for home in homes:
        floor = Polygon(home.rooms[0].polygon).buffer(0.003)
        for box in (boxes.of(home.objects), sweeps.extended(home.objects)):
            assert all(floor.covers(part) for part in boxes.footprints(box))
            assert (box.center[:, 2] - box.size[:, 2] / 2 > -1e-6).all()
            assert (box.center[:, 2] + box.size[:, 2] / 2 < home.height + 1e-6).all()


def test_doorways_and_door_swings_stay_free(homes: list[Layout]) -> None:
    for home in homes:
        low = [o for o in home.objects if TABLE[o.category].place != "flat" and o.center[2] - o.size[2] / 2 < 2.0]
        opened = sweeps.extended(low)
        for opening in home.openings:
            if opening.kind == "window":
                continue
            normal, near = polygons.face(opening, home, home.rooms[0].id)
            ends = np.asarray(opening.segment) + near * normal
            before = Polygon([*ends, *(ends + 0.55 * normal)[::-1]]).buffer(-0.006)
            swing = polygons.swing(opening, home).buffer(-0.006)
            assert not any(part.intersects(before) for part in boxes.footprints(boxes.of(low)))
            assert not any(part.intersects(swing) for part in boxes.footprints(opened))


def test_windows_keep_their_light(homes: list[Layout]) -> None:
    for home in homes:
        tall = [o for o in home.objects if o.category != "curtain"]
        for opening in home.openings:
            if opening.kind != "window":
                continue
            normal, near = polygons.face(opening, home, home.rooms[0].id)
            ends = np.asarray(opening.segment) + near * normal
            pane = Polygon([*ends, *(ends + 0.2 * normal)[::-1]]).buffer(-0.006)
            over = [o for o in tall if o.center[2] + o.size[2] / 2 > opening.sill + 0.01
                    and o.center[2] - o.size[2] / 2 < opening.head]
            assert not any(part.intersects(pane) for part in boxes.footprints(boxes.of(over)))


def without_leaves(home: Layout) -> Layout:
    """The home with its doors off their hinges: the furnisher keeps swings clear, not ways round open doors."""
    return home.model_copy(update={"openings": [o.model_copy(update={"into": None}) for o in home.openings]})


def test_a_robot_reaches_every_door_and_every_moving_part(homes: list[Layout]) -> None:
    for home in homes:
        world = reach.space(without_leaves(home))
        empty, full = reach.survey(world, []), reach.survey(world, home.objects)
        assert set(full.doors) <= set(empty.doors)
        assert len(full.closed) + len(full.opened) <= 0.02 * len(home.objects)


def test_furniture_cuts_off_a_large_part_of_few_rooms(homes: list[Layout]) -> None:
    cut = [home for home in homes if reach.survey(reach.space(without_leaves(home)), home.objects).rooms]
    bare = [home for home in homes if reach.survey(reach.space(without_leaves(home)), []).rooms]
    assert len(cut) - len(bare) <= 0.06 * len(homes)


def test_hanging_things_have_a_wall_and_small_things_a_support(homes: list[Layout]) -> None:
    for home in homes:
        edge = Polygon(home.rooms[0].polygon).exterior
        for o in home.objects:
            box = boxes.of([o])
            back = box.center[0, :2] - boxes.axes(box)[0, 0] * o.size[0] / 2
            bottom = o.center[2] - o.size[2] / 2
            match TABLE[o.category].place:
                case "wall":
                    assert edge.distance(Point(back)) < 0.06
                case "top":
                    below = [p for p in home.objects if abs(p.center[2] + p.size[2] / 2 - bottom) < 2e-3]
                    assert any(boxes.distance(box.center[:, :2], boxes.of([p]))[0, 0] < 0 for p in below)
                case "ceiling":
                    assert o.center[2] + o.size[2] / 2 == pytest.approx(home.height, abs=1e-3)
                case _:
                    assert bottom == pytest.approx(0.0, abs=1e-3)


def test_sizes_stay_within_their_category(homes: list[Layout]) -> None:
    for home in homes:
        for o in home.objects:
            kind = TABLE[o.category]
            assert (np.array(o.size) >= np.array(kind.min) - 1e-3).all(), o
            assert (np.array(o.size) <= np.array(kind.max) + 1e-3).all(), o


def test_same_seed_same_furniture_another_seed_another() -> None:
    for type in ("bedroom", "kitchen", "living_room"):
        assert furnished(type, 5).objects == furnished(type, 5).objects
        assert furnished(type, 5).objects != furnished(type, 6).objects


def test_rooms_have_what_they_cannot_do_without() -> None:
    lacking = 0
    for type in ("bedroom", "bathroom", "kitchen", "living_room"):
        for seed in range(8):
            have = {o.category for o in furnished(type, 100 + seed).objects}
            lacking += not all(have & names for names in ESSENTIAL[type])  # type: ignore[index]
    assert lacking <= 3


def test_nightstands_stand_by_beds_and_chairs_face_tables() -> None:
    beside, facing = [], []
    for seed in range(12):
        for type in ("bedroom", "dining_room"):
            objects = furnished(type, 200 + seed).objects
            beds = [o for o in objects if o.category in ("double_bed", "single_bed")]
            tables = [o for o in objects if o.category in ("dining_table", "round_table")]
            for o in objects:
                if o.category == "nightstand" and beds:
                    beside.append(boxes.gap(boxes.of([o]), boxes.of(beds)).min())
                if o.category == "chair" and tables:
                    offset = np.array(tables[0].center[:2]) - o.center[:2]
                    if boxes.gap(boxes.of([o]), boxes.of(tables)).min() < 0.1:
                        ahead = boxes.axes(boxes.of([o]))[0, 0]
                        facing.append(ahead @ offset / np.hypot(*offset))
    assert max(beside) < 0.08 and len(beside) >= 6
    assert min(facing) > 0.3 and len(facing) >= 12


def test_sizes_as_sold_are_within_range() -> None:
    for name, row in sizes.steps().items():
        for side, k in (("depth", 0), ("width", 1), ("height", 2)):
            for value in row.get(side, ()):
                assert TABLE[name].min[k] <= value <= TABLE[name].max[k], (name, side, value)
