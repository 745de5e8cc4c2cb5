"""Plans as arrays: nothing of a room is lost."""

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import Opening, Plan, Program, Room
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.rooms import of_plan


def corridor(doors: int) -> Plan:
    """A corridor 20 m long with an entrance at its end and doors along one side."""
    room = Room(id="hallway_1", type="hallway", polygon=[(5, 5), (25, 5), (25, 6.5), (5, 6.5)])
    openings = [
        Opening(id=f"door_{i}", kind="door", rooms=["hallway_1"], segment=((6 + 1.5 * i, 4.95), (6.9 + 1.5 * i, 4.95)),
                sill=0, head=2, into=None)
        for i in range(doors)
    ]
    entrance = Opening(id="entrance_1", kind="entrance", rooms=["hallway_1"], segment=((25.15, 6.2), (25.15, 5.3)),
                       sill=0, head=2, into="hallway_1")
    program = Program(rooms=[{"id": "hallway_1", "type": "hallway", "area": 30}])
    return Plan(program=program, rooms=[room], openings=[*openings, entrance], height=2.6)


def test_every_door_of_a_long_corridor_keeps_its_clear_zone() -> None:
    space = space_of(of_plan(corridor(12)), 0)
    assert space.zones.n == 13
    assert (~space.window).all()


def test_openings_run_along_the_boundary_with_the_room_on_their_left() -> None:
    rooms = of_plan(corridor(3))
    rows = rooms.openings[0][~np.isnan(rooms.openings[0, :, 0])]
    middle, along = (rows[:, 0:2] + rows[:, 2:4]) / 2, rows[:, 2:4] - rows[:, 0:2]
    inward = np.stack([-along[:, 1], along[:, 0]], -1)
    assert ((-middle * inward).sum(1) > 0).all()
    np.testing.assert_allclose(np.abs(middle[:, 1]).max(), 0.75, atol=1e-5)


def test_a_room_with_too_many_corners_is_refused_by_name() -> None:
    plan = corridor(1)
    angle = np.linspace(0, 2 * np.pi, 41)[:-1]
    plan.rooms[0].polygon = [(float(15 + 5 * np.cos(a)), float(6 + 5 * np.sin(a))) for a in angle]
    with pytest.raises(BadInput, match="hallway_1 has 40 corners"):
        of_plan(plan)
