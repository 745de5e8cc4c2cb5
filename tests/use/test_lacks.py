"""What rooms lack: taking things away never makes a room lack less, and what belongs together is missed."""

from dataclasses import replace

import numpy as np
import pytest
from lived_in import EAST, NORTH, ROOMS, bedroom, room, table, thing

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.plan import Plan
from apartgen.stages import use
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import habits
from apartgen.stages.use.wants import HOOKS, _table


def lacking(place: use.Furnished) -> dict[str, float]:
    return {lack.name: lack.number for lack in use.lacks(place)}


def test_wants_are_of_rooms_and_things_that_there_are() -> None:
    rules = _table()
    assert set(rules["few"]) <= set(ROOM_TYPES)
    for group in ("want", "most"):
        assert set(rules[group]) <= set(ROOM_TYPES)
        for kind, wants in rules[group].items():
            for want in wants.values():
                assert set(want["of"]) <= set(TABLE) and want["weight"] > 0
                if group == "want":
                    assert any(kind in TABLE[name].rooms for name in want["of"])


@pytest.mark.parametrize("kind", ROOMS)
def test_the_empty_room_lacks_most(kind: str) -> None:
    width, depth, things = ROOMS[kind]

    def cost(some: list) -> float:  # type: ignore[type-arg]
        return sum(lack.cost for lack in use.lacks(room(kind, width, depth, *some)))

    full, rng = things(), np.random.default_rng(3)
    for _ in range(20):
        k = int(rng.integers(1, len(full)))
        some = [full[i] for i in sorted(rng.choice(len(full), k, replace=False))]
        # A table that is gone is no more lacking chairs.
        if any(o.category in ("dining_table", "double_bed", "tv_stand") for o in some):
            assert cost(some) >= cost(full)
        assert cost(some) <= cost([]) + 4 * 0.4 + 2 * 0.5 + 0.3
    assert cost([]) > cost(full) + 1


def test_a_double_bed_wants_two_nightstands() -> None:
    stands = bedroom()
    assert "double bed with one nightstand" not in lacking(room("bedroom", 4, 4, *stands))
    assert lacking(room("bedroom", 4, 4, *stands[:2], stands[3]))["double bed with one nightstand"] == 1
    assert lacking(room("bedroom", 4, 4, stands[0], stands[3]))["double bed without nightstand"] == 2


@pytest.mark.parametrize("sleeps", [True, False])
def test_a_double_bed_where_one_lives_and_sleeps_wants_them_too(sleeps: bool) -> None:
    here = room("living_room", 4, 4, *bedroom()[:2])
    found = lacking(use.Furnished(replace(here.site, sleeps=sleeps), here.objects))
    assert ("double bed with one nightstand" in found) == sleeps


@pytest.mark.parametrize(("people", "missing"), [(None, 2), (1, 0), (2, 0), (3, 2), (4, 2), (6, 4), (9, 6)])
def test_everyone_who_sleeps_there_has_a_chair(people: int | None, missing: int) -> None:
    site = room("dining_room", 4, 3).site
    seated = table()[:3]
    found = lacking(use.Furnished(replace(site, sleepers=people), seated))
    assert found.get("few chairs at the table", 0) == missing


@pytest.mark.parametrize("kind", ROOMS)
def test_what_is_lacking_by_name_alone_is_the_least_that_can_be_lacking(kind: str) -> None:
    """Where everything stands well nothing more is; where things stand anyhow, as much or more."""
    width, depth, things = ROOMS[kind]
    well, rng = room(kind, width, depth, *things()), np.random.default_rng(5)

    def by_name(place: use.Furnished) -> float:
        return sum(lack.cost for lack in use.lacks_of(place.site, [o.category for o in place.objects]))

    assert by_name(well) == pytest.approx(sum(lack.cost for lack in use.lacks(well)))
    for _ in range(30):
        some = [o.model_copy(update={"center": (rng.uniform(0, width), rng.uniform(0, depth), o.center[2])})
                for o in things() if rng.random() < 0.7]
        anyhow = room(kind, width, depth, *some)
        assert by_name(anyhow) <= sum(lack.cost for lack in use.lacks(anyhow)) + 1e-9


def test_who_sleeps_in_the_living_room_wants_a_place_for_clothes() -> None:
    bed = thing("double_bed", 1.06, 2.0, EAST)
    assert lacking(room("living_room", 6, 5, bed))["no place for clothes"] == 1
    assert "no place for clothes" not in lacking(room("living_room", 6, 5, bed, thing("wardrobe", 3, 0.3, NORTH)))
    assert "no place for clothes" not in lacking(room("living_room", 6, 5))


