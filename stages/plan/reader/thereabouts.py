"""Furniture whose room is told behind it: `the freezer goes there`, `put both in the lounge`, `in the first`."""

import re

from apartgen.stages.plan.reader.hers import whose_rooms
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import KIND, reworded

_NAMED = re.compile(rf"\b({KIND})\b(?:(?:,? (?:which|that) (?:is|opens|lies))? (?:off|next to|near|beside|behind|"
                    rf"opposite|"
                    rf"adjacent to|from|onto) (?:the |an? |my )?{KIND}\b)?")  # fmt: skip
_THING = r"(?:(?:an?|my|our|his|her|the|two|three|four|five|six|\d) [a-z]+(?:[ -][a-z]+){0,2}?)"
_THINGS = re.compile(rf"(?:^|[.;:!?] ?)([^.;:!?]*?{_THING}(?:(?:,|,? and) {_THING})*)$")
_GOES = r"(?:goes|go|belongs|belong|should go|must go|will go|are to go|is to go|should stand|will stand|must stand)"
_IN_ALL = late(
    r" ?[.;:,] ?(?:and )?(?:please )?(?:(?:put|place|set|keep) (?:both|them|them both|all(?: of them| three)?|these)"
    r"(?: of them)?|(?:both|they|these|all(?: of them)?)(?: both| all)? "
    rf"(?:{_GOES}|stay|stand|should be|must be|are to be|will be|are)) (?:both |all )?in(?:to)? (?=(?:the|my|our) "
    rf"{KIND}\b)"
)
_THERE = late(rf"(?:\b|(?<=[.;:] )|^)((?:{_THING}|(?:(?<=[.;:] )|^)[a-z]+(?: [a-z]+)?(?:, [a-z]+(?: [a-z]+)?)*(?:,? "
              rf"and [a-z]+(?: [a-z]+)?)?)(?:(?:,|,? and) {_THING})*) (?:{_GOES}|will be|should be|must be) (?:in )?("
              rf"?:there|in it|"
              rf"in that room)\b")
_PUT_THERE = late(rf"\b(in (?:the|our|my) (?:[a-z']+ )?{KIND})\b([^.;:]{{0,30}}?)[.:;,] ?(?:(?:and|so) )*(?:please )?"
                  r"(?:place|put|add|set up|set|plan|provide|foresee|(?:we|i) (?:need|want|would like)) ([^.;:]+?)"
                  r" there(?= ?(?:[.,;]|$))")  # fmt: skip
_DE = {"ersten": "first", "zweiten": "second", "dritten": "third", "vierten": "fourth", "anderen": "other"}
_FR = {"premiere": "first", "deuxieme": "second", "seconde": "second", "troisieme": "third", "autre": "other"}
_ES = {"primero": "first", "primera": "first", "segundo": "second", "segunda": "second", "tercero": "third",
       "tercera": "third", "otro": "other", "otra": "other"}  # fmt: skip
_WHICH = _DE | _FR | _ES
_ENDS = r"(?= ?(?:[.,;:]|$)| (?:und|et|y) )"
_SLEEPS = re.compile(r"\b(?:schlaf(?:e|en|t)|wohn(?:e|en|t)|dor[mt]\w*|duerm\w*|viv\w*|habit(?:e|ons|ent))\b[^.;,]*$")


def _which(found: re.Match[str]) -> str:
    """`im zweiten` as the second, unless somebody sleeps there, of whom others tell."""
    return found.group() if _SLEEPS.search(found.string[: found.start()]) else f"in the {_WHICH[found[1]]}"


def _in_ours(found: re.Match[str]) -> str:
    """`… in the guest room, a double bed in ours` as in our bedroom."""
    told = re.search(r"\b(?:bed ?rooms?|guest rooms?|nursery|kids'? rooms?|room)\b", found.string[: found.start()])
    return found.group() if told is None else f"in {'our' if found[1] == 'ours' else 'my'} bedroom"


def _in_none(found: re.Match[str]) -> str:
    """`neither of them has a tv` as no television in the rooms that were counted last."""
    before = found.string[: found.start()]
    counted = re.findall(r"\b(?:two|three|four|five|[2-5]) ([a-z]+ ?rooms|studies|balconies)\b", before)
    rooms = found[1] if found[1] != "them" else f"the {counted[-1]}" if counted else ""
    return f"no {found[2]} in {rooms}" if rooms else found.group()


_SAID = [(late(pattern), words) for pattern, words in (
    # "six chairs around the dining table, which stands in the lounge", "one double bed in ours"
    (r"\b((?:two|three|four|five|six|eight|[2-8]) chairs) (?:around|round|at) (the|an?|our|my) ((?:[a-z]+ )?table)\b",
     r"\2 \3 with \1"),
    (rf"\b((?:an?|the|my|our) (?!{KIND}\b)[a-z]+(?: [a-z]+)?(?: with [a-z]+ chairs)?), (?:which|that) (?:stands?|"
     rf"goes|is to stand|"
     rf"should stand|should go|must stand|belongs|is|should be|will be) in (?=(?:the|my|our) {KIND}\b)", r"\1 in "),
    (r"\bin (ours|mine)(?= ?(?:[.,;]|$)| and )", _in_ours),
    # "neither of them has a tv"
    (r"\b(?:neither|none) of (them|the (?:two |three )?[a-z]+ ?rooms) (?:has|have|gets?|needs?|should have|is to "
     r"have) (?:an? |any )?"
     r"(?!own|balcon|bath ?room|en|door|window|closet|toilet|view|access)([a-z]+(?: [a-z]+)?)(?= ?(?:[.,;]|$))",
     _in_none),
    # "ein Doppelbett im ersten, zwei Einzelbetten im zweiten", "dans la première", "en el segundo"
    (rf"\b(?:im|in dem) ({'|'.join(_DE)}){_ENDS}", _which),
    (rf"\bdans (?:la |l')({'|'.join(_FR)}){_ENDS}", _which),
    (rf"\ben (?:el|la) ({'|'.join(_ES)}){_ENDS}", _which),
)]  # fmt: skip


def thereabouts(text: str) -> str:
    """A folded text with such furniture in the rooms that are meant."""
    text = _all_in(whose_rooms(reworded(text, _SAID)))
    return _THERE.sub(_there, _PUT_THERE.sub(r"\1\2. \1 \3", text))


def _all_in(text: str) -> str:
    """`my sofa and my desk; put both in the study` as a sofa and a desk in the study."""
    for found in _IN_ALL.finditer(text):
        before = _THINGS.search(text[: found.start()])
        if before is not None and not re.search(rf"\b{KIND}s?\b(?! table)", before[1]):
            return f"{text[: found.start()]} in {_all_in(text[found.end() :])}"
    return text


def _there(found: re.Match[str]) -> str:
    """`the freezer goes there`, with the room named last in the place of the word."""
    rooms = _NAMED.findall(found.string[: found.start()])
    return f"{found[1]} in the {rooms[-1]}" if rooms else found.group()
