"""Every home has somewhere to eat, and what the prompt says about tables wins."""

import numpy as np
import pytest

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import AskedObjects, Plan
from apartgen.stages.layout import LayoutConfig, run_many
from apartgen.stages.layout.datasets import furnisher
from apartgen.stages.layout.meals import TABLES, table_of, without_table
from apartgen.stages.plan import PlanConfig, build
from apartgen.stages.plan.study import archetypes


@pytest.fixture(scope="module")
def homes() -> list[Plan]:
    names = ("studio", "one_bedroom", "two_bedroom", "three_bedroom")
    return [build(archetypes()[name], PlanConfig(), np.random.default_rng(3)) for name in names]


def seated(plan: Plan, objects: list[Box]) -> bool:
    """Whether one room holds a table and a chair at least."""
    held = [{box.category for box in objects if box.room == room.id} for room in plan.rooms]
    return any("chair" in names and not names.isdisjoint(TABLES) for names in held)


def test_a_home_has_a_table_with_chairs(homes: list[Plan]) -> None:
    rngs = [np.random.default_rng(i) for i in range(len(homes))]
    for home in run_many(homes, LayoutConfig(candidates=2), rngs):
        assert seated(home, home.objects)
    for home in homes:
        assert seated(home, furnisher.furnish(home, np.random.default_rng(0)))


def test_what_the_prompt_says_of_tables_wins(homes: list[Plan]) -> None:
    plan = next(home for home in homes if table_of(home) is not None)
    place, _ = table_of(plan) or ("", "")

    def told(**said: object) -> Plan:
        return plan.model_copy(update={"program": plan.program.model_copy(update=said)})

    assert table_of(told(objects=[AskedObjects(room=place, category="dining_table", count=0)])) is None
    assert (table_of(told(counts={place: 3})) or ("",))[0] != place
    alone = plan.model_copy(update={"rooms": [room for room in plan.rooms if room.id == place]})
    assert table_of(alone) is None, "a room by itself is no home"


def test_beside_a_dining_room_the_living_room_has_a_table_only_where_one_is_asked_for(homes: list[Plan]) -> None:
    plan = homes[3]
    plan = plan.model_copy(update={"rooms": [
        room.model_copy(update={"type": "dining_room"}) if room.id == "bedroom_2" else room for room in plan.rooms]})
    living = next(room.id for room in plan.rooms if room.type == "living_room")
    rows = [AskedObjects(room=living, category="dining_table", count=1)]
    asked = plan.model_copy(update={"program": plan.program.model_copy(update={"objects": rows})})
    assert without_table(plan) == [living] and not without_table(asked)
    config = LayoutConfig(room=[living, "bedroom_2"])
    tables = [{box.room for box in home.objects if box.category in ("dining_table", "round_table")}
              for seed in range(2)
              for home in run_many([plan, asked], config, list(map(np.random.default_rng, (seed, seed))))]
    assert all(living not in there and "bedroom_2" in there for there in tables[::2])
    assert all(living in there for there in tables[1::2])


@pytest.mark.parametrize("bedrooms, long, round_", [
    (2, 7, True), (3, 7, True), (4, 7, False), (4, 10, False), (2, 6, True), (3, 6, False)])
def test_no_more_than_six_eat_at_a_round_table_and_four_where_there_is_little_floor(
        bedrooms: int, long: int, round_: bool) -> None:
    """Two sleep in each of the bedrooms, and all eat in the living room."""
    rooms = [("living_room_1", "living_room", 0)]
    rooms += [(f"bedroom_{k}", "bedroom", 11 * k) for k in range(1, bedrooms + 1)]
    plan = Plan.model_validate({
        "program": {"rooms": [{"id": id, "type": kind, "area": 28} for id, kind, _ in rooms]},
        "rooms": [{"id": id, "type": kind, "polygon": [(x, 0), (x + long, 0), (x + long, 4), (x, 4)]}
                  for id, kind, x in rooms],
        "openings": [], "height": 2.6})
    assert table_of(plan, 0.0) == ("living_room_1", "round_table" if round_ else "dining_table")
    assert table_of(plan, 0.9) == ("living_room_1", "dining_table")
