"""Limits of lengths, widths and doors: `no longer than 4 m`, `at least 1.4 m wide`, `three doors or fewer`."""

from apartgen.stages.plan.reader.dimensions import METRES
from apartgen.stages.plan.reader.lexeme import Lexeme

MORE = {"longer": "length", "langer": "length", "wider": "width", "broader": "width", "breiter": "width",
        "deeper": "width"}  # fmt: skip
LESS = {"shorter": "length", "kurzer": "length", "narrower": "width", "schmaler": "width"}
THAN = ("than", "als", "que")
SPANS = dict.fromkeys("long length lang lange longueur largo longitud 长 长度".split(), "length") | dict.fromkeys(
    "wide broad deep width breit breite large largeur ancho anchura 宽 宽度".split(), "width"
)
"""Words of extent behind or before a number with its unit."""
LINKS = ("of", "in", "de", "be", "a", "von")
FLIPPED = {"at_least": "at_most", "at_most": "at_least"}
SHUT = ("or", "oder", "ou", "o", "maximum", "minimum", "max", "min", "at", "hochstens", "mindestens")
"""First words of a limit behind its number: `four doors or fewer`, `4 m maximum`."""
DEEPEST = 40.0
"""Metres beyond which a length is none of a room."""


def extents(words: list[Lexeme]) -> list[Lexeme]:
    """Limits with what they limit joined to one lexeme of kind `limit`: `at_most:length` and metres or a number."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        found, i = _limit(words, i, out)
        out += found
    return out


def _limit(words: list[Lexeme], i: int, out: list[Lexeme]) -> tuple[list[Lexeme], int]:
    """The lexemes that stand for those from `i` on, and where reading goes on; takes from `out` what belongs to it."""
    sense, span, j = _sense(words, i)
    if not sense and words[i].kind != "number":
        return [words[i]], i + 1
    value, there, end = _measured(words, j)
    behind = "" if sense or not there and value is None else _behind(words, end)
    if not (sense or behind) and there == "width" and not (end < len(words) and words[end].kind == "room"):
        sense = "at_least"  # "the living room is 5 m wide"
    if value is None or not (sense or behind):
        return [words[i]], i + 1
    before = _named_before(out) if not (span or there) else 0
    span = span or there or (SPANS[out[-before].text] if before else _of_room(out))
    if value > DEEPEST:
        return [words[i]], i + 1
    if before:
        del out[-before:]
    denied = out[-back:] if sense and (back := _denied(out)) else []
    if denied:
        del out[-len(denied) :]
        sense = FLIPPED[sense]
    end += bool(behind)
    text = " ".join(w.text for w in (*denied, *words[i:end]))
    return [Lexeme("limit", f"{sense or behind}:{span}", text, values=(value,))], end


def _sense(words: list[Lexeme], i: int) -> tuple[str, str, int]:
    """Which way a limit at `i` goes, of what, and where its number is to stand; "" where there is none."""
    bound = words[i].reading("bound") or words[i]
    if bound.kind == "bound":
        return bound.value, "", _past(words, i + 1)
    first, *rest = words[i].text.split() or [""]
    j = i + 1
    if words[i].text in ("plus", "mas") and [w.text for w in words[j : j + 2]][1:] == ["que"]:
        span = SPANS.get(words[j].text, "")  # "plus large que"
        return ("at_least", span, j + 2) if span else ("", "", i)
    if not rest and j < len(words) and words[j].text in THAN:
        rest, j = [words[j].text], j + 1
    if rest[-1:] and rest[-1] in THAN and first in MORE:
        return "at_least", MORE[first], j
    if rest[-1:] and rest[-1] in THAN and first in LESS:
        return "at_most", LESS[first], j
    return "", "", i


def _measured(words: list[Lexeme], j: int) -> tuple[float | None, str, int]:
    """Metres or a number of doors at `j`, what is measured if that is said, and where it ends."""
    if j + 1 >= len(words) or words[j].kind != "number":
        return None, "", j
    if words[j + 1].text in ("doors", "door", "turen", "portes", "puertas"):
        return words[j].number, "doors", j + 2
    if words[j + 1].value not in ("m", "ft", "cm"):
        return None, "", j
    metres, k = words[j].number * METRES[words[j + 1].value], j + 2
    ahead = _past(words, k)
    if ahead < len(words) and words[ahead].text in SPANS:
        return metres, SPANS[words[ahead].text], ahead + 1
    return metres, "", k


def _behind(words: list[Lexeme], k: int) -> str:
    """The way of a limit that stands behind its number: `or fewer`, `maximum`."""
    bound = (words[k].reading("bound") or words[k]) if k < len(words) else None
    closes = bound is not None and bound.kind == "bound" and words[k].text.split()[0] in SHUT
    return bound.value if bound is not None and closes else ""


def _named_before(out: list[Lexeme]) -> int:
    """How many lexemes back `a width of` stands, 0 where it does not."""
    back = 1
    while back < min(len(out), 4) and out[-back].text not in SPANS and out[-back].kind in ("stop", "determiner"):
        back += 1
    return back if back <= len(out) and out[-back].text in SPANS else 0


def _of_room(out: list[Lexeme]) -> str:
    """What is measured of `a wide hall of at least 1.5 m`."""
    named = [w for w in out[-4:] if w.kind not in ("stop", "mark")][-2:]
    return SPANS.get(named[0].text, "") if len(named) > 1 and named[1].kind == "room" else ""


def _denied(out: list[Lexeme]) -> int:
    """How many lexemes back the `not` of `must not be longer than` stands, 0 where it does not."""
    back = 1
    while back < min(len(out), 3) and out[-back].kind == "stop":
        back += 1
    denied = back <= len(out) and out[-back].kind == "negation" and out[-back].value in ("no", "not", "without")
    return back if denied else 0


def _past(words: list[Lexeme], j: int) -> int:
    while j < len(words) and words[j].text in LINKS:
        j += 1
    return j

