"""What no room of a type is to be: `no bedroom next to the kitchen` denies a neighbour, not the bedrooms."""

from apartgen.stages.plan.reader.banned import ALWAYS
from apartgen.stages.plan.reader.extents import LESS, MORE
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, rooms_of
from apartgen.stages.plan.reader.vocabulary import Det, Relation

NONE = ("none", "no", "kein", "keine", "keines", "keiner", "keins", "aucun", "aucune",
        "ninguno", "ninguna", "ningun", "没有", "neither")  # fmt: skip
"""Words that say of how many rooms something holds: of none."""
NOWHERE = ("nowhere", "nirgends", "nirgendwo")
POINT = ("point", "place", "spot", "stelle", "endroit")
"""What is at none of these is nowhere."""
OTHER = {"at_least": "at_most", "at_most": "at_least"}
BETWEEN = ("copula", "relative", "reach")
SKIPPED = ("stop", "pronoun", "adjective", "negation", "determiner")
"""What may stand between `none` and the limit it denies: `none of them should be …`."""


def limits_denied(words: list[Lexeme]) -> list[Lexeme]:
    """`none of them under 10 m²` as `all of them at least 10 m²`."""
    out = list(words)
    for k, word in enumerate(out):
        if word.kind not in ("bound", "compare") or (bound := _bound(word)) is None:
            continue
        following = out[k + 1] if k + 1 < len(out) else None
        if following is None or following.kind not in ("number", "area"):
            continue
        at = none_before(out, k)
        no = k - 1
        while no > 0 and out[no].kind == "stop" and out[no].value != "word":
            no -= 1  # "may not be smaller than"
        if no >= 0 and out[no].kind == "negation" and out[no].value == "not":
            out[no], out[k] = Lexeme("stop", "", out[no].text), Lexeme("bound", OTHER[bound], word.text)
        elif at is not None:
            out[at] = Lexeme("determiner", "each" if _one(out[at + 1]) else "all", out[at].text)
            out[k] = Lexeme("bound", OTHER[bound], word.text)
    return out


def _bound(word: Lexeme) -> str | None:
    if word.kind == "bound":
        return word.value
    other = word.reading("bound")
    return other.value if other is not None else None


def _one(word: Lexeme) -> bool:
    return word.kind in ("room", "main_rooms")


def none_before(words: list[Lexeme], k: int) -> int | None:
    """Where the `none` stands that the limit at `k` is said with."""
    j, room = k - 1, False
    while j >= 0:
        if words[j].text.partition(" ")[0] in NONE:
            return j
        if words[j].kind not in SKIPPED and (room or not _one(words[j])):
            return None
        room = room or _one(words[j])
        j -= 1
    return None


def nowhere_less(words: list[Lexeme]) -> list[Lexeme]:
    """`nowhere may the hall be narrower than 1.2 m` with a `not` before the limit."""
    out = list(words)
    for at in [k for k, word in enumerate(words) if word.text in NOWHERE or _no_point(words[k : k + 2])]:
        limit = next((k for k in range(at + 1, len(out)) if _limits(out[k]) or out[k].kind == "mark"), len(out))
        if limit < len(out) and _limits(out[limit]):
            places = [out.pop(at) for _ in range(1 + (out[at].text not in NOWHERE))]
            out.insert(limit - len(places), Lexeme("negation", "not", " ".join(w.text for w in places)))
    return out


def _no_point(words: list[Lexeme]) -> bool:
    return len(words) > 1 and words[0].text in NONE and words[1].text in POINT


def _limits(word: Lexeme) -> bool:
    return word.kind == "compare" or _bound(word) is not None or word.text.partition(" ")[0] in (*MORE, *LESS)


def all_denied(items: list[Item]) -> list[Item]:
    """`no bedroom adjoins the kitchen` as `all bedrooms: not next to the kitchen`.

    `no bedroom off the kitchen` says the same of rooms that there are, and of others only that there are none.
    """
    out: list[Item] = []
    for k in range(len(items)):
        item = items[k]
        no, phrase = (out[-1] if out else Item("")), item.room
        denied = no.kind == "negation" and phrase is not None and phrase.negated
        denied = denied and phrase is not None and (no.text.split()[0] in NONE or phrase.quantifier == Det.THE)
        at = k + 1
        while denied and at < len(items) and items[at].kind in BETWEEN:
            at += 1
        link, other = (items[at : at + 2] + [Item(""), Item("")])[:2]
        finite = link.form in ("s", "p") or at > k + 1
        near = link.value in (Relation.NEAR, Relation.APART)
        if denied and phrase is not None and other.room is not None and finite and not _there_is(phrase, items):
            items = [*items[:at], Item("mark", ",", ","), *items[at + 1 :]]  # "no study is off the kitchen": none is
            out.append(item)
            continue
        if denied and phrase is not None and other.room is not None and link.value == Relation.DOOR and not finite:
            near = _there_is(phrase, items)
            items = items if near else [*items[:at], Item("mark", ",", ","), *items[at + 1 :]]
        if denied and phrase is not None and link.kind == "link" and other.room is not None and (finite or near):
            out.pop()
            phrase.negated = False
            phrase.quantifier = Det.THE if phrase.quantifier == Det.THE else Det.ALL
            out += [item, Item("negation", "not", no.text)]
        else:
            out.append(item)
    return out


def _there_is(phrase: RoomPhrase, items: list[Item]) -> bool:
    """Whether a home has rooms of this type, or others speak of one."""
    known = phrase.type in ALWAYS or phrase.type in ("any", "")
    return known or any(r.type == phrase.type and not r.negated for r in rooms_of(items))


def of_all(phrases: list[RoomPhrase]) -> list[RoomPhrase]:
    """`not next to a bedroom` asks for no bedroom and is said of all of them."""
    for phrase in phrases:
        if phrase.quantifier == Det.A and phrase.count is None:
            phrase.quantifier = Det.ALL
    return phrases
