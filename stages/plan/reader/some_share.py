"""Children who are counted, of whom some share a room: `four children: two share, the other two have their own`."""

import re

from apartgen.stages.plan.reader.families import BEDROOMS, COUNTED
from apartgen.stages.plan.reader.kin import pattern, value_of

_YOUNG = (r"(?:children|kids|sons|daughters|boys|girls|teenagers|grandchildren|kinder[n]?|sohne|tochter|jungs|madchen|"
          r"enfants|filles|garcons|hij[oa]s|nin[oa]s|个?孩子|个?小孩)")  # fmt: skip
_OF_THEM = (r"(?:,? ?(?:of (?:them|whom|the (?:kids|children|boys|girls))|von (?:ihnen|denen)|d'entre (?:eux|elles)|"
            r"de (?:ell[oa]s|l[oa]s cuales)))")  # fmt: skip
_AND = r"(?: ?(?:[,;.:-]|,? (?:and|but|while|und|aber|et|mais|y|pero)\b)+ ?)"
_OTHERS = (r"(?:(?:the |die |der |das |les |los |las |l'|el |la )?(?:{numbers}|andere[nrs]?|autres?|otr[oa]s?|"
           r"remaining|others?|third|fourth|fifth|last|dritte|letzte|eldest|oldest|youngest|ones?|kids?|child|"
           r"children|beiden|un[oa]?|une?|mayor|menor|aine|个|另外?|其他|其余)[ ]?)+")  # fmt: skip
_OWN = (r"(?:(?:each|both|all|will|can|should|chacune?|cada un[oa]|jeweils|jede[rs]?|各自?)[ ]?)*(?:{need} ?)?"
        r"(?:(?:each|both|chacune?|cada un[oa]|jeweils|各) ?)?(?:{hers}|la leur|le leur|(?:ein(?:en?)? |ihr |sein "
        r")eigene[sn]?"
        r"|(?:one|a room|one room) each|{article}+{room}{each}?|{article}*own|alone|各?一间)")  # fmt: skip
_WITH_US = (r"(?:the |our |das |le |la |el )?(?:baby|youngest|newborn|toddler|little one|smallest|bebe|kleinste)(?: "
            r"one)?"
            r"(?: will| can)? (?:{with_us}|(?:sleeps?|stays?|is) in ours)")  # fmt: skip
_ALSO = r"(?:(?:also|too|auch|aussi|tambien|another) )*{share}(?: ?{article}*(?:{room}|other|another)(?: one)?)?"
_END = r"(?= ?(?:[.,;:)]|$)| (?:and|und|et|y|with|mit|avec|con) )"
_HAVE = (r"(?P<ours>\b(?:we have(?: got)?|we are (?:a|the) (?:family|couple) (?:with|of)|(?:the|a|our) (?:family|"
         r"couple) "
         r"(?:with|of)|wir (?:haben|sind eine familie mit)|(?:eine )?familie mit|nous (?:avons|sommes une famille "
         r"avec)|"
         r"(?:une )?famille avec|tenemos|(?:una )?familia con|(?:us|we|me|my (?:wife|husband|partner) and (?:me|i)|"
         r"me and my (?:wife|husband|partner))(?:,| and| with| &)|(?:our|my|unsere|nos|nuestr[oa]s)) (?:our "
         r")?)?")  # fmt: skip
_SOME = (
    rf"{_HAVE}(?P<all>{{numbers}}) ?(?:{{adjective}})*{_YOUNG}"
    r"(?P<said>(?! (?:and|with|und|et|y) )[^.:;,0-9]{0,25}?)"
    rf"(?: ?[.:;,-]+| and| of) ?(?:(?:and|und|et|y) )?(?:{{before}})?(?P<some>{{numbers}})个? ?{_OF_THEM}?"
    r"(?: ?(?:will|can|are to|should|must|sollen|doivent))? ?"
    rf"{{share}}(?: ?(?:{{article}}*{{room}}(?: teilen)?|一间))?{_END}"
    rf"(?:{_AND}(?:(?P<own>{_OTHERS}{_OWN})|(?P<also>{_OTHERS}{_ALSO}))(?: (?:haben|bekommen))?{_END})?"
    rf"(?:{_AND}(?P<baby>{_WITH_US}){_END})?"
)
_MEMBERS = (
    r"\b(?P<family>family of|familie mit|famille de|familia de) (?P<all>{numbers})(?P<said>[^.:;,]{0,25}?) ?[.:;,-]+ ?"
    rf"(?P<some>{{numbers}}) {_OF_THEM} ?(?:will |can )?{{share}}(?: ?{{article}}*{{room}})?{_END}"
    rf"(?:{_AND}{_OTHERS}{_OWN}{_END})?"
)


def some_share(text: str) -> str:
    """A folded text with as many children's rooms as they need, and one for their parents where none is told of."""
    if COUNTED.search(text) is not None:
        return text
    told, rest = text, text
    for said in (pattern(_SOME), pattern(_MEMBERS)):
        told, rest = said.sub(_rooms, told), said.sub("", rest)
    alone = told != text and not BEDROOMS.search(rest)
    return f"{told.rstrip(' .!')}. a parents' bedroom." if alone else told


def _rooms(found: re.Match[str]) -> str:
    """Those who share have one, the others one each, but for a baby that sleeps with its parents."""
    children = value_of(found["all"]) - (2 if found.groupdict().get("family") else 0)
    some = value_of(found["some"])
    if not 1 < some <= children:
        return found.group()
    rooms = 1 + children - some - bool(found.groupdict().get("baby"))
    rooms = 2 if found.groupdict().get("also") else rooms
    return (f"{rooms} kids rooms" if rooms > 1 else "a kids room") + found["said"]
