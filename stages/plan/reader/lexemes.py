"""Tokens as lexemes: longest phrases of the lexicon, numbers, areas, shares and listings' shorthand."""

import tomllib
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

from stages.plan.reader.lexicon import Entry, Lexicon
from stages.plan.reader.spelling import correct, split
from stages.plan.reader.tokens import Token

SQUARE_METRES = {"m2": 1.0, "ft2": 0.09290304}
METRES = {"m": 1.0, "ft": 0.3048}
JOINTS = {"-": "-", "to": "-", "x": "x", "by": "x", "and": "and", ",": "and", "und": "and", "et": "and", "y": "and", "bis": "-"}
ABBREVIATED = ("sq", "approx", "ca", "incl", "no", "apt", "ft", "env")
"""A full stop after these ends no sentence."""


@dataclass(frozen=True)
class Lexeme:
    """A phrase with its readings. `joined` says that a hyphen ties it to the lexeme before.

    Beyond the lexicon's kinds: `mark`, `unknown`, `area` (m² in `values`), `share`, `shorthand`.
    """

    kind: str
    value: str
    text: str
    plural: bool = False
    joined: bool = False
    glued: bool = False
    values: tuple[float, ...] = ()
    others: tuple[Entry, ...] = ()
    parts: tuple[tuple[str, float], ...] = field(default=())

    @property
    def number(self) -> float:
        """The value of a number lexeme."""
        return self.values[0]

    def reading(self, kind: str) -> Entry | None:
        """Another reading of the same phrase."""
        return next((e for e in self.others if e.kind == kind), None)


@cache
def _shorthand() -> dict[str, dict[str, dict[str, str]]]:
    return tomllib.loads((Path(__file__).parent / "shorthand.toml").read_text())


def lexemes(tokens: list[Token], lexicon: Lexicon) -> list[Lexeme]:
    """All lexemes of a prompt in order, `mark` "." between sentences."""
    return _quantities(_words(_split_words(tokens, lexicon), lexicon))


def _split_words(tokens: list[Token], lexicon: Lexicon) -> list[Token]:
    out: list[Token] = []
    for token in tokens:
        parts = split(token.text, lexicon) if token.kind == "word" and (token.text,) not in lexicon.entries and correct(token.text, lexicon) == token.text else None
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
    if found:
        return found
    if first.kind == "word":
        fixed = {j: correct(tokens[j].text, lexicon) for j in range(i, min(i + 3, len(tokens))) if tokens[j].kind == "word"}
        found = _longest(tokens, i, lexicon, fixed) if fixed[i] != first.text else None
        return found or (_compound(first, lexicon), i + 1)
    if first.text == "." and i and tokens[i - 1].text in ABBREVIATED and i + 1 < len(tokens):
        return Lexeme("stop", "", "."), i + 1
    return Lexeme("mark", "." if first.text in "\n;!?." else first.text, first.text, glued=first.glued), i + 1


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
            best = Lexeme(head.kind, head.value, text, head.plural, values=values, others=entries[1:], glued=tokens[i].glued), j
    return best


def _short(tokens: list[Token], i: int) -> tuple[Lexeme, int] | None:
    """`2bhk`, `2 BR`, `t3`; "3b2b" is read as three bedrooms and two bathrooms."""
    if i + 1 >= len(tokens):
        return None
    a, b = tokens[i], tokens[i + 1]
    if a.kind == "number" and b.text == "-" and i + 2 < len(tokens) and tokens[i + 2].glued and tokens[i + 2].text in ("bhk", "br", "ba"):
        b, i = tokens[i + 2], i + 1
    if a.kind == "number" and b.text in _shorthand()["after"] and (b.glued and a.value <= 9 or len(b.text) > 1) and a.value <= 99:
        bath = b.text == "b" and i > 0 and tokens[i - 1].text in ("b", "/") and a.glued
        parts = {"bathroom": "n"} if bath else _shorthand()["after"][b.text]
        return Lexeme("shorthand", b.text, a.text + b.text, parts=_counts(parts, a.value)), i + 2
    c = tokens[i + 2] if i + 2 < len(tokens) else None
    if a.kind == "number" and b.text == "+" and b.glued and c is not None and c.kind == "number" and c.glued and c.value <= 3:
        return Lexeme("shorthand", "+", a.text + "+" + c.text, parts=(("bedroom", a.value), ("living_room", c.value))), i + 3
    if a.text in _shorthand()["before"] and b.kind == "number" and b.glued and 1 <= b.value <= 9:
        return Lexeme("shorthand", a.text, a.text + b.text, parts=_counts(_shorthand()["before"][a.text], b.value)), i + 2
    return None


def _counts(parts: dict[str, str], n: float) -> tuple[tuple[str, float], ...]:
    value = {"n": n, "n-1": n - 1, "1": 1.0}
    return tuple((kind, value[count]) for kind, count in parts.items())


def _quantities(words: list[Lexeme]) -> list[Lexeme]:
    """Merge compound numbers, then numbers with their units into areas and shares."""
    return _listing(_areas(_shares(_numbers(words))))


