"""Beds counted for a whole home: `Beds: one double, two singles`, `two bedrooms, three beds`, `sleeps four`."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import NUMBER, WORDS

_KINDS = r"(?:double|single|twin|bunk|king|queen)(?:[ -]size)?"
_WORDS = WORDS | {
    "count": rf"(?:an?|{NUMBER})",
    "of_kind": _KINDS,
    "bed": rf"(?:an?|{NUMBER}) {_KINDS} beds?\b",
    "one_told": r"(?! ?(?:each\b|in\b|per\b|apiece|for\b|:|\(|,? (?:one|two|three) of (?:them|which)))",
}
SINGLE = ("a", "an", "one", "1")
_COUNTED = Late(r"\b(?P<n>one|{several})[ -]?(?:bed ?rooms?\b|br\b|bed (?:flat|apartment|house|home|unit|condo)\b)",
                _WORDS)  # fmt: skip
_LISTED = Late(r"(?P<begin>^|[.;,:(\n-] ?)(?:in total |total )?beds(?: in total| needed| wanted)? ?[:=] ?"
               r"(?P<list>(?:(?:{count}|\d ?x) )?{of_kind}[^.;\n]*)", _WORDS)  # fmt: skip
_SHORT = re.compile(rf"\b(an?|{NUMBER})(?: ?x)? ({_KINDS})s?\b(?! ?(?:beds?|rooms?|bed ?rooms?)\b)")
_OF_ALL = Late(r"(?<!each of the )(?<!both )(?<!all )\b(?P<rooms>{several} bed ?rooms)(?: with|,? having|:|,| \()? ?"
               r"(?P<beds>{bed}(?:(?:,| and|, and| plus| \+| &) {bed})+)\)?(?! each\b| in (?:each|the|every) | apiece)",
               _WORDS)  # fmt: skip
_SLEEPS = Late(r",? ?(?:(?:that|which|to|should|must|it) )*\bsleeps? (?:up to |for )?(?:{several}|\d+)"
               r"(?: people| persons| guests| adults)?(?P<end>:?)(?= ?(?:[.,;:)]|$)| in | with )", _WORDS)  # fmt: skip
_BARE = Late(r"(?P<begin>^|[,;.:(]| and| with|, with| in total| should be| are) ?(?:there (?:are|should be|must be) |"
             r"(?:i|we) need )?(?:a total of )?\b(?P<n>{several}) beds(?: in (?:total|all)| altogether)?\b{one_told}",
             _WORDS)  # fmt: skip
_ALONE = re.compile(rf"(?:^|(?<=, )|(?<=,)|(?<=and ))(?={_KINDS}(?: bed)? in\b)")
"""Where a kind of bed begins that is not counted: `king in the main bedroom`."""
_OF_SOME = re.compile(r"\b(?:each|every|both|all|one|other|first|second|them|which|room has)\b(?![- ]?bed ?room)")
"""Words for some of the bedrooms, whose the beds behind are."""


def beds_listed(text: str) -> str:
    """A folded text with such beds as those of the home, not of each bedroom, each with its kind."""
    if not _COUNTED.search(text):
        return text
    text = _SLEEPS.sub(lambda found: "," if found["end"] else "", text)
    text = _OF_ALL.sub(_of_all, _LISTED.sub(_in_words, text))
    return text if re.search(rf"\b{_KINDS}s? ?beds?\b", text) else _BARE.sub(_dealt, text)


def _in_words(found: re.Match[str]) -> str:
    """`beds: one double, two singles` as beds in a sentence of their own."""
    beds = _ALONE.sub("a ", found["list"])
    beds = _SHORT.sub(lambda one: f"{one[1]} {one[2]} bed{'' if one[1] in SINGLE else 's'}", beds)
    return f"{'.' if found['begin'].strip() in ('', ':', '-', ',') else found['begin'].strip()} {beds}"


def _of_all(found: re.Match[str]) -> str:
    """Beds of several kinds behind bedrooms that are counted are not all in each of them."""
    kinds = set(re.findall(_KINDS, found["beds"]))
    return f"{found['rooms']}; {found['beds']}" if len(kinds) > 1 else found.group()


def _dealt(found: re.Match[str]) -> str:
    """Beds of no kind are double where they are alone in a room, and single where two of them share one."""
    clause = re.split(r"[.;:,]", found.string[: found.start()])[-1] if found["begin"] not in (".", ";") else ""
    if _OF_SOME.search(clause) or clause.endswith("one bedroom"):
        return found.group()
    counted = _COUNTED.search(found.string)
    rooms, beds = _value(counted["n"] if counted else "one"), _value(found["n"])
    double = max(2 * rooms - beds, 0) if beds >= rooms else beds
    if rooms == 1:
        return f" with {beds} single beds in the bedroom"
    told = [f"{n} {kind} bed{'s' if n > 1 else ''}" for n, kind in ((double, "double"), (beds - double, "single")) if n]
    return f"; {' and '.join(told)}"


def _value(said: str) -> int:
    return int(said) if said.isdigit() else numbers()[said]
