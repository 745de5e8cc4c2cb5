"""Clauses of German, French, Spanish and Chinese homes: ways in, ends of halls, ours beside theirs, second uses."""

import re

from apartgen.stages.plan.reader.pieces import HALL, reworded, rules


def _each_door(found: re.Match[str]) -> str:
    """Of each of several rooms that it has a door to another."""
    rooms = re.split(r", | y ", found["all"])
    return ". ".join(f"{room} tiene puerta {found['to']}" for room in rooms)


_TWO_USES = (
    # "ein Arbeitszimmer, das man auch als Gästezimmer nutzen kann"
    (r"\b(?P<of>{de}),? (?:das|die|der|welches) (?:man |wir |ich |sich )?(?:auch |zugleich |gleichzeitig )*als "
     r"(?P<use>{de}) (?:genutzt|verwendet|nutzen|benutzen|dient|dienen|nutzbar)(?: werden)?"
     r"(?: kann| konnen| soll| lasst| ist)?\b",
     r"\g<of> which also serves as \g<use>"),
    (r"\b(?P<of>{fr}) qui (?:(?:peut|pourra|doit|puisse) )?(?:aussi |egalement )?(?:servir|sert|servira|faire office) "
     r"(?:aussi )?de (?P<use>{fr})",
     r"\g<of> which also serves as \g<use>"),
    (r"\b(?P<of>{es}) que (?:tambien )?(?:sirva|sirve|pueda servir|puede servir|se pueda usar) "
     r"(?:tambien )?(?:de|como) (?P<use>{es})", r"\g<of> which also serves as \g<use>"),
)
_WAYS = (
    # "soll 10 m² haben und einen Zugang zum Balkon", "alle Zimmer vom Flur aus erreichbar", "hinter dem Wohnzimmer"
    (r"\b(?P<of>(?:die|das|der) {de}) (?P<be>soll|sollte|muss) (?P<said>[^.;]*?) haben und "
     r"(?:einen )?(?:direkten )?zugang (?=zu[mr] )", r"\g<of> \g<be> \g<said> haben. \g<of> hat zugang "),
    (r"\balle (?P<of>zimmer|raume) (?:sind |sollen |mussen )?(?:direkt )?"
     r"(?P<by>vom flur|von der diele|vom gang)(?: aus)? "
     r"(?:erreichbar|zuganglich|begehbar|betretbar|zu erreichen|zu betreten)(?: sein)?\b",
     r"\g<by> aus kommt man in alle \g<of>"),
    (r"\bhinter (?:dem|der|den) (?={de})", "neben dem "),
    # "on entre directement dans le salon", "se entra directamente al salón", "man kommt direkt ins Wohnzimmer"
    (r"\b(?:on entre|on arrive|vous entrez|l'entree (?:donne|se fait)) directement (?:dans|sur) le (?:salon|sejour)\b",
     "you enter directly into the living room"),
    (r"\bse (?:entra|accede|llega) directamente (?:al|en el) (?:salon|comedor)\b",
     "you enter directly into the living room"),
    (r"\b(?:man|wir) (?:kommt|tritt|kommen|gelangt|betritt) (?:direkt|gleich|unmittelbar) (?:ins|in das|das) "
     r"(?:wohnzimmer|wohnbereich)\b", "you enter directly into the living room"),
    (r"(?:进门|入户)(?:就|直接)?是客厅", "you enter directly into the living room"),
    # "a long hallway and a bathroom at the far end of it", "at the end of the hall"
    (r"(?P<hall>\b{hall}),? (?:and |with )(?P<of>an? (?:[a-z]+ )?(?P<room>{kind})) at the "
     r"(?:far |very |other )?end of it\b", r"\g<hall> and \g<of>. the \g<room> is at the far end"),
    (r"\bat the (?:far |very )?end of the {hall}", "at the far end"),
    (r"\bam ende de[sr] (?:flure?s|gange?s|korridors|diele)\b", "hinten"),
    (r"\bau (?:bout|fond) du couloir\b", "au fond"),
    (r"\bal (?:final|fondo) del pasillo\b", "al fondo"),
    (r"在?走廊(?:的)?尽头", "远离入口"),
    # "el dormitorio, el baño y la cocina tengan puerta al salón", "una terraza a la que se sale desde el salón"
    (r"(?P<all>(?:(?:el|la) {es}, )*(?:el|la) {es} y (?:el|la) {es}) (?:tienen|tengan|deben tener|con) (?:una )?puerta "
     r"(?P<to>(?:al|a la|con el|con la) {es})", _each_door),
    (r"\btenga(?=n? (?:una )?puerta\b)", "tiene"),
    (r"(?P<of>\b(?:balcon|terraza)) (?:a la|al|a el) que se (?:sale|accede|llega|salga|acceda)"
     r"(?=(?: directamente)? (?:desde|por) )", r"\g<of> con salida"),
    # "je travaille à la maison", "trabajo en casa", "une seule chambre"
    (r"\b(?P<work>travaill\w+|teletravail\w*) (?:a la maison|depuis la maison)\b", r"\g<work>"),
    (r"\b(?P<work>trabaj\w+|teletrabaj\w+) (?:en|desde) casa\b", r"\g<work>"),
    (r"\b(?P<one>une?) seule? (?=(?:grande? |petite? )?{fr})", r"\g<one> "),
    (r"(?P<far>\b(?:loin|pres|a cote) d(?:u |e la |e l'){fr}),? et (?=une? {fr})", r"\g<far>. "),
    # "el baño lo compartimos", "compartimos dos baños", "一个独立的厕所", "ein Bad für die Eltern, eins für die Kinder"
    (r"(\bel {es}) lo compartimos(?: tod[oa]s| l[oa]s dos| entre (?:tod[oa]s|l[oa]s dos))?(?:{end}|(?= y ))", r"\1"),
    (r"\bcompartimos\b", "comparten"),
    (r"\b(?:ein |eigenes )?bad(?:ezimmer)? fur (?:die )?eltern(?:,|,? und) eine?s? fur (?:die )?kinder\b",
     "zwei bader"),
    (r"\b(?:une )?salle de bains? pour les parents(?:,|,? et) une(?: autre)? pour les enfants\b",
     "deux salles de bain"),
    (r"\b(?:un )?bano para los padres(?:,|,? y) (?:otro|uno) para los (?:ninos|hijos)\b", "dos banos"),
    (r"(?<=[,另外还要有一个])(?:独立|单独)的?厕所", "客卫"),
)
_OURS = (
    # "neben unserem Schlafzimmer, das Gästezimmer möglichst weit weg davon", "à côté de la nôtre"
    (r"\b(?P<by>neben|bei|nahe|nahe bei|weit weg von|weit von) (?:unserem|meinem) schlafzimmer\b(?! (?:brauche|hatte))",
     r"\g<by> dem elternschlafzimmer"),
    (r"\b(?:moglichst |so )?weit (?:weg|entfernt) davon\b(?: wie moglich)?", "weit entfernt vom elternschlafzimmer"),
    (r"\ba cote de la notre\b", "a cote de la chambre des parents"),
    (r"\bloin de la notre\b", "loin de la chambre des parents"),
    (r"\b(?:al lado|cerca|lejos) del nuestro\b",
     lambda found: f"{found.group().removesuffix('nuestro')}dormitorio principal"),
    (r"\by el de (?:los )?invitados (?=al|cerca|lejos|en|junto|esta)", ". la habitacion de invitados "),
)
_SAID = rules((*_TWO_USES, *_WAYS, *_OURS), hall=HALL)


def everywhere(text: str) -> str:
    """A folded text with such sentences in words that the rules know."""
    return reworded(text, _SAID)
