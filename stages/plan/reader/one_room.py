"""Rooms to live and sleep in: `a living and sleeping room`, `Wohn-Schlafzimmer`, a studio's `sleeping corner`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded, rules

_BEDROOMS = late(r"\bbed ?room|schlafzimmer|kinderzimmer|\bchambre|\bdormitorio|\bhabitaci|卧室|\bmaster\b|"
                 r"\bkids? |\bguest ?room")  # fmt: skip
_STUDIO = late(r"\bstudio|einzimmer|\bein[- ]?raum|\b1[ -](?:zimmer|room)|\bone-room|"
               r"\bone room (?:flat|apartment|home)|\bbedsit|\bestudio\b|\bmonoambiente|单间|开间")  # fmt: skip

_TWO_ROOMS = late(r"\b(?:two|2)[ -]room(?:ed)? (?=flat|apartment|home|unit|condo)")


def _main_room(found: re.Match[str]) -> str:
    """A studio, or the living room of a home that has bedrooms beside it."""
    if _STUDIO.search(found.string):
        return "a main room"
    rest = f"{found.string[: found.start()]}|{found.string[found.end() :]}"
    return "a living room with a double bed" if _BEDROOMS.search(rest) else "a studio"


def _bed(found: re.Match[str]) -> str:
    """What a studio's corner to sleep in is furnished with."""
    return "a double bed" if _STUDIO.search(found.string) else found.group()


def _home_of_one(found: re.Match[str]) -> str:
    """Without what makes a flat a studio; a studio that has a bed is one."""
    home = "flat" if found["home"] == "pad" else found["home"]
    return home if _BEDROOMS.search(found.string) else found.group()


_SAID = rules((
    # "bachelor flat, one bedroom": where a bachelor lives, and no studio
    (r"\bbachelor(?:'s)? (?P<home>flat|apartment|pad|condo|home)\b", _home_of_one),
    # "a room for living and sleeping", "a combined living and sleeping room", "a living-bedroom"
    (r"\b(?:one|an?|single|1) (?:single )?room (?:for|to) (?:both )?(?:living|live)(?: in)? and (?:for |to )?"
     r"(?:sleeping|sleep)(?: in)?\b", _main_room),
    (r"\b(?:an? |one |the )?(?:large |big )?(?:combined|joint) (?:living|sitting)(?: room)?(?: and |[ /&+-]+)"
     r"(?:sleeping|bed) ?(?:room|area)\b(?! and| or)", _main_room),
    (r"\b(?:an? |one |the )?(?:(?:large|big|single) )*(?:living|sitting)(?: and | ?[/&+-] ?)sleeping (?:room|area)\b"
     r"(?! and| or)", _main_room),
    (r"\b(?:an?|one) (?:large |big )?living ?[-/] ?bed ?room\b(?! ?/)", _main_room),
    (r"\b(?:eine?[mn]? |das )?(?:(?:kombinierte[sn]?|grosse[sn]?) )*wohn(?:-?/-?|- und | und |-)?"
     r"schlaf(?:zimmer|raum|bereich)\b", _main_room),
    (r"\b(?:une? |le |la )?(?:sejour|salon|piece a vivre)[ /-]+chambre\b", _main_room),
    (r"\b(?:une? |la |le )?(?:piece a vivre|piece principale|salon|sejour) (?:qui )?(?:sert|servant|fait) "
     r"(?:aussi |egalement )?(?:de|office de) chambre\b", _main_room),
    (r"\b(?:una? |el |la )?(?:salon|sala)[ /-]+(?:dormitorio|habitacion)\b", _main_room),
    # "with a sleeping corner", of a studio
    (r"\b(?:an? |one |the )?(?:(?:small|separate|cosy|cozy) )*(?:sleeping|sleep|bed) "
     r"(?:corner|area|nook|alcove|niche|zone|space)\b{stands}", _bed),
    (r"\b(?:eine?[nmr]? |der |die |den )?(?:kleine[rn]? )?schlaf(?:ecke|nische|bereich|platz|alkoven)\b{stands}",
     _bed),
    (r"\b(?:une? |le |la )?(?:petite? )?(?:coin|espace|alcove|zone)[ -](?:nuit|chambre|couchage|pour dormir)\b"
     r"{stands}", _bed),
    (r"\b(?:una? |la |el )?(?:pequen[oa] )?(?:zona|rincon|espacio|area) (?:de|para) (?:dormir|descanso|noche)\b"
     r"{stands}", _bed),
    (r"(?:一个)?(?:睡眠|睡觉|休息|卧室)区(?:域)?", _bed),
), stands=r"(?= ?(?:[.,;:!)]|$)| (?:and|plus|with|in|und|mit|et|avec|dans|y|con|en) )")  # fmt: skip


def in_one_room(text: str) -> str:
    """A folded text with such rooms as studios or as living rooms with a bed; the kitchen is the other of two rooms."""
    told = reworded(text, _SAID)
    return _TWO_ROOMS.sub("", told) if told != text and "a studio" in told else told
