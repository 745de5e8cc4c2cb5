"""Rooms of people who write of themselves as parents or children, and who sleep in one room, another, a third."""

from sentences.facts import as_meant

TOLD = [
    # bedrooms that are summed up
    ("We are five: three children who each want their own room, and the two of us. That makes four bedrooms. "
     "One bathroom.", "B4 H K L W", ""),
    ("Zwei Kinder, jedes braucht ein eigenes Zimmer, und wir Eltern haben unser eigenes Schlafzimmer. Das macht drei "
     "Schlafzimmer. Ein Bad.", "B3 H K L W", ""),
    ("Nous avons trois enfants qui veulent chacun leur chambre, et nous deux. Cela fait quatre chambres. Une salle de "
     "bain.", "B4 H K L W", ""),
    ("Our son needs a room, my mother needs one, and we have ours, which makes three bedrooms and one bathroom.",
     "B3 H K L W", ""),
    # parents and children who write
    ("Die beiden Kinder teilen sich ein Zimmer mit einem Etagenbett, wir Eltern haben unser eigenes Schlafzimmer. Ein "
     "Bad.", "B2 H K L W", "B2 has 1 bunk_bed"),
    ("Les deux enfants partagent une chambre, nous les parents avons notre propre chambre. Une salle de bain.",
     "B2 H K L W", ""),
    ("Los dos hijos comparten una habitación, nosotros los padres tenemos nuestro propio dormitorio. Un baño.",
     "B2 H K L W", ""),
    ("Mum and Dad have the second bedroom, and my brother and I share the third, where we have a bunk bed. Grandma has "
     "the first bedroom. One bathroom.", "B3 H K L W", ""),
    ("My brother and I share a room with a bunk bed, Mum and Dad have their own. One bathroom.", "B2 H K L W",
     "B2 has 1 bunk_bed"),
    # children named, then told of again
    ("We are two parents with a daughter of nine and a son of six. The children each have a room of their own, we have "
     "ours. One bathroom.", "B3 H K L W", ""),
    ("I have a son and a daughter. Both children need their own room. One bathroom.", "B3 H K L W", ""),
    # one room, another, a third
    ("Two boys are sleeping together in one bedroom in a bunk bed, two girls in other bedroom in two single beds, and "
     "we parents in the third bedroom. One bathroom.", "B3 H K L W", "B2 has 1 bunk_bed, B3 has 2 single_bed"),
    ("Die zwei Jungen schlafen in einem Zimmer in einem Etagenbett, die Mädchen in einem anderen in zwei Einzelbetten "
     "und wir im dritten. Ein Bad.", "B3 H K L W", "B2 has 1 bunk_bed, B3 has 2 single_bed"),
    ("Les deux garçons dorment dans une chambre avec un lit superposé, les filles dans une autre et nous dans la "
     "troisième. Une salle de bain.", "B3 H K L W", "B2 has 1 bunk_bed"),
    ("Los dos chicos duermen en una habitación con una litera, las niñas en otra y nosotros en la tercera. Un baño.",
     "B3 H K L W", "B2 has 1 bunk_bed"),
]  # fmt: skip

test_rooms_of_those_who_tell_of_themselves = as_meant(TOLD)
