"""Rooms that were counted before and are told of without an article: `Bedrooms: 2. … Child's bedroom needs a desk.`"""

from apartgen.stages.plan.reader.pieces import reworded, rules

_COUNTED = r"(?:\b(?:{number} bed ?rooms?\b|bed ?rooms? ?: ?\d)[^§]{{0,240}}?)".format(number="(?:two|three|"
                                                                                              "four|five|[2-5])")
_OWNER = (r"(?:(?:child|kid|baby|son|daughter|boy|girl|teenager|toddler|guest|grandma|grandmother|mother)(?:'s)?|"
          r"(?:children|kids|boys|girls)'?s?)")  # fmt: skip
_SAID = rules((
    # "Bedrooms: 2. Child's bedroom needs a desk."
    (r"(?P<before>{counted}[.;\n] ?)(?P<room>{owner} (?:bed ?)?room)(?= (?:needs?|has|must|should|gets|is|wants|faces|"
     r"looks|lies|next to|beside|near|close to|away from|far from)\b)", r"\g<before>the \g<room>"),
    # "Need two bedrooms, baby room next to our bedroom"
    (r"(?P<before>{counted}, )(?P<room>{owner} (?:bed ?)?room)(?= (?:is |must be |should be )?(?:next to|beside|near|"
     r"close to|opposite|away from|far from) (?:our|my|ours|mine|the parents)\b)", r"\g<before>the \g<room>"),
), counted=_COUNTED, owner=_OWNER)  # fmt: skip


def once_counted(text: str) -> str:
    """A folded text with such rooms as known ones."""
    return reworded(text, _SAID)
