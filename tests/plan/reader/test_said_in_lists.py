"""What lists and clauses say of a room behind what they say of its doors."""

from sentences.facts import as_meant

TOLD = [
    ("Three bedrooms; two bathrooms, one off the hallway and one en suite to the master bedroom.", "B3 H K L W2",
     "B1W1, H1W2"),
    ("Two bedrooms; kitchen open to the living room and at the back of the flat.", "B2 H K L W",
     "position K1 back, K1~L1, !position L1 back"),
    ("3 bedrooms, 2 bathrooms, living room, kitchen and dining room. Everything opens off the hallway, both bathrooms "
     "too, except the dining room, which opens off the kitchen and the living room.", "B3 D H K L W2",
     "H1W1, H1W2, D1K1, D1L1, !D1H1, !B1W1"),
    ("- type: apartment\n- bedrooms: 2\n- bathrooms: 1\n- balcony: yes, off the living room, facing south\n- study: no",
     "B2 H K L W Y", "L1Y1, orientation Y1 south, !orientation L1 south"),
    ("两室一厅，一厨，一卫。阳台：与客厅相连，朝南", "B2 H K L W Y", "L1Y1, orientation Y1 south"),
    ("Eine Speisekammer, die von der Küche abgeht, zwei Schlafzimmer.", "B2 H K L T W", "K1T1, !unread abgeht"),
    ("Zwei Schlafzimmer, ein Bad, das vom Flur abgeht, und ein Balkon.", "B2 H K L W Y", "H1W1"),
    ("Dos dormitorios, cocina, salón, un baño de 6 m² como mínimo.", "B2 H K L W", "at_least W1 6"),
    ("Deux chambres, cuisine, salon, une salle de bain de 6 m² au maximum.", "B2 H K L W", "at_most W1 6"),
]  # fmt: skip

test_each_is_said_of_its_room = as_meant(TOLD)
