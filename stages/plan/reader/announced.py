"""Words that announce what is said anew: `no, two`, `I first wanted two, but now one`, `no balcony after all`."""

from apartgen.stages.plan.reader.mention import Item, is_mark
from apartgen.stages.plan.reader.sufficing import counts
from apartgen.stages.plan.reader.vocabulary import Det

RELATED = ("link", "front", "place", "side", "beside")
"""Kinds of items that say where a room is or leads."""
TOLD = ("area", "object", "negation", "anew")
"""What else may be said anew."""
LEADING = ("only", "stop", "with", "reach", "copula", "bound")
"""Kinds of items that may stand between such a word and what is said anew."""


def announced(items: list[Item]) -> list[Item]:
    """`anew` alone in the place of all such words; what was once wanted comes first."""
    out: list[Item] = []
    former, dashed = False, False
    for k, item in enumerate(items):
        kind = item.value if item.kind == "anew" else ""
        if kind == "formerly":
            former = True
        elif kind == "now" and not (former and (not out or out[-1].kind != "anew")):
            pass  # "a balcony now", "but now"
        elif kind == "now" or _denies_nothing(items, k) or (kind == "anew" and not _goes_on(items, k)):
            dashed = _without_dash(out) or dashed
            out.append(Item("anew", "anew", item.text))
        elif kind == "late":
            _said_late(out)
        elif dashed and is_mark(item, "-"):
            out.append(Item("mark", ",", ","))
            dashed = False
        else:
            out.append(item)
            out += [Item("anew", "anew", item.text)] if former and item.kind == "boundary" else []
        former = former and not (item.kind == "boundary" or kind == "now")
    return out


def _denies_nothing(items: list[Item], k: int) -> bool:
    """Whether this is the `no` of `off the kitchen, no, off the living room`."""
    item, after = items[k], items[k + 1 : k + 2]
    if item.kind != "negation" or item.text != "no" or not after or not is_mark(after[0], ","):
        return False
    if k and items[k - 1].kind not in ("mark", "conjunction", "boundary", "anew") or (k and is_mark(items[k - 1], ":")):
        return False
    if k + 2 < len(items) and items[k + 2].kind == "with" and items[k + 2].value == "in":
        return True
    ahead = [i for i in items[k + 2 :] if i.kind not in LEADING and not is_mark(i, ",")][:2]
    if not ahead:
        return False
    room = ahead[0].room
    related = ahead[0].kind in (*RELATED, *TOLD) or any(i.kind == "enough" for i in ahead)
    return related or (room is not None and (counts(room) or room.quantifier == Det.A))


def _goes_on(items: list[Item], k: int) -> bool:
    """Whether another such word follows: `sorry, I meant`."""
    ahead = [i for i in items[k + 1 : k + 3] if not is_mark(i, ",")][:1]
    return bool(ahead) and ahead[0].kind == "anew" and ahead[0].value == "anew"


def _without_dash(out: list[Item]) -> bool:
    """A comma in the place of the dash before an aside: `three bedrooms - no, two - and …`."""
    dashed = bool(out) and is_mark(out[-1], "-")
    if dashed:
        out[-1] = Item("mark", ",", ",")
    return dashed


def _said_late(out: list[Item]) -> None:
    """`no balcony after all`: the word stands behind what it announces."""
    if out and out[-1].room is not None:
        at = len(out) - 1
        while at and out[at - 1].kind in ("negation", *LEADING):
            at -= 1
        out.insert(at, Item("anew", "anew"))
