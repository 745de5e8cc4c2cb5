"""Rooms that one comes into through others, and what none of them has, as five languages say it."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded

_ES_ROOM = r"(?!dormitorio|bano)[a-z]+(?: de [a-z]+| principal)?"
_ES_WAY = r"(?:entra|accede|llega|sale|pasa)"
_DE_INTO = "in (?:den|die|das)|ins|zu[mr]|auf (?:den|die|das)|den|die|das"
_DE_GO = "kommt|gelangt|geht|betritt|erreicht"
_DE_WAY = "durch|uber|vom|von|aus|via"
_FR_ROOM = r"[a-z]+(?: de [a-z]+| a [a-z]+)?"
_FR_WAY = "uniquement par|seulement par|par|depuis|via"


def _reached(found: re.Match[str]) -> str:
    """`in den Abstellraum kommt man durch …` with the door behind the room."""
    return f"{found[1]} {'only ' if found[2] else ''}reachable from "


def _becomes(found: re.Match[str]) -> str:
    """`one of the two bedrooms becomes a study`: one bedroom and a study."""
    left = {"two": "one bedroom", "three": "two bedrooms", "four": "three bedrooms"}[found[1]]
    return f"{left} and {found[2]}"


_EN = (r"(?:(?:main|master|second|first|guest|living|dining|sitting|utility|laundry|storage|shower|bath|bed) ?)?"
       r"[a-z]+(?: ?room)?")  # fmt: skip
_WAYS = r"(?:ways(?: in)?|entrances|accesses|doors|routes)"
_ONE_FROM = r"(?:(?:one|another|the other)(?: door)? )?(?:from|through|via|off) "
_IN_ZH = {"卧室": " the bedroom has ", "卫生间": " the bathroom has "}
"""Rooms in which something is."""


def _along(found: re.Match[str]) -> str:
    """`a balcony along A and B, with a door from each` as what it has doors to."""
    room = re.sub(r"^(?:an?|the) ", "", found[1])
    return f"{found[1]}. the {room} has a door to {found[2]} and a door to {found[3]}"


def _two_of(found: re.Match[str]) -> str:
    """`bedroom 14 and 11` as two bedrooms, where the numbers can be areas of such."""
    sizes = [float(n.replace(",", ".")) for n in found.groups()]
    return f"two bedrooms of {found[1]} and {found[2]} m2" if all(6 < n < 40 for n in sizes) else found.group()


_SIZE = {"大": "larger", "小": "smaller"}
_SAID = [(late(pattern), words) for pattern, words in (
    # "One goes into the pantry through the kitchen", "entry to the study is through the living room"
    (r"\b(?:you|one|we|people) (?:(?:can )?(?:go|get|come|walk|step)|goes|gets|comes|walks|steps) (?:in)?to "
     r"((?:the |an? )?[a-z -]{3,30}?) (only )?(?:through|via|by way of) ", r"\1 is reached \2from "),
    (r"\b(?:the )?(?:entry|entrance|access|way) (?:in)?to (the [a-z -]{3,30}?) is (only )?"
     r"(?:through|via|from|by way of) ", r"\1 is \2reached from "),
    # "Al lavadero se entra por la cocina", "se accede al despacho desde el salón"
    (rf"(^|[.;,] ?|\by )(?:al|a la) ({_ES_ROOM}) se {_ES_WAY} (?:por|desde|a traves de) ",
     r"\1el \2 es accesible desde "),
    (rf"\bse {_ES_WAY} (?:al|a la) ({_ES_ROOM}) (?:por|desde|a traves de) ", r"el \1 es accesible desde "),
    # "In den Abstellraum kommt man nur durch die Küche", "den Balkon erreicht man über das Schlafzimmer"
    (rf"\b(?:{_DE_INTO}) (\w+) (?:{_DE_GO}) man (nur )?(?:{_DE_WAY}) ", _reached),
    (rf"\bman (?:betritt|erreicht) (?:den|die|das) (\w+) (nur )?(?:{_DE_WAY}) ", _reached),
    (rf"\b(?:der )?(?:zugang|eingang) (?:zum|zur|in den|in die|ins) (\w+) (?:erfolgt|ist|geht) (nur )?(?:{_DE_WAY}) ",
     _reached),
    # "On accède à la buanderie par la cuisine", "l'accès au balcon se fait par la chambre"
    (rf"\bon (?:entre dans|accede a|accede|arrive a|arrive dans|passe a|sort sur|sort) (?:la |le |l'|au )({_FR_ROOM}) "
     rf"(?:{_FR_WAY}) ", r"\1 accessible par "),
    (rf"\bl'acces (?:a la|au|a l') ?({_FR_ROOM}) (?:se fait|est) (?:{_FR_WAY}) ", r"\1 accessible par "),
    # "进书房要经过客厅"
    (r"(?:进入|进|去|到)([^,.;:从]{1,6}?)(?:要|得|需要|必须)?先?(?:经过|穿过|通过)([^,.;:]{1,6}?)(?=[,.;]|$)",
     r"\2通向\1"),
    # "ein Teppich im Wohnzimmer, aber keiner in der Küche"
    (r"\bkein(?:er|es|en|e)? (?:im|in der) ", "none in "),
    (r"\b(?:aucune?|pas) dans ", "none in "),
    (r"\bningun[oa]? en ", "none in "),
    (r"住一间(?![房卧])", "住一间房"),
    (r"(?:,|,? (?:et|mais)) (?:non pas|non|pas) sur (?=l[ae] )", ", not "),
    # "guests do not have to cross the living room to get to the bathroom"
    (r"[a-z]+ (?:don't|do not|doesn't|does not|needn't|need not|never) (?:have to |need to )?"
     r"(?:cross|go through|pass through|walk through) (the [a-z ]{3,20}?) to (?:get to|reach|get into|enter) "
     r"(the [a-z ]{3,20}?)(?= ?(?:[,.;]|$))", r"no door between \1 and \2"),
    (r"[,;]? (?:and )?the ([a-z ]{3,20}?) (?:gets|takes|has|is) (?:what(?:'s| is) left|the rest) of "
     r"(\d+ ?(?:sqm|m2|square met(?:er|re)s))", r", \1, total area \2"),
    # "zwei Zimmer für die Kinder, eins für uns", "une chambre pour nous, une pour les enfants"
    (r"\b(ein|zwei|drei|\d) (?:schlaf)?zimmer fur (?:die|unsere) kinder,? (?:und )?ein(?:e?s)? fur uns\b",
     r"\1 kinderzimmer, ein elternschlafzimmer"),
    (r"\bune chambre pour nous,? (?:et )?(une|deux|trois) pour les enfants\b",
     r"une chambre parentale, \1 chambre d'enfants"),
    (r"(朝[东南西北])(?=一间)", r"\1,"),
    (r"((?<!not )\bin (?:the |every |each )?[a-z ]{3,18}), (?:but |and )?not in (?=the |any |our )", r"\1, none in "),
    (r"\bentre (?:ellos|ellas|ambos|ambas|los dos|las dos|elles|eux|les deux)(?= ?(?:[,.;]|$)| y | et )|"
     r"\bdazwischen\b", "between them"),
    (r"\b(has|have|with) (?:two|three|four|\d) doors ?[,:(] ?(to|into|onto|from) ", r"\1 doors \2 "),
    (r"\b(with|has|have|having) no beds?\b", r"\1 no double bed"),
    (r"\b(?:neither|none)(?: of them)? (?:belongs?|opens?|leads?|is attached|is connected) "
     r"(?:to|onto|into|off) (?:an?|any) bed ?room\b", "neither of them en suite"),
    (r"\b(and|but) none between ", r"\1 no door between "),
    (r",? (two|three|four|\d) of (?:them|which|these) (?:are |being )?doubles?(?: rooms)?(?= ?[,;.]|$)",
     r". \1 of the bedrooms are double"),
    (r"\bformer(?:ly)?(?: an?)? (?=[a-z\d]+-(?:bed|room))", "originally a "),
    (r"\bone of the (two|three|four) bedrooms (?:becomes|will become|turns into|is turned into|serves as|is used as) "
     r"(an? (?:home )?(?:study|office|library|playroom|gym|guest room))", _becomes),
    (r"\bno(?: se)? debe (dar|abrir(?:se)?) (al|a la) ([a-z]+),? sino (al|a la) ", r"da \4 "),
    (r"(大|小)的那?[间个]?(?=\d|是|有|放|带|朝|靠)", lambda found: f" the {_SIZE[found[1]]} one "),
    (r"(^|[,;.:] ?|\bund )(?:im|in der) (\w+zimmer|kuche|bad|flur) (?=(?:ein(?:e|en)?|zwei|drei|vier|\d+) )",
     r"\1in the \2 "),
    (r"\bam (?:anderen )?ende (?:des flure?s|der diele|vom flur|des ganges)\b", "at the end of the hallway"),
    (r"\bthe door (?:to|of) (the [a-z ]{3,20}?) is (from|off|in) ", r"\1 is reached from "),
    # "zwei Bäder am Flur", "deux salles de bains sur le couloir", "两个卫生间都在走廊上"
    (r"\b(bad|bader|badezimmer|duschbad|duschbader|wc|wcs|toiletten?|\w+zimmer|kuche) (?:am|auf dem|vom|an dem) "
     r"(flur|gang|korridor)\b(?! aus)", r"\1 zuganglich vom \2"),
    (r"\b(salles? de bains?|salles? d'eau|wc|toilettes|chambres?) (?:sur|dans) le (couloir|hall)\b",
     r"\1 accessibles depuis le \2"),
    (r"\b(banos?|aseos?|dormitorios?) (?:en|junto) (?:el|al) (pasillo|distribuidor)\b", r"\1 accesibles desde el \2"),
    (r"((?:卫生间|浴室|厕所|卧室))(?:都|全部|全都)(?:在|靠)走廊(?:上|里|边)?", r"\1都从走廊进"),
    # "two ways to get to the kitchen: from the hall and from the lounge", "it has two entrances, from A and from B"
    (rf"(?:\bthere (?:are|should be|must be|have to be|are to be) |\b(?:we|i) want |,? (?:with|and) |(?<=[.;] )|^)"
     rf"two {_WAYS} "
     rf"(?:in|into|to|onto|to get (?:in)?to|to reach|to enter)(?: to)? (the {_EN})[,:;]? {_ONE_FROM}(the {_EN}),?(?: "
     rf"and|,) "
     rf"{_ONE_FROM}(the {_EN})(?= ?(?:[.,;]|$))", r". \1 has a door to \2 and a door to \3"),
    (rf"\b(the {_EN}) (?:has|should have|must have|gets) two {_WAYS}(?: in)?[,:;]? {_ONE_FROM}(the {_EN}),?(?: and|,) "
     rf"{_ONE_FROM}(the {_EN})(?= ?(?:[.,;]|$))", r"\1 has a door to \2 and a door to \3"),
    (rf"\b(?:you|one|we) (?:can )?(?:enter|reach|get to|get into|go into) (the {_EN}) (?:in|by|from) two (?:ways|"
     rf"sides)[,:;]? "
     rf"{_ONE_FROM}(the {_EN}),?(?: and|,) {_ONE_FROM}(the {_EN})(?= ?(?:[.,;]|$))",
     r"\1 has a door to \2 and a door to \3"),
    (r"\bhat zwei (?:zugange|eingange|turen)[,:]? (?:eine[nr]? )?(?:vom|von der|zum|zur) (\w+) und (?:eine[nr]? )?(?"
     r":vom|von der|"
     r"zum|zur) (\w+)", r"hat eine tur zum \1 und eine tur zum \2"),
    (r"\ba deux (?:acces|entrees|portes)[,:]? (?:l'une? )?(?:par|depuis|sur|vers) (l[ea] \w+) et (?:l'autre )?(?:par|"
     r"depuis|sur|"
     r"vers) (l[ea] \w+)", r"has a door to \1 and a door to \2"),
    (r"\btiene dos (?:accesos|entradas|puertas)[,:]? (?:una? )?(?:desde|por|al?) ((?:el|la) \w+) y (?:otr[oa] )?(?"
     r":desde|por|al?) "
     r"((?:el|la) \w+)", r"has a door to \1 and a door to \2"),
    (r"([^,.;:的]{1,6})有[两二2][个扇]门[,:]?一[个扇](?:通向|通往|开向|通|朝)([^,.;:]{1,5}?)[,和]?另?一[个扇]"
     r"(?:通向|通往|开向|通|朝)([^,.;:]{1,5})(?=[,.;]|$)", r" the \1 has a door to \2 and a door to \3"),
    # "a balcony along the living room and the bedroom, with a door from each"
    (rf"\b((?:an? |the )?{_EN}) (?:along|for|between|shared by|serving|in front of) (the {_EN}) and (the {_EN}),? (?"
     rf":with |and )?"
     r"(?:an? )?doors? (?:from|to|into) (?:each|both)(?: of (?:them|the two))?(?= ?(?:[.,;]|$))",
     _along),
    # "客厅最大", "das Wohnzimmer ist am größten"
    (r"([^,.;:的]{1,6}?)(?:面积)?(?:是|要)?最(大|小)(?=[,.;]|$)",
     lambda found: f" the {found[1]} is the {'largest' if found[2] == '大' else 'smallest'} room"),
    (r"\b((?:der|die|das) \w+) (?:ist |soll |sei )?am (grossten|kleinsten)(?: sein)?(?= ?(?:[,.;]|$))",
     lambda found: f"{found[1]} is the {'largest' if found[2][0] == 'g' else 'smallest'} room"),
    # "一间卧室,卧室里放一张床"
    (r"(?<![间个主次小大两房])(卧室|卫生间)里(?=有|放|摆|要)", lambda found: _IN_ZH[found[1]]),
    # "bedroom 14 and 11 m²"
    (r"\bbed(?: ?room)?:? (\d{1,2}(?:[.,]\d)?) ?(?:m2|sqm)? ?(?:and|&|\+) ?(\d{1,2}(?:[.,]\d)?) ?(?:m2|sqm)?(?= ?(?"
     r":[,.;]|$))",
     _two_of),
)]  # fmt: skip


def entered(text: str) -> str:
    """A folded text with such clauses in the words of doors."""
    return reworded(text, _SAID)
