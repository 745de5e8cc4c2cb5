"""Habits of furnishing as figures: of every room what a table of relations counts, to lay beside rooms of people.

Each value is a case: a share's 0 or 1, a number or a length; `MEDIANS` are summed up by their median, others by mean.
"""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from apartgen.stages.use.kinds import CASES, COUNTERS, DOUBLE, RUN, SOFAS, TABLES
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.rules import wash
from apartgen.stages.use.rules.cook import ABOVE, TOP, hobs, runs, worktop
from apartgen.stages.use.rules.eat import across, at, diners
from apartgen.stages.use.rules.sit import before, main_sofa, shown
from apartgen.stages.use.rules.sleep import sides, within_reach

Case = tuple[str, float]
MEDIANS = frozenset({
    "bed off the middle of its wall, m", "double bed's width, m", "sofa to television, m",
    "sofa off the television's axis, m", "sofa to coffee table, m",
})
SETS = ("nightstand", "chair", "armchair", "side_table", "bookshelf", "sofa")
"""Of these several alike are of one size, if they were bought for one room."""
PAIRS = frozenset({
    "nightstand", "chair", "armchair", "side_table", "floor_lamp", "plant", "bookshelf", "pouffe", "stool",
})
ABOUT = frozenset({"double_bed", "sofa", "corner_sofa", "dining_table", "tv_stand", "coffee_table"})
"""About whose axis pairs stand."""
SAME = 0.03
"""Sizes that differ by no more are one, m."""


def cases(room: Furnished) -> dict[str, list[float]]:
    """All cases of a room by relation."""
    found: dict[str, list[float]] = {}
    for part in (_whole, *PARTS.get(room.site.kind, ()), _sets):
        for name, value in part(room):
            found.setdefault(name, []).append(float(value))
    return found


def typical(name: str, values: Sequence[float]) -> float:
    """Cases summed up: a share, a mean or a median."""
    return float(np.median(values) if name in MEDIANS else np.mean(values))


def _whole(room: Furnished) -> Iterator[Case]:
    taken = sum(room.depth[i] * room.width[i] for i in room.upright)
    yield "floor covered", min(1.0, taken / room.site.area)
    yield "things on the floor", len(room.upright)


def _bedroom(room: Furnished) -> Iterator[Case]:
    for bed in room.which(DOUBLE):
        there = sum(within_reach(room, bed, i) for i in room.which("nightstand") + room.which("side_table"))
        for number, name in enumerate(("no nightstand", "one nightstand", "two nightstands")):
            yield f"double bed: {name}", there == number or there > number == 2
        yield "bed head at a wall", room.back[bed] < 0.2
        yield "double bed's width, m", room.width[bed]
        yield "bed off the middle of its wall, m", _off_middle(room, bed)
        yield "two sides to get in", sides(room, bed) == 2
    for i in room.which("nightstand"):
        yield "nightstand at a bed", any(within_reach(room, bed, i) for bed in room.which(DOUBLE | {"single_bed"}))
    for i in room.which("desk"):
        yield "desk has its chair", any(at(room, s, i) for s in room.which("chair") + room.which("office_chair"))


def _screens(room: Furnished) -> Iterator[Case]:
    viewers = room.which(SOFAS | {"armchair"} | DOUBLE | {"single_bed"})
    for i in shown(room):
        yield "television has a viewer", any(room.aside[s, i] <= 40 and room.aside[i, s] <= 45 for s in viewers)


def _off_middle(room: Furnished, i: int) -> float:
    """From the middle of the wall behind it, along that wall."""
    back = room.boxes.center[i, :2] - room.axes[i, 0] * room.depth[i] / 2
    offset = back - room.site.start
    along = (offset * room.site.along).sum(1)
    far = np.abs(offset[:, 0] * room.site.along[:, 1] - offset[:, 1] * room.site.along[:, 0])
    far[(along < 0) | (along > room.site.length)] = np.inf
    wall = int(far.argmin())
    return abs(float(along[wall] - room.site.length[wall] / 2))


