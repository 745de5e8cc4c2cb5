"""Prompts that programs write: one home in every notation is one home, each field is read as meant, none breaks."""

import json
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from sentences.facts import as_meant, facts, rooms

from apartgen.schemas.errors import ApartgenError
from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.structured import in_sentences

FIELDS = [
    ('{"rooms": {"bedroom": 2, "bathroom": 1, "separate_toilet": 1, "balcony": 1}, "facing": {"living_room": '
     '"south_west", "bedroom_1": "north_east"}, "total_area": 77}', "B2 H K L W2 Y",
     "orientation L1 south_west, orientation B1 north_east, all=77"),
    ('{"bedrooms": [{"min_m2": 15, "ensuite": true}, {"min_m2": 11}, {"min_m2": 11}], "bathrooms": 2, "no_door": '
     '[["living_room", "kitchen"]]}', "B3 H K L W2",
     "at_least B1 15, at_least B2 11, at_least B3 11, B1W1, no_door L1 K1"),
    ('{"bedrooms": [{"name": "parents", "min_area": 14, "walk_in_closet": true}, {"name": "Mia", "furniture": '
     '{"single_bed": 1, "desk": 1}}, {"name": "Leo", "adjacent_to": "Mia"}], "bathrooms": 2, "dining_room": true}',
     "B3 C D H K L W2", "B1C1, B2 has 1 single_bed, B2 has 1 desk, adjacent B3 B2, at_least B1 14"),
    ('{"total_area_m2": 85, "bedrooms": 2, "other_rooms": ["living_room", "study"], "constraints": [{"room": "study", '
     '"near": "entrance"}, {"type": "opposite", "rooms": ["study", "bathroom"]}]}', "B2 H K L S W",
     "near S1 entrance, opposite S1 W1, all=85"),
    ('[{"room": "living_room", "furniture": ["corner_sofa", "bookshelf", "bookshelf"]}, {"room": "bedroom", '
     '"count": 2}, {"room": "bathroom", "next_to": "kitchen"}, {"room": "kitchen"}]', "B2 H K L W",
     "L1 has 1 corner_sofa, L1 has 2 bookshelf, adjacent W1 K1"),
    ("beds=1 baths=1 study=1 | study.near=entrance | bedroom.area>=14m2 | kitchen.area<=8m2 | "
     "living_room.facing=south_west", "B H K L S W",
     "near S1 entrance, at_least B1 14, at_most K1 8, orientation L1 south_west"),
    ("bedrooms: 1; bathrooms: 1; utility: adjacent to kitchen; kitchen.furniture: island x1, oven x1; home.area.max: "
     "62 m2", "B H K L U W", "adjacent U1 K1, K1 has 1 island, K1 has 1 oven, at_most home 62"),
    ("hallway: max 8 doors; storage: off hallway, min width 1.5 m; bedrooms: 2; bathrooms: 1; study: none",
     "B2 H K L T W", "at_most H1 doors 8, at_least T1 width 1.5"),
    ("n_bedrooms=1; balcony=yes; balcony_access=bedroom,living_room; kitchen_area=9; living_room_min_length=5.5; "
     "washing_machine=bathroom", "B H K L W Y",
     "B1Y1, L1Y1, K1=9, at_least L1 length 5.5, W1 has 1 washing_machine"),
    ("bedrooms: 2\nbathrooms: 1\nseparate wc: yes\nstudy: no\nkitchen: open to living room\n"
     "balcony: off living room, facing south-west\nmax total area: 70 sqm", "B2 H K L W2 Y",
     "K1~L1, orientation Y1 south_west, at_most home 70"),
    ("| room | m2 | notes |\n|---|---|---|\n| living | 24 | next to dining |\n| dining | 12 | table, 6 chairs |\n"
     "| kitchen | 10 | |\n| bedroom 1 | 15 | walk-in closet |\n| bedroom 2 | 11 | desk |\n"
     "| bathroom | 6 | opposite bedroom 2 |\n| hall | 8 | |", "B2 C D H K L W",
     "L1=24, B2=11, D1 has 6 chair, B2 has 1 desk, B1C1, opposite W1 B2"),
    ("flat:\n  bedrooms:\n    - name: master\n      ensuite: true\n      bed: double\n    - name: kids\n"
     "      beds: 2 single\n      near: master\n  bathrooms: 2\n  hallway:\n    min_width: 1.2\n", "B2 H K L W2",
     "B1W1, B1 has 1 double_bed, B2 has 2 single_bed, adjacent B2 B1, at_least H1 width 1.2"),
    ("bedrooms=4; bathrooms=2; ensuite=bedroom 2; bedroom 3 adjacent to bedroom 4; kitchen away from bedroom 1",
     "B4 H K L W2", "adjacent B3 B4, apart K1 B1"),
    ('{"bedrooms": 2, "balcony": true, "rooms": [{"name": "kitchen", "area": 10}, '
     '{"name": "bedroom 1", "faces": "south"}]}',
     "B2 H K L W Y", "K1=10, orientation B1 south"),
    ('{"rooms": ["living", "kitchen", "bed_a", "bed_b", "bath"], "constraints": [["bed_a", "far_from", "bed_b"], '
     '{"type": "max_area", "room": "bed_b", "value": 12}]}', "B2 H K L W", "apart B1 B2, at_most B2 12"),
    ('{"rooms": [{"type": "kitchen", "next_to": "dining"}, {"type": "dining"}, {"type": "bedroom", "count": 2}], '
     '"near_entrance": "kitchen"}', "B2 D H K L W", "near K1 entrance"),
    ('{"bedrooms": 2, "bathrooms": 1, "kitchen": {"open_to": "living_room", "min_area": 9, "max_area": 12}}',
     "B2 H K L W", "K1~L1, at_least K1 9, at_most K1 12"),
]  # fmt: skip

