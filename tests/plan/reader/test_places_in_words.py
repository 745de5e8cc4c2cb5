"""Places as people may put them, drawn at random from what stands for each: all are asked for, nothing is unread."""

import numpy as np
import pytest

from apartgen.stages.plan.reader import read

HOMES = ("Two-bedroom flat. ", "Living room, kitchen, bathroom and two bedrooms. ",
         "A home with a living room, a kitchen, two bedrooms and one bathroom. ")  # fmt: skip
VERBS = ("is", "lies", "is located", "is situated", "should be", "must be", "goes", "sits", "")
OF = ("", "of the house", "of the home", "of the flat", "of the apartment", "of the property", "of the plan",
      "of the floor plan", "of the building", "of the unit", "of the layout")  # fmt: skip
ROOMS = {"the kitchen": "kitchen_1", "the living room": "living_room_1", "kitchen": "kitchen_1"}
SIDES = {
    "north": "north", "northern": "north", "far north": "north", "south": "south", "east": "east", "eastern": "east",
    "western": "west", "left": "left west", "left hand": "left west", "right": "right east", "top": "top north",
    "upper": "top north", "bottom": "bottom south", "lower": "bottom south", "front": "front", "back": "back",
    "rear": "back",
}  # fmt: skip
CORNERS = {"north east": "north_east", "north-west": "north_west", "southeast": "south_east",
           "southwestern": "south_west", "top left": "north_west", "lower right": "south_east"}  # fmt: skip


def _place(rng: np.random.Generator) -> tuple[str, str]:
    at = str(rng.choice(["in the", "on the", "at the"]))
    if rng.random() < 0.3:
        corner = str(rng.choice(list(CORNERS)))
        return f"{at} {corner} corner", CORNERS[corner]
    side = str(rng.choice(list(SIDES)))
    return f"{at} {side} {rng.choice(['side', 'part', 'end', 'half'])}", SIDES[side]


@pytest.mark.wide
def test_a_place_is_asked_for_in_whatever_words_it_is_said() -> None:
    rng = np.random.default_rng(160400)
    wrong = []
    for _ in range(300):
        place, values = _place(rng)
        room, verb, of, home = (str(rng.choice(list(some))) for some in (ROOMS, VERBS, OF, HOMES))
        said = " ".join(part for part in (room, verb, place, of) if part)
        program = read(f"{home}{said[0].upper()}{said[1:]}.")
        asked = [(r.of, r.value in values.split(), r.to) for r in program.requirements if r.kind == "position"]
        if asked != [(ROOMS[room], True, None)] or program.unread:
            wrong.append((home + said, asked, program.unread))
    assert not wrong


def test_a_side_of_another_room_is_asked_for_in_whatever_words_it_is_said() -> None:
    rng = np.random.default_rng(160401)
    wrong = []
    for _ in range(200):
        side = str(rng.choice([*"north south east west left right".split(), "north east", "southwest", "north-west"]))
        said = rng.choice(["{} of", "to the {} of", "on the {} side of"])
        verb, home = rng.choice(["is", "lies", "is located", "should be", "must be", "sits"]), str(rng.choice(HOMES))
        text = f"{home}The kitchen {verb} {str(said).format(side)} the living room."
        program = read(text)
        value = {"southwest": "south_west"}.get(side, side.replace(" ", "_").replace("-", "_"))
        asked = [(r.of, r.value, r.to) for r in program.requirements]
        if asked != [("kitchen_1", value, "living_room_1")] or program.unread:
            wrong.append((text, asked, program.unread))
    assert not wrong
