"""How many rooms a home is to have in all: `exactly six rooms`, hallway and bathroom among them, and no more unsaid."""

import re
from functools import cache

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.patterns import Late, late
from apartgen.stages.plan.reader.pieces import DE, ES, FR, KIND
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.tokens import fold

OUTSIDE = ("balcony",)
"""What nobody counts among rooms."""
MAIN = ("living_room", "dining_room", "bedroom", "study")
"""Rooms that are counted where kitchen and bath go without saying."""
MORE = ("bathroom", "study", "storage", "dining_room", "utility")
"""Rooms that make up a number of which not all are named; a second bathroom from three bedrooms on."""
_NAMED = {
    "n": r"(?P<n>1[0-2]|[3-9]|three|four|five|six|seven|eight|nine|ten)",
    "no_more": (r"(?: ?[,;(-]* ?(?:and |but )?(?:no more(?:,? (?:and )?no (?:less|fewer))?|not more|nothing more|no "
                r"others?|not one more|no more than that|no (?:additional|further|extra|other) (?:rooms?|ones?))\)?)"),
    "all": r"(?:in all|in total|altogether|all together|overall|all told|total|in sum)",
    "with": (r"(?:,? ?(?:there (?:must|should|shall|are to|have to) be|there (?:are|is)|it (?:has|should have|must "
             r"have)|that (?:has|makes|is)|which (?:has|makes|is)|making|(?:i|we) (?:want|need)|make it|so|"
             r"contain(?:s|ing)?|(?:must|should|shall|has to|with|of|has|have|having|for)(?: have)?) )?"),
    "with_hall": (r"(?P<incl>,? ?\(?(?:including|incl\.?|counting|inclusive of)(?:(?:,|,? and|,? plus)? (?:the |an? "
                  r")?(?:hall(?:way)?|corridor|entrance(?: hall)?|bath ?rooms?|kitchen|toilet))+\)?)?"),
    "ends": r"(?P<list> ?: ?| ?- (?=[a-z])|(?= ?(?:[.,;)]|$)|,? (?:and|with|including|counting|which|for) ))",
    "zh": r"(?P<n>1[0-2]|[3-9]|[三四五六七八九十])",
}  # fmt: skip
_SAID = (
    r"{with}\b(?:exactly|precisely) {n} rooms(?: {all})?{no_more}*{with_hall}{no_more}*{ends}",
    r"{with}(?:only |just |exactly )?\b(?<!than )(?<!most )(?<!least )(?<!least of )(?<!up to ){n} rooms,? "
    r"{all}{no_more}*{with_hall}{no_more}*{ends}",
    r"{with}\b(?<!than )(?<!most )(?<!least ){n} rooms{no_more}+{with_hall}{ends}",
    r"{with}\b(?:no more than|at most|max(?:imum)?(?: of)?|only|just) {n} rooms(?: {all})?(?P<list> ?: ?)",
    r"\b(?:total|overall)(?: number of)? rooms ?: ?{n}(?P<list>)(?= ?(?:[.,;\n]|$))",
    r"\brooms (?:in total|in all|altogether) ?: ?{n}(?P<list>)(?= ?(?:[.,;\n]|$))",
    r"\b(?:mit )?(?:genau|exakt) (?P<n>zwei|drei|vier|funf|sechs|sieben|acht|[3-9]) raume?n?(?P<list> ?: ?|(?= "
    r"?(?:[.,;]|$)))",
    r"\b(?:mit )?(?:genau|exakt|insgesamt) (?P<n>drei|vier|funf|sechs|sieben|acht|[3-9]) (?:raume?n?|"
    r"zimmern?)(?P<list> ?: ?)",
    r"\b(?:avec )?(?:exactement|seulement) (?P<n>trois|quatre|cinq|six|sept|huit|[3-9]) pieces(?: en tout| au "
    r"total)?(?P<list> ?: ?)",
    r"\b(?:avec )?(?P<n>trois|quatre|cinq|six|sept|huit|[3-9]) pieces (?:en tout|au total)(?P<list> ?: ?)",
    r"\b(?:con )?(?:exactamente|solo) (?P<n>tres|cuatro|cinco|seis|siete|ocho|[3-9]) (?:habitaciones|estancias|"
    r"cuartos)(?: en total)?(?P<list> ?: ?)",
    r"\b(?:con )?(?P<n>tres|cuatro|cinco|seis|siete|ocho|[3-9]) (?:habitaciones|estancias|cuartos) en total(?P<list> "
    r"?: ?)",
    r"(?:总共|一共|正好|恰好|刚好|只有|共)(?:要|有)?{zh}[个间]房间?(?P<list> ?[:,] ?)",
)  # fmt: skip
_SOME = late(r"exactly|precisely|only|just|in all|in total|altogether|all together|overall|all told|total|no more|not "
             r"more|nothing more|at most|maximum|max |genau|exakt|insgesamt|exactement|seulement|en tout|exactamente|"
             r"solo|[总一]共|正好|恰好|刚好|只有")  # fmt: skip
_OF_THEM = late(r",? ?\b(?P<k>one|two|three|four|five|\d) of (?:them|which|those) (?:are |being |should be )?(?=bed "
                r"?rooms)")
