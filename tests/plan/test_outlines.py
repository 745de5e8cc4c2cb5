"""Outlines: taken apart without loss, filled when given, straight or askew."""

import numpy as np
import pytest
import shapely
from plan.flats import within
from shapely.affinity import rotate, scale
from shapely.geometry import Polygon, box

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Envelope
from apartgen.stages.plan import PlanConfig, build, validate
from apartgen.stages.plan.blocks import blocks, entrance_sides, straightened, taken_apart
from apartgen.stages.plan.fitting import fitted
from apartgen.stages.plan.outline import draw
from apartgen.stages.plan.slicing import Tree
from apartgen.stages.plan.study import archetypes
from apartgen.stages.plan.turn import askew
from apartgen.stages.space import polygons

L_SHAPE = [(0.0, 0.0), (11.0, 0.0), (11.0, 5.0), (6.0, 5.0), (6.0, 9.0), (0.0, 9.0)]
SLANTED = [(0.0, 0.0), (9.5, 0.0), (8.0, 8.0), (0.0, 8.0)]


@pytest.mark.parametrize("seed", range(8))
def test_rectilinear_outlines_are_the_sum_of_their_blocks(seed: int) -> None:
    rng = np.random.default_rng(seed)
    corners = rng.integers(0, 10, (4, 2)) / 2
    polygon = shapely.union_all([box(0, 0, 4, 4), *(box(x, y, x + 4, y + 3) for x, y in corners)])
    polygon = Polygon(polygon.exterior)
    parts = [box(*row) for row in blocks(polygon)]
    assert sum(part.area for part in parts) == pytest.approx(polygon.area)
    assert shapely.union_all(parts).symmetric_difference(polygon).area < 1e-9


def test_slanting_walls_keep_the_area() -> None:
    for points in (SLANTED, [(0, 0), (9, 0), (9, 7), (0, 9)], [(y, x) for x, y in SLANTED]):
        found = taken_apart(Polygon(points), Envelope(), (1.0, 1.0)).blocks
        assert sum(box(*row).area for row in found) == pytest.approx(Polygon(points).area)


@pytest.mark.parametrize("shape", ["rectangle", "L", "notched"])
def test_drawn_outlines_have_the_area_asked_for(shape: str) -> None:
    for lane in np.random.default_rng(1).spawn(10):
        found = draw(Envelope(), 80.0, shape, 1.3, lane)
        assert sum(box(*row).area for row in found.blocks) == pytest.approx(80.0)
        assert (len(found.blocks) > 1) == (shape != "rectangle")


def test_entrance_is_opposite_the_only_facade() -> None:
    assert entrance_sides(Envelope(party_walls=["east", "west", "north"])) == ["north"]
    assert entrance_sides(Envelope(party_walls=["east"], entrance="east")) == ["east"]
    assert "east" not in entrance_sides(Envelope(party_walls=["east"]))


@pytest.mark.parametrize("degrees", [-40.0, -12.5, 0.0, 30.0, 44.0])
def test_askew_is_the_angle_turned_by(degrees: float) -> None:
    assert np.degrees(askew([rotate(Polygon(SLANTED), degrees)])) == pytest.approx(degrees, abs=1e-6)


@pytest.mark.parametrize("points, degrees", [(L_SHAPE, 0.0), (L_SHAPE, 25.0), (SLANTED, 0.0)])
def test_given_outlines_are_filled(points: list[tuple[float, float]], degrees: float) -> None:
    outline = rotate(Polygon(points), degrees, origin=(0, 0))
    ring = [(float(x), float(y)) for x, y in outline.exterior.coords[:-1]]
    plan = build(within(archetypes()["two_bedroom"], outline=ring), PlanConfig(), np.random.default_rng(3))
    assert validate(plan) == []
    filled = shapely.union_all(list(polygons.floors(plan).values())).buffer(0.051, join_style="mitre")
    assert outline.difference(filled).area < 0.01
    assert all(outline.buffer(0.002).covers(polygons.floor(room)) for room in plan.rooms)


def quadrilateral(seed: int) -> Polygon:
    """Four walls of which two slant."""
    rng = np.random.default_rng([11, seed])
    (w, h), (a, b) = rng.uniform((8.5, 7.0), (11.0, 9.5)), rng.uniform(0.4, 2.0, 2)
    return Polygon([(0, 0), (w, 0), (w - a, h), (0, h - b / 2)])


@pytest.mark.parametrize("seed", range(12))
def test_slanting_walls_are_straightened_without_losing_much(seed: int) -> None:
    for outline in (quadrilateral(seed), rotate(quadrilateral(seed), 0.02, origin=(0, 0)), Polygon(SLANTED)):
        found = straightened(outline)
        steps = np.abs(np.diff(shapely.get_coordinates(found.exterior), axis=0))
        assert steps.min(axis=1).max() < 1e-9 and found.is_valid
        assert found.area == pytest.approx(outline.area, rel=0.06)
        assert found.symmetric_difference(outline).area < 0.16 * outline.area
    assert straightened(Polygon(L_SHAPE)).equals(Polygon(L_SHAPE))


