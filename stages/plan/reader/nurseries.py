"""In which bedrooms children sleep, and how many of them, where a text tells of them."""

from apartgen.stages.plan.reader.about import People
from apartgen.stages.plan.reader.entity import OTHERS, Entity
from apartgen.stages.plan.reader.kin import kind_of, number_of, pattern
from apartgen.stages.plan.reader.tokens import fold
from apartgen.stages.plan.reader.vocabulary import Trait

GROWN = (OTHERS - {Trait.KIDS}) | {Trait.MASTER}
MOST = 6
"""Children of a home that are counted."""


def children(bedrooms: list[Entity], people: People | None, prompt: str) -> dict[int, int]:
    """Children by their bedroom (`id` of the entity): at least one in every room that is said to be theirs, else the
    children of those who live there in the rooms behind those of the grown-ups; so many as are told of."""
    told = [room for room in bedrooms if Trait.KIDS in room.labels]
    many = people.children if people else 0
    if told and not many:
        many = _told(prompt)
    elif not told and people and many:
        own = people.pairs + people.singles - sum(Trait.MASTER in room.labels for room in bedrooms)
        told = [room for room in bedrooms if not room.labels & GROWN][max(own, 0):]
    shares = _shares(prompt) if len(told) > 1 else None
    if shares is not None and len(shares) == len(told):
        return {id(room): number for room, number in zip(told, shares, strict=True)}
    return {id(room): 1 + max(0, min(many, MOST) - 1 - k) // len(told) for k, room in enumerate(told)}


def _shares(prompt: str) -> list[int] | None:
    """How many share each of their rooms, where a text tells who does."""
    from apartgen.stages.plan.reader.siblings import sleepers  # which few texts want

    return sleepers(fold(prompt))


def _told(prompt: str) -> int:
    """The largest number of children of whom a text tells at once."""
    found = [match for match in pattern("{who}").finditer(fold(prompt)) if kind_of(match) in ("child", "twins")]
    return max((number_of(match) for match in found), default=0)
