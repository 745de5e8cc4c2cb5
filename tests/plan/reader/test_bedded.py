"""Who sleeps in which bed and where, and whose bathroom has its door in the hall."""

import pytest

from apartgen.stages.plan.reader import read

OURS, THEIRS = {("bedroom_1", "double_bed", 1)}, {("bedroom_2", "single_bed", 2)}
SAID = [
    ("Our twins sleep in one bedroom, in two single beds, and we sleep in the other, in a double bed.",
     OURS | THEIRS),
    ("Two bedrooms: the twins in one with two single beds, us in the other with a double bed.", OURS | THEIRS),
    ("Two bedrooms. The twins have two single beds, we have a double bed.", OURS | THEIRS),
    ("Our twins sleep in one bedroom in two single beds and we sleep in the other.", THEIRS),
    ("2-bed flat: grandma in one with a double bed, the children in the other with two single beds.", None),
    ("2-bed flat: grandma in one with a single bed, us in the other with a double bed.",
     OURS | {("bedroom_2", "single_bed", 1)}),
    ("Two bedrooms. We have a double bed. The kids have two single beds and a desk.",
     OURS | THEIRS | {("bedroom_2", "desk", 1)}),
]
LODGER = "The lodger gets a bedroom with an en suite shower room. "
USED = [
    f"{LODGER}I keep the other bedroom and use the bathroom off the hallway. We share the kitchen and the living room.",
    "Two bedrooms. The main bedroom has an ensuite. The other bedroom uses the bathroom off the hall.",
]  # fmt: skip


@pytest.mark.parametrize(("text", "beds"), SAID)
def test_beds_stand_where_those_sleep_who_have_them(text: str, beds: set[tuple[str, str, int]] | None) -> None:
    program = read(text)
    found = {(o.room, o.category, o.count) for o in program.objects}
    assert found == beds if beds else {c for _, c, _ in found} == {"double_bed", "single_bed"}
    assert sum(r.type == "bedroom" for r in program.rooms) == 2 and not program.unread


@pytest.mark.parametrize("text", USED)
def test_a_bathroom_off_the_hall_that_somebody_uses_has_its_door_there(text: str) -> None:
    program = read(text)
    own = {r.id: r.private_to for r in program.rooms if r.type == "bathroom"}
    (shared,) = [room for room, owner in own.items() if owner is None]
    assert len(own) == 2 and [set(link) for link in program.links if shared in link] == [{shared, "hallway_1"}]
