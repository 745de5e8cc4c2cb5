"""What people tell of how they live before they name their rooms, and slips of fingers, in words the rules know."""

import re

from apartgen.stages.plan.reader.lives_abroad import lived_abroad
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, reworded, rules

_COMMON = ("next", "facing", "front", "back", "near", "opposite", "between", "everyone", "people", "share", "with",
           "open", "main", "large", "small", "largest", "should", "their", "have", "beside", "without", "each",
           "separate", "other")  # fmt: skip
"""Words of which two letters change places, and that are then no other word."""
_SLIPS = {
    "adn": "and", "teh": "the", "nxt": "next", "oposite": "opposite", "opposit": "opposite",
    "betwen": "between", "beetween": "between", "shoud": "should", "largst": "largest", "bigest": "biggest",
    "smalest": "smallest", "acess": "access", "evryone": "everyone", "larg": "large", "seperate": "separate",
} | {f"{word[:k]}{word[k + 1]}{word[k]}{word[k + 2:]}": word for word in _COMMON for k in range(len(word) - 1)
     if word[k] != word[k + 1] and (word, k) not in (("main", 2), ("near", 2))}  # fmt: skip
"""Words mistyped, which are no others; names of rooms are corrected where they are read."""
_SLIP = re.compile(rf"\b(?:{'|'.join(_SLIPS)})\b")
_KIN = rf"(?:{ELDER}|(?:mother|father|parents)-in-law|brother|sister|cousin|nephew|niece|client|lady|gentleman)"
_HIS = late(rf"\b(?:my|our|an?) (?:(?:elderly|old|disabled|sick) )?(?P<who>{_KIN})\b[^.;]*[.;,] ?(?:[a-z]+ ){{0,3}}"
            r"(?P<his>his|her) (?:own )?(?:bed ?)?room\b")  # fmt: skip
_COUNTED = re.compile(r"\b(?:one|two|three|four|five|\d)[ -](?:[a-z]+ )?bed ?rooms?\b")
_NAMED_ELSE = re.compile(r"\bour (?:own )?bed ?room\b|\bme and my\b")
_ABROAD = re.compile(r"\b(?:chambres?|dormitorios?|habitaciones|zimmer|schlafzimmer)\b|[\u4e00-\u9fff]")
_LARGE, _SMALL = (late(rf"\bthe (?:{words}) bed ?room\b") for words in ("big|bigger|large|larger", "small|smaller"))
_SHARERS = late(r"\b(?:for |with )?(two|three|four|five|six|[2-6]) (?:[a-z-]+ )?(?:(?:flat|house|room)mates|friends|"
                r"students|colleagues|tenants|adults|lodgers|nurses|trainees)\b")  # fmt: skip
_EACH = re.compile(r"\b(?:each|every|all)(?: of)?(?: the)? bed ?rooms?\b|\bthe bed ?rooms\b")
_ROOM = late(r"\b(?:living room|kitchen|study|dining room|bath ?room|hall(?:way)?|balcony|office|lounge)\b")
_ROOMS_OF = "(?:bed ?room|room|bath ?room)"
_GIVEN_UP = r"(?:won't|will not|shan't|are not going to|aren't going to) (?:have|want|need|be having)"
_THING = (r"(?:desks?|piano|table|sofa|wardrobes?|beds?|cot|armchair|bookshel(?:f|ves)|bookcase|dresser|rug|television|"
          r"tv)")  # fmt: skip
_MOVED = r"(?:(?:washing machine|dryer|desk|piano|freezer|fridge|dishwasher|wardrobe))"


def _whose(text: str) -> str:
    """`I look after my father. His room …, my own room …` as bedrooms of the two, where none are counted."""
    found = _HIS.search(text)
    if found is None or _COUNTED.search(text) or _NAMED_ELSE.search(text):
        return text
    before, after = text[: found.start("his")], text[found.start("his") :]
    after = re.sub(rf"\b{found['his']} (?:own )?(?:bed ?)?room\b", f"my {found['who']}'s bedroom", after)
    after = re.sub(r"\b(one|an?)(?: (?:bed ?)?room)? for (?=(?:my|our|us|me|the)\b)", r"\1 bedroom for ", after)
    return before + re.sub(r"\b(my|our) (?:own )?room\b", r"\1 bedroom", after)


def _two_sizes(text: str) -> str:
    """`she has the big bedroom, I have the small bedroom`: two, where none are counted."""
    if _LARGE.search(text) is None or _SMALL.search(text) is None or _COUNTED.search(text) or _ABROAD.search(text):
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


