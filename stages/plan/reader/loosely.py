"""What stands apart from its room: sizes behind asides, lists behind `that leads to`, doors and owners told shortly."""

import re

from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_SIZE = (r"(?:\d+(?:[.,]\d+)?(?: ?(?:m|ft|feet|foot|'))? ?(?:x|by|times) ?\d+(?:[.,]\d+)? ?(?:m\b|ft\b|feet\b|foot\b|met(?:"
         r"er|re)s?\b|')|\d+(?:[.,]\d+)? ?(?:m2|sqm|sq\.? ?m|square met(?:er|re)s?|sq\.? ?ft|sqft|square feet))")  # fmt: skip
_ONE = (rf"(?:the|one|an?|another|my|our) (?:{KIND}|(?:main|master|other|second|third|large[rs]?t?|small(?:er|est)?|big"
        r"(?:ger|gest)?)(?: one)?)|one|another")  # fmt: skip
_ITS_OWN = {"her": "her own", "his": "his own", "its": "its own", "their": "their own", "our": "our own"}
_KIN = r"(?:grand(?:mother|father|ma|pa|dad)|granny|gran|nan|mother|father|mum|mom|dad|aunt|uncle|sister|brother)"
_SHE = r"(?:grand(?:mother|ma)|granny|gran|nan|mother|mum|mom|aunt|sister)"
_FEMALE = re.compile(rf"\b(?P<who>{_SHE}|wife|girlfriend|daughter|client|she|woman|girl|nurse|painter)s?\b")
_MALE = re.compile(r"\b(?P<who>grand(?:father|pa|dad)|father|dad|uncle|brother|husband|boyfriend|son|client|he|man|"
                   r"boy)s?\b")  # fmt: skip
_RELATIVE = re.compile(rf"{_KIN}$")
_ROOMS = re.compile(rf"\b{KIND}|\b\d")


def _whose(found: re.Match[str]) -> str:
    """`I live with my grandmother. Her room …`: the grandmother's, where nobody else is she."""
    known = (_FEMALE if found["her"] == "her" else _MALE).finditer(found.string[: found.start()])
    named = {one["who"] for one in known}
    only = next(iter(named)) if len(named) == 1 else ""
    return f"the {only}'s bedroom" if _RELATIVE.match(only) else found.group()


def _list_goes_on(found: re.Match[str]) -> str:
    """`two bedrooms, a lounge that leads to a balcony, a kitchen`: of a list, only the first leads off the lounge."""
    return f"{found['before']}{found['room']} {found['to']}. " if _ROOMS.search(found["before"]) else found.group()


def _only_door(found: re.Match[str]) -> str:
    """`one door is enough for the kitchen, and it goes to the living room`."""
    only = f"{found['of']} has at most one door"
    return f"{only}. {found['of']} has a door " if found["to"] else only


_OWNABLE = re.compile(r"\b(?:(?:bath|shower|dressing) ?room|toilet|balcony|closet|study|office|terrace|wardrobe|desk)s?\b")
_FAMILIES = {"三": 1, "3": 1, "四": 2, "4": 2, "五": 3, "5": 3, "六": 4, "6": 4}
_BEDS = re.compile("[一二两三四五1-5](?:室|居|间卧|个卧|间房)")


def _another(found: re.Match[str]) -> str:
    """`our room has a private one`: a private bathroom, where one was spoken of last."""
    last = _OWNABLE.findall(found.string[: found.start()])[-1:]
    own = found["own"].replace("private", "own").replace("a own", "its own")
    return f"{found['has']} {own}{last[0].removesuffix('s')}" if last else found.group()


def _of_antecedent(found: re.Match[str]) -> str:
    """`the living room, which faces west and gets a sofa`: it is the living room that gets it."""
    return f"{found['room']}, {found['which']}. {_the(found['room'])} {found['has']} "


def _the(room: str) -> str:
    return room if room.startswith(("the ", "my ", "our ")) else f"the {room}"


