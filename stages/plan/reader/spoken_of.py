"""Whom rooms are told by where people are spoken of again: `one for us … our bedroom`, `my son needs … his bedroom`."""

import re

from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, SEVERAL, WORDS

_PARTNER = r"(?:wife|husband|partner|spouse|girlfriend|boyfriend)"
_KIN = rf"(?:{ELDER}|{CHILD}|(?:grand)?(?:daughter|son)|sister|brother|niece|nephew|cousin)"
_WORDS = WORDS | {
    "kin": rf"(?:(?:older|younger|elder|little|big|teenage|grown-up|eldest|youngest|only) )?{_KIN}",
    "elder": ELDER, "years": r"(?:[a-z]+|\d{1,2})(?:(?:,| and|, and) (?:[a-z]+|\d{1,2}))*(?: years?(?: old)?)?",
    "aged": r"(?:(?:,? (?:who is |of |aged? )?|-)\(?\d{1,2}\)?(?:[ -]years?(?:[ -]old)?)?,?)",
    "needs": r"(?:(?:also |already |will |should |must )*(?:need|want|get|have|sleep)s?|has|should have|would like)\b",
    "us": rf"(?:(?:the two of |both of )?us|me|myself|my {_PARTNER} and (?:me|i|myself)|me and my {_PARTNER})",
}
_COUNTED = Late(rf"\b{SEVERAL}[ -]?(?:bed ?rooms|bed\b|br\b)")
_ONE_FOR_US = Late(
    r"\b(?P<one>(?:(?:one|another|a (?:bed ?)?room)(?: bed ?room| room)?|the (?:first|second|third|other)(?: one| "
    r"bed ?room)?)(?: is| should be)? for) {us}(?=(?: alone| both)?(?: ?[.,;:)]|$| and | with ))", _WORDS)  # fmt: skip
_OURS = Late(r"\b(?:(?:our|my) (?:own )?bed ?room|(?:main|master|parents'|parental) bed ?room|en[ -]?suite to ours)\b")
_HAVE_A = Late(
    r"\b(?:we|i) (?:also |already )?have (?:an?|one) (?:(?:[a-z]+|\d+)(?:-[a-z]+)*[ -]){0,3}?(?P<who>{kin})\b{aged}?"
    r"(?P<of>[^.;,:]{0,40})[.;,:] ?(?:and |so )?(?:she|he|it|who|the (?:child|baby)) (?={needs})", _WORDS)  # fmt: skip
_OLD = Late(r"\b(?P<who>(?:our|my|the) (?:{several} )?{young}) are (?:already )?{years},? (?:and|so|but) (?:they )?"
            r"(?=(?:each|both|all|share|sleep|need|have|get) )", _WORDS)  # fmt: skip
_LIVES = Late(
    r"\b(?P<who>(?:my|our) {kin}|{elder}) (?:also )?(?:lives?|stays?|moves? in|is moving in|is going to live|"
    r"will live|comes to live|is staying)(?: (?:with|in with) (?:us|me|our family))?"
    r"(?:[.;,:] ?(?:and |so )?(?:she|he|it|who)| and(?: she| he)?) (?={needs})", _WORDS)  # fmt: skip
_IN_LAW = re.compile(r"\b(mother|father|sister|brother) in law\b")
_LIVE_WITH = Late(
    r"\b(?P<live>(?:i|we) (?:still |also )?live (?:together )?with) (?P<who>(?:my|our) {kin})[.;,:] ?(?:and |so |but )?"
    r"(?:she|he) (?={needs})", _WORDS)  # fmt: skip
_AND_ME = Late(
    r"\b(?:(?P<who>my {kin}) and (?:me|i|myself)|(?:me|myself) and (?P<whom>my {kin}))[.;,:] ?(?:and |so |but )?"
    r"(?:she|he|who) (?=(?:will |should |must )?(?:need|want|get|have|has)s? [a-z ]{0,10}?(?:bed "
    r"?)?room\b)", _WORDS)  # fmt: skip
_WHOSE = r"(?:our|my|one|an?|unsere?|meine?[rnm]?|notre|mon|ma|nuestr[oa]|mi)"
_ONE = r"(son|daughter|baby|mother|father|sohn|tochter|mutter|vater|fils|fille|mere|pere|hij[oa]|madre|padre)"
_AGAIN = (r"[.;] (?:the|our|my|der|die|unsere?|meine?|le|la|notre|ma|mon|el|mi|nuestr[oa]) {} (?:also |auch )?"
          r"(?=needs?|wants?|gets?|has|should have|braucht|bekommt|hat|will|a besoin|veut|necesita|quiere|"
          r"tiene)")  # fmt: skip
_WHO_NEEDS = Late(rf"\b({_WHOSE} {_ONE})" + _AGAIN.replace("{}", r"\2"))
_TOLD_AGAIN = Late(rf"(?:,| and| und| et| y)+ {_WHOSE} {_ONE}\b(?=[^.;]*" + _AGAIN.replace("{}", r"\1") + ")")
_OF_HIS_OWN = Late(r"\b(?P<room>(?:needs?|wants?|gets?|has|have) an? (?:own )?(?:bed ?)?room\b[^.;,]{0,40}?),? and an? "
                   r"(?P<bath>bath ?room|toilet|shower room|wc) of (?:his|her|their|its) own\b", _WORDS)  # fmt: skip
_WE = Late(r"\b(?:we (?:also )?(?:need|want|have|sleep|get|keep)|ours|(?:bed ?)?room for (?:us|me))\b")
_ROOM = re.compile(r"\b(?P<who>kids room|relative's room)(?P<many>s?)\b")
_OF_THEM = re.compile(r"\b(?:his|her|its|their) (?:own )?(?:bed ?)?room\b")


def as_first_told(text: str) -> str:
    """A folded text in which `one for us` is the parents' room, where that is told of later, and `she` is named."""
    text = _TOLD_AGAIN.sub("", _WHO_NEEDS.sub(r"\1 who ", text))
    text = _OF_HIS_OWN.sub(r"\g<room> with its own \g<bath>", _OLD.sub(r"\g<who> ", text))
    text = _LIVE_WITH.sub(r"\g<live> \g<who> who ", _IN_LAW.sub(r"\1-in-law", text))
    text = _AND_ME.sub(lambda found: f"me and {found['who'] or found['whom']} who ", text)
    text = _with_us(_HAVE_A.sub(r"our \g<who>\g<of> ", text))
    found = _ONE_FOR_US.search(text)
    if found is None or not _COUNTED.search(text[: found.start()]) or not _OURS.search(text[found.end() :]):
        return text
    return f"{text[: found.start()]}{found['one']} the parents{text[found.end() :]}"


def _with_us(text: str) -> str:
    """`my mother lives with us. She needs a bedroom`: hers, and one of those whom she lives with."""
    said = _LIVES.sub(r"\g<who> ", text)
    alone = said != text and not _COUNTED.search(text) and not _OURS.search(text) and not _WE.search(text)
    return f"{said.rstrip(' .!')}. a parents' bedroom." if alone else said


def of_the_last(text: str) -> str:
    """`a kids room; his bedroom faces south`: that of the one whose room it is, where only one has been told of."""
    first = _ROOM.search(text)
    one = first is not None and not first["many"] and len({m["who"] for m in _ROOM.finditer(text)}) == 1
    if first is None or not one or len(_ROOM.findall(text)) > 1:
        return text
    return text[: first.end()] + _OF_THEM.sub(f"the {first['who']}", text[first.end() :])
