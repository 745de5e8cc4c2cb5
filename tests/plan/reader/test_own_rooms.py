"""People who each have a bedroom or a bathroom, children who share, and rooms told by whose they are."""

from sentences.facts import as_meant

EACH = [
    ("Piso para cuatro compañeros de facultad, cada uno con su dormitorio.", "B4 H K L W2", ""),
    ("Piso para tres colegas, cada uno con habitación propia.", "B3 H K L W2", ""),
    ("Appartement pour trois collègues, chacun avec sa chambre.", "B3 H K L W2", ""),
    ("Appartement pour trois amies, chacune a sa chambre.", "B3 H K L W2", ""),
    ("Wohnung für drei Arbeitskollegen, jeder mit eigenem Zimmer.", "B3 H K L W2", ""),
    ("WG für drei Freundinnen, jede mit eigenem Zimmer.", "B3 H K L W2", ""),
    ("Flat for four nurses, each with their own bedroom.", "B4 H K L W2", ""),
    ("Flat for three coworkers, each having a bedroom.", "B3 H K L W2", "!K1 has 3 oven"),
    ("Three students, each with own room and bathroom.", "B3 H K L W3", "B1W1, B2W2, B3W3"),
    ("Me and two friends, each with their own room.", "B3 H K L W2", ""),
    ("A couple with three children, each with their own room.", "B4 H K L W2", ""),
    ("Somos tres compañeras de máster y cada una necesita su propia habitación.", "B3 H K L W2", ""),
    ("Logement pour quatre étudiantes, chacune avec sa chambre et sa salle d'eau.", "B4 H K L W4", "B1W1, B4W4"),
    ("2 bed flat for me and a friend, we both want our own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("Zwei Schlafzimmer, wir wollen beide ein eigenes Bad.", "B2 H K L W2", "B1W1, B2W2"),
    ("Dos dormitorios; cada uno quiere su propio baño.", "B2 H K L W2", "B1W1, B2W2"),
]  # fmt: skip
SHARED = [
    ("My wife, our two boys (sharing a room) and I need a flat.", "B2 H K L W", ""),
    ("My partner, our twin boys and I need a flat. The boys' room has two single beds.", "B2 H K L W",
     "B2 has 2 single_bed"),
    ("Meine Brüder und ich teilen uns ein Zimmer, die Eltern schlafen im anderen.", "B2 H K L W", ""),
    ("A couple with two kids (they share) needs a flat.", "B2 H K L W", ""),
    ("Two parents and two girls; the girls' room has a bunk bed.", "B2 H K L W", "B2 has 1 bunk_bed"),
    ("A family with two kids; the kids' room has a bunk bed.", "B2 H K L W", "B2 has 1 bunk_bed"),
    ("My wife and I with three boys (the two little ones share).", "B3 H K L W2", ""),
    ("A family with two sons, who share, and one daughter.", "B3 H K L W2", ""),
    ("Me, my wife and our two daughters need a flat; the girls share a room with two desks.", "B2 H K L W",
     "B2 has 2 desk"),
    ("Wir und unsere zwei Kinder (teilen sich ein Zimmer).", "B2 H K L W", ""),
    ("Nosotros y nuestras dos hijas (comparten habitación).", "B2 H K L W", ""),
    ("Meine Schwester und ich teilen uns ein Zimmer, unsere Eltern haben das andere.", "B2 H K L W", "!unread uns"),
    ("Ma soeur et moi partageons une chambre, nos parents ont l'autre.", "B2 H K L W", ""),
    ("Mi hermano y yo compartimos un dormitorio, mis padres tienen otro.", "B2 H K L W", ""),
    ("我和弟弟合住一个房间，父母住另一个。", "B2 H K L W", ""),
    ("My sister and I share a bedroom; our parents have the other.", "B2 H K L W", ""),
    ("My brother and I share a room.", "B H K L W", ""),
]  # fmt: skip
WHOSE = [
    ("My room is 9 m2, my parents' room faces south.", "B2 H K L W", "B2=9, orientation B1 south"),
    ("The house is for me and my parents, my room near the entrance, their bedroom far from it.", "B2 H K L W",
     "apart B1 entrance, near B2 entrance"),
    ("Mein Zimmer soll 12 m² haben, das Zimmer meiner Eltern 16 m².", "B2 H K L W", "B1=16, B2=12"),
    ("Ma chambre au nord, la chambre de mes parents au sud.", "B2 H K L W", "position B1 south, position B2 north"),
    ("Mi habitación de 10 m² y la de mis padres de 14 m².", "B2 H K L W", "B1=14, B2=10"),
    ("Two bedrooms: my room faces south and my parents' room faces north.", "B2 H K L W",
     "orientation B1 north, orientation B2 south"),
    ("Hers should be 13 m2 and mine 11 m2; two bedrooms.", "B2 H K L W", "B1=13, B2=11"),
    ("Two bedrooms, one bath. Mine must be 14 m2 and next to the bathroom, his only 10 m2.", "B2 H K L W",
     "B1=14, B2=10, !adjacent B1 B2"),
    ("Drei Schlafzimmer; meines ist 10 m² groß, das meiner Eltern 14 m².", "B3 H K L W2", "B1=14, B2=10"),
    ("Mine is 10 m2, my parents' 14 m2. One bathroom.", "B2 H K L W", "B1=14, B2=10"),
    ("Zwei Schlafzimmer, ihres mit 12 m², meines mit 10 m².", "B2 H K L W", "B1=12, B2=10"),
    ("Zwei Schlafzimmer; in meinem steht ein Schreibtisch, in ihrem ein Klavier.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 piano"),
    ("Deux chambres, la sienne au nord, la mienne au sud.", "B2 H K L W", "position B1 north, position B2 south"),
    ("Deux chambres : la mienne avec un bureau, la sienne avec un piano.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 piano"),
    ("Dos dormitorios, la mía al este y la tuya al oeste.", "B2 H K L W", "position B1 east, position B2 west"),
    ("Dos dormitorios: el mío de 12 m² y el suyo de 10 m².", "B2 H K L W", "B1=12, B2=10"),
    ("Ich brauche ein Schlafzimmer und ein Arbeitszimmer.", "B H K L S W", ""),
    ("Quiero un dormitorio y un despacho.", "B H K L S W", ""),
]  # fmt: skip

test_each_has_a_room = as_meant(EACH)
test_children_and_siblings_share = as_meant(SHARED)
test_rooms_by_whose_they_are = as_meant(WHOSE)