_HALL = late(r"\b(?:hall|corridor|entrance)")
_LIST = late(r"\b(?P<said>(?P<n>[3-9]|three|four|five|six|seven|eight|drei|vier|funf|sechs|sieben|trois|quatre|cinq|"
             r"tres|cuatro|cinco|seis) (?:rooms|zimmern?|raume?n?|pieces|habitaciones|ambientes|cuartos|estancias))\b"
             r"[^.:;]*: ?(?P<list>[^.:;\n]*[^.:;\n ])")  # fmt: skip
_ROOMS = Late(r"^(?:(?:an?|the|eine?|une?|una?|la|el|le|\d x|(?P<n>\d|[a-z]+)) )?(?:{kind}|{de}|{fr}|{es})s?\b",
              {"kind": KIND, "de": DE, "fr": FR, "es": ES})  # fmt: skip
_ZH = dict(zip("三四五六七八九十", range(3, 11), strict=True))


def rooms_in_all(text: str) -> tuple[str, tuple[int, str] | None]:
    """A text without the number of all rooms, folded where it had one; that number, and the words that told it."""
    if not _SOME.search(text.lower()):
        return text, None
    folded = fold(text)
    for pattern in _patterns():
        found = next(pattern.finditer(folded), None)
        if found is not None:
            said, number = found.group().strip(" ,:;-"), found["n"]
            rest = f"{_begun(folded[: found.start()], found)}{folded[found.end() :]}"
            unnamed = _HALL.search(found.groupdict().get("incl") or "") and not _HALL.search(rest)
            rest += ". there is a hallway." if unnamed else ""
            many = int(number) if number.isdigit() else _ZH.get(number) or _numbers()[number]
            return _OF_THEM.sub(r" \g<k> ", rest).strip(" ,;") or "a flat", (many, said)
    return text, None


def _begun(before: str, found: re.Match[str]) -> str:
    """What stands before, with the word that a list wants behind it."""
    of_home = bool(found["list"]) and re.search(r"[a-z] ?$", before) is not None
    return f"{before.rstrip()} with " if of_home else before


@cache
def _patterns() -> tuple[Late, ...]:
    return tuple(Late(pattern, _NAMED) for pattern in _SAID)


@cache
def _numbers() -> dict[str, int]:
    more = ("seven", "sieben", "sept", "siete"), ("eight", "acht", "huit", "ocho"), ("nine",), ("ten",)
    return dict(numbers()) | {word: 7 + k for k, words in enumerate(more) for word in words}


def counted(home: Household) -> list[Entity]:
    """Rooms that a number of all rooms counts."""
    return [room for room in home.rooms if room.type not in OUTSIDE]


def all_named(said: Said, home: Household) -> bool:
    """Whether the rooms that are named are as many as there may be; a number of those to live in is no such number."""
    main = [room for room in home.rooms if room.type in MAIN]
    if said.in_all is not None and len(counted(home)) > len(main) == said.in_all[0]:
        said.in_all = None  # "four rooms altogether: two bedrooms, a study, a living room; plus kitchen and bath"
    return said.in_all is not None and len(counted(home)) >= said.in_all[0]


def make_room(said: Said, home: Household) -> None:
    """Bedrooms where none is named, and no hallway where the rooms that every home has make up the number."""
    if said.in_all is None:
        return
    always = [kind for kind in sense()["missing"]["always"] if not home.of(kind) and (kind, "") not in home.banned]
    free = said.in_all[0] - len(counted(home)) - len(always)
    if not home.of("bedroom") and said.dwelling != "studio" and free > 0 and said.about.people is None:
        many = free if free < 2 else free - (not home.of("hallway"))
        home.add("bedroom", min(many, 3))
        free -= min(many, 3)
    if "bathroom" in always:
        home.add("bathroom")
    if free < 1 and not home.of("hallway"):
        home.banned.add(("hallway", ""))


def make_up(said: Said, home: Household) -> None:
    """More rooms where fewer than that number are named; where it cannot be had, it is told."""
    if said.in_all is None:
        return
    many, words = said.in_all
    for kind in MORE:
        wanted = kind != "bathroom" or (len(home.of("bedroom")) > 2 and len(home.of(kind)) < 2)
        if len(counted(home)) < many and (kind, "") not in home.banned and wanted:
            home.add(kind)


def told(said: Said, home: Household) -> None:
    """Of a number that a home does not have, how many rooms it has."""
    many = said.in_all or _listed(said.prompt)
    if many is not None and (there := len(counted(home))) != many[0]:
        said.beyond.append((many[1], f"with what is asked for there are {there} rooms"))


def _listed(prompt: str) -> tuple[int, str] | None:
    """How many rooms `five rooms: a hall, a kitchen, …` lists, hall, kitchen or bath among them: a home has more."""
    folded = fold(prompt)
    found = next(_LIST.finditer(folded), None)
    if found is None or not re.search(r"\b(?:hall|corridor|kitchen|bath|kuche|flur|bad|cuisine|cocina)", found["list"]):
        return None
    rooms = [_ROOMS.search(part.strip()) for part in re.split(r" ?, ?(?:and )?| (?:and|und|et|y) ", found["list"])]
    counts = [room["n"] or "1" for room in rooms if room is not None]
    there = sum(int(n) if n.isdigit() else _numbers().get(n, 1) for n in counts)
    many = int(found["n"]) if found["n"].isdigit() else _numbers()[found["n"]]
    return (many, found["said"]) if there == many and len(counts) == len(rooms) else None
