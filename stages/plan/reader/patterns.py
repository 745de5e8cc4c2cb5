"""Regular expressions that are compiled once the words that they need stand in a text: most never are."""

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache, cached_property

Needs = tuple[frozenset[str], ...]
"""Of each of these sets, one string stands in whatever a pattern finds."""
_PARTS = re.compile(
    r"\((?:\?:)?[a-z' |-]+\)|\\.|\[[^\]]*\]|\(\?P<\w+>|\(\?<?[:=!]|[()|?*+]|\{[^}]*\}|[^\\\[\](){}|?*+.^$]+|.")
_SIGN = re.compile(r"\\[^\w\s]")
"""A sign that stands for itself: `\\(`."""


class _Parts(dict[str, tuple[int, str, bool]]):
    """Parts of patterns: what each is, its letters or its name, and whether as a quantifier it allows for none."""

    def __missing__(self, part: str) -> tuple[int, str, bool]:
        first, none = part[:1], part[:1] in ("?", "*") or part.startswith("{0")
        if not part or first not in "\\()|[?*+{.^$" or _SIGN.fullmatch(part):
            found = (_LETTERS if part else _OTHER, part.removeprefix("\\"), none)
        elif part[-1] == ")" != part:
            found = (_WORDS, part.removeprefix("(").removeprefix("?:")[:-1], none)
        elif first in "?*+{":
            found = (_QUANTIFIER, part[1:-1], none)
        else:
            found = ({"(": _AROUND if part in ("(?=", "(?!", "(?<=", "(?<!") else _OPEN, ")": _CLOSE, "|": _OR}.get(
                first, _OTHER), "", none)
        self[part] = found
        return found


_LETTERS, _WORDS, _OPEN, _AROUND, _CLOSE, _OR, _QUANTIFIER, _OTHER = range(8)
_KNOWN = _Parts()


def needed(pattern: str, named: Mapping[str, str] | None = None) -> Needs:
    """What a pattern needs; `{name}` stands for a pattern of `named`, or else for any text.

    Nearly two thousand patterns are read before the first sentence is: hence one loop, and parts that are known.
    """
    outer: list[tuple[list[Needs], Needs, bool]] = []
    alternatives: list[Needs] = []
    present: Needs = ()  # of the present alternative; `run` are its last letters
    run, around = "", False
    parts = [_KNOWN[part] for part in _PARTS.findall(pattern)]
    parts.append(_KNOWN[""])
    for k, (kind, text, _) in enumerate(parts[:-1], 1):
        after, _, optional = parts[k]
        if kind == _LETTERS:
            if after != _QUANTIFIER:
                run += text
                continue
            run += text[:-1] if optional else text
        if run:  # what comes next need not follow the letters before
            present, run = (*present, frozenset((run,))), ""
        if kind == _WORDS:
            words = text.split("|")
            if not optional and all(words):
                present += (frozenset(words),)
        elif kind in (_OPEN, _AROUND):
            outer.append((alternatives, present, around))
            alternatives, present, around = [], (), kind == _AROUND
        elif kind == _CLOSE:
            inner = () if optional or around else _of_each(alternatives, present)
            alternatives, present, around = outer.pop()
            present += inner
        elif kind == _OR:
            alternatives.append(present)
            present = ()
        elif kind == _QUANTIFIER and named and not optional and text in named:
            present += _of(named[text])
    return _of_each(alternatives, (*present, frozenset((run,))) if run else present)


def _of_each(alternatives: list[Needs], last: Needs) -> Needs:
    """What all alternatives need: one of the longest words of each."""
    if not alternatives:
        return last
    if not last or not all(alternatives):
        return ()
    best = [max(needs, key=_least) if len(needs) > 1 else needs[0] for needs in (*alternatives, last)]
    return (frozenset().union(*best),)


def _least(words: frozenset[str]) -> int:
    return min(map(len, words))


@cache
def _of(pattern: str) -> Needs:
    return needed(pattern)


class Late:
    """A pattern with those of `named` in the place of their names, which is compiled for texts that may have it."""

    def __init__(self, pattern: str, named: Mapping[str, str] | None = None) -> None:
        self.pattern, self.named = pattern, named or {}
        self.needs = needed(pattern, named)

    @cached_property
    def compiled(self) -> re.Pattern[str]:
        """As `re.compile` gives it."""
        text = self.pattern
        for name, words in self.named.items():
            text = text.replace("{" + name + "}", words)
        return re.compile(text)

    def lacked_by(self, text: str) -> bool:
        """Whether a text has not all that is needed."""
        return not all(any(word in text for word in words) for words in self.needs)

    def search(self, text: str) -> re.Match[str] | None:
        """As `re.Pattern.search`."""
        return None if self.lacked_by(text) else self.compiled.search(text)

    def finditer(self, text: str) -> Iterator[re.Match[str]]:
        """As `re.Pattern.finditer`."""
        return iter(()) if self.lacked_by(text) else self.compiled.finditer(text)

    def sub(self, instead: str | Callable[[re.Match[str]], str], text: str) -> str:
        """As `re.Pattern.sub`."""
        return text if self.lacked_by(text) else self.compiled.sub(instead, text)


@cache
def late(pattern: str) -> Late:
    """The same for the same pattern."""
    return Late(pattern)