def test_too_much_is_named() -> None:
    things = [thing("desk", 1, 0.35 + k, NORTH, id=f"desk{k}") for k in range(3)]
    assert lacking(room("bedroom", 4, 4, *things))["too many desks"] == 2
    assert "too many desks" not in lacking(room("study", 4, 4, *things))


def test_newcomers_are_used_as_what_they_are_like(monkeypatch: pytest.MonkeyPatch) -> None:
    newcomer = replace(TABLE["double_bed"], name="water_bed", lineage=("water_bed", "double_bed"))
    monkeypatch.setitem(TABLE, "water_bed", newcomer)
    own = room("bedroom", 4, 4, thing("water_bed", 1.06, 2.0, EAST), *bedroom()[1:])
    usual = room("bedroom", 4, 4, *bedroom())
    assert lacking(own) == lacking(usual) and not list(use.faults(own))


def test_clothes_are_washed_in_one_room_of_a_home() -> None:
    here = room("bathroom", 2.45, 3.0).site
    there = replace(here, laundry=True)
    assert "no machine to wash" in {lack.name for lack in use.lacks_of(there, [])}
    assert "no machine to wash" not in {lack.name for lack in use.lacks_of(there, ["washing_machine"])}
    assert "no machine to wash" not in {lack.name for lack in use.lacks_of(here, [])}
    assert (use.belongings(there), use.belongings(here)) == (["washing_machine"], [])


@pytest.mark.parametrize(("width", "main", "bed", "lacks"), [
    (2.6, False, "single_bed", set()), (3.0, False, "single_bed", {"bed for one where two sleep"}),
    (2.6, True, "single_bed", {"no double bed in the largest bedroom"}), (2.6, True, "double_bed", set()),
    (3.0, False, "bunk_bed", set()), (2.3, True, "single_bed", set()),
])
def test_two_sleep_where_there_is_floor_and_a_couple_in_the_largest_bedroom(
        width: float, main: bool, bed: str, lacks: set[str]) -> None:
    """Rooms of 2.3, 2.6 and 3 by 3.6 m: 8.3, 9.4 and 10.8 m²."""
    site = replace(room("bedroom", width, 3.6).site, sleepers=4, main=main)
    found = {lack.name for lack in use.lacks_of(site, [bed])}
    assert found & {"bed for one where two sleep", "no double bed in the largest bedroom"} == lacks
    assert "bed for one where two sleep" not in {x.name for x in use.lacks_of(replace(site, sleepers=None), [bed])}


@pytest.mark.parametrize(("width", "things", "few"), [
    (2.0, ["single_bed"], 0), (2.3, ["single_bed"], 1), (2.3, ["single_bed", "desk"], 0), (3.4, ["double_bed"], 0),
    (2.6, ["bunk_bed"], 1), (3.0, ["bunk_bed"], 2), (3.0, ["bunk_bed", "desk"], 1), (3.0, ["single_bed"] * 2, 1),
    (3.4, ["single_bed"] * 2, 2), (3.4, ["single_bed", "single_bed", "desk", "desk"], 0), (3.4, [], 0),
    (3.4, ["single_bed"], 1),
])
def test_who_shares_no_bed_wants_a_desk_of_their_own_where_there_is_floor(
        width: float, things: list[str], few: int) -> None:
    """Bedrooms so wide and 3.6 m long, 7.2 to 12.2 m²; who lives in a room by itself is not known."""
    site = replace(room("bedroom", width, 3.6).site, sleepers=4)
    assert sum(lack.number for lack in use.lacks_of(site, things) if lack.name == "few desks") == few
    assert "few desks" not in {lack.name for lack in use.lacks_of(replace(site, sleepers=None), things)}
    assert "few desks" not in {lack.name for lack in use.lacks_of(replace(site, kind="study"), things)}


@pytest.mark.parametrize(("beds", "wanted"), [(2, {"bedroom_1", "bedroom_2"}), (3, {"bedroom_1"})])
def test_in_homes_of_three_bedrooms_and_more_only_the_largest_wants_a_double_bed(beds: int, wanted: set[str]) -> None:
    """Bedrooms of 14 m² and, the others, of 12 m², side by side."""
    widths = [3.5] + [3.0] * (beds - 1)
    starts = np.concatenate([[0.0], np.cumsum(widths)[:-1]])
    rooms = [{"id": f"bedroom_{k + 1}", "type": "bedroom", "polygon": [[x, 0], [x + w, 0], [x + w, 4], [x, 4]]}
             for k, (x, w) in enumerate(zip(starts.tolist(), widths, strict=True))]
    asked = [{"id": room["id"], "type": "bedroom"} for room in rooms]
    plan = Plan.model_validate({"program": {"rooms": asked}, "rooms": rooms, "openings": []})
    found = {room["id"] for room in rooms if "no double bed" in {
        lack.name for lack in use.lacks_of(use.site(plan, room["id"]), ["single_bed", "single_bed"])}}
    assert found == wanted


