"""Lists of areas, beds, numbers taken back, other sides and owners, as people say them, in words the rules know."""

import re

from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded, rules

_PIECE = (r"(?:armchair|sofa|couch|desk|table|wardrobe|shelf|shelves|bookshel(?:f|ves)|bookcase|chair|lamp|tv|"
          r"television|dresser|nightstand|chest|rug|stool)s?\b")  # fmt: skip
_COUNT = r"(?:an?|one|two|three|four|no|\d)"
_SEATS = r"(?:two|three|four|five|six|seven|eight|nine|ten|twelve)"
_GETS = r"(?:gets?|has|have|takes?|wants?|needs?|sleeps? in)"
_WHO = r"(?:i|he|she|we|they|(?:my|our|the|his|her) [a-z]+|(?:grand)?(?:mother|father|ma|pa)|mum|mom|dad|granny)"
_THEIRS = r"(?:his|hers|mine|theirs|ours)"
_LES_MEUBLES = (r"(?:lits?|armoires?|chaises?|fauteuils?|canapes?|tables?|etageres?|tapis|lampes?|commodes?|"
                r"bibliotheques?(?: murale)?|television|tele)\b")  # fmt: skip
_OF_MANY = re.compile(r"\b(two|three|four|five|six) ((?:[a-z]+ )?(?:bed|bath|guest|kids|children's)? ?rooms)\b")


def _plural(found: re.Match[str]) -> str:
    """`the bedroom areas are 9 and 11 m²` as areas of the bedrooms."""
    return f"the {found[1].rstrip('s')}s of "


def _of_last(found: re.Match[str]) -> str:
    """`their areas are …`, of the rooms that were counted last."""
    named = re.findall(r"\b((?:bed|bath) ?rooms|balconies)\b", found.string[: found.start()])
    return f"the {named[-1]} of " if named else found.group()


def _seated(found: re.Match[str]) -> str:
    """`a table for six` as one with six chairs, where no chairs are counted."""
    table, count = found["table"], found["n"] or found["zahl"] or found["nombre"] or found["cuantos"]
    if re.search(r"\b(?:chairs?|stuhle?n?|chaises?|sillas?|seats\b(?= around))", found.string):
        return table
    with_them = ("with {} chairs", "mit {} stuhlen", "avec {} chaises", "con {} sillas")
    which = next(k for k, name in enumerate(("n", "zahl", "nombre", "cuantos")) if found[name])
    return f"{table} {with_them[which].format(count)}"


def _fewer(found: re.Match[str]) -> str:
    """`three bedrooms are too many, I want one` as one bedroom."""
    count, room = found["new"], found["room"].rstrip("s")
    return f"a flat with {count} {room}{'' if count in ('one', '1') else 's'}{',' if found['more'] else ''}"


def _two_rooms(found: re.Match[str]) -> str:
    """`he gets one bedroom and I get another, far from his` as two bedrooms far from each other."""
    where = re.sub("^(?:as|right|directly|just) ", "", (found["where"] or "").strip(", "))
    if not where:
        return "two bedrooms"
    return f"two bedrooms {'next to' if where.startswith(('next', 'beside', 'near')) else 'far from'} each other"


def _all_listed(found: re.Match[str]) -> str:
    """`all three` as all of them, or as the three rooms of a kind that were counted."""
    counted = dict(_OF_MANY.findall(found.string[: found.start()]))
    return f"all {found[1]} {counted[found[1]]} " if found[1] in counted else "all of them "


_COUNTED = "bed ?rooms?|bath ?rooms?|studies|balconies"
_TOO = (r"(?:are|is|was|were|would be|will be) (?:far |really |one |two )?(?:too (?:many|much|few|little)|more than "
        r"(?:i|we) (?:need|want)|not enough|no longer enough)")  # fmt: skip
_FILL = r"(?:(?:so|and|now|but|i|we|want|need|would like|prefer|give|us|me|make|it|have|rather|just|only) )*"
_ALONE = (r"(?! ?(?:m2|sqm|(?!bed|bath)[a-z]*rooms?\b))(?: (?:bed ?|bath ?)rooms?\b)?(?: only)?(?:,? please)?"
          r"(?: (?:is|are|will be|would be) (?:enough|fine|plenty)| will do| would do)?(?: now)?"
          r"(?P<more>,? with(?= ))?")  # fmt: skip
_APART = (r"(?P<where>,? (?:as |right |directly |just )?(?:far away|far|away|next to|beside|near)(?: away)?"
          rf"(?: from| to)? {_THEIRS}(?: as possible)?)?")  # fmt: skip
