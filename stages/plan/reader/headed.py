"""Rooms named behind what is said of them, or by where they stand in a list: `adjacent: A and B`, `the last two`."""

from apartgen.stages.plan.reader.clausal import again_named, ahead, clause, last
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark

DENIED = ("negation", "copula")
"""What may stand before a relation that heads a line: `must not be adjacent: …`."""
ENDS = {"last": slice(-2, None), "first": slice(2)}
"""Which rooms of a list `the last two` and `the first two` are."""


def related_first(out: list[Item], items: list[Item], k: int) -> bool:
    """`must not share a wall: bedroom 2 and kitchen; bath and study`: said of the two rooms of each pair."""
    at = len(out)
    while at and out[at - 1].kind in DENIED:
        at -= 1
    begins = at == 0 or is_mark(out[at - 1], ".")
    if items[k].kind != "link" or not begins or not is_mark(ahead(items, k)[0], ":"):
        return False
    pairs, end = _pairs(items, k + 2)
    if not pairs:
        return False
    denied = [i for i in out[at:] if i.kind == "negation"]
    del out[at:]
    for a, b in pairs:
        out += [a, *denied, items[k], b, Item("mark", ".", ".")]
    items[k + 1 : end] = [Item("stop", "", i.text) for i in items[k + 1 : end]]
    return True


def _pairs(items: list[Item], k: int) -> tuple[list[tuple[Item, Item]], int]:
    """The pairs of `A and B, C and D` from `k` on and where they end; none where more is said."""
    out: list[tuple[Item, Item]] = []
    while True:
        a, joint, b = (items[k : k + 3] + [Item("")] * 3)[:3]
        if not (_single(a.room) and joint.kind == "conjunction" and _single(b.room)):
            return [], k
        out.append((a, b))
        k += 3
        if k >= len(items) or is_mark(items[k], "."):
            return out, k
        if not is_mark(items[k], ","):
            return [], k
        k += 1


def last_two(out: list[Item], items: list[Item], k: int) -> bool:
    """`a bath of 5 m² and a store of 3 m², the last two next to each other`: the bath and the store."""
    room = items[k].room
    words = room.text.split()[-2:] if room is not None and not room.type and room.count == 2 else []
    if words[1:] != ["two"] or words[0] not in ENDS:
        return False
    listed = clause(out) or clause(out[:-1])
    pair = [i.room for i in listed if i.room is not None][ENDS[words[0]]]
    if len(pair) < 2 or not all(_single(r) for r in pair):
        return False
    if is_mark(last(out), ",") or last(out).kind == "conjunction":
        out[-1] = Item("mark", ".", ".")
    out += [again_named(pair[0]), Item("conjunction", "and", "and"), again_named(pair[1])]
    return True


def _single(room: RoomPhrase | None) -> bool:
    one = room is not None and room.type not in ("", "any") and not room.plural and room.count in (None, 1)
    return one and room is not None and not room.negated
