"""What programs, engineers and Chinese numerals write, put into the words that the lexicon knows."""

import re

from apartgen.stages.plan.reader.excluded import excluded
from apartgen.stages.plan.reader.lettered import numbered

CODES = {"k": "kitchen", "kt": "kitchen", "lr": "living room", "dr": "dining room", "br": "bedroom", "bd": "bedroom",
         "ba": "bathroom", "bth": "bathroom"}  # fmt: skip
"""Abbreviations of rooms that are read as such only where a text has two of them."""
DIGITS = {sign: n for n, sign in enumerate("一二三四五六七八九", 1)} | {"两": 2, "兩": 2}

_TYPED = re.compile(r'\(\s*"?(?:type|room|kind|name)"?\s*:\s*"?([a-z ]+?)s?"?\s*[,.]\s*"?(?:count|'
    r'number)"?\s*:\s*(\d)\s*\)')
_TYPED_TO = re.compile(
    r'\(\s*"?(?:type|room|kind|name)"?\s*:\s*"?([a-z ]+?)"?\s*[,.]\s*"?(open|next|adjacent|connected) '
    r'to"?\s*:\s*"?([a-z ]+?)"?\s*\)'
)
_ITEM = re.compile(
    r'"?\b(?:type|room|kind|name)"?: ?"?([a-z ]+?)s?"?[\s,.]+"?(?:count|number|qty)"?: ?(\d)'
    r'(?:[\s,.]+"?(?:area|size)(?: m2| sqm)?"?: ?"?(\d+(?:\.\d+)?))?'
)
"""An item of a list in YAML: what room, how many, and of which area each."""
_DOTTED = re.compile(r"(?<=[a-z])\.(?=[a-z][a-z ]*\s*:)")
_OPEN_KEY = re.compile(r"\b(kitchen|living room|dining room) open\s*:\s*(?:true|yes|1)\b")
_TRUTH = re.compile(r"(?<=:)(\s*)(true|false)\b")
_KEY = re.compile(r'\b((?:total )?(?:floor )?area|size|surface)"?\s*:\s*"?(\d+(?:\.\d+)?)"?(?=\s*(?:[.,;)\n](?!\d)|$))')
_UNIT_KEY = re.compile(r'\b(?:total )?(sqm|m2|sqft|ft2)"?\s*:\s*"?(\d+(?:\.\d+)?)"?(?=\s*(?:[.,;)\n](?!\d)|$))')
_KEYED = re.compile(r'\b(area|size) ?\(?(m2|sqm|sq m|sqft|sq ft|ft2)\)?"?\s*:\s*(\d+(?:\.\d+)?)')
_KEYED_ROOM = re.compile(
    r'(?:(?<=["(.,;:\n] )|(?<=["(.,;:\n])|^)(bed ?room|bath ?room|study|balcony|kitchen)s? (?:area|size)"?: '
    r"(\d+(?:\.\d+)?) (m2|sqm|sq m|sqft|sq ft|ft2)\b"
)
"""Areas of rooms of which there is a count elsewhere."""
_WHOSE = re.compile(r"\b(kitchen|(?:living|dining|bath|bed) ?room|hall(?:way)?|corridor|study|balcony|lounge|flat)'s\b")
_SIZED = re.compile(r"\b((?:bed|bath)room) (\d) ?\((\d+(?:\.\d+)?)\)")
_ADDED = re.compile(r"\b(bed|bedroom|br|bath|bathroom)s? (\d+(?:\.\d+)?) ?\+ ?(\d+(?:\.\d+)?)")
_VALUE = re.compile(r"(?<=[a-z])\"?: ?\"?(?=(?:open to|off|next to|near|opposite|with|at(?! (?:most|least))|on|in|"
    r"beside|adjacent to)\b)")
