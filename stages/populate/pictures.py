"""Which pictures hang in which room, and on what walls they are wanted."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from apartgen.schemas.plan import Room
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.populate.faces import Face, Hung, Rectangle, seen
from apartgen.stages.things import categories
from apartgen.stages.things.small import Design

Place = tuple[Face, float, float]
"""A wall, where along it, and the top of what is below, m."""

COUNT = {"living_room": (2, 4), "bedroom": (1, 3), "hallway": (1, 2), "study": (1, 2), "dining_room": (1, 2),
         "kitchen": (0, 1)}
"""How many hang in a room at least and at most."""
MORE = {"living_room": 4}
"""And so many more are kept for bare walls of a room of this type, where they hang whatever the count is."""
BARE, PLAIN, LEAST = 1.5, 2.0, 1.2
"""A wall is bare that has nothing from skirting to lintel on a stretch so long, m, and plain that has nothing at the
height of eyes on one of 2 m, or on all of its length if that is 1.2 m or more.
"""
WIDEST = {"kitchen": 0.7, "hallway": 0.8}
"""Pictures are no wider in a room of this type, m."""
LARGE = 0.5
"""What hangs alone on a bare wall is as wide as this, m, if there is one."""
EYE = 1.5
"""Height of a picture's middle, m."""
OVER = 0.18
"""Between a piece of furniture and the picture above it, m."""
_UPRIGHT, _EYES = (0.25, 2.2), (EYE - 0.2, EYE + 0.2)
"""From skirting to lintel, and what eyes see first, m."""
_REACH, BESIDE = (EYE - 0.5, EYE + 0.5), 0.5
"""What a picture may cover, and how far its middle is from what stands beside it, m."""
_UNDER = categories.those(lambda kind: kind.pictures > 0)
"""Furniture that pictures are hung over."""


def dealt(rooms: Sequence[Room], every: Sequence[Design], of: Room) -> list[Design]:
    """Those of a home's pictures that are a room's: more where more may hang, and none another's as well; where only
    small ones may, they are dealt first."""
    hands = [room for room in rooms for _ in range(COUNT.get(room.base, (0, 0))[1] + MORE.get(room.base, 0))]
    hands.sort(key=lambda room: WIDEST.get(room.base, np.inf))
    left, own = list(every), list[Design]()
    while hands and left:
        before = len(left)
        for room in hands:
            most = WIDEST.get(room.base, np.inf)
            if (design := next((design for design in left if design.size[1] <= most), None)) is not None:
                left.remove(design)
                own += [design] if room.id == of.id else []
        if len(left) == before:
            break
    return own


def hung(room: Room, faces: Sequence[Face], here: Sequence[Furnishing], own: Sequence[Design], density: float,
         rng: np.random.Generator) -> list[Hung]:
    """Some of a room's own pictures: over furniture, then where walls are free, and more where they would be bare."""
    count = int(density * rng.integers(*COUNT.get(room.base, (0, 0)), endpoint=True) + 0.5)
    left = [own[k] for k in rng.permutation(len(own))]
    found = list(_hang([*_over(faces, here), *free(faces, 0.6)], left, count))
    if density > 0 and room.base in MORE:
        left.sort(key=lambda design: design.size[1] < LARGE)
        found += _hang(free(faces, BARE, *_UPRIGHT, shut=True), left, len(left))
        while more := list(_hang(plain(faces), left, len(left))):
            found += more
        while more := list(_hang(beside(faces), left, 1)):
            found += more
    return found


def plain(faces: Sequence[Face]) -> list[Place]:
    """Where a picture is wanted on walls with nothing at the height of eyes."""
    found = ((face, free([face], max(min(PLAIN, face.length - 0.02), LEAST), shut=True)) for face in faces)
    return [place for _, places in found for place in places]


def beside(faces: Sequence[Face]) -> list[Place]:
    """Where one is wanted on such a wall that has no room in its middle, as at a television: what is free of all that
    a picture may cover, as near to the middle as may be.
    """
    found = []
    for face, middle, _ in plain(faces):
        for first, last in _gaps(_spans([*face.covered, *face.swept], *_REACH), 0.0, face.length):
            s = min(max(middle, first + BESIDE), last - BESIDE)
            between = (a < max(s, middle) and b > min(s, middle) for a, b in _spans(face.covered, *_EYES))
            if last - first > 2 * BESIDE and not any(between):
                found.append((abs(s - middle), face, s))
    return [(face, s, _below(face, s, _REACH[0])) for _, face, s in sorted(found, key=lambda row: row[0])]


def _spans(rectangles: Iterable[Rectangle], low: float, high: float) -> list[tuple[float, float]]:
    """From where to where these cover a wall at such heights."""
    return [(a, b) for a, b, z0, z1 in rectangles if z0 < high and z1 > low]


def _hang(places: Sequence[Place], left: list[Design], count: int) -> Iterator[Hung]:
    """At the first of these places; each picture once, the first that fits."""
    for face, s, low in places:
        if count <= 0:
            return
        for design in left:
            _, w, h = design.size
            z = max(EYE, low + OVER + h / 2)
            if z + h / 2 < 2.25 and face.free(s, w, z - h / 2, z + h / 2, 0.12):
                yield face.hang(design, s, z)
                left.remove(design)
                count -= 1
                break


def _over(faces: Sequence[Face], here: Sequence[Furnishing]) -> Iterator[Place]:
    under = [o for o in here if o.category in _UNDER]
    for o in sorted(under, key=lambda o: (categories.TABLE[o.category].pictures, o.id)):
        top = o.center[2] + o.size[2] / 2
        if top < 1.3:
            back = np.array([np.cos(o.yaw), np.sin(o.yaw)]) * -o.size[0] / 2 + o.center[:2]
            for face in faces:
                s, off = seen(face, back[None])
                if abs(off[0]) < 0.25 and 0 < s[0] < face.length:
                    yield face, float(s[0]), top


def free(
    faces: Sequence[Face], least: float, low: float = _EYES[0], high: float = _EYES[1], shut: bool = False
) -> list[Place]:
    """Middles of the stretches longer than that which nothing covers at these heights, the longest first; of those with
    all doors `shut`, of what they leave free when they open.
    """
    found = []
    for face in faces:
        over, swept = _spans(face.covered, low, high), _spans(face.swept, low, high)
        for first, last in _gaps(over if shut else [*over, *swept], 0.0, face.length):
            clear = max(_gaps(swept, first, last), key=lambda span: span[1] - span[0], default=None)
            if last - first > least and clear is not None:
                found.append((last - first, face, (clear[0] + clear[1]) / 2))
    return [(face, s, _below(face, s, low)) for _, face, s in sorted(found, key=lambda row: -row[0])]


def _below(face: Face, s: float, most: float) -> float:
    """The top of what covers a wall below that height there, m."""
    return max((z1 for a, b, _, z1 in face.covered if a < s < b and z1 <= most), default=0.0)


def _gaps(cuts: Sequence[tuple[float, float]], first: float, last: float) -> Iterator[tuple[float, float]]:
    """What is left of a span between these."""
    at = first
    for a, b in [*sorted(cuts), (last, last)]:
        if min(a, last) > at:
            yield at, min(a, last)
        at = max(at, b)
