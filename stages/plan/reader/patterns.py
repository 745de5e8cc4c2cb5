"""Regular expressions that are compiled once the words that they need stand in a text: most never are."""

import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache, cached_property

Needs = tuple[frozenset[str], ...]
"""Of each of these sets, one string stands in whatever a pattern finds."""
_PARTS = re.compile(r"\\.|\[[^\]]*\]|\(\?P<\w+>|\(\?<?[:=!]|[()|?*+]|\{[^}]*\}|[^\\\[\](){}|?*+.^$]+|.")
_SIGN = re.compile(r"\\[^\w\s]")
"""A sign that stands for itself: `\\(`."""
_AROUND = ("(?=", "(?!", "(?<=", "(?<!")


def needed(pattern: str, named: Mapping[str, str] | None = None) -> Needs:
    """What a pattern needs; `{name}` stands for a pattern of `named`, or else for any text.

    Over a thousand patterns are read before the first sentence is: hence one loop.
    """
    outer: list[tuple[list[Needs], Needs, bool]] = []
    alternatives: list[Needs] = []
    present: Needs = ()  # of the present alternative; `run` are its last letters
    run, around = "", False
    parts = _PARTS.findall(pattern)
    for part, after in zip(parts, [*parts[1:], ""], strict=True):
        first, optional = part[0], after in ("?", "*") or after.startswith("{0")
        letters = first not in "\\()|[?*+{.^$" or (first == "\\" and _SIGN.fullmatch(part))
        if letters:
            text = part.removeprefix("\\")
            run += text[:-1] if optional else text
        if run and (not letters or after[:1] in ("?", "*", "+", "{")):
            # what comes next need not follow the letters before
            present, run = (*present, frozenset((run,))), ""
        if first == "(":
            outer.append((alternatives, present, around))
            alternatives, present, around = [], (), part in _AROUND
        elif first == ")":
            inner = () if optional or around else _of_each(alternatives, present)
            alternatives, present, around = outer.pop()
            present += inner
        elif first == "|":
            alternatives.append(present)
            present = ()
        elif first == "{" and named and not optional and part[1:-1] in named:
            present += _of(named[part[1:-1]])
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