_FACES = re.compile(r"^(?:facing|orientation|aspect|face)$")
_RELATED = re.compile(
    r'"?\b((?:open|next|adjacent|connected) to|opposite|near|accessed from|facing|orientation|faces?|aspect)"?\s*:\s*'
    r'"?([a-z][a-z \d]*)"?\s*(?:[.,;]\s*|$)'
)
_OBJECT = re.compile(r'"?([a-z][a-z ]*?(?: \d)?)"?\s*:\s*[({]([^(){}]*)[)}]')
_TAG = re.compile(r"</?\w+([^<>]*?)/?->")
_NAMED = re.compile(
    r'"?\b(?:name|type|room|kind|id)"?\s*:\s*"?([a-z][a-z ]*?)(?: ?\d+)?"?[\s.,;]*'
    r'"?(?:area|size)(?: ?(?:m2|sqm))?"?\s*:\s*"?(\d+(?:\.\d+)?)'
)
_COMBINED = re.compile(r"(?<![\w/])([kld])([/+])([kld])(?:\2([kld]))?(?![\w/])")
_TIMES = re.compile(
    r"\b(bedroom|bathroom|bed|bath|br|ba|wc|balcony|closet|storage|study)s? ?x ?(\d)\b(?! ?[xm.]\d)(?!\.\d)"
)
_THINGS = re.compile(
    r"(^|[-;,.:(\n]\s*|\b(?:and|with|plus|has|have) )"
    r"(?!(?:bedroom|bathroom|bed|bath|br|ba|wc|balcony|closet|storage|study)s? ?x)"
    r"(?:an? |the )?([a-z]+(?:[ -][a-z]+){0,2}(?: (?=x)|(?=x\d)))x ?(\d)\b"
    r"(?!,\d)(?! ?[xm.]\d| ?(?:x|m|m2|cm|sqm|by|ft)\b)"
)
"""`desk x2`: how many of a thing there are, 0 for none."""
_NONE = re.compile(r"\bno\s*:")
_OPEN_PLAN = re.compile(r"\bopen (?:plan|concept|space)\"?\s*:\s*yes\b(?:\s*\(([^)]*)\))?")
_LETTERS = re.compile(r"[+,&] ?k ?[+,&] ?b\b")
_SHORT = {"k": "kitchen", "l": "living room", "d": "dining room"}
_LEADS = r"(?:\bin|(?<![a-z] )\bfor|(?<=and )for)"
"""Before `each` where a clause begins; `a bedroom for each` is none."""
_IN_EACH = re.compile(
    rf"{_LEADS} each (?:one )?(?:(?:of them|of these|of those) ?)?,? ?(?:there is |is )?(?:an? |its )|"
    r"\bin jedem (?:davon )?(?:ein )|\bdans chacune? (?:d'elles )?(?:une? )|\ben cada uno (?:de ellos )?(?:una? )"
)
_EACH_OF = re.compile(
    rf"{_LEADS} each (?:one )?(?:of (?:them|these|those))?,? ?(?:there are |are )?(?=(?:\d|two|three|four|several) )"
)
_BY_COUNT = re.compile(r"\b((?:bed|bath)?rooms):? (\d) ?x ?(\d+(?:\.\d+)?) ?(m2|sqm)\b")
_COUNT = re.compile(r'\b(\w+) (?:count|number|qty)"?\s*:(?=\s*"?\d)')
_UNITS = r"m2|m\^2|sqm|sq m|sqft|ft2"
_TOLERANCE = re.compile(rf"(\d+(?:\.\d+)?)\s*({_UNITS})?\s*(?:\+/-|\+-|±)\s*(\d+(?:\.\d+)?)\s*(?:{_UNITS})?")
_CODE = re.compile(rf"\b({'|'.join(CODES)})(\d?)\b(?!['-])")
_CODED = re.compile(rf"\b(?:(?:{'|'.join(CODES)})\d?|mbr|\d ?(?:br|ba|bd|b)|[kld](?:[/+][kld])+)\b")
_TENS = re.compile(r"(?:([一二三四五六七八九两兩])百)?零?(?:([一二三四五六七八九]?)十)?([一二三四五六七八九]?)")


_COMPASS = re.compile(r"(?<=[a-z0-9)])[ :]\s?(N|S|E|W|NE|NW|SE|SW)(?=\s*(?:[,;.\n)]|$))")
_SIDES = {"N": "north", "S": "south", "E": "east", "W": "west", "NE": "north east", "NW": "north west",
          "SE": "south east", "SW": "south west"}  # fmt: skip


def sided(text: str) -> str:
    """A text as written with `bedrooms N` as `bedrooms north`; later a capital is not told from others."""
    return re.sub(r"\bentry (?=(?:north|south|east|west)\b)", "entrance ", _COMPASS.sub(_side, text))


def _side(found: re.Match[str]) -> str:
    return f" {_SIDES[found[1]]}"


