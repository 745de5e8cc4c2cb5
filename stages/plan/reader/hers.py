"""Which of two rooms is hers and which is mine, in five languages: the first and the second that are told of."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import BEDROOMS

_OWNERS = ("his", "hers", "mine", "ours", "theirs", "yours")
_OF_WHOM = re.compile(rf"\b(?:{'|'.join(_OWNERS)})\b")
_ROOMS = {
    "bedroom": BEDROOMS,
    "bathroom": "bath ?rooms|bader|badezimmer|salles de bains?|salles d'eau|banos",
    "study": "studies|arbeitszimmer|buros|despachos|estudios",
    "balcony": "balconies|balkone|balcons|balcones|terrazas",
}
_TWO = {kind: late(rf"\b(?:two|2|zwei|deux|dos) (?:{words})\b|(?:两|二|2)[个间]?{zh}") for (kind, words), zh in
        zip(_ROOMS.items(), ("(?:卧室|房间|室)", "(?:卫生间|浴室)", "书房", "阳台"), strict=True)}  # fmt: skip
_VERB = (r"(?=(?: ?[,:;]? ?)(?:mit|nach|im|in|am|an|neben|bei|zum|zur|soll|ist|hat|bekommt|liegt|geht|ohne|etwas|\d|"
         r"auf))")  # fmt: skip
_SAID = [(late(said), owner) for said, owner in (
    (r"\bin meinem (?:(?:steht|stehen|soll(?:en)?|kommt)\b|(?=ein|zwei|drei))", "mine has "),
    (r"\bin (?:ihrem|seinem) (?:(?:steht|stehen|soll(?:en)?|kommt)\b|(?=ein|zwei|drei))", "hers has "),
    (rf"\bmein(?:e?s|e[rnm]?)\b{_VERB}|\b(?:la mienne|le mien|el mio|la mia)\b|我的(?=朝|在|靠|挨|有|带|要|放|是|\d)",
     "mine"),
    (rf"\b(?:ihr(?:e?s|e[rnm]?)|sein(?:e?s|e[rnm]?))\b{_VERB}|\b(?:la sienne|le sien|el suyo|la suya)\b|"
     r"[她他]的(?=朝|在|靠|挨|有|带|要|放|是|\d)", "hers"),
    (rf"\bdein(?:e?s|e[rnm]?)\b{_VERB}|\b(?:la tienne|le tien|el tuyo|la tuya)\b", "yours"),
)]  # fmt: skip
_DESK = re.compile(r"(\bthe (?:first|second) bedroom,? (?:avec|a|aura)) un bureau\b")
_BY = re.compile(r"\b(?:next|adjacent|close|opposite) to\b|\b(?:beside|near|off|opposite)\b")
_AT_END = re.compile(r"[;,.] ?(?:two|2) (?:bed ?rooms|bath ?rooms|studies|balconies)(?= ?(?:[.;,]|$))")


def whose_rooms(text: str) -> str:
    """`two bedrooms, 8 m² for hers and 13 for mine; no TV in hers`: the first and the second, wherever named."""
    told = text
    for said, owner in _SAID:
        told = said.sub(owner if text.isascii() else f" {owner} ", told)
    names = list(dict.fromkeys(_OF_WHOM.findall(told)))
    if len(names) != 2:
        return text
    told = _counted_first(told)
    found = [(kind, two) for kind, said in _TWO.items() if (two := said.search(told)) is not None]
    if len(found) != 1 or _OF_WHOM.search(told[: found[0][1].start()]):
        return text
    which = dict(zip(names, (f"the first {found[0][0]}", f"the second {found[0][0]}"), strict=True))
    second = re.compile(rf", (?=(?:{names[1]})\b(?! (?:both|each|are|and)\b))")
    told = second.sub(". ", told) if _BY.search(told) else told
    return _DESK.sub(r"\1 une table de travail", _OF_WHOM.sub(lambda one: which[one.group()], told))


def _counted_first(text: str) -> str:
    """`hers should be 12 m² and mine 10; two bedrooms` with the count before."""
    behind = _AT_END.search(text)
    first = _OF_WHOM.search(text)
    if behind is None or first is None or behind.start() < first.start():
        return text
    return f"{behind.group().strip(' ;,.')}. {text[: behind.start()]}{text[behind.end() :]}"
