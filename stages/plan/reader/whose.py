"""Whose room `hers`, `his room`, `ours` is: people are followed through a text and their bedrooms numbered.

Centering in its simplest form: a pronoun means the person told of last whom it agrees with in gender and number (Grosz,
Joshi and Weinstein, 1995, DOI 10.21236/ADA324949). The speakers have bedroom 1, others follow as they are told of.
"""

import re
from dataclasses import dataclass

from apartgen.stages.plan.reader.patterns import Late

_FEMALE = (r"mother-in-law|mother|mum|mom|mama|mommy|step-?mother|grandmother|grandma|granny|"
           r"gran|nana?|daughter|step-?daughter|sister-in-law|sister|aunt|auntie|niece|girl|lady|"
           r"nanny|au[ -]pair|granddaughter|woman")  # fmt: skip
_MALE = (r"father-in-law|father|dad|daddy|papa|step-?father|grandfather|grandpa|grand-?dad|step-?son|son|"
         r"brother-in-law|brother|uncle|nephew|boy|butler|grandson|man")  # fmt: skip
_EITHER = (r"baby|child|kid|teenager|teen|toddler|(?:flat|house|room)-?mate|cousin|friend|tenant|lodger|student|"
           r"eldest|oldest|youngest|grandchild|carer|colleague|sibling")  # fmt: skip
_SEVERAL = (r"parents-in-law|grandparents|parents|kids|children|twins|boys|girls|sons|daughters|grandchildren|in-laws|"
            r"little ones|toddlers|teenagers|teens")  # fmt: skip
_SPOUSE = r"wife|husband|partner|girlfriend|boyfriend|fiancee?|spouse|hubby|missus"
_PERSON = Late(
    rf"\b(?:(?P<several>{_SEVERAL})|(?P<she>{_FEMALE})|(?P<he>{_MALE})|(?P<either>{_EITHER})|(?P<spouse>{_SPOUSE}))"
    r"\b(?!'s (?:mother|father|mum|mom|dad|parents|sister|brother|son|daughter))(?! (?:room|bedroom|bathroom|bath)\b)"
)
_PRONOUN = Late(r"\b(?P<she>she)\b|\b(?P<he>he)\b")
_SIZED = r"(?:own |small |little |tiny |big |large |new )*"
_ROOM = rf"{_SIZED}(?:bed ?)?room(?!s|mate|-)"
_WHOSE = Late(
    rf"\b(?P<whose>my|our|his|her|their) (?P<size>{_SIZED})(?:bed ?)?room(?![a-z]|-)(?! (?:schedule|plan|list|service))"
    r"|(?<!only )\b(?P<alone>mine|ours|hers|theirs)\b(?!')|\b(?P<alone_his>his)(?= ?(?:[.,;:]|$)| (?:can|could|should|"
    r"must|has|have|is|needs|may|gets|to be|on|at|in|next)\b)"
)
_SENTENCE = Late(r"[.!?;\n]")
_OTHER_ROOMS = Late(
    r"\b(?:bath ?rooms|en-?suites?|studies|desks|(?:my|our|his|her|their)(?: own)? (?:bath ?room|study|office|desk|"
    r"bath|closet))\b"
)
_ASSIGNED = Late(
    r"\b(?:an?|one|the|another|separate|same) (?:(?!living|dining|laundry|utility|storage|sitting|guest|play|"
    r"family)[a-z]+ )?(?:bed ?)?room\b|\b(?:each|every|everyone|everybody)\b(?! of our)|\b(?:all|both) (?:[a-z]+ "
    r")?(?:gets?|have|needs?|wants?|with|own)\b|\bone for\b|\bseparate (?:bed ?)?rooms|\bshares?\b"
)
"""Who is given a room in other words: rules for those know better."""
_BED = Late(r"\b(?:bed ?)?rooms?\b")
_COUNT = Late(
    r"\b(?:\d|one|two|three|four|five|six|single|a)[ -](?:[a-z]+ )?bed ?-?rooms?\b|\bbedrooms?[:=] ?\d|\bstudio\b"
)
_APART = Late(
    r"\b(?:snor|given up sharing|separate (?:bed)?rooms|sleep apart|not share a (?:bed)?room|our own rooms?|a room "
    r"each)"
)
_LABELLED = Late(
    r"\b(?:nursery|guest (?:bed)?room|kids'? (?:bed)?rooms?|children's (?:bed)?rooms?|[a-z]+(?:'s|s') (?:own )?(?:bed "
    r"?)?rooms?|master|main bedroom|parents' bedroom|spare (?:bed)?room|first bedroom|second bedroom|third bedroom|"
    r"bedroom \d|bigger (?:bed)?room|smaller (?:bed)?room|largest (?:bed)?room|room for |rooms? of (?:my|our|the)|"
    r"other (?:bed)?room)\b"
)
_WE = Late(r"\b(?:i|me|my|we|us|our|mine|ours|i'm|we're|i've|we've)\b")


