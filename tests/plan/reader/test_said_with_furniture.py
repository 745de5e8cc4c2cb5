"""Who gets which room, what is too many, rooms just listed, desks and armchairs in four languages, other sides."""

from sentences.facts import as_meant

APART = [
    ("My husband snores, so he gets one bedroom and I get another, far away from his. One bathroom, a sitting room "
     "and a kitchen.", "B2 H K L W", "apart B1 B2"),
    ("He gets one bedroom and I get another. One bathroom.", "B2 H K L W", ""),
    ("My wife snores: she has one bedroom and I have another, far from hers. One bathroom.", "B2 H K L W",
     "apart B1 B2"),
    ("I take one bedroom and my brother takes the other, far from mine. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("My son gets a bedroom and I get another one, next to his. One bathroom.", "B2 H K L W", "adjacent B1 B2"),
    ("She wants one bedroom and I want another one. One bathroom, kitchen, living room.", "B2 H K L W", ""),
    ("He sleeps in one bedroom and I sleep in another, as far away from his as possible. One bathroom.", "B2 H K L W",
     "apart B1 B2"),
    ("My flatmate has one bedroom, I have another far away from his. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("One bedroom for him and another for me, far away from his. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("My father gets one bedroom and my mother gets another, far away from his. One bathroom, living room, kitchen.",
     "B2 H K L W", "apart B1 B2"),
    ("My husband snores, so he has his bedroom and I have mine, far away from his. One bathroom.", "B2 H K L W",
     "apart B1 B2"),
]  # fmt: skip

TOO_MANY = [
    ("Three bedrooms are too many for me now. I want just one, with a living room, a kitchen and a bathroom, and a "
     "larder off the kitchen for my preserves.", "B H K L T W", "K1T1"),
    ("Three bedrooms are too many for me. I want just one.", "B H K L W", ""),
    ("Four bedrooms is too much for us; two will do. One bathroom.", "B2 H K L W", ""),
    ("Two bathrooms are too many, one is enough. Three bedrooms.", "B3 H K L W", ""),
    ("Three bedrooms would be too many; two are fine. One bathroom.", "B2 H K L W", ""),
    ("Three bedrooms were too many for us. We need only two, and one bathroom.", "B2 H K L W", ""),
    ("Two bathrooms are more than we need. One is enough. Two bedrooms.", "B2 H K L W", ""),
    ("Our three bedrooms are too many now that the children have gone. We want two.", "B2 H K L W", ""),
    ("One bathroom is too few for us, we need two. Three bedrooms.", "B3 H K L W2", ""),
    ("One bedroom is not enough. I want two, with a kitchen and a bathroom.", "B2 H K L W", ""),
    ("Five bedrooms are too many for our family. Give us four, and two bathrooms.", "B4 H K L W2", ""),
]  # fmt: skip

STAIRS = [
    ("On the ground floor please, with no stairs. A living room, a kitchen, one bedroom, and a bathroom.",
     "B H K L W", "unread stairs"),
    ("A flat with one bedroom, without stairs.", "B H K L W", "unread stairs"),
    ("Two bedrooms, no stairs please.", "B2 H K L W", "unread stairs"),
    ("Two bedrooms, no lift.", "B2 H K L W", "unread lift"),
    ("Two bedrooms; no steps and no stairs anywhere.", "B2 H K L W", "unread stairs"),
    ("A flat with two bedrooms, no basement.", "B2 H K L W", "unread basement"),
    ("Zwei Schlafzimmer, ohne Treppen.", "B2 H K L W", "unread treppen"),
    ("Deux chambres, sans escalier.", "B2 H K L W", "unread escalier"),
    ("Dos dormitorios, sin escaleras.", "B2 H K L W", "unread escaleras"),
    ("A flat with one bedroom and no skylights.", "B H K L W", "unread skylights"),
    ("Two bedrooms, I cannot manage stairs.", "B2 H K L W", "unread stairs"),
]  # fmt: skip

PIECES = [
    ("Quisiera un piso con salón, cocina, un dormitorio y un baño; en el dormitorio dos camas y en el salón una "
     "butaca.", "B H K L W", "B1 has 2 double_bed, L1 has 1 armchair"),
    ("Un piso de un dormitorio; en el salón dos butacas y una mesita.", "B H K L W", "L1 has 2 armchair"),
    ("Dos dormitorios, un baño; en cada dormitorio una cama y un armario.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 wardrobe"),
    ("Un estudio con una cama, un escritorio y una estantería en la habitación principal.", "K L W",
     "L1 has 1 double_bed, L1 has 1 desk"),
    ("Deux chambres, un salon avec un canapé et deux fauteuils, une salle de bains.", "B2 H K L W",
     "L1 has 1 sofa, L1 has 2 armchair"),
    ("Un T2 ; dans la chambre un lit et une armoire, dans le salon un fauteuil.", "B H K L W",
     "B1 has 1 double_bed, B1 has 1 wardrobe, L1 has 1 armchair"),
    ("Zwei Schlafzimmer, ein Bad; im Wohnzimmer ein Sofa und zwei Sessel.", "B2 H K L W",
     "L1 has 1 sofa, L1 has 2 armchair"),
    ("Ein Schlafzimmer mit Bett und Kleiderschrank, ein Wohnzimmer mit Sessel und Fernseher, Küche, Bad.", "B H K L W",
     "B1 has 1 wardrobe, L1 has 1 armchair, L1 has 1 tv"),
    ("两室一厅一卫，客厅放一张沙发和两把扶手椅。", "B2 H K L W", "L1 has 1 sofa, L1 has 2 armchair"),
    ("一室一厅，卧室放一张床和一个衣柜，客厅放一台电视。", "B H K L W",
     "B1 has 1 double_bed, B1 has 1 wardrobe, L1 has 1 tv"),
    ("Je cherche un studio de 28 m² avec une salle d'eau et un balcon ; un lit et un bureau dans la pièce principale.",
     "K L W Y", "L1 has 1 double_bed, L1 has 1 desk, all=28"),
    ("Un studio avec un lit, un bureau et une armoire.", "K L W", "L1 has 1 desk"),
    ("Deux chambres, une salle de bains ; une armoire et un bureau dans le salon.", "B2 H K L W",
     "L1 has 1 desk, L1 has 1 wardrobe"),
    ("Un appartement avec deux chambres, un bureau et une cuisine.", "B2 H K L S W", ""),
    ("Une chambre avec un lit, un bureau et une chaise, un salon, une cuisine, une salle de bains.", "B H K L W",
     "B1 has 1 desk"),
]  # fmt: skip

EVERY = [
    ("I want flat with two bedroom, one bathroom, kitchen and living room. In the every bedroom must be one wardrobe.",
     "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedroom, one bathroom. In every bedroom must be one desk.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("Three bedrooms. In the each bedroom there is a wardrobe.", "B3 H K L W2", "B1 has 1 wardrobe, B3 has 1 wardrobe"),
    ("Two bedrooms. In the both bedrooms must be wardrobe.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedrooms. The every bedroom has one desk.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("Two bedrooms, one bathroom. In each of bedrooms must be a wardrobe.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedrooms. In the all bedrooms should be one armchair.", "B2 H K L W", "B1 has 1 armchair, B2 has 1 armchair"),
    ("Two bedrooms. Every bedrooms must have one wardrobe.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedrooms. Must be one wardrobe in the every bedroom.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("Two bedrooms. The each bedroom must have the desk.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("Two bedrooms. In every of the bedrooms must stand one wardrobe.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe"),
]  # fmt: skip

LISTED = [
    ("I need the flat without living room. Only one bedroom, kitchen and bathroom. All three have the door to the "
     "corridor.", "B H K W", "B1H1, H1K1, H1W1"),
    ("A bedroom, a kitchen, a bathroom and a living room. All four open off the hallway.", "B H K L W",
     "B1H1, H1K1, H1W1, H1L1"),
    ("One bedroom, kitchen, living room, bathroom. Each of them has a door to the hall.", "B H K L W",
     "B1H1, H1K1, H1L1, H1W1"),
    ("Two bedrooms. A study and a pantry. Both have a door to the kitchen.", "B2 H K L S T W", "K1S1, K1T1, !B1K1"),
    ("One bedroom, one bathroom, a kitchen. They all have doors to the living room, no hall.", "B K L W",
     "B1L1, K1L1, L1W1"),
    ("Bedroom, kitchen and bathroom; all three open into the living room.", "B K L W", "B1L1, K1L1, L1W1"),
    ("Two bedrooms and one bathroom. All three are off the hallway.", "B2 H K L W", "B1H1, B2H1, H1W1"),
    ("Only one bedroom, kitchen and bathroom, without living room. All of them have the door to the corridor.",
     "B H K W", "B1H1, H1K1, H1W1"),
    ("Three bedrooms and two bathrooms. All five rooms are off the corridor.", "B3 H K L W2",
     "B1H1, B2H1, B3H1, H1W1, H1W2"),
    ("A dining room and a kitchen. Both open off the hall. Two bedrooms.", "B2 D H K L W", "D1H1, H1K1"),
    ("A flat with one bedroom, a study and a bathroom. All three rooms have a door to the hallway.", "B H K L S W",
     "B1H1, H1S1, H1W1"),
]  # fmt: skip

OPPOSITE = [
    ("One bedroom flat. The bathroom must be opposite the bedroom, on other side of the corridor. To the kitchen we go "
     "only from the living room.", "B H K L W", "opposite W1 B1, K1L1, !opposite W1 H1, !H1K1"),
    ("One bedroom flat. The bathroom is opposite the bedroom, across the hall.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("One bedroom. The kitchen is opposite the living room, on the other side of the hallway.", "B H K L W",
     "opposite K1 L1, !opposite K1 H1"),
    ("One bedroom flat. The bathroom is on the other side of the corridor, opposite the bedroom.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("One bedroom flat. Opposite the bedroom, on the opposite side of the corridor, is the bathroom.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("One bedroom flat. The bathroom must be across from the bedroom, on the other side of the hall.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("Two bedrooms. The study is across the corridor from the kitchen.", "B2 H K L S W",
     "opposite S1 K1, !opposite S1 H1"),
    ("One bedroom flat. The bathroom faces the bedroom across the corridor.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("One bedroom flat. The bathroom is opposite the bedroom, with the corridor between them.", "B H K L W",
     "opposite W1 B1, !opposite W1 H1"),
    ("One bedroom. To the pantry you go only from the kitchen.", "B H K L T W", "K1T1, !H1T1"),
    ("One bedroom. Into the kitchen we come only from the living room.", "B H K L W", "K1L1, !H1K1"),
]  # fmt: skip

BATHS = [
    ("我想要三室两厅两卫的房子，主卧带独立卫生间，另一个卫生间的门开向走廊，阳台连着客厅。", "B3 D H K L W2 Y",
     "B1W1, H1W2, L1Y1, !B2W2"),
    ("三室两厅两卫，主卧带独立卫生间，另一个卫生间在走廊。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
    ("三室两厅两卫，主卧有独立卫生间，另外一个卫生间通向走廊。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
    ("三室一厅两卫，主卧带卫生间，另一个卫生间的门通向走廊。", "B3 H K L W2", "B1W1, H1W2, !B2W2"),
    ("两室两厅两卫，主卧带独立浴室，另一个浴室开向走廊。", "B2 D H K L W2", "B1W2, H1W1, !B2W2"),
    ("四室两厅三卫，主卧带独立卫生间，其他两个卫生间都通向走廊。", "B4 D H K L W3", "B1W1, H1W2, H1W3, !B2W2"),
    ("三室两厅两卫，主卧独立卫生间，公共卫生间的门开向走廊。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
    ("三室两厅两卫，主卧自带卫生间。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
    ("三室两厅两卫，主卧带独立卫生间，第二个卫生间在走廊上。", "B3 D H K L W2", "B1W1, H1W2, !B2W2"),
    ("两室一厅两卫，一个卫生间在主卧，另一个的门开向走廊。", "B2 H K L W2", "B1W1, H1W2, !B2W2"),
    ("三室两厅一卫，卫生间的门开向走廊，阳台连着客厅。", "B3 D H K L W Y", "H1W1, L1Y1"),
]  # fmt: skip

test_one_gets_a_room_and_another_gets_another = as_meant(APART)
test_too_many_are_not_wanted = as_meant(TOO_MANY)
test_what_is_not_wanted_and_no_plan_has_is_told = as_meant(STAIRS)
test_pieces_of_furniture_stand_where_they_are_told = as_meant(PIECES)
test_every_room_is_furnished_by_learners_too = as_meant(EVERY)
test_all_of_those_are_the_rooms_just_listed = as_meant(LISTED)
test_opposite_is_one_wish_where_the_hall_is_between = as_meant(OPPOSITE)
test_the_other_bath_is_nobodys = as_meant(BATHS)
