"""Standing: nothing in anything else, outside the room, in a doorway, in a leaf's way or tall before a window."""

from collections.abc import Iterator

from apartgen.stages.things.categories import belong_together
from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import CHAIRS, ON_THE_FLOOR, SLENDER
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.site import Hole

DEEP = 0.05
"""What stands deeper in something else collides, m."""
WAY = 0.46
"""From a door to the first piece of furniture, m."""
STRIP = 0.25
"""What stands so near a window is before it, m."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of bodies, walls and openings."""
    for i, j in zip(*(room.deep > DEEP).nonzero()):
        if i < j and _meet(room, int(i), int(j)):
            yield Fault("things stand in one another", room.ids(int(i), int(j)))
    for i in room.upright:
        if room.outside[i] > DEEP:
            yield Fault("stands beyond the wall", room.ids(i))
    for hole in room.site.passages:
        yield from _passage(room, hole)
    for hole in room.site.windows:
        yield from _window(room, hole)


def _meet(room: Furnished, i: int, j: int) -> bool:
    solid = room.stands[i] and room.stands[j]
    return solid and not belong_together(room.names[i], room.names[j])


def _passage(room: Furnished, hole: Hole) -> Iterator[Fault]:
    deep, half = (max(WAY, hole.width) if hole.leaf else WAY), hole.width / 2
    ahead, left = (0.0, deep), (-half, half)
    bare = room.clear(hole.frame, ahead, left, ())
    found = [k for k in room.upright if room.names[k] not in CHAIRS
             and room.clear(hole.frame, ahead, left, (k,)) < bare - 0.05]
    if found:
        yield Fault("stands in a doorway", (*room.ids(*found), hole.id))


def _window(room: Furnished, hole: Hole) -> Iterator[Fault]:
    half = hole.width / 2
    for k in room.upright:
        tall = room.top[k] > max(hole.sill + 0.15, 1.0)
        if tall and room.names[k] in ON_THE_FLOOR - SLENDER:
            if room.clear(hole.frame, (0.0, STRIP), (-half, half), (k,)) < 0.75:
                yield Fault("tall before a window", (*room.ids(k), hole.id))
