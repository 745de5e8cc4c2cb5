"""For whom some of the rooms counted are: `one for the parents and two for the kids`, `all are near the entrance`."""

from apartgen.stages.plan.reader.clausal import ahead, last
from apartgen.stages.plan.reader.kin import kind_of, pattern
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.mention import Item, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

LABELS = {"child": "kids", "twins": "kids", "adult": "relative", "couple": "master", "spouse": "master"}
"""What the bedroom of such people is."""
ELDERS = ("grandparents", "grosseltern", "grands parents", "abuelos")
THEIR = ("the", "our", "my", "their", "his", "her", "a", "an")
WHO = {Trait.KIDS, Trait.RELATIVE, Trait.MASTER, Trait.GUEST}
SAID = ("link", "side", "place", "front", "beside")
"""Kinds with which begins what is said of rooms behind a verb."""


GUESTS = ("guests", "visitors", "guest", "visitor")
BEING = ("is", "are", "should be", "must be", "will be", "shall be")
PRONOUNS = ("me", "us", "her", "him", "them", "myself", "ourselves")
OF_US = (["of", "us"], ["of", "them"], ["of", "you"])
ALL_OF_US = ("all of", "both of")
ENDS = ("mark", "conjunction", "with", "boundary", "link", "side", "place", "area")
SLEEPERS = {"kids", "relative"}


def rooms_of_people(words: list[Lexeme]) -> list[Lexeme]:
    """`two rooms for the kids`, `a room for my mother` are bedrooms, where others of the home have one."""
    found = [(k, whom) for k in range(1, len(words)) if (whom := _whose_room(words, k)) is not None]
    beds = sum(w.kind == "room" and w.value.startswith("bedroom") for w in words)
    out = list(words)
    for k, (who, at, count) in found if len(found) + beds > 1 else []:
        number = words[k - 1]
        out[k] = Lexeme("room", "bedroom", words[k].text, plural=count > 1 or words[k].plural)
        out[at] = Lexeme("label", who, words[at].text) if who else words[at]
        if count > 1:
            out[k - 1] = Lexeme("number", str(count), number.text, values=(float(count),))
            out[k + 2 : at] = [Lexeme("stop", "stop", w.text) for w in words[k + 2 : at]]
    return out


def _whose_room(words: list[Lexeme], k: int) -> tuple[str, int, int] | None:
    """The label of those the room at `k` is for, where they stand and how many each have one."""
    number, after = words[k - 1], words[k + 1 : k + 2]
    counts = number.kind == "number" and number.number <= 6
    one = number.kind == "determiner" or (counts and number.number == 1)
    if words[k].kind != "main_rooms" or words[k].value != "rooms" or not (one or counts):
        return None
    if [w.text for w in after] != ["for"]:
        return None
    j = k + 2
    each = [w.text for w in words[j : j + 2]] == ["each", "of"]
    j += 2 * each
    if one and not each and _pronoun(words, j):
        return "", j, 1
    while j < len(words) and words[j].text in THEIR:
        j += 1
    many = j if each and j < len(words) and words[j].kind == "number" else None
    j += many is not None
    if j >= len(words):
        return None
    count = int(words[many].number) if many is not None else 1
    label = words[j].value if words[j].kind == "label" else _person(words[j].text)
    return (label, j, count) if label in SLEEPERS and (many is not None) == each else None


def _pronoun(words: list[Lexeme], j: int) -> bool:
    """Whether people are spoken of at `j` by a pronoun; `her` of `her son` is none."""
    ends = j + 1 >= len(words) or words[j + 1].kind in ENDS
    return j < len(words) and words[j].text in PRONOUNS and ends


def _person(text: str) -> str:
    """The label of the bedroom of people so called, "" for words of no people."""
    found = pattern("^(?:{who})$").search(text)
    return LABELS.get(kind_of(found), "") if found is not None else ""


def for_people(words: list[Lexeme]) -> list[Lexeme]:
    """People behind `one for` tell whose room it is, where bedrooms were counted before."""
    words = rooms_of_people(_for_all_of_us(words))
    out: list[Lexeme] = []
    beds = False
    for k, word in enumerate(words):
        beds = beds or (word.kind == "room" and word.value.startswith("bedroom"))
        who = _who(words, k) if beds and _counts(words, k) else ""
        out.append(Lexeme("label", who, word.text) if who else word)
    return out


def _for_all_of_us(words: list[Lexeme]) -> list[Lexeme]:
    """`one bathroom for all of us`, `for the five of us`, `for all`: people, and none of the rooms told before."""
    out = list(words)
    for k in range(1, len(words)):
        if words[k].text != "for":
            continue
        end = next((j for j in range(k + 1, len(words)) if words[j].kind not in ("determiner", "number")), len(words))
        us = end + 1 < len(words) and [w.text for w in words[end : end + 2]] in OF_US
        us = us or words[end - 1].text in ALL_OF_US
        alone = words[end - 1].text == "all" and (end == len(words) or words[end].kind in ("mark", "conjunction"))
        if end > k + 1 and (us or alone):
            stop = end + (0 if alone else 1 if words[end - 1].text in ALL_OF_US else 2)
            out[k:stop] = [Lexeme("stop", "stop", w.text) for w in words[k:stop]]
            if stop < len(words) and words[stop].kind == "conjunction":
                out[stop - 1] = Lexeme("mark", ",", ",")  # what follows is said of the next room alone
    return out


