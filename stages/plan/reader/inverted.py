"""What is counted, limited or told of whom only behind what it is said of, in an order that the rules follow."""

import re

from apartgen.stages.plan.reader.pieces import GO, HALL, KIND, NUMBER, OUTSIDE, ROOM, YOUNG, Words, reworded, rules

_WANT = (r"(?:(?:i|we|you|one|he|she|they|everybody) )?(?:(?:want|wants|would like|'d like|need|needs|like|wish|should|"
         r"can|could|must|may|have|has|be able|ought)(?: to)? (?:be able to )?)?")  # fmt: skip
_GO = rf"{_WANT}{GO}(?: out(?:side)?)?(?: straight| directly)?"
_OWN = {
    "room": KIND, "young": rf"(?:{YOUNG}|brothers|sisters)", "go": _GO,
    "hub": rf"(?:[a-z]+ ){{0,2}}?(?P<hub>(?:living|sitting|family) room|lounge|{HALL})",
    "with": r"(?P<pair>(?:an? |the |two )?(?:couple|parents|(?:young )?family) )?(?P<with>(?:with|and) )?\b",
    "rest": r"(?:[^.;:]|\.(?=\d))",
}  # fmt: skip
_OUTSIDE = re.compile(rf"\b{OUTSIDE}\b")
_ALTOGETHER = re.compile(r"\b(?:in total|altogether|in all|all in all|all together|overall|a total of)\b")
_HERS = re.compile(r"\b(?:his|her|their) (?:own )?(?:bed ?)?room\b")
_OURS = re.compile(r"\b(?:master|main|parents'|parental|our) bed ?room")
_BEDROOMS = re.compile(rf"\b{NUMBER}[ -]bed ?rooms?\b")


def _out_on_it(found: re.Match[str]) -> str:
    """`I want to go out on it from the kitchen`, of the balcony named before."""
    named = _OUTSIDE.findall(found.string[: found.start()])
    last = re.findall(rf"\b{ROOM}\b", found.string[: found.start()])[-1:]
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


