"""Where a clause begins whose words are read before doors are: its subject is no object of the clause before."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark

FINITE = frozenset("is are lies lie faces face looks look sits sit has have ist sind liegt liegen est sont".split())
"""Verbs with which such a clause may begin."""


def clause_of(out: list[Item], rooms: list[RoomPhrase], words: str) -> None:
    """`… next to the bath and the study faces south`: a boundary before the study, once `faces south` is read."""
    at = next((j for j in range(len(out) - 1, 1, -1) if rooms and out[j].room is rooms[0]), 0)
    told = any(i.kind == "copula" for i in out[at + 1 :]) or words.split()[0] in FINITE or not words.isascii()
    told = told or (at > 0 and rooms[0].type == "")  # "…, the smaller one near the entrance"
    joint = out[at - 1] if at else Item("")
    if told and (joint.kind == "conjunction" or is_mark(joint, ",")):
        out[at - 1] = Item("boundary", "while", joint.text)
