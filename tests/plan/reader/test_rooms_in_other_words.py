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
    kinds = [SHORT[room.type] for room in program.rooms]
    assert kinds.count(kind) == 1 + 2 * (kind == "B") and not program.unread
