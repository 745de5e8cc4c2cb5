"""Verbs at the end, pronouns, rooms of a list spoken of again: what rounds of fresh prompts had shown to be missed."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read


def doors(program: Program) -> set[tuple[str, str]]:
    """All links, open ones too."""
    return {*program.links, *program.open_links}


def asked(program: Program) -> set[tuple[str, str, str | None, str | None]]:
    """Requirements without their words."""
    return {(r.kind, r.of, r.to, None if r.value is None else str(r.value)) for r in program.requirements}


@pytest.mark.parametrize(
    ("prompt", "door"),
    [
        ("Wohnung mit einem Schlafzimmer und Abstellraum. Er soll von der Küche aus zugänglich sein.",
         "kitchen_1 storage_1"),
        ("Wohnung mit zwei Schlafzimmern. Zum Elternschlafzimmer gehört eine Ankleide.", "bedroom_1 closet_1"),
        ("Drei Schlafzimmer, ein Abstellraum, der nur von der Küche aus betreten wird.", "kitchen_1 storage_1"),
        ("Zweizimmerwohnung mit Balkon am Schlafzimmer.", "balcony_1 bedroom_1"),
        ("Das Elternschlafzimmer ist groß und hat einen Balkon. Zwei Schlafzimmer.", "balcony_1 bedroom_1"),
        ("Piso de dos dormitorios con un trastero al que se entra desde el despacho.", "storage_1 study_1"),
        ("三室一厅，书房的门开在客厅里。", "living_room_1 study_1"),
        ("两室一厅，储藏室从厨房进去，走廊至少1.2米宽。", "kitchen_1 storage_1"),
        ("We don't want any hallway, two bedrooms open straight off the living room.", "bedroom_2 living_room_1"),
        ("Apartamento de un dormitorio, con baño pequeño y cocina abierta al salón.", "bathroom_1 hallway_1"),
        ("Un appartement d'une chambre avec une salle de bain et un bureau.", "bathroom_1 hallway_1"),
        ("A separate dining room between the kitchen and the living room, two bedrooms.", "hallway_1 kitchen_1"),
    ],
)  # fmt: skip
def test_doors_said_in_another_order(prompt: str, door: str) -> None:
    assert tuple(door.split()) in doors(read(prompt))


@pytest.mark.parametrize(
    "prompt",
    [
        "Zwei Schlafzimmer. Kochen, Essen und Wohnen finden in einem offenen Bereich statt.",
        "Zwei Schlafzimmer. Küche, Essbereich und Wohnzimmer bilden einen offenen Raum.",
        "Two bedrooms. The kitchen, dining room and living room form one open-plan space.",
        "Two bedrooms, the kitchen, dining area and living room are all open plan.",
        "bedrooms: 2, kitchen + dining + living: open plan, living room: 32 m2",
        "Two bedrooms. Kitchen, dining and living share one open-plan space of 45 m².",
    ],
)
def test_one_space_however_it_is_said(prompt: str) -> None:
    opened = {("dining_room_1", "kitchen_1"), ("dining_room_1", "living_room_1")}
    program = read(prompt)
    assert set(program.open_links) == opened and len([r for r in program.rooms if r.type == "living_room"]) == 1


@pytest.mark.parametrize(
    ("prompt", "row"),
    [
        ("Drei Schlafzimmer. Der Hauswirtschaftsraum soll an die Küche grenzen.",
         ("adjacent", "utility_1", "kitchen_1", None)),
        ("Ein Bad und ein Gäste-WC. Das Bad soll größer sein als das Gäste-WC.",
         ("order", "bathroom_1", "bathroom_2", "larger")),
        ("两室一厅，主卧要比次卧大。", ("order", "bedroom_1", "bedroom_2", "larger")),
        ("两室一厅，次卧要离客厅远一点。", ("apart", "bedroom_2", "living_room_1", None)),
        ("Two bedrooms, set well apart from each other.", ("apart", "bedroom_1", "bedroom_2", None)),
        ("Three bedrooms, and the main bedroom is the largest of them.", ("order", "bedroom_1", "bedroom_3", "larger")),
        ("I need one study and one storage room, and it must be far from the bathroom.",
         ("apart", "storage_1", "bathroom_1", None)),
        ("A flat with a big kitchen, a dining room next to it, three bedrooms.",
         ("adjacent", "dining_room_1", "kitchen_1", None)),
        ("Two bedrooms, and the living room is 5 m wide.", ("at_least", "living_room_1", "width", "5")),
        ("Five bedrooms, bedroom 5 far from the living room.", ("apart", "bedroom_5", "living_room_1", None)),
        ("Three bedrooms, two bathrooms. The children's bedroom should be near the bathroom.",
         ("adjacent", "bedroom_3", "bathroom_1", None)),
    ],
)  # fmt: skip
def test_requirements_said_in_another_order(prompt: str, row: tuple[str, str, str | None, str | None]) -> None:
    assert row in asked(read(prompt))


@pytest.mark.parametrize(
    ("prompt", "bathrooms", "own"),
    [
        ("Two bathrooms, one of which is an en-suite, and one bedroom.", 2, 1),
        ("House with 4 bedrooms and 3 bathrooms, two of which are en-suite.", 3, 2),
        ("Three bedrooms, two bathrooms. One bathroom should be an en-suite for the main bedroom.", 2, 1),
        ("One bedroom, one bathroom. The bathroom is an en-suite.", 1, 1),
        ("Vier Schlafzimmer, zwei Bäder, davon eines direkt am Elternschlafzimmer.", 2, 1),
    ],
)
def test_bathrooms_counted_are_not_doubled(prompt: str, bathrooms: int, own: int) -> None:
    found = [r for r in read(prompt).rooms if r.type == "bathroom"]
    assert len(found) == bathrooms and sum(r.private_to is not None for r in found) == own


@pytest.mark.parametrize(
    ("prompt", "room", "category"),
    [
        ("Drei Schlafzimmer. Im Kinderzimmer steht ein Einzelbett.", "bedroom_3", "single_bed"),
        ("Three bedrooms, a walk-in closet for us. Put two single beds in the kids' room.", "bedroom_3", "single_bed"),
        ("Piso de dos dormitorios con una mesa de comedor en el salón.", "living_room_1", "dining_table"),
        ("一室一厅，卧室里放一张双人床。", "bedroom_1", "double_bed"),
        ("Two bedrooms. One dining table with six chairs in the living room.", "living_room_1", "dining_table"),
        ("Two bedrooms. The baby's room is small, and we need a crib in it.", "bedroom_2", "cot"),
        ("Studio with a desk, a wardrobe and a single bed.", "living_room_1", "wardrobe"),
        ("Deux chambres et un bureau avec une table de travail et une bibliothèque.", "study_1", "bookshelf"),
    ],
)
def test_furniture_of_other_languages_stands_where_it_is_said(prompt: str, room: str, category: str) -> None:
    assert (room, category) in {(o.room, o.category) for o in read(prompt).objects}


@pytest.mark.parametrize(
    ("prompt", "room", "area"),
    [
        ("Two bedrooms. The main bedroom has its own bathroom and it is 18 square meters.", "bedroom_1", 18.0),
        ("Two bedrooms. Living room on the south side, 27 m2.", "living_room_1", 27.0),
        ("两室一厅，客厅面积是主卧的两倍，主卧15平方米。", "living_room_1", 30.0),
    ],
)
def test_areas_are_those_of_the_room_spoken_of(prompt: str, room: str, area: float) -> None:
    assert next(r.area for r in read(prompt).rooms if r.id == room) == pytest.approx(area)


@pytest.mark.parametrize(
    ("prompt", "kind", "count"),
    [
        ("4 bedrooms. Main bedroom large, bedroom 4 small.", "bedroom", 4),
        ("Three-bedroom house. The main bedroom is bigger than the two kids' rooms.", "bedroom", 3),
        ("3 bedrooms, 1 utility room. Utility room has a washing machine.", "utility", 1),
        ("For a long-term study of household robots we need two bedrooms.", "study", 0),
        ("Das Bad liegt zwischen den beiden Schlafzimmern.", "study", 0),
        ("Ein Haus ohne Flur mit vier Schlafzimmern.", "bedroom", 4),
        ("Two bedrooms with a wine cellar.", "storage", 0),
    ],
)
def test_rooms_spoken_of_again_are_no_further_ones(prompt: str, kind: str, count: int) -> None:
    assert len([r for r in read(prompt).rooms if r.type == kind]) == count


def test_a_study_is_small_though_something_stands_between() -> None:
    small, usual = (
        next(r.area for r in read(f"Two bedrooms and a study for my work{words}.").rooms if r.type == "study")
        for words in (" and it is small", "")
    )
    assert small < 0.9 * usual
