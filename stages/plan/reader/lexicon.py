"""The lexicon: phrases of several languages, each with a kind and a value; the data is `lexicon/*.toml`."""

import logging
import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.rooms import kinds, told
from apartgen.stages.plan.reader.phrase import Phrase, first_letters, first_words, most_words, phrase, plain, plural
from apartgen.stages.plan.reader.tables import expand, languages
from apartgen.stages.things.categories import TABLE, by_word

log = logging.getLogger("apartgen")
Row = tuple[int, str, str, str]
"""A pattern's number, kind, value and text: of two that say the same of a phrase the first counts."""

NOUNS = ("room", "dwelling", "furniture", "main_rooms")
PRIORITY = (
    "room", "dwelling", "number", "fraction", "ordinal", "determiner", "negation", "link", "compare", "with",
    "opening", "unneeded", "enough", "reach", "relative", "front", "boundary", "label", "size", "unit",
    "area_word", "conjunction", "pronoun", "only", "style", "shape", "side_role", "side", "beside", "place", "bound",
    "use", "furniture", "furniture_count", "graph", "main_rooms",
    "compound", "sum", "anew", "give", "adjective", "stop",
)  # fmt: skip
"""Which reading of a phrase of the same length comes first."""

UNSPELT = ("stop", "reach", "opening", "unneeded", "enough")
"""Kinds of which no word is what somebody meant who mistyped."""

_RANK = {kind: k for k, kind in enumerate(PRIORITY)}
_WORD = re.compile(r"[^\W\d_]+(?:'[^\W\d_]+)*")


@dataclass(frozen=True, slots=True)
class Entry:
    """One reading of a phrase. `plural` is set for nouns in their plural form."""

    kind: str
    value: str
    plural: bool = False


PLURALS = ("n", "e", "es", "er", "ern")
"""Endings of plurals that are none in English: such words stand in the lists beside their singular."""


class Entries:
    """Readings by phrase; patterns are expanded when a phrase with their first word is asked for."""

    def __init__(self) -> None:
        self._found: dict[Phrase, dict[str, Entry]] = {}
        self._waiting: dict[str, list[Row]] = defaultdict(list)
        self._asleep: dict[str, list[Row]] = defaultdict(list)
        self._rows = 0

    def add(self, words: Phrase, entry: Entry) -> None:
        """One reading more; the first of a kind counts."""
        self._found.setdefault(words, {}).setdefault(entry.kind, entry)

    def wait(self, kind: str, value: str, pattern: str) -> None:
        """A pattern to be expanded later, with the plurals of nouns.

        First words are looked for when one with such a letter is asked for: a process's first sentence waits for
        this, and has few letters.
        """
        self._rows += 1
        for letter in first_letters(pattern):
            self._asleep[letter].append((self._rows, kind, value, pattern))

    def _wake(self, letter: str) -> None:
        for row in self._asleep.pop(letter, ()):
            _, kind, _, pattern = row
            noun = kind in NOUNS
            if plain(pattern):
                words = pattern.replace("-", " ").split()
                for first in words[:1]:
                    self._waiting[first].append(row)
                    if noun and words[1:2] in ([], ["for"], ["where"]):  # it is the first that has a plural
                        self._waiting[plural((first,))[0]].append(row)
                continue
            firsts = first_words(pattern)
            for first in firsts | {plural((word,))[0] for word in firsts} if noun else firsts:
                if first[0] == letter:
                    self._waiting[first].append(row)

    def claim(self, words: Phrase, kind: str, value: str) -> None:
        """A noun's words mean this from now on, and so does their plural, whatever else of the kind they meant."""
        for form, entry in ((plural(words), Entry(kind, value, plural=True)), (words, Entry(kind, value))):
            self._expand(form[0])
            self._found.setdefault(form, {})[kind] = entry

    def get(self, words: Phrase) -> tuple[Entry, ...] | None:
        """All readings of a phrase, the likeliest first."""
        self._expand(words[0])
        readings = self._found.get(words)
        return _ranked(readings) if readings else None

    def __contains__(self, words: Phrase) -> bool:
        self._expand(words[0])
        return words in self._found

    def items(self) -> Iterator[tuple[Phrase, tuple[Entry, ...]]]:
        """Every phrase with its readings."""
        for letter in list(self._asleep):
            self._wake(letter)
        for first in list(self._waiting):
            self._expand(first)
        for words, readings in self._found.items():
            yield words, _ranked(readings)

    def words(self) -> Iterator[tuple[str, str]]:
        """Every word with a kind of phrase that has it."""
        for words, readings in self._found.items():
            best = _ranked(readings)[0].kind
            yield from ((word, best) for word in words)
        for letter in list(self._asleep):
            self._wake(letter)
        waiting: dict[str, dict[str, None]] = {}
        for rows in self._waiting.values():
            for _, kind, _, pattern in rows:
                waiting.setdefault(kind, {})[pattern] = None
        for kind, patterns in waiting.items():
            yield from ((word, kind) for word in _WORD.findall(" ".join(patterns)))
            yield from ((word, kind) for pattern in patterns if kind in NOUNS for word in _plurals(pattern))

    def _expand(self, first: str) -> None:
        self._wake(first[:1])
        for _, kind, value, pattern in sorted(self._waiting.pop(first, ())):
            noun = kind in NOUNS
            one, several = Entry(kind, value), Entry(kind, value, plural=True)
            for text in expand(pattern):
                words = phrase(text)
                if words[:1] == (first,):
                    self.add(words, one)
                if noun and words and words[-1].isascii() and (many := plural(words))[0] == first:
                    self.add(many, several)


