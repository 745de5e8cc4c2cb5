"""Two ways to say one thing give one programme."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read
from apartgen.stages.space.graphs import edge_similarity, node_similarity, of_program

SAME = [
    ("both", "The study and the lounge are off the hall. Both open onto a balcony. Two bedrooms, a bathroom.",
     "The study and the lounge are off the hall. The balcony opens onto the study. The balcony opens onto the lounge. "
     "Two bedrooms, a bathroom."),
    ("former and latter", "Two bedrooms, a lounge and a kitchen, the latter reached from the former.",
     "Two bedrooms, a lounge and a kitchen. The kitchen is reached from the lounge."),
    ("all but", "Two bedrooms, a study, a bathroom. Every room but the study opens onto the hall. The study is reached "
     "from the lounge.", "Two bedrooms, a study, a bathroom. The study is reached from the lounge."),
    ("as is", "The bedrooms are off the hall, as is the bathroom. The kitchen is off the lounge.",
     "The bedrooms and the bathroom are off the hall. The kitchen is off the lounge."),
    ("unsaid has", "Two-bedroom flat. One of the bedrooms has an en suite, the other a balcony.",
     "Two-bedroom flat. One of the bedrooms has an en suite, the other has a balcony."),
    ("each of a coordination", "Two-bedroom flat. The lounge and the master bedroom have balconies.",
     "Two-bedroom flat. The lounge has a balcony. The master bedroom has a balcony."),
    ("give", "Give each of the two bedrooms a walk-in closet.", "Each of the two bedrooms has a walk-in closet."),
    ("pairs in brackets", "Rooms: living_room, kitchen, bedroom, bathroom, hallway. Edges: (hallway, living_room), "
     "(hallway, bedroom), (hallway, bathroom), (living_room, kitchen).",
     "hallway -> living room, bedroom, bathroom; living room -> kitchen"),
    ("pairs between", "Doors between hallway and lounge, lounge and kitchen, hallway and bedroom, hall and bath.",
     "hallway -> living room, bedroom, bathroom; living room -> kitchen"),
    ("lists by room", "hall: lounge, wc, bedroom; lounge: balcony, kitchen; bedroom: bathroom",
     "hall -> lounge, wc, bedroom; lounge -> balcony, kitchen; bedroom -> bathroom"),
    ("chain with >", "hall > living > dining > kitchen; hall > bedroom, bath",
     "hall -> living -> dining -> kitchen; hall -> bedroom, bath"),
    ("none", "bedrooms: 2, bathrooms: 1, hall: none", "two bedrooms, one bathroom, no hall"),
    ("zero", "two-bedroom flat with 0 balconies and 0 studies", "two-bedroom flat with no balcony and no study"),
    ("count afterwards", "The bedrooms, of which there are three, are off the hall. One bathroom.",
     "Three bedrooms are off the hall. One bathroom."),
    ("letters", "The hall leads to bedroom A, bedroom B and the bathroom.",
     "The hall leads to bedroom 1, bedroom 2 and the bathroom."),
    ("one of which", "Three bedrooms and two bathrooms, one of which belongs to the main bedroom.",
     "Three bedrooms and two bathrooms; one bathroom belongs to the main bedroom."),
    ("contrast", "Two-bedroom flat. The lounge, not the hallway, leads to the kitchen.",
     "Two-bedroom flat. The lounge leads to the kitchen."),
    ("neither has", "Neither bedroom has its own bathroom; there is one bathroom.",
     "Two bedrooms without ensuite; there is one bathroom."),
    ("one door each", "The kitchen has two doors, one to the hall and one to the dining room. Two bedrooms.",
     "The kitchen opens to the hall. The kitchen opens to the dining room. Two bedrooms."),
    ("foyer and corridor", "The lobby leads to the lounge, the lounge to the kitchen, the lounge to the corridor and "
     "the corridor to two bedrooms and a bathroom.",
     "A first hall leads to the lounge. The lounge opens to the kitchen. The lounge opens to a second hall. The second "
     "hall leads to two bedrooms and a bathroom."),
    ("landing", "Lounge and kitchen off the hall. Two bedrooms and a bathroom off the landing.",
     "Lounge and kitchen off the first hall. Two bedrooms and a bathroom off a second hall."),
    ("doors from it", "Corridor in the centre. Doors from there to: lounge, bedroom, kitchen, bathroom.",
     "The corridor leads to the lounge, the bedroom, the kitchen and the bathroom."),
    ("links as a verb", "The hall links the lounge with the kitchen. Two bedrooms, a bathroom.",
     "The hall leads to the lounge and the kitchen. Two bedrooms, a bathroom."),
    ("not this but that", "The bathroom isn't reached from the hall but from the bedroom; nor is the closet.",
     "The bathroom is reached from the bedroom, the closet is reached from the bedroom."),
    ("which are joined", "The hall leads to the lounge and the kitchen, which are joined. Two bedrooms and a bathroom.",
     "The hall leads to the lounge and the kitchen. The lounge is joined to the kitchen. Two bedrooms and a bathroom."),
    ("next to, with doors", "Two bedrooms, the bathroom beside bedroom 2 with doors to both the bedroom and the hall.",
     "Two bedrooms. Bedroom 2 opens to the bathroom. The hall leads to the bathroom."),
    ("that hallway", "The lounge leads to a hallway, and that hallway leads to two bedrooms. Kitchen, bathroom.",
     "The lounge leads to a hallway. The hallway leads to two bedrooms. Kitchen, bathroom."),
    ("which both enter", "Two bedrooms are separated by a bathroom which both may enter.",
     "Two bedrooms are separated by a bathroom."),
    ("what one bathroom is for", "One bathroom for the main bedroom, one for the other three bedrooms; lounge.",
     "Four bedrooms, the main bedroom with an en suite, a family bathroom; lounge."),
    ("more than usual", "One more study than usual: two studies, two bedrooms.", "Two studies, two bedrooms."),
    ("suites", "Two suites, each with a walk-in closet and a bathroom, and a lounge and a kitchen.",
     "Two bedrooms, each with its own bathroom and each with a walk-in closet, and a lounge and a kitchen."),
    ("into which and from which", "A hall into which the lounge, the kitchen and a WC open, and from which a corridor "
     "leads to two bedrooms and a bathroom.",
     "The hall leads to the lounge, the kitchen, a WC and a second hall. The second hall leads to two bedrooms and a "
     "bathroom."),
    ("enfilade", "Hall, lounge, study and kitchen form an enfilade. Two bedrooms, a bathroom.",
     "The hall leads to the lounge, the lounge to the study, the study to the kitchen. Two bedrooms, a bathroom."),
    ("all that there is", "There is a kitchen. There are two bedrooms and a bath. All of them open onto the lounge.",
     "The kitchen, two bedrooms and a bathroom open onto the lounge."),
    ("a room set to a part", "2 bedrooms, 1 living; hub: living; hall: none", "two bedrooms, a living room, no hall"),
    ("way in, then what it has", "The lounge, reached through a passage off the kitchen, has a balcony. Two bedrooms.",
     "The lounge has a balcony. The lounge is reached from a passage. The passage is off the kitchen. Two bedrooms."),
    ("cupboard of a hall", "Hall with cupboard, two bedrooms, a bathroom.",
     "Hall with storage room, two bedrooms, a bathroom."),
    ("lists by hall", "From the corridor: two bedrooms, a bathroom; from the foyer: lounge, kitchen.",
     "The foyer leads to the lounge and the kitchen. The corridor leads to two bedrooms and a bathroom."),
    ("beyond the closet", "Two-bedroom flat, the main bedroom with a walk-in closet that opens to the ensuite.",
     "Two-bedroom flat. The main bedroom has a walk-in closet. The ensuite is off the walk-in closet."),
]  # fmt: skip


@pytest.mark.parametrize(("said", "plain"), [pair[1:] for pair in SAME], ids=[pair[0] for pair in SAME])
def test_one_home_however_it_is_said(said: str, plain: str) -> None:
    one, other = read(said), read(plain)
    assert node_similarity(of_program(one), of_program(other)) == 1
    assert edge_similarity(of_program(one), of_program(other)) == 1
    assert not one.unread


def area(program: Program, kind: str) -> list[float]:
    return [r.area or 0.0 for r in program.rooms if r.type == kind]


@pytest.mark.parametrize(
    ("prompt", "kind", "wanted"),
    [
        ("two bedrooms, kitchen and living room 10 and 26 m²", "kitchen", [10]),
        ("two bedrooms, kitchen and living room 10 and 26 m²", "living_room", [26]),
        ("a home of 110 m² with a kitchen of 14 and bedrooms of 16, 12 and 11", "bedroom", [16, 12, 11]),
        ("90 m² flat: living 30, kitchen 12, two bedrooms of 14 m² each, bathroom 6", "bathroom", [6]),
        ("hall (6), living room (24), bedroom (14), storage (2)", "storage", [2]),
        ("1000 sq ft; two beds 150 sq ft each", "bedroom", [13.94, 13.94]),
        ("100 m² flat whose living room takes a third, the kitchen is half the size of the living room", "kitchen",
         [16.66]),
    ],
)  # fmt: skip
def test_areas_of_lists(prompt: str, kind: str, wanted: list[float]) -> None:
    assert area(read(prompt), kind) == pytest.approx(wanted, abs=0.02)


def test_a_share_of_two_rooms_is_split() -> None:
    home = read("Living room and kitchen together take half of an 80 m² flat with two bedrooms.")
    assert sum(area(home, "living_room") + area(home, "kitchen")) == pytest.approx(40, abs=0.02)


def test_a_percentage_more_is_a_ratio() -> None:
    first, second = area(read("Two bedrooms, 70 m². Bedroom 1 is 40% larger than bedroom 2."), "bedroom")
    assert first / second == pytest.approx(1.4, abs=0.01)


def test_words_of_other_scripts_are_not_dropped_in_silence() -> None:
    assert [w.split(" (")[0] for w in read("two-bedroom flat с балконом").unread] == ["с", "балконом"]
