"""Neighbours: the ways of doors, where the sun stands, what is seen on coming in."""

from collections.abc import Iterator

import numpy as np

from apartgen.stages.space.boxes import Array
from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import BEDS, COATS
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.rules.sit import before, main_sofa, shown
from apartgen.stages.use.site import Hole

STEP = 0.9
"""Floor into which one steps from a door, m."""
GLARE = 0.6
"""A screen whose back is so near a window has the light behind it, m."""
COATS_FAR = 4.0
"""One does not walk further in coat and shoes, m."""
LIGHT = 2.5
"""A desk further from the window needs its lamp by day, m."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of doors and windows beside what people sit at, sleep in and look at."""
    for hole in room.site.passages:
        if room.clear(hole.frame, (0.0, STEP), (-0.3, 0.3), range(len(room.names))) < 0.85:
            yield Fault("one steps from the door into furniture", (hole.id,))
    yield from _through(room)
    for i in shown(room):
        if any(_behind(room, i, window) for window in room.site.windows):
            yield Fault("television before a window", room.ids(i))
    for i in room.which("desk"):
        if room.site.windows and min(_far(room, i, w) for w in room.site.windows) > LIGHT:
            yield Fault("desk away from the light", room.ids(i))
    for i in room.which(BEDS):
        if room.site.kind != "bedroom" and any(_far(room, i, hole) < 2.0 for hole in room.site.passages):
            yield Fault("bed beside the door of a room that others use", room.ids(i))
        if any(_behind(room, i, window) for window in room.site.windows):
            yield Fault("head of the bed at a window", room.ids(i))
        if any(hole.kind != "opening" and _far(room, i, hole) < 0.5 for hole in room.site.passages):
            yield Fault("bed right at the door", room.ids(i))
    coats, entrances = room.which(COATS), [hole for hole in room.site.holes if hole.kind == "entrance"]
    if coats and entrances and min(_far(room, i, hole) for i in coats for hole in entrances) > COATS_FAR:
        yield Fault("coats far from the entrance", room.ids(*coats))
    main = main_sofa(room)
    if main is not None:
        for hole in room.site.passages:
            ahead, _ = _seen_from(room, main, hole)
            if ahead < -room.depth[main] / 2 and _far(room, main, hole) < 0.6:
                yield Fault("back of the sofa to a near door", (*room.ids(main), hole.id))


def _through(room: Furnished) -> Iterator[Fault]:
    """Ways between doors that lead between a sofa and its coffee table or screen."""
    holes = room.site.passages
    main = main_sofa(room)
    if main is None or len(holes) < 2:
        return
    aims = [t for t in room.which("coffee_table") if before(room, main, t)] or [
        s for s in shown(room) if room.aside[main, s] < 30]
    for aim in aims[:1]:
        a, b = room.boxes.center[main, :2], room.boxes.center[aim, :2]
        for i, one in enumerate(holes):
            if any(_cross(a, b, _inside(one), _inside(other)) for other in holes[i + 1 :]):
                yield Fault("a way between doors leads through the group", (*room.ids(main, aim), one.id))


def _inside(hole: Hole) -> Array:
    """Where one stands having come in, .4 m from the door."""
    x, y, c, s = hole.frame
    return np.array([x + 0.4 * c, y + 0.4 * s])


def _cross(a: Array, b: Array, p: Array, q: Array) -> bool:
    """Whether two segments cross."""
    def side(u: Array, v: Array, w: Array) -> float:
        return float((v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]))

    return side(a, b, p) * side(a, b, q) < 0 and side(p, q, a) * side(p, q, b) < 0


def _seen_from(room: Furnished, i: int, hole: Hole) -> tuple[float, float]:
    """An opening's middle in an object's frame."""
    offset = np.array(hole.middle) - room.boxes.center[i, :2]
    ahead, left = room.axes[i] @ offset
    return float(ahead), float(left)


def _far(room: Furnished, i: int, hole: Hole) -> float:
    """From a footprint to the middle of an opening, m."""
    ahead, left = _seen_from(room, i, hole)
    return float(np.hypot(max(abs(ahead) - room.depth[i] / 2, 0), max(abs(left) - room.width[i] / 2, 0)))


def _behind(room: Furnished, i: int, window: Hole) -> bool:
    """Whether a window is at the back of something, and so much of it that it dazzles who looks there."""
    ahead, left = _seen_from(room, i, window)
    return -room.depth[i] / 2 - GLARE < ahead < 0 and abs(left) < (window.width + room.width[i]) / 2 - 0.3