_ABROAD = {
    "schlafzimmer": (
        Late(r"\b(?:mein(?:e[mns]?|s)?|unser(?:e[mns]?|s)?) (?:eigene[ns]? )?(?:schlaf)?zimmer\b|"
             r"\b(?:mein(?:e[mrs]|s)|unser(?:e[mrs]))\b"
             r"(?= ?(?:[.,;]|$| (?:liegen|sein|ist|soll|kann|darf|muss|und)\b))"),
        Late(r"\b(?:ihr|sein)(?:e[mns]?|s)? (?:schlaf)?zimmer\b|\b(?:ihr(?:e[ms])|sein(?:e[ms]))\b"
             r"(?= ?(?:[.,;]|$| (?:liegen|sein|ist|soll|kann|darf|muss|und)\b))"),
        Late(r"\b(?:\d|ein|zwei|drei|vier|funf)(?:es|e)? (?:schlaf)?zimmer|zimmer-wohnung|\bjede"),
    ),
    "chambre": (
        Late(r"\b(?:ma|notre) (?:propre )?chambre\b|\bla (?:mienne|notre)\b"),
        Late(r"\b(?:sa|leur) (?:propre )?chambre\b|\bla (?:sienne|leur)\b"),
        Late(r"\b(?:\d|une|deux|trois|quatre|cinq) chambres?\b|\bt\d\b|\bchacune?\b"),
    ),
    "dormitorio": (
        Late(r"\b(?:mi|nuestr[oa]) (?:propi[oa] )?(?:cuarto|dormitorio|habitacion)\b|"
             r"\b(?:el|la) (?:mi[oa]|nuestr[oa])\b"),
        Late(r"(?<!con )\bsu (?:propi[oa] )?(?:cuarto|dormitorio|habitacion)\b|\b(?:el|la) suy[oa]\b"),
        Late(r"\b(?:\d|un|una|dos|tres|cuatro|cinco) (?:cuartos?|dormitorios?|habitacion(?:es)?)\b"),
    ),
}  # fmt: skip
"""By the word for a bedroom: what is the speakers', what is the other's, what counts bedrooms."""
_PEOPLE_ABROAD = {
    "schlafzimmer"
    : Late(r"\b(?:schwieger|gross)?(?:mutter|vater)\b|\b(?:oma|opa|tochter|sohn|bruder|schwester|mitbewohner(?:in)?|"
                         r"kind|baby|tante|onkel|freund(?:in)?|zwillinge|eltern|jungs?|kleinen?)\b"),
    "chambre"
    : Late(r"\b(?:belle-)?(?:grand-)?(?:mere|pere)\b|\b(?:fils|fille|frere|soeur|coloc(?:ataire)?|bebe|"
                    r"cousine?|tante|oncle|ami|amie|parents|enfants?|ados?|jumeaux)\b"),
    "dormitorio"
    : Late(r"\b(?:madre|padre|abuel[oa]|suegr[oa]|hij[oa]s?|herman[oa]|prim[oa]|companer[oa]|amig[oa]|bebe|"
                       r"nin[oa]s?|padres|ti[oa]|gemelos)\b"),
}  # fmt: skip


@dataclass
class _Person:
    """Somebody told of: what `she`, `he` or `they` may mean."""

    word: str
    she: bool
    he: bool
    several: bool
    spouse: bool


