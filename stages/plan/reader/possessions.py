"""Who has which room, said by a verb: `my son gets the small one, my daughter the big one`, `we sleep in the third`."""

import re

from apartgen.stages.plan.reader.families import FAMILY
from apartgen.stages.plan.reader.kin import kind_of, number_of, pattern, rooms_for, several, value_of
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import BEDROOMS

VERB = (r"(?:{need}|takes?|uses?|occup(?:y|ies)|(?:sleeps?|stays?|lives?|is|are|moves?) in(?:to)?|schlaf(?:t|en) in|"
        r"nimmt|nehmen|dor(?:t|ment) dans|prend|prennent|duermen? en|ocupan?)")  # fmt: skip
"""What people do who have a room."""
WHICH = (r"(?:(?P<size>small|smaller|smallest|little|tiny|big|bigger|biggest|large|larger|largest|main|guest|"
         r"single|double|middle|medium|kleine[sn]?|grosse[sn]?|petite|grande)(?:er|est)? |second |third |fourth |last "
         r"|other |first |same |"
         r"zweite |dritte |andere |deuxieme |troisieme |autre |segunda |tercera |otra |pequena )?")  # fmt: skip
OBJECT = (rf"(?:(?:the|an?|his|her|their|one|my|our|this|das|ein|la|une?|una) )(?:own )?(?:(?P<many>{{numbers}}) "
    rf")?{WHICH}"
          r"(?P<noun>bed ?rooms?|rooms?|ones?|master(?: bed ?room)?|"
          r"(?:schlaf)?zimmer\b|chambre\b|habitacion\b)(?! (?:bath|wide|of (?:the|"
          r"our) (?:flat|house)))\b(?!')")  # fmt: skip
AGED = re.compile(
    r"\b(?<!\bin )(the (?:(?:two|three|[23]) )?(?:little|small|young|older|younger|big|bigger|elder|other)) ones?"
    r"(?=,? (?:in |can |will |both |each |share|sleep|has |have |get|need|want|take))"
    r"|\b(the|his|her|their) (eldest|oldest|youngest|elder|younger)(?=,? (?:in |can |will |share|sleep|has |gets?|"
    r"needs?|wants?|takes?))"
)
"""Children told by their age."""
SEVERAL = re.compile(rf"\b(?:two|three|four|five|six|[2-6])[ -]?(?:bed ?room|br\b|{BEDROOMS})")
BESIDES = re.compile(r"\b(?:besides|beside that|apart from|in addition|additionally|on top of that|further)\b")
"""Bedrooms that are counted: those of whom it is told are among them."""
ABROAD = [(late(said), words) for said, words in (
    (r"\blos (dos|tres) (?:pequenos|menores|mayores|chicos)(?= (?:comparten|duermen|tienen|quieren))", r"los \1 hijos"),
    (r"\b(?:el|la) (?:mayor|menor|pequen[oa])(?= (?:tiene|duerme|quiere|necesita))", "el hijo"),
    (r"\bles (deux|trois) (?:petits|petites|cadets|grands|plus jeunes)(?= (?:partagent|dorment|ont|veulent))",
     r"les \1 enfants"),
    (r"\b(?:l'ainee?|le grand|la grande|le cadet|la cadette)(?= (?:a|dort|veut) )", "l'enfant"),
    (r"\bdie (?:beiden|zwei) (?:kleinen|grossen|jungeren|alteren)(?= (?:teilen|schlafen|haben|bekommen))",
     "die zwei kinder"),
    (r"\b(?:der|die) (?:grosse|alteste|jungste|kleine)(?= (?:hat|schlaft|bekommt|braucht))", "das kind"),
)]
SLEEPERS = [(pattern(said), words) for said, words in (
    # "die Eltern schlafen im großen Schlafzimmer, die Jungs im kleinen", "en el dormitorio grande … en el pequeño"
    (r"(?P<they>{who}) (?:schlaf(?:t|en) )?im (?P<which>grosse|kleine|andere|zweite|dritte)n(?: (?:schlaf)?zimmer)?\b",
     r"\g<they> schlafen in das \g<which> zimmer"),
    (r"(?P<they>{who}) (?:duermen? )?en el (?:dormitorio |cuarto )?(?P<which>grand|pequen|otr|segund)[eo]\b",
     lambda found: f"{found['they']} duermen en la {found['which']}{'ea'[found['which'] != 'grand']} habitacion"),
)]
TOLD = re.compile(
    r"\b(?:the|his|her|their|das|la) (?:[a-z]+ ){0,2}(?:rooms?|bed ?rooms?|ones?|(?:schlaf)?zimmer|chambre|"
    r"habitacion)\b"
    r"|\b(?:the|das|la) (?:other|second|third|fourth|last|big|small|grosse|kleine|petite|grande)[a-z]*(?= ?(?:[.,;]|$|"
    r" and))"
    r"|\b(?:share|teilen|partagent|comparten)\b"
)
"""Without which nobody is told to have one of several rooms."""
IN_BEDS = re.compile(r"\b(sleep) in (?:(?:a|two) )?((?:[a-z]+ )?beds?) (in (?:one|the same|a) (?:bed ?)?room)\b")
BARE = re.compile(
    r"\b(the (?:other|second|third|fourth|last|biggest|largest|smallest|bigger|smaller|big|small)|das (?:grosse|"
    r"kleine|andere|zweite)|"
    r"la (?:petite|grande|otra|autre|pequena))(?= ?(?:[.,;]|$| (?:and|und|et|y) (?:i|we|my|our|the|wir|je|nous|yo)\b))"
)
"""What tells a room without a word for it."""
AND_THING = re.compile(r"\b(\d (?:kids room|relative's room|bedroom)s) and (?:an? |their own |own )?(desk|bed|"
    r"wardrobe|balcony|bathroom)\b")
