"""Plain requests for homes: where one comes in, whose baths and balconies are whose, limits without units."""

from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

STRAIGHT_IN = [
    ("You enter the flat directly into the living room, with the kitchen to the left and the bedroom to the right.",
     "B K L W", "position K1 left, position B1 right, B1L1, K1L1"),
    ("A one-bedroom flat where the entrance is in the living room.", "B K L W", ""),
    ("One enters the flat through the living room. One bedroom.", "B K L W", ""),
    ("The front door opens into the living room. Three bedrooms off a corridor.", "B3 H K L W2", ""),
    ("You can walk from the kitchen directly into the living room. Two bedrooms.", "B2 H K L W", "K1L1"),
]  # fmt: skip

test_one_comes_straight_into_a_room = as_meant(STRAIGHT_IN)

WHOSE = [
    ("Two bathrooms: one with a bathtub for the family and one with only a shower for the guests.", "B2 H K L W2",
     "W1 has 1 bath, W2 has 1 shower, H1W1, H1W2, !unread guests"),
    ("A two-bedroom flat for me and my flatmate with one bathroom each and a shared kitchen-living room.",
     "B2 H K L W2", "B1W1, B2W2, K1~L1"),
    ("There are two balconies, one for the kitchen and one for the bedroom.", "B H K L W Y2", "K1Y1, B1Y2, !L1Y1"),
    ("Two walk-in closets, one for each bedroom. Two bedrooms.", "B2 C2 H K L W", "B1C1, B2C2"),
    ("Vom Flur aus kommt man in alle Zimmer, nur das Bad ist vom Schlafzimmer aus zugänglich.", "B H K L W",
     "B1W1, H1K1, !H1W1"),
    ("Every room opens off the hall, only the bathroom is accessible from the bedroom.", "B H K L W", "B1W1, !H1W1"),
    ("Les toilettes sont séparées de la salle de bain et la buanderie se trouve à côté de la cuisine.",
     "B2 H K L U W2", "adjacent U1 K1, !adjacent W1 K1, !adjacent W2 K1"),
    ("El aseo está separado del baño. Dos dormitorios.", "B2 H K L W2", ""),
    ("All rooms should have windows except the bathroom and the storage.", "B2 H K L T W", "unread windows, !T1W1"),
    ("A gym room with a treadmill, a home cinema and a wine cellar next to the kitchen.", "B2 H K L S2 W",
     "unread wine cellar, !adjacent S2 K1"),
]  # fmt: skip

test_whose_it_is = as_meant(WHOSE)

LIMITS = [
    ("The bathroom should be at least 6 square meters and the kitchen between 8 and 10.", "K W",
     "at_least W1 6, at_least K1 8, at_most K1 10, K1=9, W1=6"),
    ("The total area should be between 70 and 80 square meters, with the living room taking up at least 25.",
     "B2 H K L W", "at_least home 70, at_most home 80, at_least L1 25"),
    ("Living room 25 m2, kitchen between 8 and 10, two bedrooms.", "B2 H K L W", "at_least K1 8, at_most K1 10"),
    ("A flat of 80 m², the living room at least 25, the kitchen no more than 10, two bedrooms.", "B2 H K L W",
     "all=80, at_least L1 25, at_most K1 10"),
    ("A flat of 80 m² with at least 2 bedrooms and a kitchen.", "B2 H K L W", "all=80"),
    ("A flat of 80 m² with a living room with at least 3 windows.", "B2 H K L W", "!L1=3"),
    ("Eine Dreizimmerwohnung mit Küche, Bad und Balkon, ungefähr 75 Quadratmeter.", "B2 H K L W Y",
     "all=75, !unread ungefahr"),
]  # fmt: skip

test_limits_without_a_unit = as_meant(LIMITS)

