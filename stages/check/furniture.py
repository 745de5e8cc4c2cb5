"""The furniture: sizes, what stands outside, in one another or on nothing, and whether it is what was asked for."""

from collections import Counter
from collections.abc import Iterator

from shapely.geometry import Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.stages.check.building import Site
from apartgen.stages.check.fault import Fault
from apartgen.stages.check.shapes import TOUCH, boxes, common, depth, meeting
from apartgen.stages.things.categories import TABLE

FLAT = 0.03
"""What is no higher is part of the floor, m."""
USE = 0.05
"""How far what belongs together may stand in one another, or what is carried in what carries it, m."""
BACK = (-0.35, 0.5, 0.5)
"""Front left upper corner of a seat's back, in shares of its size."""
SQUARE, ROUND = ((0.5, 0.5),), ((0.5, 0.2), (0.2, 0.5), (0.354, 0.354))
"""Half widths, in shares of their size, of boxes that make up tables: those without a front are round."""
BEYOND, UNKNOWN = 3.0, ((0.005,) * 3, (1.5,) * 3)
"""Sizes this many times beyond those of a category's real products, or of what nobody knows, are mistakes."""
HANGS_OFF, HELD = 0.03, 0.3
"""How far what hangs may be from its wall, m, and what share of it must be held by a wall or by what it is on."""
NOT_HELD = {"floor": {"wall", "ceiling"}, "flat": {"wall", "ceiling"}, "ceiling": {"wall", "floor"}}
"""What does not hold things of each place."""


def gives_way(o: Box) -> bool:
    """Whether it is soft, or as flat as a rug."""
    return o.center[2] + o.size[2] / 2 <= FLAT or (o.category in TABLE and TABLE[o.category].soft)


def is_seat(o: Box) -> bool:
    """Whether it goes under the table that it belongs to."""
    return o.category in TABLE and "sit" in TABLE[o.category].uses


def placed(home: Layout, site: Site) -> Iterator[Fault]:
    """What has no possible size, or is outside its room, under the floor or above the ceiling."""
    shapes = boxes(home.objects)
    rooms = {name: room.buffer(TOUCH, join_style="mitre") for name, room in site.rooms.items()}
    for o, mark, low, high in zip(home.objects, shapes.marks(), shapes.low.tolist(), shapes.high.tolist()):
        least, most = (TABLE[o.category].min, TABLE[o.category].max) if o.category in TABLE else UNKNOWN
        bad = [s for s, lo, hi in zip(o.size, least, most) if not lo / BEYOND <= s <= hi * BEYOND]
        yield from (Fault("size", (o.id,), o.center, s) for s in bad)
        if max(-low, high - home.height) > TOUCH:
            yield Fault("storey", (o.id,), (*o.center[:2], low if low < 0 else high), max(-low, high - home.height))
        if not rooms[o.room].covers(mark):
            off = mark.difference(site.rooms[o.room])
            yield Fault("outside", (o.id, o.room), (off.centroid.x, off.centroid.y), off.area)


def faults(home: Layout, site: Site) -> Iterator[Fault]:
    """What stands in one another or on nothing, and whether it is what was asked for."""
    yield from _overlaps(home.objects)
    yield from _supports(home, site)
    found, wished = Counter((o.room, o.category) for o in home.objects), Counter[tuple[str, str]]()
    for wish in home.program.objects:
        wished[wish.room, wish.category] += wish.count
    unmet = [pair for pair, count in wished.items() if found[pair] < count or (count == 0 and found[pair])]
    yield from (Fault("count", pair, (), found[pair]) for pair in unmet)
    there = Counter(o.room for o in home.objects)
    yield from (Fault("count", (room,), (), there[room]) for room, n in home.program.counts.items() if there[room] != n)


def _overlaps(objects: list[Box]) -> Iterator[Fault]:
    shapes, each = boxes(objects), [boxes([o]) for o in objects]
    for i, j in meeting(shapes.marks()):
        one, two, deep, allowed = objects[i], objects[j], float(depth(each[i], each[j])[0, 0]), TOUCH
        for child, parent in ((one, two), (two, one)):
            a, b = TABLE.get(child.category), TABLE.get(parent.category)
            allowed = USE if getattr(child, "on", None) == parent.id else allowed
            if a and b and not set(a.belongs).isdisjoint(b.lineage):
                allowed = USE
                if is_seat(child) and (b.kneehole or not b.back):
                    tops = [boxes([parent], (-x, -y, -0.5), (x, y, 0.5)) for x, y in (SQUARE if b.faces else ROUND)]
                    back = max(float(depth(boxes([child], hi=BACK), top)[0, 0]) for top in tops)
                    deep = 0.0 if child.size[2] <= parent.size[2] else min(deep, back)
        if deep > TOUCH and not gives_way(one) and not gives_way(two):
            yield Fault("overlap", (one.id, two.id), common(shapes, i, shapes, j), deep, deep > allowed)


def _supports(home: Layout, site: Site) -> Iterator[Fault]:
    shapes = boxes(home.objects)
    marks = shapes.marks()
    for i, o in enumerate(home.objects):
        low, high = float(shapes.low[i]), float(shapes.high[i])
        said, place = getattr(o, "on", None), TABLE[o.category].place if o.category in TABLE else ""
        most = [USE if other.id == said else 1.5 * TOUCH for other in home.objects]
        below = [j for j, far in enumerate(shapes.high - low) if j != i and -1.5 * TOUCH <= far <= most[j]]
        held = {home.objects[j].id for j in below if marks[i].intersection(marks[j]).area >= HELD * marks[i].area}
        held |= {"floor"} if low <= TOUCH else set()
        held |= {"ceiling"} if high >= home.height - 2 * TOUCH else set()
        held |= {"wall"} if _hangs(o, marks[i], low, high, site) else set()
        if said is not None and said not in held:
            yield Fault("not-on", (o.id, said), o.center)
        if not held - NOT_HELD.get(place, set()):
            yield Fault("unsupported", (o.id,), (*o.center[:2], low), low)


def _hangs(o: Box, mark: Polygon, low: float, high: float, site: Site) -> bool:
    """Whether enough of a side is at a wall of its room, where no opening is."""
    touched = site.rooms[o.room].exterior.intersection(mark.buffer(HANGS_OFF, join_style="mitre"))
    for opening, it in site.gates:
        if o.room in it.sides and opening.sill <= low and high <= opening.head:
            touched = touched.difference(it.cut().buffer(TOUCH))
    return bool(touched.length >= HELD * max(o.size[:2]))
