"""Clauses in an order the rules do not follow, and adverbs that part a verb from its room, in words they know."""


import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded

_ROOM_EN = r"(?:the |an? |our |my )?[a-z'-]+(?: (?:room|hall|closet|wc|area|space))?"
_ROOM_DE = r"(?:de[rmn] |die |das )?[a-z-]+"
_ROOM_FR = r"(?:la |le |les |l')[a-z-]+(?: (?:de |d'|a )(?!cote)[a-z]+)?"
_ROOM_ES = r"(?:el |la |los |las )[a-z]+(?: de [a-z]+| principal)?"
_ROOM_ZH = r"[^,.;:和与跟之间]{1,6}"
_BE = r"(?:there )?(?:is|are|must|should|shall|may|can|will|has|have)? ?(?:to )?(?:there )?(?:be )?"
_END = r"(?= ?(?:[.,;:!)]|$|and |but |so |und |et |y |because ))"
_MORE = r"bed ?room|bath ?room|toilet|wc|balcony|study|room|shower room|store ?room|storage room|closet|terrace|office"
_WHO = ("(?:you|one|we|i|people|nobody|visitors|guests|(?:the|a|my|our) "
        "(?:robot|player|agent|drone|user|wheelchair|character|cat|dog|guests?))")
_VERB = ("flows?|opens?|leads?|connects?|runs?|merges?|blends?|extends?|goes|go|spills?|passes|gives|"
         "open|opening|flowing|leading|connected|linked|joined|attached|accessible|reachable|reached|entered|next|"
         "adjacent|close")  # fmt: skip
