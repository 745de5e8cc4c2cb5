"""What is said once and meant of more: of two rooms, of a room named before, of one counted too high."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read

SENTENCES = [
    # both of a pair behind a way that ends in the room before the comma
    ("Two bedrooms and a bath along a long corridor, kitchen and living room near the entrance.", "B2 H K L W",
     "near K1 entrance, near L1 entrance"),
    ("Two bedrooms and a bath off a narrow corridor, study and kitchen close to the entrance.", "B2 H K L S W",
     "near K1 entrance, near S1 entrance"),
    ("Three bedrooms and a bathroom along a wide hallway, dining room and kitchen far from the entrance.",
     "B3 D H K L W", "apart D1 entrance, apart K1 entrance"),
    ("Two bedrooms, bathroom and kitchen, study near the entrance.", "B2 H K L S W",
     "near S1 entrance, !near K1 entrance"),
    # the verb of the first, of the second too
    ("One bedroom. Living room should look to west and the bedroom to east.", "B L",
     "orientation L1 west, orientation B1 east"),
    ("The living room faces to the south, the bedroom to the north.", "B L",
     "orientation L1 south, orientation B1 north"),
    ("One bedroom. The lounge is facing west, and the bedroom to the east.", "B L",
     "orientation L1 west, orientation B1 east"),
    ("One bedroom. The lounge is facing west, and the bedroom is to the east.", "B L",
     "orientation L1 west, position B1 east"),
    # a home that needs no room
    ("2 bedrooms of 12 m2, the living room of 24 m², and it doesn't need hallway.", "B2 K L W", "B1=12, B2=12, L1=24"),
    ("Two bedrooms, and we won't need hallway.", "B2 K L W", ""),
    ("Two bedrooms. It doesn't need to have a corridor.", "B2 K L W", ""),
    ("Two bedrooms. The flat does not require a hallway.", "B2 K L W", ""),
    ("Two bedrooms. The bathroom doesn't need a bathtub.", "B2 H K L W", "W1 has 0 bath"),
    # a number that is enough
    ("First I wanted three bedrooms, but two are enough. One bathroom.", "B2 H K L W", ""),
    ("I thought about two bathrooms, but one is enough. Three bedrooms.", "B3 H K L W", ""),
    ("Four bedrooms; actually, three bedrooms would be enough. Two bathrooms.", "B3 H K L W2", ""),
    ("A house with three bathrooms, no, two will do, and four bedrooms.", "B4 H K L W2", ""),
    ("A two-bedroom flat at first, but one bedroom is sufficient.", "B H K L W", ""),
    ("Four bedrooms, two bathrooms, and one bathroom is enough for the children.", "B4 H K L W2", ""),
    ("Two bedrooms. One bathroom is enough.", "B2 H K L W", ""),
    ("Three bedrooms, and one bathroom will do.", "B3 H K L W", ""),
    # a room named before, behind whose name something is denied
    ("One bedroom, living room 22 m2, bathroom 4.5 m2; bathroom without a bathtub", "B H K L W",
     "W1=4.5, W1 has 0 bath"),
    ("Two bedrooms, kitchen, bathroom. Bathroom without bathtub.", "B2 H K L W", "W1 has 0 bath"),
    ("Two bedrooms. One bathroom. Bathroom without a tub.", "B2 H K L W", "W1 has 0 bath"),
    ("Kitchen 10 m2, bedroom 12 m2; kitchen without a table.", "B K", "K1 has 0 dining_table"),
    ("Two bedrooms. Bathroom with a bathtub; bathroom without a bathtub.", "B2 H K L W2", "W1 has 1 bath"),
    # for whom a home is
    ("A cramped studio for the hacker character: single bed and desk in the main room.", "K L W", "!L1 has 1 stool"),
    ("An apartment for a hacker, two bedrooms and a bath.", "B2 H K L W", "!L1 has 1 stool"),
    ("A house for the hacker with one bedroom and a wardorbe in it.", "B H K L W",
     "B1 has 1 wardrobe, !L1 has 1 stool"),
    # two children's rooms that share
    ("The parents' bedroom has its own bathroom. There is a room for the daughter and a room for the son, and they "
     "share a second bathroom off the hall.", "B3 H K L W2", "B1W1, H1W2, B2H1, B3H1"),
    ("The parents' bedroom has its own bathroom. A room for my girl and a room for my boy are off the hall.",
     "B3 H K L W2", "B1W1, B2H1, B3H1"),
    ("A main bedroom with ensuite. A room for the daughter and a room for the son share a bathroom.", "B3 H K L W2",
     "B1W1"),
    # a room that becomes one more of a type
    ("Make it a one-bed with a study. Actually, make the study a second bedroom.", "B2 H K L W", ""),
    ("One bedroom and a study. Make the study a second bedroom.", "B2 H K L W", ""),
    ("One bedroom, one bathroom, a study. Make the study a bedroom.", "B2 H K L W", ""),
    ("A two-bedroom flat with a study and a balcony. No, make the study a third bedroom.", "B3 H K L W2 Y", ""),
    ("Two bedrooms, a study. Make the study a dining room.", "B2 D H K L W", ""),
    # likewise
    ("Two bedrooms, a study and a bathroom off the corridor, likewise the living room; the kitchen is entered through "
     "the dining room.", "B2 D H K L S W", "H1L1, H1S1"),
    ("Two bedrooms. The study opens off the living room, likewise the kitchen.", "B2 H K L S W", "L1S1, K1L1"),
    ("Two bedrooms. The pantry is next to the kitchen. The same goes for the study.", "B2 H K L S T W",
     "adjacent T1 K1, adjacent S1 K1"),
    ("Two bedrooms. The pantry opens off the kitchen; the same for the study.", "B2 H K L S T W", "K1T1, K1S1"),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "wanted", "told"), SENTENCES)
def test_the_programme_is_as_meant(prompt: str, wanted: str, told: str) -> None:
    program = read(prompt)
    assert rooms(program) == wanted
    said = facts(program)
    entries = [entry for entry in told.split(", ") if entry]
    assert {entry for entry in entries if entry[0] != "!"} <= said
    assert not {entry[1:] for entry in entries if entry[0] == "!"} & said
