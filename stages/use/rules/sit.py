"""Sitting: sofas, armchairs, coffee tables and the television as one group that works."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import BEDS, BEFORE_A_SEAT, CHAIRS, DESKS, EASY, SMALL_SEATS, SOFAS, TABLE_TOPS, TABLES
from apartgen.stages.use.room import Furnished

FACING, HALF_FACING = 30.0, 60.0
"""Who looks within so many degrees of something faces it, or half does."""
CLOSE, FAR = 0.2, 0.75
"""A coffee table is reached from .30 to .46 m; outside these one stoops or bumps one's shins."""
TALK = 3.0
"""People talk across no more than this, m."""
SEEN_FROM, SEEN_FROM_BED, SEEN_TO = 1.0, 0.5, 5.5
"""From a seat, or the foot of a bed, to a screen at least, and at most, m."""
AGAINST = 0.35
"""Between a dining table and a sofa one passes, m."""
SMALL = 3.0 * 1.147
"""A screen is watched from no further than three times its diagonal, in its widths (16 : 9)."""
REACH = 0.45
"""A side table is within reach of its seat, m."""
TURNED, STRANDED, ELBOW = 70.0, 2.0, 0.2
"""An armchair beside a sofa looks at the sofa or its table within so many degrees, stands no further from them, and
leaves a chair at a table room to be drawn back, m."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of sofas, armchairs, coffee tables, screens, and what stands by them."""
    screens = shown(room)
    yield from _sofas(room, screens)
    yield from _coffee(room)
    for i in room.which("armchair"):
        if room.site.kind != "study" and not _in_company(room, i, screens):
            yield Fault("armchair looks at nothing", room.ids(i))
        yield from _armchair(room, i)
    for i in screens:
        yield from _screen(room, i)
    yield from _companions(room)


def _armchair(room: Furnished, i: int) -> Iterator[Fault]:
    """What keeps an armchair from the group of a sofa, or is kept from moving by it."""
    for table in room.which(TABLES):
        wedged = [c for c in room.which(CHAIRS) if room.gap[c, table] < AGAINST and room.gap[i, c] < ELBOW]
        if (room.gap[i, table] < AGAINST or wedged) and room.look[i, table] > 35:
            yield Fault("armchair against the dining table", room.ids(i, table))
    group = [*room.which(SOFAS), *room.which("coffee_table")]
    if room.count["sofa"] + room.count["corner_sofa"] and not room.beside(i, DESKS, 0.5):
        if min(room.aside[i, k] for k in group) > TURNED:
            yield Fault("armchair turned from the group", room.ids(i))
        if min(room.gap[i, k] for k in group) > STRANDED:
            yield Fault("armchair apart from the group", room.ids(i))


def shown(room: Furnished) -> list[int]:
    """Screens: stands, and televisions that stand on anything else."""
    stands = room.which("tv_stand")
    loose = [i for i in room.which("tv") if not any(room.gap[i, j] < 0.01 for j in stands)]
    return stands + loose


def main_sofa(room: Furnished) -> int | None:
    """The widest sofa."""
    return max(room.which(SOFAS), key=lambda i: room.width[i], default=None)


def before(room: Furnished, seat: int, i: int, reach: float = 1.1) -> bool:
    """Whether something stands across the front of a seat, its near edge within `reach`."""
    (near, right), (_, left) = room.least[seat, i], room.most[seat, i]
    half = room.width[seat] / 2
    common = min(left, half) - max(right, -half)
    inside = 0.9 if room.names[seat] == "corner_sofa" else 0.15
    return bool(-inside < near - room.depth[seat] / 2 < reach and common > 0.3 * min(left - right, 2 * half))


def _sofas(room: Furnished, screens: list[int]) -> Iterator[Fault]:
    sofas, main = room.which(SOFAS), main_sofa(room)
    for i in sofas:
        if screens:
            off = min(float(room.aside[i, s]) for s in screens)
            if off > HALF_FACING and i == main:
                yield Fault("sofa not facing the television", room.ids(i, *screens))
            elif off > HALF_FACING and not _in_company(room, i, screens):
                yield Fault("second sofa turned from the television", room.ids(i, *screens))
            elif FACING < off <= HALF_FACING:
                yield Fault("sofa aside of the television", room.ids(i, *screens))
        elif len(sofas) + room.count["armchair"] + room.count["coffee_table"] > 1 and not _in_company(room, i, screens):
            yield Fault("sofa looks at nothing", room.ids(i))
        yield from _walled_in(room, i)
    for i in sofas:
        for j in sofas:
            if i != j and room.turn[i, j] < 30 and room.ahead[i, j] > 0.5 and before(room, i, j, 2.5):
                yield Fault("sofa looks at the back of another", room.ids(i, j))


