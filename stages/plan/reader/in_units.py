"""Sizes in one way of writing them: units, ranges, limits and sides as people write them, in those the rules know."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_N = r"\d+(?:[.,]\d+)?(?![.,]?\d)"
_SQUARE = (r"(?:m2|sqm|qm|sq\.? ?m\b|square met(?:er|re)s?|sq\.? ?ft\b|sqft|ft2|sf\b|square f(?:ee|oo)t|"
           r"sq\.? ?f(?:ee|oo)t)")  # fmt: skip
_LONG = r"(?:m|cm|ft|met(?:er|re)s?|f(?:ee|oo)t)\b"
_ABOUT = r"(?:(?:about|around|roughly|approximately|approx\.?|ca\.?|circa|some|exactly|just|only) )?"
_LARGE = (r"(?:(?:[4-9]\d|\d{3})(?:[.,]\d+)? ?(?:m2|sqm|sq\.? ?m\b|square met(?:er|re)s?)|"
          r"(?:[4-9]\d\d|\d{4}) ?(?:sq\.? ?ft\b|sqft|ft2|square feet))")  # fmt: skip
"""What a home has and few rooms have."""
_GROWS = re.compile(r"\b(?:enlarg|gr[oe]w|increas|exten|expan|chang|shr[iu]nk|reduc|went\b|goe?s?\b)[^.;]*$")
"""`enlarge the kitchen from 10 to 12 m²` says no range."""


_TWICE = {"2": "twice", "3": "three times"}


def _times(found: re.Match[str]) -> str:
    """`the living room 2x as large as` is no second living room."""
    return _TWICE.get(found["n"], f"{found['n']} times") + " "


def _between(found: re.Match[str]) -> str:
    """`from 10 to 12 m²`, `10 m² to 12 m²`: at least the one and at most the other."""
    least, most = (float(found[side].replace(",", ".")) for side in ("x", "y"))
    ranged = least < most and not _GROWS.search(found.string[: found.start()])
    return f"between {found['x']} and {found['y']} {found['unit']}" if ranged else found.group()


def _of_those(found: re.Match[str]) -> str:
    """`two-bedroom flat. One bedroom of 14 m² and one of 11 m²`: of the two."""
    if not re.search(rf"\b(?:two|2)[ -]{found['room'][:3]}", found.string[: found.start()]):
        return found.group()
    return f"one of the {found['room']}s is {found['x']} and the other is {found['y']}"


_SAID = rules((
    # "14 m^2", "14 sq. metres", "a 12-square-metre kitchen", "almost 14 m²", "just over 14 m²"
    (r"\bm ?\^ ?2\b", "m2"),
    (r"\bsq\.? ?-?(met(?:er|re)s?|f(?:ee|oo)t)\b", r"square \1"),
    (r"(?<=\d)-(?:square|sq)-(met(?:er|re)|foot)\b", r" square \1"),
    (r"\b(?:around|almost|nearly|not quite|just (?:over|under|about|above|below)|a good|a little (?:over|under)) "
     r"(?={n} ?(?:{square}|{long})|[a-z]+(?:[ -][a-z]+)? square)", "about "),
    # "3mx4m", "3 times 4 metres"
    (r"(?<=\d)(m|ft|met(?:er|re)s) ?x ?(?=\d)", r" \1 x "),
    (r"({n}(?: ?{long})?) times (?={n} ?{long})", r"\1 x "),
    # "from 10 to 12 m²", "between 10 m² and 12 m²", "10 m² to 12 m²"
    (r"\b(?:(?:somewhere |anywhere )?(?:between|from)|in the range (?:of|from|between)) (?P<x>{n})(?: ?{square})? ?"
     r"(?:and|to|-) ?(?P<y>{n}) ?(?P<unit>{square})", _between),
    (r"(?P<x>{n}) ?{square} to (?P<y>{n}) ?(?P<unit>{square})", _between),
    # "of 14 m² and of 11 m²"
    (r"(?<=of )({n} ?{square},?) and of (?={n} ?{square})", r"\1 and "),
    (r"(?<=[.;\n] )one (?P<room>bed ?room|bath ?room) (?:of|with|at) (?P<x>{about}{n} ?{square}),? and "
     r"(?:one|another|a second)(?: one| (?P=room))? (?:of|with|at) (?P<y>{about}{n} ?{square})", _of_those),
    # "not below 12 m²", "over 12 m²", "12 m² tops", "12 m² or above"
    (r"\bnot (?:(?:less|smaller|fewer) than|below|under) (?={about}{n} ?{square})", "at least "),
    (r"\bnot (?:(?:more|larger|bigger|greater) than|above|over) (?={about}{n} ?{square})", "at most "),
    (r"\b(?:above|over) (?={n} ?{square})", "at least "),
    (r"\b(make the {kind}) smaller than (?={about}{n} ?{square})", r"\1 at most "),
    (r"\b(make the {kind}) (?:larger|bigger) than (?={about}{n} ?{square})", r"\1 at least "),
    (r"(?<!add )(?<!adds )(?<!adding )(?<!sum )(?<!sums )\bup to (?={n} ?{square})", "at most "),
    (r"\b(?:below|under) (?={n} ?{square})", "at most "),
    (r"({n} ?{square})\.?,? (?:tops|or (?:below|under))\b", r"at most \1"),
    (r"({n} ?{square})\.?,? (?:or|and) (?:above|over|upwards?)\b", r"at least \1"),
    (r"(?<= square )(met(?:er|re)s|feet),? (?:or|and) (?:above|over|upwards?)\b", r"\1 or more"),
    # "is to be 12 m²", "comes to 12 m²", "1.5x the size of"
    (r"\b(is|are) to be (?={about}{n} ?(?:{square}|{long}|x|by))", r"\1 "),
    (r"\b(?:comes|amounts|works out|runs) (?:to|in at|at) (?={about}{n} ?{square})", "is "),
    (r"(?P<n>{n}) ?(?:x|times) (?=(?:as (?:large|big|spacious)|the (?:size|area))\b)", _times),
    # "12 m² per bedroom", "two bedrooms of 12 m² apiece", "2 x 12 m² bedrooms"
    (r"({about}{n} ?{square})\.? (?:per|for every|for each|in each) (bed ?room|bath ?room)\b", r"each \2 \1"),
    (r"({square})\.? apiece\b", r"\1 each"),
    (r"\b([2-6]|two|three|four) ?x ({n} ?{square})\.? (bed ?rooms|bath ?rooms)\b", r"\1 \3 of \2 each"),
    # "14 m² for the main bedroom and 6 m² for the bathroom"
    (r"({about}{n} ?{square})\.? for (the {kind})(?={end}| and (?:about )?{n} ?{square}\.? for the (?!other))",
     r"\2 of \1"),
    # "85 m² of living space", "living space: 85 m²"
    (r"({about}{large}) of (?:living|floor) (?:space|area)\b", r"\1 in total"),
    (r"\b(?:living|floor) (?:space|area)(?: of|:| is)? (?=(?:[a-z]+\.? ){0,4}(?:{large}))", "total area "),
), n=_N, square=_SQUARE, long=_LONG, about=_ABOUT, large=_LARGE)  # fmt: skip


def in_units(text: str) -> str:
    """A folded text with its sizes said so."""
    return reworded(text, _SAID)
