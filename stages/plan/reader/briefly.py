"""Statements in a noun's place: `3 bathrooms with one of them ensuite`, `separated from it by a door`."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_SAID = rules((
    # "Home office layout: study 14 m2 …": the kind of home, no study beside the one that follows
    (r"^(?:an? |my |the |our )?(?:home |small )*office (?:layout|plan|floor ?plan|flat|apartment|home|house|set-?up|"
     r"scene|design)s? ?[:-] ?(?=[^:]*\b(?:study|(?:home )?office)\b)", ""),
    # "3 bathrooms with one of them ensuite to the master bedroom"
    (r"(?P<rooms>\bbath ?rooms?),? (?:(?:with|where) one|and one of (?=them|which|these))(?: ?(?:of )?(?:them|which|"
     r"these))? (?:is |being |as )?(?:an )?"
     r"en[ -]?suite (?:to|of|for|in|off|with) (?P<of>(?:the |my |our )?(?:master|main|primary|principal|parents'?)"
     r"(?: bed ?room)?)", r"\g<rooms>, one of which is ensuite to \g<of>"),
    # "kitchen separated from living room by a door", "a door separates the kitchen from the living room"
    (r"\b(?P<a>(?:the |an? )?{kind}),? (?:that |which )?(?:(?:is|{must} be) )?(?:separated?|divided|closed off|"
     r"shut off|cut off|parted) from (?P<b>(?:the |an? )?{kind}) (?:by|with|through) (?:an? |one )?"
     r"(?:(?:sliding|glass|single|simple|wooden|closing) )*door\b", r"\g<a>, a door between \g<a> and \g<b>"),
    (r"\b(?:an? |one )?(?:sliding |glass |single )*door (?:{must} )?(?:separat|divid|part)(?:es?|ing) (?P<a>(?:the "
     r")?{kind}) from (?P<b>(?:the )?{kind})", r"\g<a> has a door to \g<b>"),
    # "two bedrooms, a door between the kitchen and the living room": what is named before lies nowhere between
    (r"(?<=[,;.] )(?:an? |one )door between (?P<a>(?:the )?{kind}) and (?P<b>(?:the )?{kind})(?={end})",
     r"\g<a> has a door to \g<b>"),
    # "bedrooms at the opposite end of the corridor from the kitchen"
    (r"\b(?:(?:at|on|in|to) )?the (?:opposite|other|far|further) (?:end|side)s? of (?:the |a )?(?:{hall}|flat|"
     r"apartment|house|home|plan),? (?:away )?(?:from|to|than|as) (?=(?:the )?{kind})", "far from "),
))  # fmt: skip


def briefly(text: str) -> str:
    """A folded text with such statements as clauses."""
    return reworded(text, _SAID)
