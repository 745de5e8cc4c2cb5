"""Rooms between two others, rooms that one enters first, toilets apart, odd prepositions of learners."""

import pytest
from sentences.facts import as_meant, rooms

from apartgen.stages.plan.reader import read

SENTENCES = [
    # between
    ("Two bedrooms and in between them a bathroom.", "B2 H K L W", "B1W1, B2W1"),
    ("Two bedrooms and, sandwiched between them, the bathroom.", "B2 H K L W", "B1W1, B2W1"),
    ("Two bedrooms with a bathroom in the middle between them.", "B2 H K L W", "B1W1, B2W1, !position W1 centre"),
    ("Kitchen, living room, and between them a dining room; two bedrooms.", "B2 D H K L W", "D1K1, D1L1"),
    ("Zwei Schlafzimmer, dazwischen das Bad.", "B2 H K L W", "B1W1, B2W1"),
    ("Deux chambres et, entre elles, une salle de bain.", "B2 H K L W", "B1W1, B2W1"),
    ("Dos dormitorios con el baño en medio.", "B2 H K L W", "B1W1, B2W1"),
    ("两间卧室，中间是卫生间。", "B2 H K L W", "B1W1, B2W1"),
    # odd prepositions
    ("Two bedrooms, balcony at the big bedroom.", "B2 H K L W Y", "B1Y1, !L1Y1"),
    ("Three bedrooms, balcony for the large bedroom.", "B3 H K L W2 Y", "B1Y1"),
    ("Two bedrooms, bath is at big bedroom.", "B2 H K L W2", "B1W1"),
    ("Two bedrooms and desk into kids room.", "B2 H K L W", "B2 has 1 desk"),
    ("Two bedrooms, wardrobe at small bedroom.", "B2 H K L W", "B2 has 1 wardrobe"),
    ("In kids room is bunk bed. Two bedrooms.", "B2 H K L W", "B2 has 1 bunk_bed"),
    ("Two bedrooms, toilet next of entrance.", "B2 H K L W2", "near W1 entrance"),
    ("Deux chambres, balcon à la grande chambre.", "B2 H K L W Y", "B1Y1"),
    ("两室，阳台在大卧室。", "B2 H K L W Y", "B1Y1"),
    # in usual words
    ("Two bedrooms, balcony by the main bedroom.", "B2 H K L W Y", "adjacent Y1 B1"),
    ("Two bedrooms, a rug on the bedroom floor.", "B2 H K L W", "B1 has 1 rug"),
    # through which room one enters
    ("One bedroom; you enter through the kitchen.", "B K L W", "near K1 entrance"),
    ("Two bedrooms, entry is through the kitchen.", "B2 K L W", "near K1 entrance"),
    ("Two bedrooms; behind the front door is the kitchen.", "B2 K L W", "near K1 entrance"),
    ("Two bedrooms. From the front door you step into the living room.", "B2 K L W", "B1L1"),
    ("Two bedrooms and a hallway; the front door opens into the living room.", "B2 H K L W", "near L1 entrance"),
    ("Dos dormitorios; se entra por la cocina.", "B2 K L W", "near K1 entrance"),
    ("Un piso de dos dormitorios, la entrada da al salón.", "B2 K L W", "B1L1"),
    ("Dos dormitorios; la cocina da al salón.", "B2 H K L W", "K1L1"),
    ("Deux chambres, on entre par la cuisine.", "B2 K L W", "near K1 entrance"),
    ("Zwei Schlafzimmer, der Eingang führt in die Küche.", "B2 K L W", "near K1 entrance"),
    ("两室，从厨房进门。", "B2 K L W", "near K1 entrance"),
    # of other rooms
    ("Two bedrooms; the pantry is entered through the kitchen.", "B2 H K L T W", "K1T1, !near K1 entrance"),
    ("Al lavadero se entra por la cocina; dos dormitorios.", "B2 H K L U W", "K1U1, !near K1 entrance"),
    ("Two bedrooms, you enter the kitchen through the living room.", "B2 H K L W", "K1L1, !near K1 entrance"),
]  # fmt: skip

test_places_are_as_meant = as_meant(SENTENCES)

APART = ("a shower room apart from the toilet", "separate toilet and shower", "shower and WC in separate rooms",
         "the toilet should be separate from the shower", "Dusche und Toilette getrennt", "douche et WC séparés")
BATHS = ("toilet and bath apart", "one bathroom with toilet apart", "a split bathroom (toilet apart)",
         "toilet not in the bathroom but on its own", "Bad mit separatem WC", "baño con el inodoro aparte",
         "with bathroom & toilet separated")  # fmt: skip


@pytest.mark.parametrize("said", [*APART, *BATHS])
def test_toilets_apart_are_rooms(said: str) -> None:
    program = read(f"Two bedrooms, {said}.")
    areas = [room.area for room in program.rooms if room.type == "bathroom"]
    assert (rooms(program), areas, program.unread) == ("B2 H K L W2", [3.6 if said in APART else 5.0, 2.3], [])
