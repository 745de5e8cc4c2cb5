"""Clauses of which it is not plain what room they are said of, with that room named: `its area`, `and the bedroom "
  "…`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import BEDROOMS, DE, ES, FR, ROOM, reworded, rules

_HATE = (r"(?:(?:i|we|my [a-z]+) )?(?:really |just )?(?:hates?|dislikes?|loathes?|cannot stand|can't stand|do not "
         r"like|don't like|"
         r"do not want|don't want|can not stand|am sick of)")  # fmt: skip
_SMELL = (r"(?:the |any |that )?(?:(?:cooking|kitchen|food) )?(?:smells?|odou?rs?|noises?|sounds?|steam|fumes|mess|"
          r"dirt|draughts?|clatter)")  # fmt: skip
_SIDE = (r"(?:on|in|at|to|near|facing|towards) (?:the )?(?:very )?(?:(?:north|south)(?:[ -]?(?:east|west))?|east|"
         r"west|left|right|back|front|"
         r"rear|entrance|middle|cent(?:re|er)|street|garden)(?: side| end| corner| part)?")  # fmt: skip
_ALONE = re.compile(r"\b(?:one|an?|the) (?:[a-z]+ ){0,2}bed ?room\b|\bone for\b|\banother for\b")
_BEDS = re.compile(rf"\b(?:two|2|dos|deux|zwei)[ -]?(?:[a-z]+ )?{BEDROOMS}\b|[两二2][个间]?(?:卧室|房间|室)")
_KIDS = late(r"\b(?:kids|children's|child's|nursery|kinderzimmer|(?:des |d')enfants?|de los ninos|ninos)\b")
_OURS = late(r"\b(?:ours|our (?:bed ?)?room|parents|elternschlafzimmer|unsere?m? schlafzimmer|parentale|notre "
             r"chambre|principal)\b")
_TWO = re.compile(r"\b(?:two|2|three|3|both)[ -]?(?:[a-z]+ )?bed(?: ?rooms?)?\b|\bt3\b")


def _bedrooms(found: re.Match[str]) -> str:
    """`the two rooms must be side by side`: the bedrooms, where two of these were told of."""
    before = found.string[: found.start()]
    two = _TWO.search(before) or len(_ALONE.findall(before)) > 1
    return f"the two bedrooms {found['must']} {found['how']}" if two else found.group()


def _between(found: re.Match[str]) -> str:
    """`two bedrooms and a bathroom between them`: between the two bedrooms."""
    before = found.string[: found.start()]
    two = _BEDS.search(before) or (_KIDS.search(before) and _OURS.search(before))
    end = "." if found.groupdict().get("on") else ""
    return f", {found['what']} between the two bedrooms{end}" if two else found.group()


def _suite(found: re.Match[str]) -> str:
    """`three bedrooms, being one suite`: one of the three."""
    return f"{found['rooms']}, one of which is a {found['suite']}"


_LISTED = (
    (rf"(?:(?:el|la|un|una) )?{ES}", "y"),
    (rf"(?:(?:le|la|un|une) )?{FR}", "et"),
    (rf"(?:(?:der|die|das|eine?) )?{DE}", "und"),
    (rf"(?:(?:the|an?) )?{ROOM}", "and"),
)
"""Lists that are joined by the same word all along: `el salón y la cocina y el comedor`."""
_JOINED = [(joint, late(rf"(?<!con )(?<!with )(?<!avec )(?<!mit )\b(?P<a>{one}) {joint} (?P<b>{one}) {joint} "
                        rf"(?={one}\b)")) for one, joint in _LISTED]  # fmt: skip
_SAID = rules((
    # "no open kitchen, I can't stand the smell of frying in the lounge"
    (r"(?P<of>\b{hate} {smell}(?: of [a-z]+)?) (?:in|into|through|from|all over) (?:the |my |our )?{room}(?: and (?"
     r":the )?{room})?\b",
     r"\g<of>"),
    (r"\b(?:ich|wir) (?:hasse|hassen|mag|mogen) (?:den |keinen |das |keine )?(?P<of>\w*geruch|geruche|larm|dampf)(?"
     r": vom kochen)?"
     r"(?: nicht)? (?:im|in der|in den) \w+(?: nicht)?\b", r"\g<of>"),
    (r"\b(?:je|nous) (?:deteste|detestons|n'aime pas|n'aimons pas|hais) (?:l'|les |le |la )(?P<of>odeurs?|bruit|fumee)"
     r"(?: de (?:la )?cuisine)? (?:dans|de) (?:le|la|l') ?{fr}\b", r"\g<of>"),
    (r"\b(?:odio|odiamos|no me gusta|no soporto|no nos gusta) (?:el|los) (?P<of>olor|olores|ruido|humo)(?: (?:a|de) "
     r"(?:la )?(?:comida|cocina|"
     r"fritos|cocinar))? (?:en|de) (?:el|la|l) {es}\b", r"\g<of>"),
    (r"(?:我|我们)?(?:不喜欢|讨厌|受不了|怕)(?:在)?(?:客厅|卧室|餐厅|厨房)?(?:里)?(?:的)?(?:有)?(?P<of>油烟味?|气味|"
     r"味道|噪音)", r"\g<of>"),
    # "salón y cocina juntos"
    (r"(?P<a>\b{vivid}),? y (?P<b>{vivid}),? (?:juntos|juntas|unidos|integrados|en (?:un|el) (?:solo|mismo|unico) (?"
     r":espacio|ambiente))\b",
     r"\g<a> y \g<b> abiertos"),
    # "two bedrooms and a bathroom between them"
    (r",? (?:and|with|y|et|und|mit|con|avec) (?P<what>(?:(?:an?|one|the|una?|el|la|une|le|eine?[mr]?|das|dem) )?(?"
     r":small |shared )?"
     r"(?:bath ?room|shower room|kitchen|study|bano|cocina|despacho|salle de bains?|salle d'eau|cuisine|bad|"
     r"badezimmer|kuche)),? "
     r"(?:right |directly |placed |located |situado |situee? )?(?:between (?:them|the two|both)|in between(?: them)?"
     r"|dazwischen|"
     r"entre (?:ell[oa]s|l[oa]s dos|ambos|ambas|les deux|elles)){end}(?P<on> ?[,;])?", _between),
    (r",? (?:und|and) (?:dazwischen|between them|in between) (?P<what>(?:an?|das|die|ein|eine|the) (?:bath ?room|"
     r"kitchen|bad|badezimmer|kuche)){end}", _between),
    (r"(?P<what>卫生间|浴室|厨房|书房)(?:在|位于)(?:它们|两者|两间|这两间|二者)(?:的)?(?:之间|中间)", _between),
    # "the study must be near the entrance and its size at least 8 m2"
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:the|my|our) {kind}) (?P<said>{must} [^.;:]*?|(?:is|lies|has|opens|faces)"
     r"\b[^.;:]*?),? "
     r"(?:and|but) its (?:floor )?(?:area|size|surface)(?: area)? (?={must}|is\b|has\b|at\b)", r"\g<begin>\g<of> "
      r"\g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:the|my|our) {kind}) (?P<said>{must} [^.;:]*?|(?:is|lies|has|opens|faces)"
     r"\b[^.;:]*?)[.;] "
     r"its (?:floor )?(?:area|size|surface)(?: area)? (?={must}|is\b|has\b|at\b)", r"\g<begin>\g<of> \g<said>. "
      r"\g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:der|die|das) \w+) (?P<said>(?:soll|muss|ist|liegt|grenzt)\b[^.;:]*?)[,;.]? "
     r"(?:und )?"
     r"(?:seine|ihre) (?:flache|grosse) (?=(?:soll|darf|muss|ist|betragt)\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:le|la) \w+) (?P<said>(?:doit|est|donne|se trouve)\b[^.;:]*?)[,;.]? (?:et )?"
     r"sa (?:surface|superficie|taille) (?=(?:ne |doit|est|fait|sera)\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:el|la) \w+) (?P<said>(?:debe|esta|da|tiene|queda)\b[^.;:]*?)[,;.]? (?:y )?"
     r"su (?:superficie|area|tamano) (?=(?:no |debe|es|sera|ha)\b)", r"\g<begin>\g<of> \g<said>. \g<of> "),
    # "the pantry beside the kitchen and the bathroom in the north"
    (r"(?P<by>\b(?:next to|beside|adjacent to|adjoining|opposite|close to|near|off) (?:the|our|my) {kind}),? and (?"
     r"P<of>(?:the|our|my) {kind}) "
     r"(?P<side>{side}){end}", r"\g<by>. \g<of> is \g<side>"),
    (r"(?P<by>\bneben (?:dem|der) \w+|\bbe(?:im|i der) \w+) und (?P<of>(?:der|die|das) \w+) (?=(?:im|nach|am|auf "
     r"der) (?:nord|sud|ost|"
     r"west|eingang|hint|vorn))", r"\g<by>. \g<of> "),
    (r"(?P<by>\b(?:a cote|pres) de (?:la |l')?\w+) et (?P<of>(?:la|le) \w+(?: principale| parentale| d'amis)?) (?=(?"
     r":au|a l'|du cote|pres|cote) ?"
     r"(?:nord|sud|est|ouest|de l'entree|fond))", r"\g<by>. \g<of> "),
    (r"(?P<by>\b(?:junto|al lado|cerca) (?:al|a la|del|de la) \w+) y (?P<of>(?:el|la) \w+(?: principal| de "
     r"invitados)?) (?=(?:al|en el|hacia el|"
     r"cerca de) (?:norte|sur|este|oeste|fondo|la entrada))", r"\g<by>. \g<of> "),
    # "one for us, one for the baby. Both rooms must be side by side"
    (r"\b(must|should|shall|can) to be\b", r"\1 be"),
    (r"\b(?:the two|both|these two|those two|these|the) rooms (?P<must>(?:must|should|have to|need to|shall|are to) "
     r"be|are|lie|must lie) "
     r"(?P<how>(?:side by side|next to (?:each other|one another)|adjacent|opposite(?: each other)?|back to back|(?"
     r":far )?(?:apart|away)|"
     r"far(?: away)? from (?:each other|one another)|not (?:next to|adjacent to|beside) each other)){end}", _bedrooms),
    # "the kitchen should back onto the bathroom"
    (r"\b(?P<must>{must} )?(?:stands?|lies?|is|are|be|sits?)? ?(?:placed |set )?back[ -]to[ -]back (?:with|to) ",
     lambda found: f"{found['must'] or ''}{'share' if found['must'] else 'shares'} a wall with "),
    (r"\b(?P<must>{must} )?backs? on ?to (?=(?:the|our|my|a) {kind})",
     lambda found: f"{found['must'] or ''}{'share' if found['must'] else 'shares'} a wall with "),
    (r"\b(?:liegt |liegen |steht )?rucken an rucken mit ", "neben "),
    (r"\b(?:dos a dos|adosse[es]*) (?:avec|a) ", "a cote de "),
    (r"\b(?:espalda con espalda con|de espaldas a|espalda a espalda con) ", "junto a "),
    (r"([^,.;和与]{1,6})(?:和|与)([^,.;和与]{1,6})背靠背", r"\1紧挨\2"),
    (r"\bun[oa] de ell[oa]s (?:es |sea |siendo )?una suite(?: principal)?(?: con (?:su |un )?(?:propio )?bano(?: "
     r"propio| privado)?)?",
     "uno de ellos en suite"),
    (r"(\b(?:dos|tres|cuatro|[2-4]) (?:dormitorios|habitaciones)),? (?:siendo|incluyendo|incluid[oa]) una (?:de "
     r"ell[oa]s )?(?:una )?suite"
     r"(?: principal)?(?: con (?:su |un )?(?:propio )?bano(?: propio| privado)?)?", r"\1, uno de ellos en suite"),
    # "three bedrooms including one suite"
    (r"(?P<rooms>\b(?:two|three|four|five|[2-5]) bed ?rooms),? (?:being|including|incl|with|(?:and )?one (?:of (?"
     r":them|which|these) )?being) "
     r"(?:(?:one|an?) (?:of (?:them|these|which) )?(?:is )?(?:being )?(?:an? )?)?(?P<suite>(?:master |main )?suite)\b",
      _suite),
    (r"(?P<rooms>\b(?:two|three|four|five|[2-5]) bed ?rooms),? one of (?:them|these|which) an? (?P<suite>(?:master |"
     r"main )?suite)\b", _suite),
    (r"(\bsuite\b[^.,;:]{0,30}? )(?:with|avec|con|mit) (?:its|an?|sa|une|son|un|su|einem|eigenem)(?: own| private| "
     r"propre)? "
     r"((?:shower|bath) ?room|salle d'eau|salle de bains?|bano|bad)(?: propio| privative)?\b",
     lambda found: f"{found[1]}with its own "
                   f"{'shower room' if found[2] in ('salle d' + chr(39) + 'eau', 'shower room') else 'bathroom'}"),
), vivid=r"(?:(?:el|la|un|una) )?(?:salon|cocina|comedor)", hate=_HATE, smell=_SMELL, side=_SIDE)  # fmt: skip
_NOT_BE = late(r"\bich bin\b")


def meant_of(text: str) -> str:
    """A folded text with such clauses said of their rooms."""
    for joint, listed in _JOINED:
        if text.count(f" {joint} ") > 1:
            text = listed.sub(rf"\g<a>, \g<b> {joint} ", text)
    return reworded(_NOT_BE.sub("ich", text), _SAID)
