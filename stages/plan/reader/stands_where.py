"""Where in its room furniture is to stand, `a sofa in the corner`: told, and no place of the room in the home."""

import re
from functools import cache

from apartgen.stages.plan.reader.beside_things import WHY
from apartgen.stages.plan.reader.patterns import Late, late
from apartgen.stages.plan.reader.sized_things import THINGS
from apartgen.stages.plan.reader.tokens import fold

_SOME = late(r"corner|middle|cent(?:er|re|ro|rum)|window|wall|ecke|mitte|fenster|wand|coin|milieu|fenetre|mur|angle|"
             r"esquina|rincon|medio|ventana|pared|角|中间|中央|正中|窗|墙")  # fmt: skip
_MORE = (r"(?:(?:potted|house|floor|coffee|dining|kitchen|reading|arm|side|bedside) ?)?(?:plants?|lamps?|islands?|"
         r"chairs?|tables?|ottomans?|stools?)|nightstands?|(?:kuchen)?insel|pflanzen?|(?:steh)?lampen?|nachttisch|"
         r"esstisch|(?:window |love ?)?seats?|benches|bench|fireplaces?|cribs?|cots?|treadmills?|aquariums?|"
         r"bean ?bags?|"
         r"bathtubs?|ilot(?: central)?|plantes?|chaises?|isla|plantas?|sillas?|lampara|岛台|中岛|植物|绿植|盆栽|灯|"
         r"钢琴|椅子?|"
         r"柜子|跑步机")  # fmt: skip
_STANDS = (
    r"(?:,? (?:(?:that|which|to|is|are|stands?|standing|sits?|sitting|goes|should|must|shall|be|stand|go|placed|"
    r"put|set|positioned|right|directly|up|steht|stehen|soll|stehend|place|placee|situe|colocad[oa]) ?)+)?"
)
_AT = (r"(?:in|at|by|near(?: to)?|against|under(?:neath)?|below|beneath|next to|beside|along|facing|in front of|on|"
       r"close "
       r"to|opposite|over)")  # fmt: skip
_SPOT = (rf" ?{_AT} (?:the|an?|one|its|each|every)(?: (?:far|left|right|back|front|other|opposite|big|large|long|short|"
         rf"(?:north|south)?(?:ern|east|west)?))* (?:corner|middle|cent(?:er|re)|windows?|walls?)\b(?!-| (?:bed|room|"
         rf"unit|shel))(?: {_AT} (?:the|a) (?:door|window|entrance|bed|tv|sofa)\b)?")  # fmt: skip
_FLAT = r"(?:flat|apartment|home|house|plan|building|layout|unit|dwelling|floor|whole)"
_ORT = (r" ?(?:in (?:der|einer|die)|im|am|an (?:der|die|einer)|ans|vor dem|vors|unter dem|neben dem|mitten im|"
        r"gegenuber "
        r"dem) (?:(?:linken|rechten|hinteren|grossen) )?(?:(?:zimmer)?ecke|(?:zimmer)?mitte|raum|zentrum|fenster|"
        r"wand)\b"
        r"(?! (?:der|des) (?:wohnung|hauses|grundrisses))")  # fmt: skip
_LIEU = (r" ?(?:dans (?:le|un)|au|contre (?:le|un)|devant (?:la|une)|sous (?:la|une)|pres (?:de la|d'une|du)|"
         r"a cote de la|"
         r"face (?:a la|au)|dans l'|en) ?(?:coin|angle|milieu|centre|fenetres?|mur)\b(?! (?:nuit|cuisine|repas|bureau|"
         r"salon|parental|lecture|travail|de l'appartement|du logement|de la maison))")  # fmt: skip
_SITIO = (r" ?(?:en (?:la|el|una?)|junto a la|junto al|frente a la|bajo la|debajo de la|contra la|al lado de la|"
          r"cerca de "
          r"la|delante de la|en) (?:esquina|rincon|centro|medio|ventana|pared)\b(?! (?:del (?:piso|apartamento|"
          r"plano)|de "
          r"la (?:casa|vivienda)))")  # fmt: skip
_ADJ = (r"(?: (?!dans|avec|con|pour|para|bajo|junto|frente|contra|devant|sous|pres|face|al?\b|au\b|et?\b|en\b|"
       r"y\b)[a-z]{3,})?")  # fmt: skip
_ROOM = r"(?:客厅|厨房|餐厅|书房|阳台|玄关|[主次大小]?卧室?|(?:儿童|客)房)"
_ECKE = (
    r"(?:(?:左|右|一|的|某个)*(?:角落?|中间|中央|正中(?:间|央)?|窗户?[边前下旁]|靠窗|靠墙|墙[边角]|窗台下)(?:里|"
    r"处|的?位置|的?地方)?)"
)


