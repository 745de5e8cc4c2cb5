"""Rooms told apart by letters, `bedroom A`, or by numbers alone, `1 and 2 have balconies`, as `bedroom 1`."""

import re

from apartgen.stages.plan.reader.itemized import LABEL

_ROOM = r"(?:bed ?room|bath ?room|room|study|balcony|toilet|office|store ?room)"
_SAID = (
    r"(?= ?(?:[-,.;:()/=+&]|$)| (?:and|or|is|has|gets?|on|in|at|to|off|with|by|next|opposite|near|beside|behind|faces?|"
    r"facing|opens?|lies|should|must|leads?|connects?|adjoins|shares?|measures|far|from|north|south|east|west|left|"
    r"right|twice|not|only|can|may|needs?|does|\d))"
)
"""What follows a letter that is no article."""
_MANY = re.compile(rf"\b({_ROOM})(?:s?|s[,:](?= a\b)) ([a-d])((?: ?(?:,|/|&|\+|,? and|or) ?[b-d]\b)+){_SAID}")
_ONE = re.compile(rf"\b({_ROOM}) ?[-:]? ?([a-d]){_SAID}")
_LETTERED = re.compile(rf"\b({_ROOM})(?:s?|s[,:](?= a\b)) (?:a ?(?:,|/|&|\+|,? and|or) ?)?[-:]?[b-d]{_SAID}")
_ALONE = re.compile(
    rf"(^|[,.;:(] |\b(?:to|of|which|by|from|near|with|and|off|opposite|beside|behind|between) )([a-d]){_SAID}"
)
_COUNTED = re.compile(r"\b([2-6]|two|three|four|five|six) ((?:bed|bath) ?room)s\b")
_COUNTS = {"two": 2, "three": 3, "four": 4, "five": 5, "six": 6}
_SIGNED = re.compile(rf"(?:\b(?:no|nos|nr|number|numbers)\b\.? ?|#)([1-6])(?: ?(?:and|&) ?([1-6]))?{_SAID}")
_LABELLED = re.compile(rf"\b{LABEL} $")
_ONE_DOES = r"(?! is (?:enough|fine|plenty|ok|too)\b)(?= (?:has|gets|is|shares|uses|faces|needs|opens|should|must)\b)"
_TWO_DO = r"(?= (?:both |all )?(?:have|get|are|share|use|face|need|open|should|must)\b)"
_BARE = re.compile(
    rf"(?:(?<=[-,.;:] )|(?<=and ))(?<!\d, )(?<!\d and )([1-6])(?: (?:and|&) ([1-6]){_TWO_DO}|{_ONE_DOES})"
)


def numbered(text: str) -> str:
    """A folded text with numbers for such letters, where one of them is no `a`, and rooms before numbers alone."""
    text = _with_rooms(text)
    kinds = {found[1] for found in _LETTERED.finditer(text)}
    if not kinds:
        return text
    text = _MANY.sub(lambda found: _all(found) if found[1] in kinds else found.group(), text)
    text = _ONE.sub(lambda found: f"{found[1]} {_number(found[2])}" if found[1] in kinds else found.group(), text)
    room = min(kinds)
    return _ALONE.sub(lambda found: f"{found[1]}{room} {_number(found[2])}", text) if len(kinds) == 1 else text


def _with_rooms(text: str) -> str:
    """`four bedrooms: 1 and 2 have balconies, no. 3 faces south`: which of those counted are meant."""
    counted = _COUNTED.search(text)
    if counted is None:
        return text
    count = _COUNTS.get(counted[1]) or int(counted[1])

    def named(found: re.Match[str]) -> str:
        several = found[2] is not None
        if max(int(n) for n in found.groups() if n) > count or _LABELLED.search(found.string[: found.start()]):
            return found.group()  # "requirement #1"
        return f"{counted[2]}s {found[1]} and {found[2]}" if several else f"{counted[2]} {found[1]}"

    text = _SIGNED.sub(named, text)
    alone = [found for found in _BARE.finditer(text) if found.start() > counted.end()]
    told = any(found[2] or int(found[1]) > 1 for found in alone)  # "2 has …" counts nothing
    return text[: counted.end()] + _BARE.sub(named, text[counted.end() :]) if told else text


def _number(letter: str) -> int:
    return "abcd".index(letter) + 1


def _all(found: re.Match[str]) -> str:
    """`bedrooms a, b and c` as bedrooms 1, 2 and 3; of rooms counted before it the letters say no more."""
    if re.search(r"\b(?:\d|two|three|four) $", found.string[: found.start()]):
        return f"{found[1]}s"
    numbers = [_number(letter) for letter in re.findall(r"\b[a-d]\b", found[2] + found[3])]
    return " and ".join(f"{found[1]} {n}" for n in numbers)
