"""The least areas of rooms, as numbers."""

import handmade as h
import pytest
from plan.flats import within
from shapely import Polygon

import apartgen
from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Program
from apartgen.stages.plan import validate
from apartgen.stages.plan.check import check
from apartgen.stages.plan.problem import areas

LEAST = {"living_room": 10.0, "kitchen": 4.0, "dining_room": 6.0, "bedroom": 7.0, "bathroom": 2.25, "hallway": 1.5,
         "study": 5.0, "utility": 2.25, "storage": 1.0, "closet": 1.0, "balcony": 1.8}


def flat(area: float | None = None, **more: object) -> Program:
    """Hallway, living room, kitchen, bedroom, bathroom: 24.75 m² at least."""
    kinds = ("hallway", "living_room", "kitchen", "bedroom", "bathroom")
    rooms = [{"id": f"{kind}_1", "type": kind, "area": area} for kind in kinds]
    return Program(rooms=rooms, links=[("hallway_1", f"{kind}_1") for kind in kinds[1:]], **more)


@pytest.mark.parametrize("kind", LEAST)
def test_a_room_is_never_wanted_smaller(kind: str) -> None:
    def wanted(area: float | None) -> float:
        room = {"id": f"{kind}_1", "type": kind, "area": area}
        return areas(Program(rooms=[room], links=[]))[f"{kind}_1"]

    assert wanted(0.5) == pytest.approx(LEAST[kind]) and wanted(30.0) == 30.0
    assert wanted(None) == pytest.approx(1.6 * LEAST[kind])


def test_a_flat_too_small_for_the_least_areas_is_told_so() -> None:
    with pytest.raises(Unmet, match="5 rooms need at least 25 m².*but the flat has 24 m²"):
        check(flat(total_area=24.0))
    check(flat(total_area=24.4))
    with pytest.raises(Unmet, match="at least 25 m².*outline holds 24.5 m²"):
        check(within(flat(), outline=[(0, 0), (5, 0), (5, 4.9), (0, 4.9)]))
    check(within(flat(), outline=[(0, 0), (5, 0), (5, 5), (0, 5)]))


@pytest.mark.parametrize(("deep", "small"), [(1.8, True), (1.9, False)])
def test_a_room_well_below_its_least_is_a_fault(deep: float, small: bool) -> None:
    """Four fifths of 7 m², 5.6 m², are accepted."""
    rooms = [room.model_copy(update={"polygon": h.rectangle(4.1, 0, 3, deep)}) if room.id == h.BEDROOM else room
             for room in h.plan().rooms]
    program = h.program()
    asked = [room.model_copy(update={"area": 7.0 if room.id == h.BEDROOM else None}) for room in program.rooms]
    plan = h.plan().model_copy(update={"rooms": rooms, "program": program.model_copy(update={"rooms": asked})})
    assert any("less than the least of 7" in fault for fault in validate(plan)) is small


@pytest.mark.wide
def test_hardly_a_bedroom_is_larger_than_the_one_that_is_to_be_the_largest() -> None:
    """By more than walls take of one that is longer: of 80 flats 13 before it counted."""
    larger = []
    for seed in range(32):
        plan = apartgen.plan("apartment for a couple with twins, 95 m2, with a dining room", seed=seed).body
        wanted = {room.id: room.area or 0.0 for room in plan.program.rooms if room.base == "bedroom"}
        got = {room.id: Polygon(room.polygon).area for room in plan.rooms if room.id in wanted}
        main = max(wanted, key=lambda id: wanted[id])
        larger.append(got[main] <= max(area for id, area in got.items() if id != main) - 0.3)
    assert sum(larger) <= 1
