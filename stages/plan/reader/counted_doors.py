"""How many doors a room is to have: `has only one door`, `no second door`, `needs two doors`, in words of limits."""

import re

from apartgen.stages.plan.reader.pieces import ROOM, reworded, rules

_ROOM = rf"(?:(?:[a-z]+ )?{ROOM})"
_THE = rf"(?:(?:the|my|our|each|every|both) )?(?P<room>{_ROOM})"
_ALONE = (r"(?:(?:only|just|exactly|precisely) (?:one|1|a)(?: single)? door|"
          r"(?:one|1) single door|a single door|(?:one|1) (?:only )?door (?:only|alone)|(?:one|1) only door|"
          r"only (?:one|1) door)(?: only)?")  # fmt: skip
_END = r"(?= ?(?:[.,;:!?)]|$)| and (?!one\b|it\b|that\b)| but | so | while )"
_MANY = r"(?P<n>two|three|four|2|3|4)"
_TOLD_OFF = r"(?! ?[,:;(-]* ?(?:one|to|into|from|the first|a door|each|that|which|off|on|between)\b)"
_DIGITS: dict[str, str] = {
           "zwei": "2", "drei": "3", "vier": "4", "deux": "2", "trois": "3", "quatre": "4", "dos": "2", "tres": "3",
           "cuatro": "4", "两": "2", "三": "3", "四": "4"}  # fmt: skip