def _numbers(words: list[Lexeme]) -> list[Lexeme]:
    """`twenty five` → 25, `eight hundred` → 800."""
    out: list[Lexeme] = []
    for k, word in enumerate(words):
        last = out[-1] if out else None
        hundred = last is not None and last.kind == "number" and last.number >= 100 and last.number % 100 == 0
        either = last is not None and last.kind == "number" and word.text == "or" and k + 1 < len(words) and words[k + 1].kind == "number"
        if either or (out and k and words[k - 1].text == "or" and last is not None and last.kind == word.kind == "number"):
            continue  # "two or three bedrooms": two
        if hundred and word.text == "and" and k + 1 < len(words) and words[k + 1].kind == "number" and words[k + 1].number < 100:
            continue
        if last and word.kind == last.kind == "number" and not word.text[0].isdigit():
            n, m = last.number, word.number
            total = n * m if m in (100, 1000) else n + m if (n >= 20 and n % 10 == 0 and m < 10) or (n >= 100 > m) else None
            if total is not None:
                out[-1] = replace(last, value=str(total), text=f"{last.text} {word.text}", values=(total,))
                continue
        out.append(word)
    return out


def _shares(words: list[Lexeme]) -> list[Lexeme]:
    """`half of the floor area`, `40 %`."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        word = words[i]
        percent = i + 1 < len(words) and (words[i + 1].text == "%" or words[i + 1].value == "percent")
        if word.kind == "number" and percent:
            value, end = word.number / 100, i + 2
        elif word.kind == "fraction" or (word.text == "half" and _of_area(words, i + 1) > i + 1):
            value, end = word.number if word.values else 0.5, i + 1
        else:
            out.append(word)
            i += 1
            continue
        after = _of_area(words, end)
        if after > end or percent:
            out.append(Lexeme("share", str(value), word.text, values=(value,)))
            end = after
        else:
            out.append(word)
        i = end
    return out


def _of_area(words: list[Lexeme], i: int) -> int:
    """Where `of the [total] [floor] area` or `of the flat` ends; i when it does not stand here."""
    j = i
    while j < len(words) and (words[j].text in ("of", "the", "its", "de", "la", "der", "del") or words[j].kind == "determiner"):
        j += 1
    ends = j
    while ends < len(words) and words[ends].kind in ("area_word", "dwelling"):
        ends += 1
    return ends if ends > j else i


def _areas(words: list[Lexeme]) -> list[Lexeme]:
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        area, end = _area(words, i)
        out.append(area or words[i])
        i = end if area else i + 1
    return _area_lists(out)


def _area_lists(words: list[Lexeme]) -> list[Lexeme]:
    """`12 m² and 14 m²` as one, unless the second belongs to a room of its own; `between 8 and 10 m²` as 9."""
    out: list[Lexeme] = []
    for i, word in enumerate(words):
        last = out[-2] if len(out) > 1 else None
        own = i + 1 < len(words) and words[i + 1].kind in ("room", "size", "label") and not words[i + 1].plural
        if word.kind == "area" and last is not None and last.kind == "area" and out[-1].text in ("and", ",", "und", "et", "y") and not own:
            out[-2:] = [replace(last, values=last.values + word.values)]
        elif word.kind == "area" and len(word.values) == 2 and out and out[-1].text == "between":
            out[-1] = replace(word, values=(sum(word.values) / 2,))
        else:
            out.append(word)
    return out


def _listing(words: list[Lexeme]) -> list[Lexeme]:
    """`Bedrooms: 3` and `bedrooms (3)` are counts, `kitchen (10)` is an area."""
    out = list(words)
    for i in range(len(out) - 2):
        room, mark, number = out[i : i + 3]
        closed = i + 3 >= len(out) or out[i + 3].kind in ("mark", "conjunction")
        if room.kind != "room" or mark.text not in ("(", ":", "-", "=") or number.kind != "number" or not closed:
            continue
        if room.plural or (number.number <= 3 and number.number % 1 == 0):
            out[i : i + 3] = [number, room, replace(mark, kind="stop", value="", text=",")]
        elif number.number >= 2:
            out[i + 2] = Lexeme("area", "", number.text, values=(number.number,))
    return out


def _area(words: list[Lexeme], i: int) -> tuple[Lexeme | None, int]:
    """`12 m²`, `10-12 m²`, `12 and 14 m²`, `3 x 4 m`, `3m x 4m`, `10 by 12 ft`."""
    numbers, joints, j = _numbers_joined(words, i)
    unit = words[j].value if numbers and j < len(words) and words[j].kind == "unit" else ""
    if "x" in joints and len(numbers) == 2 and unit not in SQUARE_METRES:
        end = j + 1 if unit in METRES else j
        return _made([numbers[0] * numbers[1] * METRES.get(unit, 1.0) ** 2], words, i, end), end
    if unit not in SQUARE_METRES:
        return None, i
    values = [sum(numbers) / 2] if joints == ["-"] else numbers
    return _made([v * SQUARE_METRES[unit] for v in values], words, i, j + 1), j + 1


def _numbers_joined(words: list[Lexeme], i: int) -> tuple[list[float], list[str], int]:
    """Numbers from `i` on, what stands between them, and where they end."""
    numbers: list[float] = []
    joints: list[str] = []
    j = i
    while j < len(words) and words[j].kind == "number":
        numbers.append(words[j].number)
        j += 1
        k = j + 1 if j + 1 < len(words) and words[j].value in METRES and words[j + 1].text in ("x", "by") else j
        if k < len(words) and words[k].kind == "number" and words[k].joined:
            joints.append("-")
            j = k
        elif k + 1 < len(words) and words[k + 1].kind == "number" and words[k].text in JOINTS:
            joints.append(JOINTS[words[k].text])
            j = k + 1
        else:
            break
    return numbers, joints, j


def _made(values: list[float], words: list[Lexeme], i: int, j: int) -> Lexeme:
    return Lexeme("area", "", " ".join(w.text for w in words[i:j]), values=tuple(values), joined=words[i].joined)
