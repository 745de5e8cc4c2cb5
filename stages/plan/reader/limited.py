"""Of which rooms lengths, widths and doors are limited, and between which there are to be no doors."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.positions import known
from apartgen.stages.plan.reader.statements import Asked, Said

BETWEEN = ("link", "with", "copula", "reach", "relative", "front")
"""What may stand between a limit of doors and its room: `at most four doors off the hallway`."""


def limited(items: list[Item], said: Said) -> list[Item]:
    """Adds limits to what is asked; returns the items without them."""
    out: list[Item] = []
    skip = 0
    for k, item in enumerate(items):
        if skip:
            skip -= 1
        elif item.kind != "limit":
            out.append(item)
        elif (ahead := _ahead(items, k)) is not None:
            _ask(item, ahead, said)
            skip = 1
        elif (room := _before(items, k)) is not None:
            _ask(item, known(room, items), said)
            _without_verb(out, items[k + 1 : k + 3])
        else:
            said.unread.append(item.text)
    return out


def undoored(items: list[Item]) -> list[Item]:
    """`no door between A and B`, `no access from A to B` as `A not door B`."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        no, link, a, joint, b = (items[k : k + 5] + [Item("")] * 5)[:5]
        pair = a.room is not None and b.room is not None and joint.kind in ("conjunction", "link")
        denied = no.kind == "negation" and no.value in ("no", "without")
        if denied and pair and (link.value in ("between", "door", "from") or link.text == "entre"):
            out += [Item("mark", ".", "."), a, Item("negation", "not", no.text), Item("link", "door", link.text), b]
            k += 5
        else:
            out.append(items[k])
            k += 1
    return out


def _ask(item: Item, room: RoomPhrase, said: Said) -> None:
    kind, _, extent = item.value.partition(":")
    if not extent and room.type != "hallway":
        said.unread.append(item.text)
        return
    said.asked.append(Asked(kind, [room], extent or "length", f"{item.number:g}", f"{room.text} {item.text}"))


def _ahead(items: list[Item], k: int) -> RoomPhrase | None:
    """The room behind `at most four doors off`; that before it has doors of its own: `the hall has four doors`."""
    if k + 2 >= len(items) or items[k + 1].kind not in BETWEEN or not items[k].value.endswith("doors"):
        return None
    opens = k == 0 or items[k - 1].kind in ("mark", "conjunction", "boundary", "reach")
    return items[k + 2].room if opens else None


def _before(items: list[Item], k: int) -> RoomPhrase | None:
    """The last room before a limit in its sentence; None where furniture stands between."""
    for item in reversed(items[:k]):
        if is_mark(item, ".") or item.kind == "object":
            return None
        if item.room is not None and not item.room.headline:
            return item.room
    return None


def _without_verb(out: list[Item], ahead: list[Item]) -> None:
    """Takes away the `with` of `a hallway with four doors at most`, which leads to nothing else."""
    goes_on = len(ahead) > 1 and ahead[0].kind == "conjunction" and ahead[1].kind in ("room", "object")
    if out and out[-1].kind in ("with", "copula", "relative") and not goes_on:
        out.pop()