_SAID = rules((
    # "put one bed and two armchairs in the main room": no bedroom
    (r"(?<!flat with )(?<!home with )(?<!house with )(?<!apartment with )\b(one|1) bed"
     r"(?=(?: (?:against|by|near|under|along) the [a-z]+)?(?:,| and|, and) (?:{count} )?(?:[a-z]+ )?{piece})",
     r"\1 double bed"),
    (r"(?<!flat with )(?<!home with )(?<!house with )(?<!apartment with )\b(two|three|[2-4]) beds"
     r"(?=(?:,| and|, and) (?:{count} )?(?:[a-z]+ )?{piece})", r"\1 double beds"),
    (r"({piece}(?:,| and|, and) (?:one|1)) bed\b(?! ?room)(?=[,.;]| in | and )", r"\1 double bed"),
    (r"\b(one|1) bed (?=in (?:the|each|every|my|our|a) (?!flat|house|home|apartment))", r"\1 double bed "),
    (r"\b(?:one|1|a single) (?=floor (?:lamp|light|mirror)\b)", "a "),
    (r"\b(no|without an?|without any) beds?(?= ?(?:[.,;)]|$)| in | and | or )", r"\1 double bed"),
    (r"\blaundry in the (bath ?room|kitchen|hall(?:way)?) ?:", r"in the \1"),
    (r"\blaundry (?:goes |stands |is |should be )?in the (?=bath ?room\b|kitchen\b)", "a washing machine in the "),
    # "a dining table for six", "Esstisch für sechs Personen"
    (r"(?P<table>\b(?:[a-z]*table|[a-z]*tisch|table(?: a manger)?|mesa(?: de comedor)?)),? "
     r"(?:(?:(?:(?:(?:that|which|it) )?(?:seats|fits)|seating|for|(?:big|large) enough for|"
     r"with (?:seats?|space|room) for) "
     r"(?P<n>{seats}|\d\d?)|fur (?P<zahl>zwei|drei|vier|funf|sechs|acht|zehn|\d\d?)|"
     r"pour (?P<nombre>deux|trois|quatre|cinq|six|huit|dix|\d\d?)|"
     r"para (?P<cuantos>dos|tres|cuatro|cinco|seis|ocho|diez|\d\d?))"
     r"(?: people| persons?| guests| of us| diners| personen| personnes| personas)?)"
     r"(?= ?(?:[.,;)]|$)| (?:in|and|with|at|im|und|mit|dans|et|en|y)\b)", _seated),
    # "the entrance opens straight into the living room", "que el baño no dé al salón"
    (r"\b(opens?|leads?|opening|leading) (?:straight|directly|right|immediately) (?=(?:in|on)?to\b)", r"\1 "),
    (r"\bno de (?=al? )", "no da "),
    # "the bedroom areas are 9, 11 and 14 m²", "the sizes of the bedrooms should be …", "their areas are …"
    (r"\b(?:the )?({room}) (?:floor )?(?:areas|sizes|surfaces)(?: are| should be| must be|:| of)? (?=\d)", _plural),
    (r"\b(?:the )?(?:floor )?(?:areas|sizes|surfaces) of (?:the )?({room}s)(?: are| should be| must be|:) (?=\d)",
     _plural),
    (r"\btheir (?:floor )?(?:areas|sizes|surfaces)(?: are| should be| must be|:) (?=\d)", _of_last),
    (r"\b(?:die )?(?:flachen|grossen) der schlafzimmer (?:sind|betragen) (?=\d)", "the bedrooms of "),
    # "a night corridor, reached from the entrance hall, serving three bedrooms"
    (r"\b({hall}),? \(?(?:which is )?(?:reached from|entered from|accessible from|accessed from|off) "
     r"((?:the|an) {hall})\)?,? (?:and )?(?:serving|serves|which serves|that serves) ([^.;]+)",
     r"\1 serving \3; the \1 is reached from \2"),
    (r"\b((?:an? |the )?)({hall}) serving ([^.;,]+?) is (reached|entered|accessible) from (the {hall}[^.;]*)",
     r"\1\2 is \4 from \5. the \2 serves \3"),
    (r"\b(?:one|two|three|separate) circulation (?:zones?|areas?|spaces?) ?[:,]", ""),
    (r"\bno doors?,? (?:but|just|only|but only) (?=an? (?:[a-z]+ )?(?:opening|archway)\b)", ""),
    (r"\bdoorless (?=opening|archway)", ""),
    # "with a wide opening and no door to", "an opening instead of a door"
    (r"\b(opening|archway),? (?:and|but|with|without|rather than|instead of|and not|not|no)(?: no| not| without)?"
     r"(?: an?| any)? doors?\b,?", r"\1"),
    (r"\b(?:joined|connected|linked) to (the [a-z ]{3,14}?) (?:by|through|via) an? (?:(?:wide|large|broad|big) )?"
     r"(?:opening|archway)\b", r"open to \1"),
    (r"\b(opening|archway) from (the [a-z ]{3,14}?) to (?=the )", r"\1 between \2 and "),
    (r"\bbetween ((?:the )?[a-z ]{3,14}?) and ((?:the )?[a-z ]{3,14}?) an? (?:(?:wide|large|broad|big) )?"
     r"(?:opening|archway)\b", r"\1 and \2 open to each other"),
    # "two armchairs in the sitting room and no television in there"
    (r"\b(in the {room})([^.;]*?) in there\b", r"\1\2 \1"),
    # "each bedroom should have its own bathroom" of two who each want their own
    (r"\b(my [a-z]+) and i,? (?:each|both) {gets} (?:our own (?:bed ?)?rooms?|an? (?:bed ?)?room "
     r"of our own)\b", "two bedrooms"),
    (r"\b(?:my [a-z]+) and i,? (?:each|both) {gets} an? (?:bed ?)?room (?=with (?:its|our|their|his|her|an?) )",
     "two bedrooms each "),
    (r"\b(?:each|both) of us two {gets} (?:our|his|her|their|an?) own (?:bed ?)?rooms?\b", "two bedrooms"),
    (r"\b(each|every) ({room}) (?=(?:its|his|her|their) own\b)", r"\1 \2 has "),
    (r"\b(two bedrooms),? (?:each )?with (?:its|their|our) own (bath ?room|balcony)(?: each)?\b",
     r"\1 each with its own \2"),
    # "he gets one bedroom and I get another, far away from his"
    (r"\b{who} {gets} (?:one|an?|his|her) (?:bed ?)?room(?: and|,|;| while|, and) {who} {gets} "
     r"(?:mine|another|the other|a second)(?: one)?\b{apart}", _two_rooms),
    (r"\bone bed ?room for (?:him|her|me|my [a-z]+),? (?:and )?one for (?:him|her|me|my [a-z]+),? and (?:they|these) "
     r"(?:must|should|are to) be (?P<where>far)(?: away)? from (?:one another|each other)\b", _two_rooms),
    (r"\b(?:one|a) bed ?room for (?:him|her|me|my [a-z]+)(?: and|,) (?:another|one)(?: one)? for "
     r"(?:him|her|me|my [a-z]+)\b{apart}", _two_rooms),
    (r"\bmy (?:own )?bed ?room (?:to be |is |must be |should be )?(?P<where>(?:far away|far|away|next to) (?:from )?"
     r"{theirs})\b", _two_rooms),
    # "three bedrooms are too many for me now. I want just one"
    (r"(?:\b(?:our|my|the|i had|we had) )?\b{number} (?P<room>{counted})(?:,? which)? {too}[^.,;:]*[.,;:-]+ ?"
     r"{fill}(?P<new>{number})\b{alone}", _fewer),
    (r"\b(?:(?:i|we) )?(?:do not|don't|no longer) (?:need|want) {number} (?P<room>{counted})(?: any ?more| any "
     r"longer| now)?[.,;:]+ ?{fill}(?P<new>{number})\b{alone}", _fewer),
    (r"\binstead of {number} (?P<room>{counted}),? {fill}(?P<new>{number})\b{alone}", _fewer),
    # "all three have the door to the corridor"
    (r"\bthe (two|three|four|five) of them (?=(?:have|are|open|must|should|lead|need)\b)", _all_listed),
    (r"\bevery of them\b", "each of them"),
    (r"\ball (two|three|four|five|six)(?: rooms| of them)? (?=(?:have|has|are|open|must|should|lead|need)\b)",
     _all_listed),
    # "In the every bedroom must be one wardrobe", "in every of the bedrooms"
    (r"(^|[.;,:] ?)in (?:the )?(?:every|each|both|all)(?: of)?(?: the)? ({room}|room)s? (?:there )?"
     r"(?:must |should |has to |have to |needs to |will |shall )?(?:there )?(?:be|stand|stands|is|are) ",
     r"\1each \2 has "),
    (r"\bin (?:all|both|each|every) of(?: the)? ({room})s\b", r"in every \1"),
    (r"\b(?:the )(every|each) (?={room}|room)", r"\1 "),
    (r"\b(every|each)(?: of)?(?: the)? ({room})s (?=has|have|must|should|needs?)", r"\1 \2 "),
    (r"\bmust be (?=(?:an?|one|two|three) [a-z]+ in (?:the |each |every ))", "there is "),
    (r"(^|[.;,] ?)(?:in|on)?to (the [a-z ]{3,14}?) (?:we|you|one|i) (?:go|goes|come|comes|get|gets) (only )?"
     r"(from|through|via) ", r"\1\2 is reached \3from "),
    # "另一个卫生间的门开向走廊"
    (r"另(?:外)?一个(卫生间|浴室|厕所|洗手间)的?门?(?:要|应该)?"
     r"(?:开在|开向|通向|朝向|朝)(走廊|过道)",
     r"另一个\1在\2"),
    (r"(?:公共|公用)?(卫生间|浴室|公卫)开门(?:向|朝)(走廊|过道)", r"\1在\2"),
    (r"公卫", "公共卫生间"), (r"卫浴", "卫生间"), (r"主卧套间(?=带|有)", "主卧"),
    (r"([^,.;:放]{1,4}?)放在([^,.;:放]{1,6}?)(?:里|中)?(?=[,.;]|$)", r"\2放\1"),
    (r"(主卧)带(卫生间|浴室)", r"\1带独立\2"),
    # "un lit et un bureau dans la pièce principale": a desk; "en la habitación principal" of a studio
    (r"\bune bibliotheque (?=dans (?:la|le|chaque) )", "une bibliotheque murale "),
    (r"(\bestudio\b[^.]*?)\bla habitacion principal\b", r"\1el salon"),
    (r"\ben cada (dormitorio|habitacion|bano) (?=una? |dos )", r"cada \1 con "),
), gets=_GETS, piece=_PIECE, count=_COUNT, seats=_SEATS, who=_WHO, theirs=_THEIRS, apart=_APART,
    counted=_COUNTED, too=_TOO, fill=_FILL, alone=_ALONE)  # fmt: skip

