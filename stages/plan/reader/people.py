"""What a text says of the people who live in a home, as rooms: who has a room of their own, who shares one."""

import re
import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from apartgen.stages.plan.reader.about import People, numbers
from apartgen.stages.plan.reader.patterns import Late

ROOM = {"child": "kids room", "twins": "kids room", "adult": "relative's room", "couple": "parents' bedroom",
        "spouse": "parents' bedroom"}  # fmt: skip
"""What the room of such people is called in the lexicon."""
EVERY = ("each", "every", "jedes", "jeder", "jede", "chaque", "cada", "每个")
PLURALS = ("s", "children", "kinder", "kindern", "sohne", "teenager", "madchen")
WE = re.compile(r"\b(?:we|us|our|wir|uns|unser\w*|nous|nos|nuestr\w+)\b")
COUNTED = re.compile(r"(?:\b\d|one|two|three|four|five|six|[一两二三四五])[ -]?(?:bed|br\b|居室|室)")
"""A number of bedrooms, beside which people have no further rooms."""


def housed(text: str) -> tuple[People | None, str]:
    """People who are counted in a folded text, and the text with rooms in the place of those who are said to have one.

    Where some have rooms, others beside them have some, too; where nobody has, they are told as a household.
    """
    if not any(stem in text for stem in _data()["stems"]):
        return None, text
    text = re.sub(r"\b(?:ours|mine)\b", "the parents' bedroom", re.sub(r" - (?=(?:ours|mine)\b)", ", ", text))
    text = re.sub(r"\b(?:our|my) (?:own )?bedroom\b", "the parents' bedroom", text)
    text = _pattern("{who}(?: of (?:us|them))? {with_us}").sub("", text)
    fewer, text = _told_again(text)
    if fewer is not None:
        people, text = _household(text)
        people = people and replace(people, children=max(people.children - fewer, 0))
        return people, text
    text, claimed = _claims(_placed(text))
    if claimed:
        return None, _others(_baths(text)) if not COUNTED.search(text) else _baths(text)
    people, text = _household(text)
    return _without_sharing(people, text) if people is not None else (people, text)


def _told_again(text: str) -> tuple[int | None, str]:
    """`two daughters and a son; the daughters share a room`: so many rooms fewer, None where nobody is told again."""
    fewer: list[int] = []

    def shared(match: re.Match[str]) -> str:
        noun = (match.groupdict().get(_kind(match)) or "").removesuffix("s")
        counted = re.search(rf"\b({words}) (?:\w+ )?{noun}", text) if noun and not match["n"] else None
        if counted is None:
            return match.group()
        fewer.append(_value(counted[1]) - 1)
        return ""

    words = r"\d+|" + "|".join(numbers())
    out = _pattern("{who}{relative}? ?(?:will |can |must )?{share} ?{article}*{room}").sub(shared, text)
    alone = _pattern("{who} (?:is |sleeps |schlaft )?(?:alone|allein|seule?|sol[oa])")
    return (sum(fewer), alone.sub("", out)) if fewer else (None, text)


def _placed(text: str) -> str:
    """`two boys in one room, the girl in another, us in a third` as rooms that these people have."""
    first = _pattern("{who} in {article}*{room}").search(text)
    if first is None:
        return text
    other = "in (?:another|the other|a (?:second|third|fourth)|{article}+)(?: one| room| bedroom)?(?=[,.;]|$| and)"
    text = _pattern("{self} " + other).sub("a parents' bedroom", text)
    text = _pattern("{who} " + other).sub(lambda match: _rooms(match, 1), text)
    return _pattern("{who} in {article}*{room}").sub(lambda match: _rooms(match, 1), text)


