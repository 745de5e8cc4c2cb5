"""Rooms said by what they are for: `two for sleeping and one for work`, `somewhere to cook`, `a room for bikes`."""

import tomllib
from functools import cache
from pathlib import Path

from apartgen.stages.plan.reader.lexeme import Lexeme

PLACES = ("somewhere", "place", "places", "space", "corner", "area", "platz", "ort", "endroit", "lugar", "sitio")
"""Nouns of rooms that say nothing but what is for something."""
BEHIND = ("for", "to", "for to", "fur", "zum", "zur", "pour", "para", "where")
"""What stands before a purpose."""
BETWEEN = ("the", "our", "my", "their", "a", "an", "die", "das", "den", "der", "unsere", "meine", "les", "le", "la",
           "nos", "los", "las", "i", "we", "you", "one", "do", "can", "could", "man", "ich", "wir", "zu")  # fmt: skip
OPEN = {"living_room", "kitchen", "dining_room"}
ENDS = ("mark", "conjunction", "boundary", "relative", "with", "link", "area", "bound")


def purposes(words: list[Lexeme]) -> list[Lexeme]:
    """Rooms in the place of counts, places and rooms with what they are for; other purposes make a storage room."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        kind, end = _purpose(words, i)
        named = words[i].kind == "room" and {"to", "for"} & set(words[i].text.split())
        if named and _second(words, i + 1)[0]:
            kind, end = words[i].value, i + 1  # "a room to live and cook in"
        if kind:
            text = " ".join(w.text for w in words[i:end])
            count = words[i].kind == "number" and words[i].text[0] != "a"
            out += [words[i]] if count else []
            out.append(Lexeme("room", kind, text, plural=count and words[i].number > 1))
            named = {kind}
            while (more := _second(words, end))[0] and more[0] not in named and {*named, more[0]} <= OPEN:
                out += [Lexeme("mark", "/", "/"), Lexeme("room", more[0], words[more[1] - 1].text)]
                named, end = {*named, more[0]}, more[1]
            i = end + (end < len(words) and words[end].text == "in" and _ends(words, end + 1))
        else:
            out.append(words[i])
            i += 1
    return out


def _purpose(words: list[Lexeme], i: int) -> tuple[str, int]:
    """Type and end of the room said by its purpose that begins at `i`, ("", i) where none does."""
    head, j = words[i], i + 1
    room = head.kind == "main_rooms" and head.value == "rooms"
    place = head.text in PLACES
    if head.text == "one to" and head.kind == "link":
        return _known(words, j)  # "one to work"
    counts = head.kind == "number" and head.number <= 6 and head.number % 1 == 0
    if not (room or place or counts) or (room and i and words[i - 1].kind == "number" and words[i - 1].number > 3):
        return "", i
    start = j
    while j < len(words) and words[j].text in BEHIND:
        j += 1
    if j == start:
        return "", i
    while j < len(words) and words[j].text in BETWEEN:
        j += 1
    if j >= len(words):
        return "", i
    kind, end = _known(words, j)
    if kind == "bedroom:guest" and counts and any(w.value.startswith(("bedroom", "bathroom")) for w in words[:i]):
        return "", i  # "five bedrooms; one for guests"
    if kind:
        return kind, end
    thing = room and (head.kind == "main_rooms") and words[j].kind in ("unknown", "furniture") and _ends(words, j + 1)
    return ("storage", j) if thing and not head.plural else ("", i)


def _second(words: list[Lexeme], end: int) -> tuple[str, int]:
    """The other purpose of `one room to live and cook in`."""
    and_ = end + 1 < len(words) and (words[end].kind == "conjunction" or words[end].text == ",")
    return _known(words, end + 1) if and_ else ("", end)


def _known(words: list[Lexeme], j: int) -> tuple[str, int]:
    """The room for the longest purpose at `j`; none for `a place to work in the living room`."""
    for n in (3, 2, 1):
        text = " ".join(w.text for w in words[j : j + n])
        kind = _data().get(text)
        inside = j + n + 1 < len(words) and words[j + n].text == "in" and not _ends(words, j + n + 1)
        if kind and not inside and _ends(words, j + n):
            return kind, j + n
    return "", j


def _ends(words: list[Lexeme], j: int) -> bool:
    return j >= len(words) or words[j].kind in ENDS or words[j].text in ("in", "of", "is")


@cache
def _data() -> dict[str, str]:
    rows = tomllib.loads((Path(__file__).parent / "purposes.toml").read_text(encoding="utf-8"))
    return {text: kind for kind, texts in rows.items() for text in texts}