CHATTY = [
    ("So my husband and I just sold our big house and now we want something smaller, maybe two bedrooms, because the "
     "grandkids come. A bathroom with a walk-in shower would be great since my knees are bad.", "B2 H K L W",
     "W1 has 1 shower, B1=14, !unread bad"),
    ("A place for me and two friends. We'd each like our own room, we don't mind sharing the bathroom, but the kitchen "
     "should be big.", "B3 H K L W", "!no_door B1 W1, H1W1, K1=13.65"),
    ("I'm a piano teacher, so I need a room for lessons right by the entrance. Besides that just a bedroom, a small "
     "kitchen and a bathroom.", "B H K L S W", "near S1 entrance, !L1 has 1 piano"),
    ("At the moment our daughter has her own room, so we'd need one more bedroom next to ours, and if possible a "
     "second toilet.", "B3 H K L W2", "adjacent B2 B1"),
    ("My mother-in-law is moving in with us. She should have her bedroom and her own shower room away from the noisy "
     "living room. The rest: one bedroom for us, one for our son, an open kitchen.", "B3 H K L W2",
     "apart B2 L1, B2W1, K1~L1"),
    ("Our architect suggested 90 square meters: 30 for the living room with kitchen, 14 for our bedroom, 12 for each "
     "of the two kids, and the rest for bathroom and hall.", "B3 H K L W", "all=90, L1=30, B1=14, B2=12, B3=12, H1W1"),
    ("We need a flat with two bedrooms, where the kitchen can be reached from two different rooms.", "B2 H K L W",
     "at_least K1 doors 2"),
    ("Picture a flat: you come in at the front, the kitchen is on the left, then the bathroom, and at the very end are "
     "the living room and the bedroom.", "B H K L W", "position K1 left, !K1W1"),
    ("A brightly-lit two-bedroom flat.", "B2 H K L W", "!B1 has 1 double_bed"),
    ("My back is bad and the old flat was bad. One bedroom.", "B H K L W", ""),
    ("Bad, Küche, 2 Zimmer.", "B H K L W", ""),
]  # fmt: skip

test_what_is_said_in_passing = as_meant(CHATTY)

TERSE = [
    ("Living 30, kitchen 12, master 16 + ensuite 5, kids 11 + 11, bath 6, wc 2", "B3 H K L W3",
     "L1=30, B1=16, B2=11, B3=11, W1=5, W2=6, W3=2"),
    ("60 m2, 1 bedroom, home office corner in the living room", "B H K L W", "L1 has 1 desk, all=60"),
    ("couple + 2 kids, 3 bedrooms, 2 bathrooms, kids' rooms same size", "B3 H K L W2", "B2=11, B3=11"),
    ("2 hab, 1 baño, cocina independiente, terraza, 60 m2", "B2 H K L W Y", "!unread hab"),
    ("Two toilets, one near the bedroom and the other near the entrance.", "B H K L W2",
     "near W2 entrance, adjacent W1 B1, !near B1 entrance"),
]  # fmt: skip

test_short_notes = as_meant(TERSE)

LEARNT = [
    ("I want flat for three person, each person must have own room and there is only one bathroom.", "B3 H K L W", ""),
    ("I need two toilet, one near bedroom and other near door of entrance.", "B H K L W2",
     "near W2 entrance, adjacent W1 B1"),
    ("From living room is possible to go in the kitchen and in the balcony, but in bedroom only from corridor.",
     "B H K L W Y", "K1L1, L1Y1, B1H1, !H1K1"),
    ("Make the flat without corridor, all doors go to living room, bath is inside bedroom.", "B K L W",
     "B1W1, !L1W1, K1L1"),
    ("In the bedroom put one bed for two persons, wardrobe big, and table for computer.", "B",
     "B1 has 1 double_bed, B1 has 1 desk, B1 has 1 wardrobe"),
    ("J'aimerais que la cuisine soit fermée, que le salon fasse au moins 25 m² et que les toilettes soient près de "
     "l'entrée.", "B2 H K L W2", "near W1 entrance, at_least L1 25, !unread soit"),
    ("Deux chambres côte à côte, une grande cuisine et un salon qui donne sur la terrasse.", "B2 H K L W Y",
     "L1Y1, !K1Y1, adjacent B1 B2"),
    ("Vier Schlafzimmer und zwei Bäder, eins davon neben Omas Zimmer.", "B4 H K L W2", "adjacent W1 B4"),
]  # fmt: skip

test_as_learners_and_others_say_it = as_meant(LEARNT)

FORTY = [
    ("One-bedroom flat. The bedroom should be away from the living room and the entrance.", "B H K L W",
     "apart B1 entrance, apart B1 L1, !apart L1 entrance"),
    ("A flat with two bedrooms on opposite sides of the living room.", "B2 H K L W",
     "adjacent B1 L1, adjacent B2 L1, apart B1 B2"),
    ("A guest room with its own bathroom near the entrance, and two more bedrooms at the back.", "B3 H K L W2",
     "near B3 entrance, B3W1, position B1 back, position B2 back, !near W1 entrance"),
    ("The living room in the middle, bedrooms left and right of it, the kitchen behind it.", "B2 H K L W",
     "position L1 centre, position B1 L1 left, position B2 L1 right, adjacent K1 L1"),
    ("An L-shaped living and dining room, a separate kitchen, two bedrooms.", "B2 D H K L W", "D1~L1"),
    ("You should be able to reach the bathroom from the bedrooms without crossing the living room.", "B2 H K L W",
     "no_door W1 L1, H1W1, !L1W1, !B1W1"),
    ("The children's room must be close to ours and the guest room as far away as possible.", "B3 H K L W2",
     "adjacent B2 B1, apart B3 B1"),
    ("I need storage: a walk-in closet, a pantry and a broom cupboard. Two bedrooms.", "B2 C H K L T2 W", ""),
]  # fmt: skip

