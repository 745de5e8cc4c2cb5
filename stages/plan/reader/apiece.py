"""Rooms of which each of several people has one, counted."""

import re
from dataclasses import replace

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.own_rooms import own_rooms
from apartgen.stages.plan.reader.phrase import plural

EACH_NEEDS = re.compile(
    r"(?P<who>\b(?P<n>[2-6]|two|three|four|five|six) "
    r"(?!(?:\w+ )?\w*(?:rooms?|beds?|suites?)\b)(?:\w+ )?\w+)(?: who|,)? each (?:of them |one )?"
    r"(?:needs?|wants?|have|has|gets?|with) (?:an?|their own|his own|her own) "
    r"(?P<room>(?:home )?office|study|workroom|balcony|bath ?room|shower room|dressing room|closet)\b"
)
"""Whom a room is wanted for each of, a room beside those one sleeps in."""
EACH_BEHIND = re.compile(
    r"(?P<who>\b(?P<n>[2-6]|two|three|four|five|six) (?:people|persons|adults|friends|students|flatmates|roommates)),? "
    r"(?:and |with )?(?:an?|one|their own) (?:own |separate |private )?"
    r"(?P<room>study|home office|office|balcony|bath ?room|shower room)(?: for)? each\b(?! other)"
)
"""The same with `each` at the end."""
EACH_OF_US = re.compile(
    r"\b(?P<n>[2-6]|two|three|four|five|six) of us\b(?P<said>[^.;:]{0,40})[.;:,-] ?(?:and )?(?:everyone|everybody|each)"
    r"(?: of us| one)? (?:gets?|has|have|needs?|wants?|should have|must have) (?:an?|their own|his own|our own) "
    r"(?:own )?(?:bed ?)?room\b"
)
"""People of whom nobody shares a room."""
EACH_OF_FAMILY = re.compile(
    r"\b(?:everyone|everybody|each(?: one| member| person)?|every member) (?:in|of) (?:the|our|my|a) "
    r"family of (?P<n>[2-6]|two|three|four|five|six) (?:has|have|needs|wants|gets|should have|must have) "
    r"(?:an?|their|his or her|his|her) (?:own )?(?:bed ?)?room\b"
)
"""A family of which nobody shares a room."""

EACH_CHILD = [re.compile(said) for said in (
    r"\b(?:each|every) (?:child|kid|son|daughter|boy|girl|of the (?:children|kids)|of our (?:children|kids)) "
    r"(?:should have|must have|has|gets|needs|"
    r"wants|should get) (?:its|his|her|their|an?) (?:own )?(?:bed ?)?room[;,.:]? (?:and )?(?:we have|there are|we've "
    r"got|they are) "
    r"(?P<n>two|three|four|five|[2-5])(?: of them| children| kids)?(?= ?(?:[.,;]|$))",
    r"\b(?:les|nos|mes) (?:enfants|filles|garcons) ont chacune? (?:leur|sa|une) (?:propre )?chambre,? \(?(?:ils|"
    r"elles) sont (?P<n>deux|trois|quatre|[2-4])\)?",
    r"\bcada (?:hij[oa]|nin[oa]) (?:tiene|quiere|necesita|tendra) (?:su|una) (?:propia )?habitacion(?: propia)?,? y "
    r"son (?P<n>dos|tres|cuatro|[2-4])\b",
    r"\bjedes (?:kind|madchen) (?:hat|bekommt|braucht|soll) (?:ein|sein) (?:eigenes )?zimmer(?: haben| "
    r"bekommen)?[,;.:]? (?:und )?(?:wir haben|es sind) "
    r"(?P<n>zwei|drei|vier|[2-4])\b",
)]
"""Children who each have a room, counted behind it."""
COUNTED_CHILDREN = re.compile(r"\b(?P<n>two|three|four|five|[2-5]) (?:children|kids|sons|daughters|boys|girls)\b")
OWN_ROOM = re.compile(
    r"(?<=[.;:,-] )(?:and )?(?:each|every) (?:child|kid|son|daughter|boy|girl) "
    r"(?:should have|must have|has|gets|needs|wants) (?:its|his|her|their) own (?:bed ?)?room(?= ?(?:[.,;]|$))"
)
EVERYBODY = (("each",), ("for", "each"), ("for", "everyone"), ("for", "everybody"), ("per", "person"), ("per", "head"),
             ("for", "each", "person"), ("for", "every", "person"))  # fmt: skip
