"""Rooms spoken of by what was said before: `away from hers`, `off it too`, one for each child among all."""

import re
from functools import partial

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import (
    BEDROOMS,
    BESIDE,
    CHILD,
    GO,
    HALL,
    HE,
    KIND,
    MUST,
    SHE,
    THEY,
    YOUNG,
    reworded,
)

_N = r"(?:two|three|four|five|six|zwei|drei|vier|funf|deux|trois|quatre|cinq|dos|tres|cuatro|cinco|[2-6])"
_COUNTED = re.compile(rf"\b({_N})[- ](?:[a-z]+[- ])?(?:bed ?room|{BEDROOMS})\b")
_VALUES = {word: n for words in ("two three four five six", "zwei drei vier funf", "deux trois quatre cinq",
                                 "dos tres cuatro cinco", "2 3 4 5 6")
           for n, word in enumerate(words.split(), 2)}  # fmt: skip
_EACH = [(late(pattern), words) for pattern, words in (
    (r"(?:there (?:is|should be) )?\b(?:one|an? (?:bed ?)?room|another)(?: one)? (?:for each of|each for) (?:our |my |"
     rf"the |their )?(?P<n>{_N}) {YOUNG}\b", "{} for the kids"),
    (rf"\b(?:one|an? (?:bed ?)?room) (?:for each of|each for) (?:(?:our|my|the|their) )?{YOUNG}\b|"
     r"\b(?:one|an? (?:bed ?)?room) for (?:each|every) (?:child|kid|son|daughter)\b|"
     r"\bone for each of them\b", ""),
    (rf"\bje ein(?:e?s|en|e)?(?: zimmer)? fur (?:unsere|meine|die) (?P<n>{_N}) (?:kinder|tochter|sohne|madchen|jungen|"
     rf"jungs)\b", "{} for the kids"),
    (rf"\bune (?:autre )?pour chacune? de (?:nos|mes|leurs) (?P<n>{_N}) (?:enfants|filles|fils|garcons)\b",
     "{} for the kids"),
    (rf"\b(?:un[oa]|otr[oa]) para cada un[oa] de (?:nuestr[oa]s|los|las|mis|sus) (?P<n>{_N}) (?:hij[oa]s|nin[oa]s)\b",
     "{} for the kids"),
)]  # fmt: skip
_OWN = late(r"(\bbed ?rooms ?[:,-]) ?our own(?= ?,| and\b)")
_AGED = re.compile(r"\b[a-z]{2,} ?\((?:aged? )?(?:[2-9]|1\d)(?: years?(?: old)?)?\)")
"""Children by their names: `Lea (4) and Tom (9)`."""
_CHILDREN = re.compile(rf"\b(?:{YOUNG})\b")
_ROOMS = re.compile(r"\b(bed|bath|living |dining |sitting |)(?:room|kitchen|study|toilet|balcony|desk)s?\b")
_ENGLISH = ("", "", "two", "three", "four", "five", "six")
_ADDED = re.compile(r"\b(?:plus|besides|in addition|additionally)\b|^[^,:;(-]*\b(?:and|plus|und|et|y) $")
"""Behind bedrooms that are counted: what follows comes on top of them."""
_NEAR = rf"(?:{BESIDE}|as)"
_HERS = late(rf"\b({_NEAR}) (hers|his|theirs)(?= ?(?:[.,;:!?)]|$)| (?:and|but|as|so|if|with)\b)")
_OWNED = late(rf"\b({_NEAR}|than) ((?:(?:our|my|the|his|her|their) )?(?:{SHE}|{HE}|{THEY}|{CHILD}|lodger|guest)'s?)"
              r"(?= ?(?:[.,;:!?)]|$)| (?:and|but|so|if)\b)")  # fmt: skip
_OWNER = {
    "hers": re.compile(rf"\b{SHE}'s (?:own )?(?:bed ?)?room\b"),
    "his": re.compile(rf"\b{HE}'s (?:own )?(?:bed ?)?room\b"),
    "theirs": re.compile(rf"\b{THEY}'s? (?:own )?(?:bed ?)?room\b|\b{THEY}'? (?:own )?(?:bed ?)?room\b"),
}
_HALL = rf"({HALL})"
_OF_HALL = r"(?:directly )?(?:off|along|on|onto|to|from)"
_SOME = (r"(?:an?|one|two|three|four|five|six|the|both|all|also|their|\d) (?:[a-z']+ ){0,2}[a-z]+"
         r"(?: (?:is|are|open|opens|opening|lie|lies|also|both))*")  # fmt: skip