def whose_rooms(text: str) -> str:
    """A folded English text with the bedrooms of those who are told of by their numbers, where all are clear."""
    for bedroom, (ours, theirs, counts) in _ABROAD.items():
        if theirs.search(text):
            text = _of_two(text, bedroom, ours, theirs, counts)
    owned = list(_WHOSE.finditer(text))
    others = [m for m in owned if (m["whose"] or m["alone"] or "his") in ("his", "her", "their", "hers", "theirs")]
    if not others or _LABELLED.search(text) or not _WE.search(text) or _ASSIGNED.search(text):
        return text
    rooms, order = _resolved(text, owned)
    if rooms is None:
        return text
    told: list[str] = []
    at = 0
    for found, person in zip(owned, rooms, strict=True):
        if person is None:
            continue
        size = (found["size"] or "").replace("own", "").strip()
        told += [text[at : found.start()], f"{size} bedroom {order[person]}".strip()]
        at = found.end()
    said = "".join([*told, text[at:]])
    if _COUNT.search(text):
        return said
    return f"{len(order)} bedrooms. {said}"


def _of_two(text: str, bedroom: str, ours: Late, theirs: Late, counts: Late) -> str:
    """`sa chambre … la mienne` where but one other person is told of: the speakers' bedroom and that of the other."""
    text = re.sub(r"\b(de|a)l (?=(?:mi|suy|nuestr)[oa]\b)", r"\1 el ", text) if bedroom == "dormitorio" else text
    others = {m.group() for m in _PEOPLE_ABROAD[bedroom].finditer(text)}
    if not ours.search(text) or len(others) != 1:
        return text
    text = re.sub(
        r",? (?:cada un[oa] con su (?:propi[oa] )?(?:cuarto|dormitorio|habitacion)|chacune? (?:a )?sa chambre)\b",
        "",
        text,
    )
    said = theirs.sub(f"{bedroom} 2", ours.sub(f"{bedroom} 1", text))
    return said if counts.search(text) else f"2 {bedroom}{'' if bedroom == 'schlafzimmer' else 's'}. {said}"


def _resolved(text: str, owned: list[re.Match[str]]) -> tuple[list[str | None] | None, dict[str, int]]:
    """Whose bedroom each phrase means, None of what is no bedroom; all None where one cannot be told."""
    apart = _APART.search(text) is not None
    people: list[tuple[int, _Person]] = [(m.start(), _person(m)) for m in _PERSON.finditer(text)]
    out: list[str | None] = []
    for found in owned:
        word = found["whose"] or found["alone"] or "his"
        if found["whose"] is None and not _of_bedroom(text[: found.start()]):
            out.append(None)
            continue
        if word in ("my", "our", "mine", "ours"):
            out.append("")
            continue
        person = _meant(word, [p for at, p in people if at < found.start()])
        if person is None:
            return None, {}
        name = "" if person.spouse and not apart else person.word
        out.append(name)
    named = list(dict.fromkeys(name for name in out if name is not None))
    named = ["", *(name for name in named if name)]  # the first bedroom is theirs whose the home is, or their parents'
    named.sort(key=lambda name: "parents" not in name)
    housed = {p.word for _, p in people if not p.spouse or apart}
    told = len(set(out) - {None}) > 1 and housed == set(named) - {""}
    return (out, {name: k for k, name in enumerate(named, 1)}) if told else (None, {})


def _person(found: re.Match[str]) -> _Person:
    either, spouse = found["either"] is not None, found["spouse"] is not None
    word = found.group()
    she = found["she"] is not None or either or word in ("wife", "girlfriend", "partner", "spouse", "fiancee", "missus")
    he = found["he"] is not None or either or word in ("husband", "boyfriend", "partner", "spouse", "fiance", "hubby")
    return _Person({"boy": "son", "girl": "daughter"}.get(word, word), she, he, found["several"] is not None, spouse)


def _meant(word: str, people: list[_Person]) -> _Person | None:
    """The last of whom `her`, `his` or `their` may be said."""
    fits = [
        p for p in people if (p.several if word in ("their", "theirs") else p.she if word.startswith("her") else p.he)
    ]
    fits = [p for p in fits if not p.spouse] or fits
    exact = [p for p in fits if not (p.she and p.he)]
    return (exact or fits)[-1] if fits else None


def _of_bedroom(before: str) -> bool:
    """Whether `mine` is a bedroom after what stands before: no bathroom or study is spoken of more nearly."""
    clause = _sentences(before)
    rooms = [m.end() for m in _BED.finditer(clause)]
    other = [m.end() for m in _OTHER_ROOMS.finditer(clause)]
    return not other or (bool(rooms) and rooms[-1] > other[-1])


def _sentences(before: str) -> str:
    """The sentence that a text ends in and the one before it."""
    ends = [m.end() for m in _SENTENCE.finditer(before)]
    return before[ends[-2] if len(ends) > 1 else 0 :]
