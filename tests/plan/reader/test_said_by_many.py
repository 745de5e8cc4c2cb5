"""Further phrasings of agents, makers of games, learners of English and families, as a careful reader takes them."""

from sentences.facts import as_meant

SENTENCES = [
    ("I need a two-bedroom apartment for a social navigation study, with a corridor between 1.2 and 1.5 m wide "
     "and one bathroom.", "B2 H K L W", "at_least H1 width 1.2, at_most H1 width 1.5, !at_least H1 width 1.5"),
    ("2bed/2bath; bath1 off hall; bath2 ensuite to bed1; kitchen open to living; study near entrance",
     "B2 H K L S W2", "!B1W1"),
    ("adjacency: kitchen-dining door, dining-living open, hall-living door, hall-bed1 door, hall-bed2 door, "
     "hall-bath door", "B2 D H K L W", "D1~L1"),
    ("The princess has a bedroom with a balcony and a dressing room; her maid sleeps in a tiny room next to the "
     "kitchen. One bathroom.", "B2 C H K L W Y", "B2H1, adjacent B2 K1"),
    ("Locked-room mystery: the study has only one door and it leads to the library, which opens onto the hall. "
     "One bedroom, one bathroom.", "B H K L S2 W", "H1S2, S1S2"),
    ("The two older kids share, the baby stays in our room. One bathroom with a tub.", "B2 H K L W",
     "B1H1, B2H1, H1K1, H1L1, H1W1"),
    ("A bedroom for us, one for each of our three children, and one for guests. Three bathrooms, one of them off"
     " our bedroom.", "B5 H K L W3", "B4H1, B5H1"),
    ("In apartment I want three rooms: bedroom, living room, and one more small room for baby. Kitchen, bathroom"
     " and toilet separately.", "B2 H K L W2", "B2H1"),
    ("I want kitchen without door to corridor, only to living room. One bedroom.", "B H K L W",
     "K1L1, !no_door K1 H1, !no_door K1 L1"),
    ("Living room and bedroom must not be near. Between them put the kitchen. One bedroom, one bathroom.",
     "B H K L W", "K1L1, adjacent K1 B1, adjacent K1 L1, !H1K1"),
    ("I am looking a flat with two bedroom, in one bedroom two bed, in other one bed. One bathroom.", "B2 H K L W",
     "B1 has 2 double_bed, B2 has 1 double_bed, !B1 has 1 double_bed"),
    ("Two floor is not need, only one floor. Three bedrooms, one bathroom, one balcony for kitchen.", "B3 H K L W Y",
     "K1Y1, !L1Y1"),
    ("Elegant two-bedroom, one-bathroom residence: gallery hall, corner living room, windowed kitchen with "
     "adjoining pantry, bedrooms on opposite sides of the flat.", "B2 H K L T W", "B1H1, B2H1, H1W1, apart B1 B2"),
    ("Two single bedrooms for me and my night nurse, next to each other with a door between them. One bathroom.",
     "B2 H K L W", "B1B2"),
    ("Die Küche darf keine Tür zum Wohnzimmer haben, sondern nur zum Flur. Zwei Schlafzimmer, ein Bad.", "B2 H K L W",
     "H1K1, !no_door K1 H1"),
    ("Jeder unserer drei Söhne braucht ein Zimmer mit Schreibtisch; Elternschlafzimmer mit Balkon; zwei Bäder.",
     "B4 H K L W2 Y", "B1W1, B2 has 1 desk, B3 has 1 desk, B4 has 1 desk"),
    ("Wohnzimmer und Küche gehören zusammen, Bad und WC getrennt, zwei Schlafzimmer, keine Abstellkammer.",
     "B2 H K L W2", "K1L1, K1~L1, !H1K1"),
    ("El baño tiene que tener dos puertas: una al dormitorio y otra al pasillo. Un dormitorio, salón y cocina.",
     "B H K L W", "B1W1"),
    ("我和室友各要一间卧室，每间放一张床和一张书桌，一个卫生间，一个厨房，不要客厅。", "B2 H K W",
     "B1 has 1 desk, B1 has 1 double_bed"),
    ("两室一厅一卫，厨房不要和卫生间相邻，客厅朝南，主卧比次卧大。", "B2 H K L W", "apart K1 W1"),
    ("Two-bedroom apartment, 75 m². I need the kitchen to be visible from the living room, so make it open. One "
     "bathroom and a small storage room.", "B2 H K L T W", "K1L1, K1~L1, !H1K1"),
    ("One bedroom apartment with a home office at the entrance and a bathroom close to the bedroom.", "B H K L S W",
     "near S1 entrance, !adjacent S1 B1"),
    ("Hacker den: one bedroom, blackout living room with three desks, kitchen the size of a closet, bathroom.",
     "B H K L W", ""),
    ("We have three boys. Two of them share the bigger room and the third has the smaller one. We sleep next to "
     "the bathroom.", "B3 H K L W", "B3H1, adjacent B1 W1"),
    ("Each child should have its own room; we have two. Our bedroom next to the nursery of the younger one.",
     "B3 H K L W2", "B1W1, B3H1, H1W2, adjacent B1 B3"),
    ("Grandpa can't walk well, so his room should be near the entrance and have its own toilet. Two more "
     "bedrooms and a bathroom.", "B3 H K L W2", "B1W1, !H1W1"),
    ("The kitchen is where we live, so it should be the biggest room; the living room can be small. Two "
     "bedrooms.", "B2 H K L W", "order K1 largest"),
    ("In bedroom stay bed, wardrobe and table for work. In living room stay sofa and television. One bedroom "
     "flat.", "B H K L W", "B1 has 1 desk, B1 has 1 double_bed, !K1 has 1 dining_table"),
    ("The first bedroom is bigger than the second bedroom, the third is smallest. One bathroom.", "B3 H K L W",
     "order B3 smallest"),
    ("Flat no need balcony, no need store. Only one bedroom, kitchen, bath, living.", "B H K L W", ""),
    ("I have low vision. Please avoid long corridors and keep the bathroom directly across from the bedroom. One"
     " bedroom.", "B H K L W", "B1H1, H1W1, at_most H1 length 6"),
    ("Im Bad keine Badewanne, im Schlafzimmer kein Fernseher. Wohnung mit einem Schlafzimmer.", "B H K L W",
     "B1 has 0 tv, !L1 has 0 tv"),
    ("Les enfants ont chacun leur chambre (ils sont deux) et nous dormons dans la chambre avec balcon. Une salle"
     " de bains.", "B3 H K L W Y", "B2H1, B3H1"),
    ("La cocina comunica con el salón y con el comedor; el comedor no comunica con el pasillo. Tres dormitorios,"
     " dos baños.", "B3 D H K L W2", "!D1~K1"),
    ("Cada hijo tiene su habitación y son tres; nosotros, un dormitorio con baño. Otro baño en el pasillo.",
     "B4 H K L W2", "B1W1, B3H1, B4H1"),
    ("Both bathrooms off the hall, none of them off a bedroom. Three bedrooms.", "B3 H K L W2", ""),
    ("An apartment in which the kitchen is the only way to the balcony. One bedroom, one bathroom.", "B H K L W Y",
     "K1Y1, !L1Y1"),
    ("three beds - two baths - kitchen/diner - lounge - utility - store", "B3 D H K L T U W2",
     "B1H1, B2H1, B3H1, H1K1, H1L1, H1T1, H1U1, H1W2"),
    ("Three generations: grandparents' bedroom with its own bathroom near the entrance, parents' bedroom, and a "
     "room each for our two daughters. One more bathroom.", "B4 H K L W2", "B3H1, B4H1"),
    ("The girls (8 and 10) share, the boy (14) has his own room, and there is a room for us. One bathroom and a "
     "guest toilet.", "B3 H K L W2", "B3H1"),
    ("I wish apartment with two rooms and kitchen, toilet is together with bathroom.", "B H K L W", ""),
    ("The bathroom must be not less 6 m2 and the kitchen not more 10 m2. One bedroom.", "B H K L W",
     "at_least W1 6, at_most K1 10"),
    ("The big bedroom is for me and my wife, the middle is for my mother, the small is for my son.", "B3 H K L W2",
     "B1W1, B3H1, H1W2"),
    ("I need two same bedrooms, each with bed and table, and in living room sofa and no table.", "B2 H K L W",
     "L1 has 0 dining_table, !K1 has 0 dining_table"),
    ("Die Wohnung soll zwei Balkone haben, einen am Wohnzimmer und einen am Schlafzimmer. Zwei Schlafzimmer, ein"
     " Bad.", "B2 H K L W Y2", "B1Y2, !L1Y2"),
    ("Unsere Tochter bekommt das kleine Zimmer neben dem Bad, unser Sohn das große, wir schlafen im dritten. Ein"
     " Bad und ein WC.", "B3 H K L W2", "B3H1, H1W1, H1W2, adjacent B2 W1"),
    ("Tres compañeros de piso: cada uno quiere una habitación con escritorio; dos baños y una cocina grande sin "
     "salón.", "B3 H K W2", "B1W1, B2 has 1 desk, B2H1, B3 has 1 desk, B3H1, H1W2"),
    ("爸妈住主卧，我和弟弟各一间，一个卫生间，阳台连着主卧。", "B3 H K L W Y", "B2H1, B3H1"),
    ("厨房挨着餐厅，餐厅连着客厅，三室两卫，主卫在主卧里。", "B3 D H K L W2", "B1H1, B2H1, B3H1, H1L1, H1W2"),
    ("Just one bathroom, but a toilet extra; two bedrooms; the toilet next to the front door and the bathroom "
     "next to the bedrooms.", "B2 H K L W2", ""),
    ("Two bedrooms of at least 10 m² each, neither next to the kitchen; the bathroom between them.", "B2 H K L W",
     "B1W1, B2W1, !H1W1"),
    ("The baby sleeps with us, the two big ones each have a room. One bathroom and a balcony off the living "
     "room.", "B3 H K L W Y", "B1H1, B2H1, B3H1, H1K1, H1L1, H1W1"),
    ("I see badly, so please no doors between kitchen and living room, just one open space. One bedroom, one "
     "bathroom.", "B H K L W", "K1L1, K1~L1, !H1K1, !no_door K1 L1"),
    ("I use a rollator. The bathroom must be near my bedroom and at least 5 m². One bedroom, living room, "
     "kitchen.", "B H K L W", "at_least W1 5, !at_least home 5"),
    ("One bathroom, two bedrooms, and between kitchen and dining room no wall.", "B2 D H K L W",
     "B1H1, B2H1, D1K1, D1~K1, !B1D1, !B1K1, !B2D1, !B2K1"),
    ("Zwei Kinder, zwei Kinderzimmer, ein Elternschlafzimmer, ein Bad und ein Gäste-WC, die Küche mit Tür zum "
     "Wohnzimmer und zum Flur.", "B3 H K L W2", "H1K1"),
    ("Un dormitorio para nosotros y otro para cada uno de nuestros dos hijos; un baño y un aseo.", "B3 H K L W2",
     "B3H1"),
    ("Robot test: kitchen and living room connected by an open doorway, hallway with three doors, one bedroom, "
     "one bathroom.", "B H K L W", "K1~L1"),
    ("Each of the three bedrooms gets a wardrobe and a desk, the largest one also an armchair. One bathroom.",
     "B3 H K L W", "B1 has 1 armchair, !L1 has 1 armchair"),
    ("Two bedrooms, one bathroom; the hallway must be at least 1.1 m wide and free of rugs.", "B2 H K L W",
     "H1 has 0 rug, at_least H1 width 1.1, !L1 has 2 rug"),
    ('apartment: {bedrooms: 2, bathrooms: 1, kitchen: {open: true}}', "B2 H K L W", "K1~L1"),
    ("living 20 m2 w/ 2 sofas; kitchen 8 m2 w/ table; bedroom 12 m2 w/ bed + desk; bath 4 m2; hall", "B H K L W",
     "B1 has 1 double_bed, B1 has 1 desk"),
    ("The kids may share, but they need two desks. Our bedroom should be far from theirs. One bathroom with a tub.",
     "B2 H K L W", "B2 has 2 desk, apart B1 B2"),
    ("Parents plus one child: two bedrooms next to each other, a bathroom between them, open kitchen.", "B2 H K L W",
     "B1W1, B2W1, !K1W1"),
    ("I don't like bathtub, please only shower. One bedroom, one bathroom.", "B H K L W", "W1 has 0 bath"),
    ("Wohnung mit Wohnküche, zwei Schlafzimmern und Bad; vom Schlafzimmer aus soll man auf den Balkon kommen.",
     "B2 H K L W Y", "B1Y1, !L1Y1"),
    ("El balcón está en el dormitorio y no en el salón. Un dormitorio, un baño.", "B H K L W Y", "B1Y1, !L1Y1"),
    ("A flat with one bedroom facing the sea.", "B H K L W", "unread facing the sea"),
    ("A two-bedroom flat with bay windows in the lounge.", "B2 H K L W", "unread bay windows, !unread with bay"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)
