"""Places that head their rooms, rooms said anew under another name or number, and what `it` is of a way."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read

SENTENCES = [
    # places that head a list
    ("The flat has two bedrooms. On the north side: kitchen and bathroom. On the south side: living room and both "
     "bedrooms.", "B2 H K L W", "position K1 north, position W1 north, position L1 south, position B2 south"),
    ("North: kitchen, bathroom; south: living room, bedroom.", "B H K L W", "position W1 north, position B1 south"),
    ("Left: kitchen, bathroom. Right: bedroom, living room.", "B H K L W", "position K1 left, position L1 right"),
    # another room in the place of one
    ("One bedroom, a bathroom and a storage room. No wait, make the storage room a utility room.", "B H K L U W", ""),
    ("Two bedrooms and a pantry off the kitchen. Actually, change the pantry to a laundry room.", "B2 H K L U W",
     "K1U1"),
    ("Three bedrooms, living room and kitchen. Turn the third bedroom into a study.", "B2 H K L S W", ""),
    # another number
    ("two bedrooms, actually three, but one bathroom is enough.", "B3 H K L W", ""),
    ("Two bedrooms and one bathroom. Scratch that, two bathrooms.", "B2 H K L W2", ""),
    ("One bathroom. Two bedrooms, sorry, three.", "B3 H K L W", ""),
    ("I need actually three bedrooms and two bathrooms", "B3 H K L W2", ""),
    # a study that is work and no room
    ("For a rearrangement study: 3 bedrooms, one shared bathroom", "B3 H K L W", ""),
    ("A flat for a fetch study. Two bedrooms and a study.", "B2 H K L S W", ""),
    # doors
    ("Two bedrooms, kitchen, dining room, living room. The dining room lies between the kitchen and the living room, "
     "and there is no door between the kitchen and the hallway.", "B2 D H K L W", "D1K1, D1L1, !K1L1, !H1K1"),
    ("Living room, kitchen, two bedrooms and bathroom, with no more than five doors off the hallway.", "B2 H K L W",
     "at_most H1 doors 5"),
    ("You come in the corridor; from the corridor you go to two bedrooms and the bathroom; at the end of the corridor "
     "is the living room, and from it you go to the kitchen.", "B2 H K L W", "K1L1, H1L1, !H1K1"),
    ("Piso de dos dormitorios con cocina abierta al salón, un baño y una terraza en el dormitorio principal.",
     "B2 H K L W Y", "B1Y1, H1W1, !L1Y1"),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "wanted", "told"), SENTENCES)
def test_the_programme_is_as_meant(prompt: str, wanted: str, told: str) -> None:
    program = read(prompt)
    assert rooms(program) == wanted
    said = facts(program)
    entries = [entry for entry in told.split(", ") if entry]
    assert {entry for entry in entries if entry[0] != "!"} <= said
    assert not {entry[1:] for entry in entries if entry[0] == "!"} & said