ORDINAL = re.compile(r"\bthe (second|third|fourth)(?= (?:bed ?)?room| one)")
OURS = (
    r"\b(?:we|my [a-z]+ and i|i and my [a-z]+) (?:both |two |parents )?(?:{verb}) (?:the|an?|our|one) (?:own )?"
    r"(?:(?:biggest|largest|big|large|second|third|fourth|last|other|main|remaining|same|smallest|small) )?"
    r"(?:bed ?room|room|one|other)\b"
)
OURS_ELSEWHERE = re.compile(
    r"\bwe (?:take|get|have|sleep in|use) the (?:biggest|largest|third|last|other|remaining)(?= ?(?:[.,;]|$))"
    r"|\bwir (?:schlafen|wohnen|haben|nehmen|bekommen)(?: in| im)? (?:de[mnr] |das |die )?"
    r"(?:dritten|vierten|zweiten|grossten|grossen|grosste|anderen|andere|letzten)(?: schlafzimmer| zimmer)?\b"
    r"|\bnous (?:avons|dormons dans|prenons|occupons|aurons) (?:la |une )?(?:plus grande|troisieme|quatrieme|deuxieme|"
    r"derniere|autre)(?: chambre)?\b"
    r"|\bje dors dans (?:la |une )?(?:plus grande|troisieme|quatrieme|deuxieme|derniere|autre)(?: chambre)?\b"
    r"|\bich schlafe (?:im|in dem) (?:dritten|zweiten|anderen|letzten)(?: schlafzimmer| zimmer)?\b"
    r"|\bnosotros (?:dormimos en|tenemos|ocupamos|usamos) (?:la |el |una? )?(?:mas grande|tercer[oa]?|segund[oa]|"
    r"cuart[oa]|"
    r"ultim[oa]|otr[oa])(?: habitacion| dormitorio)?\b"
)
MINE = (
    r"\bi (?:also )?(?:{verb}) (?:the|an?|my|one) (?:own )?"
    r"(?:(?:second|third|fourth|last|other|remaining|small|big|middle) )?"
    r"(?:bed ?room|room|one|other)\b(?! bath)"
)
SELF = "(?:takes?|gets?|has|have|needs?|wants?|uses?|sleeps? in|live in|stay in)"


SLEEP_IN = re.compile(r"\b(?:(?:sleeps?|stays?|schlaf(?:t|en)) in|dor(?:t|ment) dans|duermen? en) (?:the|das|la) ")
"""What several do in one room: `the boys sleep in the other one`."""


def aged(text: str) -> str:
    """`the two little ones`, `the eldest` as children, where a text speaks of some."""
    for said, words in (*ABROAD, *SLEEPERS) if not FAMILY.search(text) else []:
        text = said.sub(words, text)
    if not re.search(r"\b(?:children|kids?|sons?|daughters?|boys|girls|baby|toddler|twins)\b", text):
        return text
    text = AGED.sub(lambda found: f"{found[1]} children" if found[1] else f"{found[2]} {found[3]} child", text)
    text = re.sub(r"\b(the (?:little|small|young|older|younger|big|bigger|elder|other) )children(?= (?:has|gets|needs|"
        r"wants|takes))", r"\1child", text)
    return IN_BEDS.sub(r"\1 \3 with \2", text)


