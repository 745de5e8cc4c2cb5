"""What people tell of how they live, and whose rooms follow from it; slips; a truly plain manner of speaking."""

from sentences.facts import as_meant

WHOSE = [
    ("I look after my father, who uses a walker. His room needs at least 16 m2, my own room can be small.",
     "B2 H K L W",
     "at_least B2 16"),
    ("My mum is moving in, so her room should be next to the bathroom. Then one room for my husband and me, and one "
     "for our teenager. One bathroom.", "B3 H K L W", "adjacent B3 W1"),
    ("My father paints. Two bedrooms, his room faces north.", "B2 H K L W", ""),
    ("My client has the big bedroom with a bathroom of her own, I have the small bedroom and use the other bathroom "
     "off the hall.", "B2 H K L W2", "H1W2"),
    ("The big bedroom faces south, two bedrooms in all, and the small bedroom faces north.", "B2 H K L W", ""),
    ("My two girls are with me every other week, so there is my bedroom and one that they share, with two single beds. "
     "One bathroom.", "B2 H K L W", "B2 has 2 single_bed"),
    ("We have four kids: the twins share, the other two each get their own room. Two bathrooms off the hall.",
     "B4 H K L W2", ""),
    ("Three of us rent together and need no living room. None of the bedrooms under 10 m2. One bathroom.", "B3 H K W",
     "at_least B1 10, at_least B3 10"),
    ("Five of us share a place, four bedrooms.", "B4 H K L W2", ""),
    ("A flat for three students, each bedroom at least 10 m2, one bathroom", "B3 H K L W", "at_least B3 10"),
    ("We have three childs and they sleeps all in the same room. My wife and me in other room. Bathroom one is enough.",
     "B2 H K L W", ""),
    ("Her brother's bedroom should be far from the living room. A bedroom for me, one for her, one for him.",
     "B3 H K L W2",
     "apart B3 L1"),
    ("Dos dormitorios, el de mi madre orientado al sur", "B2 H K L W", "orientation B2 south, !orientation B1 south"),
    ("三间卧室，爸妈那间朝南，一个卫生间", "B3 H K L W", "orientation B1 south, !orientation B2 south"),
    ("Somos dos parejas que compartimos piso: cada pareja con su dormitorio y su baño dentro, y un aseo.",
     "B2 H K L W3",
     "B1W1, B2W2"),
]
NOT_WANTED = [
    ("Four bedrooms, one bathroom, a dining table in the kitchen because we won't have a dining room.", "B4 H K L W",
     "K1 has 1 dining_table"),
    ("Could I have the desk in the bedroom? There's no space for a proper office. One bedroom.", "B H K L W",
     "B1 has 1 desk"),
    ("I was going to ask for a dining room, but we'd rather eat in the kitchen, so a round table and four chairs "
     "there. Two bedrooms.", "B2 H K L W", "K1 has 4 chair"),
    ("Our bedroom and a guest room with a desk. The rest of the month I use that room as my office.", "B2 H K L W", ""),
    ("Our washing machine stands in the kitchen today. Please move it to a laundry room. Two bedrooms.", "B2 H K L U W",
     "U1 has 1 washing_machine, !K1 has 1 washing_machine"),
    ("I wanted the balcony in the front but now I prefer it in the back. Two bedrooms.", "B2 H K L W Y",
     "position Y1 back, !position Y1 front"),
    ("Zwei Schlafzimmer, eine offene Küche möchte ich nicht.", "B2 H K L W", "H1K1, !K1~L1"),
    ("次卧兼作书房，两室一厅，次卧放一张书桌。", "B2 H K L W", "B2 has 1 desk"),
]
LIMITS = [
    ("Three bedrooms, one bathroom, no bedroom above 14 m².", "B3 H K L W", "at_most B1 14, at_most B3 14"),
    ("Two bedrooms, no bedrooms smaller than 9 m2", "B2 H K L W", "at_least B1 9, at_least B2 9"),
    ('{"bedrooms": 2, "bathrooms": 1, "max_total_area_m2": 85}', "B2 H K L W", "at_most home 85"),
    ("rooms: bedroom, kitchen, living room, bathroom, hallway; kitchen max area: 9 m2", "B H K L W",
     "at_most K1 9, !at_most home 9"),
    ("One bedroom, one study, all together not more big than 65 square meters.", "B H K L S W", "at_most home 65"),
    ("living room 20 m2, kitchen 8 m2, bedroom: 1, 12 m2, bathroom: 1, 4.5 m2", "B H K L W", "B1=12, W1=4.5"),
    ("El salón tiene que ser la habitación más grande. Dos dormitorios.", "B2 H K L W", "order L1 largest"),
]
SLIPS = [
    ("4 bedrroms, 2 bahtrooms, kitchen opne to the livign room", "B4 H K L W2", "K1~L1"),
    ("one bedrom appartment wiht a stroage room oposite the kithcen", "B H K L T W", "opposite T1 K1"),
    ("two bedrooms, the mian bedroom shoud be the largst room", "B2 H K L W", "order B1 largest"),
    ("two bedrooms. main bedroom faces south", "B2 H K L W", "orientation B1 south"),
    ("Two bedrooms, a utility room next to the bathroom, and the main bedroom should be the largest room.",
     "B2 H K L U W",
     "adjacent U1 W1, !adjacent U1 B1, order B1 largest"),
    ("Deux chambres, un bureau où l'on entre par le séjour", "B2 H K L S W", "L1S1, !H1S1"),
    ("两个卧室，两个卫生间的门都开在走廊上。", "B2 H K L W2", "H1W1, H1W2"),
]
TOLD = [
    ("No long corridor please. One bedroom plus a small room for my assistant.", "B2 H K L W", ""),
    ("Looking for a place for me and my son. He needs a desk in his room. One bathroom.",
     "B2 H K L W", "B2 has 1 desk"),
    ("We are four nurses on different shifts, so the bedrooms should be far from the living room. Two bathrooms.",
     "B4 H K L W2", "apart B1 L1, apart B4 L1"),
    ("My office is also the guest room. One bedroom, one bath.", "B H K L S W", "use S1 bedroom"),
    ("The kids fight, so put their rooms at opposite ends. Three bedrooms.",
     "B3 H K L W2", "apart B2 B3, !apart B1 B2"),
    ("Could the laundry be in the bathroom? Two bedrooms.", "B2 H K L W", "W1 has 1 washing_machine"),
    ("The twins will share, the older one has her own room. One bathroom.", "B3 H K L W", ""),
    ("I teach piano at home: the music room should be the first room when you come in. Two other bedrooms.",
     "B2 H K L S W",
     "near S1 entrance, !L1 has 1 piano"),
    ("i want a dressing room off our bedroom and a balcony off the living room, thats it",
     "B C H K L W Y", "B1C1, L1Y1"),
    ("a living room, a bedroom, a kitchen and a bathroom, that's it", "B K L W", ""),
    ("The dining room is between the kitchen and the living room, and both should be open to it. Two bedrooms.",
     "B2 D H K L W", "D1~K1, D1~L1"),
    ("A one-bedroom flat; the bedroom has room for a piano.", "B H K L W", "B1 has 1 piano"),
    ("Two desks in the second bedroom. We both study. One bath.", "B2 H K L W", "B2 has 2 desk"),
    ("Our last flat had the bathroom off the kitchen, never again. Two bedrooms.",
     "B2 H K L W", "no_door W1 K1, !K1W1"),
    ("Two bedrooms. My bedroom must not have a window to the street.", "B2 H K L W", "!position B1 front"),
    ("The previous tenants had the washing machine in the hallway; we want it in the bathroom. One-bedroom flat.",
     "B H K L W", "W1 has 1 washing_machine, !H1 has 1 washing_machine"),
    ("We are three adults. A flat with one bathroom.", "B3 H K L W", ""),
    ("One bedroom for him by the bathroom, one for me.", "B2 H K L W", "adjacent B2 W1"),
    ("Our son wants to have the room next to the bathroom, our daughter the one next to us.", "B3 H K L W",
     "adjacent B2 W1, adjacent B3 B1"),
    ("A big kitchen with an island, open to the living room, and a bedroom at the back.", "B H K L W",
     "K1~L1, K1 has 1 island, !B1K1, position B1 back"),
    ("Grandma, us two, and two boys who share. One bathroom.", "B3 H K L W", ""),
]
ABROAD = [
    ("Wir sind zu dritt mit unserem Baby, das noch bei uns schläft. Ein Arbeitszimmer wäre toll.", "B H K L S W", ""),
    ("Unsere Kinder sind 4 und 7 und teilen sich ein Zimmer. Küche bitte nicht offen.", "B2 H K L W", "H1K1"),
    ("Ich wohne allein und brauche ein Zimmer zum Malen mit Nordlicht. Sonst nichts Besonderes.", "B H K L S W",
     "orientation S1 north"),
    ("Un studio pour un étudiant, avec un bureau et un coin cuisine.", "K L W", "L1 has 1 desk"),
    ("Pas besoin de salon, on est trois colocataires.", "B3 H K W2", ""),
]
DOORS = [
    ("The living room is next to the bathroom. There must be no door from it into my bedroom.", "B H K L W",
     "no_door L1 B1, !B1L1"),
    ("Two bedrooms. No door from the kitchen into the bathroom.", "B2 H K L W", "no_door K1 W1, !K1W1"),
    ("kitchen open to the dining room and dining room open to the living room, two bedrooms", "B2 D H K L W",
     "D1~K1, D1~L1"),
    ("Two bedrooms of equal area opposite each other", "B2 H K L W", "opposite B1 B2"),
    ("four students, all have their own bedroom, one bathroom", "B4 H K L W", ""),
    ("Zwei Schlafzimmer, vom Esszimmer geht eine Tür ins Wohnzimmer.", "B2 D H K L W", "D1L1"),
    ("Ein Schlafzimmer, im Wohnzimmer ein Ecksofa", "B H K L W", "L1 has 1 corner_sofa, !L1 has 1 sofa"),
    ("deux chambres éloignées l'une de l'autre", "B2 H K L W", "apart B1 B2"),
    ("一室一厅，客厅放两盆绿植", "B H K L W", "L1 has 2 plant"),
]
SAID_OF_IT = [
    ("I keep parrots in the living room, so it needs at least 30 m2. One bedroom.", "B H K L W",
     "at_least L1 30, !at_least home 30"),
    ("One bedroom. The kitchen is next to the bedroom, and the study is far away from both.", "B H K L S W",
     "adjacent K1 B1, apart S1 K1, apart S1 B1"),
    ("four bedrooms, one facing north, one east, one south and one west", "B4 H K L W2",
     "orientation B1 north, orientation B2 east, orientation B4 west"),
    ("Two bedrooms, and a hallway that is at least 1.3 m wide and not longer than 10 m.", "B2 H K L W",
     "at_least H1 width 1.3, at_most H1 length 10"),
    ("a utility room that you enter from the kitchen, on the north side. One bedroom.", "B H K L U W",
     "K1U1, position U1 north, !position K1 north"),
    ("The study must be the smallest room, in the centre of the flat. One bedroom.", "B H K L S W",
     "order S1 smallest, position S1 centre"),
]

test_whose_rooms = as_meant(WHOSE)
test_what_is_not_wanted = as_meant(NOT_WANTED)
test_limits = as_meant(LIMITS)
test_slips = as_meant(SLIPS)
test_what_is_told = as_meant(TOLD)
test_what_is_told_abroad = as_meant(ABROAD)
test_doors_and_words = as_meant(DOORS)
test_what_is_said_of_it = as_meant(SAID_OF_IT)