def _no_door(found: re.Match[str]) -> str:
    """`no door from it into my bedroom`, of the first room of the sentence before."""
    one = found["a"]
    if one == "it":
        parts = [_ROOM.search(part) for part in re.split(r"[.;]", found.string[: found.start()])]
        named = [room.group() for room in parts if room]
        if not named:
            return found.group()
        one = f"the {named[-1]}"
    return f"no door between {one} and {found['b']}"


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
     r"an?|the) (?:live-in |visiting |elderly )?(?:assistant|carer|nurse|au pair|nanny|helper|housekeeper|lodger|"
     r"maid)\b)",
     r"\1 \2bedroom "),
    (r"\b(?:for|of) (?:just )?(?:me|myself) and (?:my|our) (?=(?:son|daughter|boy|girl|kid|child|nephew|"
     r"niece)\b)(?!.*\b(?:her|his|their) (?:bed ?)?room\b[^.;]*\bmy (?:own )?(?:bed "
     r"?)?room\b)(?!.*\b{number}[ -](?:[a-z]+ )?(?:bed ?)?rooms?\b)([a-z]+)",
     r"with a bedroom for me and a bedroom for my \1"),
    (r"\bwe(?: are|'re) (?P<n>{several}) (?P<who>(?:young |old |male |female |medical |phd )?(?:{grown}|nurses|doctors|"
     r"interns|trainees|musicians|artists|cousins|girls|guys)) (?:on|in|at|from|who) [^.;,]+?[,.;](?: so)?",
     r"for \g<n> flatmates."),
    (r"\bmy (son|daughter)\b([^.;]*?)\b(?:his|her) room ((?:far )?away from|far from|next to|beside) mine\b",
     r"my \1\2my \1's bedroom \3 my bedroom"),
    # "my office is also the guest room", "the kids' rooms at opposite ends", "could the laundry be in the bathroom"
    (r"\b(?:my|our|the) ((?:home )?office|study|workroom) (?:is|should be|must be|will be) also (?:be )?(?:the|our|"
     r"an?) (?=guest (?:bed ?)?room)", r"a \1 also used as "),
    (r"\b(?:so )?(?:please )?(?:put|place|keep|have) (?:their|the kids'?|the children's|the boys'|the girls') "
     r"(?:bed ?)?rooms (?:at|on|in) (?:the )?opposite (?:ends|sides|corners)(?: of the (?:flat|house|home|apartment))?",
     "the kids' bedrooms are far from each other"),
    (r"\b(?:could|can|should|may|might) (?:the|our|my) laundry (?:be|go|stand) in the (bath ?room|kitchen|"
     r"hall(?:way)?)\b",
     r"a washing machine in the \1"),
    (r"\b(?:the )?(?:twins|two little ones|boys|girls) (?:will |can |should |are to )?share(?: an?| one)?(?: bed "
     r"?room| room)?[,;]? (?:and |but |while )?the (?:older|younger|other|big|little|eldest|elder|oldest|youngest) "
     r"(?:one|child|boy|girl|son|daughter) (?:will have|has|gets|needs|wants) (?:her|his|their|its|an?) own(?: bed "
     r"?room| room)?(?!.*\bbed ?rooms\b)",
     "two kids rooms and a parents' bedroom"),
    # "I teach piano at home: the music room should be the first room when you come in"
    (r"\b(?:i|she|he|we|they|who) (?:also )?teach(?:es)? (?:the )?(?:piano|drums|violin|guitar|cello)(?: at home)?(?: "
     r"so|[:,;.])? ?", ""),
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
    # "no door from the living room into my bedroom", "kitchen open to the dining room and dining room open to the
    # living room"
    (r"\bno doors? (?:from|leading from) (?P<a>the {kind}|it) (?:in)?to (?P<b>(?:the|my|our|his|her) (?:own )?{kind})",
     _no_door),
    (r"\b({kind}) open to (?:the )?({kind}),? (?:and )?(?:the )?\2 open to (?:the )?({kind})",
     r"\1 open to the \2, the \2 is open to the \3"),
    (r"\b(two (bed|bath)( ?)rooms of (?:the same|equal) (?:area|size)),? (opposite|next to|far from|away from) "
     r"(?:each other|one another)", r"\1. the \2\3rooms are \4 each other"),
    (r"\b(?:we are |for )?({several}) (?:student|friend|flatmate|colleague|sister|brother|nurse)s?(?: from [a-z]+)?,? "
     r"(?:and |who )?(?:we )?all (?:have|need|want|get)s?(?: our| their| his)? own (?:bed ?)?rooms?\b",
     r"for \1 flatmates"),
    # "parrots live in the living room, so it needs at least 30 m²", "the study is far away from both"
    (r"(\bthe {kind})([^.;]{0,40}?),? so it (?:needs|has to have|must have|should have) (?:at least|a minimum of) "
     r"({amount} ?{unit})",
     r"\1\2. \1 has at least \3"),
    (r"\b(the {kind}) (?:is|should be|must be|lies) (?:right |directly )?(next to|beside|opposite|near) (the "
     r"{kind}),? (?:and|but) (the {kind}) (?:is|should be|must be) (?:as )?far(?: away)?(?: as possible)? from "
     r"both(?: of them)?",
     r"\1 is \2 \3. \4 is far from \1 and \3"),
    # "one facing north, one east and one south", "at least 1.3 m wide and not longer than 10 m"
    (r"\bone facing {side}(?:(?:,| and|, and) one {side}\b)+",
     lambda found: re.sub(r"\bone (?!facing)", "one facing ", found.group())),
    (r"\b(an?|the) ({hall}|balcony) (that is (?:at least|at most) {amount} ?m (?:wide|long)),? (?:and|but) (?:not|no) "
     r"(long|wide)e?r than ({amount} ?m)\b", r"\1 \2 \3. the \2 is at most \5 \4"),
    (r"\b(an? {kind}) (that|which) (you|one) (enters?) from (the {kind}), (?:on|at|in) the ({side})(?: side)?",
     r"\1 on the \6 side \2 \3 \4 from \5"),
    # "five people: grandma, us two, and two boys who share"
    (r"\b({elder}),? us two,? and (?:the |our )?two {young} (?:who|that) share\b",
     r"a bedroom for \1, a bedroom for us and a "
     r"kids bedroom"),
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
), given_up=_GIVEN_UP, rooms_of=_ROOMS_OF, moved=_MOVED, thing=_THING, side="(?:north|south|east|west)",
    elder=ELDER, child=CHILD)  # fmt: skip


def lived(text: str) -> str:
    """A folded text with such clauses in plain words."""
    text = _SLIP.sub(lambda found: _SLIPS[found.group()], text)
    return _each_of_many(lived_abroad(reworded(_two_sizes(_whose(text)), _SAID)))
