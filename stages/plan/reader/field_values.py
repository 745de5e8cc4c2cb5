"""Keys and values of fields, taken apart: words, rooms, counts, numbers with units, furniture."""

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from apartgen.stages.plan.reader.field_names import COUNT, LIMIT, NAME, UNIT
from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.phrase import plural

_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
NUMBER = r"\d+(?:\.\d+)?"
_COUNTED = re.compile(r"(?:x ?(\d{1,2})|(\d{1,2}) ?x)")
SIDE = re.compile(
    r"(?:the )?(north|south|east|west)(?:[ -]?(east|west))?(?:(?:ern)?[ -](side|corner|end|facade|wall))?"
)
SHORT = {"n": "north", "s": "south", "e": "east", "w": "west", "ne": "north east", "nw": "north west",
          "se": "south east", "sw": "south west"}  # fmt: skip
PLACES = {"centre": "in the centre", "center": "in the centre", "middle": "in the centre", "central": "in the centre",
           "back": "at the back", "rear": "at the back", "front": "at the front", "left": "to the left of the entrance",
           "right": "to the right of the entrance", "entrance": "near the entrance", "entry": "near the entrance",
           "front door": "near the entrance"}  # fmt: skip
_YES, _NO = ("yes", "true", "required", "y"), ("no", "none", "false", "null", "0", "n", "without")


class Unclear(Exception):
    """A field that has no sentence: the prompt stays as it is."""


def words(key: Any) -> str:
    """`livingRoom`, `living_room` as words."""
    if not isinstance(key, str) or len(key) > 80:
        raise Unclear
    return " ".join(re.sub(r"[_\-]+", " ", _CAMEL.sub(" ", key)).lower().split())


@cache
def room(name: str) -> tuple[str, str] | None:
    """What `bedroom 2` or `bedrooms` is in the singular, and its number; None of what is no room."""
    name = re.sub(r"^(bed|bath)(?:room)? ([a-d])$", lambda m: f"{m[1]}room {' abcd'.index(m[2])}", name)
    found = re.fullmatch(r"(?:the )?(.+?)(?: ?#?(\d{1,2}))?", name)
    if found is None:
        return None
    name, number = found[1], found[2] or ""
    name = {"bed": "bedroom", "beds": "bedrooms", "bath": "bathroom", "baths": "bathrooms", "living": "living room",
            "dining": "dining room", "half baths": "separate toilets", "half bath": "separate toilet",
            "ensuite": "", "en suite": "", "master": "master bedroom",
            "main": "main bedroom"}.get(name, name)  # fmt: skip
    for reading in read_lexicon().entries.get(tuple(name.split()) or ("",)) or ():
        if reading.kind == "room":
            return (_singular(name) if reading.plural else name), number
    first, _, rest = name.partition(" ")
    if rest and first in ("master", "main", "guest", "kids", "children's", "first", "second", "third", "shared"):
        inner = room(rest)
        return (f"{first} {inner[0]}", number) if inner else None
    return None


def _singular(name: str) -> str:
    if name.endswith("ies"):
        return name[:-3] + "y"
    return name[:-1] if name.endswith("s") else name


def pairs_of(subject: str, value: Any) -> Iterator[tuple[str, str]]:
    if isinstance(value, dict):
        named = {words(k): v for k, v in value.items()}
        ends = [named[k] for k in ("room", "of", "from", "a", "source", "to", "b", "target", "other") if k in named]
        if len(ends) == 2 and len(named) == 2:
            yield ends[0], ends[1]
            return
        for one, others in value.items():
            yield from ((one, other) for other in (others if isinstance(others, list) else [others]))
    elif isinstance(value, list):
        for one in value:
            if isinstance(one, list) and len(one) == 2:
                yield one[0], one[1]
            elif isinstance(one, dict):
                yield from pairs_of(subject, one)
            elif subject:
                yield subject, one
            else:
                raise Unclear
    elif subject and isinstance(value, str):
        for other in re.split(r",\s*|\s+and\s+", value):
            yield subject, other
    elif isinstance(value, str) and len(ends := re.split(r"\s*(?:<?->?|,|&|\band\b|\bfrom\b|\bto\b)\s*", value)) == 2:
        yield ends[0], ends[1]
    else:
        raise Unclear


