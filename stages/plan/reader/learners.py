"""English as those write it who learn it, in the words and the order of those who do not."""

import re

from apartgen.stages.plan.reader.patterns import late

_ROOM = r"(?:bed ?room|bath ?room|living room|dining room|kitchen|balcony|hall|study|toilet|room|lounge|corridor)"
_LIVING = re.compile(r"\b(?:living|lounge|sitting|main room|salon)")


def _big_room(found: re.Match[str]) -> str:
    """`hall, kitchen, big room and bedroom`: the big one is the living room, where none is named."""
    return found.group() if _LIVING.search(found.string) or "bedroom" not in found.string else f"{found[1]}living room"


_SAID = [(late(pattern), words) for pattern, words in (
    # "kitchen no have door", "there is not balcony", "it is not balcony"
    (r"\b(no|not) (have|has) (?:an? |any )?", "has no "),
    (r"\b(?:there is|there are|it is) not (?:an? |any )?(?=(?:balcony|hall|corridor|study|dining|toilet|pantry|"
     r"storage|tv|sofa|"
     r"table|desk|bathtub|[a-z]+room)\b)", "there is no "),
    # "Big room is 25 meters", "kitchen of 10 meters"
    (rf"({_ROOM}) ?(is|are|has|of|about|:|,|-)? ?(about )?(\d{{1,2}}(?:\.\d)?) met(?:er|re)s?\b(?! ?(?:long|wide|by|x|"
     rf"high|from|away|"
     r"square|deep|in|of|and \d))", r"\1 \2 \3\4 m2"),
    (rf"(^|[.;,] ?)({_ROOM}) (is|must be|should be) (?!one\b|two\b|three\b|for\b|\d (?:room|bed)|in the plan)",
     r"\1the \2 \3 "),
    (r"\b((?:the |one |a )?)(?:big|large|great) room(?= ?(?:[.,;]|is|and|with|$))", _big_room),
    # "balcony not in bedroom but in kitchen"
    (rf"\b((?:the |an? )?(?:balcony|terrace|closet|pantry|storage room)) not (?:in|off|on|at) (?:the |an? )?{_ROOM},? "
     rf"but "
     rf"(?:in|off|on|at) (?:the |an? )?({_ROOM})\b", r"\1 off the \2"),
    # "two balcony: one on living room, second on bedroom"
    (rf"\b(?:two|2) (balcony|balconies|terraces?)[:,] (?:one|first) (?:on|in|at|from|off|near) (?:the )?({_ROOM}),? "
     rf"(?:and )?(?:the )?"
     rf"(?:second|other|one|another|the other)(?: one)? (?:on|in|at|from|off|near) (?:the )?({_ROOM})\b",
     r"a balcony off the \2 and another balcony off the \3"),
    # "in living room not must be table"
    (r"\bnot (must|should|can|may) be\b", r"\1 not be"),
    (rf"(^|[.;,] ?|\band )(?:in|at) (?:the |my )?({_ROOM}) (?:there )?(?:must|should|can|may) not (?:be|have) (?:an? |"
     rf"any )?"
     r"([a-z]+)", r"\1no \3 in the \2"),
    # "bathroom must have the door from bedroom, but also second door from corridor"
    (rf"({_ROOM}) (?:must |should )?(?:has|have) (?:the |an? |one )?door (?:from|to|in) (?:the )?({_ROOM}),? (?:but |"
     rf"and )?(?:also )?(?:the |an? )?"
     rf"(?:second|another|other|one more|one)(?: door)? (?:from|to|in) (?:the )?({_ROOM})", r"\1 has a door to the \2 "
     r"and a door to the \3"),
    (rf"({_ROOM}) without (?:an? |the )?doors? to (?:the )?{_ROOM},? (?:but )?only to (?:the )?({_ROOM})",
     r"\1 reached only from the \2"),
    # "in one bedroom two bed, in other one bed", "balcony for kitchen"
    (r"\bin (?:the )?one (?:bed ?room )?(two|three|one|an?) (?:single |double )?beds?,? (?:and )?in (?:the )?(?:other|"
     r"second|another)"
     r"(?: one| bed ?room)? (one|two|an?) (?:double |single )?beds?\b", r"the first bedroom has \1 double beds, the "
     r"second bedroom has \2 double bed"),
    (rf"\b(balcony|terrace) for (?:the )?({_ROOM})\b", r"\1 off the \2"),
    (rf"(\boff the {_ROOM}[.,;] ?(?:(?:no|sorry|actually|rather|better|wait),? )+)for the (?={_ROOM})", r"\1off the "),
    # "in bedroom stay bed and table for work", "the third is smallest", "no need balcony"
    (rf"(^|[.;] ?)in (?:the |my )?({_ROOM}) (?:must |should )?(?:stays?|stands?|is standing|are standing) (?=[a-z])",
     r"\1the \2 has "),
    (r"\btable for (?:work|working|study|studying|writing)\b", "desk"),
    (r"\b(is|are) (smallest|largest|biggest)(?= ?(?:[.,;]|$))", r"\1 the \2"),
    (r"\bno need (?:of |for |to have )?(?:an? )?(?=[a-z])", "no "),
    (rf"(?:^|[.;,] ?)(?:and )?in (?:the )?({_ROOM}) ((?:an? |one |two )?[a-z]+) and no ([a-z]+)(?= ?(?:[.,;]|$))",
     r". the \1 has \2 and no \3"),
    # "not make the kitchen open"
    (r"\b(?:please )?(?:do not|don't|not|never|no) (?:to )?(?:make|want|have|leave|like) (?:the |an? )?kitchen (?:to "
     r"be |be |which is )?"
     r"open\b(?! to)", "separate kitchen"),
    # "the bathroom is entering from the bedroom"
    (r"\b(is|are) (entering|accessing|reaching) from\b", r"\1 entered from"),
    (r"\b(from|to) ((?:the )?[a-z]+) and (?:from|to) ((?:the )?[a-z]+) (?:also|too)\b", r"\1 \2 and \1 \3"),
)]  # fmt: skip


def as_learnt(text: str) -> str:
    """A folded text with such clauses put right."""
    for pattern, words in _SAID:
        text = pattern.sub(words, text)
    return text