def worded(text: str) -> str:
    """A folded text with truth values as yes and no, areas behind their units, codes and numerals written out."""
    text = numbered(text)
    coded = len({found.group() for found in _CODED.finditer(text)}) > 1
    text = re.sub(r'\b(kitchen)"?\s*:\s*\(\s*"?open"?\s*:\s*"?(?:true|yes)"?\s*\)', r"open \1", text)
    text = excluded(text)
    text = _ITEM.sub(lambda found: f"{found[2]} {found[1]}s{f' of {found[3]} m2 each' if found[3] else ''}", text)
    text = _TYPED.sub(r"\2 \1s, ", text)
    text = _TYPED_TO.sub(r"\1 \2 to \3, ", text)
    text = _OPEN_KEY.sub(r"open \1", _DOTTED.sub(" ", text))
    text = _WHOSE.sub(r"\1", _TAG.sub(r"\1 ;", text))
    text = re.sub(r" / ", " ; ", text) if text.count(" / ") > 1 else text
    text = _OBJECT.sub(_with_relations, text)
    text = re.sub(r"\(n ?: ?(\d)\)", r"(\1)", _VALUE.sub(" ", text))
    text = re.sub(r"(?<!\d)\bldk\b", "kitchen/dining room/living room", text)
    text = _ADDED.sub(lambda found: f"{'' if 'room' in found[1] else '2 '}{found[1]}s ({found[2]}, {found[3]})", text)
    text = _TRUTH.sub(lambda found: f"{found[1]}{'yes' if found[2] == 'true' else 'none'}", text)
    text = _COMBINED.sub(lambda found: "/".join(_SHORT[c] for c in found.group(1, 3, 4) if c), text)
    text = _decoded(_LETTERS.sub("+ kitchen + bathroom", text)) if coded else _LETTERS.sub("+ kitchen + bathroom", text)
    text = re.sub(r"\bopen kitchen\"?\s*:\s*\"?(?:no|none)\b", "separate kitchen", text)
    text = _NAMED.sub(r"\1: \2 m2", text)
    text = _OPEN_PLAN.sub(lambda found: f"open plan {found[1] or 'kitchen and living room'}", text)
    text = _SIZED.sub(r"\1 \2: \3 m2", text)
    text = _THINGS.sub(_so_many, text)
    text = _TIMES.sub(r"\2 \1s", _NONE.sub("no", text))
    text = re.sub(r"\b(bed|bath)(?:room)? count:? (\d)\b", r"\2 \1s", re.sub(r"\b(sqm|m2) (\d{2,3})$", r"\2 \1", text))
    text = _COUNT.sub(r"\1s:", re.sub(r"\b(?:num|nb|nr) (?=[a-z]+s\b)", "", text))
    text = _KEYED.sub(r"\1: \3 \2", text)
    text = _UNIT_KEY.sub(r"area: \2 \1", _KEY.sub(r"\1: \2 m2", text))
    text = _KEYED_ROOM.sub(_counted_before, text)
    text = _EACH_OF.sub("each with ", _IN_EACH.sub("each with a ", text))
    text = _BY_COUNT.sub(_counted, text)
    text = _TOLERANCE.sub(_range, text)
    text = re.sub(r"\b1 of (?=which|them|these)", "one of ", text)
    return _TENS.sub(_numeral, text)


def _so_many(found: re.Match[str]) -> str:
    """`desk x2` as `2 desk`; `we want bathroom x2` counts rooms."""
    begin, thing, number = found.groups()
    rooms = thing.split()[-1] in ("bedroom", "bathroom", "balcony", "closet", "study")
    return found.group() if rooms else f"{begin}{'no' if number == '0' else number} {thing}"


def _with_relations(found: re.Match[str]) -> str:
    """`kitchen: {area: 12, open to: living room}` with its relations behind, each with the room it is said of."""
    room, said = found.groups()
    relations = [f"{room} {_FACES.sub('faces', words)} {other}" for words, other in _RELATED.findall(said)]
    rest = _RELATED.sub("", said).strip(" .,;")
    kept = [f"{room}: ({rest})"] if rest else []
    return ". ".join([*kept, *relations]) if relations else found.group()


def _counted_before(found: re.Match[str]) -> str:
    """`bedroom area: 14 m2` beside `bedrooms: 1` as said of that bedroom, beside `bedrooms: 2` as said of each."""
    room, area, unit = found.groups()
    told = re.search(rf'\b{room.rstrip("y")}(?:y|ies|s)?"?\s*:\s*"?(\d)"?(?=\s*(?:[.,;)\n](?!\d)|$))', found.string)
    if told is None:
        return found.group()
    return f"{'the' if told[1] == '1' else 'each'} {room}: {area} {unit}"


def _counted(found: re.Match[str]) -> str:
    """`bedrooms: 3 x 13 m2` as three of 13 m² each, where such lengths and widths would make no bedroom."""
    a, b = float(found[2]), float(found[3])
    return found.group() if a * b < 30 and b < 3 * a else f"{found[2]} {found[1]} of {found[3]} {found[4]} each"


def _range(found: re.Match[str]) -> str:
    """`95 m2 +/- 5` as both limits."""
    middle, off = float(found[1]), float(found[3])
    return f"between {middle - off:g} and {middle + off:g} {found[2] or ''}"


def _decoded(text: str) -> str:
    """`K open to LR`: one letter is a room among other codes only."""
    text = re.sub(r"\b([ld]) (?=\d)", lambda found: f"{_SHORT[found[1]]} ", text)
    return _CODE.sub(lambda found: CODES[found[1]] + (f" {found[2]}" if found[2] else ""), text)


def _numeral(found: re.Match[str]) -> str:
    """八十 as 80; signs without tens or hundreds stay as they are."""
    whole, (hundreds, _, ones) = found.group(), found.groups()
    if "十" not in whole and "百" not in whole:
        return whole
    tens = DIGITS.get(found[2] or "", 1) if "十" in whole else 0
    return str(100 * DIGITS.get(hundreds or "", 0) + 10 * tens + DIGITS.get(ones or "", 0))
