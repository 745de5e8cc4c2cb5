"""Toilets in a room of their own: `toilet and shower separate`, `a shower room apart from the toilet`, `WC à part`."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_WC = r"(?:toilets?|wcs?|w\.c\.|loos?|lavator(?:y|ies)|water closets?)"
_SHOWER = r"(?:shower(?:[ -]?rooms?)?|wash ?room|bath(?:[ -]?rooms?)?|bath ?tub)"
_APART = (r"(?:separated?|apart|in (?:a |two )?(?:separate|different|own|another) rooms?|each in (?:its|their) own "
          r"room|split|on its own|by itself|independent|in its own room|detached|separately)")  # fmt: skip
_BE = r"(?:(?:should|must|to|is|are|be|has|have|being|kept|placed|a bit|completely|fully|strictly) )*"
_NAMED = re.compile(r"\b(?:bath ?rooms?|shower ?rooms?)\b")
_BOTH = {"shower": "a shower room and a separate toilet", "bath": "a bathroom and a separate toilet"}


def _both(found: re.Match[str]) -> str:
    """A room with the shower or bath, where none was named before, and one with the toilet."""
    if _NAMED.search(found.string[: found.start()]):
        return "a separate toilet"
    begin = ", " if found.groupdict().get("with") else ""
    return begin + _BOTH["shower" if found["of"].startswith("shower") else "bath"]


_SAID = rules((
    # "toilet and shower separate", "the shower should be apart from the toilet"
    (r"(?P<with>(?<=rooms) with )?\b(?:(?:the|an?|one|own) )?(?:separated? )?{wc}(?: and|,| &|/| \+) (?:(?:the|an?|"
     r"one) )?(?P<of>{shower}),? {be}{apart}(?: (?:from (?:each other|one another)|of each other))?(?! (?:from|to|of|"
     r"for|with))", _both),
    (r"(?P<with>(?<=rooms) with )?\b(?:(?:the|an?|one|own) )?(?P<of>{shower})(?: and|,| &|/| \+) (?:(?:the|an?|one) "
     r")?{wc},? {be}{apart}(?: (?:from (?:each other|one another)|of each other))?(?! (?:from|to|of|for|with))", _both),
    (r"\bseparated? {wc}(?: and| &|/| \+) (?P<of>shower)\b(?! ?room)", _both),
    (r"\b(?:(?:the|an?|one) )?{wc},? {be}{apart} (?:from|of) (?:the |an? )?(?P<of>shower)(?:[ -]?room)?\b", _both),
    (r"\b(?:(?:the|an?|one) )?{wc},? {be}(?:split|apart|detached) (?:from|of) (?:the |an? )?(?P<of>{shower})\b", _both),
    (r"\b(?:(?:the|an?|one) )?{wc},? {be}not in (?:the|an?) (?P<of>{shower}),? but {be}(?:{apart}|outside(?: of)? it)",
     _both),
    (r"\b(?:(?:the|an?|one) )?{wc},? {be}{apart},? {apart} (?:from|of) (?:the |an? )?(?P<of>{shower})\b", _both),
    (r"\b(?:(?:the|an?|one) )?(?P<of>shower(?:[ -]?room)?),? {be}{apart} (?:from|of) (?:the |an? )?{wc}\b", _both),
    # "one bathroom with toilet apart", "a split bathroom (toilet apart)"
    (r"\b(?P<n>(?:an?|one|the) )?(?:(?:split|divided|separated) )?(?P<of>bath ?room|bath|shower room)(?: with|,| "
     r"?\(with| ?\() ?(?:the |an? )?{wc},? {be}{apart}\)?(?! (?:from|to|of|for))", _both),
    (r"\b(?:an? )?split (?P<of>bath ?room|bath)s?\b", _both),
    # "toilet apart"
    (r"(?<!not )(?<!no )\b(?:(?:the|an?|one) )?{wc},? {be}(?:apart|on its own|by itself|in (?:a separate|its own) "
     r"room)(?={end}| and | with )", "a separate toilet"),
    (r"\b(?P<wc>aseo|wc|inodoro|retrete) aparte\b(?! de)", "aseo separado"),
    # "Bad mit WC getrennt", "baño con el inodoro aparte", "salle de bain avec WC à part"
    (r"\b(?:dusche|duschbad) (?:und|,) (?:toilette|wc) (?:sind |sollen )?(?:getrennt|separat|extra)(?: sein)?\b",
     "duschbad und separates wc"),
    (r"\b(?:toilette|wc) und (?:dusche|duschbad) (?:sind |sollen )?(?:getrennt|separat|extra)(?: sein)?\b",
     "duschbad und separates wc"),
    (r"\b(?P<bath>bad|badezimmer|duschbad) mit (?:getrennte[rmn] |separate[rmn] |extra )(?:toilette|wc)\b|"
     r"\b(?P<bath2>bad|badezimmer|duschbad) mit (?:toilette|wc) (?:getrennt|separat|extra)\b",
     lambda found: f"{found['bath'] or found['bath2']} und separates wc"),
    (r"\b(?P<bath>(?:un |el )?bano|(?:una |la )?ducha) con (?:el |un )?(?:inodoro|retrete|vater|wc|aseo) (?:aparte|"
     r"separado|independiente)\b", r"\g<bath> y aseo separado"),
    (r"\b(?:la |una )?ducha y (?:el |un )?(?:inodoro|retrete|vater|wc|aseo|bano) (?:aparte|separad[oa]s?|"
     r"independientes?)\b|\b(?:inodoro|retrete|vater|wc|aseo) y (?:la |una )?ducha (?:aparte|separad[oa]s?|"
     r"independientes?)\b",
     "bano con ducha y aseo separado"),
    (r"\b(?P<bath>(?:une |la )?salle de bains?|(?:une |la )?salle d'eau|(?:une |la )?douche) (?:avec|et) (?:les |des |"
     r"un )?(?:toilettes?|wc) (?:a part|separee?s?|independants?)\b",
     lambda found: f"{found['bath'].replace('douche', 'salle de douche')} et wc separes"),
    (r"(?:厕所|马桶|洗手间|卫生间)(?:和|与|跟)(?:淋浴间?|浴室)(?:要|是)?(?:分开|分离|独立)", "浴室,独立厕所"),
    (r"(?:淋浴间?|浴室)(?:和|与|跟)(?:厕所|马桶|洗手间|卫生间)(?:要|是)?(?:分开|分离|独立)", "浴室,独立厕所"),
), wc=_WC, shower=_SHOWER, apart=_APART, be=_BE)  # fmt: skip


def toilets_apart(text: str) -> str:
    """A folded text with such toilets as rooms beside that of the shower or bath."""
    return reworded(text, _SAID)
