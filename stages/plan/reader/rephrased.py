"""What German, Chinese and English say in an order of words that the rules do not follow, put into one they do."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.retold import retold

_DE_ROOMS = {"kochen": "kuche", "essen": "esszimmer", "wohnen": "wohnzimmer"}
_DOING = "kochen|essen|wohnen"
_TOGETHER = re.compile(rf"\b(?:{_DOING})(?:(?:, ?| und |/| & | \+ )(?:{_DOING})){{1,2}}\b")
_WHOSE = {"eltern": "elternschlafzimmer", "kinder": "kinderzimmer", "gaste": "gastezimmer"}
_OF_WHOM = re.compile(r"\b(?:schlaf)?zimmer (?:der|unserer|meiner|fur (?:die|unsere)) (eltern|kinder|gaste)n?\b")
_LIVED = r"(?:kitchen|dining|living)(?: room)?"
_OPENED = re.compile(rf"\b({_LIVED}(?: ?\+ ?{_LIVED}){{1,2}}) ?: ?open(?:[ -]?plan)?\b")
_COMPARED = re.compile(r"比([^,.;:]{1,10}?)(?:还要|还|更|要)?(大|小)(?:一些|一点|些)?(?=[,.;]|$)")
_PEOPLE = "grandparents|parents|children|childs|kids"
_NAMED = {"grandparents": "grandparents'", "parents": "parents'", "children": "children's",
          "childs": "children's", "kids": "kids"}  # fmt: skip


def _whose_room(found: re.Match[str]) -> str:
    """`two bedrooms for the children` as `two children's bedrooms`."""
    count, room, own, people = found.groups()
    if re.search(r"\b(?:one|another|two|others?) for\b", found.string):
        return found.group()  # "two bedrooms for the children, one for us"
    return f"{count + ' ' if count else ''}{_NAMED[people]} {room}{own}"


def _halved(found: re.Match[str]) -> str:
    """`a bathroom for every two bedrooms`, of bedrooms counted elsewhere."""
    words = {"two": 2, "three": 3, "four": 4, "five": 5, "six": 6}
    rest = found.string[: found.start()] + "|" + found.string[found.end() :]
    told = re.search(r"\b(\d|two|three|four|five|six)[ -]bed ?rooms?\b", rest)
    count = (words.get(told[1]) or int(told[1])) if told else 0
    return f"{(count + 1) // 2} bathrooms" if count else found.group()


def _which(found: re.Match[str]) -> str:
    """`the one in the corridor` as the bathroom or bedroom of which several were named last."""
    named = re.findall(r"\b(bath|bed) ?rooms\b", found.string[: found.start()])
    return f"the {named[-1]}room {'off' if found[2] in _WAYS else 'in'}" if named else found.group()


def _altogether(found: re.Match[str]) -> str:
    """`each family has two bedrooms`, of families counted before."""
    told = re.search(r"\b(two|three|four|2|3|4) families\b", found.string[: found.start()])
    if told is None:
        return found.group()
    return f"{int(_NUMBERS.get(told[1], told[1])) * int(_NUMBERS.get(found[1], found[1]))} {found[2].rstrip('s')}s"


def _paired(found: re.Match[str]) -> str:
    """`each pair of bedrooms shares a bathroom`, of an even number of bedrooms counted elsewhere."""
    words = {"four": 4, "six": 6, "eight": 8}
    told = re.search(r"\b(4|6|8|four|six|eight)[ -]bed ?rooms?\b", found.string)
    if told is None:
        return found.group()
    count = words.get(told[1]) or int(told[1])
    pairs = [f"bedrooms {2 * k - 1} and {2 * k} share bathroom {k}" for k in range(1, count // 2 + 1)]
    return f". {count // 2} bathrooms. {'. '.join(pairs)}"


_AGAIN = "hmm|erm?|uhm?|no|sorry|wait|oops|actually|correction|i mean|i meant|or rather|make it|make that|nein|doch|" \
    "besser|lieber|non|plutot|pardon|perdon|mejor|digo|不对|不"
"""Words before what is said anew."""


_WAYS = ("corridor", "hallway", "hall")
_NUMBERS = {"one": "1", "a": "1", "two": "2", "three": "3", "four": "4"}
_ORDERED = [(late(pattern), words) for pattern, words in (
    # "Zum Schlafzimmer gehört eine Ankleide."
    (r"\bzu(?:m|r) (\w+) gehor(?:t|en)\b", r"das \1 hat"),
    # "Der Abstellraum soll an die Küche grenzen."
    (r"\b(?:direkt )?an(?:s| die| das| den| der| dem) (\w+) (?:an)?grenz(?:t|en)\b", r"neben dem \1"),
    # "Es soll vom Flur aus zugänglich sein."
    (r"\b(?:vom|von d(?:er|em)|uber d(?:en|ie|as)|durch d(?:en|ie|as)) (\w+) (?:aus )?"
     r"(?:zuganglich|erreichbar|begehbar|betretbar|zu erreichen|zu betreten)\b(?: sein)?", r"zuganglich vom \1"),
    (r",? (?:der|die|das) (?:nur )?(?:vom|von d(?:er|em)|uber d(?:en|ie|as)|durch d(?:en|ie|as)) (\w+) (?:aus )?"
     r"(?:betreten|erreicht|zuganglich|erreichbar|begehbar) (?:wird|ist|sein soll|werden (?:kann|soll))\b",
     r" zuganglich vom \1"),
    # "Das Bad soll größer sein als das WC."
    (r"\b(grosser|kleiner|so gross) sein (als|wie)\b", r"\1 \2"),
    # "Küche und Wohnzimmer gehen ineinander über."
    (r"\b(?:finden|liegen|sind) in einem (?:(?:grossen|gemeinsamen|einzigen) )*offenen (?:bereich|raum)"
     r"(?: statt)?\b", "sind offen"),
    (r"\b(?:offen |fliessend )?ineinander ubergehen(?:d)?\b", "offen"),
    (r"\bgehen (?:offen |fliessend )?ineinander uber\b", "sind offen"),
    # "for a long-term study of robots" is no room
    (r"\bfor (?:an? |our |my |the )?(?:[\w-]+ ){0,3}stud(?:y|ies) (?:of|on|about|into) (?![^,.;]{0,20}\d)",
     "for research on "),
    (r"^((?:this |it |that )?(?:is |will be )?)for (?:an? |our |my |the )(?!small|large|big|tiny|quiet|separate|home)"
     r"[\w-]+ (?:[\w-]+ )?stud(?:y|ies)(?= ?[:,.])", r"\1for research"),
    (r"\b(flat|apartment|house|layouts?|plans?|scenes?|environments?) for (?:an? |our |my |the )"
     r"(?!small|large|big|tiny)[\w-]+ (?:[\w-]+ )?stud(?:y|ies)(?= ?(?:[:,.]|with|$))", r"\1 for research"),
    # "Left: kitchen, bathroom. Back: bedrooms."
    (r"(^|[.;] ?)(?:on the |at the |to the )?(left|right|back|rear|front)(?: side)? ?: ?", r"\1on the \2: "),
    # "zwei Bäder, davon eines am Elternschlafzimmer"
    (r"\bdavon ein(?:e[sr]?)? (?:direkt )?(?:am|beim|im|vom) (?:eltern|haupt)(?:schlaf)?zimmer(?: aus)?"
     r"(?: zuganglich| erreichbar)?\b", "davon eines en suite"),
    # "The bedrooms are set apart from each other."
    # "Küche, Essbereich und Wohnzimmer bilden einen offenen Raum."
    (r"\bbilden (?:zusammen )?eine?n? (?:(?:grosse[ns]?|gemeinsame[ns]?|einzige[ns]?|offene[ns]?) )+"
     r"(?:raum|bereich|einheit)\b", "sind offen"),
    (r"\b(balkon|terrasse|loggia) (?:am|beim|vor d(?:em|er)|an der) (\w+)", r"\1 zuganglich vom \2"),
    # "Im Wohnzimmer stehen ein Sofa und zwei Sessel"; "ein Wohnraum, in dem ein Bett steht"
    (r"\b(?:im|in d(?:er|em)) (\w+) (?:steht|stehen) ", r"das \1 hat "),
    (r",? in (?:dem|der|denen) ([^,.;]+?) (?:steht|stehen)(?=[,.;]|$)", r" mit \1"),
    # "ein Balkon, den man nur von dort betritt"
    (r", d(?:en|ie|as) man nur von dort (?:aus )?(?:betritt|erreicht|betreten kann|erreichen kann)\b", ""),
    # "bathrooms which are both on the corridor", "entered both from the bedroom and from the hall"
    (r"\bon the (corridor|hallway|hall|landing|passage)\b(?! side|'s)", r"off the \1"),
    (r"\b(is|are|be) (?:both|all) (?=off|reached|accessed|accessible|reachable|entered|connected|linked|next)", r"\1 "),
    (r"\b(entered|reached|accessed|accessible|reachable|connected|linked|leads?|doors?|opens?) both "
     r"(from|to|into|onto|off)\b", r"\1 \2"),
    # "les deux autres chambres", "la chambre a une salle d'eau", "el salón es la habitación más grande"
    (r"\b(dos|tres|cuatro) (dormitorios|habitaciones|banos) mas\b(?! (?:grand|pequen))", r"otros \1 \2"),
    (r"\bles (deux|trois|quatre) autres\b", r"les autres \1"),
    (r"\b((?:chambre|salon|cuisine|sejour|suite|appartement|logement|bureau)(?: \w+)?) a (une?|deux|trois|sa|son)\b",
     r"\1 avec \2"),
    (r"\b(?:ser|es|sea) la (?:habitacion|estancia|pieza) mas (grande|pequena)\b",
     lambda found: f"is the {'largest' if found[1] == 'grande' else 'smallest'} room"),
    # "a bigger living room than kitchen"
    (r"\b(?:an? |the )?(larger|bigger|smaller) ((?:living|dining|bed|bath) ?room|kitchen|study|balcony|hall) than\b",
     r"the \2 \1 than the"),
    # "the first bedroom is the largest" of the bedrooms, "the lounge is the largest" of all rooms
    (r"(?<!\bthe )\b(bed|bath)( ?room(?: \d| [a-d])?) is the (largest|biggest|smallest)"
     r"(?: \1 ?room| one)?(?= ?[.,;]|$| and\b)", r"\1\2 is the \3 of the \1rooms"),
    (r"\bis the (largest|biggest|smallest)(?= ?[.,;]|$)", r"is the \1 room"),
    (r"\bthan the (?:the|an?)\b", "than the"),
    # "as large as the two bedrooms combined"
    (r"(\b(?:as (?:large|big|spacious) as|(?:larg|bigg|small)er than|the size of) [^.;,]*?) (?:combined|(?:put|taken) "
     r"together)\b", r"\1 together"),
    (r"\b(to|near|from|beside|touch|touching) any (?:of the )?(bed|bath)rooms?\b", r"\1 the \2rooms"),
    (r"\bon (?:either|both) sides? of the (bath ?room|kitchen|living room|study)\b", r"next to the \1"),
    (r"\bun bureau (?=dans (?:chaque |les |la |une )?chambre)", "une table de travail "),
    # "Three friends share the flat; each has a bedroom"
    (r"\b((?:two|three|four|five|six|\d) (?:friends|students|flatmates|roommates|sisters|brothers|colleagues)),? "
     r"(?:who )?(?:share|live in|rent) (?:the|an?|this) (?:flat|apartment|house|home)[;,.] (?:and )?"
     r"each\b(?: of them)?", r"\1 each"),
    # "two bedrooms of 12 m², actually make them 14"
    (r"\b(m2|sqm|qm|sq m|square met(?:er|re)s?)\b(.*?\bmake (?:it|them|that|each) \d+)(?= ?(?:[.,;!](?!\d)|$))",
     r"\1\2 m2"),
    (r"\bactually,? (?=(?:\d+(?:[.,]\d+)? ?(?:m2|sqm|sq m)|off|next to|near|beside|facing|(?:on|to|at|in) the)\b)",
     "correction, "),
    (r"(^|[,;.] ?|\band )the rest(?: of the (?:rooms|flat|house|home))? (?=(?:is|are|lies|goes|should|must) )",
     r"\1all other rooms "),
    (r"\bactually,? (?:i (?:need|want) |we (?:need|want) )?"
     r"(?=(?:only |just )?(?:one|two|three|four|five|six|[1-9])\b(?! ?(?:m|sqm|sq|x|by|of)\b))", "correction, "),
    # "Actually, put it off the living room instead.", "make the one with the tub 7 m²"
    (r"\b(?:actually|no|sorry|better|rather|correction)[, ]+(?:please )?(?:put|place|move|make) (?:it|them) "
     r"((?:off|next to|near|beside|in|at|on|facing) [^,.;]*?)(?: instead)?(?= ?(?:[.,;!]|$))", r"correction, \1"),
    (r"\bmake (the (?!kitchen|hall|corridor)[a-z ]{3,40}?) (\d+(?:\.\d+)? ?(?:m2|sqm|sq m|square met(?:er|re)s?))",
     r"\1 is \2"),
    # "The kitchen is 10 m², sorry, 12."
    (rf"\b(m2|sqm|qm|square met(?:er|re)s?|quadratmeter|平米|平方米)((?: \w+)?(?:[,.; -]+(?:{_AGAIN}))+[, ]+)(\d+"
     r"(?:(?:,|,? and|,? und|,? et|,? y) \d+)*)(?: instead)?(?= ?(?:[.,;!)]|-|$))", r"\1\2\3 m2"),
    (r"\b(?:make|turn|change|convert|replace|swap) the ([a-z ]{4,25}?) (?:into|to|with|by|for|instead) (?=an? )",
     r"make the \1 "),
    # "wide enough for a wheelchair (at least 1.2 m)", "one large room with kitchen", "a luxury suite: …"
    (r"\bwide enough [^.,;()]*?\((at least|min(?:imum)?|>=) ?(\d+(?:\.\d+)?) ?m\)", r"at least \2 m wide"),
    (r"\bone (large|big|huge|small) (?:open )?(?:room|space) with (?:an? )?(?:open )?kitchen\b",
     r"a \1 living room with open kitchen"),
    (r"^(?:an? |the )?(?:[\w-]+ )?suite ?:", "a home:"),
    # "with a bedroom on either side of it", "bedrooms are three"
    (r",? with an? (bed ?room) on (?:either|each|both) sides?(?: of it)?(?= ?(?:[.,;]|$))", r", next to both \1s"),
    (r"\b(bed ?rooms|bath ?rooms|toilets) (?:are|is|must be|should be) (two|three|four|\d)"
     r"(?= ?(?:[.,;](?!\d)|$))", r"\2 \1"),
    (r"(?:\b(?:appartement|maison|logement) (?:de|a|avec) (?:une?|deux|trois|quatre|\d) )?"
     r"\b(chambres?(?: de \d+ ?m2)?(?: chacune)?) avec (?:un )?bureau\b",
     lambda found: found.group() if found.start() < found.start(1) else f"{found[1]} avec une table de travail"),
    (r"(\b(?:piso|apartamento|departamento|casa|vivienda)\b.*\bcon )un estudio\b", r"\1un despacho"),
    # "There are two beds in the bedroom", "my room has a desk, hers a piano", "the parents have their own"
    (r"\b(two|three|\d) beds (?=in (?:the|each|every|my|our|his|her|one|a) )", r"\1 double beds "),
    (r"\b(?:hers|his)(?= (?:has|is|with|should|needs|a)\b)", "her room"),
    (r"(\bbath(?:room)?\b[^.;]{0,30}?(?:and|,|while|but|;)) (?:the |my |our |their )?"
     r"(parents|grandparents|guests|children|kids) (?:have|has|get|gets) (?:their|his|her) own(?= ?(?:[.,;]|$))",
     lambda found: f"{found[1]} the {_NAMED.get(found[2], 'guest')} bedroom has its own bathroom"),
    (r"\b(?:one|an?) (?:shared )?bath(?:room)? (?:for|per) every (?:two|2) (?:bed)?rooms?\b", _halved),
    (r"\b(?:a|avec) sa propre (salle (?:de bains?|d'eau|de douche))\b", r"avec \1 privative"),
    (r"\b(?:a|avec) (?:son|sa) propre\b", "avec un"),
    # "a corridor with a bedroom on each side"
    (r"\ba (bed ?room|balcony|study|bath ?room) (?=(?:on|at|to) (?:each|either|both) sides?\b(?! of))", r"two \1s "),
    # "The kitchen should be around 10 m2, give or take 1."
    (r"(?:(?:about|around|roughly) )?(\d+) ?(?:m2|sqm|square met(?:er|re)s?),? give or take (\d+)"
     r"(?: ?(?:m2|sqm|square met(?:er|re)s?))?",
     lambda found: f"between {int(found[1]) - int(found[2])} and {int(found[1]) + int(found[2])} m2"),
    (r"\baround (?=\d)", "about "),
    # "as far apart as possible", "three same bedrooms", "one room is for sleep"
    (r"\b(two|three|four|five|both|\d) same(?:[- ]size)? (?=(?:bed|bath|child|kid)?\w*\s?rooms)", r"\1 equal sized "),
    (r"\b(?:one room|another room|one|another|the (?:second|third|other)(?: room)?) (?:is|should be|will be) for "
     r"(sleep|work|study|live|living|sleeping|working|studying|cooking|eating)\b", r"one for \1"),
    (r"\bkitchen\"?: ?\"?open\b(?!-| plan| to| onto| concept)", "open kitchen"),
    (r"\bkitchen\"?: ?\"?(?:closed|separate)\b", "separate kitchen"),
    (r"\blong,? (?:and )?(?!narrow)(\w+) (hallway|corridor|hall|passage)\b", r"\1 long \2"),
    (r"(\d(?:[.,]\d+)?) ?(?:m|met(?:er|re)s?)? on (\d(?:[.,]\d+)? ?(?:m|met(?:er|re)s?)\b)", r"\1 x \2"),
    # "Place two lamps in the study", "a balcony I don't need"
    (r"(^|[.;:] *)place (?=(?:an?|the|one|two|three|four|\d+) )", r"\1put "),
    (r"\bno doors (?=between|to|from)", "no door "),
    (r"\beither (bed|bath)room\b", r"both \1rooms"),
    # "a bedroom with a bath for the grandparents", "the bedroom of the children"
    (rf"\b(?:(two|three|2|3) )?(bed ?rooms?)((?: with (?:an? |its own |their own |own )(?:[\w-]+ ){{0,2}}[\w-]+)?) "
     rf"(?:for|of) (?:the |my |our |their )?({_PEOPLE})\b(?! (?:bed)?rooms?)", _whose_room),
    (r"\bd'(?=une?\b)", "de "),  # "un appartement d'une chambre"
    # "Un trastero al que se entre desde el despacho"
    (r"\b(?:al|a la) que se (?:entra|entre|accede|acceda|llega|llegue) (?:desde|por) ", "accesible desde "),
    (r"\b(una?) (terraza|balcon|vestidor) en ((?:el|la) (?:dormitorio|habitacion|salon|cocina|comedor)(?: principal)?)"
     r"(?= ?(?:[,.;]|$))", r"\3 con \1 \2"),
    (r"\b(terraza|balcon|vestidor) en (el|la) (dormitorio|habitacion|salon|cocina|comedor)",
     r"\1 accesible desde \2 \3"),
    (r"\bthe one (in|off|on|at) the (?=(corridor|hallway|hall)\b)",
     lambda found: f"{_which(found)} the " if "room" in _which(found) else found.group()),
    (r"\beach (?:family|of them) (?:has|have|gets|needs|with|should have) (one|a|two|three|\d) "
     r"(bed ?rooms?|bath ?rooms?)", _altogether),
    (r",? (?:where |and |with )?(?:each|every) (?:pair of|two) bed ?rooms (?:shares?|sharing|has|have|gets?) "
     r"(?:one |an? )bath ?room(?= ?(?:[.,;]|$))", _paired),
    (r"\b(through|via|from) the ((?:main |master )?bed ?room)(?:'s)? (walk-in closet|closet|dressing room)",
     r"\1 the \3 off the \2"),
    # "a dining room between A and B and open to both"
    (r"\bbetween (the )?(\w+(?: room)?) and (the )?(\w+(?: room)?)(,? and (?:is )?|, )open to both(?: of them)?",
     r"between \1\2 and \3\4 and is open to the \2 and to the \4"),
    (r"\bzwischen (?:d(?:er|em) )?(\w+) und (?:d(?:er|em) )?(\w+)(,? und |, )(?:ist )?zu beiden(?: hin)? offen\b",
     r"zwischen \1 und \2 und ist offen zu \1 und \2"),
    (r"\b(salon|pasillo|vestibulo|distribuidor|recibidor) al que dan ([^.;]+)", r"\1. \2 dan al \1"),
    # "two bedrooms 4 x 3.5 and 3 x 3 m"
    (r"\btwo (bed ?rooms|bath ?rooms),? ?:?(?: of)? (\d+(?:\.\d+)?) ?m? ?(?:x|by) ?(\d+(?:\.\d+)?)(?: ?m)? ?"
     r"(?:and|,|&) ?(\d+(?:\.\d+)?) ?m? ?(?:x|by) ?(\d+(?:\.\d+)?)(?: ?m(?:et(?:er|re)s?)?)?\b",
     r"two \1, one of \2 x \3 m and one of \4 x \5 m"),
    (r"\b(bed ?rooms|bath ?rooms) (two|three|four|five)(?= ?(?:, | of \d| a \d|$))", r"\2 \1"),
    (r"(^|[.;] ?)(?:the )?((?:bed|bath|living|dining) ?room|kitchen|study) windows? "
     r"(?:to(?:wards)?|on|at|facing|faces?|looks?|opens?)(?: to)? (?:the )?(north|south|east|west)\b",
     r"\1the \2 faces \3"),
    (r"(\b(?:left\b.*?\bright|right\b.*?\bleft)\b.*?),? (?:with |and )?(an? [a-z ]{3,15}?) in between(?: them)?"
     r"(?= ?(?:[,.;]|$))",
     r"\1, \2 in the middle"),
    # "with exit to the terrace", "from the kitchen you can go out on the balcony", "a door connects them"
    (r"\bfrom the (\w+(?: room)?) (?:you|one|we|i) (?:can )?(?:go|get|step|walk)(?: out)? (?:on|onto|to|into) "
     r"(?:the|an?) (balcony|terrace|loggia)\b", r"the \1 has a door to the \2"),
    (r"\btwo (bed|bath)( ?)rooms[;,.]? ?(?:(?:and |with )?a (?:connecting )?door (?:that )?"
     r"(?:connects|joins|links|between) (?:them|the two|each other)(?: both)?|(?:(?:that|which) are )?"
     r"(?:connected|linked|joined) (?:to|with) (?:each other|one another))(?= ?(?:[.,;]|$))(.*)$",
     r"two \1rooms\3. \1room 1 has a door to \1room 2"),
    (r"\bliving room (?:who|which|that) is also (?:the |a )?dining room\b", "living-dining room"),
    (r",? all (?:of them )?opening (?:into|onto|off|to) (?:the|one|an?) ((?:[a-z]+ )?)living room\b",
     r", \1living room. all rooms open onto the living room"),
    (r"\b(the (?:[a-z]+ ){0,2}bedrooms) ((?:should |must )?(?:share a wall with|are next to|be next to)) each other,? "
     r"but not (?:with|to|next to) (the [a-z ]+?)(?= ?(?:[.,;]|$))", r"\1 \2 each other. they are not next to \3"),
    (r"\b((?:cocina|salon|bano|dormitorio|terraza|comedor)(?: \w+)?) de (\d+) metros(?! de| cuadrad)", r"\1 de \2 m2"),
    (r"\b((?:[a-z]+teen|ten|twelve|eleven|twenty|thirty|forty)) (met(?:er|re)s) square\b", r"\1 square \2"),
    (r",? (?:and |who )?they (?:both |all )?sleep in (?:the )?(?:same|one) (?:bed)?room\b(?!,? (?:in|with) )",
     " who share a room"),
    (r"\beverything in one room,? (?:apart from|except|but)(?: for)? the bath ?room\b", "a studio"),
    (r"\b((?:big |large |great |small )?)hall for (?:eating|dining)\b", r"\1dining room"),
    (r",? (?:and )?straight (?:on|ahead),? (?=the |an? |two |three |is |are )", ". ahead "),
    # "wait no, one bathroom", "scratch that, no balcony", "scratch the study"
    (r"\bwait,? (?:no|actually|sorry)\b,?"
     r"(?! ?(?:balcony|terrace|study|office|dining|storage|pantry|utility|laundry|closet))", "no wait, "),
    (r"\bbetter (?=(?:one|two|three|four|five|\d+)\b)", "or better "),
    (r"\b(?:scratch that|no wait|wait|actually|on second thought),? no (balcony|terrace|study|office|dining room|"
     r"storage|storage room|pantry|utility room|laundry|closet)(?= ?(?:[,.;!]|$))", r"forget the \1"),
    # "书房的门开在客厅里", "次卧要离客厅远一点"
    (r"([^,.;:的]{1,6})的门(?:要|应该)?(?:开在|开向|通向|朝)([^,.;:里]{1,6}?)(?:里|开)*(?:[,.;]|$)", r"\1通向\2."),
    (r"离([^,.;:]{1,8}?)(?:尽量|比较|要|更)?远(?:一点|一些|些|点)?(?=[,.;]|$)", r" far from \1"),
    (r"离([^,.;:]{1,8}?)(?:尽量|比较|要|更)?近(?:一点|一些|些|点)?(?=[,.;]|$)", r"靠近\1"),
    (r"(?:面积)?是([^,.;:]{1,8}?)的(?:两|2|二)倍大?", r" twice as large as \1"),
    (r"(?:面积)?是([^,.;:]{1,8}?)的(?:三|3)倍大?", r" three times as large as \1"),
    (r"(?:面积)?是([^,.;:]{1,8}?)的一半", r" half as large as \1"),
    (r"(?<![一两二三四个间1-9])次卧", "第二卧室"),
    # "厨房和客厅之间不要有门", "卫生间在两个卧室之间", "厨房在客厅旁边"
    (r"([^,.;:和]{1,6})和([^,.;:]{1,6})之间(?:不要有|不能有|没有|不要|无)门", r" no door between \1 and \2"),
    (r"在([^,.;:]{1,12}?)之间", r" between \1"),
    (r"(?<=[^,.;:在])在((?!入口|门口|大门)[^,.;:在]{1,6}?)(?:旁边|隔壁|边上)", r"靠近\1"),
    (r"(?<=[,.])(?:哦|啊|噢)?不(?=[,.])", "不对"),
    # "一个储藏室，从厨房进去"
    (r"从([^,.;:从]{1,8}?)(?:进去|进入|进出|进)(?:[,.;]|$)", r"通向\1."),
)]  # fmt: skip


def rephrased(text: str) -> str:
    """A folded text whose verbs and comparisons stand where the rules look for them."""
    text = retold(text)
    text = _OF_WHOM.sub(lambda found: _WHOSE[found[1]], text)
    text = _OPENED.sub(lambda found: f"open plan {found[1].replace('+', ', ')}", text)
    text = _TOGETHER.sub(_doing, text)
    text = _COMPARED.sub(lambda found: f" {'larger' if found[2] == '大' else 'smaller'} than {found[1]}", text)
    for pattern, words in _ORDERED:
        text = pattern.sub(words, text)
    return text


def _doing(found: re.Match[str]) -> str:
    """`Kochen, Essen und Wohnen` as the rooms for it."""
    return re.sub(_DOING, lambda verb: _DE_ROOMS[verb.group()], found.group())
