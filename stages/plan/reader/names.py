"""A description as a row of parts: names of rooms, sizes, words and marks."""

import re
from dataclasses import dataclass

from apartgen.stages.plan.reader.lexeme import Lexeme

NUMBERS = {"one": 1, "two": 2, "three": 3, "four": 4, "1st": 1, "2nd": 2, "3rd": 3, "4th": 4, "to": 2, "a": 1, "b": 2}
MOST = 6
"""Rooms of a kind that are told apart by numbers."""
APART = ("master", "guest", "kids", "relative", "staff", "entrance", "inner")
"""Traits that make another room of the same type."""
WAYS_IN = ("entry", "entryway", "entries")
"""No rooms of their own in a description."""
SHORT = ("common", "com", "comm")
"""Names of secondary bedrooms where the living room has its own."""


@dataclass(frozen=True, order=True)
class Name:
    """A room's type, the trait and the number that tell it from others."""

    type: str
    trait: str = ""
    number: int = 0


@dataclass(frozen=True)
class Part:
    """A name, an area, a word or a mark; words know the lexeme they are from."""

    text: str
    lexeme: Lexeme
    name: Name | None = None


def names(words: list[Lexeme]) -> list[Part]:
    """All parts of a text; names without numbers are those of the room last named so."""
    return _numbered(_parts(words))


def _parts(words: list[Lexeme]) -> list[Part]:
    out: list[Part] = []
    i = 0
    common = any(w.kind == "room" and w.value == "living_room" and not _common(w) for w in words)
    while i < len(words):
        word = words[i]
        room = _room(words, i, common)
        if word.text == "room" and out and out[-1].name is not None:
            i += 1  # "kitchen room"
        elif room is None:
            texts = [word.text] if word.kind in ("area", "number", "mark") else re.split(r"[\s-]+", word.text)
            out += [Part(text, word) for text in texts if text]
            i += 1
        else:
            i = _name(words, i, room, out)
    return out


def _name(words: list[Lexeme], i: int, room: tuple[str, str], out: list[Part]) -> int:
    """Adds the room named at `i`, with its numbers; returns where reading goes on."""
    numbers, end = _numbers(words, i + 1)
    before = out[-1] if out else None
    if not numbers and before is not None and before.lexeme.kind == "ordinal":
        numbers = [max(int(before.lexeme.number), 1)]
        out.pop()
    out += [Part(words[i].text, words[i], Name(*room, n)) for n in numbers or [0]]
    return end


def _room(words: list[Lexeme], i: int, common: bool) -> tuple[str, str] | None:
    """Type and trait of the room named at `i`; a common room is a bedroom where there is a living room."""
    word = words[i]
    if word.kind == "room" and word.text not in WAYS_IN:
        kind, _, traits = word.value.partition(":")
        if _common(word) and common:
            return "bedroom", ""
        return kind, next((t for t in APART if t in traits.split("+")), "")
    following = words[i + 1] if i + 1 < len(words) else None
    short = word.text in SHORT and (following is None or following.kind != "room")
    return ("bedroom", "") if short and common else None


def _common(word: Lexeme) -> bool:
    """`common room`, however it is spelled."""
    return word.value == "living_room" and word.text.startswith(("com", "second common"))


def _numbers(words: list[Lexeme], i: int) -> tuple[list[int], int]:
    """`2`, `1 and 2` behind a name, and where they end."""
    out: list[int] = []
    while i < len(words) and (n := _number(words, i)):
        out.append(n)
        i += 1
        if i + 1 < len(words) and words[i].text in ("and", "&", ",") and _number(words, i + 1):
            i += 1
        else:
            break
    return out, i


def _number(words: list[Lexeme], i: int) -> int:
    """A number that tells rooms apart, else 0: no length, no article."""
    word, following = words[i], words[i + 1] if i + 1 < len(words) else None
    if following is not None and (following.kind in ("unit", "room") or following.text in ("x", "by", "*")):
        return 0
    if word.kind == "number":
        return int(word.number) if word.number % 1 == 0 and 0 < word.number <= MOST else 0
    verb = following is not None and following.text.split()[:1] in (["is"], ["are"])
    return NUMBERS.get(word.text, 0) if verb and word.text in ("to", "a", "b") else 0


def _numbered(parts: list[Part]) -> list[Part]:
    known = {(p.name.type, p.name.trait) for p in parts if p.name is not None and p.name.number}
    last: dict[tuple[str, str], int] = {}
    out: list[Part] = []
    for part in parts:
        name = part.name
        if name is not None and (name.type, name.trait) in known:
            number = name.number or last.get((name.type, name.trait), 1)
            last[name.type, name.trait] = number
            part = Part(part.text, part.lexeme, Name(name.type, name.trait, number))
        out.append(part)
    return out
