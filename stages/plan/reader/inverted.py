"""What is counted, limited or told of whom only behind what it is said of, in an order that the rules follow."""

import re
from collections.abc import Callable

from apartgen.stages.plan.reader.patterns import Late

_ROOM = (r"(?:(?:(?:main|master|guest|second|first|third|other|children's|kids|large|small|big) )*"
         r"(?:(?:living|sitting|dining|laundry|utility|storage|guest|shower|bed|bath) ?rooms?|kitchen|study|balcony|"
         r"lounge|toilet|office|pantry|closet))")  # fmt: skip
_HALL = r"(?:(?:central|long|wide|narrow|entrance|single|main) )*(?:hall(?:way)?|corridor|passage|landing)"
_NUMBER = r"(?:one|two|three|four|five|six|[1-9])"
_YOUNG = r"(?:kids|children|sons|daughters|boys|girls|teenagers|brothers|sisters)"
_GROWN = (r"(?:roommates|flatmates|housemates|friends|students|colleagues|tenants|adults|lodgers|"
          r"siblings|people|persons)")  # fmt: skip
_WANT = (r"(?:(?:i|we|you|one|he|she|they|everybody) )?(?:(?:want|wants|would like|'d like|need|needs|like|wish|should|"
         r"can|could|must|may|have|has|be able|ought)(?: to)? (?:be able to )?)?")  # fmt: skip
_GO = rf"{_WANT}(?:go|goes|step|steps|get|gets|walk|walks|come|comes)(?: out(?:side)?)?(?: straight| directly)?"
_WORDS = {
    "room": _ROOM, "hall": _HALL, "number": _NUMBER, "young": _YOUNG, "grown": _GROWN, "go": _GO,
    "hub": r"(?:[a-z]+ ){0,2}?(?P<hub>(?:living|sitting) room|lounge|hall(?:way)?|corridor|passage|landing)",
    "with": r"(?P<pair>(?:an? |the |two )?(?:couple|parents|(?:young )?family) )?(?P<with>(?:with|and) )?\b",
    "rest": r"(?:[^.;:]|\.(?=\d))",
    "end": r"(?= ?(?:[.,;!]|$))",
    "outside": r"(?:balcony|terrace|loggia|patio|veranda|roof terrace)",
    "unit": r"(?:m2|sqm|sq\.? ?m|square met(?:er|re)s?|sq\.? ?ft|sqft|square feet)",
    "least": r"(?:at least|no less than|not less than|no smaller than|not smaller than|min(?:imum)?)",
    "most": r"(?:at most|no more than|not more than|no larger than|not larger than|no bigger than|max(?:imum)?|up to)",
}  # fmt: skip
_OUTSIDE = re.compile(rf"\b{_WORDS['outside']}\b")
_ALTOGETHER = re.compile(r"\b(?:in total|altogether|in all|all in all|all together|overall|a total of)\b")
_HERS = re.compile(r"\b(?:his|her|their) (?:own )?(?:bed ?)?room\b")
_OURS = re.compile(r"\b(?:master|main|parents'|parental|our) bed ?room")
_BEDROOMS = re.compile(rf"\b{_NUMBER}[ -]bed ?rooms?\b")


def _out_on_it(found: re.Match[str]) -> str:
    """`I want to go out on it from the kitchen`, of the balcony named before."""
    named = _OUTSIDE.findall(found.string[: found.start()])
    last = re.findall(rf"\b(?:{_WORDS['outside']}|{_ROOM})\b", found.string[: found.start()])[-1:]
    fits = named and ("out" in found.group() or last == named[-1:])
    hub = found.groupdict().get("from") or ""
    return f"the {named[-1]} is reached {'only ' if found['only'] else ''}from {hub}" if fits else found.group()


def _finite(found: re.Match[str]) -> str:
    """`a utility room off the hallway, sharing a wall with the bathroom` as what it shares."""
    verb = found["verb"]
    return f"{found['the']}{verb}{'es' if verb in ('shar', 'touch', 'fac') else 's'} "


def _each_their_own(found: re.Match[str]) -> str:
    """`two children, each in a single bed in a bedroom of their own` as the children's rooms."""
    bed = found.groupdict().get("bed")
    rooms = f"{found['n']} kids rooms{f' each with {bed}' if bed else ''}"
    if not found["pair"]:
        return f"{found['with'] or ''}{rooms}"
    return f"{found['pair']}, {'' if _OURS.search(found.string) else 'a master bedroom and '}{rooms}"


