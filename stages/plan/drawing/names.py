"""What type of room a name speaks of, in any language that the reader of prompts knows, or as drawings shorten it."""

import re
import tomllib
from functools import cache
from pathlib import Path
from typing import NamedTuple

from apartgen.schemas.rooms import kinds
from apartgen.stages.plan.reader.lexemes import lexemes
from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.tokens import fold, tokenize

OUTSIDE = "outside"
"""What labels call places out of doors."""
_ID = re.compile(r"([a-z][a-z_]*)[ _](\d{1,3})")


class Named(NamedTuple):
    """A type of room, and its number where the name has one."""

    type: str
    number: int | None = None


@cache
def _labels() -> dict[str, str]:
    table = tomllib.loads((Path(__file__).parent / "labels.toml").read_text(encoding="utf-8"))
    return {fold(label): type for type, labels in table.items() for label in labels}


def read(name: str) -> Named | None:
    """The type of room; None for a name that speaks of none."""
    plain = " ".join(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).split())
    if (own := _ID.fullmatch(plain.lower().replace("-", "_"))) and (type := own[1].replace(" ", "_")) in kinds():
        return Named(type, int(own[2]))
    words = [*re.split(r"[\s/,;+&()]+", fold(plain)), fold(name.strip())]
    labelled = [_labels()[word.rstrip(".")] for word in words if word.rstrip(".") in _labels()]
    found = _known(plain)
    return Named(found or labelled[0]) if found or labelled else None


def is_outside(name: str) -> bool:
    """Whether a name is that of a place out of doors, which is no room."""
    found = read(name)
    return found is not None and found.type == OUTSIDE


def _known(name: str) -> str | None:
    """The first room that the reader of prompts finds in a name, of those that say most."""
    if fold(name).strip() in _labels():
        return None
    read = [lexeme for lexeme in lexemes(tokenize(fold(name)), read_lexicon())]
    rooms = [lexeme.value for lexeme in read if lexeme.kind == "room"]
    rooms += [entry.value for lexeme in read if (entry := lexeme.reading("room"))]
    return rooms[0].partition(":")[0] if rooms else None
