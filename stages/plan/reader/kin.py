"""Words for people: what is found of them in a text, how many they are, what their rooms are called."""

import re
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.patterns import Late

ROOM = {"child": "kids room", "twins": "kids room", "adult": "relative's room", "couple": "parents' bedroom",
        "spouse": "parents' bedroom"}  # fmt: skip
"""What the room of such people is called in the lexicon."""

ELDERS = re.compile(r"grand|gross|in-laws|abuelos")
"""Of couples, those whose home it is not."""
PLURALS = ("s", "children", "kinder", "kindern", "sohne", "teenager", "madchen")


def rooms_for(match: re.Match[str], count: int) -> str:
    kind = kind_of(match)
    if kind == "couple" and ELDERS.match(match["couple"]):
        return f"a {ROOM['adult']}"
    if kind in ("couple", "spouse"):
        return f"a {ROOM[kind]}"
    return f"a {ROOM[kind]}" if count == 1 else f"{count} {ROOM[kind]}s"


def kind_of(match: re.Match[str]) -> str:
    return next((kind for kind in data()["nouns"] if match.groupdict().get(kind)), "self")


def number_of(match: re.Match[str], group: str = "n") -> int:
    said = match.groupdict().get(group)
    return value_of(said) if said else 2 if match.groupdict().get("twins") else 0


def value_of(said: str) -> int:
    return int(said) if said.isdigit() else numbers()[said]


def several(match: re.Match[str]) -> bool:
    noun = match.groupdict().get(kind_of(match)) or ""
    return noun.endswith(PLURALS) or kind_of(match) == "twins"


@cache
def data() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "people.toml").read_text(encoding="utf-8"))


@cache
def pattern(text: str, unnamed: bool = False) -> Late:
    """A pattern with the words of `people.toml` in the place of their names."""
    return Late(text, _words(unnamed))


@cache
def _words(unnamed: bool) -> dict[str, str]:
    """Parts of patterns by their names; `unnamed` ones may stand in a pattern twice."""
    words = dict(data()["words"])
    words["numbers"] = r"\d+|" + "|".join(sorted(numbers(), key=len, reverse=True))
    count = rf"(?P<n>{words['numbers']})" if not unnamed else rf"(?:{words['numbers']})"
    nouns = "|".join(
        f"({'?:' if unnamed else f'?P<{kind}>'}{'|'.join(of_kind)})" for kind, of_kind in data()["nouns"].items()
    )
    modified = rf"(?:{words['before']})*(?:{count} ?)?(?:{words['adjective']})*"
    words["number"] = rf"(?:{words['numbers']})\b"
    words["who"] = rf"(?<![a-z']){modified}(?:{nouns})(?![a-z'])(?! ?(?:bed|bath|room|suite|bunk))"
    members = rf"(?P<family>{words['numbers']})" if not unnamed else rf"(?:{words['numbers']})"
    family = "(?:family of|famille de|familie von|familia de)"
    words["family"] = rf"\b(?:the |our |my |an? |eine |une |una )?{family} {members}\b"
    words["self"] = r"\b(?:me|myself|us|we|i|mich|mir|uns|ich|moi|nous|yo|nosotros)\b"
    return words
