"""`My room` beside that of the writer's parents, in five languages: two bedrooms, where none are counted."""

import re

from apartgen.stages.plan.reader.families import COUNTED
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import BEDROOMS

_MINE = late(
    r"\b(?:mein(?:em)? (?:schlaf)?zimmer|ma (?:propre )?chambre|mi (?:propi[oa] )?(?:habitacion|dormitorio|cuarto)|"
    r"my (?:own )?(?:bed ?)?room|la mienne|le mien|la mia|el mio|meine?s|mine)\b(?! ?mate)"
)
_MY_ROOM = late(r"\bmein(?:em|es)? zimmer\b")
_THEIRS = late(
    r"\b(?:(?:das|dem) )?(?:(?:schlaf)?zimmer (?:meiner|der|von meinen|fur meine) eltern|elternschlafzimmer)\b|"
    r"\bla (?:chambre )?(?:de mes|des) parents\b|\bcell?e (?:de mes|des) parents\b|\bdas meiner eltern\b|"
    r"\b(?:la|el) (?:habitacion |dormitorio |cuarto )?de mis padres\b|"
    r"\b(?:my |the )?parents' (?:bed ?)?room\b|\b(?:bed ?)?room (?:of|for) my parents\b|"
    r"\bmy parents'(?= (?:is|has|must|should|needs|next|near|at|on|in|\d))"
)
_COUNTED = re.compile(rf"\b(?:zwei|drei|vier|deux|trois|quatre|dos|tres|cuatro|[2-4]) {BEDROOMS}\b")
_THEIR_ROOM = re.compile(r"\btheir (?:own )?(?:bed ?)?room\b")


def beside_mine(text: str) -> str:
    """A folded text in which both are told of, each as first told, or as the first and second of those counted."""
    text = _MY_ROOM.sub("my room", text)
    if _MINE.search(text) is None:
        return text
    told = _THEIR_ROOM.sub("my parents' room", text, count=1) if "my parents" in text else text
    if (theirs := _THEIRS.search(told)) is None or (mine := _MINE.search(told)) is None:
        return text
    counted = COUNTED.search(told) or _COUNTED.search(told)
    if counted or theirs.start() < mine.start():
        return _MINE.sub("the second bedroom" if counted else "my room", _THEIRS.sub("the parents' bedroom", told))
    return _MINE.sub("my room", _THEIRS.compiled.sub("a parents' bedroom", told, count=1))
