"""Small steps of reading on items by hand, and prompts that hang on them: where lists begin, areas given anew, rooms
that are each larger than the other."""

import pytest

from apartgen.schemas.errors import Unmet
from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.distributed import matched
from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.measures import _coordinated, _corrected
from apartgen.stages.plan.reader.mention import Item, RoomPhrase
from apartgen.stages.plan.reader.objects import _continues
from apartgen.stages.plan.reader.predicates import Predicate
from apartgen.stages.plan.reader.ranked import _by_size
from apartgen.stages.plan.reader.subjects import and_group
from apartgen.stages.plan.reader.vocabulary import Relation, Trait

AND, PLUS, COMMA = Item("conjunction", "and"), Item("conjunction", "plus"), Item("mark", ",")
NO, AREA = Item("negation", "not", "no"), Item("area", values=(12.0,))


def rooms(n: int) -> list[Item]:
    return [Item("room", room=RoomPhrase("bedroom", text=str(k))) for k in range(n)]


def test_rooms_joined_by_and_begin_no_earlier_than_they_may() -> None:
    """0 and 1 and 2 and 3: at 0, 2, 4, 6."""
    a, b, c, d = rooms(4)
    items = [a, AND, b, AND, c, AND, d]
    assert [and_group(items, 6, floor) for floor in range(7)] == [0, 2, 2, 4, 4, 6, 6]
    assert [and_group(items, at, 0) for at in (0, 2, 4)] == [0, 0, 0] and and_group(items[:3], 2, 0) == 0


def test_plus_commas_and_other_words_part_rooms() -> None:
    a, b, c, _ = rooms(4)
    assert and_group([a, PLUS, b, AND, c], 4, 0) == 2
    assert and_group([a, COMMA, b, AND, c], 4, 0) == 2 and and_group([a, COMMA, b, AND, c], 4, 0, whole=True) == 0
    assert and_group([a, Item("link"), b], 2, 0) == and_group([Item("with"), AND, b], 2, 0) == 2


def test_a_list_of_rooms_ends_in_the_last_and_begins_after_what_is_no_and() -> None:
    """A sentence that begins with a list may have commas in it."""
    a, b, c, d = rooms(4)
    names = [[phrase.text for phrase in _coordinated(items, last.room)] for items, last in (  # type: ignore[arg-type]
        ([a, AND, b], b), ([a, AND, b], a), ([a, COMMA, b, AND, c], c), ([a, AND, b, AND, c, AND, d], c),
        ([AND, b], b), ([NO, AND, b], b))]
    assert names == [["0", "1"], ["0"], ["0", "1", "2"], ["0", "1", "2"], ["1"], ["1"]]


@pytest.mark.parametrize("between", range(4))
def test_what_is_denied_of_a_relation_is_the_room_right_after_but_not(between: int) -> None:
    """`A next to B but not to C`: the room after `but not`, and at most one word, goes on with it, a later one not."""
    a, b, c, _ = rooms(4)
    items = [a, Item("link", "to"), b, Item("conjunction", text="but"), NO, *[Item("unknown")] * between, c]
    to = Predicate(1, Relation.TO, "part", False)
    assert _continues(items, to, len(items) - 1, [b.room], [a.room]) is (between < 2)  # type: ignore[list-item]


@pytest.mark.parametrize("before", [[], [COMMA], [AND, COMMA]])
def test_an_area_given_anew_is_of_the_room_before_wherever_that_stands(before: list[Item]) -> None:
    """`kitchen 12 m², no, 14 m²`: the first is forgotten."""
    (room,) = rooms(1)
    assert room.room is not None
    items = [*before, room, AREA, COMMA, NO, COMMA, AREA]
    room.room.areas = (12.0,)
    assert _corrected(items, len(items) - 1) == [room.room] and room.room.areas == ()
    room.room.areas = (12.0,)
    told = [*before, room, AREA, COMMA, AREA]
    assert _corrected(told, len(told) - 1) == [] and room.room.areas == (12.0,)
    assert _corrected([AREA, COMMA, NO, COMMA, AREA], 4) == []


@pytest.mark.parametrize("prompt", [
    "Kitchen 12 m², no, 14 m², two bedrooms.", "Two bedrooms, kitchen 12 m², no, 14 m²."])
