"""Rooms counted, wished for and not wanted, in words that people have for it, put into those the rules know."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.pieces import reworded, rules

_COUNT = r"(?:one|two|three|four|five|six|[1-6])"
_SIZE = r"(?:large|big|small|little|tiny|spacious|good-sized|double|single|twin)"
_COUNTED = re.compile(rf"\b({_COUNT})[ -]bed(?: ?rooms?)?\b|\bbed ?rooms ?: ?({_COUNT})\b")


def _number(said: str) -> int:
    return 1 if said in ("a", "an") else int(said) if said.isdigit() else numbers()[said]


def _counted_before(found: re.Match[str]) -> int:
    """How many bedrooms were counted before what is found; 0 where none were."""
    counts = _COUNTED.findall(found.string[: found.start()])
    return max((_number(n or m) for n, m in counts), default=0)


def _of_those(found: re.Match[str]) -> str:
    """`four-bedroom flat. Two bedrooms have their own bathrooms`: two of the four."""
    many, known = _number(found["n"]), _counted_before(found)
    return f"{found['n']} of the bedrooms " if many < known else "the bedrooms " if many == known else found.group()


def _suite(found: re.Match[str]) -> str:
    """`three-bedroom flat. A master ensuite`: that of the main one of the three."""
    return "the master bedroom has an ensuite" if _counted_before(found) else found.group()


def _sized(found: re.Match[str]) -> str:
    """`one large and two small bedrooms`: each number with its rooms."""
    one = "s" if _number(found["n"]) > 1 else ""
    return f"{found['n']} {found['a']} bedroom{one} and {found['m']} {found['b']} bedroom{found['s']}"


def _listed(found: re.Match[str]) -> str:
    """`three bedrooms, a master and two kids' rooms`: those are the three."""
    adds_up = _number(found["n"]) == 1 + _number(found["m"])
    return found.group().replace(",", ":", 1) if adds_up else found.group()


_SAID = rules((
    # "a three-bedroomed house", "half a dozen bedrooms", "the number of bedrooms is three"
    (r"(?<=[ -])bed ?roomed\b", "bedroom"), (r"\bhalf a dozen (?=(?:[a-z]+ )?(?:bed|bath) ?rooms)", "six "),
    (r"\b(?:the )?(?:total )?number of ((?:bed|bath) ?room)s ?(?:is|are|:|should be|must be|will be)? ?({count})\b",
     r"\2 \1s"),
    # "one large and two small bedrooms", "two double bedrooms and a single"
    (r"\b(?P<n>{count}|an?) (?P<a>{size}) and (?P<m>{count}|an?) (?P<b>{size}) bed ?room(?P<s>s?)\b", _sized),
    (r"(\b(?:double|single|twin) bed ?rooms?,? and (?:{count}|an?) (?:double|single|twin))(s?)(?={end}| and )",
     r"\1 bedroom\2"),
    (r"\b(?P<n>{count}) bed ?rooms, (?:an?|one|the) (?:master|main|parents'|big|large)(?: bed ?room)? and "
     r"(?P<m>{count}|an?) (?=[a-z' -]*rooms?\b)", _listed),
    # "four bedrooms, one of them for guests"
    (r"\b(one of (?:them|which|these)) (?:is )?for (?:the |our |my )?(?:guests|visitors)\b", r"\1 is a guest room"),
    # "four-bedroom flat. Two bedrooms have their own bathrooms", "three-bedroom flat. A master ensuite"
    (r"(?<=[.;\n] )(?P<n>{count}) bed ?rooms (?=(?:each )?(?:have|get|share|are)\b)", _of_those),
    (r"(?<=[.;\n] )(?:an? )?(?:master|main) en ?suite(?: bath ?room)?(?={end})", _suite),
    # "a study would be great", "make sure there is a study", "in addition, a study", "it comes with a study"
    (r"\b(an? {kind}) (?:would be|is|will be) (?:great|lovely|nice|ideal|perfect|welcome|essential|important|vital|"
     r"crucial|a must|a plus)\b", r"\1 is needed"),
    (r"\b(?:please )?(?:make sure|ensure|see to it)(?: that)? (?=there (?:is|are)\b)", ""),
    (r"\b(?:absolutely|definitely|certainly|ideally|preferably),? (?=(?:no|need|want|with|an?|one|two)\b)", ""),
    (r"(^|[.;\n] ?)in addition,? (?!to\b)", r"\1also "),
    (r"\bcomes? with (?=(?:an?|its|their|one|two|\d)\b)", "has "),
    # "there must not be a study", "we have no use for a study", "leave the study out", "no study/balcony"
    (r"\bthere (?:(?:must|should|shall|can|may|will|need) not be|isn't|is not|won't be|needn't be) (?:an?|any) "
     r"(?={kind})", "there is no "),
    (r"\b(?:i|we) have no use for (?:an? |any |the )?(?={kind})", "no "),
    (r"(?<=[.;\n] )not an? ({kind})(?={end})", r"no \1"),
    (r"\b(?:please )?leave the ({kind}) out\b", r"no \1"),
    (r"\ban? ({kind}) (?:would be|is) (?:just |only )?a waste(?: of (?:space|room|money))?\b", r"no \1"),
    (r"\bno ({kind}) ?/ ?(?={kind}{end})", r"no \1, no "),
), count=_COUNT, size=_SIZE)  # fmt: skip


def in_numbers(text: str) -> str:
    """A folded text with its rooms counted and wished for so."""
    return reworded(text, _SAID)
