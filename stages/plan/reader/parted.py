"""Clauses within clauses and doors said last, parted into sentences of their own."""

import re

from apartgen.stages.plan.reader.declined import declined
from apartgen.stages.plan.reader.mutually import mutually
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import KIND, YOUNG, reworded, rules
from apartgen.stages.plan.reader.referred import referred
from apartgen.stages.plan.reader.renounced import renounced
from apartgen.stages.plan.reader.respectively import respectively
from apartgen.stages.plan.reader.tasks import as_listed, without_tasks
from apartgen.stages.plan.reader.thereabouts import thereabouts

_BOTH = rf"between (?:the )?{KIND} and (?:the )?{KIND}\b"
_SAID = rules((
    # "the living room, which has the balcony too, must have three doors"
    (r"(?<![a-z] )\b((?:the|my|our) {kind}), (?:which|that) ((?:also )?"
     r"(?:has|is|leads|opens|faces|lies|connects|gets|needs|must|should)\b[^.;:]*?), "
     r"(?=(?:must|should|shall|has|is|needs|gets|faces|measures|opens|leads|lies|can|may|will)\b)", r"\1 \2. \1 "),
    # "all open off the hallway, and there is also a door between the kitchen and the living room"
    (r"(?:,? (?:and|but|plus)(?: there(?: is|'s| should be| must be)| with)?|, with) (?:also |additionally )?"
     r"(?:an?|another|one) (?:second |further |more |direct |additional |connecting )?door "
     r"(?:also |as well )?(?={both})",
     ". there is a door "),
    # "a bedroom has no door to the hall, only one to the bathroom"
    (r"\b((?:the|my|our) {kind}) (?:has|should have|must have) no doors? to (?:the )?({kind}),? "
     r"(?:only|just|but|but only) (?:one|a door|one door) to (?:the )?({kind})\b",
     r"\1 has no door to the \2. \1 has a door to the \3"),
    # "starts in the study, which has no door to the hall"
    (r"(?<= in )(the {kind}), (?:which|that) has (no doors?|a door) to ", r"\1. \1 has \2 to "),
    # "a door to the living room but none to the hallway"
    (r"(\bdoors? (?:to|into) (?:the |an? )?{kind}),? (?:but|and) (?:none|no door|no doors|not one|no other) "
     r"(?:to|into|towards) ", r"\1 but not to "),
    # "un balcón en el salón y, en la cocina, dos frigoríficos"
    (r",? y,? en (la|el) (\w+), (?=una? |dos |tres |cuatro |\d )", r". \1 \2 tiene "),
    (r",? et,? dans (la|le) (\w+), (?=une? |deux |trois |quatre |\d )", r". \1 \2 a "),
    # "Abstellraum mit Zugang von der Küche"
    (r"\bmit (?:direktem |eigenem )?(?:zugang|zutritt|eingang) (?:von|aus|uber) (?:der|dem|die|den|das) (\w+)",
     r"zuganglich vom \1"),
    (r"\bmit (?:direktem |eigenem )?(?:zugang|zutritt|eingang) (?:vom|ubers|zum|zur) (\w+)", r"zuganglich vom \1"),
    # "the second is for everybody and its door is in the corridor"
    (r"\b(is|are) for (?:everybody|everyone|all(?: of us)?|the whole family),? and (?:its|the|their) doors? (?:is|are) "
     r"(?=in|on|off|to)", r"\1 "),
    # "the living room is on the south side of the house"
    (r"(\b{kind}\b[^.;:]* )on the (north|south|east|west)(?:ern)? (?:side|edge) of (?:the|our|my|this) (?:house|home|"
     r"flat|apartment|plan|unit)\b", r"\1at the \2 end of the flat"),
    # "a studio with the kitchen in a separate room"
    (r"\b(?:the |an? )?kitchen (?:is |should be |must be )?(?:in|as) (?:an?|its own|another) (?:separate |own )?room\b",
     "a separate kitchen"),
), both=_BOTH)  # fmt: skip
_YOUNG = rf"(?:(?:our|my|the) )?(?:two |three )?{YOUNG}"
_IN = r"(?:will |should |can )?(?:share|sleep in|sleep together in|have|get|are in|sleeps? in)"
_TWO_SLEEP = [late(pattern) for pattern in (
    rf"\b{_YOUNG} {_IN} one (?:bed)?room,? (?:and|while|but)? ?(?:we|my (?:wife|husband|partner) and (?:i|me)) "
    rf"(?:{_IN} |in )?the other(?: one| (?:bed)?room)?\b",
    rf"\b(?:we|my (?:wife|husband|partner) and i) {_IN} one (?:bed)?room,? (?:and|while|but)? ?{_YOUNG} "
    rf"(?:{_IN} |in )?the other(?: one| (?:bed)?room)?\b",
)]  # fmt: skip
_KIDS, _OURS = "the kids' bedroom", "the parents' bedroom"
_SAID_OF = [(re.compile(pattern), words) for pattern, words in (
    (r"\btheirs\b", _KIDS), (r"\b(?:ours|our (?:bed)?room)\b", _OURS),
    (r"\b(?:they|the twins|the kids|the children) (?:get|have|need|want)\b", f"{_KIDS} has"),
    (r"\bwe (?:get|have|need|want) (?=an? )", f"{_OURS} has "),
)]  # fmt: skip


def _two_sleep(text: str) -> str:
    """`our twins sleep in one bedroom and we sleep in the other; theirs is next to ours` as what is said of the two."""
    for pattern in _TWO_SLEEP:
        the = "the" if re.search(r"\b(?:two|three|four|[2-4])[ -]bed", text) else "a"
        said = pattern.sub(f"{the} kids bedroom, {the} parents' bedroom", text)
        if said != text:
            for words, room in _SAID_OF:
                said = words.sub(room, said)
            return said
    return text


def parted(text: str) -> str:
    """A folded text with such clauses behind one another."""
    text = mutually(declined(respectively(thereabouts(as_listed(without_tasks(referred(renounced(text))))))))
    return _two_sleep(reworded(text, _SAID))
