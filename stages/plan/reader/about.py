"""Whom a home is for and what stands about it, found in the text before its rooms are read."""

import re
import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from apartgen.stages.plan.reader.patterns import Late

BEFORE = r"(?:\b(?:for|fur|pour|para)\s+)?(?:\b(?:a|an|the|ein|eine|einem|einer|un|une|una)\s+)?"
"""What stands before people and goes with them."""


@dataclass(frozen=True)
class People:
    """Couples who share a bedroom, grown-ups who have their own, children."""

    pairs: int = 0
    singles: int = 0
    children: int = 0

    @property
    def count(self) -> int:
        """How many they are."""
        return 2 * self.pairs + self.singles + self.children


@dataclass(frozen=True)
class About:
    """What a prompt says about the home as a whole: `dwelling` and `facades` as in `schemas.plan.Envelope`.

    `lived` says that people speak of their home, which has more rooms than they name.
    """

    people: People | None = None
    dwelling: str = ""
    facades: int | None = None
    loft: bool = False
    lived: bool = False


def about(text: str) -> tuple[About, str]:
    """What a folded text says of people and surroundings, and the text without the words that say it."""
    lived = _first(_data()["lived"], text) is not None
    people, text = _people(text)
    dwelling, facades, text = _dwelling(text)
    return About(people, dwelling, facades, _first(_data()["loft"], text) is not None, lived), text


def numbers() -> dict[str, int]:
    """Words for numbers of people."""
    return dict(_data()["numbers"])


@cache
def _data() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "about.toml").read_text(encoding="utf-8"))


def _first(row: dict[str, Any], text: str, before: str = "") -> re.Match[str] | None:
    """What the first of a row's patterns finds that finds anything."""
    found = (_pattern(before + words).search(text) for words in row["find"])
    return next((match for match in found if match is not None), None)


@cache
def _pattern(text: str) -> Late:
    return Late(text, _named())


@cache
def _named() -> dict[str, str]:
    return {"n": rf"(?P<n>\d+|{'|'.join(sorted(numbers(), key=len, reverse=True))})"}


def _people(text: str) -> tuple[People | None, str]:
    for row in _data()["people"]:
        if (found := _first(row, text, BEFORE)) is not None:
            return _counted(row, found), _without(text, found)
    return None, text


def _counted(row: dict[str, Any], found: re.Match[str]) -> People:
    said = found.groupdict().get("n") or "1"
    n = int(said) if said.isdigit() else int(_data()["numbers"][said])
    if row.get("household"):
        return People(singles=1) if n < 2 else People(pairs=1, children=n - 2)
    value = {-1: n, -2: max(n - 2, 0)}
    return People(**{who: value.get(row.get(who, 0), row.get(who, 0)) for who in ("pairs", "singles", "children")})


def _dwelling(text: str) -> tuple[str, int | None, str]:
    flat = _first(_data()["not_a_house"], text) is not None
    for row in _data()["dwelling"]:
        found = None if flat and row["kind"] == "house" else _first(row, text)
        if found is not None:
            return row["kind"], row["facades"], _without(text, found)
    return "", None, text


def _without(text: str, found: re.Match[str]) -> str:
    kept = found.groupdict().get("keep") or ""
    return f"{text[: found.start()]}{kept}{text[found.end() :]}"
