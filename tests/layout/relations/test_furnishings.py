"""What comes to the contents that a model draws: nightstands, desks for who sleeps alone, light, wardrobes, chairs."""

from collections import Counter

import pytest

from apartgen.stages.layout.relations.furnishings import completed, idle


@pytest.mark.parametrize("names, stands", [
    (["double_bed"], 2), (["double_bed", "nightstand"], 2), (["double_bed", "side_table", "nightstand"], 1),
    (["single_bed", "desk"], 1), (["single_bed", "nightstand", "desk"], 1), (["sofa"], 0), (["bunk_bed"], 0),
])
def test_everyone_has_a_nightstand(names: list[str], stands: int) -> None:
    found = completed(names, {}, "bedroom", 12.0)
    assert found[: len(names)] == names and found.count("nightstand") == stands
    none = dict.fromkeys(["nightstand", "table_lamp", "desk", "ceiling_lamp", "wardrobe"], 0)
    assert completed(names, none, "bedroom", 12.0) == names


@pytest.mark.parametrize("names, bedroom, lamps", [
    (["bunk_bed", "desk"], True, 1), (["bunk_bed", "floor_lamp"], True, 0), (["double_bed", "table_lamp"], True, 0),
    (["double_bed", "ceiling_lamp"], True, 1), (["sofa"], False, 0),
])
def test_one_reads_in_bed(names: list[str], bedroom: bool, lamps: int) -> None:
    room = "bedroom" if bedroom else "living_room"
    found = completed(names, {}, room, 7.0)
    assert found.count("table_lamp") - names.count("table_lamp") == lamps
    assert "table_lamp" not in completed(["bunk_bed"], {"wall_lamp": 0}, room, 7.0)


@pytest.mark.parametrize("names, bedroom, area, desks, chairs", [
    (["single_bed"], True, 9.0, 1, 1), (["single_bed", "chair"], True, 9.0, 1, 0), (["single_bed"], True, 6.0, 0, 0),
    (["single_bed"], False, 20.0, 0, 0), (["double_bed"], True, 14.0, 0, 0), (["single_bed"] * 2, True, 14.0, 2, 2),
    (["single_bed", "desk", "office_chair"], True, 9.0, 1, 1), (["single_bed"] * 2, True, 10.0, 1, 1),
    (["bunk_bed"], True, 11.0, 2, 2), (["bunk_bed"], True, 9.0, 1, 1), (["bunk_bed"], True, 7.0, 0, 0),
    (["bunk_bed", "desk", "office_chair"], True, 11.0, 2, 2), (["bunk_bed", "double_bed"], True, 16.0, 0, 0),
])
def test_who_shares_no_bed_has_a_desk(names: list[str], bedroom: bool, area: float, desks: int, chairs: int) -> None:
    room = "bedroom" if bedroom else "living_room"
    found = Counter(completed(names, {}, room, area))
    assert (found["desk"], found["office_chair"]) == (desks, chairs)
    assert Counter(completed(names, {"desk": 0}, room, area))["desk"] == names.count("desk")


@pytest.mark.parametrize(("asked", "there", "kind", "found"), [
    ({"desk": 0}, [], "study", {"chair", "office_chair", "monitor"}),
    ({"desk": 0}, [], "living_room", {"office_chair", "monitor"}),
    ({"desk": 0}, [], "dining_room", set()),
    ({"desk": 0, "chair": 1}, [], "study", {"office_chair", "monitor"}),
    ({"desk": 0}, ["desk"], "study", set()), ({"desk": 1}, [], "study", set()), ({}, [], "study", set()),
    ({"dining_table": 0}, [], "kitchen", set()), ({"dining_table": 0, "round_table": 0}, [], "kitchen", {"chair"}),
    ({"sofa": 0}, [], "living_room", set()),
])
def test_a_chair_has_no_use_where_no_desk_is_to_be(asked, there, kind, found) -> None:
    """Nor has one where there is to be no table, unless another that comes in such rooms is left."""
    assert idle(asked, there, kind) == dict.fromkeys(found, 0)


@pytest.mark.parametrize("names, diners, chairs", [
    (["sofa", "dining_table"] + ["chair"] * 4, 6, 6), (["round_table", "chair"], 2, 2), (["sofa"], 6, 0),
    (["dining_table"] + ["chair"] * 6, 4, 6), (["dining_table", "chair"], 0, 1),
    (["dining_table", "chair"], 8, 6),
])
def test_who_eats_has_a_chair_at_the_table(names: list[str], diners: int, chairs: int) -> None:
    assert completed(names, {}, "living_room", 25.0, diners).count("chair") == chairs
    assert completed(names, {"chair": 2, "ceiling_lamp": 1}, "living_room", 25.0, diners) == names


@pytest.mark.parametrize("names, room, lamps, wardrobes", [
    (["double_bed", "sofa"], "living_room", 1, 1), (["single_bed", "sliding_wardrobe"], "bedroom", 1, 0),
    (["double_bed", "clothes_rail", "ceiling_lamp"], "bedroom", 1, 0), (["sofa"], "living_room", 1, 0),
    (["toilet"], "bathroom", 1, 0), (["balcony_chair"], "balcony", 0, 0),
])
def test_every_room_has_light_and_who_sleeps_a_wardrobe(
    names: list[str], room: str, lamps: int, wardrobes: int,
) -> None:
    found = completed(names, {}, room, 20.0)
    assert (found.count("ceiling_lamp"), found.count("wardrobe")) == (lamps, wardrobes)
    asked = completed(names, {"ceiling_lamp": 0, "sliding_wardrobe": 0}, room, 20.0)
    assert Counter(asked)["ceiling_lamp"] == names.count("ceiling_lamp") and "wardrobe" not in asked
