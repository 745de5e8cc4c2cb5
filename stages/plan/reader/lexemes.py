"""Tokens as lexemes: longest phrases of the lexicon, numbers and listings' shorthand."""

import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path

from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.lexicon import Lexicon
from apartgen.stages.plan.reader.spelling import correct, split
from apartgen.stages.plan.reader.tokens import Token

ABBREVIATED = ("sq", "approx", "ca", "incl", "no", "apt", "ft", "env", "max", "min")
"""A full stop after these ends no sentence."""


@cache
def _shorthand() -> dict[str, dict[str, dict[str, str]]]:
    return tomllib.loads((Path(__file__).parent / "shorthand.toml").read_text())


def lexemes(tokens: list[Token], lexicon: Lexicon) -> list[Lexeme]:
    """All lexemes of a prompt in order, `mark` "." between sentences; numbers and units are not joined yet."""
    return _words(_split_words(tokens, lexicon), lexicon)


def _split_words(tokens: list[Token], lexicon: Lexicon) -> list[Token]:
    out: list[Token] = []
    for token in tokens:
        parts = (
            split(token.text, lexicon)
            if token.kind == "word"
            and (token.text,) not in lexicon.entries
            and correct(token.text, lexicon) == token.text
            else None
        )
        out += [token] if parts is None else [replace(token, text=parts[0]), replace(token, text=parts[1], glued=False)]
    return out


def _words(tokens: list[Token], lexicon: Lexicon) -> list[Lexeme]:
    out: list[Lexeme] = []
    i = 0
    joined = False
    while i < len(tokens):
        if _hyphen(tokens, i):
            joined, i = True, i + 1
            continue
        lexeme, i = _next(tokens, i, lexicon)
        out.append(replace(lexeme, joined=joined))
        joined = False
    return out


def _hyphen(tokens: list[Token], i: int) -> bool:
    return tokens[i].text == "-" and tokens[i].glued and i + 1 < len(tokens) and tokens[i + 1].glued


def _next(tokens: list[Token], i: int, lexicon: Lexicon) -> tuple[Lexeme, int]:
    short = _short(tokens, i)
    if short:
        return short
    first = tokens[i]
    if first.kind == "number" and not _starts_phrase(tokens, i, lexicon):
        return Lexeme("number", first.text, first.text, values=(first.value,), glued=first.glued), i + 1
    found = _longest(tokens, i, lexicon, {})
    if found and found[0].kind == "fraction" and _half_bath(tokens, i, lexicon):
        return Lexeme("determiner", "a", first.text), i + 1
    if found:
        slips = _slips(tokens, found[1], lexicon)
        return slips and _longest(tokens, i, lexicon, slips) or found
    if first.kind == "word":
        fixed = {
            j: correct(tokens[j].text, lexicon) for j in range(i, min(i + 3, len(tokens))) if tokens[j].kind == "word"
        }
        found = _longest(tokens, i, lexicon, fixed) if fixed[i] != first.text else None
        whom = found is not None and found[0].kind == "furniture" and _for_whom(tokens, i, lexicon)
        return found if found and not whom else (_compound(first, lexicon), i + 1)
    if first.text == "." and i and i + 1 < len(tokens) and _abbreviated(tokens[i - 1], tokens[i + 1]):
        return Lexeme("stop", "", "."), i + 1
    return Lexeme("mark", "." if first.text in "\n;!?." else first.text, first.text, glued=first.glued), i + 1


def _for_whom(tokens: list[Token], i: int, lexicon: Lexicon) -> bool:
    """Whether a home is for what stands at `i`, which is no furniture mistyped: `a studio for the hacker`."""
    home, goal, article = ([""] * 3 + [t.text for t in tokens[:i]])[-3:]
    homes = lexicon.entries.get((home,)) or ()
    return goal == "for" and article in ("the", "a", "an", "our") and any(e.kind == "dwelling" for e in homes)


def _abbreviated(word: Token, following: Token) -> bool:
    """Whether a full stop after the word ends no sentence: `approx. 9`, `no. 3`, but not `study: no. kitchen: open`."""
    return word.text in ABBREVIATED and (word.text != "no" or following.kind == "number")


def _half_bath(tokens: list[Token], i: int, lexicon: Lexicon) -> bool:
    """`a half bath`, but not `one and a half baths`."""
    room = _longest(tokens, i + 1, lexicon, {}) if tokens[i].text in ("a", "one") else None
    if room is not None and room[0].kind == "ordinal" and (noun := _longest(tokens, room[1], lexicon, {})) is not None:
        return noun[0].kind == "room"  # "a third bedroom"
    number = i > 1 and tokens[i - 1].text == "and"
    return room is not None and room[0].kind == "room" and room[1] > i + 2 and not (number and room[0].plural)


