"""The room that one enters first: `entry is through the kitchen`, `la puerta da al salón`, near the entrance then."""

import re

from apartgen.stages.plan.reader.homely import hall_or_studio
from apartgen.stages.plan.reader.pieces import reworded, rules

_ENGLISH = {
    "kitchen": "kitchen|kuche|wohnkuche|cuisine|cocina|厨房",
    "dining room": "dining room|dining area|esszimmer|salle a manger|comedor|餐厅",
    "living room": "living room|lounge|living area|living space|living-room|sitting room|great room|main room|"
                   "wohnzimmer|wohnraum|salon|sejour|sala(?: de estar)?|客厅|起居室",
}  # fmt: skip
_ROOM = f"(?P<room>{'|'.join(_ENGLISH.values())})"
_DOOR = (r"(?:(?:the |our |my )?(?:(?:front|main|entrance|entry|apartment|flat|house|home|outside|outer) doors?|"
         r"(?:main )?entrance(?: door)?|entry(?:way)?))")  # fmt: skip
_TO = r"(?:(?:directly|straight|right|immediately|first) )?(?:in ?to|on ?to|to|in|inside|on|at|through|via|by)"
_WHO = r"(?:you|one|we|i|people|visitors|everyone|everybody|guests)"
_LEADS = (r"(?:(?:should|must|shall|will|to|has|have|can|would) )*(?:opens?|leads?|goes|go|gives?|be|is|are|comes?|"
          r"brings?|takes?)(?: you| us| one)?")  # fmt: skip
_HOME = r"(?:(?: the| our| my)? (?:flat|apartment|home|house|unit|place|studio))?"
_ELSEWHERE = re.compile(r"\b(?:whose|its|only|al|a la) [^.;]*$|\b(?:to|of|into) (?:the |an? )?[a-z]+,? $")
"""What is entered there is another room: `al lavadero, con lavadora, se entra por la cocina`."""
_NO_HALL = re.compile(r"(?:n't (?:need|want)|\b(?:no|without|not (?:need|want)|kein\w*|ohne|sans|pas de|sin|ningun)) "
                      r"(?:an? |any )?(?:[a-z]+ )?(?:hall|hallway|corridor|passage|flur|diele|couloir|pasillo|"
                      r"recibidor)\b")  # fmt: skip


def _first(found: re.Match[str]) -> str:
    """That the door of the home leads there; a room that is not the hub, or has a hall before it, is near the door."""
    clause = re.split(r"[.;]", found.string[: found.start()])[-1]
    if _ELSEWHERE.search(clause):
        return found.group()
    room = next(name for name, words in _ENGLISH.items() if re.fullmatch(words, found["room"]))
    begin = found.groupdict().get("begin") or ""
    said = f"{begin}the front door leads to the {room}"
    rest = found.string.replace(found.group(), "")
    hall = hall_or_studio(rest) and "studio" not in rest and not _NO_HALL.search(rest)
    hub = room == "living room" and not hall
    return said if hub else f"{said}. the {room} is near the entrance"


_BEGINS = (r"(?:(?<=^)|(?<=[.;,:(] )|(?<=[.;,:(])|(?<=\band )|(?<=\bso )|(?<=\bwhere )|(?<=\bhome )|(?<=\bflat )|"
           r"(?<=\bapartment ))")  # fmt: skip