_ACROSS = rules((
    # "opposite the bedroom, on the other side of the corridor"
    (r"\b(opposite(?: to)?|across from|facing) (the [a-z ]{3,14}?),? (?:and )?"
     r"(?:(?:on|at) (?:the )?(?:other|opposite|far) side of|across) the {hall}\b", r"opposite \2"),
    (r"\b(?:on|at) (?:the )?(?:other|opposite|far) side of the {hall},? (?=opposite|across from)", ""),
    (r"\bacross the {hall} from ", "opposite "),
    (r"(^|[.;] ?)(?:directly )?(?:opposite|across from) (the {room}),? (?:is|lies) ((?:the|an?) {room})"
     r"(?= ?[.,;]|$)", r"\1\3 is opposite \2"),
    (r"\bthe ({room})(?: door| entrance)? and the ({room})(?: door| entrance)? (?:face|are facing|are opposite) "
     r"(?:each other|one another)(?:,? across the {hall})?", r"the \1 and the \2 are opposite each other"),
    (r"(\bgegenuber\b[^.;]*?),? auf der (?:anderen|gegenuberliegenden) seite (?:des|vom|der) (?:flure?s?|gang(?:e?s)?|"
     r"korridors|diele)\b", r"\1"),
    (r"(\ben face\b[^.;]*?),? de l'autre cote du couloir\b", r"\1"),
    (r"(\b(?:en)?frente (?:al?|del?)\b[^.;]*?),? al otro lado del pasillo\b", r"\1"),
    (r"\bfaces (the [a-z ]{3,14}?) across the {hall}\b", r"is opposite \1"),
))  # fmt: skip


