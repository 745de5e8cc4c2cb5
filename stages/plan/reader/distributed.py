"""What is asked of each of some rooms and of any of others: `each bedroom next to a bathroom`."""

from collections.abc import Iterator

from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.statements import Asked, Said, Statement
from apartgen.stages.plan.reader.vocabulary import OPPOSITE, Det, Relation, Trait

EVERYWHERE = ("bathroom", "bedroom")
"""Rooms that a home has, how many of them it is left to say elsewhere."""
EVERY = (Det.EACH, Det.ALL, Det.BOTH)


def each_beside_one(said: Said) -> None:
    """Neighbours of that kind become wishes of their own, so that the second phrase makes no room and counts none."""
    for s in list(said.statements):
        one = s.right[0] if len(s.right) == 1 else None
        near = s.kind == Relation.NEAR and not s.relation.startswith(OPPOSITE)
        if one is None or not near or not all(_every(p) for p in s.left) or not _some(one, said, s):
            continue
        said.statements.remove(s)
        said.rooms = [room for room in said.rooms if room is not one]
        names = " and ".join(p.text for p in s.left)
        said.asked.append(Asked("adjacent", s.left, [one], "", f"{names} {s.relation} {one.text}"))
        one.quantifier = Det.EACH


def _every(phrase: RoomPhrase) -> bool:
    return phrase.quantifier in EVERY and phrase.type in ("", *EVERYWHERE)


def _some(one: RoomPhrase, said: Said, s: Statement) -> bool:
    """Whether the phrase means any room of its type, and nothing else is said of it."""
    bare = one.quantifier == Det.A and one.count in (None, 1) and not (one.ordinals or one.areas or one.owned)
    again = any(one in (*o.left, *o.right) for o in said.statements if o is not s)
    alike = any(p.type == one.type for p in s.left)
    return bare and one.type in EVERYWHERE and not one.labels - {Trait.OWN} and not again and not alike


def matched(of: list[Entity], others: list[Entity]) -> Iterator[tuple[Entity, Entity]]:
    """Each room with the other that belongs to it, else with one that belongs to none."""
    free = [o for o in others if o.owner is None] or others
    for k, room in enumerate([e for e in of if not any(o.owner is e for o in others)]):
        if free:
            yield room, free[min(k, len(free) - 1)]
