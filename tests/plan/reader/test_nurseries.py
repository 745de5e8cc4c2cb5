"""In which bedrooms children sleep."""

import pytest

from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("prompt, children", [
    ("Flat for a family of four.", [None, 1, 1]), ("Flat for a family of five.", [None, 1, 1, 1]),
    ("Flat for a couple with two kids who share a room.", [None, 2]),
    ("Familie mit zwei Kindern, die sich ein Zimmer teilen.", [None, 2]),
    ("Flat with a parents' bedroom and a children's room.", [None, 1]),
    ("Wohnung mit Elternschlafzimmer und zwei Kinderzimmern.", [None, 1, 1]),
    ("Flat for parents and three children; the two girls share a room, the boy has his own.", [None, 2, 1]),
    ("Flat for a couple, their child and grandma.", [None, None, 1]),
    ("Two-bedroom flat.", [None, None]), ("Flat for a couple and a friend.", [None, None]),
])
def test_children_sleep_where_it_is_told(prompt: str, children: list[int | None]) -> None:
    rooms = [room for room in read(prompt).rooms if room.type == "bedroom"]
    assert sorted((room.children for room in rooms), key=str) == sorted(children, key=str)
    assert rooms[0].children is None


def test_where_nobody_is_known_to_sleep_nothing_is_written() -> None:
    rows = read("Flat with a parents' bedroom and a children's room.").model_dump(mode="json")["rooms"]
    assert [row["id"] for row in rows if "children" in row] == ["bedroom_2"]
