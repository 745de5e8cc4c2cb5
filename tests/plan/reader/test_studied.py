"""Studies that are research and no rooms, and desks and tables instead of rooms of their own."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    # research
    ("two-bedroom flat, HRI study", "B2 H K L W", "unread research"),
    ("In our study, a robot fetches things in a two-bedroom flat.", "B2 H K L W", "unread fetches"),
    ("Our study requires a one-bedroom apartment.", "B H K L W", "unread research"),
    ("The study compares two robots; give me a two-bedroom flat.", "B2 H K L W", "unread research"),
    ("Scene for perception studies: two bedrooms and a kitchen.", "B2 H K L W", "unread research"),
    ("Flat for research studies with 2 bedrooms and a study.", "B2 H K L S W", ""),
    ("Eine Wohnung mit zwei Schlafzimmern für eine Studie zur Navigation.", "B2 H K L W", "unread research"),
    ("Un piso de dos dormitorios para un estudio de interacción.", "B2 H K L W", "unread interaccion"),
    # rooms
    ("A flat for a study with a desk and two bedrooms.", "B2 H K L S W", "S1 has 1 desk"),
    ("Our study needs a desk; two bedrooms.", "B2 H K L S W", "S1 has 1 desk"),
    ("A two-bedroom flat; in the study, a desk and a bookcase.", "B2 H K L S W", "S1 has 1 desk"),
    ("Two bedrooms and a quiet study of 9 m2.", "B2 H K L S W", "S1=9"),
    ("Un estudio con balcón.", "K L W Y", ""),
    # no room of its own
    ("A one-bedroom flat with a desk in the bedroom in lieu of a study.", "B H K L W", "B1 has 1 desk"),
    ("One-bedroom flat, a workspace in the bedroom rather than an office.", "B H K L W", "B1 has 1 desk"),
    ("One-bedroom flat with a dining area in the living room as opposed to a separate dining room.", "B H K L W",
     "L1 has 1 dining_table"),
    ("Two bedrooms, I want a desk in the bedroom, not a separate study.", "B2 H K L W", "B1 has 1 desk"),
    ("一室一厅，在卧室放一张书桌，而不是单独的书房。", "B H K L W", "B1 has 1 desk"),
    ("一室一厅，卧室里放书桌，不要单独的书房。", "B H K L W", "B1 has 1 desk"),
    # one room instead of another
    ("Two bedrooms with a study instead of a dining room.", "B2 H K L S W", ""),
    ("Two bathrooms rather than one, two bedrooms.", "B2 H K L W2", ""),
]  # fmt: skip

test_such_rooms_are_not_planned = as_meant(SENTENCES)

APART = ("rather than a separate room", "instead of a separate room for it", "rather than in a room of its own",
         "in lieu of a dedicated room")  # fmt: skip


@pytest.mark.parametrize("apart", APART)
def test_a_room_apart_is_no_room(apart: str) -> None:
    program = read(f"A one-bedroom flat with a desk in the bedroom {apart}.")
    assert (len(program.rooms), program.unread) == (5, [])
