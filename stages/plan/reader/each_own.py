"""People of whom each has a room of his own, and rooms of theirs that are alike: as so many rooms of such people."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.families import COUNTED
from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import GROWN, SEVERAL, YOUNG, reworded, rules

_N = (r"(?:[2-8]|two|three|four|five|six|seven|eight|zwei|drei|vier|funf|sechs|deux|trois|quatre|cinq|dos|tres|cuatro|"
      r"cinco|seis)")  # fmt: skip
_ZH = {"三": 3, "四": 4, "五": 5, "六": 6}
_EACH = (r"(?:everyone|everybody|each(?: one)?(?: of us)?|all of us|(?:each|every) (?:one|person|child|kid|(?:family "
         r")?member)|we all|jede[rs]?(?: von uns| einzelne)?|chacune?(?: d'entre nous)?|tout le monde|cada un[oa](?: "
         r"de nosotros)?|cada (?:persona|miembro))")  # fmt: skip
_HAS = (r"(?:(?:should|must|will|would|is to|has to|wants?|needs?|like|likes?|gets?|has|have|having|with|to have|in|"
        r"hat|braucht|bekommt|will|mochte|soll|a|veut|aura|doit avoir|tiene|quiere|necesita|tendra|debe tener) )*")
_OWN = (r"(?:(?:an?|one|his|her|his or her|their|our|its|own|separate|private|single|individual|eine?[nms]?|sein|ihr|"
        r"seine?[nms]?|eigene?[nms]?|sa|son|leur|une?|propre|su|una?|propi[oa]) )+")  # fmt: skip
_ROOM = (r"(?:bed ?rooms?|rooms?|(?:schlaf)?zimmer|chambre|habitacion|dormitorio|cuarto)(?: of (?:his|her|their|our|"
         r"its) own| to (?:him|her|them)sel(?:f|ves)| propi[oa]| haben| bekommen| individuelle)?")  # fmt: skip
_CLAUSE = rf"{_EACH} {_HAS}{_OWN}{_ROOM}(?![a-z'])"
_JOINT = r"(?:[,;:.-]|\b(?:and|where|in which|so that|und|wobei|et|ou|y|donde|who)\b| )*"
_FAMILY = (rf"(?P<lead>\b(?:we are|we're|wir sind|nous sommes|somos) |\b(?:for|fur|pour|para) )?\b(?:(?:an?|the|our|"
           rf"eine?|une|una) )?(?:famil(?:y|ie|le|ia) (?:of|with|von|mit|de|a) (?P<n>{_N})(?: personen| personnes| "
           rf"personas| people| members)?"
           r"(?! (?:kids|children|kinder|enfants|hijos|ninos|sons|daughters))|(?P<m>drei|vier|funf|sechs)kopfige[nr]? "
           rf"familie|(?P<k>{_N})[- ](?:person|member) family)\b")  # fmt: skip
_OF_FAMILY = Late(rf"{_FAMILY}(?P<gap>[^.;:]{{0,60}}?(?:[.;:] ?)?){_JOINT}{_CLAUSE}")
_OF_CHINESE = Late(r"一?家(?P<zh>[三四五六])口人?[,.;]?(?:每个?人|人人|大家)(?:都)?(?:要|有|住|需要|想要|"
                   r"能)*(?:一?[间个])?(?:自己|独立|单独)?的?(?:一?[间个])?(?:房间|卧室)")  # fmt: skip
_LIKE = (r"(?:(?:of |about |roughly |exactly )*(?:the )?(?:same|equal|equally|identical|alike|similar)\b|equal in |as "
         r"(?:large|big) as )")  # fmt: skip


def _family(found: re.Match[str]) -> str:
    """`a family of five and everyone has their own room`: one of the parents', and one of each child."""
    said = found.groupdict()
    if said.get("zh"):
        return f"一间主卧,{'零一两三四'[_ZH[said['zh']] - 2]}间儿童房"
    number = said["n"] or said["m"] or said["k"]
    children = (int(number) if number.isdigit() else numbers()[number]) - 2
    lead = "with " if (said["lead"] or "").strip() in ("for", "fur", "pour", "para") else ""
    kids = "" if children < 1 else " and a kids room" if children == 1 else f" and {children} kids rooms"
    return f"{lead}a parents' bedroom{kids}{said['gap'].rstrip()}"


def _theirs(found: re.Match[str]) -> str:
    """`three roommates, their bedrooms of the same size`: three bedrooms, and all of them."""
    known = COUNTED.search(found.string)
    n = found["n"]
    rooms = "" if known else f"{n} bedrooms. "
    return f"{found['who'] if known else ''}{found['gap'] if known else ''}{rooms}the bedrooms {found['be'] or ''}"


