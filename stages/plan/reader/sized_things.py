"""How large furniture, doors and windows are to be: told, as no plan is asked for it, and no size of any room."""

import re
from functools import cache

from apartgen.stages.plan.reader.patterns import Late, late
from apartgen.stages.plan.reader.tokens import fold

THINGS = {
    "furniture": (
        r"(?:all |any |every |each )?(?:furniture|furnishings?|pieces?|objects?)|mobel(?:stucke?)?|meubles?|muebles?|"
        r"家具|(?:(?:double|single|bunk|king|queen|twin|box|hospital|doppel|einzel|etagen|ehe|hoch|kinder|"
        r"baby)[- ]?)?(?:beds?|bett(?:en)?)(?!-| ?rooms?)|mattress(?:es)?|matratzen?|(?:lits?|camas?)(?: (?:doubles?|"
        r"dobles?|simples?|individual(?:es)?|matrimonial(?:es)?|de matrimonio))?|colchon(?:es)?|sofas?|couch(?:es)?|"
        r"settees?|canapes?|(?:(?:dining|coffee|kitchen|side|work|conference|billiard|ess|couch|arbeits|schreib|"
        r"kuchen|pool)[- ]?)?(?:tables?|tische?)|tables? (?:basses?|a manger|de travail)|mesas?(?: de (?:comedor|"
        r"centro|trabajo))?|desks?|escritorios?|(?:kleider)?schranke?|schrank|wardrobes?|cupboards?|cabinets?|"
        r"armoires?|armarios?|book ?(?:case|shel(?:f|ve))s?|shel(?:f|ves)|shelving|regale?|etageres?|bibliotheques?|"
        r"estanterias?|tvs?|televisions?|screens?|fernseher|televiseurs?|televisor(?:es)?|rugs?|carpets?|teppiche?|"
        r"tapis|alfombras?|(?:kitchen )?(?:counters?|worktops?|islands?|work surfaces?)|(?:bath ?)?tubs?|badewannen?|"
        r"baignoires?|baneras?|showers? trays?|pianos?|chairs?|armchairs?|sessel|fauteuils?|sillon(?:es)?|sideboards?|"
        r"dressers?|fridges?|refrigerators?|lamps?|mirrors?|benches|bench|床|沙发|餐桌|书桌|桌子|衣柜|书架|书柜|茶几|"
        r"电视|地毯"
    ),
    "doors": (
        r"(?:(?:all|every|each|any|interior|inner|entrance|front|internal|sliding|room|the) )*(?:doors?|doorways?|"
        r"door (?:leaves|leaf|openings?|frames?))|(?:innen|wohnungs|haus|zimmer|eingangs|schiebe)?tur(?:en)?|"
        r"portes?(?: d'entree| interieures?)?|puertas?(?: de entrada| interiores?| principal)?|门"
    ),
    "windows": (
        r"(?:all |every |each )?windows?(?: ?sills?| openings?)?|(?:window )?sills?|fenster(?:bank|banke)?|fenetres?|"
        r"ventanas?|窗户?|窗台"
    ),
    "walls": r"(?:(?:outer|inner|exterior|interior|all|party) )*walls?|(?:innen|aussen)?wande?|murs?|paredes|pared|墙",
}
_UNIT = (r"(?:cm|mm|centim(?:et(?:er|re)s?|etros?)|inch(?:es)?|in\b|feet|foot|ft|met(?:er|re)s?|metros?|m(?![\w²])|"
         r"厘米|公分|米)")  # fmt: skip
_N = r"\d+(?:[.,]\d+)?"
_X = r" ?(?:x|by|mal|sur|por|乘) ?"
_AXIS = (r"(?:wide|long|high|tall|deep|thick|across|in (?:width|height|length|depth|diameter)|breit|lang|hoch|tief|"
         r"dick|de (?:large(?:ur)?|long(?:ueur|itud)?|haut(?:eur)?|profondeur|ancho|largo|alto|altura|anchura|fondo|"
         r"profundidad|epaisseur|grosor)|or (?:wider|higher|taller|more|less)|宽|长|高|深|厚)")  # fmt: skip
_EXTENT = (r"(?:widths?|heights?|lengths?|depths?|sizes?|dimensions?|thickness(?:es)?|diameters?|breiten?|hohen?|"
           r"langen?|tiefen?|grossen?|starken?|dicken?|largeurs?|hauteurs?|longueurs?|profondeurs?|epaisseurs?|"
           r"anchos?|anchuras?|alturas?|largos?|grosor(?:es)?)")  # fmt: skip
_AROUND = (r"(?:(?:at (?:the )?(?:least|most)|about|around|approx\.?|roughly|ca\.?|min(?:imum|destens|\.)?|max(?:imum|"
           r"imal|\.)?|no (?:more|less|wider|narrower|higher|taller|lower|larger|smaller) than|not (?:more|less|wider|"
           r"narrower|higher|taller) than|(?:lower|higher|taller|wider|narrower|longer|shorter|larger|smaller|more|"
           r"less) than|under|over|below|above|up to|(?:d')?au (?:moins|plus)|moins de|plus de|al menos|como "
           r"(?:maximo|minimo)|menos de|mas de|hochstens|mindestens|wenigstens|etwa|rund|unter|uber|niedriger als|"
           r"hoher als|breiter als|exactly|至少|最多|不超过|不小于|约) ?)*")  # fmt: skip
