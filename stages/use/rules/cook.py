"""Cooking: one run of units, worktop between sink and hob, the hood above the hob, floor to stand on."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import CLOSED, COLD, COUNTERS, HOT, MOVED, RUN, WET, WORKTOPS
from apartgen.stages.use.room import Furnished

JOINED = 0.08
"""Units of one run stand no further apart, m."""
ABOVE = 0.10
"""A hood's axis is no further from its hob's, m."""
AISLE = 0.9
"""Floor before units, m; NKBA asks for 1.07 for one cook."""
TOP, LITTLE_TOP = 1.2, 0.6
"""Worktop in one piece beside the sink or the hob, m; in kitchens below `SMALL` m² the latter."""
SMALL = 5.5
TRIANGLE = 7.92
"""Longest way from sink to hob to fridge and back, m (NKBA kitchen guideline 3)."""
PUT_DOWN, CORNER = 0.28, 0.2
"""Worktop between sink and hob, and from a hob to a wall at its side, m (NKBA wants more)."""
TALL = 1.3
"""An oven this high is no hob, m."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of kitchen units, of what hangs above them and of stools at counters."""
    if room.site.kind not in ("kitchen", "living_room"):
        return
    units = room.which(RUN)
    if room.site.kind == "kitchen" or room.count["kitchen_sink"]:
        yield from _run(room, units)
        yield from _worktop(room, units)
        yield from _triangle(room)
    for i in units:
        if room.names[i] not in CLOSED and room.front(i, AISLE, 0.05, MOVED) < 0.6:
            yield Fault("no floor before the kitchen unit", room.ids(i))
        if room.back[i] > 0.15 and room.wall[i] > 0.05:
            yield Fault("kitchen unit off the wall", room.ids(i))
    yield from _hung(room, units)
    for i in room.which("stool"):
        if room.site.kind == "kitchen" and not room.beside(i, COUNTERS, 0.4):
            yield Fault("stool without a counter", room.ids(i))


def hobs(room: Furnished) -> list[int]:
    """What one cooks on: hobs, else cookers."""
    return room.which("hob") or [i for i in room.which(HOT) if room.top[i] < TALL]


def runs(room: Furnished, units: list[int]) -> list[list[int]]:
    """Units that stand in one piece, the longest run first."""
    left, found = list(units), list[list[int]]()
    while left:
        run = [left.pop(0)]
        for i in run:  # which grows
            run += (near := [j for j in left if room.gap[min(i, j), max(i, j)] <= JOINED])
            left = [j for j in left if j not in near]
        found.append(sorted(run))
    return sorted(found, key=len, reverse=True)


def worktop(room: Furnished, units: list[int]) -> float:
    """The longest piece of worktop beside a sink or a hob, m."""
    ends = [*room.which(WET), *hobs(room)]
    pieces = runs(room, [i for i in units if room.names[i] in WORKTOPS])
    return max((sum(room.width[i] for i in piece) for piece in pieces
                if any(room.gap[i, e] <= JOINED for i in piece for e in ends)), default=0.0)


def _run(room: Furnished, units: list[int]) -> Iterator[Fault]:
    first, *others = runs(room, units) or [[]]
    for part in others:
        facing = len(part) > 1 and all(room.turn[first[0], i] > 150 for i in part) or (
            len(part) > 1 and any(room.turn[i, j] > 150 for i in first for j in part))
        if len(part) == 1:
            cold = room.names[part[0]] in COLD
            yield Fault("fridge apart from the run" if cold else "kitchen unit alone", room.ids(*part))
        elif not facing:
            yield Fault("kitchen run in pieces", room.ids(*part))


def _worktop(room: Furnished, units: list[int]) -> Iterator[Fault]:
    if room.count["kitchen_sink"] and worktop(room, units) < (LITTLE_TOP if room.site.area < SMALL else TOP) - 0.01:
        yield Fault("little worktop beside sink and hob", room.ids(*room.which(WET)))
    for i in hobs(room):
        if any(room.gap[i, k] <= JOINED and room.top[k] > TALL for k in units):
            yield Fault("hob beside a tall unit", room.ids(i))
        if room.wall_beside(i) < CORNER:
            yield Fault("hob in the corner", room.ids(i))
    yield from _between(room)


def _between(room: Furnished) -> Iterator[Fault]:
    """Of what is between sink and hob: worktop to put down on, and nothing tall."""
    for i in room.which(WET):
        for k in hobs(room):
            if room.site.area >= SMALL and room.gap[i, k] < PUT_DOWN:
                yield Fault("no worktop between sink and hob", room.ids(i, k))
            tall = [t for t in room.which(COLD) if room.top[t] > TALL and room.lies_between(t, i, k)]
            if tall:
                yield Fault("tall unit between sink and hob", room.ids(i, k, *tall))


def _triangle(room: Furnished) -> Iterator[Fault]:
    corners = [kind[0] for kind in (room.which(WET), hobs(room), room.which(COLD)) if kind]
    if len(corners) == 3:
        a, b, c = (room.boxes.center[i, :2] for i in corners)
        if sum(float(((p - q) ** 2).sum() ** 0.5) for p, q in ((a, b), (b, c), (c, a))) > TRIANGLE:
            yield Fault("sink, hob and fridge far apart", room.ids(*corners))


def _hung(room: Furnished, units: list[int]) -> Iterator[Fault]:
    for i in room.which("hood"):
        if not any(abs(room.left[h, i]) <= ABOVE and abs(room.ahead[h, i]) < 0.5 for h in hobs(room)):
            yield Fault("hood not above the hob", room.ids(i))
    for i in room.which("wall_unit"):
        if not any(room.gap[i, k] < 0.01 for k in units):
            yield Fault("wall unit above nothing", room.ids(i))
