"""Working: desks and dressing tables that one sits at."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import DINERS, SMALL_SEATS
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.rules.eat import at

SIT = 0.6
"""Floor before a desk on which one sits, m."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of desks and dressing tables."""
    for i in room.which("desk") + room.which("dressing_table"):
        seated = any(at(room, s, i) for s in room.which(DINERS | SMALL_SEATS))
        if room.names[i] == "desk" and not seated:
            yield Fault("desk without chair", room.ids(i))
        elif not seated and room.front(i, SIT, 0.1) < 0.7:
            yield Fault("no floor to sit at it", room.ids(i))