def test_a_home_is_entered_with_coats_where_it_has_no_hall() -> None:
    """A hall wants a place for them as a hall does, which is another row of the table."""
    for kind, lacks in (("living_room", True), ("hallway", False)):
        one = {"id": f"{kind}_1", "type": kind}
        door = {"id": "in", "kind": "entrance", "rooms": [one["id"]], "segment": [[1, 0], [2, 0]], "sill": 0, "head": 2}
        rooms = [one | {"polygon": [[0, 0], [5, 0], [5, 4], [0, 4]]}]
        plan = Plan.model_validate({"program": {"rooms": [one]}, "rooms": rooms, "openings": [door]})
        place = use.site(plan, one["id"])
        assert use.arrivals(place) == ["coat_rack"]
        assert [lack.cost for lack in use.lacks_of(place, ["sofa"]) if lack.name == "no place for coats"] == [
            HOOKS if lacks else 1.0]
        assert "no place for coats" not in {lack.name for lack in use.lacks_of(place, ["sofa", "coat_rack"])}


def test_a_dishwasher_is_worktop_and_no_cupboard() -> None:
    site = room("kitchen", 2.4, 3.0).site
    cook = ["kitchen_sink", "oven", "fridge", "hood", "wall_unit", "wall_unit", "ceiling_lamp"]
    found = [{lack.name for lack in use.lacks_of(site, [*cook, *more])} & {"no cupboard", "no worktop"}
             for more in ([], ["dishwasher"], ["kitchen_base"], ["dishwasher", "kitchen_drawers"])]
    assert found == [{"no cupboard", "no worktop"}, {"no cupboard"}, set(), set()]


@pytest.mark.parametrize(("people", "wide", "things", "missing"), [
    (6, 5.0, ["sofa", "armchair"], 2), (6, 5.0, ["sofa", "sofa"], 0), (5, 5.0, ["corner_sofa", "armchair"], 0),
    (8, 5.0, ["sofa"], 3), (4, 5.0, ["sofa"], 0), (6, 3.5, ["sofa"], 0), (None, 5.0, ["sofa"], 0),
])  # fmt: skip
def test_many_want_soft_seats(people: int | None, wide: float, things: list[str], missing: int) -> None:
    """In living rooms of 25 m², and of 17.5 m², where four are enough."""
    site = replace(room("living_room", wide, 5.0).site, sleepers=people)
    found = {lack.name: lack.number for lack in use.lacks_of(site, things)}
    assert found.get("few seats beside the sofa", 0) == missing


@pytest.mark.parametrize(("people", "deep", "things", "lacks"), [
    (3, 4.0, ["coat_rack"], True), (3, 4.0, ["sliding_wardrobe"], False), (2, 4.0, ["coat_rack"], False),
    (3, 3.0, ["coat_rack"], False), (None, 4.0, [], False),
])  # fmt: skip
def test_coats_of_many_want_a_cupboard(people: int | None, deep: float, things: list[str], lacks: bool) -> None:
    """In halls of 8 m², not of 6 m²."""
    site = replace(room("hallway", 2.0, deep).site, sleepers=people)
    assert ("no cupboard for the coats of many" in {lack.name for lack in use.lacks_of(site, things)}) == lacks


@pytest.mark.parametrize("many", [2, 3])
def test_of_a_hallway_it_is_counted_whether_it_has_two_cabinets_at_most(many: int) -> None:
    cabinets = [thing("shoe_cabinet", 1.0 + 1.5 * k, 0.2, NORTH) for k in range(many)]
    assert habits.cases(room("hallway", 6.0, 2.0, *cabinets))["two cabinets at most"] == [many == 2]


@pytest.mark.parametrize(("widths", "same"), [
    ((0.45, 0.45, 0.45), [True] * 3), ((0.45, 0.45, 0.55), [True, True, False]), ((0.45, 0.47), [True, True]),
    ((0.45, 0.49), [False, False]), ((0.45,), None)])
def test_each_of_several_alike_is_of_one_size_with_another_or_not(widths: tuple[float, ...], same: list[bool] | None,
                                                                  ) -> None:
    """Up to 3 cm apart."""
    chairs = [thing("chair", 0.8 + k, 1.0, NORTH, (0.5, wide, 0.9)) for k, wide in enumerate(widths)]
    assert habits.cases(room("dining_room", 4.0, 3.0, *chairs)).get("several alike of one size") == same