_SAID = [(late(pattern), words) for pattern, words in (
    # "flows openly into the kitchen", "is connected seamlessly to it"
    (rf"\b({_VERB}) (?!only\b|solely\b|merely\b|simply\b|exclusively\b|family\b)[a-z]+ly (?=(?:in|on)?to |from |off |"
     r"with |via |through )", r"\1 "),
    # "Between kitchen and bathroom should not be a door", "… there is no door"
    (rf"\bbetween ({_ROOM_EN}) and ({_ROOM_EN}),? {_BE}(?:no|not|without)(?: be| have)?(?: an?| any)? "
     rf"(?:direct |connecting )?doors?(?: be)?{_END}", r"no door between \1 and \2"),
    (rf"\bzwischen ({_ROOM_DE}) und ({_ROOM_DE}) (?:(?:soll|sollen|darf|durfen|muss|ist|sind|gibt|gabe|braucht)(?: "
     rf"es)? "
     rf")?keinen? (?:direkten? )?(?:verbindungs)?tur(?:en)?(?: (?:sein|geben|bestehen))?{_END}",
     r"keine tur zwischen \1 und \2"),
    (rf"\bentre ({_ROOM_FR}) et ({_ROOM_FR}),? (?:(?:il )?(?:n'y a|ne doit pas y avoir|ne doit y avoir|n'y aura) ?)?"
     rf"(?:pas de|aucune|sans|de) (?:porte|communication)s?{_END}", r"pas de porte entre \1 et \2"),
    (rf"\bentre ({_ROOM_ES}) y ({_ROOM_ES}),? no (?:(?:debe|puede|tiene que|ha de|quiero que)(?: haber)?|hay|haya|"
     rf"habra) "
     rf"?(?:ninguna |una )?puertas?{_END}", r"ninguna puerta entre \1 y \2"),
    # "one toilet more", "two bedrooms more"
    (rf"\b(one|two|three|an?|\d) ((?:small |big |large |guest |separate )?(?:{_MORE})s?) more{_END}", r"\1 more \2"),
    # "weder im Wohnzimmer noch im Flur"
    (r"\bweder ([^.;:]+?) noch ", r"neither \1 nor "),
    # "you cannot walk directly from the kitchen into the living room; you have to go through the hallway"
    (rf"\b{_WHO} (?:can ?not|can't|must not|mustn't|should not|shouldn't|may not|is not able to|never)(?: be able to)? "
     rf"(?:walk|go|get|pass|step|move|drive|come)s?(?: directly| straight)* from ({_ROOM_EN})(?: directly| straight)* "
     rf"(?:in|on)?to ({_ROOM_EN}){_END}", r"no door between \1 and \2"),
    (rf"[,;:]? ?(?:but |and |so )?\b{_WHO} (?:always |only )?(?:must|have to|has to|needs? to|should|will) "
     rf"(?:always |first )?(?:go|pass|walk|get|drive|move|come|cross)(?: there)?(?: through| via| by)? "
     rf"the (?:hall|hallway|corridor){_END}", ""),
    # "I don't want that the guests go through the bedroom to the bathroom"
    (rf"\b(?:i|we) (?:do not|don't|would not|wouldn't) (?:want|like)(?: that)? [a-z ]{{3,20}}? (?:to )?(?:goe?s?|"
     rf"walks?|pass(?:es)?|must go|have "
     rf"to go) through ({_ROOM_EN}) (?:in order )?(?:to|into|to get to|to reach|for) ({_ROOM_EN}){_END}",
     r"no door between \1 and \2"),
    # "the living room runs into the kitchen without any wall"
    (r"\b(?:runs?|goes|go|extends?|leads?|opens?|passes|continues?|flows?|blends?)(?: on| straight| directly)*"
     r" (?:in|on)?to ((?:the )?(?:kitchen|living room|dining room|dining area|lounge)),? without (?:any|an?) "
     r"(?:dividing )?"
     r"walls?(?: (?:in )?between(?: them)?)?", r"is open to \1"),
    (r"\b(spills?|spilling|spilled) (?:over )?(?:in|on)?to ", r"open to "),
    # "two bedrooms at opposite ends of the flat"
    (r"\b((?:two|both|the|three) )?(bed ?rooms|bath ?rooms)\b([^.;]*?),? (?:(?:both |which |that )?(?:are |being |lie "
     r"|placed |at))?"
     r"(?:at|on) (?:the )?(?:opposite|different|two|both|far) (?:ends|sides) of (?:the |my |our )?"
     r"(?:flat|apartment|home|house|plan|corridor|hall|hallway|unit)\b", r"\1\2\3. the \2 are far from each other"),
    # "put a table in the kitchen, … put it in the dining room"
    (r"\b(an?|the|one) ([a-z]+) (in(?:to)? [^.;,]+)[.;,] ?((?:but |and |please |rather |instead )*)(put|place|move) "
     r"it in(?:to)? ",
     r"\1 \2 \3. \4\5 a \2 in "),
    # "Do we need a dining room? No."
    (r"(?:\b(?:do|does|should|shall|will) (?:we|i|you|it|the flat|there) (?:need|want|have|be|get) |^|[.;!?] ?)(?:an?|"
     r"any|the) "
     r"([a-z ]{3,16})\?[ ,]*(?:no|nope|not needed|not really)\b[.,;!]?(?= |$)", r". no \1."),
    (r"(?:\b(?:do|does|should|shall|will) (?:we|i|you|it|the flat|there) (?:need|want|have|be|get) |^|[.;!?] ?)(an?) "
     r"([a-z ]{3,16})\?[ ,]*(?:yes|yes please|of course|sure)\b[.,;!]?(?= |$)", r". \1 \2."),
    (r"\ba bed ?room (?:on|at|to) (?:each|either|both) sides? of (?:the|a|one) bath ?room\b",
     "two bedrooms with a bathroom between them"),
    (r"\b((?:the |our |my )?(?:two |three )?(?:twins|kids|children|boys|girls|sons|daughters|teenagers)) (?:both |all "
     r"|each )?"
     r"(want|need|get|have|should have) (?:separate|different|individual|their own) (?:bed ?)?rooms\b",
     r"\1 each \2 a room"),
    (r"\bfull of (?=[a-z]+)", "with "),
    (r"((?:children|kid)'?s'? bath(?:room)?\b[^.]*?)\bour bath(?:room)?\b", r"\1another bathroom"),
    # "en el primero una cama doble, en el segundo dos camas", "im Wohnzimmer kein Fernseher"
    (r"(^|[.,;:] ?|\by )en (?:el|la) (?:(primer[oa]?)|(segund[oa])|(?:el |la )?(otr[oa]))(?: dormitorio| "
     r"habitacion)?,? (?=una? |dos |tres )",
     lambda found: f"{found[1]}the {'first' if found[2] else 'second' if found[3] else 'other'} one has "),
    (r"(^|[.,;:] ?|\bet )dans (?:la|le) (?:(premiere?)|(deuxieme|seconde?))(?: chambre)?,? (?=une? |deux |trois )",
     lambda found: f"{found[1]}the {'first' if found[2] else 'second'} one has "),
    (r"(^|[.,;:] ?|\bund )im (?:(ersten)|(zweiten)|(anderen))(?: schlafzimmer| zimmer)?,? (?=eine? |zwei |drei )",
     lambda found: f"{found[1]}the {'first' if found[2] else 'second' if found[3] else 'other'} one has "),
    (r"(^|[.,;:] ?|\bund )(im|in der) (\w+) (keine?n? \w+)(?= ?(?:[.,;]|$|und ))", r"\1\4 \2 \3"),
    (r"\b(?:des |les |de )?toilettes,? (?:a part|separees|independantes|a cote)\b", "un wc separe"),
    (r"(?:每个|每间|各个)?(卧室|房间)(?:都|各)?(?:带|有)(?:独立|自己的|单独的)?(?:卫生间|浴室)",
     r"every bedroom has its own bathroom"),
    (r"(客厅|餐厅|厨房)(?:和|与|跟)(客厅|餐厅|厨房)(?:都)?(?:是|为|在|做成)(?:同)?一个?大?(?:空间|房间|整体)",
     r"\1, \2 in one open space"),
    # "the kitchen is visible from the lounge, so make it open", "so it should be the biggest room"
    (r"(\bkitchen\b[^.]*?),? (?:so|and|but) (?:please )?(?:make|keep|leave) it open(?: plan)?(?= ?(?:[.,;]|$))",
     r"\1. an open kitchen"),
    (r"(\bthe (kitchen|living room|study|bathroom|dining room|bedroom)\b[^.;]*?),? (?:so|and|but) it (?:should|must|"
     r"is to|has to) be the "
     r"(biggest|largest|smallest)(?: room)?(?= ?(?:[.,;]|$))", r"\1. the \2 is the \3 room"),
    (r"\b(office|study|toilet|wc|bathroom|storage room|kitchen|closet|bedroom|room) (?:right |just |directly )?at the "
     r"(?:entrance|entry|front door)\b",
     r"\1 near the entrance"),
    (r"(?<=[a-z\d])@(?=[a-z])", " off the "),
    (r"\b(bed|bath)(?:room)?s? ?: ?(\d) ?\((\d[\d., ]*\d)\)", r"\2 \1rooms of \3 m2"),
    (r"\b(kitchen|bathroom|bedroom|study|living room) the size of an? (?:closet|cupboard|shoe ?box|match ?box|"
     r"wardrobe)\b", r"tiny \1"),
    (r"^(?:an? |the )?[a-z']+ (?:den|lair|nest|hub) ?:", "a home:"),
    (r"\bavoid (?!that|[a-z]+ing\b)(?:any |the |all )?", "no "),
    (r"\b(?:none|neither) of them (?:off|in|from|inside) (?:an?|any|the) bed ?rooms?\b", "neither of them en "
     "suite"),
    # "a corridor between 1.2 and 1.5 m wide", "bath2 ensuite to bed1", "dining-living open"
    (r"\bbetween (\d+(?:\.\d+)?)(?: ?m)? and (\d+(?:\.\d+)?) ?m(?:et(?:er|re)s)? (wide|long|in width|in length)\b",
     r"at least \1 m \3 and at most \2 m \3"),
    (r"\b(bath ?(?:room)? ?\d),? (?:is )?(?:an? )?(?:en ?suite|ensuite) (?:to|of|for) ", r"\1 off "),
    (r"\b([a-z]+)-([a-z]+) open(?= ?(?:[,;.]|$))", r"\1 open to \2"),
    # "her maid sleeps in a tiny room", "one more small room for baby", "one for each of our three children"
    (r"\bsleeps? in (an?|her|his|their|another) ((?:own |tiny |small |little |large |big |separate |spare |single "
     r"){0,2})room\b",
     r"sleeps in \1 \2bedroom"),
    (r"\b((?:small |little |big |large |tiny )?)room for (?:the |a |our |my )?(?:baby|child|kid|toddler)\b(?! and)",
     r"\1kids room"),
    (r"\bone for each of (?:our|my|the) (two|three|four|[234]) (?:children|kids|sons|daughters|boys|girls)\b",
     r"\1 kids rooms"),
    # "A and B must not be near. Between them put the kitchen."
    (rf"((?:^|[.;] ?)({_ROOM_EN}) and ({_ROOM_EN}) [^.;]*[.;]) ?between them,? (?:you |we )?(?:put|place|there is|"
     rf"comes|goes|is|lies) (the [a-z]+(?: room)?)",
     r"\1 \4 is between \2 and \3"),
    (r"(\b(?:two|both) (?:[a-z]+ )?bed ?rooms\b[^.;]*?next to each other),? (?:and )?with an? (?:connecting )?door "
     r"between(?: them| the two)?",
     r"\1. bedroom 1 has a door to bedroom 2"),
    (r"\b(?:die|der|das) (\w+) (?:darf|soll|hat|muss|sollte) keine tur (?:zum|zur) (\w+)(?: haben)?,? sondern (?:nur "
     r")?(?:eine )?"
     r"(?:zum|zur) (\w+)(?: haben)?", r"no door between \1 and \2. the \1 has a door to the \3"),
    (r"\b(kuche|wohnzimmer|esszimmer) und (kuche|wohnzimmer|esszimmer) (?:gehoren zusammen|sind zusammen|sind eins)\b",
     r"\1 und \2 sind offen"),
    (r"每间(?:房间?|卧室)?(?=放|要|有|都)", "每个卧室"),
    (r"([^,.;:]{1,6}?)(?:不要|不能|不可)(?:和|与|跟)([^,.;:]{1,6}?)(?:相邻|挨着|挨在一起|靠在一起)",
     r"\1 must not be next to \2"),
    (r"\b(comunica|conecta|comunicad[oa]|conectad[oa]) con ((?:el|la) \w+),? y con ", r"\1 con \2 y "),
    (r"\b(communique|communiquant) avec ((?:le|la) \w+),? et avec ", r"\1 avec \2 et "),
    # "la cocina tiene dos puertas, una al pasillo y otra al comedor"
    (r"\b(?:(tiene|tener|tenga)|con) dos puertas[,:]? una (?:al|a la) (\w+),? y (?:la )?otra (?:al|a la) (\w+)",
     lambda found: f"{'has' if found[1] else 'with'} a door to the {found[2]} and a door to the {found[3]}"),
    (r"\b(?:(a)|avec) deux portes[,:]? (?:l')?une (?:vers|sur|donnant sur) (?:le |la |l')(\w+(?: a manger)?),? et "
     r"(?:l'autre|une autre|une)"
     r" (?:vers|sur|donnant sur) (?:le |la |l')(\w+(?: a manger)?)",
     lambda found: f"{'has' if found[1] else 'with'} a door to the {found[2]} and a door to the {found[3]}"),
    (r"\b(?:(hat)|mit) zwei turen[,:]? eine (?:zum|zur|in den|ins|in die) (\w+),? und (?:die andere|eine andere|eine) "
     r"(?:zum|zur|in den|ins|in die) (\w+)",
     lambda found: f"{'has' if found[1] else 'with'} a door to the {found[2]} and a door to the {found[3]}"),
    # "between living room and bedroom should be the kitchen"
    (rf"(^|[.;] ?)between ({_ROOM_EN}) and ({_ROOM_EN}),? (?:there )?(?:should be|must be|is|lies|comes|goes) ((?:the|"
     rf"an?) {_ROOM_EN})(?= ?(?:[.,;]|$))",
     r"\1\4 is between \2 and \3"),
    # "a bathroom I can reach from my bedroom and guests can reach from the hall"
    (rf",? (?:that |which )?{_WHO} can (?:reach|enter|get to|access|go (?:in)?to)(?: straight| directly)* from ",
     " reachable from "),
    (rf"(\breachable from [^.;,]+?),? and (?:that |which )?{_WHO} (?:can )?(?:reach|enter|get to|access|go (?:in)?to) "
     rf"from ", r"\1 and from "),
    (r"(\breachable from [^.;,]+?),? and [a-z]+ can (?:reach|enter|get to|access) from ", r"\1 and from "),
    (rf"\bwhich {_WHO} (?:can )?(?:reach|enter|get (?:in)?to|access) (through|via|from) ", r"which are reached from "),
    # "no walls between living room, dining area and kitchen"
    (rf"\b(?:no|without(?: any)?) walls? between ({_ROOM_EN}), ({_ROOM_EN}),? and ({_ROOM_EN})\b",
     r"\1, \2 and \3 in one open space"),
    # "side by side with a door between them"
    (rf"({_ROOM_EN}) and ({_ROOM_EN}) (?:must be|should be|are|is|be|lie) (?:side by side|next to each other|adjacent|"
     rf"neighbours),? "
     r"(?:with|and have|connected by|joined by) an? (?:connecting )?door between (?:them|the two)",
     r"\1 is next to \2. \1 has a door to \2"),
    # "a bathroom shared by both bedrooms and not reachable from anywhere else"
    (r"\bshared by (both|the two) bed ?rooms,? (?:and|which is|that is|but) not (?:reachable|accessible|entered) "
     r"(?:from|by) "
     r"(?:anywhere else|any other room|elsewhere|the hall(?:way)?)", "between the two bedrooms, with doors to both"),
    # "two doubles and a single"
    (r"(\bdoubles?(?: bed ?rooms?)?)(?:,? and|,) (?:an?|one) single(?= ?(?:[.,;]|$))", r"\1 and a single bedroom"),
    # "every door leads off it", "everything as small as possible"
    (r"\b(?:every|all the|all) doors? (?:leads?|opens?|goes|go|is|are|should be|must be)(?: off| to| onto| into| from|"
     r" on| in)+ "
     r"(?:it|this|the (hall|hallway|corridor))\b", r"all rooms open onto the hallway"),
    (r"\beverything (?:(?:should be|must be|is) )?(?:as (?:small|compact|tight) as possible|very small|tiny|compact)\b",
     "compact"),
    # "the dining room sits between kitchen and living room with doors to both"
    (rf"(?:,? (?:which |that )?(?:is|sits|lies|placed|located|should be))? between ({_ROOM_EN}) and ({_ROOM_EN}),? "
     r"(?:with|and has|having|and with) (?:an? |one )?doors? to (?:both|each|either)(?: of (?:them|these|the two))?",
     r" with a door to \1 and a door to \2"),
    # "short way from bedroom to toilet"
    (rf"\b(?:an? )?(?:short|quick|easy) (?:way|path|walk|distance|route|trip) (?:from|between) ({_ROOM_EN}) (?:to|and) "
     r"(?:the )?(?:toilet|bathroom|bath|loo)\b", r"\1 next to the bathroom"),
    # "three bedrooms: one 10, one 12 and one 15 square metres"
    (r"\b(bed ?rooms|bath ?rooms|balconies)[:,]? (?:one|the first|a) (?:of |is )?(\d+)(?: m2| sqm)?,? (?:and )?(?:one|"
     r"the second|a|"
     r"the other) (?:of |is )?(\d+)(?: m2| sqm)?,? (?:and )?(?:one|the third|a) (?:of |is )?(\d+) (m2|sqm|square "
     r"met(?:er|re)s)",
     r"\1 of \2, \3 and \4 m2"),
    (r"\b(bed ?rooms|bath ?rooms|balconies)[:,]? (?:one|the first|a) (?:of |is )?(\d+)(?: m2| sqm)?,? (?:and )?(?:one|"
     r"the second|a|"
     r"the other) (?:of |is )?(\d+) (m2|sqm|square met(?:er|re)s)", r"\1 of \2 and \3 m2"),
    # "one for the boys with two beds"
    (r"(?<!flat )(?<!apartment )(?<!house )(?<!home )(?<!studio )(?<!place )\bwith (two|three|[23]) beds\b"
     r"(?!,? ?(?:and |& )?(?:one|two|an?|\d) bath)", r"with \1 double beds"),
    # "connect everything to a corridor", "link all rooms to the hall"
    (r"(^|[.;,:] ?|\band )(?:please )?(?:connect|link|join|attach) (everything|(?:all|every) (?:the |other |of the "
     r")?rooms?)"
     r"(?: up)? (?:to|with) ", r"\1all rooms open onto "),
    # "in the first there is a big bed", "in the second two small beds"
    (r"(^|[.,;:] ?|\band )in ((?:the (?:first|second|third|other|smaller|larger|bigger|main)(?: one| bed ?room)?|each|"
     r"both)),?"
     r" (?:there )?(?:is|are|must be|should be|i want|we want|i need|put|goes|go|stands?) ", r"\1\2 has "),
    (r"\b(has|have|with|put|is|are|for|in) (an?|one|two|three|\d) (?:small|little|narrow) bed(s?)\b",
     r"\1 \2 single bed\3"),
    (r"\b(has|have|with|put|is|are|for|in) (an?|one|two|three|\d) (?:big|large|wide|king[- ]size|queen[- ]size) "
     r"bed(s?)\b",
     r"\1 \2 double bed\3"),
    # "I hear everything", of no room
    (rf"\b(i|we|he|she|they|you|one|who) ((?:can |will |could )?(?!want|need|have|put|keep)[a-z]+) everything{_END}",
     r"\1 \2"),
)]  # fmt: skip


