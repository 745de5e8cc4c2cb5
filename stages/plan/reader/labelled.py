"""Rooms told apart by what they are: the guest bathroom, two children's rooms."""

import re
from typing import TYPE_CHECKING

from apartgen.stages.plan.reader.entity import DISTINCT, OTHERS, Entity
from apartgen.stages.plan.reader.halls import may_be
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.ranked import rest_of
from apartgen.stages.plan.reader.vocabulary import Det, Trait

if TYPE_CHECKING:
    from apartgen.stages.plan.reader.household import Household


WHOSE = (("boy", "son"), ("girl", "daughter"), ("twin",), ("bab", "nursery", "toddler"), ("teen",),
         ("grandm", "granny", "nan"), ("grandf", "grandpa"), ("mother", "mum", "mom", "madre"),
         ("father", "dad", "padre"))  # fmt: skip
"""Words of people whose rooms are not one another's."""
RELATIVES = ("儿子", "女儿", "孩子", "老人", "父母", "爸", "妈", "爷", "奶", "婆", "公公", "宝宝", "男孩", "女孩")
"""Whose room is told without `的`: `儿子房间`."""
GROWN = 5
"""From here on they are no children."""


POSSESSIVE = ("my", "our", "his", "her")
"""Of `my room`, `her bedroom`: two people's are two."""


def _of_others(text: str, name: str) -> bool:
    """Whether `the girls' room` is not `the boys' room`."""
    a, b = _whose(text), _whose(name)
    return None not in (a, b) and a != b


def _whose(text: str) -> int | None:
    who = re.sub(r".* de (?:mi|la|el) ", "", text)  # "cuarto de mi madre"
    return next((k for k, words in enumerate(WHOSE) if who.startswith(words)), None)


def _of_one(phrase: RoomPhrase, known: list[Entity]) -> list[Entity]:
    """`my mother's room`, where several are told to be relatives': one of them, from now on hers."""
    if phrase.plural or (_whose(phrase.text) or 0) < GROWN or len(known) < 2:
        return known
    for room in (free := [e for e in known if _whose(e.name) is None][:1]):
        room.name = phrase.text
    return free or known


def told_apart(phrase: RoomPhrase, known: list[Entity]) -> list[Entity] | None:
    """The room of `the 9 m² bedroom`, of `my room` beside `her room`; [] is a new one, None where nobody says so."""
    if phrase.quantifier == Det.THE and len(phrase.areas) == 1:
        return [e for e in known if e.area == phrase.areas[0]][:1] or None
    if phrase.bounds and phrase.quantifier == Det.BARE and len(known) == 1 and known[0].area is None:
        return known  # "bathrooms: 1. … bathroom <= 6 m²"
    if phrase.text.split()[0] not in POSSESSIVE:
        return None
    free = [e for e in known if e.name == phrase.text] or [
        e for e in known if not e.name.startswith((*POSSESSIVE, "parent")) and not e.labels & OTHERS
    ]
    if phrase.text.startswith(("his ", "her ")) and not any(e.counted for e in free):
        free.reverse()  # "a bedroom for us and one for our daughter. Her bedroom …": the last that was named
    for room in free[:1]:
        room.name = phrase.text
    return free[:1]