def _bedrooms_last(words: list[Lexeme], k: int) -> bool:
    """Whether of rooms, bedrooms were named last."""
    return next((w.value for w in reversed(words[:k]) if w.kind == "room"), "").startswith("bedroom")


def _counts(words: list[Lexeme], k: int) -> bool:
    """Whether a number and `for`, or `is for`, stand before."""
    j = k - 1
    while j > 0 and words[j].text in THEIR:
        j -= 1
    if j > 1 and words[j].text == "for" and words[j - 1].text in BEING and _bedrooms_last(words, k):
        j -= 1
        words = [*words[:j], words[j + 1], *words[j + 1 :]]  # "one is for the kids"
    return j > 0 and words[j].text == "for" and (
        (words[j - 1].kind == "number" and words[j - 1].number <= 9)
        or words[j - 1].kind == "ordinal"
        or words[j - 1].value in ("other", "another")
    )


def _who(words: list[Lexeme], k: int) -> str:
    ends = k + 1 >= len(words) or words[k + 1].kind in ("mark", "conjunction", "with", "boundary", "number")
    if ends and words[k].text in GUESTS and _bedrooms_last(words, k):
        return "guest"
    found = pattern("^(?:{who})$").search(words[k].text) if ends and words[k].kind in ("unknown", "stop") else None
    if found is None:
        return ""
    return "relative" if words[k].text in ELDERS else LABELS.get(kind_of(found), "")


def whose(out: list[Item], items: list[Item], k: int) -> bool:
    """`two for the kids`: the two are the kids'."""
    people, at = items[k].room, len(out) - 2 - (len(out) > 2 and out[-2].kind == "copula")
    before = out[at].room if at >= 0 else None
    if people is None or before is None or (last(out).kind, last(out).text) != ("with", "for"):
        return False
    if people.type or people.count or not people.labels or not people.labels <= WHO:
        return False
    one = before.type == "bedroom" and before.quantifier == Det.A
    if not (before.count or before.ordinals or one or before.quantifier in (Det.OTHER, Det.ANOTHER)):
        return False
    if before.type not in ("", "bedroom"):
        return False
    if before.quantifier == Det.A and _alike_before(out[:at], people.labels):
        before.quantifier = Det.ANOTHER  # "a room for the daughter and a room for the son"
    before.labels |= people.labels
    return True


def _alike_before(out: list[Item], labels: set[Trait]) -> bool:
    """Whether `out` ends in a bedroom of such people, joined to what follows, and counts none."""
    rooms = [i.room for i in out if i.room is not None and i.room.type == "bedroom"]
    joined = [i.kind for i in out[-3:]] == ["room", "with", "conjunction"]
    one = joined and rooms[-1].quantifier == Det.A and rooms[-1].labels == labels
    return one and all((r.count or 1) == 1 and not r.plural for r in rooms)


def floating(out: list[Item], items: list[Item], k: int) -> bool:
    """The `all` of `the bedrooms are all away from the entrance`, which says nothing more."""
    room = items[k].room
    if room is None or room.type or room.quantifier not in (Det.ALL, Det.BOTH, Det.EACH) or room.count or room.labels:
        return False
    if room.text == "都":
        if (said_of := last(out).room) is not None and said_of.count is None and not _joined(out):
            said_of.quantifier, said_of.plural = Det.ALL, True  # "卧室都朝南"
        return True
    subject = out[-2].room if len(out) > 1 and out[-1].kind == "copula" else None
    several = subject is not None and (subject.plural or (subject.count or 1) > 1 or _pair(out))
    return several and ahead(items, k)[0].kind in SAID


def _joined(out: list[Item]) -> bool:
    return len(out) > 2 and out[-2].kind == "conjunction" and out[-3].room is not None


def _pair(out: list[Item]) -> bool:
    return len(out) > 3 and out[-3].kind == "conjunction" and out[-4].room is not None and not is_mark(out[-4], ",")


def sleeps_in(out: list[Item], items: list[Item], k: int) -> bool:
    """`they sleep in one bedroom, in a double bed`: the bedroom has it."""
    inside, room = ([Item("")] * 2 + (out[:-1] if is_mark(last(out), ",") else out))[-2:]
    bedroom = room.room is not None and room.room.type in ("bedroom", "")
    fits = items[k].value == "in" and bedroom and inside.value == "in"
    if not fits or ahead(items, k)[0].kind != "object" or ahead(items, k)[1].value == "in":
        return False
    if is_mark(last(out), ","):
        out.pop()
    out.append(Item("with", "has", items[k].text))
    return True
