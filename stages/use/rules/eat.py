"""Eating: chairs at tables, facing them, with room to be drawn back."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import CHAIRS, DESKS, DINERS, TABLE_TOPS
from apartgen.stages.use.room import Furnished

AT, AT_DESK = 0.3, 0.5
"""A seat no further from its table's edge is at it, m."""
SQUARE = 35.0
"""It looks at the table within so many degrees."""
BEHIND = 0.35
"""A chair is drawn back by this to be got out of, m; .81 m of table edge to wall, less the chair drawn in."""
CROWD = 0.02
"""Chairs at one table stand no deeper in one another, m."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of dining tables and every chair."""
    for t in room.which(TABLE_TOPS - {"island"}):
        seats = diners(room, t)
        if not seats:
            yield Fault("table without chairs", room.ids(t))
        elif len(seats) == 1 and room.names[t] != "balcony_table":
            yield Fault("table with one chair", room.ids(t, *seats))
        elif len(seats) % 2:
            yield Fault("table with an odd number of chairs", room.ids(t, *seats))
        if lonely := [s for s in seats if len(seats) > 1 and not across(room, t, s, seats)]:
            yield Fault("chair with none across", room.ids(t, *lonely))
        if any(room.deep[s, other] > CROWD for s in seats for other in seats):
            yield Fault("chairs crowd the table", room.ids(t, *seats))
    for c in room.which(CHAIRS):
        yield from _chair(room, c)


def diners(room: Furnished, table: int) -> list[int]:
    """Seats at a table, facing it."""
    return [s for s in room.which(DINERS) if at(room, s, table)]


def at(room: Furnished, seat: int, table: int) -> bool:
    """Whether one sits there at that table or desk."""
    far = AT if room.names[table] in TABLE_TOPS else AT_DESK
    return bool(room.gap[seat, table] <= far and (room.look[seat, table] <= SQUARE or room.names[seat] == "stool"))


def across(room: Furnished, table: int, seat: int, seats: list[int]) -> bool:
    """Whether another seat faces this one over the table, mirrored about one of its axes or its middle."""
    x, y = room.ahead[table, seat], room.left[table, seat]
    for other in seats:
        u, v = room.ahead[table, other], room.left[table, other]
        mirrored = (abs(x + u) < 0.2 and abs(y - v) < 0.2) or (abs(x - u) < 0.2 and abs(y + v) < 0.2)
        if other != seat and (mirrored or (abs(x + u) < 0.2 and abs(y + v) < 0.2)):
            return True
    return False


def _chair(room: Furnished, c: int) -> Iterator[Fault]:
    tables = [t for t in room.which(TABLE_TOPS | DESKS) if at(room, c, t)]
    if not tables:
        yield Fault("chair at nothing", room.ids(c))
        return
    d, w = room.depth[c] / 2, 0.8 * room.width[c] / 2
    if room.open(c, (-d - BEHIND, -d - 0.02), (-w, w), CHAIRS) < 0.6:
        yield Fault("chair cannot be drawn back", room.ids(c, *tables))
