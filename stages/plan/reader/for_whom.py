"""For whom each bedroom is, and who shares a home, as rooms: `ein Schlafzimmer für uns, eins für Oma`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded, rules

_DE = {"wir": "uns|mich|die eltern|eltern|meine frau und mich|meinen mann und mich",
       "kind": "(?:die |unsere |meine |den |unseren |meinen |das )?(?:zwei |beiden |drei |[2-4] )?(?:kindern?|jungs|"
               "jungen|madchen|tochter|sohn|sohne|baby|zwillinge)",
       "oma": "(?:die |unsere |meine |den |unseren |meinen )?(?:oma|opa|grossmutter|grossvater|grosseltern|mutter|"
              "vater|schwiegermutter|schwiegervater|schwiegereltern)",
       "gast": "(?:die |unsere )?(?:gaste|besucher|besuch)"}  # fmt: skip
_FR = {"wir": "nous|moi|les parents|ma femme et moi|mon mari et moi",
       "kind": "(?:les |nos |mes |le |la |notre |mon |ma |l')?(?:deux |trois )?(?:enfants?|garcons?|filles?|fils|"
               "bebe|jumeaux)",
       "oma": "(?:la |le |ma |mon |les |nos |notre )?(?:grand-?mere|grand-?pere|grands-parents|mere|pere|mamie|papi|"
              "belle-mere|beau-pere|beaux-parents)",
       "gast": "(?:les |nos |des )?(?:invites|amis|visiteurs)"}  # fmt: skip
_ES = {"wir": "nosotros|mi|los padres|mi mujer y yo|mi marido y yo",
       "kind": "(?:los |las |el |la |nuestros |mis |mi )?(?:dos |tres )?(?:nin[oa]s?|hij[oa]s?|bebe|gemelos)",
       "oma": "(?:la |el |mi |los |nuestra )?(?:abuel[oa]s?|madre|padre|suegr[oa]s?)",
       "gast": "(?:los |las )?(?:invitados|visitas)"}  # fmt: skip
_COUNT: dict[str, str] = {"dritt": "3", "viert": "4", "funft": "5", "sechst": "6",
                          "两": "2", "二": "2", "三": "3", "四": "4", "五": "5"}  # fmt: skip
_ROOM = {"wir": "parents' bedroom", "kind": "kids room", "oma": "relative's room", "gast": "guest room"}


def _named(words: dict[str, str]) -> str:
    return "|".join(f"(?P<{{0}}_{who}>{said})" for who, said in words.items()).replace("{0}", "{at}")


def _both(words: dict[str, str]) -> dict[str, str]:
    """The people of a language, as those of the first and of the second room."""
    return {name: f"(?:{_named(words).replace('{at}', name)})" for name in ("a", "b", "c")}


def _rooms(found: re.Match[str]) -> str:
    """Each of the rooms by whose it is."""
    told = [who.partition("_")[2] for who, said in found.groupdict().items() if said and "_" in who]
    article = "the" if found.groupdict().get("of") else "a"
    return " and ".join(f"{article} {_ROOM[who]}" for who in told)


_ENDS = r"(?= ?(?:[.,;:!)]|$)| (?:und|et|y|mit|avec|con|sowie) )"
_JOIN_DE = r"(?:,|,? und|;) (?:noch )?(?:eins|eines|ein weiteres|ein anderes|das andere|ein zweites|ein drittes) fur "
_JOIN_FR = r"(?:,|,? et|;) (?:une|une autre|l'autre|une deuxieme|une troisieme) pour "
_JOIN_ES = r"(?:,|,? y|;) (?:otr[oa]|un[oa]|el otro|la otra) para "
_SAID = [
    *rules(((r"\b(?:ein |eines |eins )?(?:schlaf)?zimmer fur {a}{join}{b}(?:{join}{c})?{ends}", _rooms),),
           join=_JOIN_DE, ends=_ENDS, **_both(_DE)),
    *rules(((r"\b(?:une )?chambre pour {a}{join}{b}(?:{join}{c})?{ends}", _rooms),),
           join=_JOIN_FR, ends=_ENDS, **_both(_FR)),
    *rules(((r"\b(?:un |una )?(?:dormitorio|habitacion|cuarto) para {a}{join}{b}(?:{join}{c})?{ends}", _rooms),),
           join=_JOIN_ES, ends=_ENDS, **_both(_ES)),
    *rules((
        # "一间主卧，一间给两个孩子"
        (r"{one}(?:我的?|我们的?)?(?:[一两二三]个)?(?:孩子们?|小孩|儿子|女儿|宝宝)", "一间儿童房"),
        (r"{one}(?:我的?|我们的?)?(?:父母|爸妈|爷爷奶奶|奶奶|爷爷|外婆|老人|妈妈|岳母|婆婆)", "一间老人房"),
        (r"{one}(?:我们|夫妻俩?|我和我?(?:妻子|丈夫|老婆|老公))", "一间主卧"),
        (r"(?:适合|给)?一对(?=夫妻|夫妇)", ""), (r"(?<=夫妻|夫妇)俩?(?:住|居住)的?", ""),
        # "zu viert, zwei Erwachsene und zwei Kinder", "nous sommes quatre"
        (r"\bwir sind zu (?:dritt|viert|funft|sechst)[,:] ?(?=(?:zwei|ein|eine|drei) )", ""),
        (r"\bwir sind zu (dritt|viert|funft|sechst)\b", lambda found: f"fur {_COUNT[found[1]]} personen"),
        (r"\bnous sommes (trois|quatre|cinq|six){end}", r"pour \1 personnes"),
        (r"\bsomos (tres|cuatro|cinco|seis){end}", r"para \1 personas"),
        (r"\b(zwei|drei|vier) erwachsenen?\b", r"\1 adults"),
        # "two kids sharing one bedroom, parents in the other", "the children share a bedroom, and we have our own"
        (r"\b(?:the |our )?(?:two |three )?(?:kids|children|boys|girls|twins) sharing (?:one|an?) (?:bed ?)?room,? "
         r"(?:and )?(?:the |their )?(?:parents|us|we) in the other(?: one| room| bed ?room)?\b",
         "a parents' bedroom and a kids room"),
        (r"(\b(?:kids|children|boys|girls|twins|sons|daughters) share (?:one|an?) (?:bed ?)?room,? (?:and |while |but "
         r")?)we (?:have|get|keep|need) our own(?: one| room| bed ?room)?{end}", r"\1we have a bedroom"),
        # "a flat share for 3 people", "une colocation pour trois", "三个学生合租的"
        (r"\b(?:flat|house)[ -]?share for (\d|two|three|four|five|six)(?: (?:people|persons|students|friends))?\b",
         r"flat for \1 flatmates"),
        (r"\b(?:une )?colocation (?:pour|de|a) (deux|trois|quatre|cinq|\d)(?: personnes)?\b",
         r"appartement pour \1 colocataires"),
        (r"\b(piso|apartamento) compartido (?:para|por|de|entre) (dos|tres|cuatro|cinco|\d)(?: personas)?\b",
         r"\1 para \2 estudiantes"),
        (r"(?P<n>[两二三四五2-5])个?(?:学生|朋友|同学|同事|室友|人)合租的?(?![^.;]*(?:每|各))",
         lambda found: f" for {_COUNT.get(found['n'], found['n'])} flatmates "),
    ), one="(?:另)?一[间个](?:卧室|房间)?给"),
]
_FOUR = late(r"\b(un|le|avec un|et un) four\b(?! \w+s\b)")


def for_whom_said(text: str) -> str:
    """A folded text with such rooms and homes."""
    return _FOUR.sub(r"\1 cuisiniere", reworded(text, _SAID))