_TOLD: list[tuple[str, Words]] = [
    # "a hallway, with two bedrooms, one bathroom and the kitchen all opening off it"
    (r"\b(?P<hall>(?:(?:an?|the|one) )?{hub}\b{rest}*?),? (?:with|and) (?P<what>{rest}+? and {rest}+?),? "
          r"all (?:of them |of which )?(?:opening|leading|coming|branching|going|accessible|accessed|reached|entered|"
          r"reachable|open|lead|being)? ?(?:directly )?(?:off|from|onto|on to|to) (?:it|there){end}(?P<more>,? )?",
     lambda found: f"{found['hall']}. {found['what']} open off the {found['hub']}{'. ' if found['more'] else ''}"),
    # "two children, each in a single bed in a bedroom of their own"
    (r"{with}(?P<n>two|three|four|[2-4]) {young}, ?each (?:with |in |sleeping in |has |having )?(?P<bed>an? "
          r"[a-z ]{3,12}bed) in (?:an? |its |their |his |her )?(?:own )?(?:bed ?)?room"
          r"(?: of (?:their|its|his|her) own)?{end}", _each_their_own),
    (r"{with}(?P<n>two|three|four|[2-4]) {young}, ?each in (?:an? |its |their |his |her )(?:own )?(?:bed ?)?room"
          r"(?: of (?:their|its|his|her) own)?{end}", _each_their_own),
    (r"{with}(?P<n>two|three|four|[2-4]) {young}[,.;] ?each (?:child|kid|one|of them) (?:has|with|gets|sleeps in) "
          r"(?P<bed>an? [a-z ]{3,12}bed) in (?:its|their|his|her) own (?:bed ?)?room{end}",
     _each_their_own),
    (r"\beach of {with}the (?P<n>two|three|four|[2-4]) {young} (?:sleeps in|has|gets|needs) (?P<bed>an? "
          r"[a-z ]{3,12}bed) in (?:an? |its |their |his |her )(?:own )?(?:bed ?)?room(?: of (?:their|its|his|her) own)?"
          r"{end}", _each_their_own),
    # "two roommates, each of whom has a bedroom with its own bathroom"
    (r"\b(?P<n>{number}) {grown},? (?:each of whom|each of them|every one of whom|all of whom|who each|who all) "
          r"(?:has|have|needs?|gets?|wants?|with) (?:an?|their own|his own|its own) bed ?room(?: of (?:their|its|his) "
          r"own)?(?P<with>,? with |(?= ?[.,;]|$))",
     lambda found: f"{found['n']} bedrooms{' each with ' if found['with'] else ''}"),
    (r"\b(?P<n>{number}) {grown},? each with an? bed ?room and an? (?:en[ -]?suite )?(?P<bath>bath ?room|shower "
          r"room)(?: of (?:their|his|its) own)?{end}", r"\g<n> bedrooms each with its own \g<bath>"),
    (r"\b(?P<n>{number}) {grown},? each with (?:an?|their own|his own|her own) bed ?room(?: of (?:their|his|her) "
          r"own)?{end}", r"\g<n> bedrooms"),
    # "The older two share the second bedroom, there we want a bunk bed"
    (r"\b(?:the |our )?(?:(?:older|younger|other|elder|little|big)(?: {number})?|{number} (?:older|younger|other) "
          r"ones|{young}) (?:will |can |should )?share the "
          r"(?P<which>second|other|third|first|large|larger|small|smaller) (?P<room>bed ?room|room)\b",
     r"the children have the \g<which> bedroom"),
    (r"\b(?:the |our )?(?:(?:older|younger|elder|little) {number}|{number} (?:older|younger)(?: ones)?) "
          r"(?:will |can |should )?share (?=(?:one|an?) (?:bed ?)?room\b)", r"the kids share "),
    (r"\b(?P<who>{young}) (?:will |can |should )?share one of (?:them|these|those|the (?:{number} )?bed ?rooms)\b",
     r"\g<who> share one bedroom"),
    (r"(?P<room>\b{room}),? (?:and )?(?:there|in there|in it) (?:i|we|they|he|she) (?:want|need|would like|"
          r"'d like|have|put|needs|wants)(?: to (?:have|put))? (?=an? |one |two |three |four |\d )",
     r"\g<room> with "),
    # "a balcony. I want to go out on it from the kitchen"
    (r"\b{go} (?:on ?to|on|in ?to|to|there)(?: it| there)? (?P<only>only )?from (?=the )", _out_on_it),
    (r"\b{go} (?:on ?to|on|in ?to|to) (?P<it>the {outside}) (?P<only>only )?from (?=the )",
     r"\g<it> is \g<only>reached from "),
    (r"\b(?P<it>{outside}),? (?:(?:that|which) )?{go} (?:on ?to|on|to) (?P<only>only )?from (?=the )",
     r"\g<it> reached from "),
    (r"\b(?P<it>{outside}),? (?:that|which) (?:you|one|we|i) (?:can )?(?P<only>only )?(?:enter|reach|"
          r"access|get to|get into) (?:only )?(?:from|through|via) (?=the )", r"\g<it> reached from "),
    (r"\bfrom (?P<from>the (?:{room}|{hall})),? {go} (?P<only>)(?:on ?to|on|to) (?:it|there){end}",
     _out_on_it),
    # "540 sq ft for this one-bedroom apartment"
    (r"\b(?P<n>\d+(?:\.\d+)? ?{unit}) for (?:this|that|the|our|an?) (?P<what>{number}[ -]bed(?:[ -]?room)? "
          r"(?:flat|apartment|home|house|dwelling|unit|condo))\b", r"a \g<what> of \g<n>"),
    # "a storage room off the hallway that shares a wall with the kitchen"
    (r"\b(?P<a>an? |one )(?P<room>{room}),? (?P<off>(?:off|on|opening off|accessed from|reached from) the "
          r"{hall}),? (?:(?:that|which) (?=(?:also )?(?:shares|touches|borders|adjoins|faces|is|lies|has|looks)\b)|"
          r"(?=(?:sharing|touching|bordering|adjoining|facing) ))",
     r"\g<a>\g<room> \g<off>. the \g<room> "),
    (r"(?P<the>\. the {room} )(?P<verb>shar|touch|border|adjoin|fac)ing ", _finite),
    # "at least 60 and at most 75 square metres"
    (r"\b(?:an? )?{least}(?: of)? (?P<low>\d+(?:\.\d+)?),? ?(?:and |but |or )?(?:an? )?{most}(?: of)? "
          r"(?P<high>\d+(?:\.\d+)? ?{unit})", r"between \g<low> and \g<high>"),
    (r"\b(?P<low>\d+(?:\.\d+)?)(?: ?{unit})? (?:at least|minimum|or more),? (?:and |but )?"
          r"(?P<high>\d+(?:\.\d+)? ?{unit}) (?:at most|maximum|or less)\b",
     r"between \g<low> and \g<high>"),
]  # fmt: skip
_SAID = rules(_TOLD, **_OWN)


def inverted(text: str) -> str:
    """A folded text with such clauses in plain order, and a count of all bedrooms before whose one is."""
    return _counted_first(reworded(text, _SAID))


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
