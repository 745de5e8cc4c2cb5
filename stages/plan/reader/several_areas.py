"""Areas that several rooms have together, and limits that none of them passes, in words the rules know."""

from apartgen.stages.plan.reader.pieces import AMOUNT, ROOM, SEVERAL, UNIT, reworded, rules

_ROOM = rf"(?:(?:(?:the|both|my|our|all) )?(?:{SEVERAL} )?(?:[a-z]+ )?{ROOM})"
_LIST = rf"{_ROOM}(?:, {_ROOM})*,? and {_ROOM}"
_SOME = rf"(?:{_LIST}|(?:(?:the|both|my|our|all) )?(?:{SEVERAL} )?(?:of the )?(?:bed|bath) ?rooms)"
_AREA = rf"(?:about |around |at least |at most )?{AMOUNT} ?{UNIT}"
_HAVE = (r"(?:have|has|measure|take(?: up)?|occupy|are|get|need|cover|come to|make up|should (?:have|be|measure)|must "
         r"(?:have|be|measure)|may have|to have)")  # fmt: skip
_SAID = rules((
    # "kitchen and living room share 30 m²", "have 30 m² in total", "have a combined area of 30 m²"
    (r"\b({some}),? (?:(?:that|which) )?(?:should |must |may |will |can )?"
     r"(?:share|add up to|sum up to|total|come to|make(?: up)?) (?:a total of |an area of )?({area})",
     r"\1 together \2"),
    (r"\b({some}),? (?:{have} )?({area}) (?:in total|in all|altogether|all together|all told|combined|total|"
     r"as a whole|in sum|taken together)\b(?! with)", r"\1 together \2"),
    (r"\b({some}),? {have} (?:a (?:total|combined|joint) (?:floor )?(?:area|size|surface) of|combined|a total of|"
     r"in total|altogether) ({area})", r"\1 together \2"),
    # "two bedrooms (12 + 10 m²)", "one is 14 and the other 10"
    (r"\(({amount}) ?\+ ?({amount})(?: ?\+ ?({amount}))? ?({unit})\)",
     lambda found: f"({', '.join(f'{n} {found[4]}' for n in found.groups()[:3] if n)})"),
    (r"(\bbed ?rooms[^.;]*?)\b(?:the )?one(?: of them)? (?:is|has|with|of) (\d{1,2})(?: ?{unit})?(?:,| and|, and) "
     r"(?:the )?(?:other|second)(?: one)?(?: is| has| with| of)? (\d{1,2})(?: ?{unit})?(?! ?(?:[a-z]|%|\d))",
     r"\1one of \2 m2 and the other of \3 m2"),
    # "must not be larger than 25 m² nor smaller than 18 m²"
    (r"\b(?:not|n't|neither) (?:be )?(?:larger|bigger|more|greater) than (?P<most>{amount})(?: ?{unit})?,? "
     r"(?:n?or|and not)(?: be)? (?:smaller|less) than (?P<least>{amount}) ?(?P<unit>{unit})",
     r"be between \g<least> and \g<most> \g<unit>"),
    (r"\b(?:not|n't|neither) (?:be )?(?:smaller|less) than (?P<least>{amount})(?: ?{unit})?,? "
     r"(?:n?or|and not)(?: be)? (?:larger|bigger|more|greater) than (?P<most>{amount}) ?(?P<unit>{unit})",
     r"be between \g<least> and \g<most> \g<unit>"),
    # "neither the study nor the kitchen should be larger than 9 m²"
    (r"\bneither ({room}) n?or ({room}) (?:should |must |may |can |is to |are to |is allowed to |needs to |has to )?"
     r"(?:be |is |are |have |has )?(?:larger|bigger|greater|more|exceed)(?: than)? (?=\d)",
     r"\1 and \2 should each be at most "),
    (r"\bneither ({room}) n?or ({room}) (?:should |must |may |can |is to |are to |is allowed to )?"
     r"(?:be |is |are |have |has )?(?:smaller|less|fewer)(?: than)? (?=\d)", r"\1 and \2 should each be at least "),
), some=_SOME, area=_AREA, have=_HAVE, room=_ROOM)  # fmt: skip


def of_several(text: str) -> str:
    """A folded text that says of how many square metres several rooms are, or none of them is."""
    return reworded(text, _SAID)
