"""What stands apart from its room: sizes behind asides, lists behind `that leads to`, doors and owners told shortly."""

import re

from apartgen.stages.plan.reader.limits_abroad import limits_in_english
from apartgen.stages.plan.reader.neighbours import as_neighbours
from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_SIZE = (r"(?:\d+(?:[.,]\d+)?(?: ?(?:m|ft|feet|foot|'))? ?(?:x|by|times) ?\d+(?:[.,]\d+)? "
         r"?(?:m\b|ft\b|feet\b|foot\b|met(?:"
         r"er|re)s?\b|')|\d+(?:[.,]\d+)? ?(?:m2|sqm|sq\.? ?m|square met(?:er|re)s?|sq\.? ?ft|sqft|square "
         r"feet))")  # fmt: skip
_ONE = (rf"(?:the|one|an?|another|my|our) "
        rf"(?:{KIND}|(?:main|master|other|second|third|large[rs]?t?|small(?:er|est)?|big"
        r"(?:ger|gest)?)(?: one)?)|one|another")  # fmt: skip
_KIN = r"(?:grand(?:mother|father|ma|pa|dad)|granny|gran|nan|mother|father|mum|mom|dad|aunt|uncle|sister|brother)"
_SHE = r"(?:grand(?:mother|ma)|granny|gran|nan|mother|mum|mom|aunt|sister)"
_FEMALE = re.compile(rf"\b(?P<who>{_SHE}|wife|girlfriend|daughter|client|she|woman|girl|nurse|painter)s?\b")
_MALE = re.compile(r"\b(?P<who>grand(?:father|pa|dad)|father|dad|uncle|brother|husband|boyfriend|son|client|he|man|"
                   r"boy)s?\b")  # fmt: skip
_RELATIVE = re.compile(rf"{_KIN}$")
_ROOMS = re.compile(rf"\b{KIND}|\b\d")


def _whose(found: re.Match[str]) -> str:
    """`a house for a couple and a grandmother: her bedroom`: the grandmother's, where nobody else is she."""
    known = (_FEMALE if found["her"] == "her" else _MALE).finditer(found.string[: found.start()])
    named = {one["who"] for one in known}
    only = next(iter(named)) if len(named) == 1 else ""
    beside = "couple" in found.string[: found.start()]
    return f"the {only}'s bedroom" if beside and _RELATIVE.match(only) else found.group()


def _list_goes_on(found: re.Match[str]) -> str:
    """`two bedrooms, a lounge that leads to a balcony, a kitchen`: of a list, only the first leads off the lounge."""
    return f"{found['before']}{found['room']} {found['to']}. " if _ROOMS.search(found["before"]) else found.group()


def _only_door(found: re.Match[str]) -> str:
    """`one door is enough for the kitchen, and it goes to the living room`."""
    only = f"{found['of']} has at most one door"
    return f"{only}. {found['of']} has a door " if found["to"] else only


_OWNABLE = re.compile(r"\b(?:(?:bath|shower|dressing) "
                      r"?room|toilet|balcony|closet|study|office|terrace|wardrobe|desk)s?\b")


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


def _both_ways(found: re.Match[str]) -> str:
    """A room that is entered from two others."""
    return f"the {found['of']} has a door to the {found['a']} and a door to the {found['b']}"


def _of_several(found: re.Match[str]) -> str:
    """`the smaller of the two bedrooms has a desk`: two bedrooms are there, unless they were told of."""
    one = f"{found['which']} {found['rooms'].removesuffix('s')}"
    known = re.search(rf"\b(?:{found['n']}|[2-4])[- ]bed", found.string[: found.start()])
    return f"{found['begin']}{one}" if known else f"{found['begin']}{found['n']} {found['rooms']}. {one}"


