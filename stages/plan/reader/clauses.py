"""Where a clause begins whose words are read before doors are: its subject is no object of the clause before."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det

FINITE = frozenset("is are lies lie faces face looks look sits sit has have ist sind liegt liegen est sont".split())
"""Verbs with which such a clause may begin."""


def clause_of(out: list[Item], rooms: list[RoomPhrase], words: str) -> None:
    """`… next to the bath and the study faces south`: a boundary before the study, once `faces south` is read."""
    at = next((j for j in range(len(out) - 1, 1, -1) if rooms and out[j].room is rooms[0]), 0)
    told = any(i.kind == "copula" for i in out[at + 1 :]) or words.split()[0] in FINITE or not words.isascii()
    told = told or (at > 0 and rooms[0].type == "")  # "…, the smaller one near the entrance"
    told = told or (at > 0 and is_mark(out[at - 1], ",") and _after_clause(out[: at - 1], rooms[0]))
    joint = out[at - 1] if at else Item("")
    if told and (joint.kind == "conjunction" or is_mark(joint, ",")):
        out[at - 1] = Item("boundary", "while", joint.text)


def _after_clause(out: list[Item], room: RoomPhrase) -> bool:
    """`the bath must not open into the kitchen, bedroom far from the entrance`: a clause without a verb follows one.

    Without a denial it does so where it has no article and the room before has one.
    """
    at = len(out)
    while at and (out[at - 1].room is not None or out[at - 1].kind == "conjunction" or is_mark(out[at - 1], ",")):
        at -= 1
    if not 0 < at < len(out) or out[at - 1].kind != "link":
        return False
    verb = next((i for i in reversed(out[: at - 1]) if i.kind != "copula"), Item(""))
    first = out[at].room
    bare = first is not None and at + 1 == len(out) and (first.quantifier, room.quantifier) == (Det.THE, Det.BARE)
    return verb.kind == "negation" or (bare and out[at - 1].form in ("s", "p"))