def _living_room(room: Furnished) -> Iterator[Case]:
    main, screens, tables = main_sofa(room), shown(room), room.which("coffee_table")
    if main is None:
        return
    yield "sofas a room", len(room.which(SOFAS))
    yield "armchair there", bool(room.count["armchair"])
    yield "side table there", bool(room.count["side_table"])
    yield "coffee table there", bool(tables)
    yield "television there", bool(screens)
    yield "main sofa's back at a wall", room.back[main] < 0.2
    served = [t for t in tables if before(room, main, t)]
    if screens:
        screen = min(screens, key=lambda s: float(room.aside[main, s]))
        off = room.aside[main, screen]
        yield "main sofa within 30 degrees of the television", off <= 30
        yield "main sofa within 10 degrees of the television", off <= 10
        yield "sofa off the television's axis, m", abs(room.left[screen, main])
        if off <= 30:
            yield "sofa to television, m", room.gap[main, screen]
        if tables:
            between = [t for t in served if room.least[main, t, 0] < room.least[main, screen, 0]]
            yield "sofa, coffee table and television in a line", off <= 30 and bool(between)
    for t in tables:
        yield "coffee table before a sofa", any(before(room, s, t) for s in room.which(SOFAS))
    if served:
        yield "sofa to coffee table, m", min(room.least[main, t, 0] for t in served) - room.depth[main] / 2
    for i in room.which("side_table"):
        yield "side table at a seat", room.beside(i, SOFAS | {"armchair"} | DOUBLE | {"single_bed"}, 0.45)


def _tables(room: Furnished) -> Iterator[Case]:
    for t in room.which(TABLES):
        seats = diners(room, t)
        yield "chairs a table", len(seats)
        yield "table with four chairs or more", len(seats) >= 4
        yield "table with an even number of chairs", len(seats) % 2 == 0 and bool(seats)
        for s in seats:
            yield "chair has one across", across(room, t, s, seats)
        if sofas := room.which(SOFAS):
            yield "table closer than .4 m to a sofa", min(room.gap[t, s] for s in sofas) < 0.4


def _sets(room: Furnished) -> Iterator[Case]:
    for name in SETS:
        sizes = room.boxes.size[room.which(name)]
        if len(sizes) > 1:
            alike = (np.abs(sizes[:, None] - sizes[None]) < SAME).all(-1).sum(1) > 1
            yield from (("several alike of one size", same) for same in alike)
    if axes := room.which(ABOUT):
        yield "holds a mirror pair", any(_mirrored(room, a, i, j) for a in axes for i in room.which(PAIRS)
                                         for j in room.which(PAIRS) if i < j and room.names[i] == room.names[j])


def _mirrored(room: Furnished, about: int, i: int, j: int) -> bool:
    x, y = room.ahead[about], room.left[about]
    return bool(abs(x[i] - x[j]) < 0.12 and abs(y[i] + y[j]) < 0.15 and abs(y[i]) > 0.2)


def _kitchen(room: Furnished) -> Iterator[Case]:
    units = room.which(RUN)
    if units:
        pieces = runs(room, units)
        yield "kitchen in one run", len(pieces) == 1
        yield "unit alone", any(len(piece) == 1 for piece in pieces)
        yield "worktop of 1.2 m beside sink or hob", worktop(room, units) >= TOP
    for i in hobs(room):
        hoods = [h for h in room.which("hood") if abs(room.left[i, h]) <= ABOVE and abs(room.ahead[i, h]) < 0.5]
        yield "hood above the hob", bool(hoods)
    for i in room.which("stool"):
        yield "stool without a counter", not room.beside(i, COUNTERS, 0.4)


def _hall(room: Furnished) -> Iterator[Case]:
    yield "place for coats", room.number(("coat_rack", "wardrobe", "sliding_wardrobe", "clothes_rail")) > 0
    yield "two cabinets at most", room.number(CASES) <= 2


def _bathroom(room: Furnished) -> Iterator[Case]:
    found = [fault.name for fault in wash.faults(room)]
    yield "floor before every fixture", not any(name.startswith("no floor") for name in found)
    yield "elbow room at toilet and basin", not any(name.startswith("no elbow") for name in found)


PARTS: dict[str, tuple[Callable[[Furnished], Iterator[Case]], ...]] = {
    "bedroom": (_bedroom, _screens), "living_room": (_living_room, _screens, _tables), "dining_room": (_tables,),
    "kitchen": (_kitchen, _tables), "hallway": (_hall,), "bathroom": (_bathroom,),
}
"""What is counted in a type of room, besides what is in all."""
