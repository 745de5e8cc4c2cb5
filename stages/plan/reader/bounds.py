"""Areas with limits: `at least 12 m²`, `no larger than 20 m²`, `between 50 and 55 m²`."""

from dataclasses import replace

from apartgen.stages.plan.reader.at_least import RATIOS, at_ratio
from apartgen.stages.plan.reader.lexeme import Lexeme

AND = ("and", "but", ",", "und", "et", "y", "mais", "aber")
BETWEEN = ("area_word", "stop")
"""What may stand between a limit and its area: `minimum area of 12 m²`."""

BEHIND = ("or ", "and ", "min", "max", "upwards", "at most", "at least", "at the most", "at the least")
"""How limits begin that stand behind their area: `12 m² or more`, `60 m² at most`."""

THAN = ("than", " als", " que", " 于")
"""How limits end that another room may follow: `no larger than`, `nicht größer als`."""


def bounded(words: list[Lexeme]) -> list[Lexeme]:
    """Limits joined to the areas that they are said of; `no larger than the bedroom` compares, others are unread."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        word = _read_as_bound(words, i)
        j = _area_after(words, i + 1) if word.kind == "bound" else i
        if word.kind != "bound":
            out.append(word)
        elif j > i:
            out += [w for w in words[i + 1 : j] if w.value == "total"]
            out.append(_limited(words[j], word.value))
            out = _joined(out)
            i = j
        elif out and out[-1].kind == "area" and word.text.startswith(BEHIND) and not _number_after(words, i):
            out[-1] = _limited(out[-1], word.value)
        elif _room_after(words, i + 1) and word.text.endswith(THAN):
            out.append(at_ratio(word, RATIOS[word.value]))
        else:
            out.append(replace(word, kind="stop", value="word"))
        i += 1
    return out


def _joined(out: list[Lexeme]) -> list[Lexeme]:
    """`at least 8 m² and at most 10 m²` as limits of one area."""
    first, joint, last = ([None] * 3 + out)[-3:]
    if first is None or joint is None or last is None or joint.text not in AND or len(first.bounds) != 1:
        return out
    if first.bounds[0][0] == last.bounds[0][0]:
        return out
    middle = (first.values[0] + last.values[0]) / 2
    return [*out[:-3], replace(first, values=(middle,), bounds=first.bounds + last.bounds)]


def _limited(area: Lexeme, kind: str) -> Lexeme:
    return replace(area, bounds=tuple((kind, value) for value in area.values[:1]))


def _read_as_bound(words: list[Lexeme], i: int) -> Lexeme:
    """`below 60 m²`, though `below` is also a place."""
    other = words[i].reading("bound")
    follows = i + 1 < len(words) and words[i + 1].kind in ("area", "number")
    return replace(words[i], kind="bound", value=other.value) if other is not None and follows else words[i]


def _area_after(words: list[Lexeme], j: int) -> int:
    """Where the area stands that a limit before `j` is said of, `j - 1` where there is none."""
    k = j
    while k < len(words) and k < j + 4 and words[k].kind in BETWEEN and words[k].value != "word":
        k += 1
    return k if k < len(words) and words[k].kind == "area" else j - 1


def _number_after(words: list[Lexeme], i: int) -> bool:
    """Whether the limit at `i` is of a number behind it: `12 m², at least 3 m wide`."""
    return words[i].text.startswith("at ") and i + 1 < len(words) and words[i + 1].kind == "number"


def _room_after(words: list[Lexeme], j: int) -> bool:
    return any(w.kind == "room" for w in words[j : j + 3])
