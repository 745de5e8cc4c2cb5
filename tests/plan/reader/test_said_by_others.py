"""Sentences as other people type them: floating words, corrections, furniture by room, clauses that go on.

Each with its rooms and what its programme says beside, `!` where it must not; the notation is `sentences.facts`'.
"""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read

SENTENCES = [
    # neighbours that are none
    ("Two bedrooms and a kitchen opposite the living room.", "B2 H K L W", "opposite K1 L1, H1K1, !K1L1"),
    ("Two bedrooms, a bathroom and a study opposite the bathroom.", "B2 H K L S W", "opposite S1 W1"),
    ("Two bedrooms of 12 m² each that should not be next to each other.", "B2 H K L W", "apart B1 B2, B1=12, B2=12"),
    ("Three-bedroom flat; the kitchen is not next to either bathroom.", "B3 H K L W2", "apart K1 W1, apart K1 W2"),
    ("Two-bedroom flat. The study is next to the kitchen, and the main bedroom faces north.", "B2 H K L S W",
     "adjacent S1 K1, orientation B1 north, !adjacent S1 B1"),
    ("A two-bedroom flat. The kitchen opens onto the living room but has no door to the hall.", "B2 H K L W",
     "K1L1, no_door K1 H1, H1L1"),
    ("Two bedrooms. The kitchen has a door to the dining room and no door to the living room.", "B2 D H K L W",
     "D1K1, no_door K1 L1, !no_door D1 L1"),
    ("Two bedrooms. The study must be next to the living room but not to any bedroom.", "B2 H K L S W",
     "adjacent S1 L1, apart S1 B1, apart S1 B2, !adjacent S1 B1"),
    ("There should be no doors between the two bedrooms.", "B2 H K L W", "no_door B1 B2"),
    ("The kitchen and the living room are separated by a wall without a door. Two bedrooms.", "B2 H K L W",
     "H1K1, H1L1, !K1L1"),
    # a clause whose place is read is no object of the clause before
    ("Two bedrooms. The study is opposite the bathroom and the kitchen is near the entrance.", "B2 H K L S W",
     "opposite S1 W1, near K1 entrance, !opposite S1 K1"),
    ("Two bedrooms; the pantry is reached only from the kitchen and the study lies west of the living room.",
     "B2 H K L S T W", "K1T1, position S1 L1 west, !S1T1"),
    ("The study must not be next to the kitchen, the bathroom is north of the study, and the hallway is at most 4 m "
     "long. One bedroom.", "B H K L S W", "apart S1 K1, position W1 S1 north, at_most H1 length 4, H1S1, !apart S1 W1"),
    ("Dos dormitorios. El baño está enfrente de la cocina.", "B2 H K L W", "opposite W1 K1, !adjacent W1 K1"),
    ("A flat with two bedrooms. A lift opens into the hall.", "B2 H K L W", "unread lift"),
    ("Flat for me and my aunt. Her room must be next to the bathroom, my room next to the kitchen.", "B2 H K L W",
     "adjacent B1 W1, adjacent B2 K1"),
    ("Bedrooms of 14, 12 and 10 m². The 10 m² bedroom is next to the kitchen.", "B3 H K L W2", "adjacent B3 K1"),
    ("The kitchen and the study should not be adjacent. Two bedrooms.", "B2 H K L S W", "apart K1 S1"),
    ("The study and the bathroom must be next to each other. Two bedrooms.", "B2 H K L S W", "adjacent S1 W1"),
    ("Two bedrooms on either side of the bathroom.", "B2 H K L W", "adjacent B1 W1, adjacent B2 W1"),
    ("The kitchen is not far from the entrance. Next to the entrance is a guest toilet. Two bedrooms.",
     "B2 H K L W2", "near K1 entrance, near W1 entrance"),
    ("Neben dem Eingang ist ein Gäste-WC, gegenüber die Küche. Drei Schlafzimmer.", "B3 H K L W2",
     "near W1 entrance, opposite W1 K1"),
    ("两个卧室，厨房和客厅之间不要有门。", "B2 H K L W", "no_door K1 L1"),
    ("两室一厅，次卧和厨房之间没有门，书房有双人床。", "B2 H K L S W",
     "no_door B2 K1, S1 has 1 double_bed, !no_door B2 S1"),
    ("卫生间在两个卧室之间，厨房在客厅旁边。", "B2 H K L W", "B1W1, B2W1, K1L1, !K1~L1"),
    ("La salle de bains se trouve entre les deux chambres.", "B2 H K L W", "B1W1, B2W1"),
    ("El baño está entre los dos dormitorios.", "B2 H K L W", "B1W1, B2W1"),
    # openings and ways
    ("The kitchen should have an island and be open to the dining area. One bedroom.", "B D H K L W", "D1~K1"),
    ("One of the two bedrooms opens onto the terrace, the other onto the street.", "B2 H K L W Y", "B1Y1, !B1B2"),
    ("一居室，厨房连着餐厅，卫生间在入口旁边。", "B D H K L W", "D1K1, H1W1, near W1 entrance, !K1W1"),
    ("两个卧室，客厅靠近厨房，入口附近是卫生间。", "B2 H K L W", "adjacent L1 K1, near W1 entrance, !near K1 entrance"),
    ("两个卧室，入口附近有一个储藏室。", "B2 H K L T W", "near T1 entrance"),
    ("The kitchen and the dining room are joined by a wide opening; one bedroom.", "B D H K L W", "D1~K1"),
    ("The kitchen is in the same space like the living room. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("Kitchen off the living room; two bedrooms and a bathroom off a corridor that begins at the living room.",
     "B2 H K L W", "B1H1, B2H1, H1W1, H1L1, !B1L1, !L1W1"),
    ("Two bedrooms; the shower room can be reached both from the main bedroom and from the hall.", "B2 H K L W",
     "B1W1, H1W1"),
    ("Four bedrooms, two bathrooms which are both on the landing.", "B4 H K L W2", "H1W1, H1W2, !B1W1"),
    ("Two bathrooms, two bedrooms: one bathroom is inside the main bedroom, the other one is off the corridor.",
     "B2 H K L W2", "B1W1, H1W2"),
    ("Two bedrooms. The bathroom is entered through the main bedroom, plus a guest toilet near the entrance.",
     "B2 H K L W2", "B1W1, H1W2, near W2 entrance, !W1W2"),
    ("Two bedrooms and a bathroom, no hallway. You step into the living room and every other room opens off it.",
     "B2 K L W", "B1L1, B2L1, K1L1, L1W1, !B1W1, !K1W1"),
    ("Bedroom, bathroom, hall. The hall leads to every room but the kitchen, which opens off the living room.",
     "B H K L W", "B1H1, H1W1, H1L1, K1L1, !B1L1, !H1K1"),
    ("kitchen:open to living room, hallway:1, study:1, bedrooms:1", "B H K L S W", "K1~L1, H1S1, !K1S1"),
    # how many, of what
    ("Flat with exactly two bedrooms, one bathroom, one kitchen and one living room.", "B2 H K L W", "H1K1"),
    ("Flatshare: four private bedrooms, each with its own bathroom, one shared kitchen.", "B4 H K L W4",
     "B1W1, B2W2, B3W3, B4W4"),
    ("Co-living flat with three bedrooms and a kitchen.", "B3 H K L W2", ""),
    ("bedrooms: 4 x 11 m², kitchen: 14 m²", "B4 H K L W2", "B1=11, B4=11, K1=14"),
    ("Bedrooms 3 x 4 m, one bathroom.", "B2 H K L W", "dimension B1 3 x 4"),
    ("A house with five bedrooms. Actually, make it four bedrooms, and two bathrooms.", "B4 H K L W2", ""),
    ("Flat with two bedrooms, no wait, three.", "B3 H K L W2", ""),
    ("Make it a two-bedroom flat with a study.", "B2 H K L S W", ""),
    ("A 90 m² flat, kitchen 12, living room 28, bedrooms 15 and 13.", "B2 H K L W", "B1=15, B2=13, L1=28, all=90"),
    ("bedrooms 3 (one with its own bath), bath 2, kitchen, living room", "B3 H K L W2", "B1W1, H1W2"),
    ("Two bedrooms; the living room should be rectangular, about 5.5 m by 4 m.", "B2 H K L W", "dimension L1 5.5 x 4"),
    ("Two bedrooms, and a bigger living room than kitchen.", "B2 H K L W", "order L1 K1 larger, !K1~L1"),
    ("Two bedrooms. The second bedroom should be two thirds the size of the first one.", "B2 H K L W",
     "B1=15.74, B2=10.49"),
    ("No hay balcón. Piso de dos dormitorios sin pasillo.", "B2 K L W", ""),
    ("El dormitorio principal tiene baño propio, dos dormitorios más. No hay pasillo.", "B3 K L W2", "B1W1"),
    ("El salón debe ser la habitación más grande. Piso de dos dormitorios.", "B2 H K L W", "order L1 largest"),
    ("Not four bedrooms but three, please, and one bathroom.", "B3 H K L W", ""),
    ("One bedroom with 12 m². A balcony I don't need.", "B H K L W", "B1=12"),
    ("Two bedrooms, both en suite, and a guest toilet.", "B2 H K L W3", "B1W1, B2W2, H1W3"),
    ("Flat with 2 bedrooms (14 m² + 12 m²) and a kitchen of 9 m².", "B2 H K L W", "B1=14, B2=12, K1=9"),
    ("Un T3 de 65 m² avec une chambre de 12 m² et une autre de 10 m².", "B2 H K L W", "B1=12, B2=10, all=65"),
    ("Add a third bedroom and remove the balcony.", "B3 H K L W2", ""),
    ("The kitchen is separate and small. Two bedrooms.", "B2 H K L W", "K1=6.75"),
    ("两室一厅，厨房最少8平米。", "B2 H K L W", "at_least K1 8"),
    # whose
    ("Two bedrooms, the main one with its own shower.", "B2 H K L W2", "B1W1, H1W2"),
    ("We make three bedrooms, the bedrooms of the kids are in the north and our bedroom is in the south.",
     "B3 H K L W2", "position B2 north, position B3 north, position B1 south, !position B1 north"),
    ("La chambre parentale a une salle d'eau privée, les deux autres chambres partagent une salle de bains.",
     "B3 H K L W2", "B1W1, H1W2"),
    ("A couple with a child and a grandmother. The grandmother's room has its own shower room.", "B3 H K L W2",
     "B3W1, H1W2"),
    ("Two bathrooms: one en suite for the main bedroom and one for guests next to the entrance.", "B H K L W2",
     "B1W1, H1W2, near W2 entrance"),
    ("A bedroom with its own bathroom for the grandparents, two bedrooms for the children. The grandparents' room "
     "should be near the entrance.", "B3 H K L W2", "near B1 entrance, B1W1"),
    ("Two bedrooms. The bedroom of the kids is more small than the bedroom of the parents.", "B2 H K L W",
     "order B2 B1 smaller"),
    ("Main bedroom, nursery, a kids room. The nursery must be next to the main bedroom.", "B3 H K L W2",
     "adjacent B2 B1, !adjacent B3 B1"),
    ("A flat for a couple with 0 children.", "B H K L W", ""),
    ("Loft whose main bedroom has its own bathroom.", "B H K L W", "B1W1, H1K1"),
    # furniture
    ("Un canapé dans le salon, un bureau dans chaque chambre. Deux chambres.", "B2 H K L W",
     "L1 has 1 sofa, B1 has 1 desk, B2 has 1 desk"),
    ("Main bedroom, kids room, living room, kitchen. In the kids room put a single bed and a bookshelf.", "B2 H K L W",
     "B2 has 1 single_bed, B2 has 1 bookshelf"),
    ("Two bedrooms. The second bedroom is 3 by 4 m. Place two nightstands in the main bedroom.", "B2 H K L W",
     "dimension B2 3 x 4, B1 has 2 nightstand, !dimension home 3 x 4"),
    ("Piso con dos dormitorios, cada uno con un escritorio.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("Two bedrooms, a study. Put a desk in the study and one in each bedroom.", "B2 H K L S W",
     "S1 has 1 desk, B1 has 1 desk, B2 has 1 desk"),
    ("Two bedrooms, in each of them two single beds and a desk, then one bathroom.", "B2 H K L W",
     "B1 has 2 single_bed, B2 has 2 single_bed, B2 has 1 desk, H1W1"),
    ("Zweizimmerwohnung, das Bad mit Badewanne und Waschmaschine.", "B H K L W",
     "W1 has 1 bath, W1 has 1 washing_machine"),
    ("Un deux-pièces, la salle de bains avec une baignoire.", "B H K L W", "W1 has 1 bath"),
    ("Piso de un dormitorio, baño con ducha y bañera.", "B H K L W", "W1 has 1 bath, W1 has 1 shower"),
    ("One bedroom, in total 600 square feets.", "B H K L W", "all=55.74"),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "wanted", "told"), SENTENCES)
def test_the_programme_is_as_meant(prompt: str, wanted: str, told: str) -> None:
    program = read(prompt)
    assert rooms(program) == wanted
    said = facts(program)
    entries = [entry for entry in told.split(", ") if entry]
    assert {entry for entry in entries if entry[0] != "!"} <= said
    assert not {entry[1:] for entry in entries if entry[0] == "!"} & said