_ONE = r"(?:one|an?|the|this|that|the same|a single)"
_IT = r"(?:directly |also )?(?:off|along|on|onto) (?:it|this one|the same one)\b"
_AND = r"((?:[,;.]| and| plus)+ (?:(?:and|then|plus|also|with) )*"
_OFF_IT = late(rf"\b({_OF_HALL}) {_ONE} {_HALL}{_AND}{_SOME}) {_IT}(?:,? (?:too|also|as well)\b)?")
_LISTED = late(rf"\b({_OF_HALL}) {_ONE} {_HALL}{_AND}{_SOME}(?:,? and|,) {_SOME}) {_IT},? (?:too|also|as well)\b")
_WITH = late(rf"\b(?:an?|one|the) {_HALL} (?:with|that has|has|having) ({_SOME}) (?:off|along|on) it\b")
_FRONTED = late(rf"\b({_OF_HALL}) {_ONE} {_HALL}(?:[,;.]| and)+ (?:and )?(?:also )?(?:off|along|on) it"
                r"(?: also| too| as well| there (?:is|are)| come| comes)*,? "
                r"((?:an?|one|two|three|four|the|\d) [a-z ]+?)"
                r"(?= ?(?:[.,;]|$))")  # fmt: skip
_HAS = late(r"\b(an?|the|our) (living room|kitchen|dining room|lounge|study|sitting room) (?:with|has|having) "
            rf"(an? (?:small |large |separate )?{KIND}) (?:directly )?off it(?= ?(?:[.,;]|$)| and\b)")  # fmt: skip
_NOBODY = r"(?:nobody|no ?one|none of us|no guests?|no visitors?)"
_YOU = (r"(?:(?:you|one|we|people|they|guests|visitors|the guests|the kids) (?:do not|don't|does not|doesn't|"
        r"should not|shouldn't|must not|mustn't|can ?not|can't|may not|never)(?: be able to)?(?: ever)?|"
        r"it (?:must|should|shall) not be possible(?: for [a-z ]{3,12})? to)")  # fmt: skip
_ENTERS = (rf"(?:(?:{MUST}|ever) )*(?:be able to )?"
           rf"(?:{GO} (?:straight |directly )?(?:in|in ?to|to)|enters?|reach(?:es)?|"
           r"access(?:es)?)")  # fmt: skip
_FROM = r"(?:straight |directly |only )?(?:from|through|via|by way of)"
_ANY_BATH = r"(?:an?|any|either|one of the|the two|both|the) ?(?:of the )?bath ?rooms?"
_ANY_BED = r"(?:an?|any|the|either|our|one of the) (?:of the )?bed ?rooms?"
_IN = (r"(?:is|are|should be|must be|can be|may be) (?:entered|reached|accessed|accessible|reachable) "
       rf"{_FROM}")  # fmt: skip
