"""Amounts denied beside those that hold: `22 m², not 26`, `not 26 but 22 m²`, `26 m² → 22 m²`."""

from apartgen.stages.plan.reader.lexeme import Lexeme

DENYING = ("not", "without")
DENIALS = ("nicht", "pas", "no", "non")
"""Words that deny a number behind them."""
BUT = ("but", "but rather", "rather", "sondern", "sino", "mais")
ARROWS = ("->", "→", "=>", "⇒")
JOINING = (",", "(", "-", "and", "but")
"""What may stand between an amount and the one it is not."""
MEASURED = ("m2", "ft2", "m", "ft", "cm")


def that_hold(words: list[Lexeme]) -> list[Lexeme]:
    """Words without the amounts that they deny; one without a unit has that of the other."""
    out = list(words)
    k = 0
    while k < len(out):
        rest = _said_anew(out, k) or _not_but(out, k) or _not_that(out, k)
        out = rest if rest is not None else out
        k += rest is None
    return out


def _amount(words: list[Lexeme], k: int) -> tuple[int, Lexeme | None]:
    """Where the amount at `k` ends, and its unit; `k` where none stands there."""
    if k >= len(words) or words[k].kind != "number":
        return k, None
    unit = words[k + 1] if k + 1 < len(words) and words[k + 1].kind == "unit" else None
    unit = unit if unit is not None and unit.value in MEASURED else None
    return k + 1 + (unit is not None), unit


def _denial(words: list[Lexeme], k: int) -> bool:
    denies = words[k].kind == "negation" and words[k].value in DENYING
    return denies or words[k].text in DENIALS


def _said_anew(words: list[Lexeme], k: int) -> list[Lexeme] | None:
    """`26 m² → 22 m²`: the second."""
    end, unit = _amount(words, k)
    arrow = unit is not None and end < len(words) and words[end].text in ARROWS
    after, other = _amount(words, end + 1) if arrow else (end, None)
    if not arrow or after == end + 1 or unit is None:
        return None
    return [*words[:k], words[end + 1], other or unit, *words[after:]]


def _not_but(words: list[Lexeme], k: int) -> list[Lexeme] | None:
    """`not 26 but 22 m²`: the second."""
    end, unit = _amount(words, k + 1) if _denial(words, k) else (k, None)
    if end <= k + 1:
        return None
    at = end + (end < len(words) and words[end].text == ",")
    but = at < len(words) and words[at].text in BUT
    after, other = _amount(words, at + 1) if but else (at, None)
    told = other or unit
    if not but or after == at + 1 or told is None:
        return None
    return [*words[:k], words[at + 1], told, *words[after:]]


def _not_that(words: list[Lexeme], k: int) -> list[Lexeme] | None:
    """`22 m², not 26`, `22 rather than 26 m²`: the first."""
    end, unit = _amount(words, k + 1) if _denial(words, k) else (k, None)
    ends = end >= len(words) or words[end].kind in ("mark", "boundary", "dwelling")
    if end <= k + 1 or not (ends or unit is not None):
        return None  # "22 m², not three bedrooms"
    at = k
    while at and words[at - 1].text in JOINING:
        at -= 1
    noun = at > 1 and words[at - 1].kind in ("room", "dwelling")  # "a 22 m² lounge, not 26 m²"
    if noun and _amount(words, at - 3)[0] == at - 1:
        return [*words[:at], *words[end:]]
    before = at - 1 - (at > 0 and words[at - 1].kind == "unit")
    start, own = _amount(words, before) if before >= 0 else (at, None)
    told = own or unit
    if before < 0 or start != at or told is None or (own is not None and unit is not None and own.value != unit.value):
        return None
    opened = any(w.text == "(" for w in words[at:k])
    end += opened and end < len(words) and words[end].text == ")"
    return [*words[:before], words[before], told, *words[end:]]
