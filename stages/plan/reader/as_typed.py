"""What people type in a hurry or as their trade writes it: cut words, dorm rooms, tables by guests, homes of one."""

import re

from apartgen.stages.plan.reader.pieces import ELDER, reworded, rules

_COUNTS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "zwei": 2, "drei": 3, "vier": 4,
           "deux": 2, "trois": 3, "quatre": 4, "dos": 2, "tres": 3, "cuatro": 4, "一": 1, "两": 2, "二": 2, "三": 3,
           "四": 4, "五": 5, "六": 6}  # fmt: skip
_SHARERS = (r"(?:(?:young |college |university )?(?:roommates|flatmates|housemates|students|friends|colleagues|sharers|"
            r"nurses|tenants|lodgers))")  # fmt: skip
_OWN_BATH = (r"(?:(?:with|has|have|having|gets?|needs?|wants?) )?(?:their|his|her|an?|its)(?: own| private| separate)*"
             r" (?:bath ?room|bath|shower room|en[ -]?suite)s?\b")  # fmt: skip
_DORM = (r"(?:(?:college |university |student |students' )*dorm(?:itory)? (?:bed)?room|student room|"
         r"(?:studenten|wohnheim)zimmer|chambre (?:d')?etudiante?|(?:habitacion|cuarto) de estudiante|"
         r"(?:学生)?宿舍)")  # fmt: skip
_SLEEPERS = (r"(?: (?:for|fur|pour|para) (?P<n>two|three|four|zwei|drei|vier|deux|trois|quatre|dos|tres|cuatro|[2-4])"
             r"(?: (?:students?|people|persons?|girls|boys|friends|roommates|studenten|studierende|personen|leute|"
             r"etudiants|personnes|estudiantes|personas))?)")  # fmt: skip
_BATHED = re.compile(r"\b(?:bad(?:ezimmer)?\b|duschbad|bano|bath|shower|en[ -]?suite|washroom|restroom|salles? d)|"
                     r"\b\d(?:\.\d)? ?ba\b")


def _dorm(found: re.Match[str]) -> str:
    """`a dorm room for two students` as a bedroom with two single beds, which is all there is."""
    count = _count(found["n"]) if found["n"] else 0
    beds = f" with {count} single beds" if count else ""
    return f"a bedroom{beds}{found['rest'].rstrip(' .!')}. no other rooms."


def _one_has(found: re.Match[str]) -> str:
    """`in the other two single beds`: the other one has them."""
    which = found["which"]
    size = {"m": "main", "l": "large", "b": "large", "g": "large", "s": "small", "pe": "small", "pr": "main"}
    name = "other" if which[0] in "oa" else size.get(which[0]) or size[which[:2]]
    return f"the {name}{'' if name == 'other' else ' bedroom'} has "


def _one_toilet_less(found: re.Match[str]) -> str:
    """`2 toilets` where no bathroom is named: one of them is in the bathroom."""
    others = _count(found["n"]) - 1
    wcs = f", {others} toilet{'s' * (others > 1)}" if others else ""
    return found.group() if _BATHED.search(found.string) else f"a bathroom{wcs}"


def _two_toilets(found: re.Match[str]) -> str:
    """Two toilets where no bathroom is named: one is the bathroom's, the other, at the entrance if one is, alone."""
    if _BATHED.search(f"{found.string[: found.start()]}|{found.string[found.end() :]}"):
        return f"a toilet {found['a']}. another toilet {found['b']}"
    bath, alone = (found["b"], found["a"]) if "entrance" in found["a"] else (found["a"], found["b"])
    return f"a bathroom {bath}. a toilet {alone}"


def _zkb(found: re.Match[str]) -> str:
    """`3ZKBB` as what its letters stand for."""
    more = {"d": "diele", "k": "kuche", "b": "bad", "t": "terrasse"}
    rooms = [more[letter] for letter in found["letters"]]
    if rooms.count("bad") > 1:
        rooms[-1] = "balkon"
    if re.search(r"(?:bad|bader|badezimmer)\b", found.string[found.end() :]):
        rooms.remove("bad")  # "3ZKB mit Tageslichtbad"
    return f"{found['n']} zimmer, {', '.join(rooms)}"


def _one_of_them(found: re.Match[str]) -> str:
    """`tres habitaciones, una de ellas despacho`, `四室…，一间做书房` as a bedroom less and a study."""
    named = found.groupdict()
    rooms, study = (f" {named['rooms']}", named["study"]) if "study" in named else ("室", "书房")
    return f"{_count(found['n']) - 1}{rooms}{found['rest']}, {study}"


