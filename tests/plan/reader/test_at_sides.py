"""Where rooms are, as people say it: `center east of the property`, `at north side of the house`, `lower left`."""

import pytest

from apartgen.stages.plan.reader import read

ROOMS = "Living room, kitchen, bathroom, common room and master room. "
PLACES = [
    ("The bathroom is located on the center west of the property.", "west"),
    ("The bathroom is in the center on the south side of the floor plan.", "south"),
    ("Bathroom is central but on the western edge of the floor plan.", "west"),
    ("The bathroom is at north centre side of the house.", "north"),
    ("The bathroom is on the center-east side of the house.", "east"),
    ("Bathroom located center east of the property.", "east"),
    ("The bathroom is located on exact center of the north side.", "north"),
    ("Bathroom is located at center of the northern part of the plan.", "north"),
    ("The bathroom is in the middle of the eastern wall.", "east"),
    ("The bathroom is on the left hand center.", "left"),
    ("The bathroom is mid-west.", "west"),
    ("The bathroom is at north side of the house.", "north"),
    ("The bathroom is on the south side of the floor plan.", "south"),
    ("The bathroom is on the west of the property.", "west"),
    ("The bathroom is on the far left of the home.", "left"),
    ("The bathroom is at north west corner of the house.", "north_west"),
    ("The bathroom is on the lower left of the image.", "south_west"),
    ("The bathroom is in the top left corner of the flat.", "north_west"),
    ("The bathroom is in the upper right hand side of the plan.", "north_east"),
    ("The bathroom: bottom left.", "south_west"),
    ("The bathroom is on the rear of the house.", "back"),
    ("The bathroom is in the center of the house.", "centre"),
    ("The bathroom is in the north east of the home.", "north_east"),
]
BESIDE = [
    (ROOMS + "The bathroom is south west of the living room.", "south_west", "living_room_1"),
    (ROOMS + "The bathroom lies to the north-east of the kitchen.", "north_east", "kitchen_1"),
    (ROOMS + "The bathroom is to the lower left of the living room.", "south_west", "living_room_1"),
    ("Wohnung mit zwei Schlafzimmern. Das Bad liegt nordöstlich der Küche.", "north_east", "kitchen_1"),
    ("Piso de dos dormitorios. El baño está al noreste de la cocina.", "north_east", "kitchen_1"),
    ("Piso de dos dormitorios. El baño está al este de la cocina.", "east", "kitchen_1"),
    ("Appartement deux chambres. La salle de bain est au nord de la cuisine.", "north", "kitchen_1"),
    ("Appartement deux chambres. La salle de bain est à l'ouest du salon.", "west", "living_room_1"),
    ("Appartement deux chambres. La salle de bain est au sud-ouest du salon.", "south_west", "living_room_1"),
]
OF_THE_HOME = [
    ("Wohnung mit zwei Schlafzimmern. Das Bad liegt im Norden der Wohnung.", "north"),
    ("Piso de dos dormitorios. El baño está al norte del piso.", "north"),
    ("Appartement deux chambres. La salle de bain est à l'ouest de l'appartement.", "west"),
]


@pytest.mark.parametrize(("said", "value"), [(ROOMS + said, value) for said, value in PLACES] + OF_THE_HOME)
def test_a_room_is_at_that_side_of_the_home(said: str, value: str) -> None:
    program = read(said)
    asked = [(r.of, r.value, r.to) for r in program.requirements if r.kind == "position"]
    assert asked == [("bathroom_1", value, None)]
    assert not program.unread


@pytest.mark.parametrize(("said", "value", "other"), BESIDE)
def test_a_room_is_at_that_side_of_another(said: str, value: str, other: str) -> None:
    program = read(said)
    assert [(r.value, r.to) for r in program.requirements if r.of == "bathroom_1"] == [(value, other)]
    assert not [r for r in program.requirements if r.of == "living_room_1"] and not program.unread
