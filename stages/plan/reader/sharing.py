"""Who shares a room, said in brackets, by siblings of themselves, or by whose room it is: `the girls' room`."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.families import COUNTED, OWN_TOO, alike
from apartgen.stages.plan.reader.kin import kind_of, number_of, pattern, value_of
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import SEVERAL, reworded, rules

_SISTER = (r"(?:(?:little|big|older|younger|elder|twin|kleine|grosse|petite?|grande?) )?(?:brother|sister|bruder|"
           r"schwester|frere|soeur|herman[oa])")  # fmt: skip
_ALONE = re.compile(r"\bmy (?:sister|brother|twin) and i share (?:an?|one|the) (?:bed ?)?room(?: together)?\b")
_PARENTS = re.compile(r"\b(?:parents|mum|mom|dad|mother|father|grand\w+)\b")
_THEIR_ROOMS = re.compile(r"\b(?:kids|children|child|boys|girls|sons|daughters)'?s? (?:bed)?rooms?\b|\bnurser|"
                          r"kinderzimmer|\bchambres? d(?:es |')enfant|"
                          r"\b(?:habitacion|dormitorio|cuarto)(?:es)? (?:infantil|de los)|"
                          r"\bbed ?room for|儿童房")  # fmt: skip


_THEIR_PARENTS = re.compile(r"\b(?:family|couple|parents?|familie|paar|famille|familia|pareja) "
                            r"(?:of|with|mit|avec|de|con) ")  # fmt: skip


def _theirs(found: re.Match[str]) -> str:
    """`the children share the other bathroom`: it is that of their rooms, where these are not told of elsewhere."""
    known = _THEIR_ROOMS.search(found.string) or _THEIR_PARENTS.search(found.string)
    return found.group() if known else "the kids rooms share "


_SAID = rules((
    # "the kids should have a bathroom near their rooms"
    (r"\b(?:the|our|my) (?:two |three )?(?:kids|children) (?:will |can |should |must )?(?:share|use|have|get|need) "
     r"(?P<bath>(?:an?|one|their own) bath ?room) (?:near|next to|close to|beside) their (?:bed ?)?rooms\b",
     r"\g<bath> next to the kids rooms"),
    # "the children use the other bathroom", "los niños comparten el otro baño"
    (r"\b(?:the|our|my) (?:two |three )?(?:kids|children) (?:will |can |should |must )?(?:share|use|have|get) "
     r"(?=(?:the (?:other|second|family|main|hall)|another|one|an?|their own) (?:separate )?bath)", _theirs),
    (r"\b(?:die|unsere) (?:zwei |drei )?kinder (?:teilen sich|benutzen|nutzen|haben|bekommen) "
     r"(?=(?:das andere|das zweite|ein anderes|ein zweites|ein) bad)", _theirs),
    (r"\b(?:les|nos|mes) (?:deux |trois )?enfants (?:se partagent|partagent|utilisent|ont) "
     r"(?=(?:l'autre|la deuxieme|la seconde|une autre|une deuxieme|une) salle d)", _theirs),
    (r"\b(?:los|nuestros|mis) (?:dos |tres )?(?:ninos|hijos) (?:comparten|usan|tienen) "
     r"(?=(?:el otro|el segundo|otro|un segundo|un) bano)", _theirs),
    # "my partner, our twin boys and I"
    (r"\b(?P<we>my (?:wife|husband|partner|spouse|girlfriend|boyfriend)),? (?P<them>our [^.;,()]{3,40}?|our [^.;,()"
     r"]{3,40}? \([^)]*\)),? "
     r"and (?:i|me)\b", r"\g<we> and i and \g<them>"),
    (r"\b(?P<we>(?:meine?|ma|mon|mi) (?:frau|mann|partner(?:in)?|freundin|mari|femme|compagne|compagnon|marido|mujer|"
     r"espos[oa]|pareja)),? "
     r"(?P<them>(?:unser[a-z]*|notre|nos|nuestr[oa]s?) [^.;,()]{3,40}?),? (?P<and>und|et|y) (?P<me>ich|moi|yo)\b",
     r"\g<we> \g<and> \g<me> \g<and> \g<them>"),
    (r"\btwin (?=(?:boys|girls|sons|daughters)\b)", "two "),
    # "two kids (they share)", "(sharing a room)"
    (r" ?\((?:and )?(?:they |who |both |all |the two |these )?(?:will |can |would like to )?(?:share|sharing|are "
     r"sharing|are to share)"
     r"(?: (?:an?|one|the same) (?:bed ?)?room)?\),?", ", who share a room,"),
    (r" ?\((?:and )?(?P<who>the (?:two |three )?(?:[a-z]+ )?(?:ones|boys|girls|kids|children|sons|daughters)) (?"
     r":will |can )?share"
     r"(?: (?:an?|one|the same) (?:bed ?)?room)?\)", r", \g<who> share a room"),
    (r" ?\((?:sie |die )?teilen sich (?:ein |das )?(?:zimmer|schlafzimmer)\),?", " who share a room,"),
    # "zwei Kinder, die sich ein Zimmer teilen": the verb ends the clause
    (r",? die (?:sich |zusammen )?(?:ein gemeinsames |ein(?:en)? |das (?:gleiche |selbe )?|dasselbe )"
     r"(?:kinder|schlaf)?(?:zimmer|raum) (?:teilen|bewohnen)\b", " who share a room"),
    (r" ?\((?:elles |ils |qui )?partagent (?:une|la meme) chambre\),?", ", qui partagent une chambre,"),
    (r" ?\((?:ell[oa]s |que )?comparten (?:una |la misma )?{bedroom}\),?", ", que comparten "
     "habitacion,"),
    (r"\b(?P<whose>the|our|my) (?P<who>girls|boys|kids|sons|daughters) (?:will |can |are to |must )?share (?:an?|"
     r"one|the same) (?:bed ?)?room "
     r"(?:with|that has|which has) (?=(?:an?|one|two|three|\d) )", r"\g<whose> \g<who>' room has "),
    # "meine Schwester und ich teilen uns ein Zimmer, unsere Eltern haben das andere"
    (r"\b(?:ich und )?(?:meine?|unsere?|ma|mon|mi) {sister}(?: (?:und|et|y) (?:ich|moi|yo))?,? (?:wir |nous |"
     r"nosotr[oa]s )?"
     r"(?:teilen uns|teilen|partageons|compartimos|partage|dormons dans|dormimos en) (?:das gleiche |dasselbe |la "
     r"meme |el mismo |la misma |una? |une |ein |"
     r"das )?{bedroom}\b", "my sister and i share a bedroom"),
    (r"我(?:和|跟|与)(?:我的?)?(?:妹妹|姐姐|弟弟|哥哥|姐妹|兄弟)(?:合住|共用|一起住|同住|住)(?:在)?(?:一间|一个|"
     r"同一间)?(?:卧室|房间|房)",
     "my sister and i share a bedroom"),
    (r"\b(?:unsere|meine|die|nos|mes|les|mis|los|nuestros) (?:eltern|parents|padres) (?:haben|bekommen|nehmen|"
     r"schlafen|ont|"
     r"prennent|dorment dans|tienen|duermen en) "
     r"(?:das andere|ein anderes|im anderen|das zweite|l'autre|une autre|la deuxieme|el otro|la otra|otr[oa]|el "
     r"segundo|la segunda)"
     r"(?: zimmer| schlafzimmer| chambre| dormitorio| habitacion)?\b", "my parents have a bedroom"),
    (r"(?:父母|爸妈|爸爸妈妈)(?:住|用)(?:另外?|另|第二)?(?:一间|一个|间)(?:卧室|房间|房)?(?=[,.;]|$)", "my parents "
     "have a bedroom"),
    (r"\bour (?=parents (?:have|get|sleep|need|take|use)\b)", "my "),
    (r"(\bmy {sister} and (?:i|me) (?:share|sleep in)\b.*\bmy parents (?:have|get|sleep in|take|use)) the other(?: "
     r"one| room| bed ?room)?\b",
     r"\1 a bedroom"),
), sister=_SISTER)  # fmt: skip
_ALIKE = ("girl|girls|daughter|daughters", "boy|boys|son|sons", "kid|kids|child|children|sons|daughters|boys|girls")
"""Words for the same children."""
_THEIR_ROOM = late(r"\b(?:the|our|my) (?P<who>girl|boy|kid|child|children|son|daughter)(?:s'|'s) (?:bed ?)?room\b(?!s)")
_SHARES = re.compile(r"\bshar(?:e|es|ing)\b|\b(?:each|own) (?:bed ?)?rooms?\b|\btheir own\b|\b(?:bed ?)?rooms for\b")


def sharing(text: str) -> str:
    """A folded text that says so of them in plain words."""
    text = reworded(text, _SAID)
    if _ALONE.search(text) and not (_PARENTS.search(text) or COUNTED.search(text)):
        text = _ALONE.sub("one bedroom for us", text)
    return _one_room(text)


def _one_room(text: str) -> str:
    """`our two girls …; the girls' room needs a bunk bed`: one room for both."""
    room = _THEIR_ROOM.search(text)
    if room is None or _SHARES.search(text) or COUNTED.search(text):
        return text
    stem = room["who"].replace("children", "child")
    nouns = next((alike for alike in _ALIKE if stem in alike.split("|")), f"{stem}s")
    many = re.compile(rf"\b{SEVERAL} (?:[a-z]+ )?(?:{nouns})\b")
    counted = many.search(text[: room.start()])
    if counted is None:
        return text
    return f"{text[: counted.end()]}, who share a room,{text[counted.end() :].removeprefix(',')}"


def told_again(text: str) -> tuple[int | None, str]:
    """`two daughters and a son; the daughters share a room`: so many rooms fewer, None where nobody is told again."""
    fewer: list[int] = []

    def shared(match: re.Match[str]) -> str:
        noun = alike((match.groupdict().get(kind_of(match)) or "").removesuffix("s"))
        counted = re.search(rf"\b({words}) (?:\w+ )?{noun}", text[: match.start()]) if noun else None
        some, all_of = number_of(match), value_of(counted[1]) if counted else 0
        if not 0 <= some < all_of or (some and OWN_TOO.search(text)):
            return match.group()
        fewer.append((some or all_of) - 1)
        return ""

    words = r"\d+|" + "|".join(numbers())
    out = pattern("{who}{relative}? ?(?:will |can |must )?{share} ?{article}*{room}").sub(shared, text)
    alone = pattern("{who} (?:is |sleeps |schlaft )?(?:alone|allein|seule?|sol[oa])")
    return (sum(fewer), alone.sub("", out)) if fewer else (None, text)
