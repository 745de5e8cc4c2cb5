"""Numbers in words, halves, and areas that are stated."""

import pytest

from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.quantities import _joined


@pytest.mark.parametrize("text, total", [
    ("A flat of one hundred and twenty square metres with two bedrooms.", 120),
    ("A three-bedroom flat of a hundred and five square metres.", 105),
])
def test_hundreds_and_what_follows_are_one_number(text: str, total: float) -> None:
    assert sum(room.area or 0 for room in read(text).rooms) == pytest.approx(total, abs=0.1)


@pytest.mark.parametrize("tens", range(20, 100, 10))
def test_after_tens_only_what_is_less_than_ten_is_of_the_same_number(tens: int) -> None:
    """`twenty-one` to `ninety-nine`; `twenty ten` are two."""
    for more in range(1, 20):
        first, second = (Lexeme("number", "so", "so", values=(float(n),)) for n in (tens, more))
        assert _joined(first, "", second) == _joined(first, "-", second) == (tens + more if more < 10 else None)


@pytest.mark.parametrize("text, number", [
    ("Three bedrooms and two and a half bathrooms.", 3), ("House with 3 bedrooms and 2.5 baths.", 3),
    ("A two-bedroom flat with 1.5 bathrooms.", 2),
])
def test_half_a_bathroom_is_a_small_room_more(text: str, number: int) -> None:
    areas = sorted(room.area or 0 for room in read(text).rooms if room.type == "bathroom")
    assert len(areas) == number and areas[0] < 3 < areas[1]


def test_what_is_stated_stays_and_nothing_else_is_stated() -> None:
    areas = {room.type: room.area for room in read("One-bedroom flat, kitchen 12 m2, living room 25 m2.").rooms}
    assert (areas["kitchen"], areas["living_room"]) == (12.0, 25.0) and areas["bedroom"]


def test_from_a_hall_one_reaches_the_rooms_behind_it() -> None:
    links = read("One-bedroom flat. From the living room you reach the study and the bathroom.").links
    assert {frozenset(pair) for pair in links} >= {
        frozenset(("living_room_1", "study_1")), frozenset(("living_room_1", "bathroom_1"))}