_STUDIO = r"(?:studio|atelier)(?! (?:flat|apartment|home|unit|loft|room))"
_SAID = rules((
    # "the corridor needs to be at least 1.2 m wide"
    (r"\b(?:needs?|ought|(?:is|are) (?:supposed|meant|required|expected)) to (?P<not>not )?be\b",
     lambda found: f"must {found['not'] or ''}be"),
    (r"(?<=[a-z0-9)]) +(?=[,;] )", ""),
    (r"\b(kitchen(?:ette)?) must be in (?=the (?:living room|lounge|sitting room)\b)", r"\1 should be in "),
    # "one opening off the hallway and one off the master bedroom"
    (r"\b(?P<one>one|another|the other|the second)(?: one)? "
     r"(?:opening|opens|leading|leads|accessed|reached|entered|accessible)(?: directly)? "
     r"(?:off|from) (?=(?:the|our|my) )", r"\g<one> off "),
    # "the main one, which is en suite, of 13 by 12 ft"
    # nor is "a bedroom with a balcony of 4 m2"
    (r"\b(?P<one>{one}),? (?P<aside>(?:which|that) [^,.;:]*?[^,.;: \d]|with (?![^,.;:]*(?:{kind}) (?:of|sized) )"
     r"[^,.;:]*?[^,.;: \d]),? (?:of|measuring|and measures|sized) (?P<size>{size})(?={end}| and|,)",
     r"\g<one> of \g<size> \g<aside>"),
    # "a one-bedroom home …; the studio of 20 m² faces north"
    (r"(?P<home>\b(?:one|two|three|four|[1-4])[ -]bed(?: ?room)?s?\b[^.;:]*[.;:,][^.]*?\b(?:the|an?|my|our|her|his) "
     r"(?:(?:{size}|large|small|bright|big|separate) )?){studio}", r"\g<home>study"),
    # "two bedrooms, a lounge that leads to a balcony, a kitchen, and a store room"
    (r"(?P<before>(?:^|[.;:])[^.;:]*, )(?P<room>(?:an?|the|one) (?:[a-z-]+ )?{kind})(?P<to>(?: "
     r"(?:that|which)\b| (?:leading|opening|giving|looking) "
     r"(?=(?:in|on)?to ))[^,.;:]*?(?:to|onto|into|off|from) (?:an?|the|its own) (?:[a-z-]+ )?{kind}), (?:and )?"
     r"(?=(?:an?|one|two|three) )", _list_goes_on),
    # "run into one another without a wall"
    (r"\b(?:run|melt|blend) into (?:one another|each other)"
     r"(?:,? without (?:an?y? |the )?walls?(?: in)?(?: ?between(?: them)?)?)?{end}", "are open to each other"),
    (r"\b(?P<a>(?:the )?{kind} and (?:the )?{kind}),? (?:without|with no) (?:an?y? )?(?:wall|partition)s?(?: "
     r"in)?(?: ?"
     r"between(?: them)?)?{end}", r"\g<a> are open to each other"),
    # "kitchen and sitting room without a door between them"
    (r",? (?:and )?\b(?P<a>(?:the |my |our )?{kind}) and (?P<b>(?:the |my |our )?{kind}),? (?:without|with no) "
     r"(?:an?y? )?"
     r"doors? (?:in between|between (?:them|the two|each other)){end}",
     r", \g<a>, \g<b>. no door between \g<a> and \g<b>"),
    (r"\b(?P<a>{de}) und (?P<b>{de}),? (?:ohne|mit keiner) ture?n? (?:dazwischen|zwischen (?:ihnen|beiden|den "
     r"beiden))",
     r"\g<a>, \g<b>. keine tur zwischen \g<a> und \g<b>"),
    (r"\b(?P<a>{fr}) et (?P<b>(?:le |la |un |une )?{fr}),? sans porte entre (?:eux|elles|les deux)",
     r"\g<a>, \g<b>. pas de porte entre \g<a> et \g<b>"),
    (r"\b(?P<a>{es}) y (?P<b>(?:el |la |un |una )?{es}),? sin puertas? entre (?:ell[oa]s|los dos|ambos|si)",
     r"\g<a>, \g<b>. ninguna puerta entre \g<a> y \g<b>"),
    # "mit einer Tür zum Schlafzimmer und einer zum Flur", "una puerta al dormitorio y otra al pasillo"
    (r"\b(?:eine[rn]? )?tur (?P<a>(?:zu[mr]|ins?(?: die| den| das)?) {de}) und (?:mit )?(?:eine[rn]?|noch "
     r"eine[rn]?)(?: "
     r"(?:weiteren?|zweiten?|anderen?))?(?: tur)? zu[mr] (?P<b>{de})",
     r"tur \g<a> und zum \g<b>"),
    (r"\b(?P<has>con|tiene|tenga) una puerta (?:al|a la|hacia el|hacia la|en el) (?P<a>{es}) y (?:con "
     r")?(?:otra|una)(?: puerta)?(?: mas)? "
     r"(?:al|a la|hacia el|hacia la|en el) (?P<b>{es})", r"with a door to the \g<a> and a door to the \g<b>"),
    (r"\b(?P<has>avec|a|ait) une porte (?:vers|sur|dans|cote) (?:la |le |l')?(?P<a>{fr}) et (?:avec )?une(?: "
     r"autre)?(?: porte)? "
     r"(?:vers|sur|dans|cote) (?:la |le |l')?(?P<b>{fr})", r"with a door to the \g<a> and a door to the \g<b>"),
    # "das Bad soll vom Flur und vom Schlafzimmer aus erreichbar sein", "al baño se entra desde …"
    (r"\b(?P<of>{de}),?(?: (?:das|der|die|welche[rs]?))?(?: (?:soll|muss|ist|kann|sollte))?,? (?:sowohl "
     r")?(?:vom|von de[rm]|uber de[nr]|durch die) (?P<a>{de})(?: aus)? (?:und|als auch|"
     r"wie auch) (?:(?:vom|von de[rm]|uber de[nr]|durch die) )?(?P<b>{de})(?: aus)? "
     r"(?:erreichbar|zuganglich|begehbar|betretbar|zu (?:erreichen|"
     r"betreten)|betreten werden|erreicht werden)(?: (?:ist|sein|sind|soll|konnen|kann))*", _both_ways),
    (r"\bon (?:doit |peut |puisse |devrait )?(?:pouvoir )?(?:entrer|entre|acceder|accede) (?:dans|a|au) ?(?:la "
     r"|le |l')?(?P<of>{fr}) (?:a la fois )?"
     r"(?:depuis|par|de) (?:la |le |l')?(?P<a>{fr}) (?:et|ou|comme)(?: aussi)? (?:(?:depuis|par|de) )?(?:la |le "
     r"|l')?(?P<b>{fr})", _both_ways),
    (r"\b(?P<of>{fr}) (?:(?:est|soit|doit etre) )?accessible (?:a la fois |aussi bien )?(?:depuis|par|de) (?:la "
     r"|le |l')?(?P<a>{fr}) (?:et|ou|que) "
     r"(?:aussi )?(?:(?:depuis|par|de) )?(?:la |le |l')?(?P<b>{fr})", _both_ways),
    (r"\b(?:al|a la) (?P<of>{es}) se (?:puede |debe )?(?:entra|entrar|accede|acceder|llega|llegar) (?:tanto "
     r")?(?:desde|por) (?:el |la )?(?P<a>{es}) "
     r"(?:y|como|o)(?: tambien)? (?:(?:desde|por) )?(?:el |la )?(?P<b>{es})", _both_ways),
    (r"\b(?P<of>{es}) (?:(?:es|sea|debe ser) )?accesible (?:tanto )?(?:desde|por) (?:el |la )?(?P<a>{es}) "
     r"(?:y|como|o)(?: tambien)? (?:(?:desde|por) )?"
     r"(?:el |la )?(?P<b>{es})", _both_ways),
    (r"(?P<of>{zh})(?:要|应该|需要)?(?:能)?从(?P<a>{zh})(?:和|与|或|跟)(?:从)?(?P<b>{zh})(?:都|均)?"
     r"(?:要|应该)?(?:能|可以|可)?进(?:入|去)?", _both_ways),
    # "im größeren ein Doppelbett, im kleineren zwei Einzelbetten"
    (r"\b(?:im|in dem) (?P<which>grosse|kleine|grosste|kleinste)(?:re)?n (?:steht |stehen "
     r")?(?=(?:eine?|zwei|drei|vier|\d) )",
     lambda found: f"the {'large' if found['which'].startswith('gro') else 'small'} bedroom has "),
    # "the smaller of the two bedrooms has a desk"
    (r"(?P<begin>^|[.;] ?)(?P<which>the (?:larger|bigger|smaller|largest|biggest|smallest|first|second)) of "
     r"(?:the|our|my) (?P<n>two|three|four) "
     r"(?P<rooms>(?:bed|bath) ?rooms)\b", _of_several),
    # "two bedrooms. Between them there should be a bathroom"
    (r"(?P<two>\b(?:two|2) [^.;]*?)[.;,] (?:and )?between (?:them|the two|both),? (?:there )?(?:(?:{must} "
     r")?(?:be|is|lies|comes|goes|sits|put|place) )?"
     r"(?P<room>(?:an?|one|the) (?:[a-z]+ )?{kind})", r"\g<two> and \g<room> between them"),
    # "no more than one bathroom"
    (r"\b(?:no|not) more than (?P<n>one|two|three|four|[1-4]) (?=(?:bed|bath|shower) ?rooms?\b|balcon|toilet)",
     r"\g<n> "),
    # "you have to go through the kitchen to reach the pantry"
    (r",? (?:where |so that |and )?(?:you|one|we|people) (?:must|have to|has to|need to|should) "
     r"(?:go|walk|pass|come|get) through (?P<by>(?:the|my|our) {kind}) "
     r"(?:in order )?to (?:reach|enter|get (?:in)?to|access) (?P<to>(?:the|my|our) {kind}){end}",
     r". \g<to> is reached only from \g<by>"),
    # "instead of a bathtub there should be a shower"
    (r"\binstead of (?P<no>an? [a-z]+),? (?:(?:there )?(?:should|must) be|we want|i want|we need|i "
     r"need|put|give us|there is) (?P<yes>an? (?:[a-z-]+ )?[a-z]+)",
     r"\g<yes> instead of \g<no>"),
    # "hallways must be at least 1.2 m wide"
    (r"(?P<begin>^|[.;:,] ?)(?:(?:all|any|the) )?(?P<hall>hallway|corridor|hall|passage)s (?P<must>{must} "
     r"be|are) (?=at least|at "
     r"most|{least} |{most} |\d|wide|wider|not |no )", r"\g<begin>the \g<hall> \g<must> "),
    (r"\bone door (?:is|will be|would be) (?:enough|sufficient|plenty) for (?P<of>the {kind})(?:, and it "
     r"(?:goes|leads|opens) "
     r"(?=(?:in|on)?to (?P<to>the {kind})))?", _only_door),
    # "a bathroom of its own", "their own room and a desk in it"
    (r"\ban? (?P<room>{kind}) of (?P<whose>its|their) own\b",
     r"\g<whose> own \g<room>"),
    (r"(?P<own>\b(?:own (?:bed ?)?room|(?:bed ?)?room of (?:its|their|his|her) own)),? and (?P<thing>an? "
     r"(?:[a-z]+ ){1,3}?)in (?:it|there|each)\b",
     lambda found: f"{found['own']} with {found['thing'].strip()}"),
    # "en suite shower rooms to two of them"
    (r"\b(?P<suite>en[ -]?suite(?: (?:shower ?room|bath ?room|bath))?)s? (?:to|for|in|off) "
     r"(?P<n>two|both|all|each|one|three)"
     r"(?: of (?:them|these))?{end}", r"\g<n> of them with \g<suite>"),
    (r",? (?:which|that) (?:all|everyone|everybody|they all|we(?: all)?|all of (?:us|them)) shares?{end}", ""),
    # "Südbalkon"
    (r"\b(?P<side>nord|sud|ost|west)(?P<room>balkon|terrasse|loggia|zimmer|schlafzimmer|wohnzimmer|kuche)\b",
     r"\g<room> nach \g<side>en"),
    # "big family room", "big room for family"
    (r"\b(?:big|large|spacious) (?:family room|room for (?:the |our |my )?(?:whole )?family)\b", "large living room"),
    # "one bathroom off the hall, and our room has a private one"
    (r"\b(?P<has>{has}) (?P<own>(?:an?|its|her|his|their|our) "
     r"(?:(?:own|private|separate|second|extra|little|small) )+)one\b",
     _another),
    # "the living room, which faces west and gets a sofa"
    (r"\b(?P<room>(?:(?:the|my|our) )?{kind}),? (?P<which>(?:which|that) "
     r"(?:is|faces|looks|lies|opens|has|measures|should|must)\b[^.;:,]*?),? and "
     r"(?:also )?(?P<has>has|gets|contains|needs|holds) (?=(?:an?|one|two|three|four|\d) )", _of_antecedent),
    # "a room for grandma with her own bathroom"
    (r"\b(?P<a>an?|one) (?P<room>(?:bed ?)?room) for (?P<who>(?:the |my |our |an? )?[a-z]+(?: [a-z]+)?),? with "
     r"(?:her|his|their|its) own "
     r"(?P<bath>bath ?room|shower room|bath)\b", r"\g<a> bedroom with its own \g<bath> for \g<who>"),
    # "a kitchen island", "facing both south and west"
    (r"\b(?P<an>an? |the )?kitchen island\b", r"\g<an>island in the kitchen"),
    (r"\b(?P<face>facing|faces?|looking|looks?) (?:to )?both (?:the )?(?P<a>{side}) and (?:the "
     r")?(?P<b>{side})\b", r"\g<face> \g<a> and \g<face> \g<b>"),
    # "一家三口", "孩子的房间"
    (r"一家([三四五六3-6])口(?:人)?(?:住)?(?!之家)", r"\1口之家"),
    (r"(?:小?孩子?们?|儿子|女儿|宝宝)的(?:房间|卧室|房)(?=要|里|放|有|需|在|朝|靠|挨|至少|不)", " the kids room "),
    # "a couple and a grandmother: her bedroom", "her room beside the bathroom and mine far away"
    (r"\b(?P<her>her|his) (?:bed ?)?room\b", _whose),
    (r"(?P<hers>\b(?:her|his|their) (?:bed ?)?room\b[^.;]*?,? (?:and|but|while) )mine(?= )", r"\g<hers>my room"),
), one=_ONE, size=_SIZE, studio=_STUDIO,
   side="(?:north|south|east|west)")  # fmt: skip


def told_apart(text: str) -> str:
    """A folded text with such words beside their rooms."""
    return as_neighbours(reworded(limits_in_english(text), _SAID))
