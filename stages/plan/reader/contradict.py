"""Wishes of one prompt that exclude one another."""

from collections.abc import Mapping

from apartgen.schemas.errors import Unmet
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.parse import mentions
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.vocabulary import Det, Relation


def consistent(said: Said, home: Household) -> None:
    """Raise Unmet naming two wishes of which only one can come true."""
    _wanted_and_not(said, home)
    _greater_than_itself(said)


def _wanted_and_not(said: Said, home: Household) -> None:
    """`a two-bedroom flat without bedrooms`; a negation that speaks of doors or of some rooms denies none."""
    placed = mentions(said.statements)
    for phrase in said.rooms:
        bare = (
            not phrase.labels
            and not phrase.ordinals
            and phrase.count is None
            and phrase.quantifier in (Det.BARE, Det.A)
        )
        plain = bare and id(phrase) not in placed
        if phrase.negated and plain and phrase.type and home.of(phrase.type):
            name = phrase.type.replace("_", " ")
            raise Unmet(f"the prompt asks for a {name} and for no {name}: leave one of the two out")


def _greater_than_itself(said: Said) -> None:
    """`A twice as large as B, B twice as large as A`."""
    ratios = [(_types(s.left), _types(s.right), s.number) for s in said.statements if s.kind == Relation.COMPARE]
    for a, b, first in ratios:
        for c, d, second in ratios:
            apart = min(first, second) > 0 and (min(first, second) > 1 or max(first, second) < 1)
            if (a, b) == (d, c) and a != b and apart:
                word = "larger" if first > 1 else "smaller"
                raise Unmet(f"the {a} and the {b} are each to be {word} than the other: leave one of the two out")


def _types(phrases: list[RoomPhrase]) -> str:
    return " and ".join(p.type.replace("_", " ") for p in phrases)


def shares_fit(shares: Mapping[str, float]) -> None:
    """Raise Unmet where rooms are to have more than the whole floor."""
    if sum(shares.values()) > 1.0 + 1e-6:
        each = ", ".join(f"{name} {100 * share:.0f} %" for name, share in shares.items())
        raise Unmet(f"the shares of the floor area add up to {100 * sum(shares.values()):.0f} % ({each}): ask for less")