def _claims(text: str) -> tuple[str, bool]:
    """Rooms for `two teenagers, each wants a room`, `the twins share a room`."""
    found: list[str] = []

    def own(match: re.Match[str]) -> str:
        if match.string[: match.start()].rstrip().endswith(EVERY):
            return match.group()  # "each child has its own room", of children counted elsewhere
        count = _number(match) or _number(match, "later")
        apart = bool(match["each"] or match["one"] or match["own"])
        found.append(match.group())
        if not count:
            count = 2 if apart and _plural(match) else 1
        rooms = _rooms(match, count if apart or _plural(match) else 1)
        return rooms + " each with its own bathroom" if match["bath"] else rooms

    def shared(match: re.Match[str]) -> str:
        found.append(match.group())
        return _rooms(match, 1)

    def own_each(match: re.Match[str]) -> str:
        found.append(match.group())
        return _rooms(match, _number(match) or 2)

    def bathed(match: re.Match[str]) -> str:
        if _kind(match) not in ("adult", "couple") or "own" not in match["bath"] + " " and "propi" not in match["bath"]:
            return match.group()
        found.append(match.group())
        return f"{_rooms(match, 1)} with its own bathroom"

    text = _pattern("{who}{relative}?,? ?(?:all |both |will |can )?{share} ?{article}*{room}").sub(shared, text)
    text = _pattern(
        "{who}{relative}?,? ?(?P<one>(?:{every}|alle|jeweils|各)(?: one| of them)? ?)?{need} ?"
        "(?P<own>(?=[^,.;]*(?:own|eigen|propr|propi|自己)))?{article}*{room}"
        "(?P<each>{each})?(?P<bath> and (?:a )?{bathroom}\\b)?"
        "(?:, (?:they|there) are (?P<later>{numbers})(?: of them)?)?"
    ).sub(own, text)
    text = _pattern("{who}[:,] {article}{room}{each}").sub(own_each, text)
    text = _pattern("{who} {need} (?P<bath>{article}+{bathroom}\\b)").sub(bathed, text)
    if found:  # "then my parents also a room, and I a room"
        also = "(?:also |too |auch |aussi |tambien )?"
        gapped = _pattern(f"(?:then )?{{who}},? {also}(?:an?|one|ein|une|una) (?:own )?{{room}}(?P<each>{{each}})?")
        text = gapped.sub(lambda match: _rooms(match, _number(match) if match["each"] else 1), text)
        text = re.sub(r"\bi (?:also )?an? room\b", "another bedroom", text)
    return text, bool(found)


def _rooms(match: re.Match[str], count: int) -> str:
    kind = _kind(match)
    if kind in ("couple", "spouse"):
        return f"a {ROOM[kind]}"
    return f"a {ROOM[kind]}" if count == 1 else f"{count} {ROOM[kind]}s"


def _others(text: str) -> str:
    """Rooms for people beside those who have one: `two parents, a kids room`."""

    def room(match: re.Match[str]) -> str:
        count = _number(match) or (2 if _plural(match) else 1)
        lead = match["lead"].replace("- ", ", ")
        return f"{lead}{_rooms(match, 1 if _kind(match) in ('couple', 'spouse') else count)}"

    begins, ends = "^|[:,;.-] |\\b(?:and|with|und|et|y) ", " ?[-,.;:]| (?:and|with|und|et|y)\\b|$"
    return _pattern(f"(?P<lead>{begins})(?={{number}}|{{before}}){{who}}(?={ends})").sub(room, text)


def _baths(text: str) -> str:
    """`one bathroom for them, another for us`: whom people speak of by pronouns have rooms."""
    ours = "ours|(?:our|my) (?:own )?bedroom|unser(?:em|en)? schlafzimmer|notre chambre|nuestro dormitorio"
    text = re.sub(rf"\b(?:{ours})\b", "the parents' bedroom", text)
    bath = r"((?:bath(?:room)?|shower room|toilet|another|other|one) for)"
    text = re.sub(rf"{bath} (?:us|ourselves)\b", r"\1 the parents' bedroom", text)
    return re.sub(rf"{bath} (?:them|the (?:kids|children|boys|girls|teenagers))\b", r"\1 the kids rooms", text)