def _two_main_rooms(found: re.Match[str]) -> str:
    """`Zimmer 1: 15 m², Zimmer 2: 12 m²` of a home of which no living room is named."""
    named = re.search(r"\b(?:wohn|living|lounge|sitting)", found.string)
    return found.group() if named else f"{found['begin']}living room{found['size']}bedroom"


def _half(said: str) -> float:
    """`dos … y medio`."""
    return (1 if said in ("un", "una") else _count(said)) + 0.5


def _count(said: str) -> int:
    return int(said) if said.isdigit() else _COUNTS[said]


_SAID = rules((
    (r"\b(each (?:with|having|has|gets?|needs?|wants?)) (?:an?|(?:their|his|her|our)(?: own)?) en[- ]?suite "
     r"bed ?room\b", r"\1 their own bedroom and bathroom"),
    # "c. 80 sqm", "env. 80 m²", "aprox. 80 m²", "rd. 80 m²"
    (r"\b(?:c\.|(?<=of )c|(?<=flat )c|(?:env|aprox|appr|approx|rd|ungef)\b\.?) ?(?=\d{2})", "about "),
    (r"\b([2-6]) ?er[ -]wg\b", r"wg mit \1 schlafzimmern"),
    # "3ZKB", "3 ZKBB"
    (r"\b(?P<n>[1-6])(?:[.,]5)? ?-?z(?:i|immer)?\.?(?P<letters>d?kd?bb?t?)\b", _zkb),
    # "piso de 60 metros": a home is no length
    (r"(^|[,;:] ?|\b(?:de|of|about|around|unos|con|has|tiene|flat|apartment|house|studio|piso) )(\d{2,3}) "
     r"(?:met(?:er|re)s?|metros)\b(?! ?(?:long|wide|by|x\b|cuadrad|carre|square|de l|de a|from|away|du |off|high|deep|"
     r"apart|lang|breit))", r"\1\2 m2"),
    # "two roommates, each with their own bathroom": they have a bedroom each
    (r"\b(?:for |of )?(?P<n>{several}) {sharers},? (?:who |and )?(?:each(?: one| of them)?,? {own_bath}|"
     r"(?:both|all) {own_bath}|with their own (?:private )?(?:bath ?rooms|baths)|{own_bath} each)(?! (?:or|on) )",
     r"with \g<n> bedrooms each with its own bathroom"),
    # "make me a dorm room for 2 students with a private bathroom"
    (r"^(?:(?:please|make|create|design|generate|give|show|build|draw|plan|i|we|need|want|would|like|me|us|"
     r"a plan of|ich|suche|brauche|je|cherche|voudrais|quiero|busco|necesito) )*(?:(?:an?|one|the|eine?n?|une?|una) )?"
     r"(?:(?:small|simple|typical|little|kleines|petite) )?{dorm}(?! (?:s|and|or)\b)(?!s\b){sleepers}?"
     r"(?P<rest>.*)$", _dorm),
    # "a dining room for 10", "Esszimmer für 8 Personen"
    (r"\b(dining (?:room|area)) for (?=(?:six|eight|ten|twelve|four|\d\d?)\b(?! ?(?:{unit})))",
     r"\1 with a table for "),
    (r"\b(esszimmer|essplatz|essbereich) fur (?=(?:vier|sechs|acht|zehn|\d\d?)\b)", r"\1 mit einem esstisch fur "),
    (r"\b(salle a manger) pour (?=(?:quatre|six|huit|dix|\d\d?)\b)", r"\1 avec une table pour "),
    (r"\b(comedor) para (?=(?:cuatro|seis|ocho|diez|\d\d?)\b)", r"\1 con una mesa para "),
    # "two toilets, one near the bedroom and the other near the entrance", "we need 3 bedrooms, 2 toilets"
    (r"\b(?:two|2) (?:toilets?|wcs?)[,:;]? ?(?:one|the first) (?P<a>{near} (?:the )?[a-z' ]{3,22}?)(?:,|,? and|;)+ "
     r"(?:one|another|the other|other|the second)(?: one)? (?P<b>{near} (?:the )?(?:door of )?[a-z' ]{3,22}?){end}",
     _two_toilets),
    (r"\b(?P<n>one|two|three|zwei|drei|deux|trois|[123]) (?:toilets?|wcs?|klos?|toiletten|toilettes)\b",
     _one_toilet_less),
    # "living 30, 2x bedroom 14", "the kids bedroom on other side"
    (r"\b([2-5]) ?x ?(bed ?room|bath ?room|study|balcony)s? (\d{1,2}(?:\.\d)?)(?= ?(?:[,;.]|$))", r"\1 x \2 \3 m2"),
    (r"\bon other side\b", "on the other side"),
    # "my mother and me, each with her own bedroom and ensuite bathroom"
    (r"\b(?:for|fur|pour|para) (?:me and )?(?:my|our|meine?n?|unsere?n?|ma|mon|mi) [a-z]+"
     r"(?: (?:and|und|et|y) (?:para )?(?:me|i|myself|mich|moi|mi))?, (?=each|jeder?|chacune?|cada un[oa])",
     "for two flatmates, "),
    (r"\b(each (?:with|having|has|gets?|needs?|wants?) (?:an?|(?:their|his|her|our)(?: own)?) bed ?room and) "
     r"(?:(?:an?|their|his|her|our) )?(?:(?:own|private|en[- ]?suite) )+bath ?room\b(?! of)", r"\1 bathroom"),
    # "in the main one a double bed, in the other two single beds", "en el principal …", "dans la grande …"
    (r"(?:(?<=[:;,.] )|(?<=\bflat )|(?<=\bhome )|(?<=rooms ))(?:and |und |et |y )?(?:in|en|dans) (?:the |el |la |l')"
     r"(?P<which>main|master|principale?|large|big|bigger|grande?|small|smaller|pequen[oa]|petite?|other|otr[oa]|autre)"
     r"(?: one| room| bed ?room)?:? (?=(?:an?|one|two|three|una?|une|dos|tres|deux|trois|[1-4]) "
     r"(?!(?:[a-z]+ )?(?:{room}s?|ones|rooms|zimmern?|chambres)\b)[a-z]+)", _one_has),
    (r"(?<=[:;,.] )(?:and )?in the other (two|three)(?: ones| rooms| bed ?rooms)?:? (?=(?:an?|one|two) [a-z])",
     r"the other \1 bedrooms have "),
    # "no bath, only a shower", "just a shower, no bath": of a bathroom, what it has
    (r"\b(?:no|without an?) bath(?:tub)?s?,? (?:but |and )?(?:only|just) (?:an? )?shower\b",
     "a bathroom with a shower, no bathtub"),
    (r"\b(?:only|just) (?:an? )?shower,? (?:and |but )?no bath(?:tub)?\b", "a bathroom with a shower, no bathtub"),
    # "a retired couple, both with their own bedroom", "near their room" of my parents
    (r"\b(couple|paar|pareja)\b([^.;]{0,20}?),? (?:who )?(?:each|both|each of whom|jeder|beide|cada uno)"
     r"(?: of them| of whom)? (?:with|has|have|having|wants?|needs?|gets?|mit|con) "
     r"(?:an?|their|his or her|eigene[mns]?|su) (?:own )?(?:separate )?(?:bed ?room|(?:schlaf)?zimmer|habitacion|"
     r"dormitorio)s?\b", r"\1\2 with two bedrooms"),
    (r"(\bmy parents(?! ?').*?\b(?:near|next to|beside|close to|off|opposite) )their (?:bed ?)?room\b",
     r"\1the parents' bedroom"),
    (r"\b(?:for )?(?:(?:someone|somebody|a person|one person|(?:my|our) {elder}),? )?(?:who (?:is )?)?(?:lives|living) "
     r"(?:alone|(?:on|by) (?:their|his|her|my) own|by (?:him|her|them|my)sel(?:f|ves))\b", "for one person"),
    # "flat with living room where is the kitchen inside"
    (r"\b(living room|lounge|salon) (?:where (?:there )?(?:is )?(?:the |a )?kitchen (?:is )?(?:inside|in it)|"
     r"(?:with|having) (?:the |a )?kitchen (?:inside|in it|integrated))\b", r"\1 with an open kitchen"),
    (r"\b(\d(?:\.\d+)? ?m(?:et(?:er|re)s?)?)[ -]wide (hall(?:way)?|corridor|passage)\b", r"\2 \1 wide"),
    (r"\b(toilet|wc|bath ?room) for (?:the |our )?(?:guests?|visitors?)\b", r"guest \1"),
    # "Zimmer 1: 15 m², Zimmer 2: 12 m²"
    (r"(?P<begin>^|[,;:.] ?)(?:zimmer|room) 1(?P<size>:? ?{amount} ?(?:{unit}|qm)?,? ?)(?:zimmer|room) 2\b(?=:? ?\d)",
     _two_main_rooms),
    # "man kommt nur durchs Wohnzimmer ins Schlafzimmer", "mit Tür zum Flur, ein Schlafzimmer"
    (r"\bman (?:kommt|gelangt) nur (?:durchs|durch das|durch die|durch den|uber das|uber die|uber den|uber) ([a-z]+) "
     r"(?:ins|in das|in die|in den|zum|zur) ([a-z]+)", r"the \2 is reached only through the \1"),
    (r"(\bmit (?:einer |eigener |direkter )?tur(?:en)? (?:zum|zur) [a-z]+),? (?:und )?(?=eine? )", r"\1. "),
    # "2 baños y medio"
    (r"\b(\d|un|una|dos|tres) (banos?) y medio\b", lambda found: f"{_half(found[1])} {found[2].rstrip('s')}s"),
    (r"\b(?:de )?un (?:solo )?ambiente\b", "estudio"), (r"\b([2-6]) ambientes\b", r"\1 room flat"),
    # "3 bedroom. 1 is master bedroom"
    (r"(\bbed ?rooms?[.,;] ?)(?:1|one) (?:is|should be|must be|will be|as) (?:an? |the )?(?=(?:master|guest|kids))",
     r"\1one of them is the "),
    # "3 room flat, one room used as office", "tres habitaciones, una de ellas despacho"
    (r"(\b(?:two|three|four|five|[2-5])[ -]rooms?(?: flat| apartment| home| house)?,? )(?:with )?"
     r"(?:one|1)(?: room| of them)? (?:is |should be |to be |will be )?(?:used )?(?:as|for) "
     r"(?:an? |my |the )?(?=office|study|home office)",
     r"\1one of them "),
    (r"\b(?P<n>two|three|four|five|[2-6])[ -]?(?P<rooms>bed(?: ?rooms?)?)\b(?P<rest>[^.;]{0,40}?)[,;.]? "
     r"(?:with |and )?(?:the )?(?:smallest|third|fourth|last)(?: bed ?room| one| of them)? (?:is|as|being|will be|"
     r"to be) (?:an? |the |my )?(?P<study>study|(?:home )?office)\b(?! (?:and|or)\b)", _one_of_them),
    (r"\b(?P<n>zwei|drei|vier|deux|trois|quatre|dos|tres|cuatro|[2-6])[ -](?P<rooms>{bedrooms})"
     r"(?P<rest>[^.;]{0,30}?),? (?:{one_of}) (?:(?:en|comme|como|als|para|es|est|ist|un|el|le|ein|sert de|usad[oa]|"
     r"utilisee) )*(?P<study>despacho|estudio|oficina|bureau|arbeitszimmer|buro)\b", _one_of_them),
    (r"(?P<n>[二两三四五])室(?P<rest>[^,;.]{0,6})[,;]?(?:其中)?一[间个室](?:房)?(?:做|作为?|当作?|用作|改成|改为|为|是|用来做)书房",
     _one_of_them),
    # "给一家四口…，两个孩子各有一间房"
    (r"(?:给|为)?(?:我们)?一家[三四五六]口(?:人)?(?:的|住)?(?P<said>[^;.]*?)(?P<n>[一两二三四2-4])个(?:小?孩子?|儿子|女儿)(?:都)?"
     r"(?:各自|各|每人)(?:都)?(?:要|有|住|需要)?(?:自己的|一间|一个|单独的)+(?:卧室|房间|房)",
     lambda found: f"{found['said']} a parents' bedroom, {_count(found['n'])} kids rooms "),
    # "balcony, … balcony from the living room", "Balkon vom Wohnzimmer aus": the one told before
    (r"(\b(balcon|balcony|terrace|balkon|terrasse|terraza)\b.*?[,.;] ?(?:the |der |die |le |la |el )?\2) "
     r"(?:from|depuis|desde|von|vom|aus) (?:(?:the|der|dem|le|la|el) )?([a-z]{4,14}(?: [a-z]{4,10})?)(?: aus)?"
     r"(?= ?(?:[.,;]|$))", r"\1 off the \3"),
    # "zwei Kinder, Kinderzimmer nebeneinander"
    (r"\b((?:familie|paar|eltern)[^.;]*?\bmit (?P<n>zwei|drei|vier|[2-4]) kindern\b)(?P<said>[^.;]*?[,:] ?)"
     r"(?:die |und )?(?:zwei |drei |vier |\d )?kinderzimmer\b(?![^.]*\bjedes\b)",
     lambda found: f"{found['said']}{_parents(found.string)}{found['n']} kinderzimmer"),
    # "ein Schlafzimmer mit 15 m² und ein Bad": no bathroom of the bedroom's
    (r"\b(mit \d+(?:[.,]\d+)? ?(?:m2|qm|quadratmetern?))(?=,? und eine? )", r"\1,"),
    # "die Schlafzimmer im Norden", "getrennte Schlafzimmer", "WG mit vier gleich großen Zimmern": several
    (r"\bdie (schlaf|kinder|bade|gaste)zimmer\b(?! ?\d)", r"die \1zimmern"),
    (r"(?<!zwei )(?<!drei )(?<!vier )(?<!\d )(?<!das )(?<!dem )\b(?:getrennten?|separaten?) schlafzimmern?\b",
     "zwei schlafzimmer"),
    (r"(\b(?:wg|wohngemeinschaft)\b[^.;]*?\b(?:zwei|drei|vier|funf|[2-6]) (?:gleich(?: ?grossen?)? )?)zimmern?\b",
     r"\1schlafzimmern"),
    (r"\b(zwei|drei|vier|funf|[2-6]) gleich ?grossen? (schlafzimmern?)\b", r"\1 \2 of equal size"),
    # "one room is shared by two"
    (r",? (?:and |with )?one (?:bed ?)?room (?:is |being |will be )?shared by (?:two|2)(?: of them| students|"
     r" people)?\b", ", one bedroom has two single beds"),
    (r"\b(?:accessible|reached|entered) from both ((?!the |of )[a-z]+ ?(?:room)?) and (?!the )({room})\b",
     r"accessible from the \1 and the \2"),
    (r"\b(an? |one )?twin (bed ?room)\b(?! with [^.;,]*beds?)", r"\1\2 with two single beds"),
    (r"\btwin (?=bed ?room\b)", ""),
    # "3 locked rooms off one hallway": the count is one of rooms
    (r"\b({number}) (locked|unlocked|hidden|secret|abandoned|dark|haunted|empty) (?=rooms\b)", r"\2 \1 "),
    # "2 bedrooms left, 2 bedrooms right"
    (r"({room}s?) (left|right)(?= ?(?:[.,;]|$| and ))", r"\1 on the \2"),
    # "小两居", "其中一个在主卧"
    (r"小(?=[一二两三四五]居)", "小户型,"), (r"(?<=[一二两三四五])居(?!室)", "居室"),
    (r"(?P<n>[两二三])[个间]?(?P<bath>卫生间|浴室|洗手间)[,;]?(?:其中)?[一1][个间](?:在|位于|属于)主卧(?:里|内|室)?",
     r"\g<n>个\g<bath>,主卧带独立卫生间"),
    # "un long couloir", "lange Flure": styles that have an English name
    (r"\b(?:ohne|keinen?) lange[rnsm]? (?:flure?n?|gange?|korridore?n?)\b", "no long corridor"),
    (r"\blange[rnsm]? (?:flure?n?|gange?|korridore?n?)\b", "long corridor"),
    (r"\b(?:sans|pas de|pas d'un)(?: un)? longs? couloirs?\b", "no long corridor"),
    (r"\blongs? couloirs?\b", "long corridor"),
    (r"\b(?:sin|no quiero)(?: un)? pasillos? (?:muy |tan )?largos?\b", "no long corridor"),
    (r"\bpasillos? (?:muy )?largos?\b", "long corridor"),
    (r"(?:不要|没有|不想要|避免)(?:太)?长(?:长的)?的?走廊", " no long corridor "),
    (r"长(?:长)?的?走廊", " long corridor "),
    # "les pièces de vie à l'avant"
    (r"\b(?:les )?pieces (?:de vie|a vivre)\b", "le salon et la cuisine"),
), elder=ELDER, near=r"(?:near(?: to)?|next to|close to|beside|by|in|off|at)",
   sharers=_SHARERS, own_bath=_OWN_BATH, dorm=_DORM, sleepers=_SLEEPERS,
   one_of="una de ellas|uno de ellos|dont une?|davon eine?s?|eine?s davon|une? d'(?:elles|entre elles)")  # fmt: skip


def _parents(text: str) -> str:
    """The parents' bedroom, where it is not told elsewhere."""
    return "" if re.search(r"\b(?:eltern|haupt)schlafzimmer|\bschlafzimmer\b", text) else "elternschlafzimmer, "


def as_typed(text: str) -> str:
    """A folded text with such words in those that the rules know."""
    return reworded(text, _SAID)
