"""Sleeping: beds that one gets into, their heads at walls, nightstands within reach."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import BEDS, BESIDE_A_BED, DOUBLE
from apartgen.stages.use.room import Furnished

HEAD = 0.25
"""A head stands no further off a wall, m."""
SIDE = 0.45
"""What one needs beside a bed to get in, m; HUD asks for .30 on the lesser side and .56 on the other."""
FREE = 0.65
"""Share of the floor beside a bed that must be free."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of beds and nightstands."""
    beds = room.which(BEDS)
    for i in beds:
        name, free = room.names[i], sides(room, i)
        at_wall = room.back[i] <= HEAD or (name not in DOUBLE and room.wall[i] <= HEAD)
        if not at_wall:
            yield Fault("bed head off the wall", room.ids(i))
        if not free:
            yield Fault("no side to get into bed", room.ids(i))
        elif name in DOUBLE and free == 1:
            yield Fault("one side to get into double bed", room.ids(i))
    for i in room.which("nightstand"):
        if not any(within_reach(room, bed, i) for bed in beds):
            yield Fault("nightstand away from bed", room.ids(i))


def within_reach(room: Furnished, bed: int, i: int) -> bool:
    """Whether an object stands beside the head of a bed, where one reaches it lying down."""
    beside = abs(float(room.left[bed, i])) - (room.width[bed] + room.width[i]) / 2
    from_head = float(room.ahead[bed, i]) + room.depth[bed] / 2
    return from_head < 0.75 and -0.25 < beside < 0.35


def sides(room: Furnished, bed: int) -> int:
    """Long sides along which one gets in."""
    d, w = room.depth[bed] / 2, room.width[bed] / 2
    strips = ((w + 0.02, w + SIDE), (-w - SIDE, -w - 0.02))
    return sum(room.open(bed, (-0.3 * d, 0.8 * d), strip, BESIDE_A_BED) >= FREE for strip in strips)
