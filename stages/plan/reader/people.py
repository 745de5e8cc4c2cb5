"""What a text says of the people who live in a home, as rooms: who has a room of their own, who shares one."""

import re
from collections.abc import Callable
from dataclasses import replace

from apartgen.stages.plan.reader.about import People, numbers
from apartgen.stages.plan.reader.apiece import apiece
from apartgen.stages.plan.reader.families import (
    BEDROOMS,
    COUNTED,
    COUPLE,
    FAMILY_ROOM,
    LIVING,
    SUMMED,
    TOGETHER,
    heading,
    we_keep,
    with_ours,
)  # fmt: skip
from apartgen.stages.plan.reader.kin import ROOM, data, kind_of, number_of, pattern, rooms_for, several, value_of
from apartgen.stages.plan.reader.kinsfolk import as_kin, in_turn, told_before, told_of_all
from apartgen.stages.plan.reader.possessions import (
    SEVERAL,
    aged,
    among_counted,
    counted_for,
    equipped,
    ours,
    possessed,
    sized,
)
from apartgen.stages.plan.reader.sharing import told_again
from apartgen.stages.plan.reader.spoken_of import as_first_told, of_the_last

EVERY = ("each", "every", "jedes", "jeder", "jede", "chaque", "cada", "每个")
PAIRS = r"(?:(?:grand)?parents|(?:gross)?eltern|padres|abuelos)\b"
"""Words for two people that need no article."""
THEIR_SPOUSE = re.compile(r"(?:her|his|ihr(?:em|en)?|sein(?:e[mr]?|en)?|son|sa|su) ")
WE = re.compile(r"\b(?:we|us|our|wir|uns|unser\w*|nous|nos|nuestr\w+)\b")


def housed(text: str) -> tuple[People | None, str]:
    """People who are counted in a folded text, and the text with rooms in the place of those who are said to have one.

    Where some have rooms, others beside them have some, too; where nobody has, they are told as a household.
    """
    text = LIVING.sub("", aged(apiece(as_first_told(as_kin(text)))))
    if not any(stem in text for stem in data()["stems"]):
        return None, text
    text = we_keep(text)
    mine = "my room" if re.search(r"\bparents' bedroom|\bmy parents\b", text) else "the parents' bedroom"
    text = re.sub(r"\bour (?:own )?bedroom\b", "the parents' bedroom", re.sub(r"\bmy (?:own )?bedroom\b", mine, text))
    said, text = text, pattern("{who}(?: of (?:us|them))? {with_us}").sub("", text)
    beside = said != text
    fewer, text = told_again(text)
    if fewer is not None:
        people, text = _household(text)
        people = people and replace(people, children=max(people.children - fewer, 0))
        return people, text
    couple = COUPLE.search(text) is not None and pattern("{who}").search(COUPLE.sub("", text)) is not None
    known = text
    placed, apart = in_turn(COUPLE.sub("the couple", text) if couple else text)
    claims, claimed = _claims(placed)
    if claimed or apart:
        if beside and "parents' bedroom" not in claims and not COUNTED.search(claims):
            claims = f"{claims.rstrip(' .!')}. a parents' bedroom."  # "the baby sleeps with us, …"
        text = re.sub(r"\btheirs\b", "the kids rooms", SUMMED.sub(r"\1 in total", of_the_last(equipped(claims))))
        text = text if BEDROOMS.search(text) else FAMILY_ROOM.sub("a parents' bedroom and ", text)
        said = _others(_baths(text), told_of_all(known)) if not COUNTED.search(text) else _baths(text)
        twice = couple and said.count("a parents' bedroom") > 1
        return None, said.removesuffix(". a parents' bedroom.") if twice else said
    whole = text
    people, text = _household(text)
    return _without_sharing(people, text, whole) if people is not None else (people, text)


