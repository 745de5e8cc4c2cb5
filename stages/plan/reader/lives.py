"""What people tell of how they live before they name their rooms, and slips of fingers, in words the rules know."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, reworded, rules

_SLIPS = {
    "adn": "and", "nad": "and", "wiht": "with", "wtih": "with", "teh": "the", "opne": "open", "mian": "main",
    "flta": "flat", "nxt": "next", "oposite": "opposite", "opposit": "opposite", "oppsite": "opposite",
    "betwen": "between", "bewteen": "between", "beetween": "between", "shoud": "should", "shuold": "should",
    "largst": "largest", "bigest": "biggest", "smalest": "smallest", "acess": "access",
}  # fmt: skip
"""Words so mistyped that they are no others, nor names of rooms, which are corrected where they are read."""
_SLIP = re.compile(rf"\b(?:{'|'.join(_SLIPS)})\b")
_KIN = rf"(?:{ELDER}|(?:mother|father|parents)-in-law|brother|sister|cousin|nephew|niece|client|lady|gentleman)"
_HIS = late(rf"\b(?:my|our|an?) (?:(?:elderly|old|disabled|sick) )?(?P<who>{_KIN})\b[^.;]*[.;,] ?(?:[a-z]+ ){{0,3}}"
            r"(?P<his>his|her) (?:own )?(?:bed ?)?room\b")  # fmt: skip
_COUNTED = re.compile(r"\b(?:one|two|three|four|five|\d)[ -](?:[a-z]+ )?bed ?rooms?\b")
_LARGE, _SMALL = (late(rf"\bthe (?:{words}) bed ?room\b") for words in ("big|bigger|large|larger", "small|smaller"))
_SHARERS = late(r"\b(?:for |with )?(two|three|four|five|six|[2-6]) (?:[a-z-]+ )?(?:(?:flat|house|room)mates|friends|"
                r"students|colleagues|tenants|adults|lodgers|nurses|trainees)\b")  # fmt: skip
_EACH = re.compile(r"\b(?:each|every|all)(?: of)?(?: the)? bed ?rooms?\b|\bthe bed ?rooms\b")
_ROOMS_OF = "(?:bed ?room|room|bath ?room)"
_GIVEN_UP = r"(?:won't|will not|shan't|are not going to|aren't going to) (?:have|want|need|be having)"
_NACH = {"nord": "norden", "sud": "suden", "ost": "osten", "west": "westen"}
_THING = (r"(?:desks?|piano|table|sofa|wardrobes?|beds?|cot|armchair|bookshel(?:f|ves)|bookcase|dresser|rug|television|"
          r"tv)")  # fmt: skip
_MOVED = r"(?:(?:washing machine|dryer|desk|piano|freezer|fridge|dishwasher|wardrobe))"


def _whose(text: str) -> str:
    """`I look after my father. His room …, my own room …` as bedrooms of the two, where none are counted."""
    found = _HIS.search(text)
    if found is None or _COUNTED.search(text):
        return text
    before, after = text[: found.start("his")], text[found.start("his") :]
    after = re.sub(rf"\b{found['his']} (?:own )?(?:bed ?)?room\b", f"my {found['who']}'s bedroom", after)
    after = re.sub(r"\b(one|an?)(?: (?:bed ?)?room)? for (?=(?:my|our|us|me|the)\b)", r"\1 bedroom for ", after)
    return before + re.sub(r"\b(my|our) (?:own )?room\b", r"\1 bedroom", after)


def _two_sizes(text: str) -> str:
    """`she has the big bedroom, I have the small bedroom`: two, where none are counted."""
    if _LARGE.search(text) is None or _SMALL.search(text) is None or _COUNTED.search(text):
        return text
    return f"two bedrooms. {text}"


def _nothing_else(found: re.Match[str]) -> str:
    """`…, that's it` behind rooms without which nobody lives is no word on the others."""
    said = found.string[: found.start()]
    return found.group() if re.search(r"\bkitchen", said) and re.search(r"\bbath|\bshower|\btoilet", said) else "."


def _second_and_mine(found: re.Match[str]) -> str:
    """`one bedroom for him next to the bathroom, one for me` as two, of which his is the second."""
    return f"two bedrooms{f'. the second bedroom{found[1]}' if found[1].strip() else ''}"


def _son_and_daughter(found: re.Match[str]) -> str:
    """`our son wants the room next to the bathroom, our daughter the one next to us`: whose each is."""
    first, second = (re.sub("^us$|^ours$", "our bedroom", found[k]) for k in (3, 6))
    return f"our {found[1]}'s bedroom is {found[2]} {first}. our {found[4]}'s bedroom is {found[5]} {second}"


def _for_each(found: re.Match[str]) -> str:
    """`a bedroom for me, one for her, one for him` as three."""
    return f"{('two', 'three', 'four')[min(found[1].count(' for '), 3) - 1]} bedrooms"


def _each_of_many(text: str) -> str:
    """`a flat for three students, each bedroom at least 10 m²`: three bedrooms, where none are counted."""
    found = _SHARERS.search(text)
    if found is None or _EACH.search(text) is None or _COUNTED.search(text):
        return text
    return f"{text[: found.start()]}with {found[1]} bedrooms{text[found.end() :]}"


_SAID = rules((
    # "we won't have a dining room", "there is no space for a proper office", "I was going to ask for a dining room,
    # but"
    (r",? ?(?:(?:because|since|as) )?\b(?:we|i|they) {given_up} (?:an? |any )(?:proper |separate |real )?({kind}){end}",
     r", no \1"),
    (r"\bthere(?:'s| is) no (?:space|room|need|place) for an? (?:(?:proper|separate|real|extra) )?({kind})\b",
     r"no \1"),
    (r"\b(?:i|we) (?:was|were) (?:going|about|planning) to (?:ask for|have|want|request|include|get) (?:an? |the )?"
     r"({kind}),? but (?:now )?", r"no \1, "),
    (r"\b(?:we'd rather |we would rather |i'd rather |we |i )?eat in the (kitchen|living room),? (?:so|with|hence) "
     r"((?:an? |one |two |four |six ).*?) there{end}", r"\2 in the \1"),
    # "no bedroom above 14 m²"
    (r"\b(?:no|none of the) ({rooms_of})s? (?:is |are |may be |should be )?(?:above|over|(?:larger|bigger|more) than|"
     r"of more than|exceeding) ({amount} ?{unit})", r"each \1 at most \2"),
    (r"\b(?:no|none of the) ({rooms_of})s? (?:is |are |may be |should be )?(?:below|under|(?:smaller|less) than|of "
     r"less than) ({amount} ?{unit})", r"each \1 at least \2"),
    # "Three of us share a flat", "four kids: the twins share", "one that they share, with two single beds"
    (r"\b({several}) of us (?:want to |will |are )?(?:rent|renting|live|living|share|sharing)\b(?: (?:a|the|this|one) "
     r"(?:flat|apartment|house|place|home))?(?: together)?(?!.*\b{number} (?:[a-z]+ )?(?:bed ?)?rooms\b)(?P<and>,? "
     r"(?:and|so) (?=we ))?",
     lambda found: f"{found[1]} flatmates{'. ' if found['and'] else ''}"),
    (r"\b((?:three|four|five|[345]) (?:kids|children))([:,;.] ?| - |,? of whom )the twins share\b",
     r"\1\2two of them share"),
    (r"({young}[^;]*?)\b(?:one|a (?:bed ?)?room) (?:that |which )?they (?:both |all )?share(?:,(?= with)|(?= with)|"
     r"{end})",
     r"\1a kids bedroom"),
    # "the rest of the month I use that room as my office"
    (r",? ?(?:and |but )?(?:(?:the rest of the (?:month|week|year|time)|otherwise|else),? )?(?:i|we) (?:also )?use "
     r"(?:that|this|the same|it)(?: room)? as (?:my|our|an?) (?:home )?(?:office|study|workroom|studio){end}", ""),
    # "it stands in the kitchen today; please move it to a laundry room"
    (r"\b(?:our|my|the) ({moved}) (?:stands|is) in the {kind} (?:today|now|at the moment|currently)[^.;]*[.;] "
     r"?(?:please )?(?:move|put) it (?:to|into|in) (an?|the) ({kind}|laundry room|utility room)", r"\2 \3 with a \1"),
    # "please not any door from the lounge", "not more big than 65 m²", "I wanted it in the front but now prefer the
    # back"
    (r"\bnot any (?=doors?\b|windows?\b|balcony\b)", "no "),
    (r"\b(?:is |must be |should be )?(?:not|no) more (?:big|large) than (?=\d)", "at most "),
    (r"\bmore (big|large|small) than\b",
     lambda found: {"big": "bigger", "large": "larger", "small": "smaller"}[found[1]] + " than"),
    (r"\b(?:at first |first )?(?:i|we) wanted (an?|the) ({kind}) (?:in|at|on) the [a-z]+,? but (?:now )?(?:i|we) "
     r"(?:prefer|want|would like)(?: to have)? it (?:in|at|on) the (front|back|left|right|north|south|east|west)\b",
     r"\1 \2 in the \3"),
    (r"\b(?:we have )?(?P<n>two|three|four|[234]) (?:{young}|childs) (?:and |who )?(?:they )?(?:all )?(?:sleeps?|"
     r"share)(?: all)?(?: together)? in (?:the same|one) (?:bed ?)?room(?:, so (?:this|that|it|the) ?(?:room)? "
     r"(?:must|should|needs to|has to) (?:have|be))?", "the children's bedroom"),
    (r"\b(?:my (?:wife|husband|partner) and (?:me|i)|we|us) (?:sleep |are )?in (?:the |an)?other (?:bed ?)?room{end}",
     "a bedroom for us"),
    # "two bedrooms. main bedroom faces south"
    (r"([.;,] ?)((?:main|master) bed ?room (?:is|are|faces|has|should|must|needs|gets|opens|lies)\b)", r"\1the \2"),
    # "a small room for my assistant", "a place for me and my son", "we are four nurses on different shifts"
    (r"\b(an?|one|the) ((?:small |large |big |little |quiet |second |third |extra |separate )?)room (?=for (?:my|our|"
     r"an?|the) (?:live-in |visiting |elderly )?(?:assistant|carer|nurse|au pair|nanny|helper|housekeeper|lodger|maid|"
     r"{elder}|{child}|brother|sister)\b)", r"\1 \2bedroom "),
    (r"\b(?:for|of) (?:just )?(?:me|myself) and (?:my|our) (?=(?:son|daughter|boy|girl|kid|child|nephew|niece|brother|"
     r"sister|{elder})\b)(?!.*\b{number}[ -](?:[a-z]+ )?(?:bed ?)?rooms?\b)([a-z]+)",
     r"with a bedroom for me and a bedroom for my \1"),
    (r"\bwe(?: are|'re) (?P<n>{several}) (?P<who>(?:young |old |male |female |medical |phd )?(?:{grown}|nurses|doctors|"
     r"interns|trainees|musicians|artists|cousins|girls|guys)) (?:on|in|at|from|with|who) [^.;,]+?[,.;](?: so)?",
     r"for \g<n> flatmates."),
    # "my office is also the guest room", "the kids' rooms at opposite ends", "could the laundry be in the bathroom"
    (r"\b(?:my|our|the) ((?:home )?office|study|workroom) (?:is|should be|must be|will be) also (?:be )?(?:the|our|"
     r"an?) (?=guest (?:bed ?)?room)", r"a \1 also used as "),
    (r"\b(?:so )?(?:please )?(?:put|place|keep|have) (?:their|the kids'?|the children's|the boys'|the girls'|the two) "
     r"(?:bed ?)?rooms (?:at|on|in) (?:the )?opposite (?:ends|sides|corners)(?: of the (?:flat|house|home|apartment))?",
     "the bedrooms are far from each other"),
    (r"\b(?:could|can|should|may|might) (?:the|our|my) laundry (?:be|go|stand) in the (bath ?room|kitchen|"
     r"hall(?:way)?)\b",
     r"a washing machine in the \1"),
    (r"\b(?:the )?(?:twins|two little ones|boys|girls) (?:will |can |should |are to )?share(?: an?| one)?(?: bed "
     r"?room| room)?[,;]? (?:and |but |while )?the (?:older|younger|other|big|little|eldest|elder|oldest|youngest) "
     r"(?:one|child|boy|girl|son|daughter) (?:will have|has|gets|needs|wants) (?:her|his|their|its|an?) own(?: bed "
     r"?room| room)?(?!.*\bbed ?rooms\b)",
     "two kids rooms and a parents' bedroom"),
    # "I teach piano at home: the music room should be the first room when you come in"
    (r"\b(?:i|she|he|we|they|who) (?:also )?(?:teach(?:es)?|plays?|practi[sc]es?|learns?) (?:the )?(?:piano|drums|"
     r"violin|guitar|cello|trumpet)(?: (?:at home|a lot|every day|every evening|at night|in the evenings?))?(?: so|"
     r"[:,;.])? ?", ""),
    (r"\bthe first (?:room|door|one) (?:when|as|that) you (?:come in|enter|walk in|get in|see)\b", "near the entrance"),
    (r"[,;.]? ?(?:and )?(?:that's|thats|that is) (?:it|all)(?: we need| i need)?[ .!]*$", _nothing_else),
    # "between the kitchen and the living room, and both should be open to it"
    (r"\bbetween (the {kind}) and (the {kind}),? and (?:both|the two)(?: of them)? (?:should be |are |must be )?open "
     r"to it\b",
     r"between \1 and \2 and is open to \1 and to \2"),
    (r"\bwalk-in shower\b", "shower"),
    # "the bedroom has room for a piano", "we both study", "my old flat had the bath off the kitchen, never again"
    (r"\b(has|have|with|needs) (?:enough )?(?:room|space|a place|a spot) for (?=(?:an?|one|two|my|our) (?:[a-z]+ "
     r"){0,2}{thing}\b)",
     r"\1 "),
    (r"\b(?:we|they|i) (?:both |all )?study(?= ?[.,;!]| at | a lot| from)", ""),
    (r"\b(?:our|my) (?:last|old|present|current|previous) (?:flat|apartment|home|house|place) (?:had|has) (the "
     r"{kind}) (?:off|next to|opening off|opening into|in) (the {kind}),? (?:and )?(?:never again|which (?:i|we) "
     r"(?:hate|hated)|(?:i|we) hated? (?:it|that))", r"no door between \1 and \2"),
    (r"\b(must not|should not|shouldn't|mustn't|can't|cannot) have (?:a |any )?windows? (?:to|on|onto|facing|towards) "
     r"(?=the (?:street|road|garden|courtyard|{side})\b)", r"\1 face "),
    (r"\b(?:the |our )?(?:previous|last|former) (?:tenants|owners|people) had (the [a-z ]+?) in the {kind}[;,.] "
     r"?(?:but )?(?:we|i) (?:want|would like|need|prefer) (?:it|them) in the ({kind})", r"\1 in the \2"),
    # "six of us in the house: mum, dad and …", "we are three adults", "one bedroom for him, one for me"
    (r"\bthere are {several} of us in (?:the|our|this) (?:house|flat|home|apartment|family) ?: ?", ""),
    (r"\bwe(?: are|'re) ({several}) (?:adults|grown-ups|singles|working people|professionals)(?=[.;,])",
     r"for \1 flatmates"),
    (r"\bone bed ?room for (?:him|her|my [a-z]+)([^.;]{0,40}?),? (?:and )?one for (?:me|us)\b", _second_and_mine),
    (r"\b(?:our|my) (son|daughter) (?:wants?|gets|has|needs|should have)(?: to have)? the (?:bed ?)?room (next to|"
     r"beside|near|opposite|away from) ([^.;,]+),? (?:and )?(?:our|my) (son|daughter) (?:gets |wants |has )?the one "
     r"(next to|beside|near|opposite|away from) ([^.;,]+)", _son_and_daughter),
    # "a kitchen with an island, open to the living room"
    (r"\bkitchen with ([^,;.]{3,25}), open to (the {kind})", r"kitchen open to \2. the kitchen has \1. "),
    # "five people: grandma, us two, and two boys who share"
    (r"\b({elder}),? us two,? and (?:the |our )?two {young} (?:who|that) share\b",
     r"a bedroom for \1, a bedroom for us and a "
     r"kids bedroom"),
    # "mit unserem Baby, das noch bei uns schläft", "unsere Kinder teilen sich ein Zimmer", "Sonst nichts Besonderes"
    (r"\bwir sind (?:zu dritt|drei),? mit (?:unserem|dem|einem) baby, das (?:noch )?bei uns schlaft\b",
     "wir sind ein paar"),
    (r"\b(?:unsere|die|meine)(?: zwei| beiden)? (?:kinder|tochter|sohne|jungs|madchen)(?: sind [\d und,]+(?:jahre alt "
     r")?)?(?: und)? teilen sich ein zimmer\b", "ein kinderzimmer und ein elternschlafzimmer"),
    (r"[,;.]? ?(?:und )?(?:sonst|ansonsten) (?:nichts (?:besonderes|weiter besonderes)|wie ublich|alles wie "
     r"ublich){end}", ""),
    (r"\bein(?:en)? (?:zimmer|raum) (?=zum (?:malen|musizieren|nahen|arbeiten|basteln|schreiben)\b)",
     "ein arbeitszimmer "),
    (r"\bmit (nord|sud|ost|west)licht\b", lambda found: f"nach {_NACH[found[1]]}"),
    (r"\b(?:meine|unsere) (?:schwieger|gross)?mutter [^.]*?,? ihr zimmer (?:also |bitte |soll )?(nah am|neben dem|"
     r"beim) bad\. ?(?:dazu |ausserdem |und )?unser schlafzimmer und (?:das|eins) (?:von meinem|fur meinen|meines) "
     r"sohne?s?\b",
     "drei schlafzimmer. das dritte schlafzimmer neben dem bad"),
    # "on est trois colocataires", "pas besoin de salon", "un studio avec un bureau", "sa chambre …, la nôtre et
    # celle de"
    (r"\b(?:on est|nous sommes) (?=(?:deux|trois|quatre|cinq) (?:colocataires|colocs|etudiant[e]?s|amis|amies)\b)",
     "pour "),
    (r"\b(deux|trois|quatre|cinq) (?:colocataires|colocs)\b(?!.*\bchambres?\b)", r"\1 chambres pour \1 colocataires"),
    (r"\b(?:pas|nul) besoin (?:de |d'une? )(?={fr})", "sans "),
    (r"^((?:un |le )?studio\b[^.]*?) un bureau\b", r"\1 une table de travail"),
    (r"\bma (?:grand-?|belle-?)?(?: )?mere vit avec nous ?[:,.] ?sa chambre ([^.;,]*), la notre et celle de (?:mon|"
     r"notre) fils\b",
     r"trois chambres. la troisieme chambre \1"),
    # "el de mis padres cerca del baño, y el nuestro al fondo"
    (r"\bel dormitorio de mis padres ([^.;]*?),? y el nuestro (?=al|cerca|junto|lejos)",
     r"el dormitorio de mis padres \1. nuestro "
     r"dormitorio "),
    # "我们的卧室在最里面"
    (r"在(?:最|房子)?里(?:面|边|头)(?=[,.;]|$)", "在后面"),
    # "next to the bathroom, and the main bedroom should be the largest"
    (r"(\b(?:next to|beside|near|opposite|off|close to|behind) the (?:{kind}|bath)), (?:and|but|while) (?=the {kind} "
     r"(?:should|must|is|has|needs|faces|gets)\b)", r"\1. "),
    # "a bedroom for me, one for her, one for him", "two little ones"
    (r"\b(?:a|one) (?:bed ?)?room for (?:me|us)((?:(?:,| and|, and) (?:an?other|a|one)(?: one| (?:bed ?)?room)? for "
     r"(?:her|him|them)\b)+)", _for_each),
    (r"\b(two|three|four|the|our|my) little ones\b", r"\1 children"),
    # "max total area m2: 85", "bathroom: 1, 4.5 m2"
    (r"(?:(?<=[{,;(.] )|(?<=\")|^)max(?:imum)? (?:total )?area(?: ?\(?(?:m2|sqm)\)?)?\"? ?: ?\"?({amount})(?: "
     r"?{unit})?", r"at most \1 m2 in total"),
    (r"\b((?:bath|bed) ?room|kitchen|living room|study) ?: ?1, ?(?={amount} ?{unit})", r"\1: "),
    # "eine offene Küche möchte ich nicht", "ins erste kommen ein Bett und …, ins zweite ein Schreibtisch"
    (r"\b(eine?n? [a-z ]{3,30}?) (?:mochte|will|brauche|wollen|mochten|brauchen) (?:ich|wir) nicht\b", r"k\1"),
    (r"\bins (erste|zweite|dritte)(?: schlafzimmer)?(?: kommen| kommt| sollen| soll| gehoren| gehort)? (?=ein|zwei|"
     r"das)",
     r"im \1n "),
    # "un bureau où l'on entre par le séjour", "accessible à la fois de la chambre et du couloir", "c'est pour mes
    # parents"
    (r",? ?ou (?:l')?on entre (par|depuis) ", r" accessible \1 "),
    (r"\b(accessibles?|donnant) a la fois (?=de|du|depuis|sur)", r"\1 "),
    (r"^c'est pour (?:mes|nos|des) [a-z]+(?: ages)? ?: ?", ""),
    # "cada pareja con su dormitorio y su baño dentro", "tiene que ser la habitación más grande"
    (r"\b(?:somos )?(dos|tres) parejas\b[^:;.]*[:;.,] ?(?:y )?cada (?:pareja|una) con su dormitorio y su bano(?: "
     r"dentro| propio| privado)?", r"\1 dormitorios, cada uno con su bano propio"),
    (r"\b(dos|tres|cuatro) dormitorios, (?:el|uno) (?=de mi (?:madre|padre|abuel[oa]|suegr[oa]|hij[oa]|herman[oa])\b)",
     r"\1 dormitorios. el dormitorio "),
    (r"\b(?:tiene que|debe|ha de|deberia) ser (?=la (?:habitacion|estancia|pieza) mas)", "es "),
    # "卫生间的门都开在走廊上", "次卧兼作书房"
    (r"((?:卫生间|浴室|卧室))的门(?:都|全)(?:要|应该)?(?:开在|开向|通向|朝)走廊(?:上|里)?", r"\1都从走廊进"),
    (r"(爸妈|父母|老人|爷爷奶奶|孩子)(?:的)?那[间个](?![房卧])", r"\1的卧室"),
    (r"(次卧|主卧|卧室)兼(?:作|做|当|用作)?(?:书房|办公室|客房),?", r"\1里"),
), given_up=_GIVEN_UP, rooms_of=_ROOMS_OF, moved=_MOVED, thing=_THING, side="(?:north|south|east|west)",
    elder=ELDER, child=CHILD)  # fmt: skip


def lived(text: str) -> str:
    """A folded text with such clauses in plain words."""
    text = _SLIP.sub(lambda found: _SLIPS[found.group()], text)
    return _each_of_many(reworded(_two_sizes(_whose(text)), _SAID))