_IS = (r"(?: |,? ?\(|: ?|-)?(?:(?:should|must|has to|have to|to|is|are|be|with|of|at|that|which|who|measures?|"
       r"measuring|an?|their|its|having|has|have|set|hung|placed|sein|soll(?:en)?|muss|mussen|ist|sind|misst|messen|"
       r"mit|von|auf|einer|der|die|mide[nr]?|miden|de|d'|unos|una|debe[nr]?|deben|tener|ser|que|est|sont|fait|font|"
       r"faire|mesure(?:nt|r)?|doit|doivent|avoir|avec|une|un|en|los|las|le|la|les)(?: |(?<=d')))*")  # fmt: skip
_LENGTHS = (rf"{_N} ?(?:{_UNIT})?(?:{_X}{_N} ?(?:{_UNIT})?){{1,2}}|{_N}(?: |-)?{_UNIT}(?: (?:and|und|et|y) {_N} "
            rf"?{_UNIT})?")  # fmt: skip
_SIZE = rf"(?P<said>{_AROUND}(?P<size>{_LENGTHS})(?:[ -]?{_AXIS})*)"
_BEHIND = r"(?![\w²]| ?(?:m2|sqm|square|sq|x ?\d)| (?:from|away|off|apart)\b| (?:bed|bath|living)? ?rooms?\b)"
_NAMED = {"size": _SIZE, "is": _IS, "extent": _EXTENT, "around": _AROUND, "axis": _AXIS, "behind": _BEHIND}
_ROOMY = 2.7
"""Metres: what is as long and as wide as that is a room."""
_LONGEST = 4.5
"""Metres of the longest thing."""
_SOME = late(rf"\d ?-?{_UNIT}|\d ?[x×] ?\d")


def sized_things(text: str) -> tuple[str, list[tuple[str, str]]]:
    """A text without sizes of things, folded where it had some; these sizes, and why they are left out."""
    if not (any(map(str.isdigit, text)) and _SOME.search(text.lower())):
        return text, []
    folded, said = fold(text), list[tuple[str, str]]()
    for kind, pattern, keeps in _patterns():
        def told(found: re.Match[str], kind: str = kind, keeps: bool = keeps) -> str:
            if not _of_a_thing(found["size"], kind):
                return found.group()
            said.append((found["said"].strip(), _why(kind, found.group())))
            return found["thing"] if keeps else ""

        folded = pattern.sub(told, folded)
    return (folded, said) if said else (text, [])


@cache
def _patterns() -> list[tuple[str, Late, bool]]:
    """Kinds of things, how their sizes are said, and whether the thing is to be had as well."""
    out = []
    for kind, things in THINGS.items():
        named = {**_NAMED, "thing": rf"(?P<thing>(?<![a-z'-])(?:{things})(?![a-z]))"}
        has = kind == "furniture"
        out += [
            (kind, Late(r"{thing}{is}{size}{behind}\)?", named), has),
            (kind, Late(r"(?<![\w.,]){size}[ -](?:wide |long |high |tall )?{thing}", named), has),
            (kind, Late(r"{thing}(?:'s)?[ -]?{extent}{is}{size}{behind}", named), has),
            (kind, Late(r"(?:the )?{extent} (?:of|von|de[rs]?|du|des|del|d')? ?(?:(?:the|all|any|den|les|las|los|"
                        r"allen|toutes|todas) )*{thing}{is}{size}{behind}", named), has),
            (kind, Late(r"{thing}的?(?:宽|长|高|深|厚)度?(?:为|是|要|应)?{size}{behind}", named), has),
        ]  # fmt: skip
    return out


def _of_a_thing(size: str, kind: str) -> bool:
    """Whether so much is the size of a thing: a sofa of 2 x 1 m, and not one in a room of 4 x 5 m."""
    numbers = [float(n.replace(",", ".")) for n in re.findall(_N, size)]
    unit = re.search(_UNIT, size)
    scale = {"c": 0.01, "厘": 0.01, "公": 0.01, "i": 0.0254, "f": 0.3048}.get(unit[0][0] if unit else "", 1.0)
    scale = 0.001 if unit and unit[0] == "mm" else scale
    if unit is None:
        return min(numbers) >= 40 and max(numbers) <= 300  # "160x200", no unit and no room
    sides = sorted(n * scale for n in numbers)
    return sides[-1] <= _LONGEST and (len(sides) == 1 or sides[0] < _ROOMY) and (kind != "walls" or sides[0] < 1)


def _why(kind: str, text: str) -> str:
    if kind == "doors":
        high = re.search(r"high|tall|height|hoch|hohe|haut|alto|altura|高|thick|dick", text)
        kind, how = "doors", "high" if high else "wide"
        return f"how {how} {kind} are is not asked of a plan"
    return f"how large {kind} {'is' if kind == 'furniture' else 'are'} is not asked of a plan"
