"""Who lives with somebody who has a room, couples among kin, children of whom some share, whose room one sleeps in."""

from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

WITH_SOMEBODY = [
    ("I live with my mother, who needs her own bedroom", "B2 H K L W", "!unread live"),
    ("I live with my mother. She needs her own bedroom.", "B2 H K L W", ""),
    ("We live with our grandmother, who has her own bedroom", "B2 H K L W", ""),
    ("A flat for my brother and me; he needs his own bedroom.", "B2 H K L W", ""),
    ("I live with my parents, who need their own bedroom.", "B2 H K L W", ""),
    ("I live with my two sons, who each need a bedroom", "B3 H K L W2", ""),
    ("My grandmother lives with us and needs her own bedroom.", "B2 H K L W", ""),
    ("we live with my mother in law, she needs a bedroom close to the bathroom", "B2 H K L W",
     "adjacent B2 W1, !adjacent B1 W1"),
    ("me and my wife live with my mother, who needs her own bedroom", "B2 H K L W", ""),
    ("Ich wohne mit meiner Mutter zusammen, die ein eigenes Schlafzimmer braucht.", "B2 H K L W", ""),
    ("J'habite avec ma mère, qui a besoin de sa propre chambre.", "B2 H K L W", ""),
    ("Vivo con mi madre y mi hermano, cada uno necesita su dormitorio.", "B3 H K L W2", ""),
    ("我和妈妈一起住，她需要自己的房间", "B2 H K L W", ""),
    ("I live with my mother. Our flat has two bedrooms, she needs her own bathroom.", "B2 H K L W2", ""),
    ("My mother and her partner live with me", "B2 H K L W", ""),
    ("Meine Eltern bekommen ein Schlafzimmer, ich brauche ein Zimmer mit Schreibtisch.", "B2 H K L W",
     "B2 has 1 desk"),
    ("Vivo con mi hermana. Cada una quiere su propio dormitorio con cama doble y armario.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe, B2 has 1 double_bed"),
    ("I live with my two brothers. Everyone needs his own bedroom.", "B3 H K L W2", ""),
]  # fmt: skip
COUPLES = [
    ("Me and my wife, my sister and her husband", "B2 H K L W", ""),
    ("A flat for my sister and her husband", "B H K L W", ""),
    ("my sister and her husband and I", "B2 H K L W", ""),
    ("my sister, her husband and their baby", "B2 H K L W", ""),
    ("A flat for my parents, my sister and her husband and me", "B3 H K L W2", ""),
    ("Meine Schwester, ihr Mann und ich", "B2 H K L W", ""),
    ("ma sœur, son mari et moi", "B2 H K L W", ""),
    ("me, my wife and my mother", "B2 H K L W", ""),
    ("mi marido, yo y dos niños que comparten habitación", "B2 H K L W", ""),
    ("mon mari, moi et nos deux filles qui partagent une chambre", "B2 H K L W", ""),
    ("我和老婆带一个孩子", "B2 H K L W", ""),
    ("couple + two kids", "B3 H K L W2", ""),
    ("Piso para un estudiante", "B H K L W", ""),
    ("Wohnung für einen Studenten", "B H K L W", ""),
]
SOME_SHARE = [
    ("four children: two share, the other two have their own", "B4 H K L W2", "!unread four"),
    ("We have four kids, two of them share a room, the other two each have their own room.", "B4 H K L W2", ""),
    ("three kids, two of them share", "B3 H K L W2", ""),
    ("A flat for us and four children: two share a room, the other two have their own rooms.", "B4 H K L W2", ""),
    ("We are a family with three kids; two of them share a room and the baby sleeps in ours.", "B2 H K L W", ""),
    ("a family of five, two of the kids share", "B3 H K L W2", ""),
    ("We have five kids; three share one room and the other two share another.", "B3 H K L W2", ""),
    ("vier Kinder: zwei teilen sich ein Zimmer, die anderen beiden haben ein eigenes", "B4 H K L W2", ""),
    ("quatre enfants : deux partagent une chambre, les deux autres ont chacun la leur", "B4 H K L W2", ""),
    ("cuatro hijos: dos comparten habitación y los otros dos tienen la suya", "B4 H K L W2", ""),
    ("四个孩子，两个合住一间，另外两个各一间", "B4 H K L W2", ""),
    ("3-bedroom flat for a family with three kids, two of them share a room", "B3 H K L W2", ""),
    ("a bedroom for the parents and one that the two girls share, with a bunk bed and two desks", "B2 H K L W",
     "B2 has 1 bunk_bed, B2 has 2 desk"),
]  # fmt: skip
TOLD_AGAIN = [
    ("Wir sind zu dritt: meine Frau, unser Sohn und ich. Der Sohn braucht ein eigenes Zimmer.", "B2 H K L W",
     "!unread dritt"),
    ("My wife and I and our son. The son needs his own room.", "B2 H K L W", ""),
    ("A flat for me and my mother. My mother needs her own room.", "B2 H K L W", ""),
    ("Wir wohnen zu viert in der Wohnung", "B3 H K L W2", ""),
    ("We are four: two adults and two children", "B3 H K L W2", "!unread four"),
    ("Somos cuatro: mi marido, yo y dos niños", "B3 H K L W2", "!unread cuatro"),
    ("My kids are 5 and 8 and share a room. We need a bedroom too.", "B2 H K L W", ""),
]
FOR_WHOM = [
    ("une maison avec une chambre pour mes parents et une pour moi", "B2 H K L W", ""),
    ("una casa con una habitación para mis padres y otra para mí", "B2 H K L W", ""),
    ("ein Haus mit einem Schlafzimmer für meine Eltern und einem für mich", "B2 H K L W", ""),
    ("three bedrooms: one for us, one for grandma, one for the boys, who share", "B3 H K L W2", ""),
]
WHOSE = [
    ("三室一厅，女儿住次卧", "B3 H K L W2", "!unread 女, !unread 住"),
    ("两室一厅，主卧我们住，次卧女儿住", "B2 H K L W", "!unread 女, !unread 住"),
    ("两个卧室，一间父母住，另一间孩子住", "B2 H K L W", ""),
    ("三室，一间我们住，一间女儿住，一间老人住", "B3 H K L W2", ""),
    ("我和妻子还有一个女儿住，需要两间卧室", "B2 H K L W", ""),
]

SHARED = [
    ("Vivo con mi hermana. Cada una quiere su propio dormitorio con cama doble, el baño lo compartimos.", "B2 H K L W",
     "H1W1, !B1W1, !B1B2"),
    ("Dos dormitorios con balcón, el baño lo compartimos entre todos y la cocina tiene despensa.", "B2 H K L T W Y2",
     "H1W1, !B1W1, !unread compartimos"),
]  # fmt: skip

test_those_who_live_with_somebody = as_meant(WITH_SOMEBODY)
test_couples_among_kin = as_meant(COUPLES)
test_some_children_share = as_meant(SOME_SHARE)
test_people_told_of_again = as_meant(TOLD_AGAIN)
test_for_whom = as_meant(FOR_WHOM)
test_whose_room = as_meant(WHOSE)
test_a_bathroom_that_we_share_is_nobody_s_own = as_meant(SHARED)


def test_as_many_sleep_in_a_room_as_share_it() -> None:
    """Of four children two sleep in the first of their rooms, one in each of the others."""
    program = read("four children: two share, the other two have their own")
    assert [room.children for room in program.rooms if room.children] == [2, 1, 1]
