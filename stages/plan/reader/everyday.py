"""Places, neighbours, sizes, rooms in one and rooms not wanted, as five languages say them every day."""

import re

from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_WAY_IN_DE = r"(?:eingang|eingangstur|wohnungstur|haustur|tur)"
_SIDE = r"(?:norte|sur|este|oeste|noreste|noroeste|sureste|suroeste)"
_ONE = r"(?:one|a|an|the same|a single|one single|one big|one large)"
_GRATEFUL = r"(?:i|we)(?: would| will|'d|'ll) be (?:very |most |so )?(?:grateful|happy|glad|thankful|pleased)"
_LIVED_DE = r"(?:kuche|wohnzimmer|esszimmer|essbereich|wohnraum)"

_OF_IT = late(rf"({KIND})[^.;]*?\b(?:left|right|north|south|east|west) of it\b")


def _behind(found: re.Match[str]) -> str:
    """`the lounge in the middle, a study left of it, the kitchen behind it`: beside the room that all are told from."""
    hub = _OF_IT.search(found.string[: found.start()])
    return f"next to the {hub[1]}" if hub else f"next to {found.group().split()[-1]}"


def _not_through(found: re.Match[str]) -> str:
    """`reach the bath from the bedrooms without crossing the lounge`: the bath has no door to it."""
    more = f". {found['home']}" if found["home"] else ""
    return f"{found['of']} must not open into {found['by']}{more}"


def _signed(found: re.Match[str]) -> str:
    """`thanks, Anna`: a name, unless the reader knows the word."""
    return found.group() if (found["name"],) in read_lexicon().entries else ""


def _whose_most(found: re.Match[str]) -> str:
    """`the biggest one is for my parents`: theirs is the biggest."""
    who = found["who"].split()[-1]
    room = {"guests": "guest room", "visitors": "guest room", "parents": "parents' bedroom", "us": "parents' bedroom",
            "me": "parents' bedroom"}.get(who, "kids room")  # fmt: skip
    more = f". the {room}{found['more'].removeprefix(' and')}" if found["more"] else ""
    return f"{found['said']}the {room} is the {found['most']} of the bedrooms{more}"


