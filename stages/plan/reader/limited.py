"""Of which rooms lengths, widths and doors are limited, and between which there are to be no doors."""

from apartgen.stages.plan.reader.clauses import clause_of
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.positions import known
from apartgen.stages.plan.reader.statements import Asked, Said
from apartgen.stages.plan.reader.vocabulary import Det

EACH = ("share a wall", "common wall", "wet wall", "plumbing wall", "share walls", "each other",
        "one another", "side by side", "back to back", "nebeneinander", "einander gegenuber",
        "cote a cote", "face a face", "mitoyens", "mitoyennes", "contigus", "contigues", "voisins", "voisines",
        "adjacents", "adjacentes", "contiguos", "contiguas", "colindantes")
ACROSS = ("opposite", "across", "fac", "einander geg")
VERBAL, PLACED = ("with", "copula", "relative", "conjunction"), ("side", "place", "area", "reach")
NARROW = 3.0
"""Metres below which a least extent of a hallway is its width."""
DOOR = ("door", "doors", "tur", "turen", "porte", "portes", "puerta", "puertas")
OFF = ("off", "off of", "in", "from", "opening off", "onto")
"""What stands between doors and the hallway whose they are."""
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
            skip = int(items[k + 1].room is None)
        elif (room := _before(items, k)) is not None:
            _ask(item, known(room, items), said)
            clause_of(out, [room], item.text)
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
            out += [Item("mark", ".", ".")] if k < len(items) and is_mark(items[k], ",") else []
        elif denied and _has_none(out, items[k : k + 4]):
            owner = next(i for i in reversed(out) if i.room is not None)
            owner = _subject_again(out) or owner
            while out[-1].kind in VERBAL or out[-1].text == "but":
                out.pop()
            out += [] if out[-1] is owner else [Item("mark", ".", "."), owner]
            k += 1 + (link.kind == "link")
            out += [Item("negation", "not", no.text), Item("link", "door", "door to"), items[k]]
            k += 1 + (k + 1 < len(items) and items[k + 1].value == "has")
            out += [Item("mark", ".", ".")] if _new_room(items[k : k + 2]) else []
        else:
            out.append(items[k])
            k += 1
    return out


def _subject_again(out: list[Item]) -> Item | None:
    """The kitchen of `the kitchen has a door to the lounge and no door to the hall`."""
    end = len(out) - (out[-1].value == "has")
    subject, link, room, joint = ([Item("")] * 4 + out[:end])[-4:]
    told = link.kind == "link" and link.form == "s" and subject.room is not None and room.room is not None
    return subject if told and joint.kind in ("conjunction", "boundary") else None


def _has_none(out: list[Item], ahead: list[Item]) -> bool:
    """`the kitchen has no door to the hall`, `keine Tür zum Flur`, after the room spoken of."""
    owner = next((i for i in reversed(out) if i.kind not in (*VERBAL, *PLACED) and i.text != "but"), None)
    no, link, *rest = [*ahead, Item("")]
    doors = link.value == "door" or any(word in no.text.split() for word in DOOR)
    other = link if link.room is not None else rest[0] if rest and link.value in ("door", "to") else Item("")
    return owner is not None and owner.room is not None and doors and other.room is not None


def _new_room(ahead: list[Item]) -> bool:
    """`…, two bedrooms`: a list of rooms goes on after what was denied."""
    room = ahead[1].room if len(ahead) > 1 and is_mark(ahead[0], ",") else None
    return room is not None and (room.count is not None or room.quantifier == Det.A)


def mutual(items: list[Item], said: Said) -> list[Item]:
    """Takes out what rooms of one phrase are to one another: `two bedrooms opposite each other`."""
    out: list[Item] = []
    skip = 0
    for k, item in enumerate(items):
        if skip:
            skip -= 1
            continue
        if _between_many(items, k):
            said.unread.append(f"{item.text.removesuffix(' door')} doors between")  # "… hall, lounge and kitchen"
        if (pair := _between_two(items, k)) is not None:
            said.asked.append(Asked("no_door", [pair], [pair], "", f"{item.text} doors between {pair.text}"))
            skip = 1
            continue
        alone = item.value == "apart" and (k + 1 == len(items) or items[k + 1].kind in ("mark", "boundary"))
        each = item.text.endswith(EACH) or alone or any(i.value == "mutual" for i in items[k + 1 : k + 2])
        between = ("copula", "relative", "negation", "area", "pronoun")
        said_of = (i for i in reversed(_told_of_them(out)) if not (i.kind in between or is_mark(i, ",") or _each(i)))
        rooms = next((i.room for i in said_of), None)
        if rooms is not None and each and _counted_before(rooms, out):
            rooms.plural = True
        several = rooms is not None and (rooms.plural or (rooms.count or 1) > 1)
        if item.kind == "link" and item.value in ("near", "apart") and each and rooms is not None and several:
            denied = _none_of(rooms, out) or any(i.kind == "negation" for i in out[-2:])
            apart = denied or item.value == "apart"
            kind = "opposite" if item.text.startswith(ACROSS) else "apart" if apart else "adjacent"
            out = _told_of_them(out)
            while out[-1].kind in VERBAL or out[-1].kind == "negation" or is_mark(out[-1], ","):
                out.pop()
            said.asked.append(Asked(kind, [rooms], [rooms], "", f"{rooms.text} {item.text} each other"))
            skip = int(not item.text.endswith(EACH) and not alone)
        else:
            out.append(item)
    return out