def _claims(text: str) -> tuple[str, bool]:
    """Rooms for `two teenagers, each wants a room`, `the twins share a room`."""
    found: list[str] = []

    def own(match: re.Match[str]) -> str:
        if match.string[: match.start()].rstrip().endswith(EVERY):
            return match.group()  # "each child has its own room", of children counted elsewhere
        if re.search(r",? an? \w+$", match.group()) and _for_them(match):
            return match.group()
        count = number_of(match) or number_of(match, "later")
        apart = bool(match["each"] or match["one"] or match["own"] or match["of"])
        found.append(match.group())
        both = match.group().startswith(("both ", "beide ")) and several(match)
        apart = apart or both
        if not count:
            count = 2 if apart and several(match) else 1
        the_one = re.search(r"\bthe (?:\w+ )?(?:bed ?)?room$|一间", match.group())
        one = not apart and (kind_of(match) == "twins" or the_one)
        rooms = rooms_for(match, count if (apart or several(match)) and not one else 1)
        rooms = sized(rooms if rooms[0].isdigit() else counted_for(match) or rooms, match["sized"])
        rooms = f"the {rooms}" if rooms[0].isdigit() and among_counted(match.string) else rooms
        return rooms + " each with its own bathroom" if match["bath"] else rooms

    def shared(match: re.Match[str]) -> str:
        found.append(match.group())
        return counted_for(match) or rooms_for(match, 1)

    def own_each(match: re.Match[str]) -> str:
        found.append(match.group())
        return rooms_for(match, number_of(match) or 2)

    def bathed(match: re.Match[str]) -> str:
        own = "own" in match["bath"] + " " or "propi" in match["bath"]
        if kind_of(match) not in ("adult", "couple") or not own:
            return match.group()
        found.append(match.group())
        return f"{rooms_for(match, 1)} with its own bathroom"

    text, each = _each_of(text)
    text, which = possessed(text)
    found += each + which
    shares = "{who}{relative}?,? ?(?:all |both |will |can )?{share} ?"
    text = pattern(shares + "{article}*{room}").sub(shared, text)
    if SEVERAL.search(text):
        text = pattern(shares + "one(?= with )").sub("one of the bedrooms", text)
        text = pattern(shares + "one(?= ?(?:[,.;]|$)| and )").sub(shared, text)
    text = pattern(
        "(?P<of>\\b(?:each|every one|all|both) of |\\bjede[rs]? (?=unserer|meiner|der )|\\bchacune? de |\\bcada "
        "un[oa] de )?{who}{relative}?,? ?(?:(?:and|they) (?={every}))?"
        "(?P<one>(?:{every}|alle|jeweils|各自?|自己|单独|独自)"
        "(?: one| of them| student| child| kid| person)? ?)?{need} ?"
        "(?P<own>(?=[^,.;]*(?:own|eigen|propr|propi|自己)))?{article}*"
        "(?P<sized>(?:small|little|large|big|tiny) )?{room}"
        "(?P<each>{each})?(?P<bath> and (?:(?:an?|their|his|her|own|private|separate) )*{bathroom}\\b)?"
        "(?:, (?:they|there) are (?P<later>{numbers})(?: of them)?)?"
    ).sub(own, text)
    text = pattern("{who}[:,] {article}{room}{each}").sub(own_each, text)
    text = pattern("{who} {need} (?P<bath>{article}+{bathroom}\\b)").sub(bathed, text)
    return (_claims_on(text, found, shared) if found else text), bool(found)


def _claims_on(text: str, found: list[str], shared: Callable[[re.Match[str]], str]) -> str:
    """Rooms of those of whom less is said where others are told to have one: `the girl has her own`, `and I a room`."""
    text = re.sub(r"\bour (?:own )?room\b", "the parents' bedroom", text)
    text = pattern("{who} {need} {hers}(?= ?(?:[,.;]|$|and ))").sub(shared, text)
    text = pattern("{who} {need} {other}(?: to (?:him|her|them)sel(?:f|ves))?"
                   "(?= ?(?:[,.;:]|$|and |with |next |near |off |of \\d))").sub(shared, text)  # fmt: skip
    text = heading(with_ours(ours(text), found))
    also = "(?:also |too |auch |aussi |tambien )?"  # "then my parents also a room, and I a room"
    gapped = pattern(f"(?:then )?{{who}},? {also}(?:an?|one|ein|une|una) (?:own )?{{room}}(?P<each>{{each}})?")
    text = gapped.sub(_gapped, text)
    return re.sub(r"\bi (?:also )?an? room\b", "another bedroom", text)


