"""Lengths and widths: `3 x 4 m`, `10 by 12 ft`, `5 feet in width and 10 feet in length`."""

from statistics import median

from apartgen.stages.plan.reader.lexeme import Lexeme

METRES = {"m": 1.0, "ft": 0.3048, "cm": 0.01, "m2": 1.0, "ft2": 0.3048}
"""Metres of a unit; of a square one, its side."""
BY = ("x", "by", "*", "乘", "乘以", "mal", "auf", "sur", "por")
AND = ("and", ",", "und", "et", "y", "&", "times")
SPANS = frozenset(
    "long wide deep broad tall length width breadth depth height lenght widht lang breit tief lange breite".split()
)
"""Words for a room's extent in one direction."""
HOUSE = 40.0
"""Area that few rooms exceed in m² and most in square feet."""


def dimensions(words: list[Lexeme]) -> list[Lexeme]:
    """Pairs of lengths joined into areas with their two sides."""
    words = [w for w in words if (w.kind, w.text) != ("stop", ".")]  # "5 ft. by 6 ft."
    found: list[tuple[Lexeme | tuple[float, float], int, int, bool]] = []
    i = 0
    while i < len(words):
        pair = _pair(words, i)
        if pair is None:
            found.append((words[i], i, i + 1, True))
            i += 1
        else:
            a, b, unit, end = pair
            found.append(((a * METRES.get(unit, 1.0), b * METRES.get(unit, 1.0)), i, end, unit in METRES))
            i = end
    bare = [a[0] * a[1] for a, _, _, told in found if isinstance(a, tuple) and not told]
    scale = _usual_unit(words, bare)
    return [
        item if isinstance(item, Lexeme) else _area(item, 1.0 if told else scale, words[start:end])
        for item, start, end, told in found
    ]


def _usual_unit(words: list[Lexeme], bare: list[float]) -> float:
    """Metres of a length without a unit: the unit of the other lengths, else what makes rooms of a usual size."""
    units = [w.value for w in words if w.kind == "unit"]
    if any(unit in ("ft", "ft2") for unit in units):
        return METRES["ft"]
    large = not units and bool(bare) and median(bare) > HOUSE
    return METRES["ft"] if large else 1.0


def _area(sides: tuple[float, float], scale: float, words: list[Lexeme]) -> Lexeme:
    a, b = sides[0] * scale, sides[1] * scale
    text = " ".join(w.text for w in words)
    return Lexeme("area", "", text, values=(a * b,), sides=(a, b), joined=words[0].joined)


def _pair(words: list[Lexeme], i: int) -> tuple[float, float, str, int] | None:
    """Two lengths from `i` on, their unit, and where they end."""
    if words[i].kind != "number":
        return None
    first, unit, spanned, j = _length(words, i)
    joint = words[j].text if j < len(words) else ""
    k = j + 1 if joint in (*BY, *AND) else j
    if k >= len(words) or words[k].kind != "number" or (k == j and not spanned):
        return None
    second, other, spanned_too, end = _length(words, k)
    if joint not in BY and not (spanned and spanned_too):
        return None
    if unit and other and unit != other:
        first *= METRES[unit] / METRES[other]
    return first, second, other or unit, end


def _length(words: list[Lexeme], i: int) -> tuple[float, str, bool, int]:
    """The number at `i`, its unit, whether it says in which direction, and where that ends."""
    j = i + 1
    unit = words[j].value if j < len(words) and words[j].kind == "unit" and words[j].value in METRES else ""
    j += bool(unit)
    k = j + 1 if j + 1 < len(words) and words[j].text in ("in", "of") else j
    spanned = k < len(words) and words[k].text in SPANS
    return words[i].number, unit, spanned, k + 1 if spanned else j
