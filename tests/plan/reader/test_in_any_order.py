"""Sentences that do not hang on one another say the same in any order, with and without what ends a sentence."""

from itertools import cycle

import numpy as np
import pytest

from apartgen.stages.plan.reader import read

SAID = {
    "en": ["two bedrooms", "a kitchen of 12 m²", "the study is next to the bathroom",
           "the living room is larger than the kitchen", "the storage room opens off the kitchen", "no balcony",
           "the bathroom has at least 6 m²", "the study faces south"],
    "de": ["zwei Schlafzimmer", "eine Küche mit 12 m²", "das Arbeitszimmer liegt neben dem Bad",
           "das Wohnzimmer ist größer als die Küche", "der Abstellraum geht von der Küche ab", "kein Balkon",
           "das Bad hat mindestens 6 m²", "das Arbeitszimmer liegt nach Süden"],
    "fr": ["deux chambres", "une cuisine de 12 m²", "le bureau est à côté de la salle de bain",
           "le salon est plus grand que la cuisine", "le cellier donne sur la cuisine", "pas de balcon",
           "la salle de bain fait au moins 6 m²", "le bureau donne au sud"],
    "es": ["dos dormitorios", "una cocina de 12 m²", "el despacho está junto al baño",
           "el salón es más grande que la cocina", "el trastero da a la cocina", "sin balcón",
           "el baño tiene al menos 6 m²", "el despacho da al sur"],
}
ROOMS = {"bathroom_1", "bedroom_1", "bedroom_2", "kitchen_1", "living_room_1", "storage_1", "study_1"}
ENDS = cycle([(". ", "."), (". ", ""), ("; ", ""), ("\n", ""), (".\n", ".")])


@pytest.mark.parametrize("language", SAID)
def test_sentences_say_the_same_in_any_order(language: str) -> None:
    rng = np.random.default_rng(2)
    for _ in range(12):
        between, end = next(ENDS)
        said = [SAID[language][k] for k in rng.permutation(8)]
        text = between.join(one[:1].upper() + one[1:] for one in said) + end
        found = read(text)
        areas = {room.id: room.area for room in found.rooms if room.type != "hallway"}
        assert set(areas) == ROOMS
        assert areas["kitchen_1"] == 12 and areas["bathroom_1"] >= 6 and areas["living_room_1"] > 12, text
        assert [link for link in found.links if "storage_1" in link] == [("kitchen_1", "storage_1")], text
        assert {(r.kind, r.of, r.to, r.value) for r in found.requirements} == {
            ("adjacent", "study_1", "bathroom_1", None), ("area", "kitchen_1", None, "12"),
            ("at_least", "bathroom_1", None, "6"),
            ("order", "living_room_1", "kitchen_1", "larger"), ("orientation", "study_1", None, "south")}, text
        assert found.unread == [], text


@pytest.mark.parametrize("said, side", [
    ("donne au sud", "south"), ("donne plein nord", "north"), ("donne vers le nord", "north"),
    ("donne à l'est", "east"), ("donne vers l'ouest", "west"), ("est exposé à l'est", "east"),
    ("est exposé à l'ouest", "west"), ("est orienté au nord", "north")])
def test_where_french_rooms_face(said: str, side: str) -> None:
    found = read(f"Deux chambres. Le salon {said}.")
    assert [(r.kind, r.of, r.value) for r in found.requirements] == [("orientation", "living_room_1", side)]
    assert found.unread == []


def test_what_a_french_room_opens_onto_is_no_side_of_it() -> None:
    found = read("Deux chambres. Le cellier donne sur la cuisine. Le salon est au sud.")
    assert ("kitchen_1", "storage_1") in found.links
    assert [(r.kind, r.value) for r in found.requirements] == [("position", "south")]


@pytest.mark.parametrize("between", [". ", "\n", "\n\n", "\r\n", "\t", "; "])
@pytest.mark.parametrize("first, second", [
    ("Two bedrooms", "The bathroom is at least 6 m²"), ("Deux chambres", "La salle de bain fait au moins 6 m²"),
    ("Zwei Schlafzimmer", "Das Bad mindestens 6 m²"), ("Dos dormitorios", "Baño al menos 6 m²")])
def test_limits_are_read_after_any_end_of_a_sentence(first: str, second: str, between: str) -> None:
    found = read(f"{first}{between}{second}")
    assert [(r.kind, r.of, r.value) for r in found.requirements] == [("at_least", "bathroom_1", "6")]
    assert sum(room.type == "bedroom" for room in found.rooms) == 2
