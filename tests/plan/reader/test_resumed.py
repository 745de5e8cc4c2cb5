"""Clauses that go on with a room named before: the other one, it has, none in, not off, so does, as is; and ways in."""

import pytest
from sentences.facts import as_meant, facts

from apartgen.stages.plan.reader import read

SENTENCES = [
    # the one and the other
    ("Two bedrooms. The one of 9 m² is for the twins, with two desks; the other one, 15 m², is ours. One bathroom.",
     "B2 H K L W", "B1=15, B2=9, B2 has 2 desk"),
    ("Two bedrooms. One, 14 m², is ours, the other, 10 m², is for the kids.", "B2 H K L W", "B1=14, B2=10"),
    ("Two bedrooms. The larger one is ours; the smaller one, 9 m², is for our son.", "B2 H K L W", "B2=9"),
    ("Two bathrooms. The one off the hall has a shower, the other one, 6 m², has a bathtub. Two bedrooms.",
     "B2 H K L W2", "H1W1, B1W2, W2=6"),
    ("Zwei Schlafzimmer. Das eine, 14 m², ist für uns, das andere, 10 m², für die Kinder.", "B2 H K L W",
     "B1=14, B2=10"),
    ("Deux chambres. L'une, de 14 m², est pour nous, l'autre, de 10 m², pour les enfants.", "B2 H K L W",
     "B1=14, B2=10"),
    ("She gets the bedroom with its own bathroom, we take the other bedroom and use the bathroom off the hall.",
     "B2 H K L W2", "B1W1, H1W2, B2H1"),
    ("A flat. Grandma has the bedroom next to the bathroom, the kids the other bedroom.", "B2 H K L W",
     "adjacent B1 W1"),
    # it has
    ("Three bedrooms. We sleep in third bedroom, it has bathroom inside. Other bathroom is in the corridor.",
     "B3 H K L W2", "B3W1, H1W2"),
    ("Two bedrooms. The second bedroom is big, it has a bathroom.", "B2 H K L W2", "B2W1, H1W2"),
    ("Two bedrooms. The second bedroom is big, and has a bathroom.", "B2 H K L W2", "B2W1, H1W2"),
    ("Three bedrooms. We sleep in the third bedroom. It has a balcony.", "B3 H K L W2 Y", "B3Y1"),
    ("The kitchen is large, it has a balcony. Two bedrooms.", "B2 H K L W Y", "K1Y1"),
    ("A flat with two bedrooms and a kitchen. It has a balcony.", "B2 H K L W Y", "L1Y1"),
    ("Two bedrooms. In the main bedroom there is a balcony.", "B2 H K L W Y", "B1Y1"),
    ("Two bedrooms. In the kitchen there is a table.", "B2 H K L W", ""),
    # that has, behind a way
    ("A two-bedroom flat with a utility room off the hall that has a washing machine in it.", "B2 H K L U W",
     "U1 has 1 washing_machine, !H1 has 1 washing_machine"),
    ("A study next to the kitchen which contains a sofa and a desk. Two bedrooms.", "B2 H K L S W",
     "S1 has 1 sofa, S1 has 1 desk, adjacent S1 K1"),
    # none in
    ("Two-bedroom apartment, a rug in the living room and one in each bedroom, but none in the kitchen.", "B2 H K L W",
     "L1 has 1 rug, B1 has 1 rug, B2 has 1 rug, K1 has 0 rug"),
    ("Two bedrooms. A mirror in the hall, none in the bathroom.", "B2 H K L W", "H1 has 1 mirror, W1 has 0 mirror"),
    ("Zwei Schlafzimmer, ein Teppich im Wohnzimmer, aber keiner in der Küche.", "B2 H K L W", "K1 has 0 rug"),
    ("Deux chambres, un tapis dans le salon, mais aucun dans la cuisine.", "B2 H K L W", "K1 has 0 rug"),
    ("Dos dormitorios, una alfombra en el salón, pero ninguna en la cocina.", "B2 H K L W", "K1 has 0 rug"),
    # a contrast asks for no more than where the door is
    ("One-bedroom flat. The balcony is off the bedroom, not off the living room.", "B H K L W Y",
     "B1Y1, !no_door Y1 L1, !L1Y1"),
    ("Two bedrooms. The study opens off the living room, not the hall.", "B2 H K L S W", "L1S1, !no_door S1 H1, !H1S1"),
    ("Le balcon donne sur la chambre, pas sur le salon. Un appartement.", "B H K L W Y", "B1Y1, !L1Y1"),
    ("El balcón da al dormitorio, no al salón. Un piso.", "B H K L W Y", "B1Y1, !L1Y1"),
    ("The utility room is reached from the kitchen and not from the hall. Two bedrooms.", "B2 H K L U W",
     "K1U1, no_door U1 H1"),
    ("Two bedrooms. The study is next to the kitchen, not next to the bathroom.", "B2 H K L S W", "apart S1 W1"),
    # so does, as is
    ("One-bedroom flat. I need a study; my husband does too.", "B H K L S2 W", ""),
    ("One-bedroom flat. I need a study, and so does my wife.", "B H K L S2 W", ""),
    ("One-bedroom flat. My wife needs a study and I need one too.", "B H K L S2 W", ""),
    ("Two bedrooms. The living room is 20 m², as is the study.", "B2 H K L S W", "L1=20, S1=20"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

WAYS = {
    "S1": ["Two bedrooms. Entry to the study is through the living room.",
           "Two bedrooms. One goes into the study through the living room.",
           "Two bedrooms. The way into the study is through the living room.",
           "Zwei Schlafzimmer. Man betritt das Arbeitszimmer durch das Wohnzimmer.",
           "Zwei Schlafzimmer. In das Arbeitszimmer kommt man über das Wohnzimmer.",
           "Zwei Schlafzimmer. Der Zugang zum Arbeitszimmer erfolgt durch das Wohnzimmer.",
           "Deux chambres. On entre dans le bureau par le salon.",
           "Deux chambres. L'accès au bureau se fait par le salon.",
           "Dos dormitorios. Al despacho se entra por el salón.",
           "Dos dormitorios. Se accede al despacho desde el salón.",
           "两间卧室，进书房要经过客厅"],
    "Y1": ["Zwei Schlafzimmer. Den Balkon betritt man nur durch das Wohnzimmer.",
           "Deux chambres. On sort sur le balcon par le salon.", "Dos dormitorios. A la terraza se sale por el salón."],
}  # fmt: skip


@pytest.mark.parametrize(("room", "prompt"), [(r, p) for r, several in WAYS.items() for p in several])
def test_a_room_has_its_door_where_one_comes_in(room: str, prompt: str) -> None:
    program = read(prompt)
    doors = {fact for fact in facts(program) if room in fact and len(fact) == 4 and "=" not in fact}
    assert doors == {f"L1{room}"} and not program.unread