_SAID = rules((
    # "one room per person", "nobody shares a room", "all of us want a separate bedroom"
    (r"\b(?:nobody|no one|none of (?:us|them)|no two (?:people|of us)) (?:(?:wants?|has|have|should|must|needs?) "
     r"(?:to )?)?shares? ?(?:an?|the)?(?: same)?(?: (?:bed ?)?rooms?)?(?={end})", "everyone has their own room"),
    (r"(?P<people>\b{n} (?:{grown}|students|sharers),? )(?:with |and )?(?:an?|one) (?:own )?(?:bed ?)?room (?:for "
     r")?each(?={end})(?!,? (?:except|but|apart|save))",
     r"\g<people>everyone has their own room"),
    (r"\b(?:an?|one) (?:own |separate |private |single )?(?:bed ?)?room (?:per|for (?:each|every)) (?:person|head|"
     r"adult|resident|member|one of (?:us|them)|of (?:us|them))(?={end})", "everyone has their own room"),
    (r"\b(?:all|every one) of (?:us|them) (?:want|need|should have|get|have|would like)s? (?:an? |our |their )?(?:own "
     r"|separate |private |single )+(?:bed ?)?rooms?\b", "everyone has their own room"),
    (r"\b(?:we are|we're|there are) (?P<n>{n}) people,? (?:and )?(?=everyone has)", r"\g<n> people, "),
    (r"\b(?:ein|je ein) (?:eigenes )?(?:schlaf)?zimmer pro person\b", "jeder hat ein eigenes zimmer"),
    (r"\bune chambre (?:par|pour chaque) personne\b", "chacun a sa chambre"),
    (r"\buna habitacion (?:por|para cada) persona\b", "cada uno tiene su habitacion"),
    (r"\bsomos (?P<n>{n}),? y (?=cada un[oa])", r"para \g<n> personas, "),
    (r"\b(?:wg|wohngemeinschaft) (?:mit|fur|von) (?P<n>{n}) (?:leuten|menschen|personen)\b", r"fur \g<n> personen"),
    # "three roommates, their bedrooms should be of the same size"
    (r"(?P<who>\b(?:(?:two|both) )?(?P<n>{several}) (?:(?:young|good|close|female|male) )*(?:{grown}|students|"
     r"sharers))(?P<gap>[^.;:]{0,50}?(?:[.;:,] ?| )(?:and |where |so )?)(?:their|the|all|all (?:the|their)) (?:\w+ "
     r")?(?:bed ?)?rooms (?P<be>(?:(?:{must}|are|is|being|have|be|all|both|to) )*)(?={like})", _theirs),
    (r"(?P<who>\b(?P<n>{several}) (?:(?:young|good|close) )*(?:{grown}|students|sharers))(?P<gap>[^.;:]{0,30}? |[,;:] "
     r")(?:(?:need|needs|want|with|have|having|get|who|each|all|both) )+(?P<be>)(?:equal(?:ly|-| )?(?: ?(?:sized?|"
     r"large|big))|same[- ]sized?|identical|equal) (?:bed ?)?rooms\b", lambda found: f"{_theirs(found)}are of the "
                                                                                     f"same size"),
    (r"\b(?P<n>zwei|drei|vier|funf) (?:mitbewohner(?:innen)?|freunde|studenten|studierende|"
     r"leute)(?P<gap>[^.;:]{0,30}?[.,;:] ?)(?:ihre|die|alle) (?:schlaf)?zimmer (?=(?:sollen |mussen |sind )?(?:alle "
     r")?gleich)",
     r"\g<n> schlafzimmer. die schlafzimmer "),
    (r"\b(?P<n>deux|trois|quatre|cinq) (?:colocataires|amis|amies|etudiants|etudiantes)(?P<gap>[^.;:]{0,30}?[.,;:] "
     r"?)(?:leurs|les|toutes les) chambres (?=(?:doivent |sont |etre )*(?:toutes )?(?:de (?:la )?(?:meme )?taille|"
     r"egales|aussi|identiques|de meme))", r"\g<n> chambres. les chambres "),
    (r"\b(?P<n>dos|tres|cuatro|cinco) (?:companer[oa]s(?: de piso)?|amig[oa]s|estudiantes)(?P<gap>[^.;:]{0,30}?[.,;:] "
     r"?)(?:sus|los|las|todas las|todos los) (?P<rooms>dormitorios|habitaciones) (?=(?:deben |son |ser |tienen que |"
     r"sean )*(?:del? |iguales|igual de|identic))", r"\g<n> \g<rooms>. los \g<rooms> "),
    (r"(?P<n>[两三四五])[个位名](?:室友|朋友|学生|同学|合租者)[,.;](?:他们|她们|大家)?的?(?:卧室|房间)",
     r"\g<n>间卧室,卧室"),
    (r"\b(?P<n>{several}) (?:{grown}|students|sharers),? (?:who |where )?(?:each|every)(?: one)?(?: of (?:them|us))? "
     r"(?:should have|must have|wants?|needs?|gets?|has|have) (?:an?|their own|his own|her own) (?:bed ?)?rooms? "
     r"(?=of (?:the )?(?:same|equal)\b)", r"\g<n> bedrooms "),
    # "two kids and us, the kids have a room each"
    (r"\b(?P<n>{several}) (?:kids|children)(?P<us> and (?:us|we|the parents|their parents|me and my [a-z]+)),? (?:and "
     r"|where )?(?:the|our) (?:kids|children) (?:have|get|need|want|should have) (?:(?:an?|one) (?:bed ?)?room each|"
     r"their own (?:bed ?)?rooms?)", r"a parents' bedroom and \g<n> kids rooms"),
    # "a room for each of our two kids", "dos habitaciones de niños"
    (r"\b(?:an?|one|own) (?:own |separate )?(?:bed ?)?room (?:for|to) each of (?P<whose>the|our|my) (?P<n>{several}) "
     r"{young}\b(?!')", r"\g<whose> \g<n> kids rooms"),
    (r"\b(?P<n>dos|tres|cuatro|[2-4]) (?:habitaciones|dormitorios|cuartos) (?:infantiles|(?:de|para) (?:l[oa]s "
     r")?(?:nin[oa]s|hij[oa]s))\b", r"\g<n> kids rooms"),
), n=_N, several=SEVERAL, young=YOUNG, grown=GROWN, like=_LIKE)  # fmt: skip


def each_own(text: str) -> str:
    """A folded text with such rooms counted."""
    text = reworded(text, _SAID)
    return text if COUNTED.search(text) else _OF_FAMILY.sub(_family, _OF_CHINESE.sub(_family, text))
