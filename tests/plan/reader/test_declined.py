"""Rooms that nobody is to plan, homes only thought of, and words that are no rooms."""

from sentences.facts import as_meant

NONE = [
    ("Don't give us a guest room. One bedroom with two single beds.", "B H K L W", "B1 has 2 single_bed"),
    ("Please do not include a study, a balcony or a dining room. Two bedrooms.", "B2 H K L W", ""),
    ("Don't add a second bathroom. Three bedrooms.", "B3 H K L W", ""),
    ("Don't bother with a balcony, two bedrooms.", "B2 H K L W", ""),
    ("Two bedrooms; no need to add a dining room.", "B2 H K L W", ""),
    ("Never mind a guest room. One bedroom.", "B H K L W", ""),
    ("Spare us the dining room. Two bedrooms.", "B2 H K L W", ""),
    ("Three bedrooms. The user does not want a second bathroom.", "B3 H K L W", ""),
    ("Two bedrooms. My wife doesn't want a dining room or a balcony.", "B2 H K L W", ""),
    ("Two bedrooms. Nobody needs a study.", "B2 H K L W", ""),
    ("Three bedrooms. A second bathroom is not wanted.", "B3 H K L W", ""),
    ("He does not like open kitchens. Two bedrooms.", "B2 H K L W", "H1K1, !K1~L1"),
    ("Strike the study from our last list. What stays is two bedrooms and a pantry off the kitchen.", "B2 H K L T W",
     "K1T1"),
    ("Two bedrooms, a study, a balcony. Take the study off the list.", "B2 H K L W Y", ""),
    ("Bitte plant kein Arbeitszimmer ein. Zwei Schlafzimmer.", "B2 H K L W", "!L1 has 1 plant"),
    ("No nos pongas terraza. Dos dormitorios.", "B2 H K L W", ""),
    ("No incluyas un despacho. Dos dormitorios.", "B2 H K L W", ""),
    # what is said is not to be left out
    ("Two bedrooms. Don't forget the balcony.", "B2 H K L W Y", ""),
    ("Deux chambres. N'oubliez pas le balcon.", "B2 H K L W Y", ""),
    ("Zwei Schlafzimmer. Vergesst nicht den Balkon.", "B2 H K L W Y", ""),
    ("Dos dormitorios. No olvides la terraza.", "B2 H K L W Y", ""),
    ("两室一厅，别忘了阳台。", "B2 H K L W Y", ""),
    ("We don't want a door between the kitchen and the living room. Two bedrooms.", "B2 H K L W", "no_door K1 L1"),
    ("Two bedrooms. Don't put the kitchen next to the bathroom.", "B2 H K L W", "apart K1 W1"),
    ("Two bedrooms. Don't put a sofa in the kitchen.", "B2 H K L W", "K1 has 0 sofa"),
    ("Don't add a balcony, a second bathroom is enough. Two bedrooms.", "B2 H K L W2", ""),
]  # fmt: skip

test_nobody_gets_what_is_declined = as_meant(NONE)

THOUGHT_OF = [
    ("We thought of a studio, but no: a one-bedroom flat with a storage room.", "B H K L T W", "B1H1"),
    ("First I wanted a studio, but now I need a one-bedroom flat.", "B H K L W", "B1H1"),
    ("We considered a studio; in the end a two-bedroom flat, please.", "B2 H K L W", "B1H1"),
    ("A studio would be too small; a one-bedroom flat, please.", "B H K L W", "B1H1"),
    ("Studio? No, a one-bedroom flat.", "B H K L W", "B1H1"),
    ("We live in a studio now and want a two-bedroom flat.", "B2 H K L W", "B1H1"),
    ("I don't want a studio, I want two bedrooms.", "B2 H K L W", "B1H1"),
    ("We were thinking about a house, but no, a studio of 30 m².", "K L W", "K1~L1"),
    ("Erst dachten wir an ein Studio, aber nein: eine Zweizimmerwohnung.", "B H K L W", "B1H1"),
    ("On pensait à un studio, mais non : un appartement avec une chambre.", "B H K L W", "B1H1"),
    ("Pensábamos en un estudio, pero no: un piso de un dormitorio.", "B H K L W", "B1H1"),
    ("我们想过开间，但还是要一室一厅。", "B H K L W", "B1H1"),
    # no rooms
    ("A grandmother is living with us. Two bedrooms, a kitchen, a living room.", "B2 H K L W", ""),
    ("Sunday lunch is at ours, so we need a dining room. One bedroom.", "B D H K L W", ""),
    ("Dataset entry: two-bedroom flat with a bathroom off the hallway.", "B2 H K L W", ""),
    ("bedroom: 4, bathroom: 2; one bathroom is en suite to bedroom 1, the other is off the hall", "B4 H K L W2",
     "B1W1, H1W2"),
    ("Kitchen: 9, bathroom: 4, bedroom: 12, living room: 20", "B H K L W", "K1=9, W1=4, B1=12, L1=20"),
]  # fmt: skip

test_what_was_only_thought_of_is_not_planned = as_meant(THOUGHT_OF)