test_each_field_is_read_as_meant = as_meant(FIELDS)

HOMES: list[dict[str, Any]] = [
    {"bedrooms": 2, "bathrooms": 1, "study": 1, "total_area": 80},
    {"bedrooms": 3, "bathrooms": 2, "kitchen": "open to living room", "balcony": "off living room"},
    {"bedrooms": 1, "storage": "next to kitchen", "living_room": "facing south", "bathroom": "6 m2"},
    {"bedrooms": 2, "study": "near entrance", "hallway": "max 6 doors", "dining_room": 1},
]


@pytest.mark.parametrize("home", HOMES)
def test_one_home_in_every_notation_is_one_home(home: dict[str, Any]) -> None:
    notations = [
        json.dumps(home),
        json.dumps({"flat": home}),
        yaml.safe_dump({"flat": home}),
        "\n".join(f"{key}: {value}" for key, value in home.items()),
        "; ".join(f"{key}={value}" for key, value in home.items()),
        json.dumps(
            {"".join(w.title() if k else w for k, w in enumerate(key.split("_"))): v for key, v in home.items()}
        ),
    ]
    read_as = [(rooms(program := read(prompt)), facts(program)) for prompt in notations]
    assert read_as == [read_as[0]] * len(notations)


def test_sentences_stay_as_they_are() -> None:
    for prompt in ("A two-bedroom flat: kitchen at the back, bath off the hall.",
                   "Three of us: me, Tom and Priya.\nA room each, please: mine next to the bathroom.",
                   "Client brief: one bedroom; a study; the living room must face south."):  # fmt: skip
        assert in_sentences(prompt) == prompt


_NAMES = ("bedrooms", "bathroom", "kitchen", "rooms", "facing", "near", "furniture", "area", "min_m2", "no_door",
          "count", "ensuite", "constraints", "open_to", "home.area.max", "bedroom_1", "name", "bogus", "")  # fmt: skip
_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-3, 60) | st.floats() | st.text(max_size=8) | st.sampled_from(_NAMES),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(_NAMES), inner, max_size=3),
    max_leaves=8,
)


@given(st.dictionaries(st.sampled_from(_NAMES), _VALUES, max_size=4) | st.lists(_VALUES, max_size=3))
@settings(max_examples=150, deadline=None)
def test_whatever_stands_in_a_field_there_is_a_programme_or_a_clear_error(fields: Any) -> None:
    prompt = json.dumps(fields)
    try:
        assert read(prompt).rooms
    except ApartgenError as error:
        assert str(error)


def test_references_that_mean_a_huge_text_are_not_followed() -> None:
    bomb = "a: &a [bedroom, bedroom]\n" + "\n".join(
        f"{b}: &{b} [*{a}, *{a}]" for a, b in zip("abcdefgh", "bcdefghi", strict=True)
    )
    assert (
        in_sentences(f"rooms:\n  {bomb.replace(chr(10), chr(10) + '  ')}")
        == f"rooms:\n  {bomb.replace(chr(10), chr(10) + '  ')}"
    )
    deep = "[" * 3000 + "]" * 3000
    assert in_sentences(deep) == deep
