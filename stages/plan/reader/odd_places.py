"""Rooms and furniture with odd prepositions: `balcony at big bedroom`, `desk into kids room`, `bath is at bedroom`."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_WHICH = (r"(?:(?:very )?(?:big|large|main|master|first|second|third|small|little|biggest|bigger|largest|larger|"
          r"smallest|smaller|guests?'?|parents?'?|kids?'?s?|children'?s?|other))")  # fmt: skip
_BED = rf"(?P<of>(?:{_WHICH} )+(?:bed ?)?room|(?:the )?master|bed ?room)\b(?! (?:suite|door|window|wing))"
_LIVED = r"(?P<of>living room|kitchen|lounge|dining room|study)\b"
_OUTSIDE = r"(?P<out>balcon(?:y|ies)|terraces?|loggias?|verandas?)"
_AT = r"(?:at|on|to|into|in|inside(?: of)?|for|by side of|of|with|next of)"
_IS = r"(?:,? (?:is|are|be|must be|should be|goes|must|should|to be|being|must to be|should to be))?"
_THING = (r"(?:(?:(?:single|double|bunk|dining|work|coffee|washing|big|small|large|one|two|three|2|3|an?|the) "
          r")*(?:desks?|beds?|sofas?|couch(?:es)?|wardrobes?|tables?|tvs?|book ?shel(?:f|ves)|bookcases?|shel(?:f|"
          r"ves)|machines?|fridges?|chairs?|armchairs?|dressers?|lamps?|mirrors?|rugs?|bath ?tubs?|showers?|pianos?|"
          r"closets?))")  # fmt: skip
_OF_BED = re.compile(r"^((?:(?:very )?(?:big|large|small|little|bigger|larger|smaller|biggest|largest|smallest|second|"
                     r"third) )+)room$")
"""A word for a bedroom, where a bed or desk stands in it: `the small room`."""


def _of(found: re.Match[str]) -> str:
    """A room with its article, as those that were named have."""
    room = re.sub(r"^(?:the|our|my) ", "", found["of"])
    return "the " + _OF_BED.sub(r"\1bedroom", room)


def _a(found: re.Match[str]) -> str:
    """`bed` that begins a clause as `a bed`, which is no bedroom then."""
    thing, opens = found["thing"], re.search(r"(?:^|[.;,:]) *$", found.string[: found.start()])
    return thing if not opens or re.search(r"s$|^(?:an?|the|one|two|three|\d)\b", thing) else f"a {thing}"


def _has_bath(found: re.Match[str]) -> str:
    return f"{_of(found)} has an ensuite bathroom"


_SAID = rules((
    # "bath is at big bedroom", "in big bedroom is bath"
    (r"(?<![a-z] )(?<!second )(?<!other )\b(?:the |an? )?(?:bath|bath ?room|en[ -]?suite) (?:is|are|must be|should be|"
     r"goes|must to be) (?:at|on|into|to|in|inside|by) (?:the )?{bed}(?={end}| and )", _has_bath),
    (r"(?:(?<=^)|(?<=[.;,] ))(?:at|in|inside|on|into) (?:the )?{bed} (?:is|there is|must be|should be|be) (?:the |an? "
     r")?(?:bath|bath ?room|en[ -]?suite)(?={end}| and )", _has_bath),
    # "balcony at the big bedroom", "terrace on kitchen"
    (r"\b{out}{is_} {at} (?:the )?{bed}", lambda found: f"{found['out']} off {_of(found)}"),
    (r"\b{out}{is_} (?:at|to|into|inside(?: of)?|next of) (?:the )?{lived}", lambda found: f"{found['out']} off "
                                                                                           f"{_of(found)}"),
    # "desk into kids room", "wardrobe at small bedroom", "sofa on living room"
    (r"(?P<thing>\b{thing}){is_} (?:(?:at|on|into|to|inside(?: of)?) (?:the )?|in ){bed}",
     lambda found: f"{_a(found)} in {_of(found)}"),
    (r"(?P<thing>\b{thing}){is_} (?:at|on|into|to|inside(?: of)?) (?:the )?{lived}",
     lambda found: f"{_a(found)} in {_of(found)}"),
    (r"(?:(?<=^)|(?<=[.;] ))in {bed} (?=(?:is|are|there is|there are|must be|should be|be|has|have) )",
     lambda found: f"in {_of(found)} "),
    (r"\bnext of (?=(?:the )?(?:entrance|{kind}))", "next to "),
    # "balcon à la grande chambre", "阳台在大卧室"
    (r"\b(?P<out>balcon|terrasse|loggia) (?:a|de|pour|dans) (?=(?:la|le|l') ?(?:(?:grande|petite|premiere|deuxieme) "
     r")?{fr})",
     r"\g<out> accessible depuis "),
    (r"(?P<out>阳台|露台)(?:要|应该)?(?:在|连着|连接|靠着|接)(?P<of>[大小主次]卧室?)(?:里|旁|外面?|上)?(?=[,.;]|$)",
     r"\g<of>带\g<out>"),
), bed=_BED, lived=_LIVED, out=_OUTSIDE, at=_AT, is_=_IS, thing=_THING)  # fmt: skip


def odd_places(text: str) -> str:
    """A folded text with such places in usual words."""
    return reworded(text, _SAID)
