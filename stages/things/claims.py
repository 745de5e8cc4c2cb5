"""What newcomers claim that is not theirs to have: words that are spoken for, symbols that nobody draws."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from apartgen.schemas.errors import near

if TYPE_CHECKING:
    from apartgen.stages.things.categories import Category


def amiss(found: "Mapping[str, Category]", known: "Mapping[str, Category]") -> Iterator[str]:
    """What is wrong with categories that can do without it, in words."""
    symbols = sorted({kind.symbol for kind in known.values()} - {""})
    for kind in found.values():
        if kind.symbol not in ("", *symbols):
            yield f"[{kind.name}] symbol: nothing is drawn for {kind.symbol!r}; {near(kind.symbol, symbols)}"
    for name, word in taken_words(found, known):
        yield f"[{name}] synonyms: {word!r} is said of another category; left out"


def taken_words(found: "Mapping[str, Category]", known: "Mapping[str, Category]") -> list[tuple[str, str]]:
    """Categories and those of their words that others there are called by already."""
    taken = {word.lower() for kind in known.values() for word in (kind.name.replace("_", " "), *kind.synonyms)}
    return [(name, word) for name, kind in found.items() for word in kind.synonyms if word.lower() in taken]