_SAID = rules((
    (r"\b{door}(?: of the (?:flat|apartment|house|home))? {leads} {to} (?:the |an? |our )?{room}{end_}", _first),
    (r"\b{door}(?: is| being)? (?:through|via|by|in|into) (?:the |our )?{room}{end_}", _first),
    (r"{begins}{who} (?:(?:can |should |must |will |would |do |wants? to |(?:would )?like to )*(?:enters?|arrives?|"
     r"comes? in|walks? in|gets? in|steps? in)|(?:comes?|walks?|steps?|gets?|goes?) in(?:side)?){home} {to} (?:the |"
     r"our )?{room}{end_}", _first),
    (r"\b(?:from|through|behind|inside|via) {door},? (?:{who} )?(?:(?:can |should |must |will )?(?:enters?|arrives?|"
     r"comes?|walks?|steps?|gets?|goes?|is|are)|there is|lies|find|have)(?: {to})? (?:the |our )?{room}{end_}", _first),
    (r"\b(?:on|when|upon|by|after) (?:entering|coming in|walking in|arriving|stepping in|{who} (?:enters?|comes? in|"
     r"arrives?)){home},? (?:{who} )?(?:(?:are|is|stands?|comes?|arrives?|finds?) )?(?:{to} )?(?:the |our "
     r")?{room}{end_}",
     _first),
    (r"(?P<begin>,? ?)\b(?:is |to be |that is )?(?:entered|accessed|reached) (?:directly |only )?(?:through|via|from|"
     r"by) (?:the |our |its )?{room} (?:from (?:outside|the street|the stairs)|first)", _first),
    (r"(?P<home>\b(?:flat|apartment|home|house|studio|unit)),? (?:(?:is|to be|that is|which is) )?(?:entered|"
     r"accessed) (?:directly |only )?(?:through|via|by|from) (?:the |our |its )?{room}{end_}",
     lambda found: f"{found['home']}. {_first(found)}"),
    # "die Wohnungstür führt ins Wohnzimmer", "man betritt die Wohnung durch die Küche"
    (r"\b(?:die |der )?(?:(?:wohnungs|haus|eingangs|haupt)tur|(?:haupt|wohnungs)?eingang) (?:soll |ist |muss "
     r")?(?:fuhrt|offnet(?: sich)?|geht|mundet|liegt|direkt|gleich|ist|befindet sich| )*(?:ins?|im|in (?:das|die|den|"
     r"der)|zu[mr]|auf (?:das|die)) (?:die |der |das |den )?{room}\b(?: fuhren| gehen| liegen| sein)?", _first),
    (r"\bman (?:betritt|kommt in) (?:die wohnung|das haus|das apartment) (?:direkt |gleich )?(?:durch|uber|in) (?:die|"
     r"das|den) {room}\b", _first),
    (r"\bman (?:kommt|tritt|gelangt|steht) (?:(?:direkt|gleich|sofort|zuerst) )+(?:ins?|im|in (?:das|die|der)) (?:die "
     r"|der |das )?{room}\b", _first),
    # "l'entrée donne sur le salon", "on entre par la cuisine"
    (r"(?:(?<=^)|(?<=[.;,:] )|(?<=\bet ))(?:l'entree|la porte(?: d'entree| principale)?)(?: principale)? (?:donne|"
     r"s'ouvre|ouvre|mene|debouche|se fait|est)(?: directement)? (?:sur|dans|a|vers|par|au) ?(?:la |le |l')?{room}\b",
     _first),
    (r"(?:(?<=^)|(?<=[.;,:] )|(?<=\bet ))on (?:entre|arrive)(?: directement)? (?:par|dans) (?:la |le |l'){room}\b(?! "
     r"par)", _first),
    # "la entrada da al salón", "se entra por la cocina"
    (r"(?:(?<=^)|(?<=[.;,:] )|(?<=\by ))(?:la entrada|la puerta(?: principal| de (?:entrada|la calle))?|el acceso)(?: "
     r"principal)? (?:da|abre|se abre|lleva|conduce|es|esta)(?: directamente)? (?:al?|en|por|hacia)(?: el| la)? "
     r"{room}\b",
     _first),
    (r"(?:(?<=^)|(?<=[.;,:] )|(?<=\by ))(?:se (?:entra|accede)|entras|entramos)(?: a(?:l piso| la casa| la "
     r"vivienda))?(?: directamente)? (?:por|en|al?)(?: el| la)? {room}\b(?! por)", _first),
    # "入户门直接进客厅", "从厨房进门"
    (r"(?:入户门|大门|进户门|正门|入口|进门)(?:直接|就|后|是|要|应该?)*(?:进入?|通向|通往|通到|开向|对着|到|是|"
     r"在)*{room}(?=[,.;]|$)", _first),
    (r"[从由]{room}(?:进门|入户|进屋)", _first),
), room=_ROOM, door=_DOOR, leads=_LEADS, to=_TO, who=_WHO, home=_HOME, begins=_BEGINS,
   end_=r"(?![a-z'])(?! (?:and the|door|wall|through|from the|via) )(?!,? (?:which|then|from there)\b)")  # fmt: skip


def one_enters(text: str) -> str:
    """A folded text with such rooms behind the front door."""
    return reworded(text, _SAID)