_PLACES = (
    # "con orientación norte", "avec exposition sud", "mit Nordausrichtung"
    (r"\bcon (?:una )?orientacion (?:al |hacia el )?(?=(?:{side})\b)", "orientada al "),
    (r"\b(?:avec )?(?:une )?(?:exposition|orientation) (?:au |vers le )?(?=(?:nord|sud|est|ouest)\b)", "exposee "),
    # "the study faces the kitchen", "liegt der Küche gegenüber", "书房在厨房对面"
    (r"\b(?P<a>the {kind}) (?:{must} )?faces? (?P<b>the (?!{outside}){kind}){end}", r"\g<a> is opposite \g<b>"),
    (r"\b(?:liegt|ist|befindet sich) (?:direkt )?(?:der|dem|den) (?P<of>{de}) gegenuber\b",
     r"liegt gegenuber der \g<of>"),
    (r"在(?P<of>{zh})的?(?:正)?对面", r" opposite \g<of>"),
    (r"(?P<of>{zh})(?:的)?(?:旁边|隔壁)(?:有|是|设|放)(?:一个|个|一间)?(?P<new>{zh})", r"\g<new>在\g<of>旁边"),
    # "right at the entrance", "just inside the front door", "an der Eingangstür", "a la entrada", "在门口"
    (r"\b(?:right |directly |just )?(?:at|inside) the (?:entrance|front door|entry door|entrance door){end}",
     "near the entrance"),
    (r"\b(?:should be |is |must be )?the first room (?:that )?(?:you|one|we|i) (?:come to|enter|see|reach)\b",
     "is near the entrance"),
    (r"\b(?:direkt )?(?:am|an der|an dem|gleich am) (?={way_in}{end})", "beim "),
    (r"\bbeim (?:eingangstur|wohnungstur|haustur|tur)\b", "beim eingang"),
    (r"(?<!hall )(?<!salle )\ba l'entree(?: de l'appartement)?{end}", "pres de l'entree"),
    (r"\b(?:a cote|pres) de la porte(?: d'entree)?{end}", "pres de l'entree"),
    (r"(?<!pegado )(?<!junto )\b(?:a|en) la entrada(?: del piso| de la casa)?{end}", "cerca de la entrada"),
    (r"\b(?:junto a|al lado de|cerca de) la puerta(?: de entrada| principal)?{end}", "cerca de la entrada"),
    (r"在(?:大门口?|门口|入口处?|进门处)(?:旁边|附近)?(?=[,.;]|$)", "靠近入口"),
    # "the study and the kitchen should be apart"
    (r"\b(?P<a>the {kind}) and (?P<b>the {kind}) (?P<be>{must} (?:be|lie)|are) (?:kept )?(?:well |far )?apart"
     r"(?: from each other)?{end}", r"\g<a> \g<be> far from \g<b>"),
    # "jouxte la cuisine", "contre la cuisine", "bei der Küche", "grenzt an die Küche"
    (r"\bjouxte(?:nt)? (?=l[ae] )", "est a cote de "), (r"\bcontre (?=l[ae] {fr})", "a cote de "),
    (r"\bbei (?:der|dem) (?={de})", "neben der "),
    (r"\bgrenzt (?:direkt |unmittelbar )?an (?:die|das|den|der|dem) (?={de})", "liegt neben der "),
)  # fmt: skip
_BESIDE = (
    # "away from the lounge and the entrance", "on opposite sides of the living room", "left and right of it"
    (r"\b(?:far )?(?:away|far) from (?P<of>the {kind}) and (?:from )?the (?:entrance|front door){end}",
     r"far from the entrance and far from \g<of>"),
    (r"\bbed ?rooms (?:both )?on opposite sides of (?P<of>the (?!{hall}){kind}){end}",
     r"bedrooms next to \g<of>. the bedrooms are far from each other"),
    (r"\b(?:two |the |both )?bed ?rooms (?:to the |on the )?left and (?:to the |on the )?right of "
     r"(?P<of>it|the {kind})\b",
     r"one bedroom to the left of \g<of>, one bedroom to the right of \g<of>"),
    (r"\bbehind (?:it|them)\b", _behind),
    # "a guest room with its own bathroom near the entrance": the room is there
    (r"\b(?P<of>(?:bed ?)?room) with (?P<bath>(?:its|his|her|their) own (?:bath ?room|shower room|bath|toilet)) "
     r"(?P<at>(?:near|close to|next to|at|by) the (?:entrance|front door|front|back|rear)){end}",
     r"\g<of> \g<at> with \g<bath>"),
    # "close to ours and the guest room as far away as possible", "reach the bath from the bedrooms without crossing it"
    (r"(\b(?:close|next|near) to ours),? (?:and|but) (?P<of>the {kind}) (?:as )?far away(?: as possible)?{end}",
     r"\1. \g<of> is far from the parents' bedroom"),
    (r"\b(?:you|one|we|everyone|everybody|people|guests) (?:{must} )?(?:be able to )?(?:reach|get to|go to) "
     r"(?P<of>the {kind}) (?:from (?P<home>the {kind}s?) )?without (?:crossing|going through|passing(?: through)?|"
     r"walking through|having to (?:cross|go through|pass)) (?P<by>the {kind}){end}", _not_through),
    # "I need storage: a closet, a pantry", "an L-shaped living and dining room"
    (r"\b(?:lots of |enough |plenty of |more |some )?storage(?: space)? ?: ?(?=(?:an? |one |two )?(?:walk-in|pantry|"
     r"closet|broom|linen|larder|store))", ""),
    (r"\b(?P<a>an?|one|the) (?P<size>(?:[a-z-]+ ){0,2}?)living and dining (?:room|area|space)\b",
     r"\g<a> \g<size>living-dining room"),
)  # fmt: skip
_OPEN = (
    # "the kitchen is part of the living room", "an American kitchen", "kitchen and living room share one space"
    (r"\bkitchen (?:is|should be|must be|will be) (?:a )?part of the (?=living|lounge|sitting|dining|main)",
     "kitchen is open to the "),
    (r"\bamerican(?:[ -]style)? kitchen\b", "open kitchen"),
    (r"\b(?P<a>(?:the )?{lived}) and (?P<b>(?:the )?{lived}) (?:{must} )?(?:share|form|make|are|be) {one} (?:open )?"
     r"(?:space|room|area){end}", r"\g<a> and \g<b> in one"),
    (r"\b(?:one |an? )?(?P<size>(?:large |big |small )?)(?:open |single |combined )*living and (?:kitchen|cooking) "
     r"(?:area|room|space)\b", r"\g<size>kitchen/living room"),
    (r"\bmit integrierter kuche\b", "mit offener kuche"),
    (r"\b(?P<a>{lived_de}) und (?P<b>{lived_de}) (?:sind |bilden |liegen |sollen |als )?(?:in )?"
     r"(?:ein|einen|einem|einem einzigen|einem gemeinsamen) (?:raum|zimmer)(?: sein| bilden)?\b",
     r"\g<a> und \g<b> sind offen"),
    (r"\bcuisine integree (?:au|dans le) (?=salon|sejour)", "cuisine ouverte sur le "),
    (r"\bcuisine integree\b", "cuisine ouverte"),
    (r"(?P<a>厨房|客厅|餐厅)(?:要)?对(?P<b>厨房|客厅|餐厅)(?:是)?(?:开放|敞开)", r"\g<a>和\g<b>相通"),
    # "Küche mit Tür"
    (r"\bkuche mit (?:einer )?(?:eigenen )?tur\b(?! (?:zu|in))", "separate kuche"),
)  # fmt: skip
_BETWEEN = (
    # "one bathroom. There should be a door between the kitchen and the dining room": said of no room before
    (r"\bthere {must} be (?=(?:an? |one |no )?(?:[a-z]+ )?doors? between )", "there is "),
    (r"\b(?:il (?:doit|devrait|faudrait) y avoir|il faut|il y a|il y aura) une porte entre (?=l[ae] |l')",
     "there is a door between "),
    (r"\b(?:(?:debe|deberia|tiene que|puede|ha de) haber|hay|que haya|habra) una puerta entre (?=el |la )",
     "there is a door between "),
    (r"\b(?:es|da) (?:soll|sollte|muss) (?:bitte )?eine tur zwischen (?P<of>[^.,;]+?) (?:geben|sein)\b",
     r"there is a door between \g<of>"),
    (r"\bzwischen (?P<of>(?:de[mr] )?{de} und (?:de[mr] )?{de}) (?:soll|sollte|muss) eine tur sein\b",
     r"there is a door between \g<of>"),
)  # fmt: skip
_NOT = (
    # "but not a balcony", "a balcony isn't important", "auf einen Balkon können wir verzichten"
    (r"\bbut not (?:an? )(?=(?:{kind}){end})", "but no "),
    (r"\b(?:an? |the )?(?P<of>{kind}) (?:is not|isn't|are not) (?:so |that |very |really )?(?:important|essential|"
     r"a must|necessary|required){end}", r"no \g<of>"),
    (r"\bauf (?:eine[nm]?|de[nm]|die|das) (?P<of>{de}) (?:konnen|kann|mochten|wollen|wurden) (?:wir|ich|man) "
     r"(?:gerne? |auch )?verzichten\b", r"kein \g<of>"),
    (r"\b(?:wir|ich) verzichten? (?:gerne? )?auf (?:eine[nm]?|de[nm]|die|das) (?P<of>{de})", r"kein \g<of>"),
    (r"\b(?:eine? |der |die |das )?(?P<of>{de}) (?:ist |sind )?nicht (?:notig|notwendig|wichtig|erforderlich){end}",
     r"kein \g<of>"),
    (r"\b(?:on|nous|je) n'(?:a|avons|ai) pas besoin (?:de |d')(?:une? )?", "pas de "),
    (r"\b(?:je|nous|on) ne (?:veux|voulons|veut|souhaite|souhaitons|desire) pas (?=de |d')", "pas "),
)  # fmt: skip
_OF = (
    # "three bedrooms; the biggest one is for my parents and has a closet"
    (r"(?P<said>\b{several} bed ?rooms\b[^.]*?[;:,.] ?)(?:and )?the (?P<most>biggest|largest|smallest)"
     r"(?: one| bed ?room)? (?:is|will be|should be) for (?P<who>(?:my |our |the )?"
     r"(?:parents|guests|visitors|baby|kids|children|son|daughter)|us|"
     r"my (?:wife|husband|partner) and me)\b(?P<more> and (?:has|gets|needs) )?", _whose_most),
    # "25 square meters of living room and 10 of kitchen", "25平方米的客厅", "客厅面积25平方米"
    (r"(?:\b(?:about|around|roughly|approx(?:imately|\.)|ca\.|circa|some|exactly|just|only) |~)?"
     r"\b(?P<n>{amount} ?(?:{unit}|ft2))\.? of (?P<of>{kind})\b", r"\g<of> of \g<n>"),
    (r"(?P<unit>{unit}) and (?P<n>{amount}) of (?P<of>{kind})\b", r"\g<unit> and \g<of> of \g<n> \g<unit>"),
    (r"(?P<n>\d+(?:\.\d+)?) ?(?:平方米|平米|平方|平|m2)的?(?P<of>大?(?:客厅|厨房|餐厅|主卧室?|次卧室?|"
     r"书房|卫生间|浴室|阳台|儿童房|客房|储藏室|玄关))(?!\d)", r"\g<of>\g<n>平方米"),
    (r"(?P<of>{zh})的?面积(?:为|是|约|大约|大概|要)?(?=\d)", r"\g<of>"),
    # "a bathroom attached", "the other bathroom is for everybody", "la principale avec sa salle de bain"
    (r"\ban? (?P<of>bath ?room|shower room) attached\b(?! to)", "an ensuite bathroom"),
    (r"\bbath(?P<s> ?)room is for (?:everybody|everyone|all(?: of us)?|the whole family){end}",
     r"bath\g<s>room is shared"),
    (r"(?<!chambre )\bla principale (?=avec|a |ayant|dispose|possede)", "la chambre principale "),
    (r"自己的(?=卫生间|浴室)", "独立"),
)  # fmt: skip
_THINGS = (
    # "dans le salon il y a un canapé", "four chairs" in Chinese
    (r"\b(?:dans|en) (?P<of>(?:le|la|chaque|notre|ma) {fr}) ?[,:]? ?(?:il y (?:a|aura|aurait) |il faut |"
     r"se trouve(?:nt)? |je (?:veux|voudrais) |nous (?:voulons|voudrions) )"
     r"(?=(?:une?|des|deux|trois|quatre|cinq|six|\d)\b)", r"\g<of> avec "),
    (r"(\b(?:salon|sejour|cuisine)\b avec (?:[^.;]*?(?:,| et) )?)un bureau\b", r"\1une table de travail"),
    (r"(\b(?:salon|sejour)\b avec (?:[^.;]*?(?:,| et) )?)une bibliotheque\b(?! murale)", r"\1une bibliotheque murale"),
    (r"(?P<n>[一两二三四五六七八\d])(?:把|张|盏|台|架|组|套)"
     r"(?=椅子|餐椅|桌子|餐桌|沙发|床|书桌|台灯|钢琴)", r"\g<n>个"),
)  # fmt: skip
_POLITE = (
    # "kind regards, Anna", "thanks in advance", "viele Grüße", "merci d'avance", "me gustaría", "你好，请帮我设计"
    (r"\b(?:(?:kind|best|warm) regards|sincerely|cordialement|(?:viele|liebe|beste) grusse|mit freundlichen grussen|"
     r"un saludo|saludos|atentamente)\b[,.]? ?(?:[a-z]+ ?){0,2}[.!]?$", ""),
    (r"\b(?:thanks?|thank you|danke|merci|gracias)(?: a lot| very much)? "
     r"(?:in advance|im voraus|d'avance|de antemano)\b", ""),
    (r"\b(?:many |a thousand )?(?:thanks|thank you|danke|merci|gracias), (?P<name>[a-z]+)[.!]?$", _signed),
    (r"\b{grateful} if (?P<of>the {kind}) (?:had|could have|would have)\b", r"\g<of> has"),
    (r"\b{grateful} (?:if|for)\b", ""),
    (r"^(?:dear (?:sir(?: or |/)madam|architect|sir|madam|all|team|designer)s?|"
     r"good (?:morning|afternoon|evening|day)|greetings)\b,? ?", ""),
    (r"\bme gustaria(?:n)?\b", "quiero"), (r"(?:你好|您好|谢谢您?|多谢|麻烦你?|请?帮我们?(?=设计|画|做))", ""),
    # "an office/guest room", "an extra bedroom for visitors"
    (r"\b(?P<of>(?:home )?office|study) ?/ ?(?=guest (?:bed)?room)", r"\g<of> which also serves as a "),
    (r"\b(?P<of>(?:home )?office|study) (?:that|which) is also (?:the |a |our )?(?=guest (?:bed)?room)",
     r"\g<of> which also serves as a "),
    (r"(?<=书房)兼(?:作|做|任)?(?=客房|客卧)", " which also serves as "),
    (r"\b(?P<a>an?|one|another) (?:extra |spare |further |additional )?bed ?room for (?:our |the )?"
     r"(?:visitors|guests){end}", r"\g<a> guest room"),
    (r"\bchambre pour (?:les |nos |des )?(?:invites|visiteurs|amis){end}", "chambre d'amis"),
    (r"\b(?:cuarto|habitacion|dormitorio) para (?:los |nuestros )?(?:invitados|huespedes){end}",
     "habitacion de invitados"),
    (r"(?P<n>[一两二三四五])[个间](?P<size>\d+(?:\.\d+)?) ?(?:平方米|平米|平|m2)的?(?P<of>卧室|房间)",
     r"\g<n>个\g<of>,每个\g<size>平方米"),
)  # fmt: skip
_LIMITS = (
    # "9+ m²", "ab 9 m²", "bis 5 m²", "9平米以上", "5平米以内"
    (r"\b(\d{1,3}) ?\+ ?(?=m2\b|sqm|sq\.? ?m|square)", r"at least \1 "),
    (r"\bab (?=\d+(?:[.,]\d+)? ?(?:m2|qm|quadratmeter))", "mindestens "),
    (r"(?<!\d )(?<!m2 )(?<!qm )\bbis (?:zu )?(?=\d+(?:[.,]\d+)? ?(?:m2|qm|quadratmeter))", "hochstens "),
    (r"(?P<n>\d+(?:\.\d+)? ?(?:平方米|平米|平|m2))(?:以上|起步?)", r"至少\g<n>"),
    (r"(?P<n>\d+(?:\.\d+)? ?(?:平方米|平米|平|m2))(?:以内|以下|之内)", r"最多\g<n>"),
    # "3 Zi. Wohnung", "trois chambres identiques", "三个一样大的卧室"
    (r"\b([1-6]) ?-?zi\b\.?(?![a-z])", r"\1 zimmer"),
    (r"\bidentiques\b", "de meme taille"), (r"\bidentic[oa]s\b", "iguales"),
    (r"(?P<n>[一两二三四五六1-6])[个间](?:一样大|同样大小?|大小(?:一样|相同))的?(?=卧室|房间|睡房)",
     r" equal sized \g<n>个"),
    (r"(?<=卧室|房间)(?:都|要|大小|面积)*(?:一样大|一样|相同|相等)(?=[,.;]|$)", " of equal size"),
    # "a balcony in front of the living room", "el baño no debe dar a la cocina", "卫生间的门不要开向厨房"
    (r"(?P<of>{outside}) (?:in front of|outside|before) (?=the {kind})", r"\g<of> off "),
    (r"\b(?:no (?:debe|puede|tiene que|deberia) (?:dar|abrir(?:se)?)|sin (?:una )?puerta|no (?:tiene|tenga) (?:una )?"
     r"puerta|no debe tener (?:una )?puerta) (?=al? |hacia )", "no da "),
    (r"\b(?P<of>(?:das|die|der) {de}) ohne (?:eine )?tur (?=zu[rm] )", r"\g<of> hat keine tur "),
    (r"(?P<a>{zh})的?门(?:不要|不能|不可以?|别)(?:开向|开在|朝向?|通向|对着)(?P<b>{zh})",
     r" no door between \g<a> and \g<b>"),
)  # fmt: skip
_SAID = rules((*_PLACES, *_BESIDE, *_OPEN, *_BETWEEN, *_NOT, *_OF, *_THINGS, *_POLITE, *_LIMITS), side=_SIDE,
              way_in=_WAY_IN_DE, one=_ONE, grateful=_GRATEFUL,
              lived_de=_LIVED_DE,
              lived=r"(?:living room|kitchen|dining room|lounge|dining area|living area)")  # fmt: skip


def every_day(text: str) -> str:
    """A folded text with such clauses in words that the rules know."""
    return reworded(text, _SAID)
