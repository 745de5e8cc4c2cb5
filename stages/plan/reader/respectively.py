"""What is said of each of two rooms: which bathroom is whose, who has which bedroom, what only one of them has."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import KIND, reworded

_COUNTED = re.compile(r"\b(?:two|three|four|five|[2-5])[- ]bed ?rooms?\b")


def _bedroom(found: re.Match[str]) -> str:
    """`my carer's has …` as her bedroom, where bedrooms were counted before."""
    if _COUNTED.search(found.string[: found.start()]) is None:
        return found.group()
    return {"mine": "my bedroom ", "ours": "our bedroom "}.get(found[1], f"{found[1]} bedroom ")


def _ensuite_each(found: re.Match[str]) -> str:
    """`two bathrooms en suite to bedrooms 1 and 2`: one to each."""
    one = f"one {found[1]}" if found[1] else "one"
    return f"{one} en suite to bedroom {found[2]}, one en suite to bedroom {found[3]}"


def _the(rooms: str, object_: bool = False) -> str:
    """Rooms spoken of again, with a verb unless they are an object."""
    again = re.sub(r"^(?:the |an? )?", "the ", rooms.strip())
    return again if object_ else f"{again} {'are' if again.endswith('s') else 'is'}"


def _one_more(found: re.Match[str]) -> str:
    """`… y uno grande` as `… and a big one`."""
    return f"{found[1]} and a {'big' if found[2].startswith('g') else 'small'} one"


def _only_one(found: re.Match[str]) -> str:
    """`only one of the two bathrooms has a bathtub`: the other has none."""
    _, verb, article, thing = found.groups()
    told = re.findall(r"\b(two|three|four|[2-6]) (?:bed|bath) ?rooms\b", found.string[: found.end()])
    other = f", the other has no {thing}" if told and told[-1] in ("two", "2") else ""
    return f"one of {found[1]} {verb} {article} {thing}{other}"


_SAID = [(late(pattern), words) for pattern, words in (
    # "with a dressing room and a bathroom, both entered from it"
    (r"(\bwith (?:an? |its own )?(?:[a-z-]+ )?[a-z]+ and (?:an? |its own )?(?:[a-z-]+ )?[a-z]+),? (?:which are )?"
     r"(?:both|each)(?: of (?:them|which))? "
     r"(?:entered|reached|accessed|accessible|reachable|opening|opening off|to be entered) (?:only )?(?:from|off|"
     r"through) it\b",
     r"\1 off it"),
    # "the other with a shower, en suite to our bedroom"
    (r"\b(with an? [a-z -]{3,20}?),? en[- ]?suite (?:to|with|off) (?=(?:our|my|the|their|his|her) (?:[a-z']+ )?(?"
     r":bed ?)?"
     r"room\b)", r"\1 off "),
    # "only one of the two bathrooms has a bathtub", "everyone else uses the bathroom off the hall"
    (r"\bonly one of (the two [a-z]+ ?[a-z]*s|them|these) (has|gets|should have|is to have|needs) (an?) (?!balcony|"
     r"bath ?room|"
     r"closet|en|shower room|"
     r"door|window|toilet|wc)([a-z]+(?: [a-z]+)?)(?= ?(?:[.,;]|$))",
     _only_one),
    (r"\b(?:everyone|everybody|anyone|anybody) else (?:uses|shares|goes to|has) (?=the |an? |one )", "there is "),
    # "two bedrooms: my carer's has a shower room off it, mine has a bathroom"
    (r"\b((?:my|our|the) [a-z]+'s|grandma's|grandpa's|granny's|mum's|dad's) (?=(?:has|is|gets|needs|should|must|"
     r"faces|opens|lies)\b"
     r"(?! (?:name|birthday|age)))", _bedroom),
    (r"\b(mine|ours) (?=(?:has|gets|needs|should|must|faces|opens)\b)", _bedroom),
    # "the larger gets a double bed, the smaller two single beds"
    (r"(\b(gets|has|needs|contains)\b [^.;]*?(?:,| and|, and|;|,? while|,? but) )(the (?:smaller|larger|bigger|"
     r"second|"
     r"first|third|smallest|biggest|largest)(?: one)?) (?=(?:two|three|four|[2-4]) (?!bed ?rooms))", r"\1\3 \2 "),
    # "dos dormitorios pequeños y uno grande", "deux petites chambres et une grande"
    (r"(\b(?:dormitorios|habitaciones)(?: \w+)?) y un[oa] (grande|pequen[oa])\b", _one_more),
    (r"(\b(?:petites|grandes) chambres) et une (petite|grande)\b", _one_more),
    (r"(\b(?:kleine|grosse) (?:schlafzimmer|zimmer)) und ein (grosses|kleines)(?= ?(?:[.,;]|$)| mit )", _one_more),
    # "four bedrooms, 11 m² each, with a bed and a desk"
    (r"\b((?:m2|sqm|sq m|square met(?:er|re)s?) each),? with (?=an? |two |its |one )",
     r"\1, each with "),
    # "bathrooms en suite to bedrooms 1 and 2", "two of them en suite to bedrooms 1 and 2"
    (r"\b(?:two|2) (?:(bath ?room|shower ?room)s|of (?:them|which|these)) (?:are |being )?en[- ]?suite (?:to|with|"
     r"off) (?:the )?"
     r"bed ?rooms (\d) and (\d)", _ensuite_each),
    # "two bedrooms at one end of the flat, the living room at the opposite end"
    (rf"\b((?:the )?(?:two|three|four|\d )?[a-z' ]*?(?:{KIND}s?)) (?:is |are |lie |lies |be )?at one end(?: of the "
     rf"[a-z]+)?"
     rf"(?:,| and|, and|;| while)? ((?:(?:the|an?) (?:[a-z]+ )?)?{KIND}s?) (?:is |are |lie |lies )?at the (?:other|"
     rf"opposite|far)"
     r"(?: end)?\b(?: of the (?:flat|apartment|house|home))?",
     lambda found: f"{found[1]}, {found[2]}. {_the(found[1])} far from {_the(found[2], True)}"),
)]  # fmt: skip


def respectively(text: str) -> str:
    """A folded text that says such things of one room after the other."""
    return reworded(text, _SAID)