"""What behind a bedroom says that everybody has one, where no rooms are spoken of."""
LIVING = ("unknown", "stop", "thing", "adjective")
"""Kinds of words for people that the lexicon does not know."""


def bedrooms_apiece(words: list[Lexeme], people: int) -> list[Lexeme]:
    """`three nurses with a bedroom each` as three bedrooms; `people` are those counted elsewhere, 0 where nobody is."""
    for k, word in enumerate(words):
        bedroom = word.kind == "room" and not word.plural and word.value.partition(":")[0] == "bedroom"
        if k == 0 or not _one(words[k - 1]) or not bedroom:
            continue
        each, end = _everybody(words, k)
        at = _people_at(words, k)
        count = int(words[at].number) if at is not None else people
        if not end or count < 2:
            continue
        number = Lexeme("number", str(count), str(count), values=(float(count),))
        before = [replace(w, kind="stop", value="") if j == at else w for j, w in enumerate(words[:each])]
        if _counted(words[:each], count):
            before.append(Lexeme("determiner", "the", "the"))  # "four bedrooms …; the two older ones have one each"
        return [*before, number, replace(word, plural=True), *words[end:]]
    return words


def _counted(words: list[Lexeme], count: int) -> bool:
    """Whether at least so many bedrooms were counted."""
    pairs = zip(words, words[1:], strict=False)
    return any(n.kind == "number" and n.number >= count and w.value == "bedroom" and w.plural for n, w in pairs)


def _one(word: Lexeme) -> bool:
    return word.kind == "determiner" or (word.kind == "number" and word.number == 1)


def _everybody(words: list[Lexeme], k: int) -> tuple[int, int]:
    """Where the words for a bedroom of each begin and end, (0, 0) where the room at `k` is no such one."""
    texts = [w.text for w in words]
    if k > 2 and texts[k - 3 : k - 1] in (["each", "with"], ["each", "has"], ["each", "having"]):
        return k - 3, k + 1
    for said in sorted(EVERYBODY, key=len, reverse=True):
        end = k + 1 + len(said)
        if tuple(texts[k + 1 : end]) == said and not _of_rooms(words, end):
            return k - 1, end + (texts[end : end + 1] in (["of them"], ["of us"]))
    return 0, 0


def _of_rooms(words: list[Lexeme], end: int) -> bool:
    """`a bedroom for each child`, `for each of the two boys`: not of those counted before."""
    ends = end >= len(words) or words[end].kind in ("mark", "conjunction", "with", "boundary", "area")
    ends = ends or [w.kind for w in words[end : end + 2]] == ["stop", "area"]  # "a bedroom each of 13 m²"
    return not ends and words[end].text not in ("of them", "of us")


def _people_at(words: list[Lexeme], k: int) -> int | None:
    """Where the last number of people before `k` stands; None where rooms or other things are counted last."""
    for j in range(k - 2, -1, -1):
        counts = words[j].kind == "number" and 2 <= words[j].number <= 9
        if counts and j + 1 < k and words[j + 1].kind in LIVING and words[j + 1].text not in ("of", "m", "floors"):
            return j
        if words[j].kind in ("room", "area", "number"):
            return None
    return None


def apiece(text: str) -> str:
    """A folded text with as many of such rooms as there are people."""
    for pattern in (EACH_NEEDS, EACH_BEHIND):
        text = pattern.sub(_of_each, text)
    for pattern in EACH_CHILD:
        text = pattern.sub(lambda found: f"{number(found['n'])} kids rooms", text)
    text = own_rooms(_each_child(text))
    text = EACH_OF_US.sub(r"a flat for \g<n> people\g<said>: \g<n> bedrooms", text)
    return EACH_OF_FAMILY.sub(r"\g<n> bedrooms", text)


def _each_child(text: str) -> str:
    """`three children. A parents' bedroom; each child gets their own bedroom`, of a home whose other rooms are told."""
    counted, ours = COUNTED_CHILDREN.search(text), re.search(r"\b(?:parents'|master|main|our) bed ?room\b", text)
    if counted is None or ours is None:
        return text
    return OWN_ROOM.sub(f"{number(counted['n'])} kids rooms", text)


def number(said: str) -> int:
    """A number as it is written in any of the languages."""
    return int(said) if said.isdigit() else numbers()[said]


def _of_each(match: re.Match[str]) -> str:
    """`two people who each need a study` as two people and two studies."""
    return f"{match['who']}, {match['n']} {' '.join(plural(tuple(match['room'].split())))}"
