"""Counts that may be one of several: the least of `between two and four bedrooms`, `2-3 bathrooms`, `one or two`."""

from dataclasses import replace

from apartgen.stages.plan.reader.lexeme import Lexeme

BETWEEN = ("between", "somewhere between", "anywhere between", "from", "entre", "zwischen", "de", "von")
JOINTS = ("and", "to", "-", "or", "und", "bis", "oder", "et", "a", "ou", "y", "o", "到", "至")
"""What joins the least and the most; `and` and its like only behind `between`."""
AND = ("and", "und", "et", "y")
QUALIFIED = ("size", "label", "adjective", "determiner", "stop")
MOST = 12
"""More are no rooms of one home."""


def ranged(words: list[Lexeme]) -> list[Lexeme]:
    """Each range of a number of rooms as its least number, which is always meant too."""
    out: list[Lexeme] = []
    k = 0
    while k < len(words):
        end = _ends(words, k)
        if _ranges(words[k], words[k + 1 : end], out[-1:]) and _of_rooms(words, end):
            begins = bool(out) and out[-1].text in BETWEEN
            out[len(out) - begins :] = [replace(words[k], text=f"{words[k].text} {words[end - 1].text}")]
            k = end
        else:
            out.append(words[k])
            k += 1
    return out


def _ends(words: list[Lexeme], k: int) -> int:
    """Where `two to four`, `2-3` ends, should it stand at `k`."""
    hyphen = k + 1 < len(words) and words[k + 1].joined and words[k + 1].kind == "number"
    return k + 2 if hyphen else k + 3


def _ranges(least: Lexeme, after: list[Lexeme], before: list[Lexeme]) -> bool:
    """Whether a count and what stands behind it is a range that rooms may have."""
    most, joint = (after[-1], after[0].text if len(after) > 1 else "-") if after else (least, "")
    if (least.kind, most.kind) != ("number", "number") or joint not in JOINTS:
        return False
    opened = bool(before) and before[0].text in BETWEEN
    if (joint in AND and not opened) or (before and before[0].kind in ("room", "number", "ordinal")):
        return False
    return least.number.is_integer() and most.number.is_integer() and 0 < least.number < most.number <= MOST


def _of_rooms(words: list[Lexeme], k: int) -> bool:
    """Whether rooms stand at `k`, perhaps with what is said of them."""
    end = k
    while end < len(words) and end < k + 3 and words[end].kind in QUALIFIED:
        end += 1
    return end < len(words) and words[end].kind == "room"
