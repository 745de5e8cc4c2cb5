"""The constructions of furniture, areas, halls, owners and numbers taken back in further words."""

from sentences.facts import as_meant

BEDS = [
    ("Bachelor flat. Furniture of the main room: one bed, one table, two chairs.", "K L W", "L1 has 1 double_bed"),
    ("Studio for manipulation tasks: the room contains one bed, one nightstand and a lamp.", "K L W",
     "L1 has 1 double_bed"),
    ("A studio with a separate kitchen; the main room is to hold one bed and no sofa.", "K L W",
     "L1 has 1 double_bed, L1 has 0 sofa"),
    ("Studio with one bathroom. One single bed and one desk in the main room.", "K L W",
     "L1 has 1 single_bed, L1 has 1 desk"),
    ("Two bedroom flat, with one bed in the first bedroom and two beds in the second.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 double_bed"),
    ("Place 1 bed, 1 wardrobe and 1 chair in the bedroom of a one-bedroom flat.", "B H K L W",
     "B1 has 1 double_bed, B1 has 1 wardrobe"),
    ("3 bed flat with sofa and tv in the living room.", "B3 H K L W2", "L1 has 1 sofa"),
    ("One bed flat with a desk in the living room.", "B H K L W", "L1 has 1 desk"),
    ("1 bed, 1 bath, sofa in the lounge.", "B H K L W", "L1 has 1 sofa"),
]  # fmt: skip

AREAS = [
    ("Three bedrooms with areas 9, 11 and 14 m², one bathroom.", "B3 H K L W", "B1=9, B2=11, B3=14"),
    ("Three bedrooms, one bathroom. Areas of bedrooms: 9 m², 11 m², 14 m².", "B3 H K L W", "B1=9, B2=11, B3=14"),
    ("The three bedrooms should have 9, 11 and 14 square metres; one bathroom.", "B3 H K L W", "B1=9, B2=11, B3=14"),
    ("Two bedrooms of 10 and 12 m² and two bathrooms of 4 and 6 m².", "B2 H K L W2", "B1=10, B2=12, W1=4, W2=6"),
    ("Two bedrooms and a bathroom. The area of the bedrooms is 10 and 14 m².", "B2 H K L W", "B1=10, B2=14"),
    ("Two bedrooms; bedroom areas 10 and 14 m².", "B2 H K L W", "B1=10, B2=14"),
    ("I need two bedrooms, 10 m² and 14 m², and a bathroom of 5 m².", "B2 H K L W", "B1=10, B2=14, W1=5"),
    ("Drei Schlafzimmer, die Flächen der Schlafzimmer sind 9, 11 und 14 m². Ein Bad.", "B3 H K L W",
     "B1=9, B2=11, B3=14"),
    ("Tres dormitorios de 9, 11 y 14 m², un baño.", "B3 H K L W", "B1=9, B2=11, B3=14"),
]  # fmt: skip

