"""Doors between two rooms of a kind, doors told one behind another: `a door between them`, `one from A to B`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import KIND, reworded
from apartgen.stages.plan.reader.vocabulary import EACH_OTHER

_KIND = (r"(?:also |additionally |always )?(?:an?|one|the) (?:(?:connecting|communicating|interconnecting|internal|"
         r"interior|inner|inside|private|direct|"
         r"sliding|shared|common|single|small|wide|normal|lockable|second|further|extra) )*")  # fmt: skip
_THEM = r"(?:them(?: both)?|the two(?: of them)?|both(?: of them| rooms)?|each other|one another)"
_DOOR = (rf"(?:{_KIND}door(?:way)? (?:right |directly |in )?(?:between|joining|connecting|linking) {_THEM}|"
         r"(?:an? |one )?(?:connecting|communicating|interconnecting) door|"
         rf"{_KIND}door(?:way)? (?:that |which )?(?:joins|connects|links|leads between) {_THEM})")  # fmt: skip
_PAIR = (r"((?:both|the (?:two|other two)|these two|those two)(?: of the)? [a-z' ]{0,24}?(?:bed|bath) ?rooms|"
         r"(?:both|the|our|the two) (?:[a-z]+'s? )?(?:bed|bath|kids'? |children's |guest )?rooms|(?:both|the two) (?"
         r":studies|offices|of them)|"
         r"the two (?:smaller|larger|small|large|other) ones)")  # fmt: skip
_BEHIND = r"(?= ?(?:[.,;:)]|$)| (?:and|besides|in addition|as well|too|please|plus|while)\b)"
_ZU_ZWEIT = (r"(?:zwischen (?:ihnen|den beiden|beiden|den zweien)|dazwischen|untereinander)")
_TUR = r"(?:eine[rn]? )?(?:(?:direkten? |eigenen? |inneren? )?tur|verbindungstur|durchgangstur|zwischentur)"
_PORTE = r"(?:une )?porte(?: de communication| interieure| communicante)?"
_PUERTA = r"(?:una )?puerta(?: de comunicacion| interior| de paso)?"
_WAY = rf"(?:from|between) (?:the )?{KIND} (?:back |on |through )?(?:to|into|onto|and) (?:the )?{KIND}"
_ON = (r"(?:[,;:.]|,? and)? ?(?:then )?(?:with |there is )?(?:an?|one|another|a second|a third|the other|the third)"
       rf"(?: one)?(?: doors?)? {_WAY}")  # fmt: skip
_CHAIN = late(rf"(?:,? (?:with|and) |\bdoors ?: ?|\bthere (?:is|are) |: ?)?(?:an? |one )door {_WAY}(?:{_ON})+|"
              rf"\bdoors ?: ?(?:an? |one ){_WAY}(?:{_ON})+")  # fmt: skip
_EACH_DOOR = re.compile(rf"(?:from|between) (?:the )?({KIND}) (?:back |on |through )?(?:to|into|onto|and) (?:the )?"
                        rf"({KIND})")  # fmt: skip
_PLURAL = re.compile(r"\b(?:[a-z]*rooms|studies|offices|ones|both|they)\b[^.;]*$")


def _joined(found: re.Match[str]) -> str:
    """`… with a door between them` of rooms of one kind; of two kinds others tell."""
    return f" {EACH_OTHER}" if _PLURAL.search(found.string[: found.start()]) else found.group()


_SIZE = r" of \d+(?:[.,]\d+)? ?(?:m2|sqm|sq m|sq ?ft|ft2)"
_SAID = [(late(pattern), words) for pattern, words in (
    # "next to the lounge, but without a door between the two"
    (r"\b(no|without|without an?|without any) doors? between (?:the two|both)(?: of them| rooms)?(?= ?(?:[.,;)]|$))",
     "no door between them"),
    # "a living room and, open to it, a kitchen"
    (rf"\b({KIND})((?:{_SIZE})?,?) (?:and|with|plus), (open to|off|directly off) it, (an? {KIND}(?:{_SIZE})?)",
     r"\1\2 and \4 \3 the \1"),
    # "a dining room, open to the lounge but with a door to the kitchen"
    (rf"\b({KIND})(?:(?: of|,) (\d+(?:[.,]\d+)? ?(?:m2|sqm|sq m|sq ?ft|ft2)))?, open to (?=(?:the|it|our|a)\b)",
     lambda found: f"{found[1]}{f' of {found[2]}' if found[2] else ''} open to "),
    # "the two bedrooms have a door between them", "two bedrooms with a connecting door"
    (rf"\b(?:they|both) (?:also |both )?(?:has|have|share|shares) {_DOOR}", f"they are {EACH_OTHER}"),
    (rf"\b(?:also |both )?(?:has|have|share|shares|are to have|should have|must have) {_DOOR}", f"are {EACH_OTHER}"),
    (r"\b(?:share|shares|sharing) (?:a|one) (?:common |connecting )?door\b", f"are {EACH_OTHER}"),
    (rf",? (?:and )?(?:with|having|sharing) {_DOOR}", _joined),
    (rf"\b(?:there (?:is|'s|should be|must be|has to be|will be)|we want|i want) (?:also )?{_DOOR}",
     f"they are {EACH_OTHER}"),
    (rf"(\b(?:two|both) [a-z' ]{{0,20}}(?:rooms|studies|offices)),? (?:and |plus )?{_DOOR}", rf"\1 {EACH_OTHER}"),
    (r",? (?:which |that )?(?:are )?(?:interconnected|interconnecting|communicating|connected|linked|joined)"
     rf"(?: with each other| to each other| together)? (?:by|through|via) {_KIND}door(?:way)?\b", f" {EACH_OTHER}"),
    (r"\b(two|the two|both) (?:interconnected|interconnecting|communicating|connecting) ((?:bed|bath) ?rooms)",
     rf"\1 \2 {EACH_OTHER},"),
    # "there is a door between the two bedrooms"
    (rf"(^|[.;:,] ?|\band |\bwith )(?:there (?:is|should be|must be|has to be) )?(?:also )?{_KIND}door(?:way)? "
     rf"between {_PAIR}"
     rf"{_BEHIND}", rf"\1\2 are {EACH_OTHER}"),
    # "zwei Schlafzimmer mit einer Tür dazwischen", "zwischen den beiden Schlafzimmern ist eine Tür"
    (rf",? (?:die )?(?:mit|durch) (?:{_TUR} {_ZU_ZWEIT}|(?:einer )?(?:verbindungstur|durchgangstur|zwischentur)|{_TUR} "
     r"(?:miteinander )?verbunden(?: sind)?)", f" {EACH_OTHER}"),
    (rf"\b(?:haben|besitzen|teilen sich|bekommen) (?:{_TUR} {_ZU_ZWEIT}|eine (?:verbindungstur|durchgangstur|"
     rf"zwischentur))",
     f"sind {EACH_OTHER}"),
    (rf"\bzwischen den (?:beiden|zwei) (schlafzimmern|kinderzimmern|badern|zimmern) "
     rf"(?:ist|gibt es|liegt|befindet sich|soll|sollte) {_TUR}(?: sein| geben)?", rf"die zwei \1 sind {EACH_OTHER}"),
    # "deux chambres communicantes", "il y a une porte entre les deux chambres"
    (rf",? (?:avec {_PORTE} entre (?:elles|les deux)|avec (?:une )?porte (?:de communication|communicante)|"
     rf"(?:qui sont )?(?:reliees|communicantes)(?: entre elles)?(?: par {_PORTE})?|qui communiquent(?: entre elles)?)"
     r"(?= ?(?:[.,;]|$)| et | avec )", f" {EACH_OTHER}"),
    (rf"\b(?:il y a|avec) {_PORTE} entre les (?:deux )?(chambres|salles de bains?)", rf"les deux \1 sont {EACH_OTHER}"),
    (rf"\bles deux (chambres|salles de bains?) (?:ont|communiquent)(?: {_PORTE} entre elles| par {_PORTE}| entre "
     rf"elles)?"
     r"(?= ?(?:[.,;]|$))", rf"les deux \1 sont {EACH_OTHER}"),
    (rf",? (?:con {_PUERTA} entre (?:ellos|ellas|ambos|ambas|los dos|las dos)|con (?:una )?puerta de (?:comunicacion|"
     rf"paso)|"
     rf"(?:que estan )?(?:comunicad[oa]s|conectad[oa]s|unid[oa]s)(?: entre si)?(?: por {_PUERTA})?|que se comunican"
     r"(?: entre si)?)(?= ?(?:[.,;]|$)| y | con )", f" {EACH_OTHER}"),
    (rf"\b(?:hay|con) {_PUERTA} entre (?:los|las|ambos|ambas|los dos|las dos) (dormitorios|habitaciones|banos)",
     rf"los dos \1 son {EACH_OTHER}"),
    # "两个卧室之间有门", "两间卧室，中间有门相通", "两个卧室互相连通"
    (r"([两二2][个间]?(?:卧室|次卧|卫生间|房间))(?:之间|中间)(?:要|应该|需要)?有一?[扇道个]?门(?:相通|连通|相连)?",
     rf"\1 {EACH_OTHER}"),
    (r"([两二2][个间]?(?:卧室|次卧|卫生间|房间))(?:,?(?:之间|中间)有一?[扇道个]?门(?:相通|连通|相连)?|(?:要|应该)?(?:互相|相互|彼此)?(?:相通|连通|互通|相连))",
     rf"\1 {EACH_OTHER}"),
)]  # fmt: skip


def mutually(text: str) -> str:
    """A folded text in which such rooms are connected to each other, and each such door stands in its own sentence."""
    text = _CHAIN.sub(_apart, text)
    return reworded(text, _SAID)


def _apart(found: re.Match[str]) -> str:
    """`a door from the hall to the study, one from the study to the lounge` as two sentences."""
    pairs = _EACH_DOOR.findall(found.group())
    return "".join(f". there is a door between the {a} and the {b}" for a, b in pairs)
