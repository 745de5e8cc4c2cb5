"""Two rooms with an opening and no door between them, said in five languages: one as open to the other."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import DE, ES, FR, reworded, rules

_EN = (r"(?:(?:the |my |our |an? )?(?:(?:living|dining|sitting|drawing|family|play) ?(?:room|area)|kitchen(?:ette)?|"
       r"lounge|parlou?r|"
       r"study|hall(?:way)?))")  # fmt: skip
_DE = rf"(?:(?:der|dem|den|die|das) )?{DE}"
_FR = rf"(?:(?:le|la|un|une|du|de la|l') ?)?{FR}"
_ES = rf"(?:(?:el|la|un|una) )?{ES}"
_DOORLESS = (r"(?:,? ?\(?(?:without (?:an?y? |the )?doors?|with no doors?|no doors?|but no doors?|and no doors?|not "
             r"a door|instead of "
             r"a door)(?: in)?\)?)?")  # fmt: skip
_OPENING = rf"(?:an? |one )?(?:(?:wide|big|large|broad|open) )*(?:opening|archway|arch){_DOORLESS}"
_LOCH = (r"(?:eine?[nr]? |nur |eine?[nr]? )*(?:(?:breite|grosse|weite|offene)[nr]? )*(?:offnung|durchgang ohne tur|"
         r"durchbruch)(?:,? ohne tur)?")  # fmt: skip
_OUVERTURE = r"(?:une )?(?:(?:grande|large|simple) )*ouverture(?: libre)?(?:,? sans porte)?"
_HUECO = (r"(?:un |una )?(?:(?:gran|amplio|amplia) )?(?:hueco|abertura|vano|apertura)(?: ancho| amplio)?(?:,? sin "
          r"puerta)?")  # fmt: skip


def _open(found: re.Match[str]) -> str:
    return f"{found['a']}{found['and']}{found['b']} are open to each other"


_SAID = rules((
    # "the kitchen and the lounge have an opening without a door between them", "an opening between kitchen and lounge"
    (r"\b(?P<a>{en})(?P<and> and )(?P<b>{en}),? (?:(?:should |must |are to |to )?(?:be )?(?:have|has|having|share|"
     r"with|are having|"
     r"being|are )? ?(?:joined |connected |linked |separated )?(?:only )?(?:by |with )?)?{opening}"
     r",? (?:(?:in )?between(?: them| the two| both)?|in the middle)?{doorless}{end}", _open),
    (r"\b{opening} between (?P<a>{en})(?P<and> and )(?P<b>{en}){doorless}", _open),
    (r"\bbetween (?P<a>{en})(?P<and> and )(?P<b>{en}),? (?:(?:there )?(?:is|should be|must be|goes|we want|i want|"
     r"put) )?(?:only |just )?"
     r"{opening}(?= ?(?:[.,;]|$))", _open),
    (r"\bzwischen (?P<a>{de})(?P<and> und )(?P<b>{de}),? (?:(?:ist|soll|gibt es|sei|soll es|bitte) )?{loch}(?: "
     r"geben| sein)?{end}",
     _open),
    (r"\b{loch} zwischen (?P<a>{de})(?P<and> und )(?P<b>{de})", _open),
    (r"\b(?P<a>{de})(?P<and> und )(?P<b>{de}),? (?:sind |sollen )?(?:(?:mit|durch|uber) )?{loch}(?: dazwischen)?"
     r"(?: miteinander)?(?: verbunden)?(?: sein)?{end}", _open),
    (r"\b(?P<a>{de})(?P<and> und )(?P<b>{de}) (?:sind |sollen |liegen )?(?:zueinander|gegeneinander) offen(?: "
     r"sein)?\b", _open),
    (r"\b{ouverture} entre (?P<a>{fr})(?P<and> et )(?P<b>{fr})", _open),
    (r"\bentre (?P<a>{fr})(?P<and> et )(?P<b>{fr}),? (?:il y a |je veux |seulement )?{ouverture}{end}", _open),
    (r"\b(?P<a>{fr})(?P<and> et )(?P<b>{fr}),? (?:sont |doivent etre )?(?:reliee?s (?:par )?)?(?:ouverte?s "
     r"(?:l'une? (?:sur|a) l'autre|"
     r"entre (?:elles|eux))|(?:avec |par ){ouverture}(?: entre (?:elles|eux|les deux))?){end}", _open),
    (r"\b{hueco} entre (?P<a>{es})(?P<and> y )(?P<b>{es})", _open),
    (r"\bentre (?P<a>{es})(?P<and> y )(?P<b>{es}),? (?:hay |debe haber |quiero |solo )?{hueco}{end}", _open),
    (r"\b(?P<a>{es})(?P<and> y )(?P<b>{es}),? (?:estan |esten |son )?(?:abiert[oa]s (?:entre (?:si|ellos|ellas)|"
     r"un[oa] a(?:l| la) otr[oa])|"
     r"(?:unid[oa]s |comunicad[oa]s |conectad[oa]s )?(?:con |por ){hueco}(?: entre (?:ellos|ellas|si|ambos|los "
     r"dos))?){end}", _open),
    (r"(?P<a>{zh})(?:和|与|跟)(?P<b>{zh})之间(?:要|是|只)?(?:有|留|开|设)(?:一个|个)?(?:大|宽)?(?:开口|门洞|洞口|垭口)(?:[,、]?(?:但)?(?:没有|不要|"
     r"不装|不设|无)门)?",
     r"\g<a>和\g<b>相通"),
    (r"\b(?P<a>{en})(?P<and> and )(?P<b>{en}),? open to (?:each other|one another)\b", _open),
    # "the dining room between the kitchen and the lounge, open to the lounge but with a door to the kitchen"
    (r"\b(?P<a>{en}) (?P<by>between {en} and {en}),? (?P<open>open to {en}),? (?:but |and )(?:with |has "
     r")?(?P<door>a (?:proper )?door to {en})",
     r"\g<a> \g<by>. \g<a> is \g<open>. \g<a> has \g<door>"),
    (r"\b(?P<a>{en}) (?P<by>between {en} and {en}),? (?:with )?(?P<door>a (?:proper )?door to {en}),? (?:but |and "
     r")(?P<open>open to {en})",
     r"\g<a> \g<by>. \g<a> is \g<open>. \g<a> has \g<door>"),
), en=_EN, de=_DE, fr=_FR, es=_ES, opening=_OPENING, doorless=_DOORLESS,
   loch=_LOCH, ouverture=_OUVERTURE, hueco=_HUECO)  # fmt: skip


_LISTED = late(r", (?=(?:the |la |le |el |die |das )?\w+(?: room)? (?:and|et|y|und) (?:the |la |le |el |die |das "
               r")?\w+(?: \w+){0,2} are open to "
               r"each other\b)")  # fmt: skip
"""A list before such a clause, which says nothing of the rooms of the list."""


def unparted(text: str) -> str:
    """A folded text with such openings in plain words."""
    return _LISTED.sub("; ", reworded(text, _SAID))
