"""Wishes that no layout can meet are refused by name; those that this one did not meet are said."""

import logging
from collections.abc import Sequence

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import Plan
from apartgen.stages import layout
from apartgen.stages.layout import wishes
from apartgen.stages.layout.config import LayoutConfig


def asking(objects: Sequence[tuple[str, int]] = (), counts: dict[str, int] | None = None) -> Plan:
    plan = h.plan()
    rows = [{"room": h.BEDROOM, "category": category, "count": count} for category, count in objects]
    return plan.model_copy(update={"program": type(plan.program).model_validate(
        plan.program.model_dump() | {"objects": rows, "counts": counts or {}})})


@pytest.mark.parametrize("objects, counts, said", [
    ([("plant", 30)], {}, "30 objects wanted in bedroom_1; a room holds at most 24"),
    ([("plant", 20), ("chair", 5)], {}, "25 objects wanted in bedroom_1"),
    ([], {h.BEDROOM: 30}, "30 objects wanted in bedroom_1; a room holds at most 24"),
    ([("desk", 4)], {h.BEDROOM: 3}, "4 objects wanted by category in bedroom_1, but 3 in all"),
    ([("desks", 1)], {}, "wanted in bedroom_1: no category 'desks' is known here .did you mean 'desk'"),
    ([("couch", 1)], {}, "did you mean 'sofa'"),
    ([("qqqq", 2)], {}, "wanted in bedroom_1: no category 'qqqq' is known here; "),
])
def test_what_no_layout_can_have_is_refused(objects: list[tuple[str, int]], counts: dict[str, int], said: str) -> None:
    with pytest.raises(BadInput, match=said):
        layout.run(asking(objects, counts), LayoutConfig(), np.random.default_rng(0))


def test_a_programme_cannot_ask_for_fewer_than_none() -> None:
    with pytest.raises(ValueError, match="greater than or equal to 0"):
        asking(counts={h.BEDROOM: -3})


def test_what_can_be_had_is_not_refused() -> None:
    wishes.check(asking([("desk", 2), ("desk", 1), ("rug", 0)], {h.BEDROOM: 3}))
    assert wishes.of_room(asking([("desk", 2), ("desk", 1), ("rug", 0)]).program, h.BEDROOM) == {"desk": 3, "rug": 0}


@pytest.mark.parametrize("many, area, beds", [
    (1, 9.0, {"single_bed": 1}), (1, 20.0, {"single_bed": 1}), (2, 11.0, {"bunk_bed": 1}), (2, 12.5, {"single_bed": 2}),
    (3, 14.0, {"bunk_bed": 1, "single_bed": 1}), (4, 16.0, {"bunk_bed": 2}),
])
def test_children_have_a_bed_each_and_grown_ups_no_bunk_bed(many: int, area: float, beds: dict[str, int]) -> None:
    first = asking().program.rooms[0]
    own = first.model_copy(update={"id": "bedroom_2", "type": "bedroom", "children": many})
    program = asking().program.model_copy(update={"rooms": [*asking().program.rooms, own]})
    found = wishes.of_sleepers(program, "bedroom_2", area)
    assert {name: n for name, n in found.items() if n} == beds and found["double_bed"] == 0
    beds_of = {room.id for room in asking().program.rooms if room.base == "bedroom"}
    assert beds_of == {h.BEDROOM}
    assert wishes.of_sleepers(program, h.BEDROOM, area) == {"bunk_bed": 0, "double_bed": 1, "single_bed": 0}
    third = own.model_copy(update={"id": "bedroom_3", "children": None})
    more = program.model_copy(update={"rooms": [*program.rooms, third]})
    assert wishes.of_sleepers(more, h.BEDROOM, area) == {"bunk_bed": 0}, "whose are the two?"
    assert wishes.of_sleepers(asking([("double_bed", 1)]).program, h.BEDROOM, area) == {}
    assert wishes.of_sleepers(asking().program, h.BEDROOM, area) == {}


def test_the_bedroom_with_a_bathroom_of_its_own_has_a_bed_for_two() -> None:
    first = asking().program.rooms[0]
    second = first.model_copy(update={"id": "bedroom_2", "type": "bedroom", "area": 14.0})
    bath = first.model_copy(update={"id": "bathroom_2", "type": "bathroom", "area": 3.0, "private_to": h.BEDROOM})

    def beds(room: str, *more: object, area: float = 10.4) -> dict[str, int]:
        program = asking().program.model_copy(update={"rooms": [*asking().program.rooms, *more]})
        return wishes.of_sleepers(program, room, area)

    for_two = {"double_bed": 1, "single_bed": 0}
    assert beds(h.BEDROOM, second, bath) == for_two and beds("bedroom_2", second, bath) == {}
    assert beds(h.BEDROOM, second) == {} and beds(h.BEDROOM, bath) == {}, "it is told from others"
    assert beds(h.BEDROOM, second, bath, area=7.0) == {}
    child = second.model_copy(update={"children": 1})
    assert beds(h.BEDROOM, child, bath)["double_bed"] == 1 and beds("bedroom_2", child, bath)["double_bed"] == 0


def test_unmet_wishes_are_counted() -> None:
    program = asking([("desk", 2), ("rug", 0), ("chair", 1)], {h.BEDROOM: 4}).program
    things = [h.thing(name, 5, 1, room=h.BEDROOM) for name in ("desk", "rug", "chair", "chair")]
    assert wishes.unmet(program, h.BEDROOM, things) == ["1 desk, 2 asked for", "1 rug, 0 asked for"]
    assert wishes.unmet(program, h.BEDROOM, things[:3])[0] == "3 objects, 4 were asked for"
    assert wishes.unmet(program, h.LIVING, things) == []


def test_a_room_too_small_for_what_it_was_asked_says_so(caplog: pytest.LogCaptureFixture) -> None:
    plan = asking([("double_bed", 3), ("wardrobe", 3)])
    with caplog.at_level(logging.INFO, "apartgen"):
        made = layout.run(plan, LayoutConfig(), np.random.default_rng(1))
    beds, wardrobes = (sum(o.category == name for o in made.objects) for name in ("double_bed", "wardrobe"))
    assert beds < 3 or wardrobes < 3
    said = [record.getMessage() for record in caplog.records if "asked for" in record.getMessage()]
    assert len(said) == 1 and said[0].startswith("bedroom_1: has ")
    assert (f"{beds} double_bed, 3" in said[0]) == (beds < 3)


def test_wishes_hold_where_guidance_sets_the_number() -> None:
    """Eq. 3 fills the slots that were given to what is wanted."""
    plan = asking([("desk", 2)], {h.BEDROOM: 5})
    config = LayoutConfig(model="diffusion", count="guided", projection=False)
    homes = layout.run_many([plan] * 4, config, [np.random.default_rng([i, 1]) for i in range(4)])
    bedrooms = [[o.category for o in home.objects if o.room == h.BEDROOM] for home in homes]
    assert [names.count("desk") for names in bedrooms] == [2] * 4 and {len(names) for names in bedrooms} == {5}


def test_a_sample_that_ran_away_is_no_layout() -> None:
    config = LayoutConfig(model="diffusion", projection=False, scaling="sigma", guidance_scale=2e5)
    with pytest.raises(Unmet, match="--guidance-scale"):
        layout.run(asking(), config, np.random.default_rng(0))
