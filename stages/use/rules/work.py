"""Working: desks and dressing tables that one sits at."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import DINERS, SMALL_SEATS
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.rules.eat import at

SIT = 0.6
"""Floor before a desk on which one sits, m."""
AWAY = 0.2
"""At a desk further off every wall one has people behind the screen, m; in a study some like it so."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of desks and dressing tables."""
    for i in room.which("desk") + room.which("dressing_table"):
        if room.back[i] > AWAY and room.wall[i] > AWAY and room.site.kind != "study":
            yield Fault("desk off the wall", room.ids(i))
        seated = any(at(room, s, i) for s in room.which(DINERS | SMALL_SEATS))
        if room.names[i] == "desk" and not seated:
            yield Fault("desk without chair", room.ids(i))
        elif not seated and room.front(i, SIT, 0.1) < 0.7:
            yield Fault("no floor to sit at it", room.ids(i))
