"""Which furniture a name speaks of."""

import re
from functools import cache

from apartgen.stages.things.categories import by_word, labelled

OTHER = "other"
"""Category of what the furniture vocabulary has no word for."""

NO_FURNITURE = (
    "kitchen cabinet upper corner", "pillow", "books", "doorway", "wall", "stairs", "floor", "door", "window", "kettle",
    "backwall", "light buttons", "lightbuttons",
)
"""What model files are called that are none."""


def split(name: str) -> list[str]:
    """Lower-case words of a file or model name: `loungeSofa_02` gives lounge, sofa."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return [word.lower() for word in re.split(r"[^A-Za-z]+", spaced) if word]


@cache
def _known() -> dict[str, str]:
    named = {label: kinds[0] for label, kinds in labelled("files").items()}
    return by_word() | named | dict.fromkeys(NO_FURNITURE, OTHER)


def category(name: str) -> str:
    """Category of a name: its longest known run of words, the earliest of equals; `other` without one."""
    words = split(name)
    for length in range(len(words), 0, -1):
        for start in range(len(words) - length + 1):
            run = " ".join(words[start : start + length])
            for word in (run, run.removesuffix("s")):
                if word in _known():
                    return _known()[word]
    return OTHER
