"""Limits and places as programs note them: `min_area(kitchen)=9`, `area in [12, 15] m²`, `Front: kitchen, bath`."""

import re

from apartgen.stages.plan.reader.pieces import KIND, ROOM, UNIT, reworded, rules

_SQUARE, _LONG = ("area", "size", "floor area", "surface"), ("width", "length")
_AT = {"front": "at the front", "back": "at the back", "rear": "at the back", "left": "on the left",
       "right": "on the right"} | dict.fromkeys(("middle", "centre", "center"), "in the middle")  # fmt: skip
_ONE = rf"(?:(?:the|a|an|both|two|three|all|1|2|3) )?(?:{KIND})(?: \d)?"


def _limit(found: re.Match[str]) -> str:
    """`min area(kitchen): 9`, `min kitchen area 9 m2` as `kitchen at least 9 m2`."""
    words = found["limit"].replace(".", "")
    limit = "at least" if words.startswith(("min", "least", "at least")) else "at most"
    unit = (found["unit"] or "").strip() or ("m2" if found["what"] in _SQUARE else "m")
    side = {"width": " wide", "length": " long"}.get(found["what"], "")
    return f"{found['of']} {limit} {found['n']} {unit}{side}"


def _there(found: re.Match[str]) -> str:
    """`front: living room and kitchen` as where they are."""
    where = _AT.get(found["side"], f"in the {found['side']}")
    rooms = re.sub(r",(?: and)? ", " and ", found["rooms"])
    return f"{found['begin']}{rooms} {'are' if re.search(' and |s$', rooms) else 'is'} {where}"


_OWN = {
    "of": rf"(?P<of>(?:{ROOM})(?: \d)?)",
    "limit": r"(?P<limit>min(?:imum|imal)?\.?|max(?:imum|imal)?\.?|at least|at most)",
    "what": r"(?:(?:clear|free|net|usable|inner|inside|overall|floor) )?(?P<what>area|size|surface|width|length)",
    "n": rf"(?P<n>\d+(?:\.\d+)?)(?P<unit> ?(?:{UNIT}|met(?:er|re)s?|m|cm|ft)\b)?",
    "is": r" ?(?:[:=]|is|of|should be|must be)? ?",
    "one": _ONE,
    "bound": r"(?:at least|at most|(?:no|not) (?:more|less|wider|narrower|longer|shorter|larger|smaller|bigger) than)",
    "square": r"(?:m2|qm|quadratmetern?|metres? carres?|metros? cuadrados?)",
    "begin": r"(?P<begin>^|[.;\n] ?|[-*] )",
    "end": r"(?= ?(?:[.;\n]|$))",
}
_SAID = rules((
    # "min_area(kitchen)=9", "min kitchen area: 9 m2", "hallway min clear width 1.25 m", "kitchen area >= 9"
    (r"\b{limit}[ -]?{what} ?\( ?{of} ?\){is}{n}", _limit),
    (r"\b{what} ?\( ?{of} ?\) ?{limit} ?{n}", _limit),
    (r"\b{limit}[ -]?{what} (?:of|for|in) (?:the )?{of}{is}{n}", _limit),
    (r"\b{limit} {of} {what}{is}{n}", _limit),
    (r"\b{of},? {limit}[ -]?{what}{is}{n}", _limit),
    (r"\b{of} {what} ?{limit}{is}{n}", _limit),
    # "corridor at least 1.5 m wide and no longer than 6 m"
    (r"\b{of},? (?P<first>{bound} {amount} ?(?:{unit}|met(?:er|re)s?|m|cm|ft|feet)(?: wide| long)?),? (?:and|but) "
     r"(?={bound} \d)", r"\g<of> \g<first>. the \g<of> is "),
    # "area in [12, 15] m2", "within 12-15 m2", "in the range 12 to 15 m2"
    (r"\b(?:in|within)(?: the)?(?: range| interval)?(?: of)? ?\((?P<low>{amount}) ?(?:,|-|to|;|and) ?"
     r"(?P<high>{amount})\) ?(?P<unit>{unit})", r"between \g<low> and \g<high> \g<unit>"),
    (r"\b(?:in|within) (?:the )?(?:range|interval|band)(?: of)? (?P<low>{amount}) ?(?:-|to|and) ?(?P<high>{amount}) ?"
     r"(?P<unit>{unit})", r"between \g<low> and \g<high> \g<unit>"),
    # "de 70 à 80 m2", "60 hasta 65 m2", "12 bis 14 qm"
    (r"(?:\b(?:de|von|desde|entre|zwischen) )?\b(?P<low>{amount})(?: ?{square})? (?:a|bis|hasta) (?P<high>{amount}) ?"
     r"(?={square}\b)", r"\g<low>-\g<high> "),
    # "Include: 2 bedrooms"
    (r"{begin}(?:include[ds]?|including|required|must have) ?: ?(?=\d|one|two|three|four)", r"\g<begin>"),
    # "Front: living room and kitchen. Back: both bedrooms."
    (r"{begin}(?P<side>front|back|rear|left|right|middle|cent(?:re|er)|(?:north|south)(?:[ -]?(?:east|west))?|east|"
     r"west)(?: (?:side|part|zone|wing|half|end))? ?: ?(?P<rooms>{one}(?:(?:, and |, | and ){one})*){end}", _there),
), **_OWN)  # fmt: skip


def as_constraints(text: str) -> str:
    """A folded text with such limits and places in words."""
    return reworded(text, _SAID)
