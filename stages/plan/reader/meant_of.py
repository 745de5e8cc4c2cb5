"""Clauses of which it is not plain what room they are said of, with that room named: `its area`, `and the bedroom …`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import ROOM, reworded, rules

_HATE = (r"(?:(?:i|we|my [a-z]+) )?(?:really |just )?(?:hates?|dislikes?|loathes?|cannot stand|can't stand|do not like|don't like|"
         r"do not want|don't want|can not stand|am sick of)")  # fmt: skip
_SMELL = r"(?:the |any |that )?(?:(?:cooking|kitchen|food) )?(?:smells?|odou?rs?|noises?|sounds?|steam|fumes|mess|dirt|draughts?|clatter)"
_SIDE = (r"(?:on|in|at|to|near|facing|towards) (?:the )?(?:very )?(?:(?:north|south)(?:[ -]?(?:east|west))?|east|west|left|right|back|front|"
         r"rear|entrance|middle|cent(?:re|er)|street|garden)(?: side| end| corner| part)?")  # fmt: skip
_ALONE = re.compile(r"\b(?:one|an?|the) (?:[a-z]+ ){0,2}bed ?room\b|\bone for\b|\banother for\b")
_TWO = re.compile(r"\b(?:two|2|three|3|both)[ -]?(?:[a-z]+ )?bed(?: ?rooms?)?\b|\bt3\b")


def _bedrooms(found: re.Match[str]) -> str:
    """`the two rooms must be side by side`: the bedrooms, where two of these were told of."""
    before = found.string[: found.start()]
    two = _TWO.search(before) or len(_ALONE.findall(before)) > 1
    return f"the two bedrooms {found['must']} {found['how']}" if two else found.group()


def _suite(found: re.Match[str]) -> str:
    """`three bedrooms, being one suite`: one of the three."""
    return f"{found['rooms']}, one of which is a {found['suite']}"


_SAID = rules((
    # "no open-plan kitchen, I hate the smell of cooking in the living room"
    (r"(?P<of>\b{hate} {smell}(?: of [a-z]+)?) (?:in|into|through|from|all over) (?:the |my |our )?{room}(?: and (?:the )?{room})?\b",
     r"\g<of>"),
    (r"\b(?:ich|wir) (?:hasse|hassen|mag|mogen) (?:den |keinen |das |keine )?(?P<of>\w*geruch|geruche|larm|dampf)(?: vom kochen)?"
     r"(?: nicht)? (?:im|in der|in den) \w+(?: nicht)?\b", r"\g<of>"),
    (r"\b(?:je|nous) (?:deteste|detestons|n'aime pas|n'aimons pas|hais) (?:l'|les |le |la )(?P<of>odeurs?|bruit|fumee)"
     r"(?: de (?:la )?cuisine)? (?:dans|de) (?:le|la|l') ?(?:salon|sejour|chambre|cuisine|piece a vivre)\b", r"\g<of>"),
    (r"\b(?:odio|odiamos|no me gusta|no soporto|no nos gusta) (?:el|los) (?P<of>olor|olores|ruido|humo)(?: (?:a|de) (?:la )?(?:comida|cocina|"
     r"fritos|cocinar))? (?:en|de) (?:el|la|l) (?:salon|comedor|dormitorio|cocina)\b", r"\g<of>"),
    (r"(?:我|我们)?(?:不喜欢|讨厌|受不了|怕)(?:在)?(?:客厅|卧室|餐厅|厨房)?(?:里)?(?:的)?(?:有)?(?P<of>油烟味?|气味|味道|噪音)", r"\g<of>"),
    # "the study must be next to the living room and its area must not exceed 9 m2"
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:the|my|our) {kind}) (?P<said>{must} [^.;:]*?|(?:is|lies|has|opens|faces)\b[^.;:]*?),? "
     r"(?:and|but) its (?:floor )?(?:area|size|surface)(?: area)? (?={must}|is\b|has\b|at\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:the|my|our) {kind}) (?P<said>{must} [^.;:]*?|(?:is|lies|has|opens|faces)\b[^.;:]*?)[.;] "
     r"its (?:floor )?(?:area|size|surface)(?: area)? (?={must}|is\b|has\b|at\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:der|die|das) \w+) (?P<said>(?:soll|muss|ist|liegt|grenzt)\b[^.;:]*?)[,;.]? (?:und )?"
     r"(?:seine|ihre) (?:flache|grosse) (?=(?:soll|darf|muss|ist|betragt)\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:le|la) \w+) (?P<said>(?:doit|est|donne|se trouve)\b[^.;:]*?)[,;.]? (?:et )?"
     r"sa (?:surface|superficie|taille) (?=(?:ne |doit|est|fait|sera)\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:el|la) \w+) (?P<said>(?:debe|esta|da|tiene|queda)\b[^.;:]*?)[,;.]? (?:y )?"
     r"su (?:superficie|area|tamano) (?=(?:no |debe|es|sera|ha)\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    # "the utility room next to the kitchen and the main bedroom on the east side"
    (r"(?P<by>\b(?:next to|beside|adjacent to|adjoining|opposite|close to|near|off) (?:the|our|my) {kind}),? and (?P<of>(?:the|our|my) {kind}) "
     r"(?P<side>{side}){end}", r"\g<by>. \g<of> is \g<side>"),
    (r"(?P<by>\bneben (?:dem|der) \w+|\bbe(?:im|i der) \w+) und (?P<of>(?:der|die|das) \w+) (?=(?:im|nach|am|auf der) (?:nord|sud|ost|"
     r"west|eingang|hint|vorn))", r"\g<by>. \g<of> "),
    (r"(?P<by>\b(?:a cote|pres) de (?:la |l')?\w+) et (?P<of>(?:la|le) \w+(?: principale| parentale| d'amis)?) (?=(?:au|a l'|du cote|pres|cote) ?"
     r"(?:nord|sud|est|ouest|de l'entree|fond))", r"\g<by>. \g<of> "),
    (r"(?P<by>\b(?:junto|al lado|cerca) (?:al|a la|del|de la) \w+) y (?P<of>(?:el|la) \w+(?: principal| de invitados)?) (?=(?:al|en el|hacia el|"
     r"cerca de) (?:norte|sur|este|oeste|fondo|la entrada))", r"\g<by>. \g<of> "),
    # "and the two rooms must to be side by side"
    (r"\b(must|should|shall|can) to be\b", r"\1 be"),
    (r"\b(?:the two|both|these two|those two|these|the) rooms (?P<must>(?:must|should|have to|need to|shall|are to) be|are|lie|must lie) "
     r"(?P<how>(?:side by side|next to (?:each other|one another)|adjacent|opposite(?: each other)?|back to back|(?:far )?(?:apart|away)|"
     r"far(?: away)? from (?:each other|one another)|not (?:next to|adjacent to|beside) each other)){end}", _bedrooms),
    # "the bathroom stands back to back with the kitchen"
    (r"\b(?P<must>{must} )?(?:stands?|lies?|is|are|be|sits?)? ?(?:placed |set )?back[ -]to[ -]back (?:with|to) ",
     lambda found: f"{found['must'] or ''}{'share' if found['must'] else 'shares'} a wall with "),
    (r"\b(?P<must>{must} )?backs? on ?to (?=(?:the|our|my|a) {kind})",
     lambda found: f"{found['must'] or ''}{'share' if found['must'] else 'shares'} a wall with "),
    (r"\b(?:liegt |liegen |steht )?rucken an rucken mit ", "neben "),
    (r"\b(?:dos a dos|adosse[es]*) (?:avec|a) ", "a cote de "),
    (r"\b(?:espalda con espalda con|de espaldas a|espalda a espalda con) ", "junto a "),
    (r"([^,.;和与]{1,6})(?:和|与)([^,.;和与]{1,6})背靠背", r"\1紧挨\2"),
    (r"\bun[oa] de ell[oa]s (?:es |sea |siendo )?una suite(?: principal)?(?: con (?:su |un )?(?:propio )?bano(?: propio| privado)?)?",
     "uno de ellos en suite"),
    (r"(\b(?:dos|tres|cuatro|[2-4]) (?:dormitorios|habitaciones)),? (?:siendo|incluyendo|incluid[oa]) una (?:de ell[oa]s )?(?:una )?suite"
     r"(?: principal)?(?: con (?:su |un )?(?:propio )?bano(?: propio| privado)?)?", r"\1, uno de ellos en suite"),
    # "three bedrooms, being one suite with its bathroom"
    (r"(?P<rooms>\b(?:two|three|four|five|[2-5]) bed ?rooms),? (?:being|including|incl|with|(?:and )?one (?:of (?:them|which|these) )?being) "
     r"(?:(?:one|an?) (?:of (?:them|these|which) )?(?:is )?(?:being )?(?:an? )?)?(?P<suite>(?:master |main )?suite)\b", _suite),
    (r"(?P<rooms>\b(?:two|three|four|five|[2-5]) bed ?rooms),? one of (?:them|these|which) an? (?P<suite>(?:master |main )?suite)\b", _suite),
    (r"(\bsuite\b[^.,;:]{0,30}? )(?:with|avec|con|mit) (?:its|an?|sa|une|son|un|su|einem|eigenem)(?: own| private| propre)? "
     r"((?:shower|bath) ?room|salle d'eau|salle de bains?|bano|bad)(?: propio| privative)?\b",
     lambda found: f"{found[1]}with its own {'shower room' if found[2] in ('salle d' + chr(39) + 'eau', 'shower room') else 'bathroom'}"),
    # "la chambre n'est accessible que par le séjour", "un dormitorio al que solo se accede por el salón"
    (r"\bn'(?P<is>est|sont) (?P<how>accessibles?|reliee?s?) (?:que|uniquement que) (?=(?:par|depuis|via|de|du|a)\b)",
     r"\g<is> accessible uniquement "),
    (r"\bon n'(?:accede|entre|arrive) (?:a la|a l'|au|dans la|dans le|dans l') ?(?P<of>\w+(?: parentale| d'amis)?) que (?:par|depuis|via) ",
     r"la \g<of> accessible uniquement par "),
    (r"\b(?:a laquelle|auquel|ou) (?:l')?on n'(?:accede|entre|arrive) que (?:par|depuis|via) ", "accessible uniquement par "),
    (r"(?P<of>\b(?:le|la|l') ?\w+) ne (?:s'ouvre|communique|donne) qu(?:e |')(?:sur|avec|dans) ", r"\g<of> accessible uniquement par "),
    (r"\b(?:al|a la|a los|a las) que (?:solo|solamente|unicamente) se (?:puede )?(?:accede|acceder|entra|entrar|llega|llegar) "
     r"(?:por|desde|a traves de) ", "accesible solo desde "),
    (r"\b(?:solo|solamente|unicamente) se (?:puede )?(?:accede|acceder|entra|entrar|llega|llegar) (?:al|a la) (?P<of>\w+) "
     r"(?:por|desde|a traves de) ", r"el \g<of> es accesible solo desde "),
    (r"\b(?:al|a la) (?P<of>\w+) (?:solo|solamente|unicamente) se (?:puede )?(?:accede|acceder|entra|entrar|llega|llegar) "
     r"(?:por|desde|a traves de) ", r"el \g<of> es accesible solo desde "),
    (r"只能(?=从|由)", ""),
    (r"\b(?:nobody|no one|no-one|you cannot|you can't|one cannot|you don't|you do not) (?:can )?(?:gets?|comes?|goes|go|enters?|walks?|steps?)(?: in)?(?: ?to)? "
     r"(?P<of>(?:the|my|our) {kind}) (?:except|but|other than|save|unless) (?:through|from|via|by way of|by) ",
     r"\g<of> is reached only from "),
    # "a laundry where we enter by the kitchen"
    (r",? (?:where|which|that|to which|in which|into which) (?:we|you|one|i|people) (?:can |should )?(?P<only>only )?enters? (?P<then>only )?(?:it )?(?:by|from|through|via) ",
     lambda found: f" {'only ' if found['only'] or found['then'] else ''}entered from "),
    (r"\b(?:entered|accessed|reached) by (?=(?:the|our|an?) )", "entered from "),
    (r",? with (?:the |an? |its )?(?:entrance|entry|access) (?:by|from|through|via) (?=(?:the|our) {kind})", " entered from "),
    # "living room must be most big"
    (r"\b(?:the )?most (big|large|small)(?=(?: room| one)?{end}| of )", lambda found: f"the {_MOST[found[1]]}"),
    # "bedroom is two, size is 12 square meter and 9 square meter"
    (r"\b(bed|bath)( ?)rooms? (?:is|are|:) ?(two|three|four|five|[2-5])(?= ?(?:[,.;)]|$| and ))", r"\3 \1\2rooms"),
    (r"(\b(?:two|three|four|[2-4]) (?:bed|bath) ?rooms)[,;:.]? ?(?:and |with )?(?:the |their |its )?(?:sizes?|areas?) (?:is |are |of |being |: ?)?"
     r"(?=\d)", r"\1 of "),
), hate=_HATE, smell=_SMELL, side=_SIDE)  # fmt: skip
_MOST = {"big": "biggest", "large": "largest", "small": "smallest"}
_NOT_BE = late(r"\bich bin\b")


def meant_of(text: str) -> str:
    """A folded text with such clauses said of their rooms."""
    return reworded(_NOT_BE.sub("ich", text), _SAID)
