"""Words for rooms in five languages: each names the room that an architect would draw."""

import pytest
from sentences.facts import SHORT

from apartgen.stages.plan.reader import read

FRAMES = {
    "en": "A flat with two bedrooms and a {}.", "de": "Wohnung mit zwei Schlafzimmern, {}.",
    "fr": "Appartement avec deux chambres, {}.", "es": "Piso con dos dormitorios, {}.", "zh": "两室公寓，带{}。",
}  # fmt: skip
WORDS = {
    "en": {
        "S": "home cinema, cinema room, home theater, homework room, darkroom, games room, gym, craft room",
        "T": "wine room, butler's pantry, larder, linen closet", "U": "drying room, scullery", "Y": "rooftop terrace",
    },
    "de": {
        "S": "Spielzimmer, Hobbyraum, Fitnessraum, Musikzimmer, Werkstatt, Lesezimmer, Heimkino, Nähzimmer",
        "T": "Besenkammer, Vorratskammer, Fahrradraum", "C": "Schrankraum", "Y": "Wintergarten",
        "B": "Jugendzimmer, Babyzimmer",
    },
    "fr": {
        "S": "salle de jeux, salle de sport, salle de musique, salle de cinéma, coin bureau, salle de lecture",
        "T": "local à vélos, espace de rangement", "C": "penderie", "U": "arrière-cuisine", "Y": "jardin d'hiver",
        "B": "chambre de bonne, chambre de bébé",
    },
    "es": {
        "S": "sala de juegos, gimnasio, sala de música, cuarto de juegos, sala de cine, zona de estudio",
        "T": "cuarto de herramientas, cuarto de bicicletas", "U": "cuarto de la plancha", "Y": "azotea",
        "B": "cuarto para los niños",
    },
    "zh": {"S": "健身房, 游戏室, 影音室, 琴房, 画室", "C": "鞋帽间", "U": "家政间", "Y": "晒台", "B": "保姆房"},
}
NAMED = [
    (language, kind, word)
    for language, kinds in WORDS.items()
    for kind, words in kinds.items()
    for word in words.split(", ")
]


@pytest.mark.parametrize(("language", "kind", "word"), NAMED)
def test_a_word_for_a_room_is_one_room_more(language: str, kind: str, word: str) -> None:
    program = read(FRAMES[language].format(word))
    kinds = [SHORT[room.base] for room in program.rooms]
    assert kinds.count(kind) == 1 + 2 * (kind == "B") and not program.unread


INSIDE = {
    "de": "Zwei Schlafzimmer. Im Wohnzimmer steht {}.", "fr": "Deux chambres. Dans le salon il y a {}.",
    "es": "Dos dormitorios. En el salón hay {}.", "zh": "两室，客厅里有{}。",
}  # fmt: skip
THINGS = {
    "de": {"side_table": "ein Beistelltisch", "bookshelf": "ein Regal", "floor_lamp": "eine Stehlampe",
           "office_chair": "ein Bürostuhl", "sofa": "eine Couch", "corner_sofa": "ein Ecksofa"},
    "fr": {"desk": "un bureau", "bookshelf": "une bibliothèque", "floor_lamp": "un lampadaire",
           "office_chair": "une chaise de bureau", "sofa": "un canapé", "tv_stand": "un meuble télé",
           "bench": "un banc", "nightstand": "une table de nuit", "oven": "un four"},
    "es": {"bookshelf": "una librería", "floor_lamp": "una lámpara de pie", "plant": "una planta",
           "sideboard": "un aparador", "tv_stand": "un mueble de TV", "side_table": "una mesita"},
    "zh": {"tv_stand": "电视柜", "floor_lamp": "落地灯", "office_chair": "办公椅", "chest": "抽屉柜"},
}  # fmt: skip


@pytest.mark.parametrize(("language", "category", "thing"), [
    (language, category, thing) for language, things in THINGS.items() for category, thing in things.items()
])  # fmt: skip
def test_a_word_for_furniture_is_a_piece_of_it_where_it_is_said(language: str, category: str, thing: str) -> None:
    program = read(INSIDE[language].format(thing))
    assert [(one.room, one.category, one.count) for one in program.objects] == [("living_room_1", category, 1)]
    assert not program.unread and sum(room.type == "bedroom" for room in program.rooms) == 2
