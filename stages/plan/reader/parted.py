"""Clauses within clauses and doors said last, parted into sentences of their own."""

import re

from apartgen.stages.plan.reader.patterns import late

_ROOM = (
    r"(?:(?:living|sitting|dining|laundry|utility|storage|guest|main|master|bed|bath) ?(?:bed)?room|kitchen|study|"
    r"balcony|lounge|toilet|office|hall(?:way)?|corridor|pantry)"
)
_BOTH = rf"between (?:the )?{_ROOM} and (?:the )?{_ROOM}\b"
_SAID = [(late(pattern), words) for pattern, words in (
    # "the living room, which has the balcony too, must have three doors"
    (rf"(?<![a-z] )\b((?:the|my|our) {_ROOM}), (?:which|that) ((?:also )?"
     r"(?:has|is|leads|opens|faces|lies|connects|gets|needs|must|should)\b[^.;:]*?), "
     r"(?=(?:must|should|shall|has|is|needs|gets|faces|measures|opens|leads|lies|can|may|will)\b)", r"\1 \2. \1 "),
    # "all open off the hallway, and there is also a door between the kitchen and the living room"
    (r"(?:,? (?:and|but|plus)(?: there(?: is|'s| should be| must be)| with)?|, with) (?:also |additionally )?"
     rf"(?:an?|another|one) (?:second |further |more |direct |additional |connecting )?door "
     rf"(?:also |as well )?(?={_BOTH})",
     ". there is a door "),
    # "a bedroom has no door to the hall, only one to the bathroom"
    (rf"\b((?:the|my|our) {_ROOM}) (?:has|should have|must have) no doors? to (?:the )?({_ROOM}),? "
     rf"(?:only|just|but|but only) (?:one|a door|one door) to (?:the )?({_ROOM})\b",
     r"\1 has no door to the \2. \1 has a door to the \3"),
    # "starts in the study, which has no door to the hall"
    (rf"(?<= in )(the {_ROOM}), (?:which|that) has (no doors?|a door) to ", r"\1. \1 has \2 to "),
    # "a door to the living room but none to the hallway"
    (rf"(\bdoors? (?:to|into) (?:the |an? )?{_ROOM}),? (?:but|and) (?:none|no door|no doors|not one|no other) "
     r"(?:to|into|towards) ", r"\1 but not to "),
)]  # fmt: skip


def parted(text: str) -> str:
    """A folded text with such clauses behind one another."""
    for pattern, words in _SAID:
        text = pattern.sub(words, text)
    return text
