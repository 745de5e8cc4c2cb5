"""Rooms of several people: friends except two who share, each with a room and a desk, twins, a lodger, guests."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.pieces import ELDER, reworded, rules

_WHO = (r"(?:(?:young |university |college |good |close )*(?:friends|students|flatmates|housemates|roommates|"
        r"colleagues|sharers|siblings|brothers|sisters|tenants|lodgers|people|adults|nurses|interns))")  # fmt: skip
_OWN = (r"(?:(?:an?|their|his or her|his|her|own|separate|private|single) )*(?:bed ?)?room")
_THING = r"(?:desk|wardrobe|bookcase|bookshelf|armchair|sofa|tv|chest of drawers|dresser)"
_QUARTERS = r"(?:(?:servants?'?s?|staff|maids?'?s?|nanny'?s|butler'?s|domestic|guests?'?)(?: living)? quarters)"
_GUESTS = re.compile(r"\bguest (?:bed ?)?room|\b(?:one|1|third|second|other|last|smallest) (?:bed ?room )?(?:is )?for "
                     r"(?:the |our |my )?(?:guests?|visitors?)\b")  # fmt: skip


def _one_shared(found: re.Match[str]) -> str:
    """`five friends, each with a room except two who share one`: a room less, and two beds in one."""
    count = numbers().get(found["n"]) or int(found["n"])
    return f"{count - 1} bedrooms, one bedroom has two single beds" if count > 2 else found.group()


def _guests_bath(found: re.Match[str]) -> str:
    """`one is for guests … a second bath for the guests`: that of the guest room, where there is one."""
    known = _GUESTS.search(found.string[: found.start()])
    only = "the second bathroom is reached only from the guest bedroom"
    return f"a second bathroom. {only}" if known else found.group()


def _shared_bath(found: re.Match[str]) -> str:
    """`a bathroom between three bedrooms`, more than one lies between: so many bedrooms, and one that all share."""
    known = found["of"] == "of them" or "between the" in found.group() or "bedroom" in found.string[: found.start()]
    bedrooms = "" if known else f"{found['n']} bedrooms, "
    return f"{bedrooms}one shared bathroom"


_SAID = rules((
    # "five friends, each with their own bedroom except two who share one", "six students with a room each, but not …"
    (r"\b(?:for |of )?(?P<n>three|four|five|six|seven|eight|[3-8]) {who}[,:]? (?:who )?(?:(?:each|all)(?: of them)?,? "
     r"(?:with|has|have|having|gets?|needs?|wants?) {own}|with {own} each),? (?:except|apart from|other than|but not|"
     r"save)(?: for)? (?:the )?(?:two(?: of them)?|twins|couple|two [a-z]+|[a-z]+ (?:and|&) [a-z]+),? (?:who |that "
     r")?(?:share|sharing)"
     r"(?: one| {own}| with each other| together)?(?={end}| and )", _one_shared),
    # "three students, each with own room and desk"
    (r"\b(each(?: one| of them)?) (?:with|having) own (?=(?:bed ?)?room)", r"\1 with their own "),
    (r"\b(each(?: one| of them)? (?:with|having|has) their own (?:bed ?)?room) and (?:their )?(?:own )?(?={thing}\b)",
     r"\1 and a "),
    (r"\b(?P<of>cada un[oa],? con su (?:propi[oa] )?(?:habitacion|dormitorio|cuarto)) y (?:con )?(?:su |una? "
     r")?(?:propi[oa] )?"
     r"(?P<thing>escritorio|armario|mesa de trabajo|estanteria|television)\b",
     r"\g<of>. cada dormitorio tiene un \g<thing>"),
    (r"\b(?P<of>jeder? (?:mit|hat|bekommt) (?:(?:ein|einem|sein|ihr)e?[nms]? )?(?:eigene[nms]? )?(?:schlaf)?zimmer) "
     r"und "
     r"(?:(?:ein|sein|ihr|eigen)\w* )*(?P<thing>schreibtisch|kleiderschrank|schrank|sessel|bucherregal)\b",
     r"\g<of>. jedes schlafzimmer hat einen \g<thing>"),
    (r"\b(?P<of>chacune? (?:avec|a) sa (?:propre )?chambre) et (?:son|un|sa|une) (?:propre )?"
     r"(?P<thing>bureau|armoire|table de travail|bibliotheque)\b",
     lambda found: f"{found['of']}. chaque chambre a une "
     f"{'table de travail' if found['thing'] == 'bureau' else found['thing']}"),
    # "twins who sleep together"
    (r"\b(twins|children|kids|boys|girls|sons|daughters) (?:who|that) (?:sleep|stay|are) "
     r"(?:together|in (?:one|the same|a shared) (?:bed ?)?room)\b", r"\1 who share a room"),
    (r"\bavec des (?:jumeaux|jumelles)(?P<one> qui (?:dorment|sont) (?:ensemble|dans (?:la meme|une) chambre))?\b",
     lambda found: f"avec deux enfants{' qui partagent une chambre' if found['one'] else ''}"),
    (r"\bgemel([oa])s que (?:duermen|estan) (?:junt[oa]s|en (?:la misma|una) habitacion)\b",
     r"dos nin\1s que comparten una habitacion"),
    (r"\bzwillingen?,? die zusammen schlafen\b", "zwei kindern, die sich ein zimmer teilen"),
    # "2 kids, boy and girl not sleep in same room"
    (r"\b(?P<n>two|2) (?:kids?|children),? (?:an? |one )?(?:boy and (?:an? |one )?girl|girl and (?:an? |one )?boy),? "
     r"(?:who |they |and )?(?:(?:do|should|must|can|will|may) ?)?(?:not|n't|no|never) (?:to )?(?:sleep|share|stay|be)s?"
     r"(?: in)?(?: the| an?| one)?(?: same)?(?: bed)? ?(?:room|together)?\b", "2 children who each have a room"),
    # "also my mother live with us she need room close to toilet"
    (r"\b(?P<my>my|our) (?P<who>{elder}) (?:will )?lives? with us,?(?: so| and)? (?:she|he) (?:will )?(?:needs?|"
     r"wants?) "
     r"(?:an? |her |his )?(?:own )?(?:bed ?)?room (?P<where>(?:near|next|close|beside)[^.;,]*)",
     r"\g<my> \g<who> lives with us. the \g<who>'s bedroom is \g<where>"),
    # "I rent a room to a lodger", "a room that we let to a lodger", "two bedrooms, one let to a lodger"
    (r"\b(?:i|we) (?:(?:will|also|would like to|want to|plan to) )*(?:rent|let|sublet)(?: out)? (?:a|one|(?:the|our|"
     r"my) spare) "
     r"(?:bed ?)?room (?:out )?to (?:an? |our |my )?(?P<who>{payer})s?\b", r"a \g<who>'s room"),
    (r"\b(?:an?|one) (?:bed ?)?room,? (?:(?:that|which) )?(?:(?:i|we|is|will be|to be) )*(?:rent|let|sublet|"
     r"rented)(?: out)? to "
     r"(?:an? |our |my )?(?P<who>{payer})s?\b", r"a \g<who>'s room"),
    # "servants' quarters with two bedrooms"
    (r"\b{quarters},? (?:with|of|having|containing|for staff:?) (?={number} bed ?rooms?\b)", ""),
    # "one bathroom between the three bedrooms", "at least two of them bedrooms"
    (r"\b(?P<bath>(?:(?:an?|one|the|single|shared) )+(?:bath ?room|bath|shower room)) (?:shared )?between (?:the |"
     r"all )*"
     r"(?P<n>three|four|five|six|[3-6]) (?P<of>of them|bed ?rooms)\b(?! (?:and|,))", _shared_bath),
    (r"\bat least (?P<n>{number}) of (?:them|which|these|those)(?: rooms)?,? (?:(?:are|being|should be|must be) )?"
     r"(?=(?:bed|bath) ?rooms\b)", r"\g<n> "),
    # "otro baño en el pasillo y una terraza en la cocina"
    (r"\b((?:un|otro|una|otra) {es} (?:en|junto a|accesible desde) (?:el|la|al) {es}),? y (?=una? {es} (?:en|"
     r"junto)\b)", r"\1. "),
    # "one is for guest … a second bath for the guest"
    (r"(?<=[.,;:] )(?:one|1) is for (?:the )?guest(?={end}| and | with )", r"one of them is a guest room"),
    (r"(\bbed ?rooms) one is for (?:the )?guests?\b", r"\1, one of them is a guest room"),
    (r"\b(?:an? |the )?(?:second|2nd|extra|another|additional) (?:bath|bath ?room|shower room|toilet) (?:only |just )?"
     r"for (?:the |our |my )?(?:guests?|visitors?)\b", _guests_bath),
), elder=ELDER, who=_WHO, own=_OWN, thing=_THING, quarters=_QUARTERS,
   payer=r"(?:lodger|tenant|student|subtenant|flatmate)")  # fmt: skip


def of_several_people(text: str) -> str:
    """A folded text with the rooms of such people counted."""
    return reworded(text, _SAID)