def _walled_in(room: Furnished, i: int) -> Iterator[Fault]:
    """What stands right before a sofa, or between it and its screen."""
    d, w = room.depth[i] / 2, 0.4 * room.width[i]
    ahead = (d + 0.05, d + 0.5)
    if room.clear(room.frame(i), ahead, (-w, w), ()) - room.open(i, ahead, (-w, w), BEFORE_A_SEAT | SOFAS) > 0.1:
        yield Fault("something right before the sofa", room.ids(i))
    if room.clear(room.frame(i), (d + 0.05, d + 1.0), (-0.2, 0.2), ()) < 0.75:
        yield Fault("sofa looks at a near wall", room.ids(i))
    for bed in room.which(BEDS):
        if room.aside[i, bed] < 35 and room.gap[i, bed] < 1.2:
            yield Fault("sofa looks into a bed", room.ids(i, bed))
    for table in room.which(TABLES):
        if room.gap[i, table] < AGAINST:
            yield Fault("dining table against the sofa", room.ids(table, i))
    for screen in shown(room):
        if room.aside[i, screen] < FACING and (between := _between(room, i, screen)):
            yield Fault("view of the television barred", room.ids(i, screen, *between))
        elif room.aside[i, screen] < FACING and (between := [
                k for side in (-0.3, 0.3) for k in _between(room, i, screen, side * room.width[i])]):
            yield Fault("view of the television barred in part", room.ids(i, screen, *between))


def _between(room: Furnished, seat: int, screen: int, beside: float = 0.0) -> list[int]:
    """What stands between a place on a seat, so far beside its middle, and a screen and is higher than a low table."""
    far = float(room.ahead[seat, screen])
    slope = (float(room.left[seat, screen]) - beside) / max(far, 1e-6)
    found = []
    for k in room.upright:
        if k in (seat, screen) or room.top[k] < 0.6 or not room.depth[seat] / 2 < room.ahead[seat, k] < far:
            continue
        at = beside + slope * float(room.ahead[seat, k])
        if room.least[seat, k, 1] < at < room.most[seat, k, 1]:
            found.append(k)
    return found


def _coffee(room: Furnished) -> Iterator[Fault]:
    seats, sofas = room.which(EASY), room.which(SOFAS)
    for t in room.which("coffee_table"):
        served = [s for s in (sofas or seats) if before(room, s, t)]
        if not served:
            yield Fault("coffee table not before the sofa", room.ids(t))
        elif not any(CLOSE <= _edge(room, s, t) <= FAR for s in served if room.names[s] != "corner_sofa") and all(
                room.names[s] != "corner_sofa" for s in served):
            yield Fault("coffee table out of reach", room.ids(t, *served))
        for table in room.which(TABLES):
            if room.gap[t, table] < AGAINST:
                yield Fault("coffee table against the dining table", room.ids(t, table))


def _edge(room: Furnished, seat: int, i: int) -> float:
    """From the front of a seat to the near edge of something."""
    return float(room.least[seat, i, 0]) - room.depth[seat] / 2


def _in_company(room: Furnished, i: int, screens: list[int]) -> bool:
    """Whether a seat looks at a table of its own, a screen, or someone to talk to, or stands paired with another."""
    if any(room.aside[i, t] <= 60 and room.gap[i, t] <= 1.3 for t in room.which("coffee_table")):
        return True
    if any(room.aside[i, s] <= 40 and room.gap[i, s] < 4.5 for s in screens):
        return True
    if any(room.aside[i, s] <= 60 and room.aside[s, i] <= 110 and room.gap[i, s] < TALK
           for s in room.which(EASY) if s != i):
        return True
    if any(room.look[i, t] <= 35 and room.gap[i, t] <= 0.55 for t in room.which(DESKS | TABLES)):
        return True
    paired = room.which("side_table") + room.which("armchair")
    return room.names[i] == "armchair" and any(room.gap[i, k] < 0.5 and room.turn[i, k] < 100 for k in paired if k != i)


def _screen(room: Furnished, i: int) -> Iterator[Fault]:
    viewers = [s for s in room.which(EASY | BEDS) if room.aside[s, i] <= 40 and room.aside[i, s] <= 45]
    if not viewers:
        yield Fault("television that nobody watches", room.ids(i))
    elif not any((SEEN_FROM_BED if room.names[s] in BEDS else SEEN_FROM) < room.gap[s, i] < SEEN_TO for s in viewers):
        yield Fault("television too near or too far", room.ids(i, *viewers))
    elif (wide := _screen_width(room, i)) and min(room.gap[s, i] for s in viewers) > SMALL * wide:
        yield Fault("television small for its distance", room.ids(i, *viewers))
    if room.names[i] == "tv_stand" and room.back[i] > 0.2:
        yield Fault("television off the wall", room.ids(i))


def _screen_width(room: Furnished, i: int) -> float:
    """Of a television, by itself or on its stand, m; 0 where the stand has none."""
    return max((room.width[k] for k in room.which("tv") if k == i or room.gap[k, i] < 0.01), default=0.0)


def _companions(room: Furnished) -> Iterator[Fault]:
    easy = EASY | BEDS
    for i in room.which("side_table"):
        if not room.beside(i, easy, REACH):
            yield Fault("side table at no seat", room.ids(i))
    for i in room.which("floor_lamp"):
        if not room.beside(i, easy | DESKS, 0.7) and room.wall[i] > 0.35:
            yield Fault("floor lamp at nothing", room.ids(i))
    for i in room.which(SMALL_SEATS):
        used = easy | DESKS | TABLE_TOPS | {"coffee_table"}
        if room.site.kind in ("living_room", "bedroom") and not room.beside(i, used, 0.6):
            yield Fault("stool at nothing", room.ids(i))
