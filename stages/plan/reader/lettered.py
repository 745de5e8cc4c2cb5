"""Rooms told apart by letters, `bedroom A`, `bathrooms A and B`, put into numbers."""

import re

_ROOM = r"(?:bed ?room|bath ?room|room|study|balcony|toilet|office|store ?room)"
_SAID = (
    r"(?= ?(?:[-,.;:()/=+&]|$)| (?:and|or|is|has|gets?|on|in|at|to|off|with|by|next|opposite|near|beside|behind|faces?|"
    r"facing|opens?|lies|should|must|leads?|connects?|adjoins|shares?|measures|far|from|north|south|east|west|left|"
    r"right|not|only|can|may|needs?|does|\d))"
)
"""What follows a letter that is no article."""
_MANY = re.compile(rf"\b({_ROOM})s? ([a-d])((?: ?(?:,|/|&|\+|,? and|or) ?[b-d]\b)+){_SAID}")
_ONE = re.compile(rf"\b({_ROOM}) ?[-:]? ?([a-d]){_SAID}")
_LETTERED = re.compile(rf"\b({_ROOM})s? (?:a ?(?:,|/|&|\+|,? and|or) ?)?[-:]?[b-d]{_SAID}")
_ALONE = re.compile(
    rf"(^|[,.;:(] |\b(?:to|of|by|from|near|with|and|off|opposite|beside|behind|between) )([a-d]){_SAID}"
)


def numbered(text: str) -> str:
    """A folded text with numbers for such letters, where one of them is no `a`."""
    kinds = {found[1] for found in _LETTERED.finditer(text)}
    if not kinds:
        return text
    text = _MANY.sub(lambda found: _all(found) if found[1] in kinds else found.group(), text)
    text = _ONE.sub(lambda found: f"{found[1]} {_number(found[2])}" if found[1] in kinds else found.group(), text)
    room = min(kinds)
    return _ALONE.sub(lambda found: f"{found[1]}{room} {_number(found[2])}", text) if len(kinds) == 1 else text


def _number(letter: str) -> int:
    return "abcd".index(letter) + 1


def _all(found: re.Match[str]) -> str:
    """`bedrooms a, b and c` as bedrooms 1, 2 and 3; of rooms counted before it the letters say no more."""
    if re.search(r"\b(?:\d|two|three|four) $", found.string[: found.start()]):
        return f"{found[1]}s"
    numbers = [_number(letter) for letter in re.findall(r"\b[a-d]\b", found[2] + found[3])]
    return " and ".join(f"{found[1]} {n}" for n in numbers)