_LINED = re.compile(
    r"\b(?:(?:\d|two|three|four|five|six|seven) )?(?:rooms|spaces) (?:(?:arranged |laid out )?in (?:a|one) (?:single "
    r")?(?:line|row|chain|"
    r"sequence|series)|one after (?:another|the other))[^:;.]*?(?:, | - |: ?)(?P<first>(?:an? |the )?[a-z ]+(?:, | -> "
    r"| and )[^.;]+)"
)
_STUDIO_BED = re.compile(r"(?<!one )(?<!1 )(?<!two )(?<!2 )\bbed (?=(?:near|by|under|opposite|in|at|next|against|"
    r"behind|on)\b)|(?<=\bthe )bed\b")


def _in_line(found: re.Match[str]) -> str:
    """`five rooms in a line: hall, lounge, kitchen` as a chain of doors."""
    tail, after = found["first"], ""
    if ", each" in tail:
        tail, after = tail.split(", each", 1)
    names = [name for name in re.split(r", (?:and )?| -> | and |->", tail) if name]
    return " -> ".join(names) + ("" if "->" in after else "")


def turned(text: str) -> str:
    """A folded text with such clauses in the usual order."""
    text = reworded(text, _SAID)
    text = _LINED.sub(_in_line, text) if "rooms in" in text or "one after" in text else text
    return _STUDIO_BED.sub("double bed ", text) if "studio" in text and "bedroom" not in text else text
