"""What a prompt says and no rule takes up: words with the clauses they stand in, and what a plan cannot have."""

import re
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.statements import Said, Statement
from apartgen.stages.plan.reader.tokens import fold
from apartgen.stages.plan.reader.vocabulary import OPPOSITE, Relation, Trait

DENIED = re.compile(r"\b(?:no|not|without|ohne|kein\w*|sans|pas d'|pas de|sin|ninguna?) (?:\w+ )?$")
"""What stands before something that nobody wants."""
ONE = re.compile(r"\b(?:single|one) (?:\w+ )?$")
"""What stands before a storey of which there is one only."""
CLAUSE = re.compile(r"(?<=\D)[.,:](?=\s|$)|[;!?\n()，。；、！？：]| - | – | — |(?<=\d)[.,](?=\s|$)")
"""Where one clause ends and the next begins; 3.5 is one number."""
CLOSED = re.compile(r"not (?:(?:be|is|are) )?open (?:to|towards?)\b")
"""What denies that rooms share a space, and no door."""
PETS = re.compile(r"^(dog|cat|pet)(?=(?:bed|basket|couch|sofa|table|chair)s?$)")
"""Whose furniture was put into one word, so that none of it is people's."""
LONGEST = 80
"""Characters of a clause that are quoted."""


def limits(text: str) -> list[tuple[str, str]]:
    """Words of a folded text for what a plan cannot have, and why; "" for what every plan has."""
    return [
        (found.group(), _why(text[: found.start()], row["why"]))
        for row in _limits()
        for pattern in row["find"]
        for found in late(pattern).finditer(text)
    ]


def without_taken(text: str) -> str:
    """A folded text without those of them that rooms would be told by: `doors at least 90 cm wide`."""
    for pattern in [one for row in _limits() if row.get("taken") for one in row["find"]]:
        text = late(pattern).sub("", text)
    return text


def _why(before: str, why: str) -> str:
    """What is told of words behind such a text."""
    if DENIED.search(before):
        return f"as wished: {why}"
    return "" if ONE.search(before) and "storey" in why else why


def can_be_met(said: Said) -> list[Statement]:
    """What is said without `not opposite the bedroom`, which no plan is judged by: it is told.

    Nor is `the kitchen is not open to the living room`: the kitchen is closed, and may have a door there.
    """
    denied = [s for s in said.statements if s.kind == Relation.NOT and s.relation.removeprefix("not ") != s.relation]
    across = [s for s in denied if s.relation.removeprefix("not ").startswith(OPPOSITE)]
    said.unread += [f"{s.relation} {phrase.text}" for s in across for phrase in s.right[:1]]
    closed = [s for s in denied if CLOSED.match(s.relation)]
    for phrase in [p for s in closed for p in (*s.left, *s.right) if p.type == "kitchen"]:
        phrase.labels.add(Trait.SEPARATE)
    return [s for s in said.statements if s not in across + closed]


def with_clauses(words: list[str], beyond: list[tuple[str, str]], prompt: str) -> list[str]:
    """Each of `words` with the clause of the prompt it stands in, those of `beyond` with the reason, once each."""
    clauses = [" ".join(part.split()) for part in CLAUSE.split(prompt) if part.strip()]
    named = _outermost(beyond)
    out = [_entry(text, why, clauses) for text, why in named if why]
    told = [_plain(text) for text, _ in named]
    joined = [PETS.sub(r"\1 ", word.replace(" - ", "-")) for word in words]
    out += [_entry(word, "", clauses) for word in joined if not any(_plain(word) in text for text in told)]
    return list(dict.fromkeys(out))


@cache
def _limits() -> list[dict[str, Any]]:
    data = tomllib.loads((Path(__file__).parent / "limits.toml").read_text(encoding="utf-8"))
    return list(data["limit"])


def _outermost(beyond: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Without those that stand inside a longer one."""
    return [
        (text, why)
        for k, (text, why) in enumerate(beyond)
        if not any(text in other and (text != other or j < k) for j, (other, _) in enumerate(beyond) if j != k)
    ]


def _entry(word: str, why: str, clauses: list[str]) -> str:
    clause = next((c for c in clauses if _holds(c, word)), "")
    quoted = "" if _plain(clause) == _plain(word) else _shortened(clause, word)
    notes = "; ".join([*([why] if why else []), *([f"in: {quoted}"] if quoted else [])])
    return f"{word} ({notes})" if notes else word


def _holds(clause: str, word: str) -> bool:
    text, wanted = _plain(clause), _plain(word)
    return f" {wanted} " in f" {text} " or (not wanted.isascii() and wanted in text)


@cache
def _plain(text: str) -> str:
    """Words of a text, folded, with single blanks."""
    return " ".join(re.findall(r"[^\W_]+", fold(text)))


def _shortened(clause: str, word: str) -> str:
    """A long clause from a few words before the word on."""
    if len(clause) <= LONGEST:
        return clause
    at = fold(clause).find(word.split()[0])
    start = clause.rfind(" ", 0, max(at - LONGEST // 2, 0)) + 1
    end = clause.find(" ", start + LONGEST)
    return ("…" if start else "") + (clause[start:] if end < 0 else clause[start:end] + "…")
