"""Wishes in other forms: keys and codes, people in the place of rooms, purposes, denials of all, lists of places."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

SHORT = {"dining_room": "D", "bedroom": "B", "bathroom": "W", "storage": "T", "balcony": "Y"}


def rooms(program: Program) -> str:
    """`B2 H K L W`: how many of each, in alphabetical order."""
    kinds = [SHORT.get(r.type, r.type[0].upper()) for r in program.rooms]
    return " ".join(f"{k}{kinds.count(k)}" if kinds.count(k) > 1 else k for k in sorted(set(kinds)))


def doors(program: Program) -> set[frozenset[str]]:
    return {frozenset(link) for link in program.links}


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        ('{"bedrooms": 2, "study": true, "balcony": false}', "B2 H K L S W"),
        ('{"kind": "flat", "bedroom_count": 3, "bathroom_count": 1, "utility": true}', "B3 H K L U W"),
        ("2BR/1BA, DR, K open to LR", "B2 D H K L W"),
        ("flat, 4 habitable rooms, 1 of which is a study", "B2 H K L S W"),
        ("十二平米的单间", "K L W"),
    ],
)
def test_keys_and_codes(prompt: str, wanted: str) -> None:
    assert rooms(read(prompt)) == wanted


def test_a_letter_is_a_room_among_other_codes_only() -> None:
    asked = read("LR 24, K 8, BR1 13, BR2 10, BA 4")
    assert [r.area for r in asked.rooms[:5]] == [24, 8, 13, 10, 4]
    assert any(entry.startswith("k (") for entry in read("two bedrooms and a K").unread)


@pytest.mark.parametrize(
    ("prompt", "total"),
    [("八十五平米两居室", 85), ("一百二十平方米四室两厅", 120), ('{"bedrooms": 2, "area_m2": 64}', 64),
     ('{"bedrooms": 2, "sqm": 64}', 64), ("two bedrooms, total 90 m2 +/- 5", 90)],
)  # fmt: skip
def test_areas_of_the_home(prompt: str, total: float) -> None:
    assert read(prompt).total_area == total


@pytest.mark.parametrize(
    ("prompt", "bedrooms"),
    [
        ("Three sons, each needs a room; our bedroom has a balcony.", 4),
        ("The twins share a room, grandma has a room of her own, and our bedroom is large.", 3),
        ("For my husband, me and our three daughters.", 4),
        ("A flat for two adults, their son and a lodger.", 3),
        ("Flat for my wife, me and two boys. Every boy has his own room.", 3),
        ("Wohnung für meine Frau, mich und zwei Kinder, jedes Kind bekommt ein eigenes Zimmer", 3),
        ("Die Zwillinge teilen sich ein Zimmer, Oma braucht ein Zimmer beim Bad, dazu unser Schlafzimmer.", 3),
        ("Les jumeaux partagent une chambre, ma mère a besoin d'une chambre, une cuisine", 2),
        ("Casa para una pareja con cuatro hijos: los dos pequeños comparten habitación", 4),
    ],
)
def test_people_have_rooms(prompt: str, bedrooms: int) -> None:
    assert rooms(read(prompt)).startswith(f"B{bedrooms}"), read(prompt).unread


def test_rooms_of_people_are_no_people() -> None:
    assert rooms(read("Two-bedroom flat; the kids' room has bunk beds")) == "B2 H K L W"


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        ("Two bedrooms, somewhere to work, a place to do laundry and a room for the skis.", "B2 H K L S T U W"),
        ("Four rooms: two for sleeping, one to work, one for guests.", "B3 H K L S W2"),
        ("Zwei Zimmer zum Schlafen, eins zum Arbeiten", "B2 H K L S W"),
        ("deux pièces pour dormir, une pour travailler, une cuisine", "B2 H K L S W"),
        ("dos dormitorios y un sitio para trabajar", "B2 H K L S W"),
        ("two-bedroom flat with space for a piano", "B2 H K L W"),
        ("two-bedroom flat with a place to work in the living room", "B2 H K L W"),
    ],
)
def test_rooms_said_by_what_they_are_for(prompt: str, wanted: str) -> None:
    assert rooms(read(prompt)) == wanted


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("Three bedrooms, none under 11 m².", "at_least"), ("Three bedrooms, none of them over 11 m².", "at_most"),
        ("No bedroom should be smaller than 11 m²; three bedrooms.", "at_least"),
        ("Drei Schlafzimmer, keines kleiner als 11 m²", "at_least"),
        ("Trois chambres, aucune plus petite que 11 m²", "at_least"),
        ("Tres dormitorios, ninguno de menos de 11 m²", "at_least"),
    ],
)  # fmt: skip
def test_a_limit_denied_of_all_is_the_other_limit(prompt: str, kind: str) -> None:
    asked = {(r.kind, r.of, r.value) for r in read(prompt).requirements}
    assert asked == {(kind, f"bedroom_{n}", "11") for n in (1, 2, 3)}


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("Two-bedroom flat, no bedroom next to the kitchen.", "apart"),
        ("A flat in which no bedroom adjoins the kitchen; two bedrooms.", "apart"),
        ("Two-bedroom flat where no bedroom opens onto the kitchen.", "no_door"),
        ("Dreizimmerwohnung, kein Schlafzimmer neben der Küche", "apart"),
        ("appartement de deux chambres, aucune chambre à côté de la cuisine", "apart"),
    ],
)
def test_what_no_room_of_a_kind_is_to_be(prompt: str, kind: str) -> None:
    program = read(prompt)
    assert {(r.kind, r.of, r.to) for r in program.requirements} == {(kind, f"bedroom_{n}", "kitchen_1") for n in (1, 2)}


@pytest.mark.parametrize(
    "prompt",
    [
        "One bedroom, on the left the kitchen, the bathroom and the study, on the right the living room.",
        "Ein Schlafzimmer, links die Küche, das Bad und das Büro, rechts das Wohnzimmer.",
        "Une chambre, à gauche la cuisine, la salle de bains et le bureau, à droite le séjour.",
    ],
)
def test_a_place_holds_for_the_list_behind_it(prompt: str) -> None:
    asked = {(r.of, r.value) for r in read(prompt).requirements}
    left = {(f"{room}_1", "left") for room in ("kitchen", "bathroom", "study")}
    assert asked == left | {("living_room_1", "right")}


@pytest.mark.parametrize("prompt", ["一居室，厨房在客厅的北边", "One bedroom, the kitchen is north of the living room"])
def test_sides_of_other_rooms(prompt: str) -> None:
    assert ("kitchen_1", "living_room_1", "north") in {(r.of, r.to, r.value) for r in read(prompt).requirements}


def test_its_sides_are_those_of_the_room_before() -> None:
    program = read("A hall; on its left side a kitchen and a bath. One bedroom.")
    asked = {(r.of, r.to, r.value) for r in program.requirements}
    assert asked == {("kitchen_1", "hallway_1", "left"), ("bathroom_1", "hallway_1", "left")}


@pytest.mark.parametrize(
    "prompt",
    [
        "One-bedroom flat, the bathroom opens off the bedroom instead of the hallway.",
        "One-bedroom flat, the bathroom is entered from the bedroom rather than the hallway.",
        "One-bedroom flat, the bathroom opens off the bedroom rather than off the hallway.",
    ],
)
def test_a_door_here_instead_of_there(prompt: str) -> None:
    near = {"bathroom_1": "bedroom_1", "bedroom_1": "hallway_1", "kitchen_1": "hallway_1", "living_room_1": "hallway_1"}
    assert doors(read(prompt)) == {frozenset(pair) for pair in near.items()}


@pytest.mark.parametrize(
    "prompt", ["One bedroom, kitchen and living room in one", "客厅和厨房连在一起，一间卧室"]
)
def test_two_rooms_in_one(prompt: str) -> None:
    assert read(prompt).open_links == [("kitchen_1", "living_room_1")]


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        ('[{"name": "kitchen", "area": 9}, {"name": "bedroom", "area": 14}, {"name": "bath", "area": 4}]', [9, 14, 4]),
        ("2 BR (13/11), kitch 8 m2, BA 4", [8, 13, 11, 4]),
        ("two bedrooms (12 and 10 m²), K 8 m², BA 5 m²", [8, 12, 10, 5]),
    ],
)
def test_areas_of_lists(prompt: str, wanted: list[float]) -> None:
    program = read(prompt)
    assert [r.area for r in program.rooms if r.type in ("kitchen", "bedroom", "bathroom")] == wanted
    assert not program.unread


def test_capitals_are_sides() -> None:
    asked = {(r.of, r.value) for r in read("two bedrooms N, kitchen SE, entry W").requirements}
    assert asked == {("bedroom_1", "north"), ("bedroom_2", "north"), ("kitchen_1", "south_east")}


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        ("Two daughters and a son and us. The daughters share a room.", "B3 H K L W2"),
        ("Our two girls in one room, the boy in another, us in a third.", "B3 H K L W2"),
        ("Drei Freunde: ein Zimmer für jeden", "B3 H K L W2"),
        ("Cinco estudiantes: una habitación para cada uno, dos baños", "B5 H K L W2"),
        ("A lodger needs his own shower, and our bedroom is large.", "B2 H K L W2"),
    ],
)
def test_who_sleeps_where(prompt: str, wanted: str) -> None:
    assert rooms(read(prompt)) == wanted, read(prompt).unread


def test_what_is_denied_of_one_of_a_kind_is_denied_of_all() -> None:
    asked = {(r.kind, r.of, r.to) for r in read("Two bedrooms; the study mustn't be next to a bedroom.").requirements}
    assert asked == {("apart", "study_1", f"bedroom_{n}") for n in (1, 2)}


def test_what_rooms_are_to_one_another() -> None:
    asked = {(r.kind, r.of, r.to) for r in read("Two studies as far from each other as possible, a bed.").requirements}
    assert asked == {("apart", "study_1", "study_2")}


def test_a_second_comparison_is_of_the_same_room() -> None:
    program = read("One bedroom, the kitchen is larger than the bathroom but smaller than the bedroom.")
    asked = {(r.of, r.to, r.value) for r in program.requirements}
    assert asked == {("kitchen_1", "bathroom_1", "larger"), ("kitchen_1", "bedroom_1", "smaller")}


def test_a_side_of_all_rooms_but_one() -> None:
    program = read("A one-bedroom flat; every room except the kitchen has a window to the east.")
    assert {r.of for r in program.requirements} == {"living_room_1", "bedroom_1", "bathroom_1"}


@pytest.mark.parametrize(
    "prompt",
    ["Two bedrooms, in each of them a bathroom", "zwei Schlafzimmer, in jedem ein Bad",
     "deux chambres, dans chacune une salle de bains", "dos dormitorios, en cada uno un baño"],
)  # fmt: skip
def test_one_in_each(prompt: str) -> None:
    pairs = {frozenset((f"bedroom_{n}", f"bathroom_{n}")) for n in (1, 2)}
    assert pairs <= doors(read(prompt))


def test_from_there_is_where_the_last_clause_led() -> None:
    program = read("The hall ends in the living room, and the kitchen is reached from there. One bedroom.")
    assert frozenset(("kitchen_1", "living_room_1")) in doors(program)


def test_a_room_after_an_unknown_thing_is_not_the_things() -> None:
    program = read("Zwei Schlafzimmer, Bad mit Bullauge, Abstellraum neben der Küche")
    assert {(r.kind, r.of, r.to) for r in program.requirements} == {("adjacent", "storage_1", "kitchen_1")}


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("Two bedrooms; the kitchen must not exceed 9 m².", "at_most"),
        ("Two bedrooms; the kitchen may not be smaller than 9 m².", "at_least"),
        ("Zwei Schlafzimmer; die Küche darf nicht kleiner als 9 m² sein.", "at_least"),
        ("Two bedrooms; the kitchen's area must not exceed 9 m².", "at_most"),
    ],
)
def test_a_limit_denied_is_the_other_limit(prompt: str, kind: str) -> None:
    assert {(r.kind, r.of) for r in read(prompt).requirements} == {(kind, "kitchen_1")}


@pytest.mark.parametrize(
    "prompt",
    [
        '<room type="kitchen" area="9"/> <room type="living_room" area="21"/> <room type="bedroom" area="13"/>',
        "kit 9 / liv 21 / bed 13", "kitchen (9), LR (21), BR1 (13)",
    ],
)  # fmt: skip
def test_areas_between_marks(prompt: str) -> None:
    area = {r.id: r.area for r in read(prompt).rooms}
    assert (area["kitchen_1"], area["living_room_1"], area["bedroom_1"]) == (9, 21, 13)


def test_keys_with_a_place_behind_them() -> None:
    program = read("bedrooms: 1\nkitchen: open to living room\nbalcony: off bedroom")
    assert program.open_links == [("kitchen_1", "living_room_1")]
    assert frozenset(("balcony_1", "bedroom_1")) in doors(program)


def test_every_room_has_one_area() -> None:
    program = read("A flat where every room is 11 m²: kitchen, lounge, one bedroom, bathroom")
    assert {r.area for r in program.rooms if r.type != "hallway"} == {11}


def test_neither_things_nor_rooms() -> None:
    assert rooms(read("Neither a bathtub nor a study, but two bedrooms")) == "B2 H K L W"


def test_doors_of_a_hall_are_limited() -> None:
    asked = {(r.kind, r.of, r.to, r.value) for r in read("Two beds, no more than 5 doors on the hall.").requirements}
    assert asked == {("at_most", "hallway_1", "doors", "5")}


@pytest.mark.parametrize(
    ("prompt", "bedrooms"),
    [("The boys' room and the girl's room side by side, two bathrooms", "B2"), ("两个孩子各有一间房，主卧朝南", "B3"),
     ("Four people, two bathrooms", "B3"), ("The kids' room beside ours, a lounge", "B2")],
)  # fmt: skip
def test_rooms_of_different_people(prompt: str, bedrooms: str) -> None:
    assert rooms(read(prompt)).startswith(bedrooms)


def test_who_shares_a_kitchen_has_no_door_to_it() -> None:
    program = read("A flat for two sisters, each with her own bedroom and bathroom, sharing kitchen and living room.")
    assert frozenset(("bedroom_1", "bathroom_1")) in doors(program)
    assert not any({"bedroom_1", other} in doors(program) for other in ("kitchen_1", "living_room_1"))


def test_what_is_not_wanted_beside_a_room_is_still_wanted() -> None:
    program = read("We don't want the bathroom next to the kitchen. Two bedrooms, no internal kitchen.")
    assert rooms(program) == "B2 H K L W"
    assert {(r.kind, r.of, r.to) for r in program.requirements} == {("apart", "bathroom_1", "kitchen_1")}


@pytest.mark.parametrize("prompt", ["Two bedrooms, no open kitchen", "Zwei Schlafzimmer, keine offene Küche",
                                    "bedrooms: 2, open kitchen: no"])  # fmt: skip
def test_no_open_kitchen_is_a_closed_one(prompt: str) -> None:
    program = read(prompt)
    assert rooms(program) == "B2 H K L W" and not program.open_links