def _slips(tokens: list[Token], j: int, lexicon: Lexicon) -> dict[int, str]:
    """The correction of the word at `j`, which may make the phrase before it longer: `all togehter`."""
    word = tokens[j].text if j < len(tokens) and tokens[j].kind == "word" else ""
    fixed = correct(word, lexicon) if word and (word,) not in lexicon.entries else word
    return {j: fixed} if fixed != word else {}


def _compound(token: Token, lexicon: Lexicon) -> Lexeme:
    """`Einbauküche` by its end, else an unknown word."""
    ends = [end for end in lexicon.suffixes if token.text.endswith(end) and len(token.text) > len(end) + 2]
    if not ends:
        return Lexeme("unknown", token.text, token.text)
    entry = lexicon.suffixes[max(ends, key=len)]
    return Lexeme(entry.kind, entry.value, token.text)


def _starts_phrase(tokens: list[Token], i: int, lexicon: Lexicon) -> bool:
    found = _longest(tokens, i, lexicon, {})
    return found is not None and found[0].kind in ("ordinal", "compare", "number", "dwelling") and found[1] > i + 1


def _longest(tokens: list[Token], i: int, lexicon: Lexicon, fixed: dict[int, str]) -> tuple[Lexeme, int] | None:
    words: list[str] = []
    best: tuple[Lexeme, int] | None = None
    j = i
    while j < len(tokens) and len(words) < lexicon.longest:
        token = tokens[j]
        if _hyphen(tokens, j) and words:
            if words == ["hall"]:
                break  # "hall-bathroom" is a door, a hall bathroom is a room
            j += 1
            continue
        if token.text == "\n" or (token.kind == "mark" and token.text in ",.;:()" and token.text != "."):
            break
        words.append(fixed.get(j, token.text))
        j += 1
        entries = lexicon.entries.get(tuple(words))
        if entries:
            text = " ".join(t.text for t in tokens[i:j])
            head = entries[0]
            values = (float(head.value),) if head.kind in ("number", "fraction", "ordinal", "compare", "size") else ()
            best = (
                Lexeme(
                    head.kind,
                    head.value,
                    text,
                    head.plural,
                    values=values,
                    others=entries[1:],
                    glued=tokens[i].glued,
                    slips=_misspelled(tokens, range(i, j), fixed),
                ),  # fmt: skip
                j,
            )
    return best


def _misspelled(tokens: list[Token], at: range, fixed: dict[int, str]) -> tuple[tuple[str, str], ...]:
    return tuple((tokens[k].text, fixed[k]) for k in at if fixed.get(k, tokens[k].text) != tokens[k].text)


def _short(tokens: list[Token], i: int) -> tuple[Lexeme, int] | None:
    """`2bhk`, `2 BR`, `t3`; "3b2b" is read as three bedrooms and two bathrooms."""
    if i + 1 >= len(tokens):
        return None
    a, b = tokens[i], tokens[i + 1]
    if (
        a.kind == "number"
        and b.text == "-"
        and i + 2 < len(tokens)
        and tokens[i + 2].glued
        and tokens[i + 2].text in ("bhk", "br", "ba")
    ):
        b, i = tokens[i + 2], i + 1
    if (
        a.kind == "number"
        and b.text in _shorthand()["after"]
        and (b.glued and a.value <= 9 or len(b.text) > 1)
        and a.value <= 99
    ):
        bath = b.text == "b" and i > 0 and tokens[i - 1].text in ("b", "/") and a.glued
        parts = {"bathroom": "n"} if bath else _shorthand()["after"][b.text]
        return Lexeme("shorthand", b.text, a.text + b.text, parts=_counts(parts, a.value)), i + 2
    c = tokens[i + 2] if i + 2 < len(tokens) else None
    if (
        a.kind == "number"
        and b.text == "+"
        and b.glued
        and c is not None
        and c.kind == "number"
        and c.glued
        and c.value <= 3
    ):
        return Lexeme(
            "shorthand", "+", a.text + "+" + c.text, parts=(("bedroom", a.value), ("living_room", c.value))
        ), i + 3
    if a.text in _shorthand()["before"] and b.kind == "number" and b.glued and 1 <= b.value <= 9:
        return Lexeme(
            "shorthand", a.text, a.text + b.text, parts=_counts(_shorthand()["before"][a.text], b.value)
        ), i + 2
    return None


def _counts(parts: dict[str, str], n: float) -> tuple[tuple[str, float], ...]:
    value = {"n": n, "n-1": n - 1, "1": 1.0, "0": 0.0}
    return tuple((kind, value[count]) for kind, count in parts.items())
