"""Furniture asked for, in words that people have for it, put into those the rules know."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_A = r"(?:an?|one|two|three|four|the|some|\d)"
_HOME = r"(?:flat|apartment|home|house|place|kitchen|room|bed ?room|bath ?room|lounge|living|family|layout|studio)"
_TWO_BEDROOMS = re.compile(r"\b(?:two|2)[ -]bed(?: ?rooms?)?\b")
_BED = r"(?:single|double|bunk|twin|king|queen)"
_NO_ROOM = rf"(?!(?:[a-z-]+ )?{_HOME}s?\b)"


def _one_of(found: re.Match[str]) -> str:
    """`two bedrooms. … In one bedroom a desk, in the other a wardrobe`: in one of the two."""
    if not _TWO_BEDROOMS.search(found.string[: found.start()]):
        return found.group()
    return f"{found['a']}one of the bedrooms has {found['x']}, the other one has {found['y']}"


_SAID = rules((
    # "a comfortable sofa", "a pair of single beds", "a couple of desks", "an eat-in table"
    (r"\b({a}) (?:comfortable|comfy|proper|decent|sturdy) (?={no_room})", r"\1 "),
    (r"\ba (?:pair|couple) of (?={bed} beds\b)", "two "),
    (r"\ba couple of (?=[a-z]+s\b){no_room}", "two "),
    (r"\ba kitchen table\b( for (?:two|three|four|five|six|eight|\d+)(?: people| persons)?)?",
     r"a table\1 in the kitchen"),
    # "main bedroom - a desk", "room for a sofa"
    (r"(?:^|(?<=[.;,\n] )|(?<=\n))((?:the )?{kind}) - (?={a} {no_room})", r"\1: "),
    (r"(?:^|(?<=[.;\n] ))(?:enough )?(?:room|space) for (?={a} {no_room})", ""),
    # "equip the kitchen with an oven", "the hall ought to have a bench", "a wardrobe belongs in the hall"
    (r"\b(?:please )?(?:equip|furnish|fit out|provide|supply) (the {kind}) with (?={a} )", r"\1 has "),
    (r"\bought to (?=have\b|be\b)", "should "),
    (r"\b(?:please )?(?:make sure|ensure|see to it)(?: that)? (?=the {kind} (?:has|have|gets|is|can)\b)", ""),
    (r"\b(?:must|should|has to|is to|have to|will|shall) (?:go|stand|be put|be placed) "
     r"in(?:to)? (?=the {kind}{end})", "is in "),
    (r"(?:^|(?<=[.;\n] ))((?:an?|two|three|four|\d) (?!{kind}){no_room}[^.;]*?) (?:must|should) be in "
     r"(?=the {kind}{end})", r"\1 in "),
    (r"\b(the {kind}) (?:needs|has|is|ought) to have (?={a} {no_room})", r"\1 has "),
    (r"\b(the {kind}) (?:must|should|shall|will|has to) (?:contain|include|feature) (?={a} )", r"\1 has "),
    (r"(?:^|(?<=[.;\n] ))(?![^.;]*\b(?:doors?|entrance|access|exit|m2|sqm|square|[a-z]*rooms?)\b[^.;]* for )"
     r"((?:an?|two|three|four|\d) (?!{kind})[^.;]*?) for (the {kind}|(?:each|every) bed ?room){end}", r"\1 in \2"),
    (r"\b(?:belongs|goes|stands) in(?:to)? (?=the {kind}{end})", "is in "),
    (r"\b(the {kind}) (?:must |should )?(?:has|have|needs) (?:room|space) for (?={a} )", r"\1 has "),
    (r"\b(?:there (?:is|has to be|must be|should be)|(?:i|we) (?:want|need)) (?:enough )?(?:room|space) for "
     r"(?={a} {no_room})", "there is "),
    (r"\b(?:that|which) (?:must|should|has to|have to|needs? to) fit(?: in)?{end}", ""),
    (r"\b(?:i'm|i am|we're|we are|i|we) (?:bringing|bring) (?=(?:an?|our|my|two) )", "we have "),
    (r"\bit (?:must|should|has to|needs to) fit (?={a} {no_room})", "it has "),
    # "for the main bedroom I'd like a desk", "add two bookshelves to the bedroom"
    (r"(?:^|(?<=[.;\n] ))for (the {kind}),? (?:(?:i|we)(?:'d like| would like| want| need) )?(?={a} {no_room})",
     r"\1 has "),
    (r"\badd ({a} [^.;]*?) to (the {kind}){end}", r"put \1 in \2"),
    # "the hall won't have a bench", "there must not be a bathtub", "in the kitchen, no washing machine"
    (r"\b(the {kind}) (?:won't|will not|cannot|can't|shall not|doesn't need(?: to)?|does not need(?: to)?) (?:have )?"
     r"(?=(?:an?|any) {no_room})", r"\1 does not have "),
    (r"\bthere (?:must|should|shall|may|can) not be (?=(?:an?|any) {no_room})", "there is not "),
    (r"\bin (the {kind})(?:,| there (?:is|are|should be|must be)) no (?={no_room})", r"\1 has no "),
    # "a desk in all bedrooms", "in one bedroom a desk, in the other a wardrobe"
    (r"\bin (?:all|both) (?:of )?(?:the |our )?bed ?rooms\b", "in each bedroom"),
    (r"\bin the (?P<m>first|main|master|larger|bigger) bed ?room,?(?: there (?:is|are))? (?P<x>{a} [^.;,]*?),? "
     r"(?:and )?in the (?P<n>second|other|smaller)(?: one| bed ?room)?,?(?: there (?:is|are))? "
     r"(?P<y>{a} [^.;,]*?){end}", r"the \g<m> bedroom has \g<x>, the \g<n> bedroom has \g<y>"),
    (r"(?P<a>^|[.;\n] ?)in one bed ?room,?(?: there (?:is|are))? (?P<x>{a} [^.;,]*?),? (?:and )?in the other"
     r"(?: one| bed ?room)?,?(?: there (?:is|are))? (?P<y>{a} [^.;,]*?){end}", _one_of),
    (r"(?P<a>^|[.;\n] ?)(?P<x>{a} [^.;,]*?) in one bed ?room,? (?:and )?(?P<y>{a} [^.;,]*?) in the other"
     r"(?: one| bed ?room)?{end}", _one_of),
    (r"(?P<a>^|[.;\n] ?)one bed ?room with (?P<x>{a} [^.;,]*?),? and one with (?P<y>{a} [^.;,]*?){end}", _one_of),
), a=_A, bed=_BED, no_room=_NO_ROOM)  # fmt: skip


def in_things(text: str) -> str:
    """A folded text with its furniture asked for so."""
    return reworded(text, _SAID)
