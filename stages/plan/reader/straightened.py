"""Clauses that say where doors, neighbours and sizes are in an order that misleads, in one that the rules follow."""

import re

from apartgen.stages.plan.reader.pieces import END, KIND, reworded, rules


def _ranked(found: re.Match[str]) -> str:
    """`the lounge should be the largest, then the kitchen, then the bedroom`: each larger than the next."""
    rooms = [found["first"], *re.findall(r"then (?:the |my |our )?([a-z ]+?)(?= ?(?:[.,;]|$))", found["rest"])]
    rooms = [f"the {room.removeprefix('the ')}" for room in rooms]
    pairs = zip(rooms, rooms[1:], strict=False)
    return f"{rooms[0]} is the largest room. " + ". ".join(f"{a} is larger than {b}" for a, b in pairs)


_TWO = re.compile(r"\b(?:two|2)[ -]bed(?:[ -]?rooms?)?\b|\bboth bed ?rooms\b")


def _of_the_two(found: re.Match[str], verb: str = "") -> str:
    """`two bedrooms; the bathroom must be between them`: between the two bedrooms."""
    return f"{found[1]} {verb}between the two bedrooms" if _TWO.search(found.string) else found.group()


_FACE = {"face": "face", "facing": "facing", "look": "face", "overlook": "face", "looking": "facing",
         "overlooking": "facing", "give": "face", "giving": "facing"}  # fmt: skip
