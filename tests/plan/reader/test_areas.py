"""Typical areas and how they share a total, by hand."""

import pytest

from apartgen.schemas.plan import AskedRoom
from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.areas import fill, typical


def rooms(**kinds: str) -> list[AskedRoom]:
    return [AskedRoom(id=name, type=kind) for name, kind in kinds.items()]  # type: ignore[arg-type]


def test_what_is_said_of_a_room_decides_its_typical_area() -> None:
    asked = rooms(bedroom_1="bedroom", bedroom_2="bedroom", bedroom_3="bedroom", bathroom_1="bathroom")
    plain = typical(asked, [], {})
    said = typical(asked, [], {"bedroom_2": {"kids"}, "bedroom_3": {"small"}, "bathroom_1": {"half"}})
    assert said["bedroom_1"] == plain["bedroom_1"]
    assert plain["bedroom_1"] > plain["bedroom_2"] > plain["bedroom_3"], "for two, for two children, for one"
    assert said["bedroom_3"] < said["bedroom_2"] < plain["bedroom_2"]
    assert said["bathroom_1"] < plain["bathroom_1"]


def test_the_rest_stretches_to_the_total() -> None:
    """20 m² are stated, 60 more are usual; of 100 m² 80 are left for what takes 30 as a rule."""
    asked = rooms(living_room_1="living_room", kitchen_1="kitchen", bedroom_1="bedroom")
    base = {"living_room_1": 30.0, "kitchen_1": 10.0, "bedroom_1": 20.0}
    found = fill(asked, base, {"living_room_1": 20.0}, {}, 100.0)
    assert found["living_room_1"] == 20.0 and sum(found.values()) == pytest.approx(100.0, abs=0.02)
    assert found["kitchen_1"] > 10.0 and found["bedroom_1"] > 20.0


def test_a_share_of_nothing_is_none() -> None:
    """A room that is said to take 0 % of a home is as large as it is as a rule."""
    asked = rooms(living_room_1="living_room", kitchen_1="kitchen")
    base = {"living_room_1": 30.0, "kitchen_1": 10.0}
    assert fill(asked, base, {}, {"kitchen_1": 0.0}, None) == base
    assert fill(asked, base, {}, {"kitchen_1": 0.0}, 40.0) == pytest.approx(base, abs=0.02)


@pytest.mark.parametrize(("prompt", "told"), [
    ("two-bedroom flat", False),
    ("70 sqm two-bedroom flat with a large living room", False),
    ("two-bedroom flat with a living room of 30 m²", True),
    ("10 x 12 ft bedroom, living room, kitchen, bathroom", True),
    ("one bedroom flat; the living room is twice as large as the bedroom", True),
    ("two-bedroom flat, the living room takes up a third of the floor area", True),
    ("two-bedroom flat, both bedrooms the same size", True),
    ("two-bedroom flat with a living room of 30 m² in the south", False),
])  # fmt: skip
def test_areas_count_for_more_where_those_of_rooms_are_told_and_no_places(prompt: str, told: bool) -> None:
    assert (read(prompt).weights.get("typical_area", 1.0) > 1.0) == told