_LEAST = re.compile("least|less|fewer|min")
_SAID = rules((
    # "the kitchen has only one door, to the living room", "…, which leads to the living room"
    (r"\b(?:{must} )?{has} (?:{alone},?|(?:one|1) door,|(?:one|1) door(?= which| that)) (?:and )?"
     r"(?:(?:which|that|it) (?:leads?|opens?|goes|is|should lead|must lead|should open|must open) )?"
     r"(?:to|into|onto|from|towards|on) (?=(?:the )?{room}\b(?!,? and (?:one|another|a|to|from)\b))",
     "is reached only from "),
    # "only one door to the kitchen", "no second door into the bathroom"
    (r"(?P<begins>^|[.;:,] ?|\band )(?:there (?:is|must be|should be|may be|can be|shall be) )?(?:to be )?"
     r"(?:{alone}|one door) (?:to|into|in|for|of) {the}(?: is enough| is plenty| will do| suffices|,? please)"
     r"{end}", r"\g<begins>the \g<room> has at most one door"),
    (r"(?P<begins>^|[.;:,] ?|\band )(?:there (?:is|must be|should be|may be|can be|shall be) )?{alone} "
     r"(?:to|into|in|for|of) {the}{end}", r"\g<begins>the \g<room> has at most one door"),
    (r"(?P<begins>^|[.;:,] ?|\band )(?:(?:please|there (?:is|must be|should be)) )?(?:no|not a|without a) "
     r"(?:second|other|further|extra|additional) door (?:to|into|in|for|of) {the}{end}",
     r"\g<begins>the \g<room> has at most one door"),
    # "no bedroom has more than one door", "no bedroom with a second door"
    (r"\bno (?P<room>{room}) (?:{must} )?(?:{has}) (?:more than one door|two doors|a second door|several doors)"
     r"{end}", r"each \g<room> has at most one door"),
    # "should not have a second door", "has no second door", "does not need a second door"
    (r"\b(?:{must} not|cannot|can't|mustn't|shouldn't|does not|doesn't|do not|don't) (?:have|get|need|want) "
     r"(?:a second|another|two|any other|any second) doors?{end}", "has at most one door"),
    (r"(?<!which )(?<!that )\b(?:has|have|gets?|needs?|with) no (?:second|other|further|extra) doors?{end}",
     "has at most one door"),
    (r"\bwithout (?:a|any) (?:second|further|other|extra) door{end}", "with at most one door"),
    # "has only one door", "one door only", "a single door"
    (r"\b{alone}{end}", "at most one door"),
    # "needs two doors", "has exactly three doors"
    (r"\b(?P<has>(?:{must}) have|needs?|gets?|wants?) (?:exactly |precisely )?{many} doors{told_off}{end}",
     r"has at least \g<n> doors"),
    (r"\b(?P<room>{room}) (?P<has>has|have|with) (?:exactly |precisely )?{many} doors{told_off}{end}",
     r"\g<room> \g<has> at least \g<n> doors"),
    # "every room has two doors", "each room connects to two others"
    (r"\b(?:every|each|all)(?: of the)? rooms? (?:{must} )?{has} (?:at least |exactly )?{many} doors{told_off}{end}",
     r"every room has at least \g<n> doors"),
    (r"\b(?:every|each|all)(?: of the)? rooms? (?:{must} (?:be )?|is |are |(?:{must} )?{has} (?:a )?doors? )?"
     r"(?:directly )?(?:connects?|connected|leads?|linked|opens?|joined)?(?: directly)? ?(?:to|into|with) "
     r"(?:at least )?{many} (?:others?|(?:other |different |neighbou?ring )?rooms|neighbou?rs){end}",
     r"every room has at least \g<n> doors"),
    # "the kitchen can be reached from two different rooms"
    (r"\b(?P<of>the {kind}) (?:(?:{must} |is |are )(?:be )?)?(?:reached|entered|accessible|accessed|reachable) from "
     r"(?:at least )?{many} (?:(?:different|other|separate) )?(?:rooms|sides|places|directions)\b",
     r"\g<of> has at least \g<n> doors"),
    # "no more than two rooms may open off the living room"
    (r"\b(?P<limit>{least}|{most}|only|exactly) (?P<n>{number}) rooms? (?:{must} )?(?:be )?(?:opens?|leads?|have a "
     r"door|reached|entered|accessible)(?: directly)? (?:off|from|on ?to|in ?to|to) (?P<of>the {kind}){end}",
     lambda found: f"{found['of']} has at {'least' if _LEAST.search(found['limit']) else 'most'} {found['n']} doors"),
    # "nur eine Tür", "n'a qu'une seule porte", "una sola puerta", "只有一扇门"
    (r"\b(?:nur|bloss|hochstens|maximal|lediglich|genau) eine(?: einzige)? tur\b(?! (?:zu|in|nach|vo))",
     "hochstens 1 turen"),
    (r"\bhochstens (zwei|drei|vier) turen\b", lambda found: f"hochstens {_DIGITS[found[1]]} turen"),
    (r"\bn'(?:a|aura|ait) qu'une(?: seule)? porte\b(?! (?:vers|sur|dans|donnant))", "a au plus 1 portes"),
    (r"\b(?:au plus une|une seule) porte\b(?! (?:vers|sur|dans|donnant))", "au plus 1 portes"),
    (r"\bau plus (deux|trois|quatre) portes\b", lambda found: f"au plus {_DIGITS[found[1]]} portes"),
    (r"\b(?:(?:solo|solamente|unicamente) (?:tiene|tenga) una|(?:tiene|tenga) (?:solo|solamente|como maximo) una|"
     r"(?:tiene|tenga) una (?:sola|unica)) puerta\b(?! (?:al?|hacia|que))", "tiene como maximo 1 puertas"),
    (r"\bcomo maximo (dos|tres|cuatro) puertas\b", lambda found: f"como maximo {_DIGITS[found[1]]} puertas"),
    (r"(?:只能有|只有|只要|只开|最多有?|仅有?)(?:一|1)(?:扇|个|道)门(?!通|到|开)", " at most one door"),
    (r"最多有?(两|三|四|2|3|4)(?:扇|个|道)门", lambda found: f" at most {_DIGITS.get(found[1], found[1])} doors"),
), alone=_ALONE, room=_ROOM, the=_THE, end=_END, many=_MANY, told_off=_TOLD_OFF)  # fmt: skip


def doors_counted(text: str) -> str:
    """A folded text that says how many doors a room has in words of limits."""
    return reworded(text, _SAID)
