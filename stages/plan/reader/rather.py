"""Rooms, places and things that are to be others than those first named: `make one of the bedrooms a study`."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_COUNTED = re.compile(r"\b(two|three|four|five|[2-5])[ -]?(?:bed ?rooms?|bed\b|br\b)")
_LAST = {"two": "second", "2": "second", "three": "third", "3": "third", "four": "fourth", "4": "fourth",
         "five": "fifth", "5": "fifth"}  # fmt: skip


def _the_last(found: re.Match[str]) -> str:
    """`make one of the bedrooms a study` as the last of those counted."""
    counted = _COUNTED.search(found.string[: found.start()])
    return f". make the {_LAST[counted[1]]} bedroom {found[1]}" if counted else found.group()


def _several(found: re.Match[str]) -> str:
    """`each bedroom gets a wardrobe, the main one two`."""
    thing = found["thing"]
    many = thing if thing.endswith("s") else f"{thing}s"
    return f"{found['each']}, {found['one']} has {found['n']} {many}"


def _one_fewer(found: re.Match[str]) -> str:
    """`two sofas in the lounge, one of them a corner sofa` as one of each."""
    fewer = {"two": "one", "three": "two", "four": "three", "2": "1", "3": "2", "4": "3"}[found["n"]]
    thing = found["thing"][:-1] if fewer in ("one", "1") else found["thing"]
    return f"{fewer} {thing} and {found['other']}{found['where'] or ''}"


_SAID = rules((
    # "actually the study can be left out", "hmm, better without"
    (r"\b(?:the|that) ({kind}) (?:can|may|could|should|must) (?:also )?(?:be (?:left out|omitted|dropped|skipped|"
     r"removed)|stay out){end}", r"forget the \1"),
    (r"(?P<begins>[.;,] ?|^)(?:(?:hmm+|no|actually|well|or|on second thoughts?|rather),? )*"
     r"(?:better|rather|preferably) without(?: it| one| that)?{end}", r"\g<begins>skip that"),
    # "change the second bath to a toilet", "make one of the bedrooms a study instead"
    (r"\b(?:change|turn|convert|make) the ((?:second|third|other) bath(?: ?room)?)(?: (?:in)?to)? "
     r"(an? (?:separate )?(?:toilet|wc|guest toilet))(?: instead)?", r"the \1 is \2"),
    (r"\b(?:change|turn|convert|make) one of the bed ?rooms(?: (?:in)?to)? (an? {kind})(?: instead)?{end}",
     _the_last),
    (r"(?:,? and )?\bthe (?:smallest|third|fourth|last|other)(?: one| bed ?room)? (?:{must} )?(?:becomes?|be turned "
     r"into|turns? into|be converted (?:in)?to) (an? (?:home )?{kind}){end}", _the_last),
    # "not an open kitchen but a separate one"
    (r"\bnot an open(?:[- ]plan)? kitchen,? but (?:rather )?an? (?:separate|closed)(?: one| kitchen)?",
     "a separate kitchen"),
    # "the washing machine should not be in the bathroom but in the kitchen"
    (r"\bthe ([a-z ]{3,18}?) {not} (?:be |go |stand |be put )?(in {the}),? but (?:rather )?(in {the})",
     r"a \1 \3, not \2"),
    # "in the north-east one", "the first door on the right is the bathroom, the second the kitchen"
    (r"\bin the ((?:north|south)-?(?: )?(?:east|west)|top left|top right|bottom left|bottom right) one\b",
     r"in the \1 corner"),
    (r"\bthe (?:first|next) door on (?:the|your) (left|right) (?:is|leads to|goes to|is that of) ({the}),? "
     r"(?:and )?the (?:second|next|other)(?: one| door)?(?: is| leads to| to)? ({the}){end}",
     r"\2 is on the \1, \3 is on the \1"),
    (r"\bthe (?:first|second|third|next|last|only) door on (?:the|your) (left|right) "
     r"(?:is|leads to|goes to|is that of) ({the})", r"\2 is on the \1"),
    # "at the opposite end of the flat from the bedrooms", "a third of the size of the bedroom"
    (r"\b(?:at|on) the (?:opposite|other|far) (?:end|side) of the (?:flat|apartment|home|house|plan) (?:from|to) ",
     "far from "),
    (r"\b(half|a third|a quarter|two thirds|three quarters) of the size of\b", r"\1 the size of"),
    # "at least 60 m² but no more than 70"
    (r"\b((?:at least|not less than|no less than|minimum) \d+ ?(m2|sqm|sq ?ft|square (?:met(?:er|re)s|feet)),? "
     r"(?:and|but) (?:at most|no more than|not more than|below|under|less than|max(?:imum)?)) (\d+)"
     r"(?! ?(?:m2|sq|square|m\b|%|\d|[a-z]))", r"\1 \3 \2"),
    # "a door to each bedroom but none to the hall"
    (r"(\bdoors? (?:in)?to (?:each|both|every|either)(?: of the)? {kind}s?),? (?:but|and) (?:none|no door|not one) "
     r"(?:in)?to ", r"\1 but not to "),
    # "three beds: a double in the main bedroom and two singles in the other"
    (r"\b(?:two|three|four|five|[2-5]) beds ?: (?=(?:an?|one|two) (?:double|single))", ""),
    (r"\b(an?|one) (double|single)(?= in (?:the|my|our|one|each) )", r"\1 \2 bed"),
    (r"\b(two|three|2|3) (single|double|twin)s(?= in (?:the|my|our|one|each) )", r"\1 \2 beds"),
    # "each bedroom gets a wardrobe, the main one two", "two sofas, one of them a corner sofa"
    (r"\b(?P<each>(?:each|every) (?:bed ?)?room (?:has|gets|should have|needs) (?:an?|one) (?P<thing>[a-z]+)),? "
     r"(?:and |but )?(?P<one>the (?:main|master|largest|biggest|guest|first|second) (?:one|bed ?room)?) ?"
     r"(?P<n>two|three|four|[2-4]){end}", _several),
    (r"\b(?P<n>two|three|four|[2-4]) (?P<thing>[a-z]+s)(?P<where> in {the})?,? "
     r"(?:one of them|of which one is|one being) (?P<other>an? [a-z ]{3,20}?){end}", _one_fewer),
))  # fmt: skip


def rather(text: str) -> str:
    """A folded text that names the rooms, places and things that are meant."""
    return reworded(text, _SAID)
