"""Regular expressions that are compiled once the words that they need stand in a text: most never are."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property

Needs = tuple[frozenset[str], ...]
"""Of each of these sets, one string stands in whatever a pattern finds."""
_PARTS = re.compile(r"\\.|\[[^\]]*\]|\(\?P<\w+>|\(\?<?[:=!]|[()|?*+]|\{[^}]*\}|[^\\\[\](){}|?*+.^$]+|.")
_SIGN = re.compile(r"\\[^\w\s]")
"""A sign that stands for itself: `\\(`."""
_AROUND = ("(?=", "(?!", "(?<=", "(?<!")


@dataclass
class _Group:
    """What is known of a bracket read so far: its alternatives, of the present one the needs and the last letters."""

    around: bool = False
    alternatives: list[Needs] = field(default_factory=list)
    present: Needs = ()
    run: str = ""

    def cut(self) -> None:
        """What comes next need not follow the letters before."""
        self.present += (frozenset({self.run}),) if self.run else ()
        self.run = ""

    def close(self) -> None:
        """The present alternative ends."""
        self.cut()
        self.alternatives.append(self.present)
        self.present = ()

    def needs(self) -> Needs:
        """What all alternatives need: one of the longest words of each."""
        self.close()
        if len(self.alternatives) == 1 or not all(self.alternatives):
            return self.alternatives[0] if len(self.alternatives) == 1 else ()
        best = [max(needs, key=lambda words: min(map(len, words))) for needs in self.alternatives]
        return (frozenset().union(*best),)


def needed(pattern: str, named: Mapping[str, str] | None = None) -> Needs:
    """What a pattern needs; `{name}` stands for a pattern of `named`, or else for any text."""
    parts = _PARTS.findall(pattern)
    groups = [_Group()]
    for part, after in zip(parts, [*parts[1:], ""], strict=True):
        optional = after[:1] in ("?", "*") or after.startswith("{0")
        if part.startswith("("):
            groups[-1].cut()
            groups.append(_Group(around=part in _AROUND))
        elif part == ")":
            inner = groups.pop()
            groups[-1].present += () if optional or inner.around else inner.needs()
        elif part == "|":
            groups[-1].close()
        elif part[0] in "\\[?*+{.^$" and not _SIGN.fullmatch(part):
            groups[-1].cut()
            known = named is not None and not optional and part[1:-1] in named
            groups[-1].present += _of(named[part[1:-1]]) if known and named is not None else ()
        else:
            text = part.removeprefix("\\")
            groups[-1].run += text[:-1] if optional else text
            if optional or after[:1] in ("+", "{"):
                groups[-1].cut()
    return groups[0].needs()


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