def _counted_before(rooms: RoomPhrase, out: list[Item]) -> bool:
    """`zwei Schlafzimmer. Die Schlafzimmer …`: one word is the plural too."""
    known = (i.room for i in out if i.room is not None and i.room is not rooms and i.room.type == rooms.type)
    return rooms.quantifier == Det.THE and not rooms.labels and any((room.count or 1) > 1 for room in known)


def _told_of_them(out: list[Item]) -> list[Item]:
    """`two bedrooms, and they must not be` without what begins the clause about them."""
    at = len(out)
    while at and out[at - 1].kind in ("negation", "copula"):
        at -= 1
    if not (at > 1 and out[at - 1].text == "they" and out[at - 2].kind in ("conjunction", "boundary", "mark")):
        return out
    end = at - 1
    while end and (out[end - 1].kind in ("conjunction", "boundary") or is_mark(out[end - 1], ",;.")):
        end -= 1
    return [*out[:end], *out[at:]]


def _none_of(rooms: RoomPhrase, out: list[Item]) -> bool:
    """`no two bedrooms share a wall`: said of all of them, which there are."""
    if not rooms.negated:
        return False
    rooms.negated, rooms.plural, rooms.count, rooms.quantifier = False, True, None, Det.THE
    out[:] = [i for i in out if i.kind != "negation" or i is not _before_room(out, rooms)]
    return True


def _before_room(out: list[Item], room: RoomPhrase) -> Item:
    at = next(k for k, i in enumerate(out) if i.room is room)
    return out[at - 1] if at else Item("")


def _between_two(items: list[Item], k: int) -> RoomPhrase | None:
    """The rooms of `no door between the two bedrooms`."""
    no, link, rooms, end = (items[k : k + 4] + [Item("mark", ".")] * 4)[:4]
    pair = rooms.room if no.kind == "negation" and link.value == "between" else None
    several = pair is not None and (pair.plural or (pair.count or 1) > 1) and end.kind != "conjunction"
    return pair if several else None


def _between_many(items: list[Item], k: int) -> bool:
    no, link, a, joint, b = (items[k : k + 5] + [Item("")] * 5)[:5]
    listed = a.room is not None and is_mark(joint, ",") and b.room is not None
    return no.kind == "negation" and no.value in ("no", "without") and link.value == "between" and listed


def _each(item: Item) -> bool:
    """The `each` of `two bedrooms of 14 m² each`."""
    return item.room is not None and item.room.type == "" and item.room.quantifier == Det.EACH


def _ask(item: Item, room: RoomPhrase, said: Said) -> None:
    kind, _, extent = item.value.partition(":")
    if not extent and room.type != "hallway":
        said.unread.append(item.text)
        return
    extent = extent or ("width" if kind == "at_least" and item.number < NARROW else "length")
    said.asked.append(Asked(kind, [room], extent, f"{item.number:g}", f"{room.text} {item.text}"))


def _ahead(items: list[Item], k: int) -> RoomPhrase | None:
    """The room behind `at most four doors off`; that before it has doors of its own: `the hall has four doors`."""
    if k + 1 < len(items) and items[k + 1].value == "hallway" and items[k].value.endswith("doors"):
        return items[k + 1].room
    if k + 2 >= len(items) or items[k + 1].kind not in BETWEEN or not items[k].value.endswith("doors"):
        return None
    opens = k == 0 or items[k - 1].kind in ("mark", "conjunction", "boundary", "reach")
    opens = opens or (items[k - 1].kind == "with" and items[k + 2].value == "hallway" and items[k + 1].text in OFF)
    return items[k + 2].room if opens else None


def _before(items: list[Item], k: int) -> RoomPhrase | None:
    """The last room before a limit in its sentence; None where furniture stands between."""
    start = max((j + 1 for j in range(k) if is_mark(items[j], ".")), default=0)
    if k > start and items[k - 1].kind == "conjunction":  # "the store is far from the bathroom and 1.5 m wide"
        return next((i.room for i in items[start:k] if i.room is not None and not i.room.headline), None)
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
