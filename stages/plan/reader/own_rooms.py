"""People of whom everybody has a bedroom, or a bathroom, said behind their number in five languages."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.patterns import Late

_CHILD = (r"(?:child|kid|son\b|sons\b|daughter|boy|girls?\b(?! friend)|teen|bab|twin|couple|hij|nin[oa]|adolesc|"
          r"enfant|fils|fille|"
          r"garcon|ado|jum|gemel|pareja|kind|sohn|tochter|jung|madchen|zwill|paar|parents|famil)")  # fmt: skip
_THING = (r"(?:[a-z]*(?:room|bed|bath|zimmer)|habitaci|dormitor|chambre|bano|aseo|salle|suite|kitchen|flat|"
          r"apartment|level|"
          r"floor|m2|sqm|store|wohnung|piece|raum|raume|stud(?:y|ies)\b|balcon)")  # fmt: skip
_WORDS = {
    "n": r"(?P<n>[2-6]|two|three|four|five|six|zwei|drei|vier|funf|sechs|deux|trois|quatre|cinq|dos|tres|cuatro|"
         r"cinco|seis)",
    "who": rf"(?P<who>(?:(?!{_CHILD}|{_THING}|and |or |y |et |und )[a-z-]+ ?){{1,4}}?)",
    "some": r"(?: (?:share|live|rent|need|want|comparten|viven|vivent|partagent|wohnen|teilen)[^.,;:]{0,40})?",
    "each": (r"(?:and )?(?:each(?: one)?(?: of (?:them|us|whom))?|every(?:one|body)|cada un[oa](?: de (?:ellos|"
             r"ellas|nosotros))?"
             r"|chacune?(?: d'(?:eux|elles|entre nous))?|jede[rs]?(?: von (?:ihnen|uns))?)"),
    "has": (r"(?:with|has|have|having|gets?|getting|wants?|needs?|should have|must have|con|tiene|tenga|quiere|"
            r"necesita|avec|"
            r"a|ayant|aura|veut|doit avoir|mit|hat|bekommt|braucht|will|soll)"),
    "own": (r"(?:(?:an?|the|his|her|their|our|own|private|separate|single|su|una?|propi[oa]|sa|leur|une|propre|ein|"
            r"eine[mns]?|"
            r"sein|ihr|seine[mn]|ihre[mn]|eigene[mns]?) )*"),
    "room": (r"(?:bed ?room|room|habitacion|dormitorio|cuarto|chambre|(?:schlaf)?zimmer)(?: propi[oa]| individuel(?"
             r":le)?|"
             r" of (?:his|her|their|our) own| haben| bekommen)?"),
    "bath": r"(?:bath ?room|bath|shower room|en[ -]?suite|bano|salle de bains?|salle d'eau|bad|badezimmer)",
    "end": r"(?= ?(?:[.,;:!)]|$)| (?:and|y|et|und|with|plus) )",
}  # fmt: skip
_BEDROOMS = Late(
    r"\b(?P<before>(?:for|para|pour|fur|of|von|de|are|somos|sommes|sind|with|me and|ich und) |^|[.;:] ?){n} "
    r"{who}{some} ?"
    r"(?:[,:;.-]+ ?|who |que |qui |(?=(?:and|y|et|und) ))(?:y |et |und )?(?:{each} (?:{has} )?{own}|(?:want|need|"
    r"have|get) each {own}){room}"
    r"(?P<bath> (?:and|y|et|und) {own}{bath}(?: propi[oa])?)?{end}", _WORDS)  # fmt: skip
_US = Late(
    r"\b(?:we (?:both|each|all)|(?:each|both|all) of us|wir (?:wollen|brauchen|mochten) (?:beide|jeder|jeweils)|"
    r"nous (?:voulons|avons besoin d'avoir) chacune?|cada un[oa](?: de nosotr[oa]s)?)(?: (?:would like|want|wants|"
    r"need|needs|have|has|"
    r"get|gets|quiere|necesita|tiene|should have|must have))?(?: to have)? {own}(?:notre |nuestro )?(?:propre |"
    r"propio )?"
    r"{bath}(?: propio)?{end}", _WORDS)  # fmt: skip


def own_rooms(text: str) -> str:
    """A folded text with as many bedrooms as there are such people."""
    text = _US.sub("each bedroom has its own bathroom", text)
    return _BEDROOMS.sub(_counted, text)


def _counted(found: re.Match[str]) -> str:
    count = int(found["n"]) if found["n"].isdigit() else numbers().get(found["n"], 6)
    bath = " each with its own bathroom" if found["bath"] else ""
    count += found["before"] in ("me and ", "ich und ")
    before = found["before"] if not re.match(r"\w", found["before"]) else ": "
    return f"{before}{count} bedrooms{bath}"
