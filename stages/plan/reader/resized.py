"""Areas said anew: `kitchen 10 m², bath 5 m². Sorry, the kitchen is 12 m²`."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det


def of_another(out: list[Item], start: int) -> bool:
    """Whether the room named last, behind `start`, is of a type that was not named before."""
    named = [i.room for i in out[start:] if i.room is not None][-1:]
    return bool(named) and all(i.room is None or i.room.type != named[0].type for i in out[:start])


def measured_anew(out: list[Item], area: Item, start: int) -> bool:
    """`kitchen of 10 m², correction: 12 m²`, of the room named behind `start`, if any; False where no area was said."""
    named = [i.room for i in out[start:] if i.room is not None][-1:]
    return _resized(out, area, start if named else len(out), *named)


def _resized(out: list[Item], area: Item, end: int, named: RoomPhrase | None = None) -> bool:
    """Puts `area` in the place of the last one before `end`, which is said of such a room as `named`, if any is."""
    for k in range(end - 1, -1, -1):
        room = out[k].room
        if out[k].kind == "area" and (named is None or _alike(_sized(out, k), named)):
            out[k] = replace(area, value=out[k].value)
            return True
        if room is not None and room.areas and (named is None or _alike(room, named)):
            room.areas, room.sides, room.bounds = area.values, area.sides, area.bounds
            return True
    return False


def _area_of(room: RoomPhrase) -> Item:
    return Item("area", values=room.areas, sides=room.sides, bounds=room.bounds)


def _sized(items: list[Item], k: int) -> RoomPhrase | None:
    """The room whose area stands at `k`."""
    before = [i for i in items[:k] if i.kind not in ("copula", "with", "area_word") and not is_mark(i, ":(,")]
    return before[-1].room if before else None


def _alike(room: RoomPhrase | None, named: RoomPhrase) -> bool:
    return room is not None and (room.type, room.labels, room.ordinals) == (named.type, named.labels, named.ordinals)


def resized(out: list[Item], room: RoomPhrase) -> None:
    """`correction: kitchen 12 m²`: puts the area in the place of the kitchen's before, where one was said."""
    if room.areas and _resized(out, _area_of(room), len(out), room):
        room.areas, room.sides, room.bounds, room.quantifier = (), (), (), Det.THE
