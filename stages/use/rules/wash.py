"""Washing: floor before every fixture, elbow room at toilet and basin, the mirror above the basin."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import FIXTURES, MACHINES, MOVED
from apartgen.stages.use.room import Furnished

AXIS = {"toilet": 0.38, "vanity": 0.38}
"""From the axis of a fixture to what stands beside it, m (NKBA bathroom guidelines 5, 6)."""
LOW = 0.3
"""What is smaller is moved with the foot, m."""
SLACK = 0.02


def faults(room: Furnished) -> Iterator[Fault]:
    """Of fixtures of a bathroom, and of washing machines anywhere."""
    for i in room.which(frozenset(FIXTURES)):
        yield from _fixture(room, i)
    for i in room.which(MACHINES):
        if room.site.kind != "kitchen" and room.front(i, 0.6, 0.05, MOVED) < 0.7:
            yield Fault("no floor before the machine", room.ids(i))
    basins = room.which("vanity")
    if basins and room.site.kind == "bathroom":
        mirrors = room.which("mirror")
        if mirrors and not any(abs(room.left[b, m]) < 0.3 and abs(room.ahead[b, m]) < 0.6
                               for m in mirrors for b in basins):
            yield Fault("mirror not above the basin", room.ids(*mirrors))


def _fixture(room: Furnished, i: int) -> Iterator[Fault]:
    name, depth = room.names[i], FIXTURES[room.names[i]]
    half = room.width[i] / 2
    if name == "bath":  # got into along its long side, wherever there is floor
        d, sides = room.depth[i] / 2, ((1, 0), (-1, 0), (0, 1), (0, -1))
        ways = [room.open(i, *_strip(d, half, depth, *side), MOVED) for side in sides]
        free = max(ways)
    else:
        free = room.front(i, depth, 0.0 if name == "shower" else min(0.05, half / 2), MOVED)
    if free < 0.8:
        yield Fault(f"no floor before the {name}", room.ids(i))
    elif name in AXIS and half < AXIS[name]:
        d = room.depth[i] / 2
        strips = ((half + 0.005, AXIS[name] - SLACK), (SLACK - AXIS[name], -half - 0.005))
        if any(room.open(i, (0.0, d), strip, MOVED) < 0.8 for strip in strips):
            yield Fault(f"no elbow room at the {name}", room.ids(i))


def _strip(d: float, half: float, depth: float, x: int, y: int) -> tuple[tuple[float, float], tuple[float, float]]:
    """A strip of floor beside one side of a box, most of its length."""
    if x:
        return ((d + 0.02, d + depth) if x > 0 else (-d - depth, -d - 0.02)), (-0.5 * half, 0.5 * half)
    return (-0.5 * d, 0.5 * d), ((half + 0.02, half + depth) if y > 0 else (-half - depth, -half - 0.02))