HALLS = [
    ("Entrance hall giving access to living room, kitchen and WC; bedroom corridor giving access to two "
     "bedrooms and a bathroom.", "B2 H2 K L W2", "H1L1, H1K1, H1W1, B1H2, B2H2, H2W2"),
    ("A front hall leads to the kitchen and living room, and a back hall leads to the two bedrooms and "
     "bathroom.", "B2 H2 K L W", "H1L1, H1K1, B1H2, B2H2, H2W1"),
    ("The entrance hall connects the living room, the kitchen and the night corridor; the night corridor "
     "connects three bedrooms and a bathroom.", "B3 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, B3H2, H2W1"),
    ("Two corridors: one serves the living room and the kitchen, the other serves two bedrooms and a "
     "bathroom.", "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
    ("From the hall: living room, kitchen, night corridor. From the night corridor: two bedrooms, "
     "bathroom.", "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
    ("A night corridor serving two bedrooms and a bathroom is reached from the entrance hall, which also "
     "serves the living room and the kitchen.", "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
]  # fmt: skip

WIDE = [
    ("One bedroom. Kitchen and living room are connected by an opening without a door.", "B H K L W", "K1~L1"),
    ("One bedroom. There is a wide opening between the kitchen and the dining room and no door.", "B D H K L W",
     "D1~K1"),
    ("One bedroom, dining room with an open archway, no door, to the living room.", "B D H K L W", "D1~L1"),
    ("One bedroom. Instead of a door, there is a wide opening between the living room and the kitchen.", "B H K L W",
     "K1~L1"),
    ("One bedroom. The living room should have a doorless opening to the kitchen.", "B H K L W", "K1~L1"),
    ("One bedroom. No door but a wide opening between living room and kitchen.", "B H K L W", "K1~L1"),
    ("One bedroom. The dining room and the living room are joined through a broad opening.", "B D H K L W", "D1~L1"),
]  # fmt: skip

FLATS = [
    ("One bedroom, a big mirror in the hall, and a bath in the bathroom.", "B H K L W", "H1 has 1 mirror"),
    ("I just need one bedroom. No carpet in the living room.", "B H K L W", ""),
    ("I am a widow. One bedroom will do. The kitchen should have a small table.", "B H K L W", ""),
    ("One bedroom please; my piano goes in the lounge.", "B H K L W", "L1 has 1 piano"),
    ("I'm alone and only need one bedroom, with a comfortable armchair in the sitting room.", "B H K L W",
     "L1 has 1 armchair"),
    ("My needs are simple: one bedroom, and a bookcase in the living room.", "B H K L W", "L1 has 1 bookshelf"),
]  # fmt: skip

OWN = [
    ("My sister and I both want our own bedroom with our own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("Each of us two wants our own bedroom, and each bedroom its own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("My husband and I would each like our own bedroom. Both bedrooms with ensuite.", "B2 H K L W2", "B1W1, B2W2"),
    ("My friend and I want separate bedrooms, each with its own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("My daughter and I each need a bedroom of our own. One bathroom.", "B2 H K L W", ""),
    ("Me and my sister each need our own room, and one bathroom.", "B2 H K L W", ""),
    ("My two sisters and I each want our own bedroom. Two bathrooms.", "B3 H K L W2", ""),
]  # fmt: skip

APART = [
    ("My husband and I sleep in separate bedrooms, far apart from each other. One bathroom.", "B2 H K L W",
     "apart B1 B2"),
    ("My husband snores. I want my bedroom far away from his. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("He snores, so two bedrooms please, as far from each other as possible. One bathroom.", "B2 H K L W",
     "apart B1 B2"),
    ("One bedroom for my husband, one for me, and they must be far from one another. One bathroom.", "B2 H K L W",
     "apart B1 B2"),
    ("My wife gets the bigger bedroom and I get the smaller one. One bathroom.", "B2 H K L W", ""),
    ("He has one bedroom, and the other one is mine, at the far end from his. One bathroom.", "B2 H K L W", ""),
]  # fmt: skip

TOO_MANY = [
    ("I had three bedrooms, which is too many. One is enough now. One bathroom.", "B H K L W", ""),
    ("We have four bedrooms now and don't need that many; two would do. One bathroom.", "B2 H K L W", ""),
    ("I don't need three bedrooms any more, just one. A kitchen, a living room, a bathroom.", "B H K L W", ""),
    ("Three bedrooms are too many to clean. Make it two. One bathroom.", "B2 H K L W", ""),
    ("Two bedrooms are too many for an old woman like me, so one bedroom only, please, and one bathroom.", "B H K L W",
     ""),
    ("Three bedrooms, which is one too many: two. One bathroom.", "B2 H K L W", ""),
    ("I need fewer rooms now: instead of three bedrooms just one.", "B H K L W", ""),
]  # fmt: skip

STAIRS = [
    ("Two bedrooms. I do not want any stairs.", "B2 H K L W", "unread stairs"),
    ("Two bedrooms, everything on one floor, no staircase.", "B2 H K L W", "unread staircase"),
    ("A flat with two bedrooms and no steps to climb.", "B2 H K L W", "unread steps"),
    ("两室一厅，没有楼梯。", "B2 H K L W", "unread 楼梯"),
]  # fmt: skip

PIECES = [
    ("Piso de dos dormitorios con dos butacas en el salón y un escritorio en cada dormitorio.", "B2 H K L W",
     "L1 has 2 armchair, B1 has 1 desk, B2 has 1 desk"),
    ("En el salón quiero un sofá, una mesa de centro y una lámpara. Un dormitorio, un baño.", "B H K L W",
     "L1 has 1 sofa, L1 has 1 coffee_table"),
    ("Appartement deux chambres : dans chaque chambre un lit et un bureau.", "B2 H K L W",
     "B1 has 1 double_bed, B1 has 1 desk, B2 has 1 desk"),
    ("Un T3 avec un canapé et une télé dans le salon, et un bureau pour travailler.", "B2 H K L S W",
     "L1 has 1 sofa"),
    ("Une chambre ; un bureau et une bibliothèque dans le séjour ; une salle de bains, une cuisine.", "B H K L W",
     "L1 has 1 desk, L1 has 1 bookshelf"),
    ("Zweizimmerwohnung; im Schlafzimmer ein Doppelbett und ein Schrank, im Wohnzimmer ein Sessel, ein Sofa "
     "und ein Couchtisch.", "B H K L W",
     "B1 has 1 double_bed, B1 has 1 wardrobe, L1 has 1 armchair, L1 has 1 coffee_table"),
    ("Zwei Schlafzimmer, in jedem ein Schreibtisch, ein Bad.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("三室两厅，书桌放在次卧，客厅要有沙发和茶几，主卧放一张大床。", "B3 D H K L W2",
     "B2 has 1 desk, L1 has 1 sofa, L1 has 1 coffee_table, B1 has 1 double_bed"),
    ("一室一厅，客厅里两把扶手椅，不要电视。", "B H K L W", "L1 has 2 armchair, L1 has 0 tv"),
    ("Un estudio con baño; una cama y dos sillas.", "K L W", "L1 has 1 double_bed, L1 has 2 chair"),
]  # fmt: skip

EVERY = [
    ("Flat with two bedrooms, bath, kitchen. Wardrobe must be in every bedroom.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("I need three bedroom. In all of the bedrooms I want desk.", "B3 H K L W2", "B1 has 1 desk, B3 has 1 desk"),
    ("Two bedrooms, and in each a wardrobe.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedrooms. In the every room must be one lamp.", "B2 H K L W", "B1 has 1 table_lamp, L1 has 1 table_lamp"),
    ("Two bedrooms. It must be a wardrobe in each bedroom.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedrooms. In both of bedrooms is needed a desk.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
]  # fmt: skip

LISTED = [
    ("A flat: one bedroom, kitchen, bathroom. These three have doors to the hall.", "B H K L W", "B1H1, H1K1, H1W1"),
    ("A flat with a bedroom, a study and a kitchen. The three of them open off the living room.", "B H K L S W",
     "B1L1, L1S1, K1L1"),
    ("Two bedrooms, study, bathroom. All of these are entered from the corridor.", "B2 H K L S W",
     "B1H1, B2H1, H1S1, H1W1"),
    ("One bedroom flat. A pantry and a utility room, both off the kitchen.", "B H K L T U W", "K1T1, K1U1"),
    ("Three bedrooms, one bathroom. All three have a wardrobe.", "B3 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe, B3 has 1 wardrobe"),
]  # fmt: skip

OPPOSITE = [
    ("One bedroom flat. Across the hallway from the kitchen is the bathroom.", "B H K L W", "opposite W1 K1"),
    ("One bedroom flat. The kitchen lies opposite the bathroom, the hall running between them.", "B H K L W",
     "opposite K1 W1, !opposite K1 H1"),
    ("One bedroom flat. The bedroom door and the bathroom door face each other across the corridor.", "B H K L W",
     "opposite B1 W1"),
    ("One bedroom flat. On the other side of the hallway, opposite the living room, is the bedroom.", "B H K L W",
     "opposite B1 L1"),
    ("Ein Schlafzimmer; das Bad liegt gegenüber dem Schlafzimmer, auf der anderen Seite des Flurs.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("Une chambre ; la salle de bains est en face de la chambre, de l'autre côté du couloir.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("Un dormitorio; el baño está frente al dormitorio, al otro lado del pasillo.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
]  # fmt: skip

BATHS = [
    ("三室两厅两卫，主卧套间带卫浴，公卫开门向走廊。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
    ("我要一套三居室，两个卫生间，一个在主卧里，另一个在走廊边。", "B3 H K L W2", "B1W1, H1W2, !B2W2"),
    ("两室两厅一卫，厨房挨着餐厅，卫生间对着走廊。", "B2 D H K L W", "H1W1"),
    ("四室两厅两卫，其中一个卫生间属于主卧，另一个大家共用。", "B4 D H K L W2", "B1W1, H1W2"),
    ("三室两厅两卫，只有主卧有独立卫生间。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
]  # fmt: skip

LOOKALIKE = [
    ("Three-bedroom flat, one bed in each bedroom.", "B3 H K L W2", "B1 has 1 double_bed, B3 has 1 double_bed"),
    ("A flat with one bed and one bath.", "B H K L W", ""),
    ("2 beds, 1 bath, desk in the living room.", "B2 H K L W", "L1 has 1 desk"),
    ("Flat with two beds and two baths.", "B2 H K L W2", ""),
    ("One bed flat with a sofa.", "B H K L W", "L1 has 1 sofa"),
    ("Three bedrooms, two bathrooms. All three have a wardrobe.", "B3 H K L W2",
     "B1 has 1 wardrobe, B3 has 1 wardrobe"),
    ("Two bedrooms; no corridor anywhere.", "B2 K L W", ""),
    ("Two bedrooms, no balcony in the flat.", "B2 H K L W", ""),
    ("A bedroom and a living room.", "B L", ""),
    ("One bedroom and one bathroom, nothing else.", "B W", ""),
    ("The bathroom faces north, the kitchen south. Two bedrooms.", "B2 H K L W",
     "orientation W1 north, orientation K1 south"),
    ("The bedroom faces north or south. One-bedroom flat.", "B H K L W", ""),
    ("Un appartement de deux chambres avec un bureau et une buanderie.", "B2 H K L S U W", ""),
    ("Un studio avec un bureau séparé.", "K L S W", ""),
    ("Eine Wohnung mit zwei Schlafzimmern und einem begehbaren Kleiderschrank.", "B2 C H K L W", ""),
    ("Two bedrooms. The kitchen is across the hall from the living room, and the pantry opens off the "
     "kitchen.", "B2 H K L T W", "opposite K1 L1, K1T1"),
    ("One bedroom for my daughter and another for me. One bathroom.", "B2 H K L W", ""),
    ("My sister gets one bedroom and I get another with a balcony. One bathroom.", "B2 H K L W Y", "B1Y1"),
    ("Two bedrooms, the study is far from the kitchen, no, from the living room.", "B2 H K L S W", "apart S1 L1"),
    ("Two bedrooms and no wall between kitchen and living room in the flat.", "B2 H K L W", "K1~L1"),
    ("Three bedrooms are enough, and two bathrooms.", "B3 H K L W2", ""),
    ("Three bedrooms are not too many for us. Two bathrooms.", "B3 H K L W2", ""),
    ("The kitchen and the bathroom are on the other side of the hall. One bedroom flat.", "B H K L W", ""),
]  # fmt: skip

ONCE_MORE = [
    ("Studio, 25 m². One bed against the wall, one armchair and a small table in the room.", "K L W",
     "L1 has 1 double_bed, L1 has 1 armchair"),
    ("Generate a studio with exactly one bed, one sofa and one tv stand; one bathroom.", "K L W",
     "L1 has 1 double_bed, L1 has 1 sofa"),
    ("Four bedrooms measuring 8, 9, 10 and 12 m², two bathrooms measuring 4 and 6 m².", "B4 H K L W2",
     "B1=8, B4=12, W1=4, W2=6"),
    ("The areas of the two bedrooms: 10 and 13 m². One bathroom of 5 m².", "B2 H K L W", "B1=10, B2=13, W1=5"),
    ("Main hall for the living room, kitchen and toilet; private corridor for the three bedrooms and the "
     "bathroom.", "B3 H2 K L W2",
     "H1L1, H1K1, B1H2, B2H2, B3H2"),
    ("Between the kitchen and the dining room no door, just a wide opening. One bedroom.", "B D H K L W", "D1~K1"),
    ("I live alone with my cat. One bedroom is plenty. Please put a rocking chair in the living room and "
     "no tv.", "B H K L W",
     "L1 has 0 tv"),
    ("My brother and I each want a bedroom with its own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("Grandmother gets one bedroom and I get another, right next to hers. One bathroom.", "B2 H K L W",
     "adjacent B1 B2"),
    ("Two bathrooms are too much cleaning for me; one will do. Two bedrooms.", "B2 H K L W", ""),
    ("We no longer need four bedrooms, only two. One bathroom.", "B2 H K L W", ""),
    ("No stairs please, my knees are bad. Two bedrooms.", "B2 H K L W", "unread stairs"),
    ("Quiero un piso de dos dormitorios; en cada dormitorio dos camas y una lámpara; en el salón una "
     "butaca y un sofá.", "B2 H K L W",
     "B1 has 2 double_bed, B2 has 2 double_bed, L1 has 1 armchair, L1 has 1 sofa"),
    ("Wohnung mit zwei Schlafzimmern. In jedem Schlafzimmer ein Bett und ein Schrank, im Wohnzimmer zwei "
     "Sessel.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe, L1 has 2 armchair"),
    ("I need flat with three bedroom. In each bedroom should stand one bed and one desk.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 desk, B3 has 1 desk"),
    ("Bedroom, bathroom, kitchen, living room. All four have door to corridor.", "B H K L W",
     "B1H1, H1W1, H1K1, H1L1"),
    ("Two bedrooms, a study and a bathroom. All four are off the corridor.", "B2 H K L S W",
     "B1H1, B2H1, H1S1, H1W1"),
    ("Flat with one bedroom. Bathroom is opposite to the bedroom, between them is the corridor.", "B H K L W",
     "opposite W1 B1"),
    ("三房两厅两卫，主人房带独立卫生间，另外一个卫生间开门在走廊。", "B3 D H K L W2", "B1W1, H1W2"),
    ("Two bedrooms, one tv in the living room and none in the other rooms.", "B2 H K L W",
     "L1 has 1 tv, B1 has 0 tv, B2 has 0 tv"),
    ("A desk and a bookcase in each of the two bedrooms, the same in the living room.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 desk, L1 has 1 desk, L1 has 1 bookshelf"),
    ("We are five: three kids, the two girls share and the boy has his own room.", "B3 H K L W2", ""),
    ("Two bedrooms. The balcony is on the south side, or no, the west side.", "B2 H K L W Y", "position Y1 west"),
]  # fmt: skip

test_a_bed_in_a_room_is_furniture = as_meant(BEDS)
test_areas_in_a_list_are_of_rooms_in_turn = as_meant(AREAS)
test_a_hall_serves_the_rooms_listed_behind_it = as_meant(HALLS)
test_an_opening_and_no_door_is_an_opening = as_meant(WIDE)
test_one_bedroom_and_furniture_is_a_flat = as_meant(FLATS)
test_each_has_their_own = as_meant(OWN)
test_one_gets_a_room_and_another_gets_another = as_meant(APART)
test_too_many_are_not_wanted = as_meant(TOO_MANY)
test_what_is_not_wanted_and_no_plan_has_is_told = as_meant(STAIRS)
test_pieces_of_furniture_stand_where_they_are_told = as_meant(PIECES)
test_every_room_is_furnished_by_learners_too = as_meant(EVERY)
test_all_of_those_are_the_rooms_just_listed = as_meant(LISTED)
test_opposite_is_one_wish_where_the_hall_is_between = as_meant(OPPOSITE)
test_the_other_bath_is_nobodys = as_meant(BATHS)
test_what_only_looks_alike_is_read_as_it_was = as_meant(LOOKALIKE)
test_the_programme_is_as_meant = as_meant(ONCE_MORE)
