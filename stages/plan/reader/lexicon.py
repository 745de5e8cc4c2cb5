"""The lexicon: phrases of several languages, each with a kind and a value; the data is `lexicon/*.toml`."""

import itertools
import re
import tomllib
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.rooms import kinds
from apartgen.stages.plan.reader.tokens import fold, tokenize
from apartgen.stages.things.categories import by_word

Phrase = tuple[str, ...]

NOUNS = ("room", "dwelling", "furniture", "main_rooms")
PRIORITY = (
    "room", "dwelling", "number", "fraction", "ordinal", "determiner", "negation", "link", "compare", "with",
    "reach", "relative", "front", "boundary", "label", "size", "unit", "area_word", "conjunction", "pronoun",
    "only", "style", "shape", "side_role", "side", "beside", "place", "bound", "use",
    "furniture", "furniture_count", "graph", "main_rooms",
    "compound", "sum", "give", "adjective", "stop",
)  # fmt: skip
"""Which reading of a phrase of the same length comes first."""

_RANK = {kind: k for k, kind in enumerate(PRIORITY)}
_PLAIN = re.compile(r"[a-z -]+")


@dataclass(frozen=True, slots=True)
class Entry:
    """One reading of a phrase. `plural` is set for nouns in their plural form."""

    kind: str
    value: str
    plural: bool = False


@dataclass(frozen=True)
class Lexicon:
    """All readings of every phrase, `longest` words at most."""

    entries: dict[Phrase, tuple[Entry, ...]]
    also_object: dict[str, str]
    suffixes: dict[str, Entry]
    longest: int

    @cached_property
    def words(self) -> frozenset[str]:
        """Words worth a spelling correction; most prompts never ask for them."""
        return frozenset(
            w
            for p, es in self.entries.items()
            if es[0].kind not in ("stop", "reach")
            for w in p
            if len(w) >= 5 and w.isascii() and not w.endswith("rm")  # an abbreviation is nobody's slip
        )


def expand(pattern: str) -> list[str]:
    """`{a,b} c` → `a c`, `b c`."""
    if "{" not in pattern:
        return [pattern]
    parts = re.split(r"(\{[^}]*\})", pattern)
    options = [p[1:-1].split(",") if p.startswith("{") else [p] for p in parts]
    return [" ".join("".join(choice).split()) for choice in itertools.product(*options)]


def phrase(text: str) -> Phrase:
    """The words of a phrase, without hyphens."""
    if _PLAIN.fullmatch(text):  # as tokens would be, without their cost: a process's first sentence waits for this
        return tuple(text.replace("-", " ").split())
    return tuple(t.text for t in tokenize(fold(text)) if t.text != "-")


def plural(words: Phrase) -> Phrase:
    """English plural of the last word."""
    *head, last = words
    if last.endswith("y") and last[-2:-1] not in "aeiou":
        many = last[:-1] + "ies"
    elif last.endswith("shelf"):
        many = last[:-1] + "ves"
    elif last.endswith(("s", "x", "ch", "sh")):
        many = last + "es"
    else:
        many = last + "s"
    return (*head, many)


@cache
def read_lexicon() -> Lexicon:
    """Read every language file once."""
    found: dict[Phrase, dict[str, Entry]] = {}
    also_object: dict[str, str] = {}
    suffixes: dict[str, Entry] = {}
    _add_group(found, "room", _newcomers())
    for file in sorted((Path(__file__).parent / "lexicon").glob("*.toml")):
        table = tomllib.loads(file.read_text(encoding="utf-8"))
        also_object |= table.pop("also_object", {})
        for name, ends in table.pop("suffix", {}).items():
            suffixes |= {end: Entry(*name.split("/")) for end in ends}
        for kind, group in table.items():
            _add_group(found, kind, group)
    _add_group(found, "furniture", _furniture())
    ranked = {p: tuple(es.values() if len(es) == 1 else sorted(es.values(), key=_rank)) for p, es in found.items()}
    return Lexicon(ranked, also_object, suffixes, max(map(len, ranked)))


def _rank(entry: Entry) -> int:
    return _RANK[entry.kind]


def _add_group(found: dict[Phrase, dict[str, Entry]], kind: str, group: dict[str, list[str]]) -> None:
    for value, patterns in group.items():
        one, several = Entry(kind, value), Entry(kind, value, plural=True)
        for text in itertools.chain.from_iterable(map(expand, patterns)):
            words = phrase(text)
            found.setdefault(words, {}).setdefault(kind, one)
            if kind in NOUNS and words[-1].isascii():
                found.setdefault(plural(words), {}).setdefault(kind, several)


def _newcomers() -> dict[str, list[str]]:
    """Words for the types of room that do not always exist; these come before others of the same words."""
    return {name: [name.replace("_", " "), *kind.words] for name, kind in kinds().items() if name not in ROOM_TYPES}


def _furniture() -> dict[str, list[str]]:
    words: dict[str, list[str]] = {}
    for word, category in sorted(by_word().items()):
        words.setdefault(category, []).append(word)
    return words
