"""What specifications say of two rooms or of all: `open: kitchen-living room`, `all about 52 m2`, `45 m2 combined`."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_OPEN = r"(?:living(?: room)?|kitchen|dining(?: room| area)?|lounge|study|hallway|hall)"
_ONE = r"(?:(?:the )?(?:living(?: room)?|kitchen|dining(?: room| area)?|lounge))"
_JOINT = r" ?(?:<-+>|<->|->|-|/|\+|~|&) ?"
_TO = rf"(?:{_JOINT})"
_AREA = (r"(?P<area>(?:about |around |approx\.? |ca\.? )?\d{2,3}(?:\.\d+)? ?(?:m2|sqm|sq\.? ?m|qm|square "
         r"met(?:er|re)s?))")  # fmt: skip
_LOOSE = r"met(?:er|re)s|m"
"""Units in which learners tell the floor of a home."""
_HOME = _AREA.replace(r"\d{2,3}", r"(?:3[5-9]|[4-9]\d|[1-3]\d\d)")
"""As much as a home has; less is one of its rooms."""
_IS = (r"(?: (?:(?:should|must|shall|may|can|will|has to) (?:be|have|measure)|is|be|has|have|makes?|comes to|"
       r"measures?))?")  # fmt: skip
_COMBINED = r"(?:combined|together|altogether|in (?:all|total|sum)|total)"
_WIDE = (r"(?:an? )?(?:(?:wide|large|big|open|simple|free|broad) )*(?:opening|archway|arch|passage|pass-through|"
         r"way through)")  # fmt: skip
_BUT = r"(?:,? ?(?:but |and )?(?:only|just|rather|simply|merely)(?: (?:only|just))?,? )"


def _full(name: str) -> str:
    """`living` as the room it is."""
    name = name.strip()
    return f"{name} room" if name in ("living", "dining") else name.replace("dining area", "dining room")


def _opened(found: re.Match[str]) -> str:
    """`open: kitchen-living room, living room-dining room`: one opening after another."""
    pairs = [[_full(name) for name in re.split(_JOINT, pair)] for pair in re.split(r" ?, ?| and ", found["pairs"])]
    told = [f"{a} and {b} are open to each other" for pair in pairs for a, b in zip(pair, pair[1:], strict=False)]
    return f"{found['begin'].replace(';', '.')}{'. '.join(told)}."


def _together(found: re.Match[str]) -> str:
    """`kitchen + dining room + living room open plan, 45 m2 combined`, `kitchen-living room 28 m2`."""
    rooms = [_full(name) for name in re.split(r" ?[+/&,-] ?(?:and )?| and ", found["rooms"]) if name.strip()]
    opened = ", ".join(f"{a} open to {b}" for a, b in zip(rooms, rooms[1:], strict=False))
    begin = ". " if found["begin"] else ""
    return f"{begin}{' and '.join(rooms)} together {found['area']}, {opened}"


_SAID = rules((
    # "doors: hallway-bedroom; open: kitchen-living room"
    (r"(?P<begin>^|[;.\n] ?)(?:\"?open(?:ings?|[ _-]?(?:links?|connections?|plan|passages?|edges?))?\"?) ?: ?"
     r"(?P<pairs>{open}(?:{to}{open})+(?:(?: ?, ?| and ){open}(?:{to}{open})+)*)(?= ?(?:[;.\n]|$))", _opened),
    # "between kitchen and living room should be no door only opening"
    (r"(?:(?<=^)|(?P<begin>,? ?(?:and )?))\bbetween (?P<a>(?:the )?{open}) and (?P<b>(?:the )?{open}),? "
     r"(?:(?:i|we) (?:do not|don't) want (?:an? |any )?|(?:i|we) (?:want|need|would like) no |(?:there )?(?:{must} be |"
     r"is |comes |goes )?(?:there )?(?:no |not an? ))doors?{but}{wide}",
     r". \g<a> and \g<b> are open to each other"),
    (r"\bno doors? between (?P<a>(?:the )?{open}) and (?P<b>(?:the )?{open}){but}{wide}",
     r"no door between \g<a> and \g<b>, only an opening"),
    (r"\b(?:there )?(?:{must} not be|is not|isn't|shouldn't be|mustn't be) (?:an? |any )?doors? between "
     r"(?P<a>(?:the )?{open}) and (?P<b>(?:the )?{open}){but}{wide}",
     r"no door between \g<a> and \g<b>, only an opening"),
    # "keine Tür zwischen Küche und Wohnzimmer, nur eine Öffnung", "pas de porte …, juste une ouverture"
    (r"\b(?:keine tur zwischen (?:der |dem )?(?P<a>{de}) und (?:der |dem )?(?P<b>{de})|zwischen (?:der |dem )?"
     r"(?P<a2>{de}) und (?:der |dem )?(?P<b2>{de}) (?:soll |ist |kommt )?keine tur(?: sein)?),? (?:sondern |und "
     r")?(?:nur|bloss|lediglich) (?:eine? )?(?:offene[rn]? |breite[rn]? )?(?:offnung|durchgang)",
     lambda found: f"{found['a'] or found['a2']} offen zu {found['b'] or found['b2']}"),
    (r"\b(?:pas de|sans) porte entre (?:la |le |l')?(?P<a>{fr}) et (?:la |le |l')?(?P<b>{fr}),? (?:mais )?(?:juste|"
     r"seulement|uniquement) (?:une? )?(?:large |simple )?(?:ouverture|passage)", r"\g<a> ouverte sur \g<b>"),
    (r"\b(?:sin|ninguna) puerta entre (?:la |el )?(?P<a>{es}) y (?:la |el )?(?P<b>{es}),? (?:sino )?(?:solo|"
     r"solamente|unicamente) (?:una? )?(?:abertura|apertura|paso|hueco|vano)", r"\g<a> abierta a \g<b>"),
    # "All about 52 square metres", "the whole thing 60 m2", "everything together 60 m2"
    (r"(?P<begin>^|[.;\n] ?)(?:and )?(?:all(?: (?:of it|this|that))?|all (?:the )?rooms {combined})(?: "
     r"{combined})?{is_}(?: {combined})? {home}(?: {combined})?{end}", r"\g<begin>the flat has \g<area>"),
    (r"(?P<begin>^|[.;,\n] ?)(?:and )?(?:everything|the (?:whole|entire) (?:thing|place|lot|home|flat|apartment))"
     r"(?: {combined})?{is_}(?: {combined})? {home}(?: {combined})?{end}", r"\g<begin>the flat has \g<area>"),
    (rf"(?P<begin>[.;\n] ?)all (?:about|around|is|together) (?P<n>(?:3[5-9]|[4-9]\d|1\d\d)) ?(?:{_LOOSE}){{end}}",
     r"\g<begin>the flat has \g<n> m2"),
    # "a kitchen and a living room; 60 m2 in total", "…. Total area about 60 m2"
    (r"(?P<begin>[.;\n] ?)(?:{home} (?:in (?:all|total)|total|altogether|overall)|(?:(?:the )?total (?:floor )?(?:area|"
     r"size|surface)|in (?:total|all)|altogether|overall)(?: is| of| ?:)? {home2}){end}",
     lambda found: f"{found['begin']}the flat has {found['area'] or found['area2']}"),
    # "flat 60m for a couple"
    (r"\b(?P<home>(?:flat|apartment|house|home)) (?P<n>\d{2,3}) ?m(?=,| for | with |[.;]|$)", r"\g<home> \g<n> m2"),
    # "kitchen + dining room + living room open plan, 45 m2 combined"
    (r"(?P<begin>(?<=\w), )?\b(?P<rooms>{one}(?:(?: ?[+/&] ?| and |, (?:and )?){one})+)"
     r"(?: (?:are )?(?:all )?open[ -]plan| in one (?:space|room)|,? all open),? ?\(?{area} {combined}\)?", _together),
    (r"(?P<begin>(?<=\w), )?\b(?:an? )?open[ -]plan (?P<rooms>{one}(?:(?: ?[+/&] ?| and |, (?:and )?){one})+)"
     r"(?: area| space| room)?,? ?\(?(?:of )?{area} {combined}\)?", _together),
    # "kitchen-living room 28 m2"
    (r"(?P<begin>(?<=x), )?(?<![a-z] )\b(?P<rooms>(?:kitchen ?[-/+] ?(?:living room|lounge)|"
     r"(?:living(?: room)?|lounge) ?[-/+] ?kitchen))(?: (?:of|with))?(?: ?: ?| ?\(| ){area}\)?", _together),
), open=_OPEN, one=_ONE, to=_TO, area=_AREA, home=_HOME, is_=_IS,
   home2=_HOME.replace("<area>", "<area2>"), combined=_COMBINED,
   wide=_WIDE, but=_BUT)  # fmt: skip


def specified(text: str) -> str:
    """A folded text with such statements in words that the rules of rooms know."""
    return reworded(text, _SAID)
