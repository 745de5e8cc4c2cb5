"""Bathrooms that the other bedrooms share: `one has its own bathroom, the others share two`, in four languages."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_BATH = r"(?:bath ?rooms?|baths?|ensuites?|en[ -]suites?|bad|bader|baeder|badezimmer|salles? de bains?|banos?)"
_ROOMS = re.compile(rf"\b(?:{_BATH}|bed ?rooms?|[a-z]*zimmern?|chambres?|dormitorios?|habitaci\w+)\b")
_IN_ALL = re.compile(rf"\b(?:three|four|five|[3-5]|drei|vier|trois|quatre|tres|cuatro) {_BATH}\b")
_FEW = {"two": "two", "2": "two", "zwei": "two", "deux": "two", "dos": "two"}


def _others_share(found: re.Match[str]) -> str:
    """`one bedroom has its own bathroom, the others share two`: two bathrooms more, or of those counted."""
    before = found.string[: found.start()]
    last = ([m.group() for m in _ROOMS.finditer(before)] or [""])[-1]
    count = _FEW.get(found["n"], "three")
    if not found["bath"] and re.fullmatch(_BATH, last) is None:
        return found.group()
    counted = _IN_ALL.search(before)
    return f"the other {count} bathrooms are off the hall" if counted else f"{count} more shared bathrooms"


_SAID = rules((
    # "one bedroom has its own bathroom, the others share two"
    (r"\bthe (?:other (?:two|three|four|ones|bed ?rooms)|others|rest|(?:two|three|four) others)"
     r"(?: of them| of the bed ?rooms)? (?:will |should |must |can )?(?:share|use)s? (?P<n>two|three|[23])"
     r"(?P<bath> {bath})?(?: between them| together)?{end}", _others_share),
    (r"\bdie (?:anderen|ubrigen|restlichen)(?: (?:beiden|zwei|drei|vier))? teilen sich (?P<n>zwei|drei)"
     r"(?P<bath> {bath})?{end}", _others_share),
    (r"\bles (?:(?:deux|trois|quatre) )?autres (?:se )?partagent (?P<n>deux|trois)(?P<bath> {bath})?{end}",
     _others_share),
    (r"\b(?:los|las) (?:(?:otr[oa]s|demas)(?: (?:dos|tres|cuatro))?) comparten (?P<n>dos|tres)(?P<bath> {bath})?{end}",
     _others_share),
), bath=_BATH)  # fmt: skip


def shared_by_others(text: str) -> str:
    """A folded text with such bathrooms as so many more, or as those of all counted that are off the hall."""
    return reworded(text, _SAID)
