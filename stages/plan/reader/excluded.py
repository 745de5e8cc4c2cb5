"""Lists of what a home is not to have below a heading that says so: `Must not have: a balcony, a study`."""

import re

_NOT_HAVE = (r"(?:must|should|may|shall|do|does|can) ?n[o']t (?:have|include|contain|want|need)|don't (?:want|need)|"
             r"darf nicht haben|soll nicht haben|ne doit pas avoir|no debe tener|no (?:queremos|quiero)")  # fmt: skip
_HEAD = (rf"\b(?:(?:the following (?:is|are) )?(?:forbidden|excluded?|avoid|unwanted|banned|not (?:wanted|needed))|"
         rf"no[ -]gos?|(?:{_NOT_HAVE})(?: any of (?:these|those|the following)| the following)?|without|excluding|"
         r"ausgeschlossen|verboten|nicht (?:gewünscht|erwünscht|gewollt|nötig)|unerwünscht|ohne|"
         r"exclus?|interdits?|sans|à éviter|"
         r"excluidos?|prohibidos?|sin)\s*:")  # fmt: skip
_ITEM = r"[^\W\d][^\W\d]*(?:[ '-][^\W\d]+)*"
_BELOW = rf"(?:[^\S\n]*\n\s*[-*•+]\s*{_ITEM}(?:,? (?:and|or))?[,;.]?(?=\s*(?:\n|$)))+"
_BEHIND = rf"\s*{_ITEM}(?:, ?{_ITEM})*(?=\s*(?:[.;\n]|$))"
_LIST = re.compile(rf"{_HEAD}(?:(?P<below>{_BELOW})|(?P<behind>{_BEHIND})|(?= *[^\W\d]))")
_BULLET = re.compile(r"([-*•+]\s*)(?=[^\W\d])")
_AND = r"(?:and|or|nor|und|oder|et|ou|y|o|ni)"
_JOINED = re.compile(rf",\s*(?:{_AND} )?| {_AND} ")
_BETWEEN = re.compile(rf"\b((?:between|zwischen|entre) (?:[^\W\d]+ ){{1,4}}?){_AND} ")
_ARTICLE = re.compile(r"^(?:an?|the|any|eine?n?|die|der|das|une?|la|le|una?|el|no) ")


def excluded(text: str) -> str:
    """A text in lower case with a `no` before each that such a heading denies, on its line or on lines below."""
    return _LIST.sub(_denied, text)


def _denied(found: re.Match[str]) -> str:
    if found["below"]:
        return _BULLET.sub(r"\1no ", found["below"])
    if found["behind"]:
        items = _JOINED.split(_BETWEEN.sub(r"\1& ", found["behind"]))  # "a door between A and B" is one
        return ", ".join(f"no {_ARTICLE.sub('', item.strip()).replace('&', 'and')}" for item in items)
    return "no"
