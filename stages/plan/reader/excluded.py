"""Lists of what a home is not to have below a heading that says so: `Must not have: a balcony, a study`."""

import re

_NOT_HAVE = (r"(?:must|should|may|shall|do|does|can) ?n[o']t (?:have|include|contain|want|need)|don't (?:want|need)|"
             r"darf nicht haben|soll nicht haben|ne doit pas avoir|no debe tener|no (?:queremos|quiero)")  # fmt: skip
_NONE_OF = (r"(?:(?:want|need|have|with|include|and|plan) )?(?:none|nothing) of (?:this|these|those|that|the "
            r"following)(?: rooms| things| items)?|"
            r"(?:keine?[rs]?|nichts) (?:davon|von diesen|von den folgenden|der folgenden)(?: räume| zimmer| dinge)?|"
            r"rien de (?:tout )?(?:cela|ça|ceci)|aucune? (?:de ces|des) (?:pièces|éléments|choses)(?: suivante?s)?|"
            r"nada de (?:esto|eso|lo siguiente)|ningun[oa] de (?:est[oa]s|l[oa]s siguientes)(?: habitaciones| "
            r"elementos| cosas)?|"
            r"不(?:要|需要)(?:以下|下列|这些)(?:的)?(?:任何)?(?:一个|一间|房间|东西)?")  # fmt: skip
_HEAD = (rf"\b(?:(?:the following (?:is|are) )?(?:forbidden|excluded?|avoid|unwanted|banned|not (?:wanted|needed))|"
         rf"no[ -]gos?|(?:{_NOT_HAVE})(?: any of (?:these|those|the following)| the following)?|without|excluding|"
         r"ausgeschlossen|verboten|nicht (?:gewünscht|erwünscht|gewollt|nötig)|unerwünscht|ohne|"
         r"exclus?|interdits?|sans|à éviter|"
         rf"excluidos?|prohibidos?|sin|{_NONE_OF}|(?<![\w:] )no)\s*(?::|(?<=following);|(?<=these);)\s*"
         r"(?!\d)")  # fmt: skip
_ITEM = r"[^\W\d][^\W\d]*(?:[ '-][^\W\d]+)*"
_BELOW = rf"(?:[^\S\n]*\n\s*[-*•+]\s*{_ITEM}(?:,? (?:and|or))?[,;.]?(?=\s*(?:\n|$)))+"
_BEHIND = rf"\s*{_ITEM}(?:, ?{_ITEM})*(?=\s*(?:[.;\n]|$))"
_COUNTS = r"(?!(?:one|two|three|four|zwei|drei|deux|trois|dos|tres|[一两二三四]|must|should|have|i |we )\b)"
_ONE_OF = rf"{_COUNTS}{_ITEM}"
_APART = rf"\s*{_ONE_OF}(?:\s?; ?{_ONE_OF})+(?=\s*(?:[.\n]|$))"
"""Items between semicolons, of which none counts rooms."""
_LIST = re.compile(rf"{_HEAD}(?:(?P<below>{_BELOW})|(?P<apart>{_APART})|(?P<behind>{_BEHIND})|(?= *[^\W\d]))")
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
    if found["behind"] or found["apart"]:
        said = found["behind"] or found["apart"].replace(";", ",")
        items = _JOINED.split(_BETWEEN.sub(r"\1& ", said))  # "a door between A and B" is one
        return ", ".join(f"no {_ARTICLE.sub('', item.strip()).replace('&', 'and')}" for item in items)
    return "no"