def _gapped(match: re.Match[str]) -> str:
    """A room of whose owner nothing more is said."""
    return match.group() if _for_them(match) else rooms_for(match, number_of(match) if match["each"] else 1)


def _for_them(match: re.Match[str]) -> bool:
    """`a room for my mother, a room for …`: the room behind is not hers."""
    return bool(re.search(r"\bfor (?:\w+ )?$", match.string[: match.start()]))


def _each_of(text: str) -> tuple[str, list[str]]:
    """Rooms for `my son and my daughter each get a room`, `three students live here, each has a room`."""
    found: list[str] = []

    def together(match: re.Match[str]) -> str:
        groups = list(pattern("{who}").finditer(match["all"]))
        kinds = {kind_of(one) for one in groups}
        found.append(match.group())
        if len(kinds) > 1 or kinds & {"couple", "spouse"}:
            rooms = [rooms_for(one, number_of(one) or (2 if several(one) else 1)) for one in groups]
            return " and ".join(rooms) + ", each"
        count = sum(number_of(one) or (2 if several(one) else 1) for one in groups) + bool(match["me"])
        return f"{count} {ROOM[kinds.pop()]}s"

    def apart(match: re.Match[str]) -> str:
        kind = kind_of(match)
        if kind not in ("adult", "child") or (match["mark"] == "," and not match["between"]):
            return match.group()
        found.append(match.group())
        rooms = "bedrooms" if kind == "adult" else f"{ROOM[kind]}s"
        lead = f"{match['between']}, " if re.search("room|kitchen|bath", match["between"]) else ""
        if match["me"] and kind == "child":
            return f"{lead}a parents' bedroom, {number_of(match)} {rooms}"
        return f"{lead}{number_of(match) + bool(match['me'])} {rooms}"

    group = "(?P<all>{who}(?:(?:,| and|,? und|,? et|,? y| &) {who})+),? (?:(?:will|should|must|can) )?"
    own = (
        "(?:(?:and )?(?:we )?(?:want|would like|need) )?(?:{every}|both|beide|all)(?: one)?(?: of them)? ?"
        "(?:to )?{need} ?{article}*{room}"
    )
    living = "(?P<me>\\b(?:i live (?:together )?with|vivo (?:junto )?con|ich (?:wohne|lebe) mit|je vis avec) )?"
    text = pattern(living + group + own, unnamed=True).sub(together, text)
    one = "(?:one|kind|enfant|hijo|hija|student|person|child|kid|friend|flatmate|roommate|adult|resident)"
    every = f"(?:they )?{{every}}(?: {one})?(?: of (?:them|us|you))?"
    gap = "(?P<between>[^.;:]{0,40}?)(?P<mark>[,.;:]| -) ?(?:and )?" + every + " ?{need} ?{article}*{room}"
    me = "(?P<me>\\b(?:me|myself|i|us|we) (?:and|&|plus|live with) )?"
    return pattern(me + "(?={before}*{number}){who}" + gap).sub(apart, text), found


def _others(text: str, again: bool) -> str:
    """Rooms for people beside those who have one: `two parents, a kids room`; not for children told of `again`."""

    def room(match: re.Match[str]) -> str:
        if again and told_before(match):
            return match.group()
        count = number_of(match) or (2 if several(match) else 1)
        lead = match["lead"].replace("- ", ", ")
        return f"{lead}{rooms_for(match, 1 if kind_of(match) in ('couple', 'spouse') else count)}"

    begins = "^|[:,;.-] |\\b(?:and|with|und|et|y|(?:flat|apartment|home|house|place) for) "
    ends = " ?[-,.;:]| (?:and|with|und|et|y)\\b|$"
    return pattern(f"(?P<lead>{begins})(?={{number}}|{{before}}|{PAIRS}){{who}}(?={ends})").sub(room, text)


def _baths(text: str) -> str:
    """`one bathroom for them, another for us`: whom people speak of by pronouns have rooms."""
    ours = "ours|(?:our|my) (?:own )?bedroom|unser(?:em|en)? schlafzimmer|notre chambre|nuestro dormitorio"
    text = re.sub(rf"\b(?:{ours})\b", "the parents' bedroom", text)
    bath = r"((?:bath(?:room)?|shower room|toilet|another|other|one) for)"
    text = re.sub(rf"{bath} (?:us|ourselves)\b", r"\1 the parents' bedroom", text)
    return re.sub(rf"{bath} (?:them|the (?:kids|children|boys|girls|teenagers))\b", r"\1 the kids rooms", text)


