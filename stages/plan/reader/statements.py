"""What a prompt says, as statements between room phrases."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.about import About
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Relation
from apartgen.stages.plan.reader.workers import Working


@dataclass(frozen=True, eq=False)
class Statement:
    """What `left` is to `right`; of a comparison, left = number × right.

    `relation` are the words that stood between the rooms.
    """

    kind: Relation
    left: list[RoomPhrase]
    right: list[RoomPhrase]
    number: float = 1.0
    relation: str = ""


@dataclass(frozen=True)
class Asked:
    """What else is asked of rooms: `kind` and `value` as in `schemas.plan.Requirement`, `to` other rooms or a place."""

    kind: str
    of: list[RoomPhrase]
    to: list[RoomPhrase] | str
    value: str
    text: str


@dataclass
class Said:
    """Everything read from a prompt. `rooms` in the order of the text, owned ones after their owners.

    `equal` says that the rooms one lives and sleeps in, which are counted together, are of one size; `in_all` is how
    many rooms there are to be, with the words; `uncounted` are things without a room of which nobody says how many.
    `studies_for_work`: that those who work at home have unsaid.
    """

    rooms: list[RoomPhrase] = field(default_factory=list)
    statements: list[Statement] = field(default_factory=list)
    loose_objects: list[tuple[str, int]] = field(default_factory=list)
    uncounted: set[str] = field(default_factory=set)
    total_area: float | None = None
    flat_size: float = 1.0
    dwelling: str = ""
    main_rooms: int | None = None
    in_all: tuple[int, str] | None = None
    main_area: float | None = None
    equal: bool = False
    open_plan: bool = False
    only: bool = False
    described: bool = False
    graph: bool = False
    styles: list[str] = field(default_factory=list)
    shape: str = ""
    sides: list[tuple[str, str]] = field(default_factory=list)
    unread: list[str] = field(default_factory=list)
    seen_from: list[RoomPhrase] = field(default_factory=list)
    asked: list[Asked] = field(default_factory=list)
    corrected: list[tuple[str, str]] = field(default_factory=list)
    beyond: list[tuple[str, str]] = field(default_factory=list)
    prompt: str = ""
    about: About = field(default_factory=About)
    working: Working = field(default_factory=Working)
    studies_for_work: int = 0


def door_pairs(items: list[Item]) -> list[Item]:
    """`(hallway, kitchen)` in a list of connections is a sentence of its own: `hallway - kitchen`."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        first, joint, second, close = (items[k + 1 : k + 5] + [Item("")] * 4)[:4]
        pair = first.room is not None and is_mark(joint, ",-:") and second.room is not None and is_mark(close, ")")
        following = items[k + 1] if k + 1 < len(items) else Item("")
        if items[k].room is not None and following.room is not None and following.joined:  # "hallway-kitchen"
            out += [Item("mark", "."), items[k], Item("mark", "-", "-"), following, Item("mark", ".")]
            k += 2
        elif is_mark(items[k], "(") and pair:
            out += [Item("mark", "."), first, Item("mark", "-", "-"), second, Item("mark", ".")]
            k += 5
        else:
            out.append(items[k])
            k += 1
    return out


def lists_doors(items: list[Item]) -> bool:
    """`hall: lounge, kitchen; lounge: balcony`: rooms named before head lists of their own."""
    named: set[str] = set()
    heads = 0
    for sentence in sentences(items):
        rooms = [i.room for i in sentence if i.room is not None]
        single = bool(rooms) and sentence[0].room is not None and not rooms[0].plural and not rooms[0].count
        if single and len(rooms) > 1 and is_mark(sentence[1], ":") and sentence[2].room is not None:
            heads += rooms[0].type in named or not heads
        named |= {r.type for r in rooms}
    return heads > 1


def between_pairs(items: list[Item]) -> list[Item]:
    """`doors between foyer and lounge, lounge and kitchen`: each pair a sentence of its own."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        j = k + 1 + (k + 1 < len(items) and is_mark(items[k + 1], ":"))
        pairs, end = _pairs(items, j) if items[k].value == "between" else ([], k)
        if len(pairs) > 1:
            for a, b in pairs:
                out += [Item("mark", "."), a, Item("mark", "-", "-"), b]
            out.append(Item("mark", "."))
            k = end
        else:
            out.append(items[k])
            k += 1
    return out


def _pairs(items: list[Item], j: int) -> tuple[list[tuple[Item, Item]], int]:
    """`A and B, C and D` from `j` on, and where it ends."""
    out: list[tuple[Item, Item]] = []
    end = j
    while j + 2 < len(items) and items[j].room is not None and items[j + 2].room is not None:
        joined = items[j + 1].kind == "conjunction"
        if not joined or any(i.room is None or i.room.plural or i.room.count for i in (items[j], items[j + 2])):
            break
        out.append((items[j], items[j + 2]))
        end = j = j + 3
        while j < len(items) and (is_mark(items[j], ",") or items[j].kind in ("conjunction", "link")):
            j += 1
    return out, end


def sentences(items: list[Item]) -> list[list[Item]]:
    """Items cut at full stops."""
    out: list[list[Item]] = [[]]
    for item in items:
        if is_mark(item, "."):
            out.append([])
        else:
            out[-1].append(item)
    return [s for s in out if s]