_TWO_BEDROOMS = late(r"\b(?:two|2)[- ]bed ?rooms?\b")
_OWNER = r"(?:the|my|our|his|her|their) ([a-z]+)'s"
_RIVALS = late(rf"\b{_OWNER} (?:bed ?)?room (?:is|should be|must be|has to be|needs to be) (larger|bigger|smaller) "
               rf"than {_OWNER}(?: one| (?:bed ?)?room)?(?= ?(?:[.,;!]|$))")  # fmt: skip


def _of_rivals(text: str) -> str:
    """`two bedrooms, the lodger's bedroom is smaller than the detective's`: the first and the second, wherever named.

    Of owners whose bedrooms the lexicon knows, both, others tell.
    """
    found = _RIVALS.search(text)
    owners = [found[1], found[3]] if found is not None else []
    known = read_lexicon().entries
    if found is None or not _TWO_BEDROOMS.search(text) or all((f"{who}'s", "bedroom") in known for who in owners):
        return text
    first, second = owners if found[2] != "smaller" else owners[::-1]
    for which, who in (("first", first), ("second", second)):
        whose = rf"\b(?:the|my|our|his|her|their) {who}'s(?: one| (?:bed ?)?room)?\b"
        text = re.sub(whose, f"the {which} bedroom", text)
    return text


def plainly(text: str) -> str:
    """A folded text with such clauses in the words of rooms, areas and furniture."""
    return _across(_of_rivals(reworded(text, _SAID)))


def _across(text: str) -> str:
    """`opposite the bedroom, on the other side of the hall` is one wish, of a home that has a hall."""
    said = text
    for pattern, words in _ACROSS:
        said = pattern.sub(words, said)
    return said if said == text or "hall" in said else f"{said.rstrip(' .')}. the hallway."
