"""Rooms that are counted behind their name, in five languages."""

from sentences.facts import as_meant

SENTENCES = [
    ("A flat with 10-12 m2 bedrooms, three of them.", "B3 H K L W2", "at_least B3 10, at_most B3 12"),
    ("Bedrooms, three of them, and bathrooms, two of those.", "B3 H K L W2", ""),
    ("Bedrooms – 3 of them – and a kitchen.", "B3 H K L W2", ""),
    ("Small bedrooms, four of them, two bathrooms.", "B4 H K L W2", ""),
    ("I'd like bedrooms of about 11 sqm, four of those, and one bath.", "B4 H K L W", "B4=11"),
    ("A house with bedrooms (4), bathrooms (2).", "B4 H K L W2", ""),
    ("We would like bedrooms, four to be exact.", "B4 H K L W2", ""),
    ("Schlafzimmer, drei Stück, und Bäder, zwei davon.", "B3 H K L W2", ""),
    ("Schlafzimmer mit je 12 m², davon drei, und ein Bad.", "B3 H K L W", "B3=12"),
    ("Des chambres, trois au total, et une salle de bain.", "B3 H K L W", ""),
    ("Chambres, il y en a trois, et deux salles de bain.", "B3 H K L W2", ""),
    ("Habitaciones de 12 m2, tres en total.", "B3 H K L W2", "B3=12"),
    ("卧室，三个，卫生间两个。", "B3 H K L W2", ""),
    # some of those counted before
    ("Flat with four bedrooms, two of them with a balcony.", "B4 H K L W2 Y2", "B1Y1, B2Y2"),
    ("Four bedrooms, three of them small.", "B4 H K L W2", ""),
]  # fmt: skip

test_counts_behind_are_as_before = as_meant(SENTENCES)
