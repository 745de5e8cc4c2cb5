"""Rooms of several people: all but two, each with a desk, twins, boy and girl, a mother, staff, guests."""

from sentences.facts import as_meant

SENTENCES = [
    ("Four friends, each with their own bedroom except two who share one.", "B3 H K L W2",
     "B1 has 2 single_bed, !B1B2"),
    ("A house: six students with a room each, except for two of them who share, one bathroom.", "B5 H K L W",
     "B1 has 2 single_bed"),
    ("Five flatmates each have a bedroom, except Ann and Bob, who share.", "B4 H K L W2", "!unread ann"),
    ("Five friends, all with their own room except for the twins who share.", "B4 H K L W2", "B1 has 2 single_bed"),
    ("Three siblings, each with own room apart from two who share one.", "B2 H K L W", ""),
    ("A flat for three students, each with own room and desk.", "B3 H K L W2", "B1 has 1 desk, B3 has 1 desk"),
    ("Piso para tres estudiantes, cada uno con su habitación y su escritorio.", "B3 H K L W2",
     "B1 has 1 desk, B2 has 1 desk, B3 has 1 desk"),
    ("Casa para dos amigos, cada uno con su dormitorio y armario.", "B2 H K L W", "B2 has 1 wardrobe"),
    ("Drei Studenten, jeder mit eigenem Zimmer und Schreibtisch.", "B3 H K L W2", "B3 has 1 desk"),
    ("Trois étudiants, chacun avec sa chambre et un bureau.", "B3 H K L W2", "B3 has 1 desk"),
    ("House for a couple with twins who sleep together.", "B2 H K L W", "!unread sleep"),
    ("Maison pour un couple avec des jumeaux qui dorment ensemble.", "B2 H K L W", "!unread jumeaux"),
    ("Haus für ein Paar mit Zwillingen, die zusammen schlafen.", "B2 H K L W", ""),
    ("Flat for me and my husband and 2 kids, girl and boy do not share a room.", "B3 H K L W2", ""),
    ("My mother live with us she need room close to toilet; 2 bedrooms.", "B2 H K L W2", "adjacent B2 W1"),
    ("I rent a room to a lodger; two bedrooms for us and a kitchen.", "B3 H K L W2", "!unread lodger"),
    ("Two bedrooms and a room that we let to a student, one bathroom.", "B3 H K L W", ""),
    ("Our bedroom, the lodger's bedroom near the entrance, a living room and a kitchen.", "B2 H K L W",
     "near B2 entrance"),
    ("Staff quarters with two bedrooms beside the kitchen.", "B2 H K L W", "adjacent B1 K1"),
    ("3 bedrooms, one is for guest, 1 bath and also a 2nd bath for the guest.", "B3 H K L W2", "B3W2, H1W1"),
    ("A living room, a bedroom and a spare room for the grandson.", "B2 H K L W", "B2=11, unread grandson"),
]  # fmt: skip

test_each_has_a_room_or_shares_one = as_meant(SENTENCES)