def _family_of(found: re.Match[str]) -> str:
    """`一家三口住的房子`: the parents' bedroom and that of the child, where none are counted."""
    kids = _FAMILIES[found["n"]]
    counted = _BEDS.search(found.string)
    return "" if counted else f" a parents' bedroom, {'a kids room' if kids == 1 else f'{kids} kids rooms'}, "


_STUDIO = r"(?:studio|atelier)(?! (?:flat|apartment|home|unit|loft|room))"
_SAID = rules((
    # "the main one, which is en suite, of 13 by 12 ft"
    (r"\b(?P<one>{one}),? (?P<aside>(?:which|that|with) [^,.;:]*?[^,.;: \d]),? (?:of|measuring|and measures|sized) "
     r"(?P<size>{size})(?={end}| and|,)", r"\g<one> of \g<size> \g<aside>"),
    # "a one-bedroom home …; the studio of 20 m² faces north"
    (r"(?P<home>\b(?:one|two|three|four|[1-4])[ -]bed(?: ?room)?s?\b[^.;:]*[.;:,][^.]*?\b(?:the|an?|my|our|her|his) "
     r"(?:(?:{size}|large|small|bright|big|separate) )?){studio}", r"\g<home>study"),
    # "two bedrooms, a lounge that leads to a balcony, a kitchen, and a store room"
    (r"(?P<before>(?:^|[.;:])[^.;:]*, )(?P<room>(?:an?|the|one) (?:[a-z-]+ )?{kind})(?P<to>(?: (?:that|which)\b| [a-z-]+ing "
     r"(?=(?:in|on)?to ))[^,.;:]*?(?:to|onto|into|off|from) (?:an?|the|its own) (?:[a-z-]+ )?{kind}), (?:and )?"
     r"(?=(?:an?|one|two|three) )", _list_goes_on),
    # "run into one another without a wall"
    (r"\b(?:run|melt|blend) into (?:one another|each other)"
     r"(?:,? without (?:an?y? |the )?walls?(?: in)?(?: ?between(?: them)?)?)?{end}", "are open to each other"),
    (r"\b(?P<a>(?:the )?{kind} and (?:the )?{kind}),? (?:without|with no) (?:an?y? )?(?:wall|partition)s?(?: in)?(?: ?"
     r"between(?: them)?)?{end}", r"\g<a> are open to each other"),
    # "kitchen and sitting room without a door between them"
    (r",? (?:and )?\b(?P<a>(?:the |my |our )?{kind}) and (?P<b>(?:the |my |our )?{kind}),? (?:without|with no) (?:an?y? )?"
     r"doors? (?:in between|between (?:them|the two|each other)){end}",
     r", \g<a>, \g<b>. no door between \g<a> and \g<b>"),
    (r"\b(?P<a>{de}) und (?P<b>{de}),? (?:ohne|mit keiner) ture?n? (?:dazwischen|zwischen (?:ihnen|beiden|den beiden))",
     r"\g<a>, \g<b>. keine tur zwischen \g<a> und \g<b>"),
    (r"\b(?P<a>{fr}) et (?P<b>(?:le |la |un |une )?{fr}),? sans porte entre (?:eux|elles|les deux)",
     r"\g<a>, \g<b>. pas de porte entre \g<a> et \g<b>"),
    (r"\b(?P<a>{es}) y (?P<b>(?:el |la |un |una )?{es}),? sin puertas? entre (?:ell[oa]s|los dos|ambos|si)",
     r"\g<a>, \g<b>. ninguna puerta entre \g<a> y \g<b>"),
    # "mit einer Tür zum Schlafzimmer und einer zum Flur", "una puerta al dormitorio y otra al pasillo"
    (r"\b(?:eine[rn]? )?tur (?P<a>(?:zu[mr]|ins?(?: die| den| das)?) {de}) und (?:mit )?(?:eine[rn]?|noch eine[rn]?)(?: "
     r"(?:weiteren?|zweiten?|anderen?))?(?: tur)? zu[mr] (?P<b>{de})",
     r"tur \g<a> und zum \g<b>"),
    (r"\b(?P<has>con|tiene|tenga) una puerta (?:al|a la|hacia el|hacia la|en el) (?P<a>{es}) y (?:con )?(?:otra|una)(?: puerta)?(?: mas)? "
     r"(?:al|a la|hacia el|hacia la|en el) (?P<b>{es})", r"with a door to the \g<a> and a door to the \g<b>"),
    (r"\b(?P<has>avec|a|ait) une porte (?:vers|sur|dans|cote) (?:la |le |l')?(?P<a>{fr}) et (?:avec )?une(?: autre)?(?: porte)? "
     r"(?:vers|sur|dans|cote) (?:la |le |l')?(?P<b>{fr})", r"with a door to the \g<a> and a door to the \g<b>"),
    # "hallways must be at least 1.2 m wide"
    (r"(?P<begin>^|[.;:,] ?)(?:(?:all|any|the) )?(?P<hall>hallway|corridor|hall|passage)s (?P<must>{must} be|are) (?=at least|at "
     r"most|{least} |{most} |\d|wide|wider|not |no )", r"\g<begin>the \g<hall> \g<must> "),
    (r"\bone door (?:is|will be|would be) (?:enough|sufficient|plenty) for (?P<of>the {kind})(?:, and it (?:goes|leads|opens) "
     r"(?=(?:in|on)?to (?P<to>the {kind})))?", _only_door),
    # "a bathroom of its own", "their own room and a desk in it"
    (r"\ban? (?P<room>{kind}) of (?P<whose>her|his|its|their|our) own\b",
     lambda found: f"{_ITS_OWN[found['whose']]} {found['room']}"),
    (r"(?P<own>\b(?:own (?:bed ?)?room|(?:bed ?)?room of (?:its|their|his|her) own)),? and (?P<thing>an? (?:[a-z]+ ){1,3}?)in (?:it|there|each)\b",
     lambda found: f"{found['own']} with {found['thing'].strip()}"),
    # "en suite shower rooms to two of them"
    (r"\b(?P<suite>en[ -]?suite(?: (?:shower ?room|bath ?room|bath))?)s? (?:to|for|in|off) (?P<n>two|both|all|each|one|three)"
     r"(?: of (?:them|these))?{end}", r"\g<n> of them with \g<suite>"),
    (r",? (?:which|that) (?:all|everyone|everybody|they all|we(?: all)?|all of (?:us|them)) shares?{end}", ""),
    # "Südbalkon"
    (r"\b(?P<side>nord|sud|ost|west)(?P<room>balkon|terrasse|loggia|zimmer|schlafzimmer|wohnzimmer|kuche)\b",
     r"\g<room> nach \g<side>en"),
    # "big family room", "big room for family"
    (r"\b(?:big|large|spacious) (?:family room|room for (?:the |our |my )?(?:whole )?family)\b", "large living room"),
    # "one bathroom off the hall, and our room has a private one"
    (r"\b(?P<has>{has}) (?P<own>(?:an?|its|her|his|their|our) (?:(?:own|private|separate|second|extra|little|small) )+)one\b",
     _another),
    # "the living room, which faces west and gets a sofa"
    (r"\b(?P<room>(?:(?:the|my|our) )?{kind}),? (?P<which>(?:which|that) (?:is|faces|looks|lies|opens|has|measures|should|must)\b[^.;:,]*?),? and "
     r"(?:also )?(?P<has>has|gets|contains|needs|holds) (?=(?:an?|one|two|three|four|\d) )", _of_antecedent),
    # "一家三口", "孩子的房间"
    (r"一家(?P<n>[三四五六3-6])口(?:人)?(?:住)?的?", _family_of),
    (r"(?:小?孩子?们?|儿子|女儿|宝宝)的(?:房间|卧室|房)(?=要|里|放|有|需|在|朝|靠|挨|至少|不)", " the kids room "),
    # "I live with my grandmother. Her room"
    (r"\b(?P<her>her|his) (?:bed ?)?room\b", _whose),
), one=_ONE, size=_SIZE, studio=_STUDIO)  # fmt: skip


def told_apart(text: str) -> str:
    """A folded text with such words beside their rooms."""
    return reworded(text, _SAID)
