"""Where a room is and where it is not, and its one door or way, said in one clause: each as a clause of its own."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules


def _but(found: re.Match[str]) -> str:
    """`soll nicht an die Küche grenzen, sondern an das Bad`: the verb of the first once more."""
    of, verb, but = found["of"], found["verb"], found["but"]
    last = found["no"].split()[-1]
    again = f" {last}" if last in ("grenzen", "liegen", "sein", "gehen", "fuhren", "ab") else ""
    return f"{of} {verb} nicht {found['no']}. {of} {verb} {but}{again}"


def _through(found: re.Match[str]) -> str:
    """`a closet between the bedroom and the en suite, which one walks through`: one behind the other."""
    behind = re.sub(r"^(?:the |an? )?en[ -]?suite(?: bath ?room)?$", "a bathroom", found["behind"])
    room = re.sub(r"^(?:an?|the|one|my|our) ", "the ", found["room"])
    return f"{found['room']} off {found['first']}, {behind} off {room}"


_SAID = rules((
    # "has only one door, to the living room", "hat nur eine Tür, zum Wohnzimmer"
    (r"\b(?P<of>(?:the|my|our) {kind}) (?:{must} )?(?:has|have) (?:only|just) one door,? (?:(?:which|that|and it|it) )?"
     r"(?:leads? |leading |goes |opens |is )?(?:to|into|onto) (?P<to>(?:the )?{kind}){end}",
     r"\g<of> has at most one door. \g<of> is reached only from \g<to>"),
    (r"\b(?P<of>(?:das|die|der) {de}) hat nur eine(?: einzige)? tur,? (?:(?:und )?zwar |(?:und )?die )?(?:fuhrt |"
     r"geht )?"
     r"(?:zu[mr]|ins?(?: das| die| den)?) (?P<to>{de})(?: fuhrt| geht)?\b",
     r"\g<of> hat hochstens 1 turen. \g<of> is reached only from \g<to>"),
    (r"\b(?P<of>(?:le|la) {fr}) n'a qu'une(?: seule)? porte,? (?:qui )?(?:donne |mene )?(?:vers|sur|dans|donnant sur) "
     r"(?P<to>(?:le |la |l'){fr})\b", r"\g<of> a au plus 1 portes. \g<of> is reached only from \g<to>"),
    (r"\b(?P<of>(?:el|la) {es}) (?:tiene|tenga) (?:solo una|una sola|una unica) puerta,? (?:que )?(?:da |lleva "
     r")?(?:al?|hacia(?: el)?) "
     r"(?P<to>(?:la )?{es})\b", r"\g<of> tiene como maximo 1 puertas. \g<of> is reached only from \g<to>"),
    # "a walk-in closet between the bedroom and the en suite, so that one walks through it"
    (r"\b(?P<room>(?:an?|the|one|my|our) (?:walk-in )?(?:closet|wardrobe|dressing room|dressing area)) (?:is |lies |"
     r"located |set )?between "
     r"(?P<first>(?:(?:the|my|our|her|his|their|an?) )?(?:{kind}|parents' bedroom|bedroom)) and "
     r"(?P<behind>(?:(?:the|an?|her|his|its|our) )?"
     r"(?:{kind}|en[ -]?suite(?: bath ?room)?)),? "
     r"(?:so(?: that)? |and |which |that |where )?(?:one|you|we|i|she|he|they)? ?(?:can |has to |have to |must )?"
     r"(?:walks?|goe?s?|pass(?:es)?) through(?: it)?{end}", _through),
    # "to the bedroom one goes through living room"
    (r"(?P<begin>^|[.;:,] ?)(?:and |but )?(?:in)?to (?P<of>(?:the |my |our )?{kind}) (?:one|you|we|i|people) (?:can "
     r"|should |must )?"
     r"(?:go|come|get|walk|pass)(?:e?s)? (?:only )?(?:through|via|from|by way of) (?P<by>(?:the )?{kind}){end}",
     lambda found: f". {_the(found['of'])} is reached from {_the(found['by'])}"),
    (r"\bfrom (?:the )?(?P<by>{hall}) (?:are going|go|lead|are leading) doors (?=to )", r"from the \g<by> doors lead "),
    # "nicht an die Küche grenzen, sondern an das Bad", "ne donne pas sur le couloir mais sur le salon"
    (r"\b(?P<of>(?:der|die|das|unsere?|meine?) {de}) (?P<verb>soll|sollte|darf|muss|ist|liegt|grenzt|geht) nicht "
     r"(?P<no>[^.;,]*?\w),? "
     r"sondern (?P<but>[^.;,]*\w)", _but),
    (r"\b(?P<of>(?:le|la) {fr}) (?:ne )?(?:donne|ouvre|doit) pas (?:donner |ouvrir )?sur (?:le|la|l') ?{fr},? mais "
     r"(?:plutot )?sur "
     r"(?P<to>(?:le |la |l'){fr})\b", r"\g<of> is reached only from \g<to>"),
    (r"\b(?P<of>(?:el|la) {es}) no (?P<verb>da|debe dar|abre) (?:al|a la) {es},? sino (?:al|a la) (?P<to>{es})\b",
     r"\g<of> is reached only from \g<to>"),
    # "the storage plus a bedroom and a bath both off the living room"
    (r",? plus (?P<two>(?:an?|one|the) {kind} and (?:an?|one|the) (?:{kind}|bath)) both (?=(?:off|next to|beside|"
     r"near|opposite|facing|at|in|"
     r"on) )", r". \g<two> "),
    # "the twins …, the parents' bedroom has to be far from them"
    (r"(?P<kids>\b(?:the|our|two|my|three) (?:[a-z]+ )?(?P<who>twins|kids|children|boys|girls|sons|"
     r"daughters)\b[^.]*?(?:share|together)[^.]*?)"
     r"(?P<us>\b(?:(?:the )?parents' (?:bed ?)?room|our (?:own )?bed ?room) (?:{must}|has to) (?:not )?be (?:not "
     r")?(?:far(?: away)? from|away "
     r"from|next to|near|close to|beside|opposite)) them{end}", r"\g<kids>\g<us> the kids room"),
))  # fmt: skip


def _the(room: str) -> str:
    return room if room.startswith(("the ", "my ", "our ")) else f"the {room}"


def instead_of(text: str) -> str:
    """A folded text with such clauses apart."""
    return reworded(text, _SAID)