def test_the_last_area_said_of_a_room_counts(prompt: str) -> None:
    assert {room.area for room in read(prompt).rooms if room.type == "kitchen"} == {14.0}


@pytest.mark.parametrize("first, second, possible", [
    ("twice as large as", "twice as large as", False), ("larger than", "slightly larger than", False),
    ("smaller than", "half as large as", False), ("larger than", "smaller than", True),
    ("twice as large as", "half as large as", True), ("as large as", "as large as", True),
    ("times as large as", "much smaller than", True), ("times as large as", "larger than", True)])
def test_two_rooms_are_not_each_larger_than_the_other(first: str, second: str, possible: bool) -> None:
    """`Times as large`, without saying how many, is neither larger nor smaller."""
    prompt = f"One bedroom. The kitchen is {first} the study. The study is {second} the kitchen."
    if possible:
        assert {room.type for room in read(prompt).rooms} >= {"bedroom", "kitchen", "study"}
    else:
        with pytest.raises(Unmet, match="are each to be (larger|smaller) than the other"):
            read(prompt)


@pytest.mark.parametrize("said, kind", [
    ("No bedroom is off the kitchen", "no_door"), ("No bedroom opens off the kitchen", "no_door"),
    ("No bedroom adjoins the kitchen", "apart"), ("No bedroom next to the kitchen", "apart"),
    ("No bedroom is next to the kitchen", "apart")])
def test_what_no_bedroom_is_none_of_them_is(said: str, kind: str) -> None:
    """With a verb, or of what lies beside; both bedrooms stay."""
    found = read(f"Two bedrooms. {said}.")
    assert {(r.kind, r.of, r.to) for r in found.requirements} == {(kind, f"bedroom_{k}", "kitchen_1") for k in (1, 2)}
    assert sum(room.type == "bedroom" for room in found.rooms) == 2


@pytest.mark.parametrize("before", ["Two bedrooms. ", "A flat with two bedrooms, ", "Two bedrooms, a study; "])
@pytest.mark.parametrize("room", ["bedroom", "bathroom"])
def test_no_room_off_the_kitchen_is_no_door_to_it(before: str, room: str) -> None:
    """It was read as if the bedrooms were off the kitchen."""
    found = read(f"{before}no {room} off the kitchen.")
    assert not {("bedroom_1", "kitchen_1"), ("bedroom_2", "kitchen_1"), ("bathroom_1", "kitchen_1")} & set(found.links)
    asked = {(r.kind, r.of, r.to) for r in found.requirements}
    assert asked == {("no_door", one.id, "kitchen_1") for one in found.rooms if one.type == room}


@pytest.mark.parametrize("prompt", ["Two bedrooms. No balcony off the living room.",
                                    "Two bedrooms with no balcony off the living room.",
                                    "Two bedrooms, no storage room off the living room, a study."])
def test_a_room_that_nobody_asked_for_and_nobody_wants_is_not_there(prompt: str) -> None:
    found = read(prompt)
    assert not {room.type for room in found.rooms} & {"balcony", "storage"} and found.requirements == []
    assert not [link for link in found.links if {"bedroom_1", "living_room_1"} == set(link)]


def test_each_of_some_rooms_gets_the_next_of_others_and_the_last_again() -> None:
    beds, baths = [Entity("bedroom") for _ in range(4)], [Entity("bathroom") for _ in range(3)]
    assert list(matched(beds, baths)) == [*zip(beds, baths), (beds[3], baths[2])]
    baths[0].owner = beds[1]
    others = [bed for bed in beds if bed is not beds[1]]
    assert list(matched(beds, baths)) == list(zip(others, [baths[1], baths[2], baths[2]]))


def test_of_rooms_as_large_as_another_the_main_one_is_the_largest() -> None:
    """And of others the one with the most or the least floor, wherever it is told."""
    plain, main = Entity("bedroom", area=12.0), Entity("bedroom", labels={Trait.MASTER}, area=12.0)
    assert _by_size("largest", [plain, main]) is main
    large = Entity("bedroom", area=14.0)
    assert _by_size("largest", [plain, large, main]) is large and _by_size("smallest", [large, main, plain]) is main
