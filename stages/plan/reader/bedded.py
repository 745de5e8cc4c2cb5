"""Where people sleep, and in what: `we sleep in the other, in a double bed`, `the twins have two single beds`."""

import re

from apartgen.stages.plan.reader.bed_lists import beds_listed
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, YOUNG, reworded, rules

_BED = (r"(?:(?:an?|one|two|three|four|their|[1-4]) )?"
        r"(?:(?:single|double|twin|bunk|king|queen|king-size|queen-size) )?beds?\b")  # fmt: skip
_YOUNG = rf"(?:{YOUNG}|{CHILD})"
_OLD = rf"(?:grandparents|{ELDER})"
_OWNED = rf"(?:(?:(?:the|our|my|both|two|three) )+(?:{_YOUNG}|{_OLD}|guests?|lodger|parents)|{_OLD})"
_WHICH = r"(?:the (?:other|second|third|small(?:er|est)?|big(?:ger|gest)?|larger?|largest)|another|one|a|their|our|my)"
_IN = rf"in {_WHICH}(?: one| (?:bed ?)?room)?"
_NAMED = r"(?:bed ?rooms?|ones?|others?|first|second|third|big(?:ger|gest)?|larger?|largest|small(?:er|est)?)"
_SHORT = r"(double|single|king|queen|bunk)s?(?= ?(?:[.,;]|$)| and\b| each\b)"
_SAID = rules((
    # "in one bedroom, in a bunk bed", "in the other in a double bed"
    (r"\b({in}),? in (?={bed})", r"\1 with "),
    # "the main bedroom has a king, the second a double"
    (r"\b({named} (?:each )?(?:has|have|gets?|needs?) (?:an?|one|two|three|four) ){short}", lambda found: _bed(found)),
    (r"(\bbeds?\b[^.;]*\bthe (?:main )?{named}(?: one| bed ?room)? (?:an?|one|two|three|four) ){short}",
     lambda found: _bed(found)),
    # "we share the kitchen and the living room"
    (r"(^|[.;,] ?|\band )(?:we|they|both of us|all of us)(?: all| both)? (?:will |can |would )?share "
     r"(?=the (?:kitchen|living|lounge|dining|sitting|bath ?room|hall|balcony))", r"\1"),
), bed=_BED, named=_NAMED, short=_SHORT, **{"in": _IN})  # fmt: skip
_TWO, _TWO_SLEEP = (late(
    rf"\b(?P<who>{_OWNED}|we|us|i|me){sleep} in one(?: (?:bed ?)?room| of them)?(?P<with>,? with [^.;,]*)?"
    rf"(?:,|;| and|, and) (?P<others>{_OWNED}|we|us|i|me){sleep} in the other(?: one| (?:bed ?)?room)?\b",
) for sleep in ("", r"(?: (?:will |can |should )?(?:sleeps?|stays?|lives?))?"))
_MY_WIFE = late(r"\b(?:(?:my|our) (?:wife|husband|partner|spouse|girlfriend|boyfriend) and (?:i|me)|"
                r"(?:i|me) and my (?:wife|husband|partner|spouse|girlfriend|boyfriend)) (?=(?:will )?sleep in )")
_SEVERAL = late(r"\b(?:two|three|four|five|[2-5])[ -]?(?:bed ?rooms|bed\b|br\b)")
_HAVE = r"(?:have|has|get|gets|need|needs|want|wants|sleep in|sleeps in|should have|must have)"
_THEIRS = [late(rf"\b(?:(?:the|our|my) )?({_YOUNG}|{_OLD}|guests?) {_HAVE} (?={_BED})"),
           late(rf"\bwe (?:have|get|sleep in) (?={_BED})(?![^.;]*\bthere\b)")]  # fmt: skip


def bedded(text: str) -> str:
    """A folded text with the beds that people sleep in, in the rooms that they have."""
    text = _TWO.sub(_two, reworded(beds_listed(text), _SAID))
    if _SEVERAL.search(text) is None:
        return text
    text = _TWO_SLEEP.sub(_two, _MY_WIFE.sub("we ", text))
    theirs, ours = _THEIRS
    said = theirs.sub(lambda found: f"{_whose(found[1])} has ", text)
    return ours.sub("the parents' bedroom has ", said)


def _bed(found: re.Match[str]) -> str:
    """The bed or beds of `has a double`, `two singles`."""
    return f"{found[1]}{found[2]} {'bed' if found[1].split()[-1] in ('a', 'an', 'one') else 'beds'}"


def _two(found: re.Match[str]) -> str:
    """`the twins in one with bunk beds, us in the other` as the rooms of both."""
    return f"{_whose(found['who'])}{found['with'] or ''}, {_whose(found['others'])}"


def _whose(people: str) -> str:
    """The bedroom of people."""
    who = people.split()[-1]
    if who in ("we", "us", "i", "me", "parents"):
        return "the parents' bedroom"
    if who in ("guest", "guests"):
        return "the guest room"
    if re.fullmatch(_YOUNG, who) is None:
        return "the relative's bedroom"
    return f"the {who}' bedroom" if who.endswith("s") else f"the {who}'s bedroom"