test_where_rooms_lie = as_meant(FORTY)

ABROAD = [
    ("Unser Sohn braucht ein eigenes Zimmer, und wir hätten gern ein Arbeitszimmer, das man auch als Gästezimmer "
     "nutzen kann.", "B2 H K L S W", "use S1 bedroom"),
    ("Zwei Schlafzimmer. Die Küche soll höchstens 10 Quadratmeter haben und einen Zugang zum Balkon.", "B2 H K L W Y",
     "at_most K1 10, K1Y1"),
    ("Ein Badezimmer für die Eltern und eins für die Kinder, dazu drei Schlafzimmer.", "B3 H K L W2", "!unread eltern"),
    ("Das Kinderzimmer neben unserem Schlafzimmer, das Gästezimmer möglichst weit weg davon.", "B3 H K L W2",
     "adjacent B2 B1, apart B3 B1"),
    ("Alle Zimmer vom Flur aus erreichbar, drei Schlafzimmer.", "B3 H K L W2", "B1H1, B2H1, B3H1, H1W1, !B1L1, !B1W1"),
    ("Je travaille à la maison, il me faut donc un bureau loin du salon, et une seule chambre.", "B H K L S W",
     "apart S1 L1, !apart S1 B1"),
    ("La chambre des enfants est à côté de la nôtre et la chambre d'amis est au bout du couloir.", "B3 H K L W2",
     "adjacent B2 B1, position B3 back"),
    ("On entre directement dans le salon, la cuisine est à gauche et la chambre à droite.", "B K L W", "B1L1, K1L1"),
    ("El cuarto de los niños está al lado del nuestro y el de invitados al final del pasillo.", "B3 H K L W2",
     "adjacent B2 B1, position B3 back, !adjacent B2 B3"),
    ("Somos cuatro compañeros de piso, cada uno con su habitación, y compartimos dos baños y una cocina grande.",
     "B4 H K L W2", "H1W1, H1W2"),
    ("Se entra directamente al salón, la cocina está a la izquierda y el dormitorio a la derecha.", "B K L W", "K1L1"),
    ("卫生间要有浴缸和淋浴，另外还要一个独立的厕所。", "W2", "W2=2.3"),
    ("四个室友合租，每人一间卧室，共用两个卫生间和一个大厨房。", "B4 H K L W2", ""),
    ("Two bedrooms, one of them small.", "B2 H K L W", "B1=14, B2=8.85"),
    ("Three bedrooms. The guest room is at the end of the hall.", "B3 H K L W2", "position B3 back"),
]  # fmt: skip

test_as_other_languages_say_it = as_meant(ABROAD)

FOR_ONE = [
    ("A flat for my mother.", "B H K L W", "!unread mother"),
    ("A flat for my daughter, who is a student.", "B H K L W", "!unread student"),
    ("A flat for my mother and her dog.", "B H K L W", "!unread dog"),
    ("A two-bedroom flat for my mother.", "B2 H K L W", "!unread mother"),
    ("A flat for my mother with a guest room.", "B2 H K L W", "!unread mother"),
    ("A flat for my parents.", "B H K L W", "!unread parents"),
    ("A flat for my parents with two bedrooms.", "B2 H K L W", "!unread parents"),
    ("Eine Wohnung für meine Mutter.", "B H K L W", "!unread mutter"),
    ("Un appartement pour ma fille étudiante.", "B H K L W", "!unread fille"),
    ("Un piso para mi madre.", "B H K L W", "!unread madre"),
    ("给我妈妈的公寓。", "B H K L W", ""),
    ("A flat for my mother and me.", "B2 H K L W", ""),
    ("A flat for my daughter with two kids.", "B3 H K L W2", ""),
    ("We need a room in the flat for my mother.", "B2 H K L W", ""),
    ("Eine Wohnung für meine Mutter und mich.", "B2 H K L W", ""),
]

test_a_home_for_a_relative_is_for_one = as_meant(FOR_ONE)



def test_flatmates_are_no_children() -> None:
    bedrooms = [room for room in read("四个室友合租，每人一间卧室。").rooms if room.type == "bedroom"]
    assert [room.children for room in bedrooms] == [None] * 4
