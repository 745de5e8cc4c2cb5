"""Rooms told of again without an article, lists of things before their room, and what is no bed and no studio."""

from sentences.facts import as_meant

test_counted_once = as_meant([
    ("Bedrooms: 2. Bathrooms: 1. Child's bedroom needs a desk.", "B2 H K L W", "B2 has 1 desk"),
    ("Two bedrooms, one bathroom. Baby's room is next to the kitchen.", "B2 H K L W", "adjacent B2 K1"),
    ("We are couple with one baby. Need two bedrooms, baby room next to our bedroom.", "B2 H K L W", "adjacent B2 B1"),
    ("Two bedrooms and a child's bedroom with a desk.", "B3 H K L W2", "B3 has 1 desk"),
    ("bachelor flat, one bedroom", "B H K L W", "B1H1, H1L1"),
    ("bachelor pad with one bedroom and a balcony", "B H K L W Y", "B1H1"),
    ("bachelor flat", "K L W", "L1 has 1 double_bed"),
])
test_things_before_their_room = as_meant([
    ("one-bedroom flat with a dining table for four, a sofa and a bookshelf in the living room", "B H K L W",
     "L1 has 4 chair, L1 has 1 dining_table, L1 has 1 sofa, L1 has 1 bookshelf"),
    ("two-bedroom flat with a desk, a chair and a floor lamp in the living room", "B2 H K L W",
     "L1 has 1 desk, L1 has 1 chair"),
    ("two-bedroom flat with a bathtub, a sofa and a desk in the living room", "B2 H K L W",
     "W1 has 1 bath, L1 has 1 desk"),
    ("one-bedroom flat, a dog bed in the living room", "B H K L W", "unread dog bed, !L1 has 1 double_bed"),
    ("two-bedroom flat with a wash machine in the bathroom", "B2 H K L W", "W1 has 1 washing_machine"),
    ("two-bedroom flat, a big kitchen with table where we can eat", "B2 H K L W", "K1 has 1 dining_table, !unread eat"),
    ("I play the piano, so a living room big enough for a grand piano, plus one bedroom", "B H K L W",
     "L1 has 1 piano, !unread music, !unread play"),
    ("两室一厅,客厅要放一张大沙发。", "B2 H K L W", "L1 has 1 sofa, B1=14"),
])
test_doors_and_places = as_meant([
    ("One bedroom, a kitchen, a living room and a bathroom with doors to the bedroom and to the hall.", "B H K L W",
     "B1W1, H1W1, B1H1, !B1L1"),
    ("house with one bedroom, a kitchen, a living room and a bathroom that can be entered both from the bedroom "
     "and from "
     "the hall", "B H K L W", "B1W1, H1W1, B1H1, !B1L1"),
    ("two-bedroom house with a long hallway and a bathroom at the far end of it", "B2 H K L W",
     "position W1 back, !position H1 back"),
    ("bedrooms: 3\nbathrooms: 1\nguest_wc: 1\nnot_adjacent: [guest_wc, kitchen]", "B3 H K L W2", "apart W2 K1"),
    ("piso de dos dormitorios, el baño y la cocina tienen puerta al salón", "B2 H K L W", "L1W1, K1L1, !unread puerta"),
    ("piso con una terraza a la que se sale desde el salón", "B2 H K L W Y", "L1Y1, !unread sale"),
    ("四室两厅两卫,餐厅和厨房相连,厨房不要开放式", "B4 D H K L W2", "D1K1, !D1~K1"),
    ("四室两厅两卫,餐厅和厨房相连", "B4 D H K L W2", "D1~K1"),
])  # fmt: skip