_SAID = rules((
    # "the only way to the kitchen is through the dining room", "the bathroom it must be between them"
    (r"\bthe only (?:way|access|entrance|door|route) (?:in|on)?to ({the}) (?:is|leads|goes|runs) "
     r"(?:through|via|from|across|by) ", r"\1 is reached only from "),
    (r"\b((?:the|my|our) {kind}) it (?=(?:must|should|is|has|will|needs) )", r"\1 "),
    (r"(\b(?:the|my|our|one|an?) {kind} (?:{must} be|is|lies|has to lie|needs to be)) between them{end}", _of_the_two),
    (r"\b(?:put|place|set|with) ((?:the|our|one|an?) {kind}) (?:right |directly )?between them{end}",
     lambda found: _of_the_two(found, "is ")),
    # "a laundry room between kitchen and bathroom"
    (r"(\b(?:an? |one |the )?(?:(?:storage|store|laundry|utility) ?room|pantry|closet)) (?:right |directly |in )?"
     r"between ((?:(?:the|my|our) )?{kind}) and ((?:(?:the|my|our) )?{kind}){end}", r"\1 next to \2 and next to \3"),
    # "the living room should be the biggest, then the kitchen, then the bedroom"
    (r"\b(?P<first>{the}) (?:{must} be|is) the (?:biggest|largest)(?: room| one)?"
     r"(?P<rest>(?:,? (?:and )?then {the}(?= ?[.,;]|$))+)", _ranked),
    # "the bathroom has two doors, one in the bedroom and one in the corridor"
    (r"\b((?:(?:the|my|our) )?{kind}) (?:(?:{must} )?(?:has|have|gets?)|with) two doors?"
     r"[,:;(]? ?(?:the )?one (?:in|on) "
     r"((?:(?:the|our) )?{kind})(?:,|;| and|, and) (?:the )?(?:one|other|another|second)(?: one| door)? {door} "
     r"((?:(?:the|our) )?{kind}){end}", r"\1 has a door to \2 and a door to \3"),
    # "every door from the hallway", "a window on the east side, the living room on the west side"
    (r"\b(?:every|all|each)(?: the)? doors? (?:(?:{must} )?(?:opens?|goes|go|leads?|is|are|be) )?(?:from|{door}) "
     r"(the {hall}){end}", r"every room has its door to \1"),
    (r"(\bwindows? (?:on|to|at|in|facing) (?:the )?(?:{compass})(?: side)?),? ?(?:and |while )?"
     r"((?:(?:the|my|our) )?{kind}) (?:on|to|at|in) (?:the )?({compass})(?: side)?{end}",
     r"\1, \2 has a window to the \3"),
    # "on the side of the entrance", "on the entrance side"
    (r"\b(?:on|at|to|towards) the (?:side of the (?:entrance|front door)|(?:entrance|entry) side){end}",
     "near the entrance"),
    (r"\b(?:on|at) the side (?:away|far|farther|farthest|opposite) from the (?:entrance|front door){end}",
     "far from the entrance"),
    # "the toilet must not be next to the dining room, but it should be near the entrance": the toilet
    (r"\b(?P<of>(?:the|my|our) {kind}) (?P<said>(?:{must} (?:not )?be|(?:is|lies)(?: not)?) (?:{beside}|off) "
     r"(?:the|my|our) {kind}),? (?P<and>but|and) it (?=(?:{must}|is|has)\b)", r"\g<of> \g<said>, \g<and> \g<of> "),
    # "from the bedroom you step into the bathroom", "get from A onto B, and from C as well"
    (r"\b(?:(?:{must} )?(?:be able to )?{go}) from (?P<a>the {kind}) (?:straight |directly |out )*(?:on ?to|in ?to|to) "
     r"(?P<to>the {kind}),? (?:and|but) (?:also )?from (?P<b>the {kind})(?:,? (?:as well|too|also))?{end}",
     r"have a door from \g<a> to \g<to> and a door from \g<b> to \g<to>"),
    (r"\bfrom (?P<a>the {kind}),? (?:you|one|we|i) (?:{must} )?(?:directly |only )?(?:step|walk|pass)(?: straight|"
     r" directly| out)* (?:on ?to|in ?to|to) (?P<to>the {kind})(?= ?(?:[.;]|$)|, (?:guests|visitors|while|but))",
     r"\g<to> is reached from \g<a>"),
    # "face the courtyard on the north side"
    (r"\b(faces?|facing|looks?|looking|overlooks?|overlooking|gives?|giving)(?: out)?(?: on ?to| into| over| on)? "
     r"(?:the |an? )?(?:quiet )?(?:courtyard|garden|street|park|yard|river|sea|lake|road|square|wood|forest) "
     r"(?:on|to|in|at|towards) (?:the )?({compass})(?: side)?{end}",
     lambda found: f"{_FACE.get(found[1], 'faces')} {found[2]}"),
    # "neither bedroom should have a door to the lounge", "nothing but the bathroom between the bedrooms"
    (r"\b((?:neither|no|none of the) (?:bed|bath) ?rooms?) {must} have (?:an?|any) doors? (?:in)?to ",
     r"\1 has a door to "),
    (r"\bnothing (?:but|except|other than) (the {kind}) (?=between)", r"\1 "),
    # "with no corridor longer than 3 m"
    (r"\b(?:no|without (?:any|an?)) (corridors?|hallways?|halls?|passages?) "
     r"(?=(?:longer|wider|narrower|shorter|broader) than)", r"a \1 not "),
    (r"\bno room (?:narrower|less wide) than (\d+(?:\.\d+)? ?(?:m|cm|ft)\b)", r"every room is at least \1 wide"),
    # "kitchen and living room on opposite sides of the hall", "keep the kitchen and the bathroom together"
    (r"\b({the}) and ({the}) (?:are |lie )?on (?:the )?opposite sides of the (?:hall(?:way)?|corridor)\b",
     r"\1 opposite \2"),
    (r"\b(?:keep|put|place) ({the}) and ({the}) (?:together|close together|side by side|next to each other)\b",
     r"\1 is next to \2"),
    (r",? (?:but|and) (?:keep )?the ((?:bed|bath) ?rooms) (?:apart|separate)(?: from (?:each other|one another))?{end}",
     r". the \1 are not next to each other"),
    # "a desk for two in the study", "a bath and a shower in the bathroom"
    (r"\b(desk|sofa|couch|bench|shower|bathtub) for (?:two|three|four|[2-4])(?: people| persons)?"
     r"(?= in |,| and |[.;]|$)", r"\1"),
    (r"\ban? bath(,| and| as well as) (?=(?:an? )?(?:separate |walk-in )?shower in the )",
     r"a bathtub\1 "),
    (r"(\bshower(?:,| and| as well as) an?) bath(?= in the )", r"\1 bathtub"),
    # "one off the hallway and one en suite to the master bedroom", "balcony: yes, off the living room"
    (r"\bone (?P<off>(?:opening |reached |accessible )?(?:off|from) the {hall}),? and (?:one|another|"
     r"the other|a second one) (?P<own>en[ -]?suite to the (?:[a-z]+ )?bed ?room){end}",
     r"one \g<own> and one \g<off>"),
    (r"({kind}) ?: ?yes, (?=(?:directly )?(?:off|facing|on|at|near|next to)\b)", r"\1 "),
    # "kitchen open to the living room and at the back of the flat"
    (r"\b(?P<of>{kind}) (?P<said>open to the {kind}) and (?=(?:at|in|on|near) the (?:very )?(?:back|front|rear|middle|"
     r"cent(?:er|re)|entrance|left|right|{compass})\b)", r"\g<of> \g<said>. the \g<of> is "),
    # "everything opens off the hallway, both bathrooms too, except the dining room"
    (r"\b(?P<all>(?:everything|all (?:the )?(?:other )?rooms|every (?:other )?room)\b[^.;,:]*), (?:even )?"
     r"(?:both|the|all|also) (?:the )?{kind}s?,? (?:too|as well|also|included)(?=[,.;])", r"\g<all>"),
    # "14 m² como mínimo", "6 m² au maximum", "die von der Küche abgeht"
    (r"(\b{amount} ?m2) (?:como|au|a lo) (minimo|maximo|minimum|maximum)\b", r"\1 \2"),
    (r",? (?:die|der|das|welche) (?:direkt )?(?:vom|von der|von dem) ([a-z]+) (?:aus )?ab(?:geht|zweigt)\b",
     r" off the \1"),
    # "阳台：与客厅相连，朝南"
    (r"(阳台|露台)[:,]? ?([与和跟同][^,.;:]{1,4}(?:相连|相通|连通|相接))[,、] ?(朝[东南西北]+)", r"\1\3,\2"),
    # "keine gemeinsame Wand haben", "qui ne partagent pas de mur", "que no compartan pared"
    (r"\bkeine (?:gemeinsame )?wand (?:gemeinsam |miteinander )?(?:haben|teilen)(?: durfen| sollen)?\b",
     "nicht nebeneinander liegen"),
    (r"\bne (?:partagent|doivent) pas (?:partager |avoir )?(?:de|un) mur(?: commun| mitoyen)?\b|\bne se touchent pas\b|"
     r"\bsans mur (?:commun|mitoyen)(?: entre elles)?\b", "ne sont pas cote a cote"),
    (r"\bno (?:compart[ae]n|deben compartir|tengan) (?:ninguna |una )?(?:pared|muro)(?: en comun)?\b",
     "no esten uno al lado del otro"),
    # "dos baños que dan al pasillo y un salón", "Balkon am Schlafzimmer und einem Bad mit Wanne"
    (r"\b(al|a la|desde el|desde la|del|de la|en el|en la|junto al|junto a la) (\w+) y (?=(?:una?|dos|tres|cuatro) "
     r"(?!puerta|al? |en |del? |desde |con |junto |para ))", r"\1 \2, "),
    (r"\b(am|an der|vom|zum|zur|beim|im|neben dem|neben der) (\w+) und (?=(?:eine?[mnr]?|zwei|drei|vier) "
     r"(?!tur|am |an |im |in |vom |von |zum |zur |bei|mit |fur |neben |weiter|ander|zweit))", r"\1 \2, "),
    (r"\b(sur|depuis|par|pres de|contre|attenante? a|a cote de) (le|la|les) (\w+) et (?=(?:une?|deux|trois|quatre) "
     r"(?!porte|sur |au |aux |a |dans |du |de |pour |depuis |avec |autre))",
     r"\1 \2 \3, "),
    # "Küche und Wohnzimmer zusammen 35 m²", "la cocina está junto al comedor"
    (r"\b(?:zusammen|ensemble|a eux deux|juntos|juntas|en conjunto)(?: de)? (?=\d)", "together "),
    (r"(和[^,.;和]{1,4})(?:一共|总共|共|合计|加起来)(?:是|有|要)?(?=\d)", r"\1 together "),
    (r"(\b(?:puerta|abre|abierta?|da) [^.;,]*?) y (el|la) (\w+) (?=(?:esta|debe|tiene|da|mide) )", r"\1. \2 \3 "),
), door="(?:in|in ?to|to|on|on ?to|from|off)", compass="(?:north|south)(?:[ -]?(?:east|west))?|east|west",
   the=rf"(?:(?:the|my|our) )?{KIND}", end=rf"(?:{END}|(?= and | but ))")  # fmt: skip


def straightened(text: str) -> str:
    """A folded text with such clauses in plain order."""
    return reworded(text, _SAID)