@pytest.mark.parametrize("seed", range(6))
def test_cuts_share_a_slanting_outline_as_asked(seed: int) -> None:
    """Three rooms, cut one after another: the first takes a share, the others share the rest."""
    rng = np.random.default_rng(seed)
    outline, wanted = quadrilateral(seed), rng.uniform(1, 3, 3)
    nodes = np.zeros((6, 3), np.int64)
    nodes[3], nodes[4], nodes[5, 0] = (0, 4, 1), (1, 2, 0), 3
    boxes = np.zeros((5, 5))
    boxes[:, 4] = [*wanted, wanted.sum(), wanted[1:].sum()]
    leaves = fitted(Tree(nodes, np.array([*wanted, 1.0])), boxes, outline)
    areas = [shapely.clip_by_rect(outline, *leaf).area for leaf in leaves]
    assert areas == pytest.approx(list(wanted / wanted.sum() * outline.area), rel=0.03)


SHAPES = {
    "L": [(0, 0), (12, 0), (12, 5), (7, 5), (7, 9), (0, 9)],
    "U": [(0, 0), (12, 0), (12, 9), (9, 9), (9, 6), (3.2, 6), (3.2, 9), (0, 9)],
    "T": [(3, 0), (9, 0), (9, 4), (12, 4), (12, 9), (0, 9), (0, 4), (3, 4)],
    "skewed": list(quadrilateral(1).exterior.coords)[:-1],
    "corner cut off": [(0, 0), (10, 0), (10, 5), (7, 8), (0, 8)],
    "stepped": [(0, 0), (5, 0), (5, -0.6), (9.4, -0.6), (9.4, 3), (10.2, 3), (10.2, 7), (7.4, 7), (7.4, 7.9),
                (3.8, 7.9), (3.8, 7.2), (0.6, 7.2), (0.6, 3.6), (0, 3.6)],
    "one step": [(0, 0), (10, 0), (10, 7.6), (3, 7.6), (3, 8), (0, 8)],
}


@pytest.mark.parametrize("shape, seed", list(zip(SHAPES, range(len(SHAPES)))))
def test_outlines_of_many_shapes_are_filled(shape: str, seed: int) -> None:
    program = archetypes()["two_bedroom"]
    outline = Polygon(SHAPES[shape])
    large = (1.06 * sum(room.area or 0 for room in program.rooms) / outline.area) ** 0.5
    outline = scale(outline, large, large, origin=(0, 0))
    ring = [(round(x, 3), round(y, 3)) for x, y in outline.exterior.coords[:-1]]
    plan = build(within(program, outline=ring), PlanConfig(processes=1), np.random.default_rng(seed))
    assert validate(plan) == []
    filled = shapely.union_all(list(polygons.floors(plan).values())).buffer(0.051, join_style="mitre")
    assert outline.difference(filled).area < 0.01


@pytest.mark.parametrize("name, ring", [
    ("one_bedroom", [(0, 0), (5.4, 0), (8.1, 2.2), (8.1, 7.2), (0, 7.2)]),
    ("two_bedroom", [(0, 0), (10.9, 0), (10.9, 4.1), (7, 6.8), (0, 6.8)]),
])  # fmt: skip
def test_a_corner_cut_off_far_aslant_leaves_room_for_a_usual_flat(name: str, ring: list[tuple[float, float]]) -> None:
    plan = build(within(archetypes()[name], outline=ring), PlanConfig(processes=1), np.random.default_rng(1))
    assert validate(plan) == []


def test_rooms_take_shares_of_an_outline_that_is_larger_than_they_are() -> None:
    program, outline = archetypes()["two_bedroom"], Polygon(SHAPES["L"])
    plan = build(within(program, outline=SHAPES["L"]), PlanConfig(processes=1), np.random.default_rng(0))
    assert plan.relaxed == ["the outline has 88 m² where the rooms asked for take 74 m²: areas are shares of it"]
    asked = {room.id: room.area or 0.0 for room in program.rooms}
    factor = sum(floor.area for floor in polygons.floors(plan).values()) / sum(asked.values())
    assert 1.1 < factor < outline.area / sum(asked.values())
    for id, floor in polygons.floors(plan).items():
        assert floor.area == pytest.approx(factor * asked[id], rel=0.5 if id == "hallway_1" else 0.2)


def test_a_long_flat_between_two_neighbours_is_planned_or_refused() -> None:
    slab = {"outline": [(0, 0), (6, 0), (6, 15), (0, 15)], "party_walls": ["east", "west"]}
    plan = build(within(archetypes()["one_bedroom_open"], **slab), PlanConfig(), np.random.default_rng(0))
    assert all(y < 0 or y > 15 for o in plan.openings if o.kind == "window" for _, y in o.segment)
    deep = {"outline": [(0, 0), (4, 0), (4, 36), (0, 36)], "party_walls": ["east", "west", "north"]}
    many = within(archetypes()["four_bedroom"], **deep)
    with pytest.raises(Unmet, match="outside wall for their windows, but the outline has 4.0 m"):
        build(many, PlanConfig(), np.random.default_rng(0))
