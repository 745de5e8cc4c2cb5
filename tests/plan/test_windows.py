"""Windows light what is lit, corridors where they end, and stand evenly on broad walls."""

import numpy as np
import pytest
from plan.flats import drawn

from apartgen.schemas.plan import Plan, Room, Side
from apartgen.stages.plan import PlanConfig, from_polygons, validate
from apartgen.stages.space import polygons


def panes(plan: Plan, room: str) -> list[np.ndarray]:
    """Ends of a room's windows, (2, 2) each, m."""
    return [np.array(o.segment) for o in plan.openings if o.kind == "window" and o.rooms == [room]]


def terrace(long: float) -> list[Room]:
    """A corridor between a living room to the south and a kitchen and a bathroom to the north."""
    return [
        drawn("hallway_1", 0, 4, long, 5.4),
        drawn("living_room_1", 0, 0, long, 4),
        drawn("kitchen_1", 0, 5.4, long - 3, 9),
        drawn("bathroom_1", long - 3, 5.4, long, 9),
    ]


@pytest.mark.parametrize("long", [5.0, 8.0])
def test_a_corridor_that_ends_at_a_facade_has_a_window_there(long: float) -> None:
    plan = from_polygons(terrace(long), PlanConfig())
    assert validate(plan) == []
    assert len(panes(plan, "hallway_1")) == 1, "the entrance takes the other end"


def test_a_corridor_that_ends_at_a_party_wall_has_none() -> None:
    program = from_polygons(terrace(8.0), PlanConfig()).program
    envelope = program.envelope.model_copy(update={"entrance": "west", "party_walls": ["east"]})
    plan = from_polygons(terrace(8.0), PlanConfig(), program.model_copy(update={"envelope": envelope}))
    assert panes(plan, "hallway_1") == []


def test_two_windows_share_a_broad_wall_evenly() -> None:
    plan = from_polygons(terrace(8.0), PlanConfig())
    south = sorted((p for p in panes(plan, "living_room_1") if abs(p[0, 1] - p[1, 1]) < 1e-6), key=lambda p: p[0, 0])
    assert len(south) == 2
    middles = [p[:, 0].mean() for p in south]
    x0, _, x1, _ = polygons.floor(next(r for r in plan.rooms if r.id == "living_room_1")).bounds
    assert middles == pytest.approx([x0 + (x1 - x0) * share for share in (0.25, 0.75)])
    assert np.ptp([np.ptp(p[:, 0]) for p in south]) < 0.011


def test_the_north_has_more_glass_than_the_south() -> None:
    def glass(party: list[Side]) -> float:
        plan = from_polygons([drawn("study_1", 0, 0, 4, 4)], PlanConfig())
        program = plan.program.model_copy(
            update={"envelope": plan.program.envelope.model_copy(update={"party_walls": party})}
        )
        lit = from_polygons([drawn("study_1", 0, 0, 4, 4)], PlanConfig(), program)
        return sum(float(np.hypot(*np.subtract(*o.segment))) for o in lit.openings if o.kind == "window")

    assert glass(["south", "east", "west"]) > glass(["north", "east", "west"])
