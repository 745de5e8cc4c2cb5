"""Neighbours in other verbs than `next to each other`, and places told before their room: `beside it a store room`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import DE, ES, FR, KIND, reworded, rules

_WALL = r"(?:(?:common|shared|party|adjoining) walls?|walls? in common)"
_SIDE_BY_SIDE = "must not be next to each other"


def _together(found: re.Match[str]) -> str:
    """`no common wall between the bedrooms` as what they must not be."""
    return f"{found['begin']}{found['them']} {_SIDE_BY_SIDE}"


_SAID = rules((
    # "kitchen and bathroom must not be neighbours", "have no common wall", "there must be no shared wall between"
    (r"\b(?P<be>(?:must|should|shall|may|can|could|are|is|need|have|has|ought)(?: not)?(?: to)?(?: be)?) "
     r"(?:(?:direct|immediate|next-door|close) )?(?:neighbou?rs|neighbou?ring|abutting|touching)(?: each "
     r"other)?(?= ?(?:[.,;:!?)]|$)| (?:in|of|and|but)\b)",
     r"\g<be> next to each other"),
    (r"\b(?:{must} )?(?:have no {wall}|share no (?:{wall}|walls?))(?! ?:){end}", _SIDE_BY_SIDE),
    (r"\b{not} (?:have (?:an?y? )?{wall}|share (?:an?y? )?(?:{wall}|walls?))(?! ?:){end}", _SIDE_BY_SIDE),
    (r",? (?:without|with no) (?:an?y? )?{wall}(?: between (?:them|the two|each other))?{end}",
     f". they {_SIDE_BY_SIDE}"),
    (r"(?P<begin>^|[.;:,] ?|\band |\bbut )(?:(?:there )?(?:{must} |is |are )?(?:not )?(?:be )?)?(?:no|without) "
     r"(?:common|shared|party|adjoining) walls? between (?P<them>(?:(?:the|my|our|both|two|these|all) )*{kind}s?"
     r"(?:(?:,? and|,) (?:the |my |our )?{kind})*){end}", _together),
    (r"\b(?P<die>und (?:das |die |der )?{de}) (?P<verb>haben|teilen|durfen|sollen|mussen)(?: sich)? keine(?:n)? "
     r"(?:gemeinsame )?wand(?: haben| teilen)?\b", r"\g<die> sollen nicht nebeneinander liegen"),
    (r"\b(?P<verb>sollen|durfen|mussen)(?P<not> nicht)? (?:direkt )?(?:aneinander ?grenzen|aneinander ?stossen|"
     r"benachbart sein|nachbarn sein|aneinander liegen|wand an wand liegen)\b",
     lambda found: f"{found['verb']}{found['not'] or ''} nebeneinander liegen"),
    (r"\bgrenzen (?P<not>nicht )?(?:direkt )?aneinander\b",
     lambda found: f"liegen {found['not'] or ''}nebeneinander"),
    (r"\b(?P<be>(?:no )?(?:deben |tienen que |pueden )?(?:estar|esten|estan|queden|quedar)) (?:bien |muy )?"
     r"(?:juntos|juntas|pegad[oa]s|al lado)(?: entre si)?(?: un[oa] (?:de|a) otr[oa])?{end}", r"\g<be> contiguos"),
    (r"\b(?:una|la) (?P<es>{es}) y (?P<b>(?:el |la |un |una )?{es}) pegad[oa]s\b", r"una \g<es> y \g<b> contiguos"),
    # "no room larger than the living room"
    (r"(?P<begin>^|[.;:,] ?|\band |\bbut )(?:there (?:is|should be|must be) )?(?:no|not a|without any) (?:other "
     r")?rooms? "
     r"(?:(?:{must} |is |may )*(?:to )?be )?(?:larger|bigger|greater) than (?P<of>(?:the |my |our )?{kind}){end}",
     lambda found: f"{found['begin']}{_the(found['of'])} is the largest room"),
), wall=_WALL)  # fmt: skip


def _the(room: str) -> str:
    return room if room.startswith(("the ", "my ", "our ")) else f"the {room}"


_NEW = (r"(?:(?:comes|lies|is|goes|put|place|there is|there should be|i want|we want|you find) "
        r")*(?:an?|one|the|our|my|"
        rf"two|another) (?:(?!and |with |{KIND})[a-z'-]+ ){{0,3}}?(?P<room>{KIND})\b(?! (?:and|or) )")  # fmt: skip
_JOINT = r"(?:,? (?:and|with|plus|but)|[,;.])+,? ?(?:and |then )?(?:right |directly |just |immediately |straight )?"
_WAYS = {"opposite": "opposite", "across": "opposite", "facing": "opposite", "gegenuber": "opposite", "en": "opposite",
         "enfrente": "opposite", "near": "near", "close": "near", "far": "far from"}  # fmt: skip
"""What a place is in the words of the rules, by the first word for it; others are `next to`."""
_FRONTED = [(late(pattern), late(rf"\b{room}\b")) for pattern, room in (
    # "at the back the kitchen, and beside it a store room"
    (rf"{_JOINT}(?P<by>next to|beside|adjacent to|adjoining|opposite(?: to)?|across from|near(?: to)?|close to|far "
     rf"(?:away )?from|facing) (?:it|that|this|them|that one|this one),? (?P<new>{_NEW})", KIND),
    # "ein Schlafzimmer, gegenüber ein Bad", "une chambre et à côté une salle de bains"
    (rf"(?:,? und|[,;.])+ ?(?:direkt |gleich |unmittelbar )?(?P<by>daneben|gegenuber)(?: davon)? "
     rf"(?P<new>(?:liegt |ist "
     rf"|kommt )?(?:eine?|das|die|der) (?:\w+ )?(?P<room>{DE}))\b", DE),
    (rf"(?:,? et|,? avec|[,;.])+ ?(?:juste |directement |tout )?(?P<by>a cote|en face|tout pres),? "
     rf"(?P<new>(?:il y a |se "
     rf"trouve )?(?:une?|le|la) (?:\w+ )?(?P<room>{FR}))\b", FR),
    (rf"(?:,? y|,? con|[,;.])+ ?(?:justo |directamente )?(?P<by>al lado|enfrente|junto a el(?:la)?),? "
     rf"(?P<new>(?:hay )?(?:"
     rf"una?|el|la) (?P<room>{ES}))\b", ES),
)]  # fmt: skip
_BY_IT = re.compile(r"\b(?:to|beside|from|adjoining|opposite|near|facing) (?:it|th(?:at|is|em)(?: one)?),? "
                    r"(?:[a-z ]{0,16}\b)?"
                    r"(?:an?|one|the|our|my|two|another) |\bdaneben\b|\bgegenuber\b|\ba cote\b|\ben face\b|"
                    r"\btout pres\b|\bal lado\b|\benfrente\b|\bjunto a el")  # fmt: skip
_ENDS = re.compile(r"[.;](?!\d)|$")


_WITH = re.compile(r" (?:with|mit|avec|con) (?:(?:an?|its|own|private|small|large|eine[mnr]?|eigene[mnr]?|kleine[mnr]?|"
                   r"grosse[mnr]?|une?|una?|petite?|grande?|pequen[oa]) )*")  # fmt: skip
"""What stands between a room and one that it has."""


def _whose(text: str, named: list[re.Match[str]]) -> list[str]:
    """The last room, or the one that has it: the living room of `a living room with a balcony, next to it`."""
    has = len(named) > 1 and _WITH.fullmatch(text[named[-2].end() : named[-1].start()])
    return [m.group() for m in (named[:-1] if has else named)][-1:]


def _told_after(text: str) -> str:
    """Such places as clauses of their own behind their sentences: `. the store room is next to the kitchen`."""
    for pattern, room in _FRONTED if _BY_IT.search(text) else ():
        at = 0
        while (found := pattern.compiled.search(text, at) if not pattern.lacked_by(text) else None) is not None:
            at = found.end()
            last = _whose(text, list(room.finditer(text[: found.start()])))
            if not last:
                continue
            way = _WAYS.get(found["by"].split()[0], "next to")
            alike = last[0].split()[-1] == found["room"].split()[-1]
            pair = (last[0], found["room"]) if way == "opposite" else (found["room"], last[0])
            both = f"the two {last[0].split()[-1]}s are {way} each other"
            clause = both if alike else f"the {pair[0]} is {way} the {pair[1]}"
            end = _ENDS.search(text, found.end())
            where = end.start() if end is not None else len(text)
            text = f"{text[:found.start()]}, {found['new']}{text[found.end() : where]}. {clause}{text[where:]}"
    return text


def as_neighbours(text: str) -> str:
    """A folded text with such clauses in the words of the rules."""
    return _told_after(reworded(text, _SAID))