def labelled(home: "Household", phrase: RoomPhrase, labels: set[Trait]) -> list[Entity]:
    """Rooms that their traits tell from others of their type: known ones, or new ones."""
    several = len(home.of("bedroom")) if Trait.ENSUITE in labels else 0  # "a house with attached bathrooms"
    count = int(phrase.count or (max(2, several) if phrase.plural else 1))
    known = [e for e in home.of(phrase.type) if labels & e.labels and not _of_others(phrase.text, e.name)]
    known = [e for e in known if e.name == phrase.text and not phrase.plural] or known
    again = phrase.quantifier in (Det.THE, Det.BARE) or (
        id(phrase) in home.mentions and phrase.quantifier != Det.ANOTHER
    )
    if known and again and phrase.count is None:
        return _of_one(phrase, known)
    if known and phrase.count and all(e.vague for e in known):
        return known[:count] + home.add(phrase.type, count - len(known), labels=set(labels))
    if labels in ({Trait.SIZED}, {Trait.FAMILY}):
        free = [e for e in home.of(phrase.type) if not e.picked and not e.labels & set(DISTINCT)]
        if free and (phrase.quantifier == Det.THE or id(phrase) in home.mentions):
            return free[:1]
    apart = set(DISTINCT) - ({Trait.DOUBLE} if Trait.MASTER in labels else set())
    free = [e for e in home.of(phrase.type) if not e.labels & apart and not e.picked and e.owner is None]
    free = [e for e in free if may_be(phrase, e)]
    total = phrase.type in home.totals or phrase.subset
    placed = Trait.MASTER in labels and id(phrase) in home.mentions and phrase.quantifier == Det.BARE
    placed = placed and phrase.count is None and len([e for e in free if e.counted]) > 1  # "study near master bedroom"
    lone = phrase.type == "bedroom" and len(home.of("bedroom")) == 1 and bool(free) and not free[0].counted
    another = lone and bool(labels & OTHERS) and not total  # "their bedroom …; the guest room …"
    further = rest_of(phrase, home.of(phrase.type)) if phrase.quantifier == Det.ANOTHER else []
    placed = placed or bool(further)  # "a main bedroom, two further doubles"
    placed = placed or _one_of_counted(home, phrase, free)
    take = free if placed or (not another and _among_known(phrase, labels, free, total)) else []
    lesser = bool(labels & OTHERS) or (phrase.type == "bedroom" and Trait.SMALL in labels)
    found = take[-count:] if lesser else take[:count]  # the first bedroom is whose the home is
    full = len(home.of(phrase.type)) >= home.totals.get(phrase.type, 99) and phrase.quantifier != Det.ANOTHER
    if phrase.type in home.totals and phrase.quantifier != Det.ANOTHER and Trait.HALF not in labels:
        count = max(len(found), 1) if found else count
    if not found and full and labels == {Trait.MASTER}:
        found = [e for e in home.of(phrase.type) if not e.labels & set(DISTINCT)][:1]  # "both bedrooms …; the main one"
    found = found or _told_off_before(home, phrase, labels)
    found += home.add(phrase.type, count - len(found))
    for entity in found:
        entity.labels |= labels
        entity.picked = True
        entity.name = phrase.text if _whose(phrase.text) is not None else entity.name
    return found


def _among_known(phrase: RoomPhrase, labels: set[Trait], free: list[Entity], total: bool) -> bool:
    """Whether a labelled room is one of those counted before: `three bedrooms, master with ensuite`."""
    if phrase.quantifier == Det.ANOTHER or Trait.STAFF in labels or (Trait.HALF in labels and not phrase.subset):
        return False
    bare = (
        phrase.quantifier == Det.BARE
        and phrase.count is None
        and (
            phrase.text in ("master", "主 卧", "主 卧 室")
            or bool(phrase.owned or phrase.areas or phrase.objects)
            or phrase.factor != 1.0
        )
    )
    counted = len([e for e in free if e.counted])
    attribute = Trait.MASTER in labels and bare and counted > 1
    attribute = attribute or (phrase.plural and phrase.count is None and counted > 2)  # "… kids' rooms of equal size"
    return total or phrase.quantifier == Det.THE or attribute or _counted(free)


def _one_of_counted(home: "Household", phrase: RoomPhrase, free: list[Entity]) -> bool:
    """`three bedrooms. Grandma's bedroom is next to the bath`: of whose room more is said, it is one of those."""
    whose = phrase.quantifier == Det.BARE and phrase.count is None and _owned(phrase.text)
    told = bool({id(phrase)} & (home.mentions | home.asked)) or (bool(phrase.objects) and not phrase.text.isascii())
    return whose and told and len([e for e in free if e.counted]) > 1


def _told_off_before(home: "Household", phrase: RoomPhrase, labels: set[Trait]) -> list[Entity]:
    """`three bedrooms: one for us, one for her, one for our son. Grandmother's bedroom …`: the last without a name."""
    rooms = home.of(phrase.type)
    whose = bool(labels & OTHERS) and phrase.quantifier == Det.THE and phrase.count is None and _owned(phrase.text)
    fits = whose and phrase.type == "bedroom" and len(rooms) > 1 and all(e.counted and e.picked for e in rooms)
    return [e for e in rooms if not e.labels & set(DISTINCT)][-1:] if fits else []


def _owned(text: str) -> bool:
    """Whether a room is somebody's: `grandma's bedroom`, `爷爷奶奶的卧室`."""
    return "'s " in text or "的" in text or _told_in_chinese(text)


def _told_in_chinese(text: str) -> bool:
    plain = text.replace(" ", "")
    return any(plain.startswith(word) for word in RELATIVES)


def _counted(free: list[Entity]) -> bool:
    """`two bathrooms, ensuite in the master`: the ensuite is one of the two."""
    return bool(free) and free[0].type == "bathroom" and len([e for e in free if e.counted]) > 1