def _household(text: str) -> tuple[People | None, str]:
    """`me, my wife and our two kids`; a single group is told by `about` alone, or is a family's children."""
    who = "{self}|{who}"
    joint = "(?:,? (?:and|with|plus|und|mit|et|avec|y|con) |, | ?& |和|带)"
    run = _pattern(rf"(?:\b(?:for|of|fur|pour|para) )?(?:{who})(?:{joint}(?:{who}))+", unnamed=True)
    found = run.search(text)
    if found is None or COUNTED.search(text):
        return None, text
    groups = [m for m in _pattern("{self}|{who}").finditer(found.group())]
    people = _sum(groups)
    if people.children and not people.pairs and WE.search(text):
        people = replace(people, pairs=1)
    if people.count < 2 or len(groups) < 2:
        return None, text
    return people, text[: found.start()] + text[found.end() :]


def _sum(groups: list[re.Match[str]]) -> People:
    pairs = singles = children = 0
    kinds = [_kind(match) for match in groups]
    for kind, match in zip(kinds, groups, strict=True):
        count = _number(match) if match.groupdict().get("n") else 2 if _plural(match) else 1
        if kind in ("child", "twins"):
            children += count
        elif kind in ("couple", "spouse") or (kind == "adult" and count == 2 and "adult" in match.group()):
            pairs += 1
        elif kind == "adult":
            singles += count
        elif match.group().strip() in ("us", "we", "uns", "nous", "nosotros"):
            pairs += "spouse" not in kinds
        else:
            singles += "spouse" not in kinds  # "me and my wife" are a pair
    return People(pairs=pairs, singles=singles, children=children)


def _without_sharing(people: People, text: str) -> tuple[People, str]:
    """`the two small ones share a room`, `the eldest has her own`, of people counted before."""
    some = "{before}?(?P<n>{numbers}) (?:of (?:them|the kids|the children) )?(?:\\w+ )?"
    shared = _pattern(some + "{share} ?{article}*{room}?", unnamed=True).search(text)
    if shared is not None:
        fewer = _value(shared["n"]) - 1
        people = People(people.pairs, people.singles, max(people.children - fewer, 0))
        text = text[: shared.start()] + text[shared.end() :]
    own = _pattern("{before}(?:\\w+ )?(?:\\w+ )?{need} {hers}", unnamed=True)
    each = _pattern("(?:{every} (?:of (?:the |my |our )?)?(?:\\w+ )?(?:{need}|with|in) ?{article}*{room})")
    return people, each.sub("", own.sub("", text))


def _kind(match: re.Match[str]) -> str:
    return next((kind for kind in _data()["nouns"] if match.groupdict().get(kind)), "self")


def _number(match: re.Match[str], group: str = "n") -> int:
    said = match.groupdict().get(group)
    return _value(said) if said else 2 if match.groupdict().get("twins") else 0


def _value(said: str) -> int:
    return int(said) if said.isdigit() else numbers()[said]


def _plural(match: re.Match[str]) -> bool:
    noun = match.groupdict().get(_kind(match)) or ""
    return noun.endswith(PLURALS) or _kind(match) == "twins"


@cache
def _data() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "people.toml").read_text(encoding="utf-8"))


@cache
def _pattern(text: str, unnamed: bool = False) -> Late:
    """A pattern with the words of `people.toml` in the place of their names."""
    return Late(text, _words(unnamed))


@cache
def _words(unnamed: bool) -> dict[str, str]:
    """Parts of patterns by their names; `unnamed` ones may stand in a pattern twice."""
    words = dict(_data()["words"])
    words["numbers"] = r"\d+|" + "|".join(sorted(numbers(), key=len, reverse=True))
    count = rf"(?P<n>{words['numbers']})" if not unnamed else rf"(?:{words['numbers']})"
    nouns = "|".join(
        f"({'?:' if unnamed else f'?P<{kind}>'}{'|'.join(of_kind)})" for kind, of_kind in _data()["nouns"].items()
    )
    modified = rf"(?:{words['before']})*(?:{count} ?)?(?:{words['adjective']})*"
    words["number"] = rf"(?:{words['numbers']})\b"
    words["who"] = rf"(?<![a-z']){modified}(?:{nouns})(?![a-z'])(?! ?(?:bed|bath|room|suite|bunk))"
    words["self"] = r"\b(?:me|myself|us|we|i|mich|mir|uns|ich|moi|nous|yo|nosotros)\b"
    return words
