"""Outlines: taken apart without loss, filled when given, straight or askew."""

import numpy as np
import pytest
import shapely
from plan.flats import within
from shapely.affinity import rotate
from shapely.geometry import Polygon, box

from apartgen.schemas.plan import Envelope
from apartgen.stages.plan import PlanConfig, build, validate
from apartgen.stages.plan.blocks import blocks, entrance_sides, taken_apart
from apartgen.stages.plan.outline import draw
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
