"""Spelling correction against the lexicon's own words."""

from functools import cache

from apartgen.stages.plan.reader.lexicon import Lexicon, read_lexicon

KIN = frozenset("grandson grandsons grandkid grandkids grandchild granddad godson godchild stepson".split())
"""People whom the lexicon has no word for, whose names are no slips of other words."""


def correct(word: str, lexicon: Lexicon) -> str:
    """The lexicon's nearest word within one slip (two from nine letters), or the word itself."""
    if len(word) < 4 or not word.isascii() or (word,) in lexicon.entries or word in KIN:
        return word
    if len(word) == 4:
        return _short(word)
    return word if word in lexicon.words else _nearest(word)


def split(word: str, lexicon: Lexicon) -> tuple[str, str] | None:
    """`onebedroom` as two known words."""
    if len(word) < 7:
        return None
    cuts = [(word[:k], word[k:]) for k in range(3, len(word) - 2)]
    return next((c for c in cuts if (c[0],) in lexicon.entries and _noun(c[1], lexicon)), None)


def _noun(word: str, lexicon: Lexicon) -> bool:
    entries = lexicon.entries.get((word,))
    return entries is not None and entries[0].kind in ("room", "dwelling")


@cache
def _by_length() -> dict[int, dict[str, list[str]]]:
    """Words by length and first letter, which is seldom mistyped."""
    out: dict[int, dict[str, list[str]]] = {}
    for word in sorted(read_lexicon().words):
        out.setdefault(len(word), {}).setdefault(word[0], []).append(word)
    return out


def _swapped(word: str, length: int) -> list[str]:
    """Candidates should the first two letters have changed places."""
    return [w for w in _by_length().get(length, {}).get(word[1], []) if w[1] == word[0] and word[0] != word[1]]


@cache
def _nearest(word: str) -> str:
    most = 1 if len(word) < 8 else 2
    best, least = word, most + (0.9 if len(word) > 5 else 0.1)  # of short words, one wrong letter makes another word
    for length in range(len(word) - most, len(word) + most + 1):
        for other in _by_length().get(length, {}).get(word[0], []) + _swapped(word, length):
            slips = distance(word, other, least)
            if slips < least:
                best, least = other, slips
    return best


@cache
def _short(word: str) -> str:
    """A number that lacks a letter: of words so short, any other slip makes another word."""
    longer = _by_length().get(5, {}).get(word[0], [])
    fits = [w for w in longer if any(w[:k] + w[k + 1 :] == word for k in range(5)) and _is_number(w)]
    return fits[0] if fits else word


def _is_number(word: str) -> bool:
    found = read_lexicon().entries.get((word,))
    return found is not None and found[0].kind == "number"


SUBSTITUTION = 1.2
"""A letter left out, doubled or swapped is a likelier slip than a wrong one."""


def distance(a: str, b: str, limit: float) -> float:
    """Damerau-Levenshtein distance (neighbours swapped count once), `limit` when it is not below."""
    if abs(len(a) - len(b)) >= limit:
        return limit
    before: list[float] = []
    row: list[float] = [float(j) for j in range(len(b) + 1)]
    for i, x in enumerate(a, 1):
        new = [float(i)]
        for j, y in enumerate(b, 1):
            cost = min(row[j] + 1, new[j - 1] + 1, row[j - 1] + SUBSTITUTION * (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and y == a[i - 2]:
                cost = min(cost, before[j - 2] + 1)
            new.append(cost)
        if min(new) >= limit:
            return limit
        before, row = row, new
    return min(row[-1], limit)
