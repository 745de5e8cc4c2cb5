"""Hallways under different names: a foyer is no corridor, a landing no hall."""

from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Det, Trait

CORRIDORS = frozenset("corridor passage landing korridor couloir degagement pasillo corredor".split()) | {
    "走 廊",
    "过 道",
}
"""Words for a hallway that no one uses of the entrance hall."""
FOYERS = frozenset(
    "foyer vestibule lobby entry entryway mudroom anteroom diele windfang eingangsbereich entree l'entree recibidor "
    "vestibulo entrada".split()
) | {"mud room", "hall d'entree", "玄 关", "门 厅"}
"""Words for where one comes in that no one uses of a passage between rooms."""
NAMED = ("utility", "storage", "study", "dining_room", "closet", "balcony")
"""Rooms of which most homes have one."""
PASSAGES = ("hallway", "passageway", *CORRIDORS)


STUDIES = frozenset("study office den workroom".split()) | {"home office", "work room", "office room", "study room",
"work space"}
"""Words that are said of one room to work in."""


def other_study(phrase: RoomPhrase, known: list[Entity]) -> bool:
    """Whether the phrase speaks of another room than the `known` ones: a library is no study."""
    if phrase.type != "study" or not known or phrase.text == "":
        return False
    return all({phrase.text, e.name} - STUDIES and phrase.text != e.name for e in known)


def other_hall(phrase: RoomPhrase, known: list[Entity], mentioned: bool) -> bool:
    """Whether the phrase speaks of a hallway besides the `known` ones."""
    if phrase.type != "hallway" or not known or not mentioned:
        return False
    if not any(_same(phrase.text, e.name) for e in known):
        return True
    entered = all(Trait.ENTRANCE in e.labels for e in known) and Trait.ENTRANCE not in phrase.labels
    return entered and (phrase.quantifier == Det.A or (phrase.quantifier == Det.BARE and phrase.text in CORRIDORS))


def best_named(phrase: RoomPhrase, known: list[Entity]) -> list[Entity]:
    """Of the `known` hallways those that may bear this name; all where none does."""
    return [e for e in known if may_be(phrase, e)] or known


def may_be(phrase: RoomPhrase, room: Entity) -> bool:
    """Whether the phrase's name may be said of the room: no foyer is a corridor."""
    return phrase.type != "hallway" or _same(phrase.text, room.name)


def spoken_of_before(phrase: RoomPhrase, known: list[Entity]) -> bool:
    """`Living room has a balcony`, `big bedroom has a bath`: known rooms, though no article says so."""
    lone = len(known) == 1 and phrase.count is None
    if lone and phrase.quantifier == Det.A and phrase.type in ("living_room", "kitchen"):
        return bool(phrase.areas) and known[0].area is None and known[0].name == phrase.text
    if phrase.quantifier != Det.BARE or phrase.labels or phrase.plural:
        return False
    if lone and phrase.type in NAMED and phrase.areas and known[0].area is None:
        return known[0].name == phrase.text  # "a study and a lounge. … Lounge 24 m², study 9 m²."
    if lone and phrase.type == "bathroom" and _told_more(phrase, known[0]):
        return known[0].name == phrase.text  # "kitchen, bathroom and two bedrooms. … Bathroom: 5 m²."
    if lone and phrase.type in ("living_room", "kitchen", "dining_room") and phrase.areas and known[0].area is None:
        return True  # "kitchen + living: open plan, living room: 32 m²"
    if phrase.type in ("living_room", "kitchen"):
        return any(e.name == phrase.text and not e.labels for e in known)
    if lone and phrase.objects and phrase.type in ("utility", "storage", "study", "dining_room"):
        return known[0].name == phrase.text  # "utility room has a washing machine"
    counted = len(known) > 1 and all(e.counted for e in known)
    return phrase.type == "bedroom" and counted and phrase.factor != 1.0 and bool(phrase.owned)


def _told_more(phrase: RoomPhrase, room: Entity) -> bool:
    """Whether a size or furniture is told where none of a room was known."""
    sized, furnished = phrase.areas and room.area is None, phrase.objects and not room.objects
    return bool(sized or furnished) and not room.labels


def hall_rank(room: Entity) -> int:
    """Where one comes in first, a landing last."""
    return 0 if Trait.ENTRANCE in room.labels or room.name in FOYERS else 2 if room.name == "landing" else 1


def _same(word: str, name: str) -> bool:
    """Whether two words may be said of one hallway."""
    pair = {" ".join(text.split()[-1:]) if text.isascii() else text for text in (word, name)}
    if "landing" in pair:
        return len(pair) == 1 or "" in pair
    return not (pair & set(FOYERS) and pair & set(PASSAGES))