_SAID: list[tuple[Late, str | Callable[[re.Match[str]], str]]] = [
    # "a hallway, with two bedrooms, one bathroom and the kitchen all opening off it"
    (Late(r"\b(?P<hall>(?:(?:an?|the|one) )?{hub}\b{rest}*?),? (?:with|and) (?P<what>{rest}+? and {rest}+?),? "
          r"all (?:of them |of which )?(?:opening|leading|coming|branching|going|accessible|accessed|reached|entered|"
          r"reachable|open|lead|being)? ?(?:directly )?(?:off|from|onto|on to|to) (?:it|there){end}(?P<more>,? )?",
          _WORDS),
     lambda found: f"{found['hall']}. {found['what']} open off the {found['hub']}{'. ' if found['more'] else ''}"),
    # "two children, each in a single bed in a bedroom of their own"
    (Late(r"{with}(?P<n>two|three|four|[2-4]) {young}, ?each (?:with |in |sleeping in |has |having )?(?P<bed>an? "
          r"[a-z ]{3,12}bed) in (?:an? |its |their |his |her )?(?:own )?(?:bed ?)?room"
          r"(?: of (?:their|its|his|her) own)?{end}", _WORDS), _each_their_own),
    (Late(r"{with}(?P<n>two|three|four|[2-4]) {young}, ?each in (?:an? |its |their |his |her )(?:own )?(?:bed ?)?room"
          r"(?: of (?:their|its|his|her) own)?{end}", _WORDS), _each_their_own),
    (Late(r"{with}(?P<n>two|three|four|[2-4]) {young}[,.;] ?each (?:child|kid|one|of them) (?:has|with|gets|sleeps in) "
          r"(?P<bed>an? [a-z ]{3,12}bed) in (?:its|their|his|her) own (?:bed ?)?room{end}", _WORDS),
     _each_their_own),
    (Late(r"\beach of {with}the (?P<n>two|three|four|[2-4]) {young} (?:sleeps in|has|gets|needs) (?P<bed>an? "
          r"[a-z ]{3,12}bed) in (?:an? |its |their |his |her )(?:own )?(?:bed ?)?room(?: of (?:their|its|his|her) own)?"
          r"{end}", _WORDS), _each_their_own),
    # "two roommates, each of whom has a bedroom with its own bathroom"
    (Late(r"\b(?P<n>{number}) {grown},? (?:each of whom|each of them|every one of whom|all of whom|who each|who all) "
          r"(?:has|have|needs?|gets?|wants?|with) (?:an?|their own|his own|its own) bed ?room(?: of (?:their|its|his) "
          r"own)?(?P<with>,? with |(?= ?[.,;]|$))", _WORDS),
     lambda found: f"{found['n']} bedrooms{' each with ' if found['with'] else ''}"),
    (Late(r"\b(?P<n>{number}) {grown},? each with an? bed ?room and an? (?:en[ -]?suite )?(?P<bath>bath ?room|shower "
          r"room)(?: of (?:their|his|its) own)?{end}", _WORDS), r"\g<n> bedrooms each with its own \g<bath>"),
    (Late(r"\b(?P<n>{number}) {grown},? each with (?:an?|their own|his own|her own) bed ?room(?: of (?:their|his|her) "
          r"own)?{end}", _WORDS), r"\g<n> bedrooms"),
    # "The older two share the second bedroom, there we want a bunk bed"
    (Late(r"\b(?:the |our )?(?:(?:older|younger|other|elder|little|big)(?: {number})?|{number} (?:older|younger|other) "
          r"ones|{young}) (?:will |can |should )?share the "
          r"(?P<which>second|other|third|first|large|larger|small|smaller) (?P<room>bed ?room|room)\b",
          _WORDS), r"the children have the \g<which> bedroom"),
    (Late(r"\b(?:the |our )?(?:(?:older|younger|elder|little) {number}|{number} (?:older|younger)(?: ones)?) "
          r"(?:will |can |should )?share (?=(?:one|an?) (?:bed ?)?room\b)", _WORDS), r"the kids share "),
    (Late(r"\b(?P<who>{young}) (?:will |can |should )?share one of (?:them|these|those|the (?:{number} )?bed ?rooms)\b",
          _WORDS), r"\g<who> share one bedroom"),
    (Late(r"(?P<room>\b{room}),? (?:and )?(?:there|in there|in it) (?:i|we|they|he|she) (?:want|need|would like|"
          r"'d like|have|put|needs|wants)(?: to (?:have|put))? (?=an? |one |two |three |four |\d )", _WORDS),
     r"\g<room> with "),
    # "a balcony. I want to go out on it from the kitchen"
    (Late(r"\b{go} (?:on ?to|on|in ?to|to|there)(?: it| there)? (?P<only>only )?from (?=the )", _WORDS), _out_on_it),
    (Late(r"\b{go} (?:on ?to|on|in ?to|to) (?P<it>the {outside}) (?P<only>only )?from (?=the )", _WORDS),
     r"\g<it> is \g<only>reached from "),
    (Late(r"\b(?P<it>{outside}),? (?:(?:that|which) )?{go} (?:on ?to|on|to) (?P<only>only )?from (?=the )", _WORDS),
     r"\g<it> reached from "),
    (Late(r"\b(?P<it>{outside}),? (?:that|which) (?:you|one|we|i) (?:can )?(?P<only>only )?(?:enter|reach|"
          r"access|get to|get into) (?:only )?(?:from|through|via) (?=the )", _WORDS), r"\g<it> reached from "),
    (Late(r"\bfrom (?P<from>the (?:{room}|{hall})),? {go} (?P<only>)(?:on ?to|on|to) (?:it|there){end}", _WORDS),
     _out_on_it),
    # "540 sq ft for this one-bedroom apartment"
    (Late(r"\b(?P<n>\d+(?:\.\d+)? ?{unit}) for (?:this|that|the|our|an?) (?P<what>{number}[ -]bed(?:[ -]?room)? "
          r"(?:flat|apartment|home|house|dwelling|unit|condo))\b", _WORDS), r"a \g<what> of \g<n>"),
    # "a storage room off the hallway that shares a wall with the kitchen"
    (Late(r"\b(?P<a>an? |one )(?P<room>{room}),? (?P<off>(?:off|on|opening off|accessed from|reached from) the "
          r"{hall}),? (?:(?:that|which) (?=(?:also )?(?:shares|touches|borders|adjoins|faces|is|lies|has|looks)\b)|"
          r"(?=(?:sharing|touching|bordering|adjoining|facing) ))", _WORDS),
     r"\g<a>\g<room> \g<off>. the \g<room> "),
    (Late(r"(?P<the>\. the {room} )(?P<verb>shar|touch|border|adjoin|fac)ing ", _WORDS), _finite),
    # "at least 60 and at most 75 square metres"
    (Late(r"\b(?:an? )?{least}(?: of)? (?P<low>\d+(?:\.\d+)?),? ?(?:and |but |or )?(?:an? )?{most}(?: of)? "
          r"(?P<high>\d+(?:\.\d+)? ?{unit})", _WORDS), r"between \g<low> and \g<high>"),
    (Late(r"\b(?P<low>\d+(?:\.\d+)?)(?: ?{unit})? (?:at least|minimum|or more),? (?:and |but )?"
          r"(?P<high>\d+(?:\.\d+)? ?{unit}) (?:at most|maximum|or less)\b", _WORDS),
     r"between \g<low> and \g<high>"),
]  # fmt: skip


def inverted(text: str) -> str:
    """A folded text with such clauses in plain order, and a count of all bedrooms before whose one is."""
    for pattern, words in _SAID:
        text = pattern.sub(words, text)
    return _counted_first(text)


def _counted_first(text: str) -> str:
    """`her bedroom should be near the entrance. In total we need three bedrooms`: hers is one of the three."""
    if not _ALTOGETHER.search(text) or not _HERS.search(text):
        return text
    said = re.split(r"(?<=[.;]) ", text)
    at = next((k for k, one in enumerate(said) if _ALTOGETHER.search(one) and _BEDROOMS.search(one)), 0)
    before = " ".join(said[:at])
    if not at or not _HERS.search(before) or _BEDROOMS.search(before):
        return text
    return " ".join([said[at].rstrip(" .;") + ".", *said[:at], *said[at + 1 :]])
