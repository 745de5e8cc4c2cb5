"""Whose side it is behind a room that is no subject: `the balcony off the living room faces south`."""

import re

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.patterns import late

VERBS = ("faces", "face", "looks", "look", "is", "are", "lies", "lie", "has", "have", "must", "should", "overlooks",
         "overlook")  # fmt: skip
"""First words of a side that say it of a subject."""
PLURAL = ("face", "look", "are", "lie", "have", "overlook")
PARTICIPLES = ("facing", "looking")
OUTSIDE = ("balcony",)
"""Rooms that lie open to a side, which one says of them rather than of the room they are entered from."""
_DE = {"norden": "north", "suden": "south", "osten": "east", "westen": "west", "nordosten": "north east",
       "nordwesten": "north west", "sudosten": "south east", "sudwesten": "south west"}  # fmt: skip
_FR = {"nord": "north", "sud": "south", "est": "east", "ouest": "west", "nord-est": "north east",
       "nord-ouest": "north west", "sud-est": "south east", "sud-ouest": "south west"}  # fmt: skip
_ES = {"norte": "north", "sur": "south", "este": "east", "oeste": "west", "noreste": "north east",
       "nordeste": "north east", "noroeste": "north west", "sureste": "south east", "sudeste": "south east",
       "suroeste": "south west", "sudoeste": "south west"}  # fmt: skip
_SIDE_OF = _DE | _FR | _ES
_NACH, _AU, _AL = ("|".join(sorted(sides, key=len, reverse=True)) for sides in (_DE, _FR, _ES))
_SEVERAL = re.compile(r"(?:sollen|sind|(?!sich)[a-z]+en|donnent|regardent|sont|miran|dan|se orientan|estan)\b")
"""Verbs of several rooms."""
_VERBS = [late(pattern) for pattern in (
    # "zeigt nach Westen", "liegen nach Süden hin"
    r"\b(?:(?:zeig|blick|weis|schau|geh|lieg|geoffne|offne)(?:t|en)(?: sich)?|soll(?:en)? (?=[^.,;]* (?:zeigen|blicken|"
    rf"gehen|liegen|weisen)\b)|ist ausgerichtet|sind ausgerichtet) nach ({_NACH})"
    r"(?: hin)?(?: (?:zeigen|blicken|gehen|liegen|weisen))?\b",
    rf"\b(?:ist|sind) nach ({_NACH}) (?:hin )?(?:ausgerichtet|gerichtet|orientiert)\b",
    # "donne au sud", "sont exposées plein est"
    r"\b(?:donne|donnent|regarde|regardent|est (?:oriente|expose)e?|sont (?:oriente|expose)e?s) "
    rf"(?:au|a l'|plein|vers le|vers l'|sur le) ?({_AU})\b",
    # "mira al sur", "están orientados al norte"
    r"\b(?:mira|miran|da|dan|se orienta|se orientan|(?:esta|estan) (?:orientad|expuest)[oa]s?) "
    rf"(?:al|hacia el) ({_AL})\b",
)]  # fmt: skip


def facing(text: str) -> str:
    """A folded text in which rooms of other languages face their sides, as those of English do."""
    for pattern in _VERBS:
        text = pattern.sub(_faces, text)
    return text


def _faces(found: re.Match[str]) -> str:
    return f"{'face' if _SEVERAL.match(found.group()) else 'faces'} {_SIDE_OF[found[1]]}"


def subject_of(items: list[Item], j: int, k: int) -> int:
    """Where the subject stands of the side at `k` behind the room at `j`; `j` where that is said of it itself."""
    if (off := _off_a_hall(items, j, k)) is not None:
        return off
    start = _before(items, j)
    first, last = (items[start].room if start >= 0 else None), items[j].room
    if first is None or last is None or _led(items, start):
        return j
    between = items[j + 1 : k]
    words = [i.text for i in between if i.kind in ("copula", "reach")] + [items[k].text]
    verb, between = words[0].split()[0], [i for i in between if i.kind not in ("copula", "reach")]
    has = items[j - 1].kind == "with"
    fits = not between and not has and items[j - 1].form not in ("s", "p")
    fits = fits and (verb in VERBS or (verb in PARTICIPLES and last.type == "hallway"))
    fits = fits or (len(between) == 1 and _goes_on(between[0], verb, first))
    return start if fits and _agrees(first, verb) and not items[j].joined else j


def _off_a_hall(items: list[Item], j: int, k: int) -> int | None:
    """The toilet of `a toilet is off the hall near the entrance`; None where halls are told apart, or none is there."""
    hall, halls = items[j].room, [i for i in items[:k] if i.value == "hallway"]
    near = items[k].value == "entrance" and [i.value for i in items[j + 1 : k]] == ["near"]
    if not near or hall is None or hall.type != "hallway" or len(halls) > 1 or items[j - 1].text.split()[-1] != "off":
        return None
    at = j - 2
    while at > 0 and (items[at].kind in ("copula", "relative") or is_mark(items[at], ",")):
        at -= 1
    return at if at >= 0 and items[at].room is not None else None


def _before(items: list[Item], j: int) -> int:
    """Where the room stands that a relation leads from to the room at `j`, or whose the room at `j` is; -1: none."""
    at = j - 1
    if at >= 0 and (items[at].kind in ("link", "front") or (items[at].value == "has" and items[at].kind == "with")):
        at -= 1
        while at >= 0 and items[at].kind == "copula":
            at -= 1
    elif at < 0 or items[at].value not in OUTSIDE:
        return -1
    return at if at >= 0 and items[at].room is not None else -1


def _led(items: list[Item], start: int) -> bool:
    """Whether the room at `start` is itself what another one leads to or has."""
    return start > 0 and items[start - 1].kind in ("link", "front") or (
        start > 1 and items[start - 1].kind == "with" and items[start - 2].room is not None)


def _goes_on(joint: Item, verb: str, first: RoomPhrase) -> bool:
    """`… opens off the hall and faces north`, `a study next to the bedroom, facing north`, `a balcony …, which …`."""
    if joint.kind == "conjunction":
        return joint.value == "and" and verb in VERBS
    if is_mark(joint, ","):
        return verb in PARTICIPLES or verb in VERBS
    return joint.kind == "relative" and first.type in OUTSIDE and verb in VERBS


def _agrees(first: RoomPhrase, verb: str) -> bool:
    several = first.plural or (first.count or 1) > 1
    return verb in PARTICIPLES or verb in ("must", "should") or several == (verb in PLURAL)
