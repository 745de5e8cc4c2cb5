"""Doors, limits and rooms of each as people type them, in five languages, in words that the rules know."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.pieces import ELDER, Words, reworded, rules

_ONE_EACH = (r"(?:each(?: one)?(?: of us)?|both(?: of us)?|every(?:one|body)|cada un[oa](?: de nosotr[oa]s)?|"
             r"chacune?(?: de nous| d'entre nous)?|jede[rs]?(?: von uns)?)")  # fmt: skip
_WANTS = r"(?:needs?|wants?|gets?|has|have|should have|quiere|necesita|tiene|veut|a|aura|braucht|will|mochte|bekommt)"
_OWN = (r"(?:(?:an?|his|her|their|our|su|sa|son|une?|una?|ein(?:en?)?|ihr|sein|own|propi[oa]|propre|eigene[sn]?) )+")
_WITH = (r"(?P<with>,? (?:with|con|avec|mit)\b)?")
_ES_DOOR = r"(?:tener|tenga|tiene|haya)(?: una| ninguna)? puertas?(?: directa)? (?P<to>al?|hacia|con|que de a) ?"


_EVERYBODY = r"(?:(?:each|every) (?:one|person)|each(?: of (?:them|us))?|every(?:one|body))"
_GETS = r"(?:gets?|has|have|needs?|wants?|should have|must have|will have)"
_STANDS = r"(?:(?:esta |queda |va )?(?:frente|enfrente|cerca|lejos|junto|al (?:lado|fondo|norte|sur|este|oeste))\b)"
_TOGETHER = {"zweit": 2, "dritt": 3, "viert": 4, "funft": 5, "sechst": 6}


def _each_of_us(found: re.Match[str]) -> str:
    """`I live with my sister. Each wants her own bedroom with a desk`: a bedroom with a desk for each."""
    said = found["n"]
    count = 2 if not said else 1 + (int(said) if said.isdigit() else numbers()[said])
    return f"{count} bedrooms{' each with' if found['with'] else ''}"


def _sleeping(kind: str) -> Words:
    """Bedrooms of such a kind in English."""
    return lambda found: f"{kind} bedroom{'s' if found['s'] else ''}"


_SAID = rules((
    # "There should be a door between the kitchen and the dining room"
    (r"\bthere (?:should|must|has to|have to|needs? to|ought to|shall|will|could|can|may)(?: also)? be "
     r"(?=(?:an?|one) (?:[a-z]+ )?(?:door|opening|passage|archway)\b)", "there is "),
    # "one bathroom between bedrooms 2 and 3, with a door to each"
    (r"(\bbath ?room[^.;]*?\bbetween [^.;,]*?),? (?:and )?(?:with|having) (?:an? |one |its own )?doors? (?:to|into|"
     r"from) "
     r"(?:each|both)(?: of (?:them|the bed ?rooms)| sides| bed ?rooms?| rooms?| one)?{end}", r"\1"),
    # "at least 15 m2, the other no more than 11"
    (r"({amount}) ?({unit})((?:(?! (?:for|with|door|chair|seat|people|window|table))[^.;\d]){0,45}? "
     r"(?:{least}|{most})) (\d\d(?:[.,]\d+)?|[3-9](?:[.,]\d+)?){end}", r"\1 \2\3 \4 \2"),
    (r"({amount}) ?({unit})(,? (?:and |but |while )?the (?:other|second|third)(?: one| bed ?room| bath ?room)?"
     r"(?: (?:is|of|has|with|should be|must be|about|around|only|just))*) ({amount}){end}", r"\1 \2\3 \4 \2"),
    # "2 bedrooms 14 and 11", beside rooms whose areas have no unit either
    (r"\b({several}|{number}) (bed|bath) ?rooms(?: of)? (\d{1,2})(,? (?:and )?)(\d{1,2})(?= ?(?:[.;]|$|, ))(?! ?,? "
     r"?(?:bath|bed|toilet|wc)[a-z]*s\b)", r"\1 \2rooms of \3 m2\4\5 m2"),
    # "I live with my sister. Each of us wants her own bedroom with a double bed"
    (r"\b(?:i live|vivo|j'habite|je vis|ich (?:wohne|lebe))(?: juntos| zusammen| together)? (?:with|con|avec|mit) "
     r"(?:my|mi|mis|ma|mon|mes|meine[rmn]?)(?: (?P<n>{several}|dos|tres|deux|trois|zwei|drei))? [a-z]+(?: in law)?"
     r"(?: and|,? y|,? et|,? und)?[.;,:]? ?(?:and |y |et |und )?{each} {wants} {own}{bedroom}\b{with_}", _each_of_us),
    # "a flat for four students? Each one gets a bedroom", "two brothers and their father. Everybody has his own"
    (r"\bfor (?P<n>{several}) (?:[a-z-]+ )?{grown}[?.;:,]+ ?(?:and )?{every} {gets} {own}bed ?room\b",
     r"with \g<n> bedrooms"),
    (r"\b(?:we are )?(?P<n>two|three|[23]) (?:[a-z-]+ ){0,2}{grown} and (?:their|our) {elder}"
     r"(?: (?:live|share a (?:flat|home))(?: here)?(?: together)?)?[.;,:] ?(?:and )?{every} {gets} {own}bed ?room\b",
     lambda found: f"a flat with {int(numbers().get(found['n'], found['n'])) + 1} bedrooms"),
    # "The study opens off the living room, everything else as usual"
    (r"[,;.]? ?(?:and |with )?(?:everything else|all else|all the rest|the rest|otherwise)(?: is| stays| being| can be"
     r"| should be)?(?: just)? (?:(?:as )?(?:usual|normal|standard)|the usual|as always){end}", ""),
    # "My grandmother lives with us, so her bedroom has to be near the entrance"
    (r"\b(?P<who>(?:my|our) {elder}) lives with us[,;.]? (?:so |and |hence |therefore )?(?:her|his) "
     r"(?=(?:bed ?)?room\b.*\bour (?:own )?bed ?room\b)", r"\g<who>'s "),
    # "the baby sleeps in ours", "das Zimmer für meine Tochter"
    (r"\b(sleeps?|sleeping|stays?) in (?:ours|our (?:own )?(?:bed ?)?room)\b", r"\1 with us"),
    (r"(?P<us>\b(?:couple|wife|husband|partner|me|i|two of us)\b),? (?:and|with) (?:an?|the|our) "
     r"(?:new |little |small )?(?:baby|newborn|infant)(?: girl| boy)?,? (?:who|that|which) "
     r"(?:still |will |can )?(?:sleeps?|stays?) with us"
     r"(?: in [a-z ]{2,12}bed ?room)?\b", r"\g<us>"),
    (r"\bzimmer (?:fur|von) (?:mein|unser|d)(?:en|em|er|ie|e) (?:kleinen? |grossen? |jungere[nr]? |altere[nr]? )?"
     r"(?:tochter|sohn|baby)\b", "kinderzimmer"),
    # "everything except a balcony: living room, …"
    (r"(^|[.;] ?)(?:(?:i|we) (?:want|need|would like) )?everything (?:except|but|apart from|other than)(?: for)? "
     r"(?:an? |the )?({kind})(?= ?[:;,.])", r"\1no \2"),
    # "make it 4 bedrooms. no wait, 3 is enough"
    (r"\b{number} (bed|bath)( ?)rooms?[.,;!]* (?:(?:no|wait|actually|sorry|hmm|well|on second thoughts?)[, ]+)+"
     r"({number}) (?:is|are|will be|would be) (?:enough|fine|plenty|ok|okay)\b", r"\3 \1\2rooms"),
    # "je veux que la cuisine soit … et que la chambre donne au nord"
    (r",? et que (?=(?:la |le |l'|les ){fr})", ". "),
    (r",? y que (?=(?:el|la|los|las) {es})", ". "),
    (r"(?P<a>\b(?:el|la) {es} {stands}[^.;,]*?), (?=(?:el|la) {es} {stands})", r"\g<a>. "),
    # "一室一厅，45平米左右", "不要三个卧室，两个就够了", "客厅是最大的房间"
    (r"(?<!约)(?<!大概)(?<![\d.])(\d+(?:\.\d+)?) ?(?:平方米|平米|平|㎡|m2)(?:左右|上下)", r"约\1平米"),
    (r"([一二两三四五\d]室[一二两\d]厅),(?=约?\d+(?:\.\d+)?平米)", r"\1,面积"),
    (r"(?:不要|不用|不需要)[一两二三四五\d]([个间])(卧室|房间|卫生间|阳台),?(?:只要|要)?([一两二三四\d])[个间](?:就够了?|就行了?|"
     r"就可以了?|够了|就好)", r"\3\1\2"),
    (r"([^,.;:的]{1,6}?)(?:要|应该|必须)?是(?:家里|家中|全家|整个房子)?(?:面积)?最(大|小)的(?:房间|一间|一个房间|屋子)",
     r"\1最\2"),
    # "la cuisine doit être ouverte sur le séjour et faire au moins 12 m2"
    (r"(?P<s>\b(?:la |le |l'|les ){fr}) (?P<p>(?:doit|devra|doivent) [^.;,]*?) et (?:faire|mesurer|avoir) "
     r"(?=[a-z ]{0,14}\d)", r"\g<s> \g<p>. \g<s> doit faire "),
    (r"(?P<s>\b(?:el|la|los|las) {es}) (?P<p>(?:debe|tiene que|ha de|deberia|deben) [^.;,]*?) y (?:medir|tener|ser de) "
     r"(?=[a-z ]{0,14}\d)", r"\g<s> \g<p>. \g<s> debe medir "),
    # "el baño no debe tener puerta a la cocina", "le bain ne doit pas avoir de porte sur la cuisine"
    (r"(?P<a>\b(?:el|la) {es}) no (?:(?:debe|puede|tiene que|ha de) )?{door}(?P<b>(?:el |la )?{es})\b",
     r"no door between \g<a> and \g<b>"),
    (r"(?P<a>\b(?:el|la) {es}) (?:debe|tiene que|ha de|deberia|que) {door}(?P<b>(?:el |la )?{es})\b",
     r"\g<a> has a door to \g<b>"),
    (r"(?P<a>\b(?:la |le |l'){fr}) ne doit pas avoir (?:de|une) porte (?:vers|sur|dans|donnant sur|avec) (?P<b>(?:la "
     r"|le |l')?{fr})\b",
     r"no door between \g<a> and \g<b>"),
    (r"(?P<a>\b(?:la |le |l'){fr}) doit avoir une porte (?:vers|sur|dans|donnant sur|avec) (?P<b>(?:la |le |"
     r"l')?{fr})\b",
     r"\g<a> has a door to \g<b>"),
    (r"(?P<a>\b(?:das |die |der ){de}) (?:darf|soll|sollte) keine tur (?:zum|zur|in die|ins|in den) (?P<b>{de}) "
     r"haben\b",
     r"no door between \g<a> and the \g<b>"),
    (r"(?P<a>\b(?:das |die |der ){de}) (?:soll|sollte|muss) eine tur (?:zum|zur|in die|ins|in den) (?P<b>{de}) haben\b",
     r"\g<a> has a door to \g<b>"),
    (r"\bsuite parentale (?=avec [^.;,]*?\bsalle (?:de bains?|d'eau)\b)", "chambre parentale "),
    # "un estudio de 9 m²" beside a bedroom is a study
    (r"(\b(?:dormitorios?|habitacion(?:es)?)\b[^.]*?(?:,|\by|\bcon|\bmas)) un (?:pequeno )?estudio\b", r"\1 un "
                                                                                                       r"despacho"),
    (r"\bun estudio (?=y (?:una?|dos|tres|cuatro) (?:dormitorios?|habitacion(?:es)?)\b)", "un despacho "),
    # "Wir sind zu dritt: meine Frau, …", "somos cuatro: mi marido, yo y …"
    (r"\b(?:we are|wir sind|nous sommes|somos) (?:zu (?:zweit|dritt|viert|funft|sechst)|(?:a )?{several}|zwei|drei|"
     r"vier|funf|sechs|"
     r"deux|trois|quatre|cinq|dos|tres|cuatro|cinco|seis)(?: people| persons| personen| personnes| personas)? ?: "
     r"?", ""),
    (r"\bzu (zweit|dritt|viert|funft|sechst)\b", lambda found: f"fur {_TOGETHER[found[1]]} personen"),
    # "living room minimum 20 m2 maximum 25 m2"
    (r"\b({least}|min(?:imum)?) ({amount}) ?({unit}),? ({most}|max(?:imum)?) ({amount}) ?{unit}", r"between \2 and "
                                                                                                  r"\5 \3"),
    # "dos dormitorios dobles y uno individual", "deux chambres doubles et une simple", "zwei Doppelzimmer"
    (r"\b(?:dormitorio|habitacion)(?P<s>(?:e?s)?) (?:dobles?|de matrimonio)\b", _sleeping("double")),
    (r"\b(?:dormitorio|habitacion)(?P<s>(?:e?s)?) (?:individual(?:es)?|sencill[oa]s?)\b", _sleeping("single")),
    (r"(\bdouble bedrooms?,? (?:y|et|und) )(?:(un)[oa]|otr[oa]|(une)|(dos|tres|deux|trois|zwei|drei))(?: mas)? "
     r"(?:individual|sencill[oa]|simple)(?:es|s)?\b", lambda found: f"{found[1]}{found[4] or 'one'} single "
                                                                    f"bedroom{'s' if found[4] else ''}"),
    (r"\bchambre(?P<s>s?) (?:doubles?|pour deux(?: personnes)?)\b", _sleeping("double")),
    (r"\bchambre(?P<s>s?) (?:simples?|individuelles?|pour une personne)\b", _sleeping("single")),
    (r"(\bdouble bedrooms?,? et )(?:une|(deux|trois)) (?:simple|individuelle)s?\b",
     lambda found: f"{found[1]}{found[2] or 'one'} single bedroom{'s' if found[2] else ''}"),
    (r"\b(?P<n>zwei|drei|vier|[2-4]) doppel(?:schlaf)?zimmern?\b", r"\g<n> double bedrooms"),
    (r"\bdoppel(?:schlaf)?zimmer\b", "double bedroom"),
    (r"\b(?P<n>zwei|drei|vier|[2-4]) einzelzimmern?\b", r"\g<n> single bedrooms"), (r"\beinzelzimmer\b", "single "
                                                                                                         "bedroom"),
    # "une chambre pour mes parents et une pour moi", "one for the boys, who share"
    (r"(\bchambre pour [^.;,]{2,30}?),? et une(?: autre)? pour (?=moi\b)", r"\1 et une chambre pour "),
    (r"(\b(?:schlaf)?zimmer fur [^.;,]{2,30}?),? und eine?[sm]?(?: weiteres)? fur (?=mich\b)",
     r"\1 und ein schlafzimmer fur "),
    (r"\b((?:one|another)(?: bed ?room| room)? for (?:the|our|my) (?:two |three )?(?:boys|girls|kids|children|sons|"
     r"daughters)),? "
     r"(?:who|to) (?:will |can |want to )?share(?: (?:it|a room|one))?{end}", r"\1"),
    # "every of us needs own room", "four peoples", "the kitchen is open with the salon", "one big bed"
    (r"\bevery of (us|them|the)\b", r"each of \1"),
    (r"\b(needs?|wants?|gets?|has|have|having) own (?=(?:bed ?|bath ?)?rooms?\b|desk\b)", r"\1 his own "),
    (r"\b(should|must|can|will|shall|does|did) has (?=an?\b|one\b|two\b|three\b|the\b)", r"\1 have "),
    (r"\b(one|an?|the) (?:common|communal) (?=(?:kitchen|living|dining|lounge))", r"\1 "),
    (r"\bchildrens\b(?! (?:bed)?room)", "children"),
    (r"\b(?:one|a|1) (?:big )?bed for (?:two|2)(?: persons?| people)?\b", "one double bed"),
    (r"\b(two|three|four|[2-4]) beds? for (?:the )?(?:children|kids|one person|one|boys|girls|single persons?)\b(?! "
     r"?room)", r"\1 single beds"),
    (r"\b(?:from |between )?(\d+) (?:until|till) (\d+)(?= ?{unit})", r"between \1 and \2"),
    # "2 bedrooms side by side, kitchen away from them"
    (r"(\b(?:two|three|2|3) (bed|bath)( ?)rooms\b[^.;]*?\b(?:far(?: away)?|away|near|close) (?:from|to) )(?:them|"
     r"these|those){end}",
     r"\1the \2\3rooms"),
    # "the child room should be in front of our bedroom"
    (r"\b((?:bed|child|kids?|children's|bath)[' ]?s? ?rooms? (?:should be|must be|is|lies)) in front of (?=(?:the|"
     r"our|my) {room}\b)",
     r"\1 opposite "),
    (r"\bchild(?:ren)? rooms?\b", lambda found: "kids rooms" if found.group().endswith("s") else "kids room"),
    # "Wannenbad", "deux chambres, chacune avec un placard et un bureau", "y tener balcón"
    (r"\b(?:tageslicht)?wannenbad\b", "bad mit badewanne"),
    (r"(\bchambres?\b[^.;]{0,40}?\b(?:avec|ont|a) (?:chacune )?(?:un lit(?: simple| double)?(?:,| et) )?)un "
     r"placard\b", r"\1une armoire"),
    (r"(\bchambres?\b[^.;]{0,40}?\b(?:avec|ont|a) (?:chacune )?une armoire(?:,| et) )un bureau\b", r"\1une table de "
                                                                                                   r"travail"),
    (r"(?P<s>\b(?:el|la) {es}(?: principal)?) (?P<p>(?:debe|tiene que|ha de|deberia) [^.;]*?),? y tener (?=(?:un |"
     r"una |su )?(?:balcon|"
     r"terraza|bano|vestidor|ventana|armario|escritorio|cama))", r"\g<s> \g<p>. \g<s> tiene "),
    (r"(?P<s>\b(?:la |le |l'){fr}(?: principale| parentale)?) (?P<p>(?:doit|devra) [^.;]*?),? et avoir (?=(?:un |une "
     r"|sa |son )?(?:balcon|"
     r"terrasse|salle|dressing|fenetre|armoire|lit|placard))", r"\g<s> \g<p>. \g<s> a "),
    (r"(\b(?:chambre|celle) (?:des|d'|de la|de l'|du) ?(?:enfants?|filles?|garcons?|bebe)\b[^.;]*?)\b(?:la notre|"
     r"notre chambre)\b",
     r"\1la chambre parentale"),
    (r"(\bkinderzimmer\b[^.;]*?)\bunserem(?= (?:liegen|sein)\b|{end})", r"\1dem elternschlafzimmer"),
    (r"(\b(?:cuarto|dormitorio|habitacion) de (?:los ninos|las ninas|l[oa]s hij[oa]s|los "
     r"chicos)\b[^.;]*?)\b(?P<de>de|a)(?:l| la) "
     r"nuestr[oa]\b", r"\1\g<de>l dormitorio principal"), (r"\bpeoples\b", "people"), (r"\bchilds\b", "children"),
    (r"\bboth (bed|bath)( ?)room\b(?!s)", r"both \1\2rooms"),
    (r"\b(facing|overlooking|towards?|looking (?:on)?to) (?=(?:garden|street|road|courtyard|yard|park)\b)", r"\1 the "),
    (r"\bin (?:the )?living(?= ?(?:[.,;]|$)| and )", "in the living room"),
    # "un bureau qui sert aussi de chambre d'amis", "das auch als Gästezimmer dient", "que también sirve de"
    (r",? qui (?:(?:peut |pourra )?(?:servir|sert|servira|fait|faire|serve)(?: aussi| egalement)*(?: office)?) de "
     r"(?=chambre|"
     r"bureau|salle|buanderie)", " also used as "),
    (r",? (?:das|der|die) (?:auch |gleichzeitig |zugleich )*als (?:ein )?(?P<use>[a-z]*(?:zimmer|buro|raum)) "
     r"(?:dient|dienen "
     r"(?:kann|soll)|genutzt (?:wird|werden (?:kann|soll)))\b", r", also used as \g<use>"),
    (r",? que (?:tambien |a la vez )*(?:sirve|sirva|se usa|hace|puede servir|funciona)(?: tambien)? (?:de|como) "
     r"(?:una? )?"
     r"(?=cuarto|habitacion|dormitorio|despacho|oficina|lavadero)", " also used as "),
    # "… on the left, the kitchen on the right, the bath in between", "一个在东边一个在西边"
    (r"(?P<a>(?:the )?{room}) (?P<at>(?:in |on |to |at )?(?:the )?(?:north|south|east|west|left|right|front|back)),? "
     r"(?:and )?"
     r"(?P<b>(?:the )?{room}) (?P<on>(?:in |on |to |at )?(?:the )?(?:north|south|east|west|left|right|front|back)),? "
     r"(?:and )?"
     r"(?:with )?(?P<c>(?:an? |the )?(?:{room}|bath|wc)) (?:is |lies )?in between(?: them)?",
     r"\g<a> \g<at>, \g<b> \g<on>. \g<c> between \g<a> and \g<b>"),
    (r"(一[个间]在[东西南北左右前后][边侧面]?)(?=(?:另外?)?一[个间]在)", r"\1,"),
    (r"\b(?:one|another|a (?:bed ?)?room) (?:that|which|where) (?P<who>(?:the|our|my) [^.,;]{3,25}?) (?:will |can |"
     r"are to )?"
     r"(?:share|sleep in|sleep)(?:,(?= with )|(?= with )|{end})", r"\g<who> share a room"),
    (r"\bwe are (?P<who>students|friends|flatmates|colleagues|cousins|nurses|sisters|brothers|siblings), "
     r"(?P<n>{several})"
     r"(?: people| persons| of us| girls| boys| women| men| guys)?(?=,)", r"we are \g<n> \g<who>"),
    (r"\b(kitchen|living room|dining room|salon|lounge) (is|must be|should be) open with (?=the |salon|living|"
     r"kitchen|dining)",
     r"\1 \2 open to "),
    (r"\b(one|1) (?:big|large|wide|king(?:[ -]size)?|queen(?:[ -]size)?) bed\b(?! ?rooms?)", r"\1 double bed"),
    (r"(\bbeds?,?(?: and| with|,) )(an?|one|two|2) (?:small|little|bedside) tables?\b",
     lambda found: f"{found[1]}{found[2]} nightstand{'s' if found[2] in ('two', '2') else ''}"),
), each=_ONE_EACH, wants=_WANTS, own=_OWN, with_=_WITH, door=_ES_DOOR, every=_EVERYBODY, gets=_GETS, elder=ELDER,
    stands=_STANDS)  # fmt: skip


def simply(text: str) -> str:
    """A folded text with such clauses in plain words."""
    return reworded(text, _SAID)