_STOP = r"(?= ?(?:[.,;!]|$))"
_NO = r"(?:neither|none of the|no)(?: of the)?(?: two)?"
_NONE = "neither bathroom is en suite"
_DOORS = [(late(pattern), words) for pattern, words in (
    # "nobody comes into a bathroom from the bedroom", "no bathroom is entered from a bedroom"
    (rf"\b(?:{_NOBODY}|{_YOU}) {_ENTERS} (?!the bath ?room\b){_ANY_BATH} {_FROM} {_ANY_BED}\b", _NONE),
    (rf"\b(?:{_NOBODY}|{_YOU}) (?:walk|go|get|come|step|pass)(?:e?s)?(?: straight| directly)* from {_ANY_BED} "
     rf"(?:straight |directly )?(?:in ?)?to (?!the bath ?room\b){_ANY_BATH}", _NONE),
    (rf"\b{_NO} bath ?rooms? {_IN} {_ANY_BED}\b", _NONE),
    (rf"\b(?:the|both|our|the two) bath ?rooms (?:are|should be|must be|may be|can be)? ?not (?:be )?"
     rf"(?:entered|reached|accessed|accessible|reachable) {_FROM} {_ANY_BED}\b", _NONE),
    (rf"\b{_NO} bath ?rooms? (?:is |are )?(?:opens?|leads?|gives?|has a door|have doors|have a door|has doors|off|"
     rf"directly off)(?: directly)?(?: off| onto| into| to| from)* {_ANY_BED}{_STOP}", _NONE),
    (rf"\b{_NO} bed ?rooms? (?:opens?|leads?|gives?|has a door|have doors)"
     rf"(?: directly)? (?:onto|into|to) (?:an?|any|either) (?:of the )?bath ?rooms?{_STOP}", _NONE),
    (rf"(\bbath ?rooms [^.;]*\bdoors? [^.;,]*),? (?:and |but )?none(?: of them)? (?:in|off|inside|from|to) {_ANY_BED}"
     rf"{_STOP}", r"\1, neither of them en suite"),
    (rf"\b(?:{_NOBODY}|{_YOU}) {_ENTERS} (the bath ?room) {_FROM} (?:an?|any) bed ?room{_STOP}",
     r"no door between \1 and the bedrooms"),
    (rf"\b(?:{_NOBODY}|{_YOU}) {_ENTERS} (the {KIND}) {_FROM} ((?:the|an?|any) {KIND}){_STOP}",
     r"no door between \1 and \2"),
    (rf"\b(?:{_NOBODY}|{_YOU}) (?:(?:should|must|can|may|shall|has to|have to) )*"
     rf"(?:walk|go|pass|cross|step|come)(?:e?s)?(?: through| across)? (the {KIND}) (?:in order )?"
     rf"to (?:reach|get (?:in)?to|enter|go to|access|use|visit) (the {KIND}){_STOP}",
     r"no door between \1 and \2"),
    # "both bathrooms have the door in the hall"
    (rf"\b(have|has|having|with) (?:the|their|its|an?|his|her)(?: own)? doors? (?:in|on|onto|off) (?:the |one )?{_HALL}"
     r"\b", r"\1 a door to the \2"),
)]  # fmt: skip


def referred(text: str) -> str:
    """A folded text with such rooms by their names."""
    for pattern, words in _EACH:
        text = pattern.sub(partial(_among, words=words), text)
    text = _HERS.sub(_theirs, _OWNED.sub(r"\1 \2 bedroom", _OWN.sub(r"\1 ours", text)))
    return _off_it(reworded(text, _DOORS))


def _among(found: re.Match[str], words: str) -> str:
    """`three bedrooms, one for us and one for each of our two daughters` as two for the kids; else as it is."""
    counted = list(_COUNTED.finditer(found.string, 0, found.start()))
    n = _VALUES[found["n"]] if "n" in found.re.groupindex else max(2, len(_AGED.findall(found.string)))
    before = found.string[: found.start()]
    if found.group().endswith("them") and not (_CHILDREN.search(before) and _ROOMS.findall(before)[-1:] == ["bed"]):
        return found.group()
    if not words and not counted:
        return f"{_ENGLISH[min(n, 6)]} for the kids"
    several = "{} for the kids" if found.group().endswith("twins") else "the others for the kids"
    n, words = (n, words) if words else (2, several)
    if not counted or _VALUES[counted[-1][1]] < n or _ADDED.search(found.string[counted[-1].end() : found.start()]):
        return found.group()
    return words.format(_ENGLISH[n])


def _theirs(found: re.Match[str]) -> str:
    """`the kids' bedroom away from hers`: from that of the woman who was spoken of last."""
    rooms = _OWNER[found[2]].findall(found.string[: found.start()])
    told = rooms[:-1] if found[2] == "theirs" and len(rooms) > 1 else rooms
    return f"{found[1]} {told[-1]}" if told else found.group()


def _off_it(text: str) -> str:
    """`three bedrooms off a corridor, two bathrooms off it too`: off the corridor, and so on along a list."""
    text = _HAS.sub(r"\1 \2, \3 off the \2", _WITH.sub(r"\2 off the \1", text))
    off = r"\1 the \2\3 off the \2"
    for pattern, words in ((_OFF_IT, off), (_LISTED, off), (_FRONTED, r"\1 the \2. the \2 leads to \3")):
        said = ""
        while said != text:
            said, text = text, pattern.sub(words, text)
    return text
