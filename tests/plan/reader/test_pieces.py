"""Words for rooms, numbers and people that one form of sentence knows are known to the others."""

import re

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader.pieces import WORDS, reworded, rules

ALIKE = [
    ("Two bedrooms and a loggia. I want to pass out on it from the kitchen.", "B2 H K L W Y", "K1Y1, !L1Y1"),
    ("Two bedrooms, a passageway with the kitchen, the bathroom and the living room all opening off it.",
     "B2 H K L W", "H1K1, H1W1, H1L1"),
    ("The utility room and the pantry have 8 m² in total. Two bedrooms.", "B2 H K L T U W", "!all=8"),
    ("The kitchen and the family room share 32 m². Two bedrooms.", "B2 H K L W", "!all=32"),
    ("Three bedrooms. The family room should be the biggest, then the kitchen, then the study.", "B3 H K L S W2",
     "order L1 largest, order L1 K1 larger, order K1 S1 larger"),
    ("Two bedrooms, a study. Only one door to the family room.", "B2 H K L S W", "at_most L1 doors 1"),
    ("Two bedrooms and a study; the kids' room faces south, and so does the family room.", "B2 H K L S W",
     "orientation L1 south, orientation B2 south"),
    ("Two bedrooms; nobody passes into a bathroom from the bedroom.", "B2 H K L W", "!unread passes"),
    ("Four bedrooms: one for us, one for grandpa and one for each of the twins. One bathroom.", "B4 H K L W",
     "!unread twins"),
]


@pytest.mark.parametrize("name", WORDS)
def test_pieces_take_no_group_of_a_pattern(name):
    assert re.compile(WORDS[name]).groups == 0


def test_a_rule_has_the_pieces_and_its_own_words():
    said = rules([(r"\b{number} {kind}s? {near} {the}{end}", "found")], near="beside")
    assert reworded("three small bedrooms beside the home office", said) == "found"
    assert reworded("three small bedrooms under the home office", said).startswith("three")


test_what_one_form_knows_the_others_know = as_meant(ALIKE)