def possessed(text: str) -> tuple[str, list[str]]:
    """A folded text with rooms in the place of clauses that say who has one, and those clauses."""
    found: list[str] = []
    if TOLD.search(text) is None:
        return text, found
    said, text = text, BARE.sub(r"\1 one", text)
    counted = among_counted(said)

    def room(match: re.Match[str]) -> str:
        plain = not match["noun"].startswith("one")
        if not plain and not (match["size"] or re.search(r"\b(?:one|ones)$", match.group())):
            return match.group()
        found.append(match.group())
        if counted and not match["many"]:
            which = match["size"] or next(iter(ORDINAL.findall(match.group())), "")
            known = f"the {which} bedroom" if which else "one of the bedrooms"
            return "the parents' bedroom" if kind_of(match) in ("couple", "spouse") else known
        many = value_of(match["many"]) if match["many"] else 1
        one = not match["noun"].endswith("s") or many == 1
        rooms = rooms_for(match, 1 if one else many)
        return sized(rooms, match["size"])

    def shared(match: re.Match[str]) -> str:
        found.append(match.group())
        return (counted_for(match) if counted else "") or rooms_for(match, 1)

    text = pattern("{who}{relative} (?:will |can |must |should )?(?:share|teilen|partagent|comparten)(?= ?(?:[,.;:]|$|"
        "and ))"
                   ).sub(shared, text)  # fmt: skip
    text = pattern(f"{{who}}{{relative}}? (?:will |should |must |can )?{VERB} {OBJECT}").sub(
        lambda match: room(match) if _takes(match) else match.group(), text)  # fmt: skip
    if found:
        text = pattern(f"{{who}}{{relative}}? (?:will |should |must |can )?share {OBJECT}").sub(
            lambda match: sized(shared(match), match["size"]), text)  # fmt: skip
        text = pattern(rf"(?<=[,;] )(?:and |while )?{{who}},? (?:in )?{OBJECT}").sub(room, text)
        text = pattern(rf"(?:(?<= and )|(?<= und )|(?<= et )|(?<= y )){{who}} (?:in|dans|en) {OBJECT}").sub(room, text)
    return (text if found else said), found


def among_counted(text: str) -> bool:
    """Whether a text counts bedrooms among which those are of whom it tells."""
    return SEVERAL.search(text) is not None and BESIDES.search(text) is None


def counted_for(match: re.Match[str]) -> str:
    """The room of boys, girls, a son or a daughter among bedrooms that are counted; "" where none are."""
    noun = match.groupdict().get(kind_of(match)) or ""
    if kind_of(match) not in ("child", "twins") or not noun.isascii() or not among_counted(match.string):
        return ""
    told = re.fullmatch(r"(?:boy|girl|son|daughter|twin)s?", noun) is not None
    room = (f"the {noun}' bedroom" if noun.endswith("s") else f"the {noun}'s bedroom") if told else "the kids room"
    before = re.split(r"[.;!?]", match.string[: match.start()])[-1].rstrip()
    return f". {room}" if before.endswith(",") and "bedroom" not in before else room  # no more of another list


def _takes(match: re.Match[str]) -> bool:
    """Whether the clause tells which room somebody has, rather than that there is to be one for them."""
    which = re.search(r"\b(?:the|his|her|their|das|la) (?:own )?(?:[a-z]+ ){0,2}(?:[a-z]*rooms?|ones?|master|"
        r"[a-z]*zimmer|chambre|habitacion)$",
                      match.group())  # fmt: skip
    own = re.search(r"\b(?:own|same|eigenes?|propre|propia)\b", match.group())
    single = kind_of(match) != "child" or not several(match) or number_of(match) == 1
    single = single and kind_of(match) != "spouse"
    share = SLEEP_IN.search(match.group())
    return bool(which) and not own and bool(single or share or match["many"] or match["noun"].endswith("s"))


def sized(rooms: str, size: str | None) -> str:
    """`a kids room` that is large or small."""
    word = {"s": "small", "l": "small", "b": "large", "t": "small", "k": "small", "p": "small",
    "g": "large"}.get((size or " ")[0], "")
    word = "large" if (size or "").startswith("large") else word
    if not word or size in ("single", "double", "main", "guest", "middle", "medium") or "parents'" in rooms:
        return rooms
    return re.sub(r"^(a|\d+) ", rf"\1 {word} ", rooms)


def equipped(text: str) -> str:
    """`three bedrooms and desk each` of those who each have a room: each room has one."""
    return AND_THING.sub(r"\1 each with a \2", text)


def ours(text: str) -> str:
    """Rooms of those who write, in a text that tells rooms of others."""
    def parents(match: re.Match[str]) -> str:
        before = "parents' bedroom" in match.string[: match.start()]
        return "another bedroom" if before else f"{'the' if SEVERAL.search(text) else 'a'} parents' bedroom"

    text = OURS_ELSEWHERE.sub(parents, text)
    text = re.sub(OURS.replace("{verb}", SELF), parents, text)
    return re.sub(MINE.replace("{verb}", SELF), "another bedroom", text)
