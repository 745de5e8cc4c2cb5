"""Areas said anew: `kitchen 10 m², bath 5 m². Sorry, the kitchen is 12 m²`."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.vocabulary import Det

SMALLEST = 18.0
"""Area, m², that no home falls below; `a storage room of 15 m²` is a room."""


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


def of_the_last(items: list[Item], before: list[RoomPhrase]) -> list[Item]:
    """`It measures 30 m²` gives an area to the one room spoken of before, as far as a room may have it."""
    said_of = [i for i in items if i.kind not in ("copula", "conjunction", "mark", "area_word", "reach")]
    area = said_of[-1] if said_of else None
    spoken = [i.kind for i in said_of]
    named = spoken == ["pronoun", "area"] or (spoken == ["area"] and any(i.kind == "area_word" for i in items))
    if area is None or not named or len(before) != 1 or before[0].areas:
        return items
    small = area.values[0] < SMALLEST  # "one bedroom. its size is 12 m²"
    if area.values[0] > 5 * sense()["area"].get(before[0].type, 12.0) or before[0].headline and not small:
        return items
    before[0].areas, before[0].sides, before[0].bounds = area.values, area.sides, area.bounds
    return []
