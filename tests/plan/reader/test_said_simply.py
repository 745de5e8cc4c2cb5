"""Doors, limits, corners, uses and areas as people type them; words that bear nothing; a side of the last of two."""

from sentences.facts import as_meant

FURNISHED = [
    ("a furnished two-bedroom flat", "B2 H K L W", "!unread furnished"),
    ("fully furnished 1-bedroom apartment", "B H K L W", "!unread furnished, !unread fully"),
    ("an unfurnished two-bedroom flat", "B2 H K L W", "unread unfurnished"),
    ("two bedrooms, not furnished", "B2 H K L W", "unread not furnished"),
    ("两室一厅，不要家具", "B2 H K L W", "unread 不要家具"),
    ("Eine voll möblierte Wohnung mit zwei Schlafzimmern", "B2 H K L W", "!unread moblierte"),
    ("appartement meublé de deux chambres", "B2 H K L W", "!unread meuble"),
    ("piso amueblado de dos dormitorios", "B2 H K L W", "!unread amueblado"),
    ("精装修两室一厅，带家具", "B2 H K L W", "!unread 精, !unread 具"),
]
LAST_OF_TWO = [
    ("A flat with one bedroom and a living room facing west", "B H K L W", "orientation L1 west, !orientation B1 west"),
    ("She needs one bedroom and a living room facing west.", "B H K L W", "orientation L1 west, !orientation B1 west"),
    ("A flat with a bedroom facing east and a study next to the living room.", "B H K L S W",
     "adjacent S1 L1, !adjacent B1 L1, orientation B1 east"),
    ("a family bathroom and a guest toilet next to the entrance, two bedrooms", "B2 H K L W2",
     "near W2 entrance, !near W1 entrance"),
    ("a study and a bathroom are near the entrance, two bedrooms", "B2 H K L S W", "near S1 entrance, near W1 "
                                                                                   "entrance"),
]  # fmt: skip
DOORS = [
    ("Two bedrooms, one bathroom. There should be a door between the kitchen and the dining room but none between the "
     "kitchen and the hallway.", "B2 D H K L W", "D1K1, no_door K1 H1, !K1W1, H1W1"),
    ("3 bedroom flat, one bathroom between the second and third bedrooms, with a door to each", "B3 H K L W",
     "B2W1, B3W1, !B2B3"),
    ("Dos dormitorios, el baño no debe tener puerta a la cocina.", "B2 H K L W", "no_door W1 K1"),
    ("Dos dormitorios. El lavadero debe tener puerta a la cocina.", "B2 H K L U W", "K1U1"),
    ("one bedroom, the bathroom is between the bedroom and the kitchen", "B H K L W",
     "adjacent W1 B1, adjacent W1 K1, H1W1, !K1W1"),
    ("I want make apartment for 2 persons with 1 sleeping room, 1 bath, kitchen is open with salon", "B H K L W",
     "K1~L1, H1W1"),
]
AREAS = [
    ("Two-bedroom flat. The master bedroom should be at least 15 square metres, the other bedroom no more than 11.",
     "B2 H K L W", "at_least B1 15, at_most B2 11"),
    ("kitchen 12, living 25, 2 bedrooms 14 and 11, bath 5", "B2 H K L W", "B1=14, B2=11, K1=12, L1=25, W1=5"),
    ("La cuisine doit être ouverte sur le séjour et faire au moins 12 m2, avec deux chambres", "B2 H K L W",
     "at_least K1 12, K1~L1"),
    ("one-bedroom flat with kitchen open to the living room, 40 m2", "B H K L W", "!L1=40"),
    ("one-bedroom flat with a large living room, 40 m2", "B H K L W", "L1=40"),
    ("Un dormitorio de 12 m², un estudio de 9 m², sin balcón.", "B H K L S W", "B1=12, S1=9"),
    ("两个卧室，要一个大阳台", "B2 H K L W Y", "Y1=6.5"),
]
TYPED = [
    ("1BR, bay window", "B H K L W", "unread bay window"),
    ("2 bedrooms next to each other, kitchen far from them", "B2 H K L W", "apart K1 B1, apart K1 B2"),
    ("The child room should be in front of our bedroom.", "B2 H K L W", "opposite B2 B1"),
    ("It should has a big bathroom with washing machine inside. One bedroom.", "B H K L W",
     "W1 has 1 washing_machine"),
    ("Two bedrooms, in first one bed for two person and in second two beds for childrens.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Area must be from 60 until 70 square meters with two bedrooms.", "B2 H K L W",
     "at_least home 60, at_most home 70"),
    ("Kitchen with the table for 4 person, two bedrooms.", "B2 H K L W", "K1 has 1 dining_table, K1 has 4 chair"),
    ("Zweizimmerwohnung mit Wannenbad", "B H K L W", "W1 has 1 bath"),
    ("Deux chambres, chacune avec un placard et un bureau", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 desk"),
    ("Casa para seis personas con tres baños", "B5 H K L W3", ""),
    ("El dormitorio principal tiene que medir por lo menos 15 m² y tener balcón; otro dormitorio de 10 m²",
     "B2 H K L W Y", "at_least B1 15, B1Y1"),
    ("La chambre des enfants doit être à côté de la nôtre, et la salle de bains entre les deux", "B2 H K L W",
     "adjacent B2 B1, B1W1, B2W1"),
    ("The kids room must be next to ours, and the bathroom between the two.", "B2 H K L W",
     "adjacent B2 B1, B1W1, B2W1"),
    ("Das Kinderzimmer soll neben unserem liegen", "B2 H K L W", "adjacent B2 B1"),
    ("living room minimum 20 square meters maximum 25, 2 bedrooms", "B2 H K L W", "at_least L1 20, at_most L1 25"),
    ("The kitchen should be next to the entrance and the bedroom at the back", "B H K L W",
     "near K1 entrance, position B1 back"),
    ("dos dormitorios dobles y uno individual", "B3 H K L W2", "B3=8, !unread dobles"),
    ("deux chambres doubles et une simple", "B3 H K L W2", "B3=8"),
    ("zwei Doppelzimmer und ein Einzelzimmer", "B3 H K L W2", "B3=8"),
    ("There should be two ways to get to the kitchen: from the hall and from the living room. Two bedrooms.",
     "B2 H K L W", "H1K1, K1L1"),
]
CORNERS = [
    ("dos dormitorios y un despacho en la esquina noreste", "B2 H K L S W", "position S1 north_east"),
    ("deux chambres, la cuisine dans l'angle nord-ouest", "B2 H K L W", "position K1 north_west"),
    ("zwei Schlafzimmer, die Küche in der Nordwestecke", "B2 H K L W", "position K1 north_west"),
    ("zwei Schlafzimmer, die Küche in der nordöstlichen Ecke", "B2 H K L W", "position K1 north_east"),
    ("两个卧室，一个在东边一个在西边", "B2 H K L W", "position B1 east, position B2 west"),
]
USES = [
    ("Un deux-pièces avec un bureau qui sert aussi de chambre d'amis", "B H K L S W", "use S1 bedroom"),
    ("zwei Schlafzimmer und ein Arbeitszimmer, das auch als Gästezimmer dient", "B2 H K L S W", "use S1 bedroom"),
    ("dos dormitorios y un despacho que también sirve de cuarto de invitados", "B2 H K L S W", "use S1 bedroom"),
]
LEARNT = [
    ("We are 3 students, every of us needs own room with desk.", "B3 H K L W2", "B1 has 1 desk, B3 has 1 desk"),
    ("We are students, four peoples, everyone wants own room, two bathrooms from the corridor", "B4 H K L W2",
     "H1W1, H1W2"),
    ("The living room must be most big room in the flat with three bedrooms.", "B3 H K L W2", "order L1 largest"),
    ("Please give wardrobe in both bedroom and one sofa in the living.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe, L1 has 1 sofa"),
    ("In the bedroom of the parents I want one big bed and two small tables.", "B H K L W",
     "B1 has 1 double_bed, B1 has 2 nightstand"),
    ("three bed, one facing garden", "B3 H K L W2", "position B1 back"),
    ("deux chambres et une salle de douche", "B2 H K L W", "!unread salle"),
    ("quatre chambres dont une suite parentale avec salle de bain, une autre salle de bain", "B4 H K L W2", "B1W1, "
                                                                                                            "H1W2"),
]
EVERYBODY = [
    ("A flat for four students? Each one gets a bedroom and there are two bathrooms off the corridor.", "B4 H K L W2",
     "H1W1, H1W2"),
    ("Two grown-up brothers and their father live together. Everybody has his own bedroom.", "B3 H K L W2", ""),
    ("Three sisters and their mother share a flat; each of them has her own bedroom.", "B4 H K L W2", ""),
    ("My grandmother lives with us, so her bedroom has to be near the entrance. There is our bedroom and one for our "
     "son.", "B3 H K L W2", "near B2 entrance"),
    ("We are a couple with a baby who sleeps in ours.", "B H K L W", "!unread sleeps"),
    ("My husband and I and the baby, who sleeps in our room, need a study.", "B H K L S W", ""),
    ("Wohnung mit drei Schlafzimmern. Das Zimmer für meine Tochter neben unserem Schlafzimmer.", "B3 H K L W2",
     "adjacent B3 B1"),
]
THE_REST = [
    ("Two-bedroom flat with a study. The study opens off the living room, everything else as usual.", "B2 H K L S W",
     "L1S1, B1H1, H1K1, H1W1, !H1S1"),
    ("Everything except a balcony: living room, kitchen, two bedrooms, bathroom, hallway.", "B2 H K L W", ""),
    ("Everything except the kitchen faces south. Two bedrooms.", "B2 H K L W",
     "orientation L1 south, !orientation K1 south"),
    ("make it 4 bedrooms. no wait, 3 is enough. 2 baths", "B3 H K L W2", ""),
    ("Three bedrooms. 2 is fine as it is, 3 faces south.", "B3 H K L W2", "orientation B3 south"),
    ("Je veux que la cuisine soit plus petite que le salon et que la chambre donne au nord.", "B H K L W",
     "orientation B1 north, !orientation L1 north"),
    ("Dos dormitorios y un baño. El baño frente al dormitorio principal, la cocina cerca de la entrada.", "B2 H K L W",
     "opposite W1 B1, near K1 entrance, !opposite W1 K1"),
    ("一室一厅，45平米左右，开放式厨房", "B H K L W", "all=45, K1~L1"),
    ("一室一厅，约45平米左右", "B H K L W", "all=45"),
    ("大约120平米左右的三室两厅", "B3 D H K L W2", "all=120"),
    ("不要三个卧室，两个就够了，阳台连着主卧。", "B2 H K L W Y", "B1Y1"),
    ("三室两厅一卫，客厅是最大的房间。", "B3 D H K L W", "order L1 largest"),
]

test_every_home_is_furnished = as_meant(FURNISHED)
test_what_is_said_of_the_last_of_two = as_meant(LAST_OF_TWO)
test_doors = as_meant(DOORS)
test_areas = as_meant(AREAS)
test_as_people_type = as_meant(TYPED)
test_corners = as_meant(CORNERS)
test_rooms_with_two_uses = as_meant(USES)
test_english_of_learners = as_meant(LEARNT)
test_a_room_for_everybody = as_meant(EVERYBODY)
test_what_is_said_of_the_rest = as_meant(THE_REST)
