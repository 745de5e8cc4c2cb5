"""Doors told as ways that somebody takes: `through the lounge to reach the kitchen`, `a terrace you reach from it`."""

from apartgen.stages.plan.reader.clausal import again_named
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark

THROUGH = ("through", "via", "crosses", "crossing", "cross")
GOING = ("go", "goes", "walk", "walks", "step", "steps", "drive", "drives", "move", "moves", "leads",
         "opens")  # fmt: skip
INTO = ("to", "into", "onto", "in", "out to", "out onto")
WALKERS = ("you", "we", "one", "get", "enter", "reach")
"""First words of what is told of somebody who comes into a room."""


def journeys(items: list[Item]) -> list[Item]:
    """Each way as a sentence of the two rooms that it joins."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        if (way := _onward(items, k)) is not None:
            k = _told(out, way)
        elif (end := _straight(items, k)) is not None:
            out += [Item("mark", ".", "."), items[k + 1], Item("link", "door", "leads to", form="s"), items[end]]
            k = end + 1
        elif (there := _out_of_it(out, items[k])) is not None:
            out += [Item("mark", ".", "."), again_named(there), Item("link", "door", "leads to", form="s")]
            k += 1 + (k + 1 < len(items) and items[k + 1].kind == "reach")
        elif (way := _to_get_there(items, k)) is not None:
            k = _told(out, way)
        elif users := _that_they_enter(items, k):
            out += [items[k], Item("link", "door", "reached from"), *users]
            k += len(users) + 3
        elif (end := _reached_from(items, k)) is not None:
            out += [items[k], Item("link", "door", "reached from")]
            k = end
        else:
            out.append(items[k])
            k += 1
    return out


def _out_of_it(out: list[Item], item: Item) -> RoomPhrase | None:
    """`at the end of the corridor is the lounge, and from it you go to …`: `it` is what is there."""
    if item.value != "from_which" or item.text.split()[-1] not in ("it", "there"):
        return None
    end = len(out)
    while end and (out[end - 1].kind in ("conjunction", "boundary") or is_mark(out[end - 1], ",")):
        end -= 1
    where, place, verb, room = ([Item("mark", ".")] * 4 + out[:end])[-4:]
    if where.kind != "front" or place.room is None or verb.kind != "copula" or room.room is None:
        return None
    del out[end:]
    return room.room


def _told(out: list[Item], way: tuple[list[Item], int]) -> int:
    """Writes the rooms of a way down pair by pair; returns where the rest begins."""
    rooms, end = way
    while out and (out[-1].kind in ("conjunction", "boundary") or is_mark(out[-1], ",")):
        out.pop()
    if len(rooms) > 2:
        out += [Item("mark", ".", "."), rooms[0], Item("link", "door", "leads to", form="s"), rooms[1]]
    out += [Item("mark", ".", "."), rooms[-1], Item("copula", "s", "is"), Item("link", "only", "reached only from"),
            rooms[-2]]  # fmt: skip
    return end


def _that_they_enter(items: list[Item], k: int) -> list[Item]:
    """The bedrooms of `a bathroom that both bedrooms can access`."""
    end = k + 2
    while end < len(items) and (items[end].room is not None or items[end].kind == "conjunction"):
        end += 1
    which, verb, after = (items[k + 1 : k + 2] + items[end : end + 2] + [Item("mark", ".")] * 3)[:3]
    told = items[k].room is not None and which.kind == "relative" and end > k + 2
    can = verb.kind == "reach" and verb.text.startswith(("can ", "could ", "may ")) and after.room is None
    return items[k + 2 : end] if told and can else []


def _onward(items: list[Item], k: int) -> tuple[list[Item], int] | None:
    """`through A to reach B`, `crosses A to get to B`, `from A through B into C`."""
    start = _from(items, k)
    at = k + 2 if start else k
    if not _through(items, at) or at + 1 >= len(items) or items[at + 1].room is None:
        return None
    if not start and not _walks(items, at):
        return None
    end = _led(items, at + 2, bool(start) or items[at].kind == "reach")
    return ([*start, items[at + 1], items[end]], end + 1) if end is not None else None


def _from(items: list[Item], k: int) -> list[Item]:
    """The room at which somebody starts: `goes from the hall through …`, `from the hall you go through …`."""
    source, room = items[k], items[k + 1 : k + 2]
    words = source.text.split()
    walked = k == 0 or items[k - 1].kind in ("mark", "conjunction", "boundary")
    fits = source.kind in ("link", "front") and words[-1:] == ["from"] and walked and any(i.room for i in room)
    return room if fits else []


def _straight(items: list[Item], k: int) -> int | None:
    """Where the room stands that one goes into from another: `walk from A straight into B`, `from A … walk to B`."""
    way, start, to, verb, room = (items[k : k + 5] + [Item("")] * 5)[:5]
    words = way.text.split()
    if way.kind not in ("link", "front") or words[-1:] != ["from"] or start.room is None:
        return None
    into = to.kind in ("link", "with") and to.text in INTO
    if words[0] in GOING and into and verb.room is not None:
        return k + 3
    if words == ["from"] and into and verb.room is not None and _on_foot(items, k):
        return k + 3
    walked = to.value == "to" and verb.kind == "reach" and verb.text.split()[0] in GOING
    return k + 4 if len(words) == 1 and walked and room.room is not None else None


def _on_foot(items: list[Item], k: int) -> bool:
    """Whether `from A into B` at `k` is where somebody walks, or walks on."""
    start = max((j for j in range(k) if is_mark(items[j], ".;")), default=0)
    walks = any(i.kind == "reach" or i.text.split()[0] in GOING for i in items[start:k] if i.text)
    return walks and items[k - 1].kind in ("reach", "mark", "conjunction")


def _through(items: list[Item], k: int) -> bool:
    return k < len(items) and items[k].kind in ("front", "reach") and items[k].text.split()[-1] in THROUGH


def _walks(items: list[Item], k: int) -> bool:
    """Whether no room stands just before, of which the way would be told: `the study is through the hall`."""
    return k == 0 or (items[k - 1].room is None and items[k - 1].kind not in ("copula", "link", "relative"))


def _led(items: list[Item], k: int, walked: bool) -> int | None:
    """Where the room stands that `to reach` or, of somebody who walks, `into` leads to."""
    to, verb, room = (items[k : k + 3] + [Item("")] * 3)[:3]
    if to.value == "to" and verb.kind == "reach" and room.room is not None:
        return k + 2
    into = to.kind in ("link", "with") and to.text in ("to", "into", "onto", "in")
    return k + 1 if walked and into and verb.room is not None else None


def _to_get_there(items: list[Item], k: int) -> tuple[list[Item], int] | None:
    """`to reach A you walk through B`."""
    to, verb, room = (items[k : k + 3] + [Item("")] * 3)[:3]
    if to.value != "to" or verb.kind != "reach" or room.room is None:
        return None
    at = k + 3
    while at < len(items) and (is_mark(items[at], ",") or items[at].text in ("you have", "one has", "to", "has")):
        at += 1
    if not _through(items, at) or at + 1 >= len(items) or items[at + 1].room is None:
        return None
    return [items[at + 1], room], at + 2


def _reached_from(items: list[Item], k: int) -> int | None:
    """Where the room stands behind `a balcony you step onto from the kitchen`, `a pantry you enter through`."""
    which = k + 1 < len(items) and items[k + 1].kind == "relative"
    verb, on = (items[k + 1 + which : k + 3 + which] + [Item("")] * 2)[:2]
    if items[k].room is None or verb.kind != "reach" or verb.text.split()[0] not in WALKERS:
        return None
    if k and items[k - 1].kind == "front":
        return None  # "from the hall you go through …"
    if verb.text.split()[-1] in ("through", "via", "from") and on.room is not None:
        return k + 2 + which
    at = k + 2 + which + (on.kind == "link" and on.text in ("to", "onto"))
    way, room = (items[at : at + 2] + [Item("")] * 2)[:2]
    leads = way.kind == "front" and way.text in ("from", "through", "via", "out of") and room.room is not None
    return at + 1 if leads else None
