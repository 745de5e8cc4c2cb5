"""Phrases of the lexicon and the patterns that they are written in, `{a,b} c`: their words, first words, plurals."""

import re
from functools import cache

from apartgen.stages.plan.reader.tables import expand
from apartgen.stages.plan.reader.tokens import CJK, fold, tokenize

Phrase = tuple[str, ...]

_PLAIN = re.compile(r"[a-z -]+")
_ELIDED = re.compile(r"[a-z][a-z']*(?:[ -]+[a-z][a-z']*)*")
"""Words with apostrophes."""
_SIGNS = re.compile(f"[{CJK} ]+")
_PATTERN = re.compile(r"[a-z -]*(?:(?:(?<= )|(?<!.)){[a-z, -]*}(?= |$)[a-z -]*)*")
"""Patterns whose braces stand between whole words."""


def plain(pattern: str) -> bool:
    """Whether a pattern is one phrase, of plain words."""
    return _PLAIN.fullmatch(pattern) is not None


def first_letters(pattern: str) -> set[str]:
    """What the first words of a pattern begin with."""
    if pattern[0] != "{":
        return {_letter(pattern[0])}
    options, _, after = pattern[1:].partition("}")
    found = [option.lstrip() for option in options.split(",")]
    letters = {_letter(option[0]) for option in found if option}
    return letters if all(found) else letters | first_letters(after.lstrip())


@cache
def _letter(sign: str) -> str:
    """Without accents; tens become digits."""
    return phrase(sign)[0][0] if phrase(sign) else sign


def first_words(pattern: str) -> set[str]:
    """The words that the phrases of a pattern begin with."""
    if not _PATTERN.fullmatch(pattern):
        return {words[0] for text in expand(pattern) if (words := phrase(text))}
    head, brace, rest = pattern.partition("{")
    if head or not brace:
        return set(head.replace("-", " ").split()[:1])
    options, _, after = rest.partition("}")
    parts = [option.replace("-", " ").split() for option in options.split(",")]
    return {part[0] for part in parts if part} | (first_words(after.strip()) if [] in parts else set())


def most_words(pattern: str) -> int:
    """No phrase of a pattern has more words."""
    if "{" not in pattern:
        return len(pattern.replace("-", " ").split())
    parts = [part.split(",") for part in pattern.replace("-", " ").replace("{", "}").split("}")]
    return sum(max(len(option.split()) for option in part) for part in parts)


def phrase(text: str) -> Phrase:
    """The words of a phrase, without hyphens."""
    if _PLAIN.fullmatch(text):  # as tokens would be, without their cost: a process's first sentence waits for this
        return tuple(text.replace("-", " ").split())
    if _ELIDED.fullmatch(text) and "''" not in text and "d'au" not in text:
        return tuple(word.rstrip("'") for word in text.replace("-", " ").split())
    if _SIGNS.fullmatch(text) and not {"十", "百"} & set(text):  # a token each; tens become digits
        return tuple(text.replace(" ", ""))
    return tuple(t.text for t in tokenize(text if text.isascii() else fold(text)) if t.text != "-")


def plural(words: Phrase) -> Phrase:
    """English plural of the last word, or of that before `for`: `rooms for sleeping`."""
    behind = next((k for k, word in enumerate(words) if k and word in ("for", "where")), len(words))
    if behind < len(words):
        return (*plural(words[:behind]), *words[behind:])
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
