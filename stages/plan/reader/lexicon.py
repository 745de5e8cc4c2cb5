"""The lexicon: phrases of several languages, each with a kind and a value; the data is `lexicon/*.toml`."""

import itertools
import re
import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from stages.categories import by_word
from stages.plan.reader.tokens import fold, tokenize

Phrase = tuple[str, ...]

NOUNS = ("room", "dwelling", "furniture", "main_rooms")
PRIORITY = (
    "room", "dwelling", "number", "fraction", "ordinal", "determiner", "negation", "link", "compare", "with",
    "reach", "relative", "front", "boundary", "label", "size", "unit", "area_word", "conjunction", "pronoun",
    "only", "style", "shape", "side_role", "side", "furniture", "furniture_count", "graph", "main_rooms",
    "compound", "sum", "adjective", "stop",
)  # fmt: skip
"""Which reading of a phrase of the same length comes first."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One reading of a phrase. `plural` is set for nouns in their plural form."""

    kind: str
    value: str
    plural: bool = False


@dataclass(frozen=True)
class Lexicon:
    """All readings of every phrase, `longest` words at most; `words` are those worth a spelling correction."""

    entries: dict[Phrase, tuple[Entry, ...]]
    also_object: dict[str, str]
    suffixes: dict[str, Entry]
    words: frozenset[str]
    longest: int


def expand(pattern: str) -> list[str]:
    """`{a,b} c` → `a c`, `b c`."""
    parts = re.split(r"(\{[^}]*\})", pattern)
    options = [p[1:-1].split(",") if p.startswith("{") else [p] for p in parts]
    return [" ".join("".join(choice).split()) for choice in itertools.product(*options)]


def phrase(text: str) -> Phrase:
    """The words of a phrase, without hyphens."""
    return tuple(t.text for t in tokenize(fold(text)) if t.text != "-")


def plural(words: Phrase) -> Phrase:
    """English plural of the last word."""
    *head, last = words
    if re.search(r"[^aeiou]y$", last):
        many = last[:-1] + "ies"
    elif last.endswith("shelf"):
        many = last[:-1] + "ves"
    elif re.search(r"(s|x|ch|sh)$", last):
        many = last + "es"
    else:
        many = last + "s"
    return (*head, many)


@cache
def load() -> Lexicon:
    """Read every language file once."""
    found: dict[Phrase, dict[str, Entry]] = {}
    also_object: dict[str, str] = {}
    suffixes: dict[str, Entry] = {}
    for file in sorted((Path(__file__).parent / "lexicon").glob("*.toml")):
        table = tomllib.loads(file.read_text(encoding="utf-8"))
        also_object |= table.pop("also_object", {})
        for name, ends in table.pop("suffix", {}).items():
            suffixes |= {end: Entry(*name.split("/")) for end in ends}
        for kind, group in table.items():
            _add_group(found, kind, group)
    _add_group(found, "furniture", _furniture())
    ranked = {p: tuple(sorted(es.values(), key=lambda e: PRIORITY.index(e.kind))) for p, es in found.items()}
    words = frozenset(
        w for p, es in ranked.items() if es[0].kind not in ("stop", "reach") for w in p if len(w) >= 5 and w.isascii()
    )
    return Lexicon(ranked, also_object, suffixes, words, max(map(len, ranked)))


def _add_group(found: dict[Phrase, dict[str, Entry]], kind: str, group: dict[str, list[str]]) -> None:
    for value, patterns in group.items():
        for text in itertools.chain.from_iterable(expand(p) for p in patterns):
            words = phrase(text)
            _add(found, words, Entry(kind, value))
            if kind in NOUNS and words[-1].isascii():
                _add(found, plural(words), Entry(kind, value, plural=True))


def _add(found: dict[Phrase, dict[str, Entry]], words: Phrase, entry: Entry) -> None:
    found.setdefault(words, {}).setdefault(entry.kind, entry)


def _furniture() -> dict[str, list[str]]:
    words: dict[str, list[str]] = {}
    for word, category in sorted(by_word().items()):
        words.setdefault(category, []).append(word)
    return words
