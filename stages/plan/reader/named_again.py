"""Rooms named by what was told before, said in full: `besides my own bedroom`, `celle du couple`, `daneben ein Bad`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, SHE, THEY, YOUNG, reworded, rules

_GUEST = (rf"(?:them|him|her|(?:(?:the|my|our|an?|two|three) )?(?:{YOUNG}|{THEY}|{CHILD}|{ELDER}|{SHE}|nephews?|"
          rf"guests?|visitors?|"
          r"friends?)\b)")  # fmt: skip
_SIZED = r"(?:(?:little|small|big|large|second|other|extra|further|more|separate|single|double) )*"
_LEAST = (r"(?:at least|at most|no (?:more|less|larger|smaller|bigger) than|not (?:more|less|larger|smaller|bigger) "
          r"than|between)")  # fmt: skip


def _article(found: re.Match[str]) -> str:
    """`la chambre … celle du fils` with the room named again."""
    return f"{found['before']}la {found['room']} "


_SAID = rules((
    # "besides my own bedroom I need one little room with a bunk bed for them"
    (r"\b(?:besides|apart from|in addition to|as well as|aside from|other than|on top of|next to) (?:my|our) (?:own "
     r")?bed ?room,? "
     r"(?:i|we) (?:(?:also|only|just|would|will|shall) )*(?:need|want|like|have)(?: to have)? (?P<n>an?|one|two|"
     r"three|another) "
     r"(?P<sized>{sized})(?:bed ?)?(?P<room>rooms?)(?= (?:with (?:an?|two|one) [a-z -]*bed|for {guest}))",
     r"a parents' bedroom and \g<n> \g<sized>bed\g<room>"),
    (r"\b(?:neben|ausser|zusatzlich zu|abgesehen von) (?:meinem|unserem) (?:eigenen )?(?:schlaf)?zimmer,? "
     r"(?:brauche?n?|mochte?n?|"
     r"wunsche?n?|will|wollen|hatten? gern) (?:ich|wir)(?: uns| mir)?(?: noch)? (?P<n>eine?|zwei|drei) "
     r"(?P<sized>(?:kleine[ns]?|grosse[ns]?|"
     r"weitere[ns]?) )?(?:schlaf)?zimmer\b", r"a parents' bedroom und \g<n> \g<sized>schlafzimmer"),
    (r"\b(?:en plus de|outre|a part) (?:ma|notre) (?:propre )?chambre,? (?:il (?:me|nous) faut|je (?:veux|voudrais)|"
     r"nous (?:voulons|voudrions)|"
     r"j'ai besoin d'|nous avons besoin d')(?: aussi| encore)? ?(?=(?:une|deux) )", "a parents' bedroom, "),
    (r"\b(?:ademas de|aparte de) (?:mi|nuestro|nuestra) (?:propi[oa] )?(?:dormitorio|habitacion|cuarto),? (?:(?:yo "
     r")?necesit(?:o|amos)|"
     r"qui?er(?:o|emos))(?: tambien)? (?=(?:una?|otr[oa]|dos) )", "a parents' bedroom, "),
    (r"除了(?:(?:我们?)?(?:自己)?的?(?:卧室|房间)| my room )(?:之外|以外|外)?[,、]?(?:我们?)?(?:还|也)?"
     r"(?:需要|想要|要)(?P<n>一个|一间|个|两间|"
     r"两个)?(?P<sized>小|大)?"
     r"(?:房间|卧室)", r" a parents' bedroom, \g<n>\g<sized>卧室"),
    # "the study is accessible from the living room and at least 8 m2"
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:the|my|our) {kind}) (?P<said>(?:{must} be|is|lies|opens|leads) "
     r"[^.;:,\d]*?),? and "
     r"(?:(?:{must} be|is|has|measures) )?(?={least} \d)", r"\g<begin>\g<of> \g<said>. \g<of> is "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:der|die|das) {de}) (?P<said>(?:ist|liegt|soll) [^.;:,\d]*?),? und (?:ist )?"
     r"(?=(?:mindestens|hochstens|maximal|mehr als|weniger als) \d)", r"\g<begin>\g<of> \g<said>. \g<of> ist "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:le|la) {fr}) (?P<said>(?:est|donne|doit) [^.;:,\d]*?),? et (?:fait |mesure |"
     r"doit faire )?"
     r"(?=(?:au moins|au plus|au maximum|plus de|moins de) \d)", r"\g<begin>\g<of> \g<said>. \g<of> fait "),
    (r"(?P<begin>^|[.;:] ?|, )(?P<of>(?:el|la) {es}) (?P<said>(?:es|esta|da|debe) [^.;:,\d]*?),? y (?:mide |tiene |"
     r"de )?"
     r"(?=(?:al menos|como minimo|como maximo|mas de|menos de|minimo|maximo) \d)", r"\g<begin>\g<of> \g<said>. "
                                                                                   r"\g<of> tiene "),
    # "que la cocina dé al norte y el salón al sur"
    (r"\bque (?P<of>(?:el|la) {es}) (?:de|mire|quede mirando|este orientad[oa]) (?:al|hacia el) (?P<side>{side})"
     r"(?P<on>,? y (?:que )?(?:el|la) {es}) (?:al|hacia el) (?P<second>{side})\b",
     r"\g<of> da al \g<side>\g<on> da al \g<second>"),
    (r"\bque (?P<of>(?:el|la) {es}) (?:de|mire|quede mirando|este orientad[oa]) (?:al|hacia el) "
     r"(?=(?:{side})\b)", r"\g<of> da al "),
    # "un trastero que no pase de 3 m²", "der 3 m² nicht überschreitet"
    (r",? que no (?:pase|supere|exceda|sobrepase|rebase|sea (?:mas grande|mayor))n?(?: de| que)?(?: los| las)? "
     r"(?=\d)", " de maximo "),
    (r"\bno debe (?:pasar|sobrepasar|rebasar)(?: de)?(?: los)? (?=\d)", "no debe superar "),
    (r",? qui ne (?:depasse|doit pas depasser|excede)(?: pas)? (?=\d)", " de maximum "),
    (r",? (?:der|die|das) (?P<amount>{amount} ?m2) nicht (?:uberschreitet|ubersteigt|uberschreiten (?:darf|soll))\b",
     r" mit maximal \g<amount>"),
    (r",? (?:der|die|das) nicht (?:mehr als|uber|grosser als) (?P<amount>{amount} ?m2) (?:hat|ist|haben (?:darf|"
     r"soll)|sein (?:darf|soll))\b",
     r" mit maximal \g<amount>"),
    # "celle du couple au fond", "el de la pareja", "das des Paares", "das Zimmer der Tochter"
    (r"\b(?:celle|la chambre) du couple\b", "the parents' bedroom"),
    (r"\b(?:el|la) (?:{bedroom} )?de la pareja\b|\b(?:nuestro|nuestra) {bedroom}(?=,? y (?:el|la) (?:{bedroom} "
     r")?de)", "the parents' bedroom"),
    (r"\bdas (?:(?:schlaf)?zimmer )?des (?:ehe)?paare?s\b", "the parents' bedroom"),
    (r"\bthe couple's(?: (?:bed ?)?room)?(?= (?:at|in|on|near|next|far|facing|is|must|should|"
     r"has)\b)", "the parents' bedroom"),
    (r"\b(?:celle|la chambre) (?:du|de la|de l'|de (?:notre|mon|ma) )(?: ?)(?:fils|fille|bebe|enfant|petit|"
     r"petite)\b(?! (?:aine|cadet))", "the kids room"),
    (r"\b(?:celle|la chambre) (?:du|de la|de (?:ma|mon)) (?:grand-?(?:mere|pere)|mamie|papi)\b", "grandma's room"),
    (r"\b(?:el|la) (?:{bedroom} )?(?:del|de la|de (?:nuestr[oa]|mi)) (?:hij[oa]|nin[oa]|bebe)\b(?! (?:mayor|menor|"
     r"peque))", "the kids room"),
    (r"\b(?:el|la) (?:{bedroom} )?(?:del|de la|de mi) abuel[oa]\b", "grandma's room"),
    (r"\b(?:das|dem) (?:(?:schlaf)?zimmer )?(?:der|des|unsere[rs]|meine[rs]) (?:tochter|sohne?s|kindes|babys|"
     r"kleinen)\b", "dem kinderzimmer"),
    (r"\b(?:das|dem) (?:(?:schlaf)?zimmer )?(?:der|des|meine[rs]) (?:oma|opas?|grossmutter|"
     r"grossvaters)\b", "grandma's room"),
    (r"\b(?P<a>the (?:parents' bedroom|kids room)) y (?P<b>the (?:parents' bedroom|kids room)) (?:bien "
     r")?(?:pegad[oa]s|junt[oa]s|contigu[oa]s)\b",
     r"\g<a> next to \g<b>"),
    (r"\b(?P<before>la (?P<room>chambre|salle de bains|salle d'eau) d[^.;]*?)\bcelle (?=d(?:e|u|es|e la) )", _article),
    # "one bedroom, a bathroom with a shower right beside it", "ein Schlafzimmer, direkt daneben ein Bad"
    (r"\b(?P<room>(?:bath|shower|wash) ?room) (?P<with>with (?:an? )?(?:walk-in |level )?(?:shower|bathtub|tub|"
     r"toilet|window|bidet)) (?:right |directly |just )?"
     r"(?P<by>(?:beside|next to|close to|near|opposite) (?:it|them|that))(?= ?(?:[.,;]|$))",
     r"\g<room> \g<by> \g<with>"),
    (r",? and (?:the|a) usual (?={kind})", ", a "),
    (r"\bright (?=(?:beside|next|opposite|behind|near|outside|by|at) )", ""),
    (r"\b(?P<a>une? (?:\w+ )?(?P<of>{fr})),? (?:et |avec )?(?P<b>une? (?:\w+ )?{fr}) (?:juste |directement |tout "
     r")?a cote(?= ?(?:[.,;]|$))",
     r"\g<a>, \g<b> a cote de la \g<of>"),
    (r"\b(?P<a>una? (?P<of>{es})),? (?:y |con )?(?P<b>una? {es}) (?:justo |directamente |pegado )?al lado(?= "
     r"?(?:[.,;]|$))",
     r"\g<a>, \g<b> junto al \g<of>"),
    # "les enfants partagent une chambre à côté", "das Kinderzimmer ist daneben", "the kids' room is next door"
    (r"\b(?<!toilettes )(?<!cote )(?:(?:juste|tout) )?a cote{end}", "next to it"),
    (r"\b(?:(?:direkt|gleich) )?daneben{end}", "next to it"), (r"\b(?:justo )?al lado{end}", "next to it"),
    (r"\b(?:right )?next door{end}", "next to it"),
), guest=_GUEST,
   sized=_SIZED,
   side="norte|sur|este|oeste|noreste|noroeste|sureste|suroeste", least=_LEAST)  # fmt: skip


_OURS = late(r"\b(?:my|our) (?:own )?bed ?room\b")


def named_again(text: str) -> str:
    """A folded text with such rooms named."""
    told = reworded(text, _SAID)
    beside = told != text and "a parents' bedroom and " in told and "a parents' bedroom and " not in text
    return _OURS.sub("the parents' bedroom", told) if beside else told