def _household(text: str) -> tuple[People | None, str]:
    """`me, my wife and our two kids`; a single group is told by `about` alone, or is a family's children."""
    who = "{self}|{who}|{family}"
    joint = ("(?:(?<=\\bi) live with | (?:also |still |now )?lives? with |,? (?:and|with|plus|und|mit|et|avec|y|con) |"
             ", | ?[&+] |和|带)")  # fmt: skip
    run = pattern(rf"(?:\b(?:for|of|fur|pour|para) )?(?:{who})(?:{joint}(?:{who}))+", unnamed=True)
    found = run.search(text)
    if found is None or COUNTED.search(text):
        return None, text
    groups = [m for m in pattern("{self}|{family}|{who}").finditer(found.group())]
    people = _sum(groups)
    if people.children and not people.pairs and WE.search(text):
        people = replace(people, pairs=1)
    if people.count < 2 or len(groups) < 2:
        return None, text
    return people, text[: found.start()] + text[found.end() :]


def _sum(groups: list[re.Match[str]]) -> People:
    coupled, groups = _couples(groups)
    pairs, singles, children = coupled, 0, 0
    kinds = [kind_of(match) for match in groups]
    for kind, match in zip(kinds, groups, strict=True):
        if match.groupdict().get("family"):
            pairs, children = pairs + 1, children + max(value_of(match["family"]) - 2, 0)
            continue
        count = number_of(match) if match.groupdict().get("n") else 2 if several(match) else 1
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


def _couples(groups: list[re.Match[str]]) -> tuple[int, list[re.Match[str]]]:
    """How many are `my sister and her husband`, and the others."""
    pairs = [(k, groups[k - 1], groups[k]) for k in range(1, len(groups))]
    theirs = [k for k, one, other in pairs if kind_of(other) == "spouse" and THEIR_SPOUSE.match(other.group())
              and kind_of(one) in ("adult", "child") and not several(one)]  # fmt: skip
    gone = {j for k in theirs for j in (k - 1, k)}
    return len(theirs), [match for k, match in enumerate(groups) if k not in gone]


def _without_sharing(people: People, text: str, whole: str) -> tuple[People, str]:
    """`the two small ones share a room`, `the eldest has her own`, of people counted before."""
    some = "{before}?(?P<n>{numbers}) (?:of (?:them|the kids|the children) )?(?:\\w+ )?"
    shared = pattern(some + "{share} ?{article}*{room}?", unnamed=True).search(text)
    if shared is not None:
        fewer = value_of(shared["n"]) - 1
        people = People(people.pairs, people.singles, max(people.children - fewer, 0))
        text = text[: shared.start()] + text[shared.end() :]
    they = pattern(
        "\\b(?:they|who|sie|ils|elles|ellos|ellas|die|qui|que) (?:both |all |will |can )?{share} ?{article}*{room}"
    ).search(text)
    if they is not None and people.children > 1:
        people = replace(people, children=1)
        text = text[: they.start()] + text[they.end() :]
    together = TOGETHER.search(text)
    if together is not None and people.children > 1:
        words = "|".join(sorted(numbers(), key=len, reverse=True))
        told = re.search(rf"\b({words}|\d) {together[1].rstrip('s')}", whole)
        fewer = value_of(told[1]) - 1 if told else 1
        people = replace(people, children=max(people.children - fewer, 1))
        text = text[: together.start()] + text[together.end() :]
    own = pattern(
        "{before}(?:\\w+ )?(?:\\w+ )?{need} {hers}|\\b(?:i|we) {need} (?:my|our) own(?: {room})?(?= ?(?:[.,;]|$))",
        unnamed=True,
    )
    each = pattern("(?:{every} (?:of (?:the |my |our )?)?(?:\\w+ )?(?:{need}|with|in) ?{article}*{room})")
    return people, each.sub("", own.sub("", text))
