"""People of whom everybody has a bedroom, or a bathroom, said behind their number in five languages."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.patterns import Late, late

_CHILD = (r"(?:child|kid|son\b|sons\b|daughter|boy|girls?\b(?! friend)|teen|bab|twin|couple|hij|nin[oa]|adolesc|"
          r"enfant|fils|fille|"
          r"garcon|ado|jum|gemel|pareja|kind|sohn|tochter|jung|madchen|zwill|paar|parents|famil)")  # fmt: skip
_THING = (r"(?:[a-z]*(?:room(?!ie|y| ?mate)|bed|bath|zimmer)|habitaci|dormitor|chambre|bano|aseo|salle|suite|"
          r"kitchen|flat(?! ?mate)|"
          r"apartment|level|"
          r"floor|m2|sqm|store|wohnung|piece|raum|raume|stud(?:y|ies)\b|balcon)")  # fmt: skip
_WORDS = {
    "n_": r"(?:[2-6]|two|three|four|five|six|zwei|drei|vier|funf|sechs)",
    "n": r"(?P<n>[2-6]|two|three|four|five|six|zwei|drei|vier|funf|sechs|deux|trois|quatre|cinq|dos|tres|cuatro|"
         r"cinco|seis)",
    "who": rf"(?P<who>(?:(?!{_CHILD}|{_THING}|and |or |y |et |und |in (?=each|every))[a-z-]+ ?){{1,4}}?)",
    "some": r"(?: (?:share|live|rent|need|want|comparten|viven|vivent|partagent|wohnen|teilen)[^.,;:]{0,40})?",
    "each": (r"(?:and )?(?:each(?: one)?(?: of (?:them|us|whom))?|every(?:one|body)|cada un[oa](?: de (?:ellos|"
             r"ellas|nosotros))?"
             r"|chacune?(?: d'(?:eux|elles|entre nous))?|jede[rs]?(?: von (?:ihnen|uns))?)"),
    "has": (r"(?:with|has|have|having|gets?|getting|wants?|needs?|should have|must have|con|tiene|tenga|quiere|"
            r"necesita|avec|"
            r"a|ayant|aura|veut|doit avoir|mit|hat|bekommt|braucht|will|soll)"),
    "own": (r"(?:(?:an?|the|his|her|its|their|our|own|private|separate|single|su|una?|propi[oa]|sa|leur|une|propre|ein|"
            r"eine[mns]?|"
            r"sein|ihr|seine[mn]|ihre[mn]|eigene[mns]?) )*"),
    "room": (r"(?:bed ?room|room|habitacion|dormitorio|cuarto|chambre|(?:schlaf)?zimmer)(?: propi[oa]| individuel(?"
             r":le)?|"
             r" of (?:his|her|their|our) own| haben| bekommen)?"),
    "bath": r"(?:bath ?room|bath|shower room|en[ -]?suite|bano|salle de bains?|salle d'eau|bad|badezimmer)",
    "gap": (r"[,:;.-]+ ?(?P<gap>(?:the (?=kitchen|bath|living|sitting|lounge)|we|wir|nous|ils|elles|they|sie|"
            r"compartimos|comparten|on)\b[^.;:]{5,60}?),? ?(?:but|and|aber|und|mais|et|pero|y|[;.:]) ?"),
    "end": r"(?= ?(?:[.,;:!)]|$)| (?:and|y|et|und|with|plus|mit|avec|con|we|wir|nous) )",
}  # fmt: skip
_COUNT = (
    r"(?:one|an?|eine?n?|une?|una|[1-6]|two|three|four|five|zwei|drei|vier|funf|deux|trois|quatre|cinq|dos|tres|"
    r"cuatro|cinco)"
)
_FAMILY = {
    "count": _COUNT,
    "grown": r"(?:adults?|grown-ups?|parents|erwachsene[rn]?|eltern|adultes?|adultos?|padres)",
    "child": (r"(?:(?:small|little|young|teenage|older|younger|grown|kleine[ns]?|petits?|petites?|pequen[oa]s?) )?"
              r"(?:children|child|kids?|sons?|daughters?|boys?|girls?|teenagers?|kinder|kind|sohne|sohn|tochter|"
              r"jungen?|"
              r"jungs|madchen|enfants?|fils|filles?|garcons?|ados?|hij[oa]s?|nin[oa]s?)\b"),
}  # fmt: skip
_SELF = r"(?:me|myself|us|i|ich|mich|moi|mi|yo)\b"
_BEDROOM = {"zimmer": "schlafzimmer", "rooms": "bedrooms"}
_BEDROOMS = Late(
    r"\b(?P<before>(?:for|para|pour|fur|of|von|de|are|somos|sommes|sind|with|(?:me|myself|us|i|ich|mich|moi|mi|"
    r"yo),? (?:and|&|und|et|y)(?: my| our)?) |^|[.;:] ?){n} "
    r"{who}{some} ?"
    r"(?:{gap}|[,:;.-]+ ?|who |que |qui |(?=(?:and|y|et|und|everyone|everybody|each|both|cada|chacune?|jeder?) "
    r"))(?:y |et |und )?(?:{each} "
    r"(?:{has} )?{own}|(?:want|need|"
    r"have|get) each {own})(?P<size>\d+(?:[.,]\d+)? ?(?:m2|sqm|sq\.? ?m|sq\.? ?ft|sqft) )?{room}"
    r"(?P<bath> (?:and|y|et|und|with|con|avec|mit) {own}{bath}(?: propi[oa])?)?"
    r"(?! and (?:their own |an? )?(?:desk|wardrobe|bed|tv|sofa|armchair|bookcase|table)s?\b){end}", _WORDS)  # fmt: skip
_US = Late(
    r"\b(?:we (?:both|each|all)|(?:each|both|all) of us|wir (?:wollen|brauchen|mochten) (?:beide|jeder|jeweils)|"
    r"nous (?:voulons|avons besoin d'avoir) chacune?|cada un[oa](?: de nosotr[oa]s)?)(?: (?:would like|want|wants|"
    r"need|needs|have|has|"
    r"get|gets|quiere|necesita|tiene|should have|must have))?(?: to have)? {own}(?:notre |nuestro )?(?:propre |"
    r"propio )?"
    r"{bath}(?: propio)?{end}", _WORDS)  # fmt: skip


_KIDS = Late(
    r"\b(?:(?P<adults>{count}) {grown}(?:,|,? and|,? und|,? et|,? y|,? with|,? mit|,? avec|,? con) )?"
    r"(?P<kids>{count} {child}(?:(?:,|,? and|,? und|,? et|,? y) {count} {child})*)(?P<said>,? [^.;:,]{0,25})?"
    r"(?:[.;:,-] ?| (?=(?:and|und|et|y) ))"
    r"(?:and |und |et |y )?(?:each|every|jede[rs]?|chacune?|chaque|cada)"
    r"(?: (?:one|un[oa]|child|kid|kind|enfant|nin[oa]|hij[oa]))?(?: of (?:them|the (?:children|kids)))? ?"
    r"(?:should |must |shall |will |debe )?(?:{has}|be having|tener) {own}{room}{end}", _WORDS | _FAMILY)  # fmt: skip
_COUPLE = re.compile(
    r"\b(?:myself|me|i|us)(?: and|,| &) (?:my )?(?:wife|husband|partner|spouse|girlfriend|boyfriend),? "
    r"(?:(?:also |will |should )?(?:need|want|have|get|take)s? )?(?:one|an?|our)(?: own)?"
    r"(?: (?:main |master |big |large |double )?(?:bed ?)?room\b| (?=with ))")  # fmt: skip
_ROOMS_OF = late(r"\b(zimmer|raume) mit je(?:weils)? (?=\d)")
_AND_I = late(
    r"\b(?:my|meine|mes|mis) (?P<n>two|three|four|zwei|drei|vier|deux|trois|quatre|dos|tres|cuatro|[2-4]) "
    r"(?P<who>[a-z]+) (?:and i|und ich|et moi|y yo)\b(?=,? (?:each|every|jede|chacun|cada))"
)
_OF_US = re.compile(
    r"\b(?:(?:the|all) )?(?P<n>two|three|four|five|six|[2-6]) of us(?=,? (?:share[^.;:]*[:;,.] ?)?(?:and "
    r")?(?:each|every))"
)
_EACH_OF = re.compile(
    r"\b(?:each|every one|all) of us (?P<n>two|three|four|five|[2-5]) (?:girls |boys |friends |people )?(?:wants?|"
    r"needs?|gets?|has|have) "
    r"(?:an?|his|her|their|our)(?: own)? (?:bed ?)?rooms?\b"
)
_AS_MANY = Late(r"\b(?:fur|for|mit|with|of) (?P<n>{n_}) (?!{thing})[a-z]+\b(?P<said>[^.;:,]{0,30}[:,;.-]) "
                r"?(?P<rooms>{n_}) "
                r"(?P<word>zimmer|rooms)\b", _WORDS | {"thing": _THING})  # fmt: skip


def own_rooms(text: str) -> str:
    """A folded text with as many bedrooms as there are such people."""
    text = _OF_US.sub(r"\g<n> people", text)
    text = _AND_I.sub(r"me and \g<n> \g<who>", text)
    text = _US.sub("each bedroom has its own bathroom", text)
    text = _ROOMS_OF.sub(r"\1 von je ", text)
    text = _EACH_OF.sub(r"\g<n> bedrooms", text)
    text = _AS_MANY.sub(_as_many, text)
    told = _KIDS.sub(_family, text)
    if told != text:
        text = _COUPLE.sub("a parents' bedroom ", told)
    return _BEDROOMS.sub(_counted, text)


def _as_many(found: re.Match[str]) -> str:
    """`for three nurses: three rooms`: a bedroom each."""
    same = _number(found["n"]) == _number(found["rooms"])
    return f"{found['said']} {found['rooms']} {_BEDROOM[found['word']]}" if same else found.group()


def _family(found: re.Match[str]) -> str:
    """`two sons and a daughter. Each should have a room`, `two adults and two children, each child has …`."""
    kids = [_number(one) for one in re.findall(rf"\b({_COUNT}) {_FAMILY['child']}", found["kids"])]
    if len(kids) < 2 and not found["adults"]:
        return found.group()
    grown = _number(found["adults"]) if found["adults"] else 0
    ours = f"{grown} relative's rooms and " if grown > 2 else "a parents' bedroom and " if grown else ""
    return f"{ours}{sum(kids)} kids rooms"


def _number(said: str) -> int:
    return int(said) if said.isdigit() else numbers().get(said, 1)


def _counted(found: re.Match[str]) -> str:
    count = _number(found["n"])
    bath = " each with its own bathroom" if found["bath"] else ""
    count += re.match(_SELF, found["before"]) is not None
    before = found["before"] if not re.match(r"\w", found["before"]) else ": "
    gap = f". {found['gap']}" if found["gap"] else ""
    size = f" of {found['size'].strip()} each" if found["size"] else ""
    return f"{before}{count} bedrooms{size}{bath}{gap}"
