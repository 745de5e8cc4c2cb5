"""Sides of the entrance as German, French and Spanish say them: `à gauche de l'entrée et le salon à droite`."""

import re

from apartgen.stages.plan.reader.patterns import late

_SIDE = {"gauche": "left", "droite": "right", "izquierda": "left", "derecha": "right", "links": "left",
         "rechts": "right", "left": "left", "right": "right"}  # fmt: skip
_OTHER = {"left": "right", "right": "left"}
_BARE = {
    "left": r"a gauche|a la izquierda|a mano izquierda|links|on the left",
    "right": r"a droite|a la derecha|a "
    r"mano derecha|"
    r"rechts|on the right",
}
_DE = r"(?:eingang|hauseingang|haustur|eingangstur|wohnungstur|tur)"
_ARTICLE = r"(?:das|die|der|la|le|el|un|una|une|eine?|the|an?)"
_BEFORE = late(rf"\b((?:left|right) of the entrance)(?:,| is| lies| liegt| ist| esta| se trouve|:) ?(?={_ARTICLE} )")
_AT_DOOR = late(
    r"\b(?:sur la |a (?:main )?)(?P<fr>gauche|droite) (?:de (?:l'entree|la porte(?: d'entree)?)|en entrant|"
    r"quand on entre|depuis l'entree)(?! principale)\b"
    r"|\ba (?:la |mano )(?P<es>izquierda|derecha) (?:de la (?:entrada|puerta(?: de entrada| principal)?)|al entrar|"
    r"segun se entra|desde la entrada|entrando)\b"
    r"|\bon (?:the |your |my )?(?P<en>left|right)(?: hand)?(?: side)? (?:as|when) (?:you|one|we) (?:enters?|comes? "
    r"in|walks? in|steps? in)"
    r"(?: the (?:flat|apartment|house|home)| through the (?:front )?door)?(?! (?:the|a) )"
    rf"|\b(?P<de>links|rechts) (?:beim (?:reinkommen|hereinkommen|eintreten|betreten)|wenn man (?:reinkommt|"
    rf"hereinkommt|eintritt)|(?:vom|von der|neben dem|neben der|am|beim|an der) {_DE})\b"
)
_IN = {
    "fr": re.compile(r"\b(?:en entrant|depuis l'entree|de l'entree),? (?:sur la |a (?:main )?)(gauche|droite)\b"),
    "es": re.compile(r"\b(?:al entrar|entrando|desde la entrada),? a (?:la |mano )(izquierda|derecha)\b"),
    "de": re.compile(rf"\b(?:beim (?:reinkommen|eintreten|betreten)|vom {_DE} aus)(?: gesehen)?,? (links|rechts)\b"),
}


def beside_entrance(text: str) -> str:
    """A folded text with such sides in English, that of the room named next among them."""
    for said in _IN.values():
        text = said.sub(lambda found: f"{_SIDE[found[1]]} of the entrance", text)
    text = _AT_DOOR.sub(lambda found: f"{_SIDE[found[found.lastgroup or 'fr']]} of the entrance", text)
    if " of the entrance" not in text:
        return text
    text = _BEFORE.sub(r"\1 ", text)
    for side, other in _OTHER.items():
        begins = re.compile(
            rf"(\b{side} of the entrance\b[^.;]*?)(?:[,;] ?|,? (?=und|et|y|and))(?:(?:und|et|y|and) )?"
            rf"(?:{_BARE[other]})(?:,| is| lies| liegt| ist| esta|:)?(?= {_ARTICLE} )"
        )
        text = begins.sub(rf"\1, {other} of the entrance", text)
        behind = re.compile(rf"(\b{side} of the entrance\b[^.;]*?\b)(?:{_BARE[other]})(?: davon| de (?:celle-ci|"
                            rf"elle|ella))?"
                            rf"(?= ?(?:[.,;]|$)| (?:und|et|y|liegt|ist|{_ARTICLE})\b)(?! de)")  # fmt: skip
        text = behind.sub(rf"\1{other} of the entrance", text)
    return text