@cache
def _patterns() -> list[Late]:
    """How the places of things are said; `of` is the room, where it is named behind the place."""
    things = rf"(?<![a-z'-])(?<!walk-in )(?:{_MORE}|{THINGS['furniture']})(?![a-z])"
    named = {"thing": things, "stands": _STANDS, "adj": _ADJ, "room": _ROOM, "corner": _ECKE}
    return [Late(pattern, named) for pattern in (
        rf"(?P<thing>{{thing}})(?P<said>{{stands}}{_SPOT}(?: of (?:the|our|my|a|this|whole) {_FLAT})?)"
        r"(?: of (?P<of>(?:the|my|our|each|every) ))?",
        rf"(?P<thing>{{thing}})(?P<said>{{stands}}{_ORT})(?: (?P<of>de[sr] [a-z]+))?",
        rf"(?P<thing>{{thing}}{{adj}}|(?P<desk>(?:petit |grand )?bureau)(?=[^,.;]*(?:fenetre|mur)))"
        rf"(?P<said>{{stands}}{_LIEU})(?: (?P<of>de la |du |de l'))?",
        rf"(?P<thing>{{thing}}{{adj}})(?P<said>{{stands}}{_SITIO})(?: (?P<of>del |de la ))?",
        r"(?P<thing>{room}的?)(?P<said>{corner})(?=,?(?:里|再|要)?(?:放|有|摆|设|安|是|带)[^,.;]{{0,8}}{thing})"
        .replace("{{0,8}}", "{0,8}"),
        r"(?P<thing>{thing}(?:要|应该?|需要?)?(?:放在?|摆在?|在|位于)(?:{room}))(?P<said>的?{corner})(?=[,.;]|$)",
        r"(?P<thing>{thing})(?P<said>(?:要|应该?|需要?)?(?:放在?|摆在?|在|位于|靠着?)?的?(?:{corner}|"
        r"靠?[窗墙]))(?=[,.;]|$)",
        # "in the corner stands a grey sofa"
        rf"(?P<thing>(?:^|(?<=[.;,] )|(?<= and )))(?P<said>{_SPOT})(?! of (?:the |our |my |a |"
        rf"this )?{_FLAT})(?: of (?P<of>(?:the|my|our) (?:[a-z]+ room|kitchen|study|lounge|bedroom))"
        rf"\b)?,? (?:(?P<is>there (?:is|are|stands)|stands?|is"
        r"|goes) )?(?=(?:an?|the|one|two|some) (?:[a-z]+ ){0,2}?{thing})",
    )]  # fmt: skip


def stands_where(text: str) -> tuple[str, list[tuple[str, str]]]:
    """A text without such places, folded where it had some; these places, and why they are left out."""
    if not _SOME.search(fold(text)):
        return text, []
    folded, said = fold(text), list[tuple[str, str]]()
    for pattern in _patterns():

        def told(found: re.Match[str]) -> str:
            groups = found.groupdict()
            said.append((found["said"].strip(" ,"), WHY))
            if found["thing"] == "":
                there = "there is " if groups.get("is") else ""
                return f"in {groups['of']} {there or 'there is '}" if groups.get("of") else there
            if _known(found) and not groups.get("of"):
                return ""
            thing = "table de travail" if groups.get("desk") else found["thing"]
            return thing + _inside((groups.get("of") or "").strip())

        folded = pattern.sub(told, folded)
    return (folded, said) if said else (text, [])


_IN = {"": "", "du": " dans le ", "de la": " dans la ", "de l'": " dans l'", "del": " en el "}


def _inside(of: str) -> str:
    """`of the living room`, `des Wohnzimmers` behind the corner that a thing stands in: the thing is in that room."""
    article, _, room = of.partition(" ")
    if room and article in ("des", "der"):
        return f" im {room.removesuffix('s')}" if article == "des" else f" in der {room}"
    return _IN.get(of, f" in {of} ")


def _known(found: re.Match[str]) -> bool:
    """Whether a clause only tells where a thing stands that was named before: `…, desk against the window`."""
    before, thing = found.string[: found.start()], found["thing"]
    after = found.string[found.end() :]
    alone = re.search(r"(?:^|[.;,] )(?:the )?$", before) and re.match(r" ?(?:[.;,!]|$)", after)
    return bool(alone) and re.search(rf"\b{re.escape(thing)}\b", before) is not None
