"""Plans drawn by hand enter with polygons only."""

import pytest
from plan.flats import cottage, drawn

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import Program
from apartgen.stages.plan import PlanConfig, from_polygons, validate
from apartgen.stages.plan.turn import turned
from apartgen.stages.space import polygons


@pytest.mark.parametrize("gap", [0.0, 0.05, 0.1, 0.2])
@pytest.mark.parametrize("angle", [0.0, 0.4])
def test_rooms_get_walls_doors_and_windows(gap: float, angle: float) -> None:
    rooms = [r.model_copy(update={"polygon": turned(r.polygon, angle)}) for r in cottage(gap)]
    plan = from_polygons(rooms, PlanConfig())
    assert validate(plan) == []
    assert {frozenset(link) for link in plan.program.links} == {
        frozenset(("hallway_1", room.id)) for room in rooms if room.id != "hallway_1"
    }
    if gap >= 0.1:
        for room, given in zip(plan.rooms, rooms, strict=True):
            assert polygons.floor(room).symmetric_difference(polygons.floor(given)).area < 0.01


def test_a_given_programme_is_kept() -> None:
    own = Program(
        rooms=[{"id": r.id, "type": r.type} for r in cottage()],
        links=[("hallway_1", "bedroom_1"), ("hallway_1", "bedroom_2"), ("hallway_1", "bathroom_1"),
               ("hallway_1", "living_room_1")],
        open_links=[("living_room_1", "kitchen_1")],
    )  # fmt: skip
    plan = from_polygons(cottage(), PlanConfig(), own)
    assert plan.program == own
    assert [o.rooms for o in plan.openings if o.kind == "opening"] == [["living_room_1", "kitchen_1"]]


def test_a_room_without_outside_wall_is_told() -> None:
    ring = [drawn("living_room_1", 0, 0, 12, 4), drawn("kitchen_1", 0, 8, 12, 12), drawn("bedroom_1", 0, 4, 4, 8),
            drawn("bedroom_2", 8, 4, 12, 8), drawn("study_1", 4, 4, 8, 8)]  # fmt: skip
    plan = from_polygons(ring, PlanConfig())
    assert plan.relaxed == ["study_1 has no outside wall for a window"]


def test_no_window_looks_into_a_slit_between_rooms() -> None:
    rooms = [drawn("hallway_1", 0, 0, 12, 2), drawn("living_room_1", 0, 2, 5, 8), drawn("bedroom_1", 7, 2, 12, 8)]
    plan = from_polygons(rooms, PlanConfig())
    assert validate(plan) == [] and plan.relaxed == []
    glass = [x for o in plan.openings if o.kind == "window" and o.rooms != ["hallway_1"] for x, _ in o.segment]
    assert glass and not any(4.9 < x < 7.1 for x in glass)


def test_overlaps_and_islands_are_errors() -> None:
    with pytest.raises(BadInput, match="overlap"):
        from_polygons([drawn("living_room_1", 0, 0, 5, 5), drawn("bedroom_1", 4, 0, 8, 4)], PlanConfig())
    with pytest.raises(Unmet, match="bedroom_1"):
        from_polygons([drawn("living_room_1", 0, 0, 5, 5), drawn("bedroom_1", 9, 0, 13, 4)], PlanConfig())
    with pytest.raises(BadInput, match="surrounds|crosses"):
        bow = drawn("living_room_1", 0, 0, 5, 5)
        from_polygons([bow.model_copy(update={"polygon": [(0, 0), (5, 5), (5, 0), (0, 5)]})], PlanConfig())
