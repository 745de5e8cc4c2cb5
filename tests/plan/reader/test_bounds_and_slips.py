"""How large and how many rooms may be, slips of five letters, and ratios below one."""

import time

import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("sign", ["a", "Ü", "7"])
def test_a_word_without_end_is_read_in_no_time(sign: str) -> None:
    """It is told as not understood, in part; at each of its letters patterns looked through all that follows."""
    start = time.process_time()
    program = read("two-bedroom flat " + sign * 7900 + " with a balcony")
    assert time.process_time() - start < 4
    assert [room.type for room in program.rooms].count("balcony") == 1 and sign * 4 in str(program.unread)


@pytest.mark.parametrize("text, fine", [
    ("One-bedroom flat with a storage room of 0.4 m².", False),
    ("One-bedroom flat with a storage room of 0.6 m².", True),
    ("A studio of 4.9 m².", False), ("A studio of 5 m².", True), ("A house of 2000 m² with nine bedrooms.", True),
    ("A house of 2001 m² with nine bedrooms.", False), ("A house with 41 bedrooms.", False), ("", False), (" ", False),
    ("two-bedroom flat " + "a" * 7983, True), ("two-bedroom flat " + "a" * 7984, False),
])
def test_what_no_home_has_is_refused(text: str, fine: bool) -> None:
    if fine:
        assert read(text).rooms
    else:
        with pytest.raises(BadInput):
            read(text)


def test_how_many_rooms_were_asked_for_is_said() -> None:
    with pytest.raises(BadInput, match="asks for 90 rooms"):
        read("A house with 90 bedrooms.")


@pytest.mark.parametrize("word, kind", [("stduy", "study"), ("kitchn", "kitchen"), ("balcny", "balcony"),
                                        ("utilty room", "utility"), ("dinning room", "dining_room")])
def test_a_slip_in_a_word_is_read(word: str, kind: str) -> None:
    program = read(f"A one-bedroom flat with a {word}.")
    assert kind in {room.type for room in program.rooms} and program.unread == []


@pytest.mark.parametrize("words, ratio", [
    ("half as large as", 0.5), ("twice as large as", 2.0), ("three times as large as", 3.0), ("as large as", 1.0),
    ("20 % smaller than", 0.8), ("25 % larger than", 1.25),
])
def test_rooms_are_in_the_ratio_that_is_said(words: str, ratio: float) -> None:
    areas = {r.id: r.area or 0 for r in read(f"One-bedroom flat, the bedroom {words} the kitchen.").rooms}
    assert areas["bedroom_1"] / areas["kitchen_1"] == pytest.approx(ratio, abs=0.01)


def test_a_bedroom_among_others_is_the_one_named() -> None:
    program = read("Bedroom, guest room, living room and kitchen; the bedroom has a balcony.")
    assert sum(room.type == "bedroom" for room in program.rooms) == 2
    assert [room.private_to for room in program.rooms if room.type == "balcony"] == ["bedroom_1"]