@dataclass(frozen=True)
class Lexicon:
    """All readings of every phrase, `longest` words at most."""

    entries: Entries
    also_object: dict[str, str]
    suffixes: dict[str, Entry]
    longest: int

    @cached_property
    def words(self) -> frozenset[str]:
        """Words worth a spelling correction; an abbreviation is nobody's slip."""
        return frozenset(
            word
            for word, kind in self.entries.words()
            if kind not in UNSPELT and len(word) >= 5 and word.isascii() and not word.endswith("rm")
        )


@cache
def read_lexicon() -> Lexicon:
    """All phrases of all languages."""
    found = Entries()
    also_object: dict[str, str] = {}
    suffixes: dict[str, Entry] = {}
    longest = 1
    for table in languages().values():
        also_object |= table.get("also_object", {})
        for name, ends in table.get("suffix", {}).items():
            kind, _, value = name.partition("/")
            suffixes |= {end: Entry(kind, value) for end in ends}
        for kind, group in table.items():
            if kind not in ("also_object", "suffix"):
                longest = _add_group(found, kind, group, longest)
    longest = _add_group(found, "furniture", _furniture(), longest)
    for name, words in _things(found):
        found.claim(words, "furniture", name)
    for name, word in _newcomers():
        words = phrase(word)
        if words == tuple(name.split("_")) or not _taken(found, name, words):
            found.claim(words, "room", name)
            longest = max(longest, len(words))
    return Lexicon(found, also_object, suffixes, longest)


def _ranked(readings: dict[str, Entry]) -> tuple[Entry, ...]:
    """The likeliest first; a kind that shares no phrase with others has no rank."""
    if len(readings) == 1:
        return tuple(readings.values())
    return tuple(sorted(readings.values(), key=lambda entry: _RANK[entry.kind]))


def _add_group(found: Entries, kind: str, group: dict[str, list[str]], longest: int) -> int:
    """Add the phrases of a kind; returns the most words that one of these or of those before may have."""
    for value, patterns in group.items():
        for pattern in patterns:
            if kind == "room" and any(
                    pattern.endswith(end) and pattern.removesuffix(end) in patterns for end in PLURALS):
                found.add((pattern,), Entry(kind, value, plural=True))  # "habitaciones", "Schlafzimmern"
            found.wait(kind, value, pattern)
            if pattern.count(" ") + pattern.count("-") >= longest:  # else it cannot have more words
                longest = max(longest, most_words(pattern))
    return longest


def _plurals(pattern: str) -> list[str]:
    """The words of the plurals of a noun's phrases that are not those of its singulars."""
    _, _, options = pattern.removesuffix("}").rpartition("{" if pattern.endswith("}") else " ")
    ends = options.split(",") if pattern.endswith("}") else [options]
    if "" in ends or "for" in pattern or "where" in pattern:
        return [word for text in expand(pattern) if (words := phrase(text))[-1].isascii() for word in plural(words)]
    return [plural(words[-1:])[0] for end in ends if (words := phrase(end)) and words[-1].isascii()]


def _newcomers() -> list[tuple[str, str]]:
    """Types of room that do not always exist, each with its own name in words, then with the others that it has."""
    new = [kind for kind in kinds().values() if kind.name not in ROOM_TYPES]
    others = [(kind.name, word.lower()) for kind in new for word in kind.words if phrase(word)]
    return [*((kind.name, kind.name.replace("_", " ")) for kind in new), *others]


def _taken(found: Entries, name: str, words: Phrase) -> bool:
    """Whether a newcomer's words are said of something else, which is told; what it is like has but its name."""
    kind = kinds()[name]
    for entry in found.get(words) or ():
        spoken = entry.value.partition(":")[0]
        less = entry.kind == "room" and spoken in (kind.like, kind.base) and words != tuple(spoken.split("_"))
        if entry.kind in NOUNS and spoken != name and not less:
            log.warning("%s", told(name, f"words: {' '.join(words)!r} is said of another, {spoken}; left out"))
            return True
    return False


def _things(found: Entries) -> Iterator[tuple[str, Phrase]]:
    """Categories that do not always exist, by their names and what of their words was said of what they are like."""
    for kind in (kind for kind in TABLE.values() if kind.like):
        for words in map(phrase, (kind.name.replace("_", " "), *(word.lower() for word in kind.synonyms))):
            spoken = {entry.value for entry in found.get(words) or () if entry.kind == "furniture"}
            if words == tuple(kind.name.split("_")) or spoken <= set(kind.lineage):
                yield kind.name, words
            else:
                other = " and ".join(sorted(spoken - {kind.name}))
                log.warning("[%s] synonyms: %r is said of another, %s; left out", kind.name, " ".join(words), other)


def _furniture() -> dict[str, list[str]]:
    words: dict[str, list[str]] = {}
    for word, category in sorted(by_word().items()):
        words.setdefault(category, []).append(word)
    return words
