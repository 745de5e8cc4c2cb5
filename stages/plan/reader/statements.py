"""What a prompt says, as statements between room phrases."""

from dataclasses import dataclass, field

from stages.plan.reader.mention import Item, RoomPhrase, is_mark


@dataclass(eq=False)
class Statement:
    """`kind`: door, only, open, near, share, not (no door), compare (left = number × right), equal."""

    kind: str
    left: list[RoomPhrase]
    right: list[RoomPhrase]
    number: float = 1.0


@dataclass
class Said:
    """Everything read from a prompt. `rooms` in the order of the text, owned ones after their owners."""

    rooms: list[RoomPhrase] = field(default_factory=list)
    statements: list[Statement] = field(default_factory=list)
    loose_objects: list[tuple[str, int]] = field(default_factory=list)
    total_area: float | None = None
    flat_size: float = 1.0
    dwelling: str = ""
    main_rooms: int | None = None
    only: bool = False
    graph: bool = False
    styles: list[str] = field(default_factory=list)
    shape: str = ""
    sides: list[tuple[str, str]] = field(default_factory=list)
    unread: list[str] = field(default_factory=list)


def door_pairs(items: list[Item]) -> list[Item]:
    """`(hallway, kitchen)` in a list of connections is a sentence of its own: `hallway - kitchen`."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        first, joint, second, close = (items[k + 1 : k + 5] + [Item("")] * 4)[:4]
        pair = first.room is not None and is_mark(joint, ",-:") and second.room is not None and is_mark(close, ")")
        if is_mark(items[k], "(") and pair:
            out += [Item("mark", "."), first, Item("mark", "-", "-"), second, Item("mark", ".")]
            k += 5
        else:
            out.append(items[k])
            k += 1
    return out


def sentences(items: list[Item]) -> list[list[Item]]:
    """Items cut at full stops."""
    out: list[list[Item]] = [[]]
    for item in items:
        if is_mark(item, "."):
            out.append([])
        else:
            out[-1].append(item)
    return [s for s in out if s]
