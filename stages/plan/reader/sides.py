"""Sides of the home as people write them: `at north side of the house`, `center east of the property`, `lower left`."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

DWELLINGS = {"house": "home", "home": "home", "flat": "flat", "apartment": "apartment"}
"""What tells that more than the rooms named are wanted, and is kept; not that it is a house that stands alone."""
ENDS = {"upper": "top", "lower": "bottom", "rear": "back"}


def _side(found: re.Match[str]) -> str:
    """A side, or a corner where two meet; of the home where it is named."""
    side = re.sub(r"ern\b", "", found["side"].replace("-", " "))
    home = _of(found["home"])
    corner = re.fullmatch(r"(north|south) ?(east|west)", side)
    if corner:
        return f"in the {corner[1]} {corner[2]} corner{home}"
    side = ENDS.get(side, side)
    if side in ("top", "bottom", "front", "back"):
        return f"at the {side}{home}"
    return f"{'in' if side in ('left', 'right') else 'at'} the {side} side{home}" if home else f"on the {side} side"


def _corner(found: re.Match[str]) -> str:
    """`in the lower left of the image`, `to the upper right of the living room`: north is up."""
    level, hand = found["level"] in ("top", "upper"), found["hand"] == "left"
    side = f"{'north' if level else 'south'} {'west' if hand else 'east'}"
    return f"{side} of " if found["other"] else f"in the {side} corner{_of(found['home'])}"


def _of(home: str | None) -> str:
    noun = (home or "").rpartition(" ")[2]
    return f" of the {DWELLINGS[noun]}" if noun in DWELLINGS else ""


_SAID = rules((
    # "in the lower left of the image", "upper right hand side", "to the top right of the kitchen"
    (r"\b(?:(?:in|at|on|to) (?:the )?)?(?P<level>top|upper|bottom|lower)[ -](?P<hand>left|right)(?:[ -]hand)?"
     r"(?: (?:side|corner|part|area|section|portion))?\b(?! (?:cabinets?|cupboards?|shelf|shelves|drawers?|units?))"
     r"(?: of (?P<home>{home})|(?P<other> of ))?", _corner),
    # "in the middle of the north side", "center-east side", "central but on the western edge", "at the north center"
    (r"\b(?:(?:exact|very|dead) )?(?:mid|middle|cent(?:er|re)|central(?:ly)?)(?:[ -]| of (?:the )?)"
     r"(?P<side>{side})(?:ern)?(?: {part})?\b(?! of (?!{home}))", r"\g<side> side"),
    (r"\b(?:in the (?:exact |very )?(?:middle|cent(?:er|re))|central(?:ly)?),?(?: located| placed| situated| but)* "
     r"(?:on|at|along) the (?P<side>{side})(?:ern)? (?:side|part|end|edge|wall)\b", r"on the \g<side> side"),
    (r"\b(?P<side>{side})(?:ern)?[ -](?:middle|cent(?:er|re))(?: (?:side|corner|part|edge))?\b", r"\g<side> side"),
    # "on the left hand center", "on the far left"
    (r"\b(?P<side>left|right)(?:[ -]hand)?(?: side)?,? (?:middle|cent(?:er|re))\b", r"\g<side> side"),
    (r"\b(?P<at>on|to|at|in) the (?:far|very|extreme) (?=(?:left|right|{side})\b)", r"\g<at> the "),
    # "located east side of the house", "the kitchen goes in the north"
    (r"\b(?P<is>located|situated|placed|positioned|found|is|are) (?P<side>{side})(?:ern)?(?: (?:side|part|end))? "
     r"of (?P<home>{home})", lambda found: f"{found['is']} {_side(found)}"),
    (r"\bgo(?:es)? (?=(?:in|on|at|to) (?:the )?{any}\b)", "is "),
    # "on the west of the property", "at north side of the house", "in the upper half of the plan", "in the north part"
    (r"\b(?:in|at|on|to|along)(?: the)?(?: far| very| extreme| exact)? (?P<side>{any})(?:[ -]hand)?(?: {part})?,? "
     r"(?:of|in) (?P<home>{home})", _side),
    (r"\b(?:in|at|on|to) (?:the )?(?P<side>{any})(?:[ -]hand)? (?:half|third|zone|portion|section|part|end|edge|side)\b"
     r"(?! (?:of|from|to)\b)(?P<home>)", _side),
    (r"\b(?P<level>north|south)(?P<hand>east|west)ern corner\b", r"\g<level> \g<hand> corner"),
    # "al norte del piso", "au nord de l'appartement"
    (r"\b(?P<at>al (?:norte|sur|este|oeste|noreste|nordeste|noroeste|sureste|sudeste|suroeste|sudoeste)|"
     r"a la (?:izquierda|derecha)) (?:del|de (?:la|nuestr[oa])) "
     r"(?=(?:piso|apartamento|vivienda|casa|plano|edificio|estudio)\b)", r"\g<at> en "),
    (r"\b(?P<at>(?:au|cote) (?:nord|sud)(?:[ -](?:est|ouest))?|(?:a l'|cote )(?:est|ouest)|a (?:gauche|droite)) "
     r"(?:du |de (?:la |notre )|de l' ?)(?=(?:appartement|appart|logement|maison|plan|studio|immeuble)\b)",
     r"\g<at> dans "),
), side=r"(?:north|south|east|west)",
   any=r"(?:(?:north|south)(?:ern)?(?:[ -]?(?:east|west)(?:ern)?)?|(?:east|west)(?:ern)?|left|right|top|upper|bottom|"
       r"lower|front|back|rear)",
   part=r"(?:side|part|end|edge|wall|section|portion|area|corner|half|zone)",
   home=r"(?:(?:the|this|our|my|your) )?(?:whole |entire )?(?:house|home|flat|apartment|property|(?:floor ?)?plan|"
        r"lay ?out|building|unit|map|image|picture|drawing|design|condo|residence|dwelling|structure)\b"
        r"(?! (?:north|south|east|west))")  # fmt: skip


def at_sides(text: str) -> str:
    """A folded text with such places in words that the rules of rooms know."""
    return reworded(text, _SAID)
