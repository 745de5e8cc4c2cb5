"""Shapes a plan implies, against a flat small enough to reckon by hand."""

import numpy as np
import pytest
from plan.flats import drawn, flat

from apartgen.schemas.plan import AskedRoom, Opening, Plan, Program
from apartgen.stages.space import polygons

DOOR = Opening(
    id="door_1", kind="door", rooms=["hallway_1", "bedroom_1"], segment=((2.05, 1.0), (2.05, 1.9)),
    sill=0, head=2.1, hinge=0, into="bedroom_1",
)  # fmt: skip
ENTRANCE = Opening(
    id="entrance_1", kind="entrance", rooms=["hallway_1"], segment=((0.5, -0.15), (1.4, -0.15)),
    sill=0, head=2.1, hinge=1, into="hallway_1",
)  # fmt: skip
PLAN = Plan(
    program=Program(rooms=[AskedRoom(id="hallway_1", type="hallway"), AskedRoom(id="bedroom_1", type="bedroom")]),
    rooms=[drawn("hallway_1", 0, 0, 2, 3), drawn("bedroom_1", 2.1, 0, 5, 3)],
    openings=[DOOR, ENTRANCE],
)


def test_thresholds_reach_from_floor_to_floor() -> None:
    assert polygons.threshold(DOOR, PLAN).bounds == pytest.approx((1.99, 1.0, 2.11, 1.9))
    assert polygons.threshold(ENTRANCE, PLAN).bounds == pytest.approx((0.5, -0.3, 1.4, 0.01))


def test_leaves_turn_about_the_wall_face() -> None:
    turn = polygons.hinge(DOOR, PLAN)
    assert turn is not None
    assert turn.pivot == pytest.approx([2.1, 1.0])
    assert turn.shut == pytest.approx([0, 1]) and turn.opened == pytest.approx([1, 0])
    assert polygons.leaf(DOOR, PLAN).bounds == pytest.approx((2.1, 1.0, 3.0, 1.04))
    assert polygons.leaf(DOOR, PLAN, 0.0).bounds == pytest.approx((2.06, 1.0, 2.1, 1.9))
    other = polygons.hinge(ENTRANCE, PLAN)
    assert other is not None and other.pivot == pytest.approx([1.4, 0.0]) and other.opened == pytest.approx([0, 1])


@pytest.mark.parametrize("opening", [DOOR, ENTRANCE])
def test_the_sweep_holds_every_position_of_the_leaf(opening: Opening) -> None:
    sweep = polygons.swing(opening, PLAN)
    assert sweep.area == pytest.approx(np.pi / 4 * (0.81 + polygons.LEAF**2), rel=0.01)
    for turned in np.linspace(0, np.pi / 2, 7):
        into = polygons.leaf(opening, PLAN, turned).intersection(polygons.floor(PLAN.rooms[opening is DOOR]))
        assert into.difference(sweep.buffer(1e-9)).area < 1e-9


def test_walls_and_free_floor() -> None:
    shell = 5.6 * 3.6
    assert polygons.shell(PLAN).area == pytest.approx(shell)
    assert polygons.walls(PLAN).area == pytest.approx(shell - 6 - 8.7 - 0.9 * 0.1 - 0.9 * 0.3)
    free = polygons.free_floor(PLAN)
    assert free.geom_type == "Polygon" and free.area == pytest.approx(6 + 8.7 + 0.09)


def test_clearance_is_floor_on_both_sides() -> None:
    zone = polygons.clearance(DOOR, PLAN, 0.6)
    assert zone.contains(polygons.swing(DOOR, PLAN).buffer(-1e-6))
    assert zone.bounds == pytest.approx((1.4, 1.0, 3.0028, 1.9028), abs=1e-3)
    assert polygons.clearance(DOOR.model_copy(update={"kind": "window"}), PLAN).is_empty


def test_one_floor_in_every_flat() -> None:
    for name in ("studio", "two_bedroom_ensuite"):
        assert polygons.free_floor(flat(name)).geom_type == "Polygon"