MOST = 10
"""Rooms of one type that a home may have where it is told by numbers alone."""


def as_list(value: Any) -> list[Any]:
    """One or several."""
    return value if isinstance(value, list) else [value]


def plural_of(name: str) -> str:
    return " ".join(plural(tuple(name.split())))


def thing(one: Any) -> tuple[str, int]:
    """A piece of furniture and how many of it."""
    if isinstance(one, dict):
        named = {words(k): v for k, v in one.items()}
        name = next((named[k] for k in (*NAME, "category", "item") if k in named), None)
        count = next((named[k] for k in COUNT if k in named), 1)
        return words(name), count if isinstance(count, int) else 1
    text = words(one)
    found = re.fullmatch(r"(?:(\d{1,2}) ?x? )?(?:an? )?([a-z][a-z' ]*?)(?: ?(?:x ?(\d{1,2})|\((\d{1,2})\)))?", text)
    if found is None:
        raise Unclear
    return found[2], int(found[1] or found[3] or found[4] or 1)


def is_furniture(name: str) -> bool:
    readings = read_lexicon().entries.get(tuple(name.split())) or ()
    return any(r.kind == "furniture" for r in readings)


def is_measured(key: str) -> bool:
    """`kitchen area`, though some call a kitchen so."""
    name, _, last = key.rpartition(" ")
    return last in ("area", "size", "width", "length") and name not in ("dining", "sitting") and room(name) is not None


def taken_apart(key: str) -> tuple[str, str, str]:
    """`min area m2` as an area's lower limit in m²."""
    unit = re.search(rf"(?:^| )({UNIT}|m)$", key)
    rest = key[: unit.start()].strip() if unit else key
    parts = rest.split()
    limit = next((LIMIT[p] for p in parts if p in LIMIT), "")
    bare = " ".join(p for p in parts if p not in LIMIT)
    return (bare or ("area" if unit or limit else "")), limit, (unit[1] if unit and unit[1] != "m" else "")


def limited(text: str) -> tuple[str, str | None, str]:
    """`max 12 m2` as its limit, number and unit."""
    found = re.fullmatch(
        rf"(?:(at least|at most|min(?:imum)?|max(?:imum)?|about|approx|~|ca)\.? ?)?({NUMBER}) ?({UNIT}|m)?", text
    )
    if found is None:
        return "", None, ""
    return LIMIT.get(found[1] or "", found[1] or ""), found[2], found[3] if found[3] and found[3] != "m" else ""


def whole(value: Any) -> int | None:
    """A count, however it is written; None of what is none."""
    if isinstance(value, bool):
        return int(value)
    if isinstance(value, int | float):
        return int(value) if value == int(value) and 0 <= value <= 40 else None
    text = value.strip().lower() if isinstance(value, str) else ""
    if text in _YES or text in _NO:
        return int(text in _YES)
    found = _COUNTED.fullmatch(text)
    return int(found[1] or found[2]) if found else int(text) if re.fullmatch(r"\d{1,2}", text) else None


def truth(value: Any) -> bool | None:
    number = whole(value)
    return None if number is None else bool(number)


def as_pairs(fields: Any, areas: bool) -> list[Any]:
    """Fields as pairs, or a list of rooms; `{"living_room": 28, "kitchen": 9}`, where asked, as areas, not counts."""
    pairs = list(fields.items()) if isinstance(fields, dict) else fields
    if not isinstance(pairs, list) or len(pairs) > 200:
        raise Unclear
    told = _areas(pairs) if areas and pairs and isinstance(pairs[0], tuple) else {}
    return [*([("areas", told)] if told else []), *(pair for pair in pairs if not told or pair[0] not in told)]


def _areas(pairs: list[tuple[Any, Any]]) -> dict[Any, float]:
    """Rooms with numbers, if one of these is more than any home has rooms of a type."""
    rooms = {}
    for key, value in pairs:
        number = float(value) if isinstance(value, str) and re.fullmatch(NUMBER, value) else value
        name = words(str(key))
        if isinstance(number, int | float) and not isinstance(number, bool) and not name.endswith("s"):
            if room(name) is not None:
                rooms[key] = number
    return rooms if max(rooms.values(), default=0) > MOST else {}
