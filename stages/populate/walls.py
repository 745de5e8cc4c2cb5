"""What hangs on walls: pictures, clocks, hooks, switches beside doors, sockets."""

from collections.abc import Iterator, Sequence

import numpy as np

from apartgen.schemas.plan import Plan, Room
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.stages.populate.faces import Array, Face, Hung, faces_of, seen
from apartgen.stages.space import polygons
from apartgen.stages.things import categories, small
from apartgen.stages.things.small import Design

PICTURES = {"living_room": (2, 4), "bedroom": (1, 3), "hallway": (1, 2), "study": (1, 2), "dining_room": (1, 2),
            "kitchen": (0, 1), "bathroom": (0, 1)}
"""How many hang in a room at least and at most."""
BARE = {"living_room": 1.5}
"""A wall of a room of this type has nothing on a stretch so long, m: a picture more is hung in its middle."""
WIDEST = {"bathroom": 0.5, "kitchen": 0.7, "hallway": 0.8}
"""Pictures are no wider in a room of this type, m."""
EYE = 1.5
"""Height of a picture's middle, m."""
OVER = 0.18
"""Between a piece of furniture and the picture above it, m."""
SWITCH, SOCKET, COUNTER = 1.05, 0.30, 1.12
"""Heights of switches, of sockets, and of sockets above worktops, m."""
ASIDE = 0.15
"""From the edge of a door to its switch, m."""
_UPRIGHT = (0.25, 2.2)
"""From skirting to lintel, m."""
_WALLED = ("living_room", "bedroom", "hallway", "study", "dining_room", "kitchen", "bathroom", "utility", "storage",
           "closet")
_UNDER = categories.those(lambda kind: kind.pictures > 0)
"""Furniture that pictures are hung over."""
_POWERED = categories.those(lambda kind: kind.socket)
"""Furniture that sockets are beside."""


def hung(
    home: Retrieve, room: Room, models: dict[str, list[Design]], density: float, rng: np.random.Generator
) -> list[Hung]:
    """All that hangs in a room; fittings first, since pictures find room elsewhere. Rooms share no pictures while there
    are enough.
    """
    if room.base not in _WALLED:
        return []
    here = [o for o in home.objects if o.room == room.id]
    faces = faces_of(home, room, here)
    found = [*_switches(home, room, faces, models["light_switch"]), *_sockets(room, faces, here, models["socket"], rng)]
    if room.base in ("kitchen", "living_room") and rng.random() < 0.6 * density:
        found += _anywhere(faces, models["wall_clock"][0], 1.95, rng)
    if room.base == "hallway" and not any(o.category == "coat_rack" for o in here):
        found += _anywhere(faces, models["coat_hooks"][0], 1.65, rng)
    if room.base == "bathroom" and rng.random() < 0.5 * density:
        found += _anywhere(faces, models["coat_hooks"][0], 1.6, rng)
    low, high = PICTURES.get(room.base, (0, 0))
    count = int(density * rng.integers(low, high + 1) + 0.5)
    every, first = models["picture"], [r.id for r in home.rooms].index(room.id)
    own = [every[k] for k in rng.permutation(np.arange(first, len(every), len(home.rooms)))]
    rest = [every[k] for k in rng.permutation(len(every)) if every[k] not in own]
    pictures = [design for design in [*own, *rest] if design.size[1] <= WIDEST.get(room.base, np.inf)]
    chosen = list(_pictures([*_over(faces, here), *_bare(faces)], pictures, count))
    left = [design for design in pictures if not any(design is other.design for other in chosen)]
    empty = list(_bare(faces, BARE.get(room.base, np.inf), *_UPRIGHT, shut=True))
    return [*found, *chosen, *_pictures(empty, left, len(left) if density > 0 else 0)]


def _switches(home: Plan, room: Room, faces: Sequence[Face], models: Sequence[Design]) -> Iterator[Hung]:
    """One beside every door into the room, on the side of its handle where there is room."""
    own = [o for o in home.openings if o.kind in ("door", "entrance") and room.id in (o.into, *o.rooms[:1])]
    own = own or [o for o in home.openings if o.kind in polygons.PASSAGES and room.id in o.rooms]
    for opening in own[:2]:
        ends = np.asarray(opening.segment, float)
        for end, other in ((ends[1], ends[0]), (ends[0], ends[1]))[:: -1 if opening.hinge else 1]:
            out = (end - other) / max(float(np.hypot(*(end - other))), 1e-9)
            if found := _at(faces, end + (ASIDE + 0.04) * out, models[0], SWITCH):
                yield found
                break


def _at(faces: Sequence[Face], point: Array, design: Design, z: float) -> Hung | None:
    """A thing on the wall that a point is at, if it is free there."""
    for face in faces:
        s, off = seen(face, point[None])
        clear = face.free(float(s[0]), design.size[1], z - design.size[2] / 2, z + design.size[2] / 2, 0.01)
        if abs(off[0]) < 0.3 and clear:
            return face.hang(design, float(s[0]), z)
    return None


def _sockets(
    room: Room, faces: Sequence[Face], here: Sequence[Furnishing], models: Sequence[Design], rng: np.random.Generator
) -> Iterator[Hung]:
    design = models[0]
    if room.base == "bathroom":
        return
    if room.base == "kitchen":
        for _ in range(2):
            yield from _above_worktops(faces, design, rng)
        return
    wanted = [o for o in here if o.category in _POWERED][:2]
    for o in wanted:
        beside = np.array([[-o.size[0] / 2, side * (o.size[1] / 2 + 0.1)] for side in (1, -1)])
        c, s = np.cos(o.yaw), np.sin(o.yaw)
        for point in beside @ np.array([[c, s], [-s, c]]) + o.center[:2]:
            if found := _at(faces, point, design, SOCKET):
                yield found
                break
    if not wanted:
        yield from _anywhere(faces, design, SOCKET, rng)


def _above_worktops(faces: Sequence[Face], design: Design, rng: np.random.Generator) -> Iterator[Hung]:
    """A thing above furniture that is as high as a worktop."""
    _, w, h = design.size
    places = [(face, s) for face in faces for a, b, _, top in face.covered if 0.8 < top < 1.0
              for s in np.arange(a + w, b - w, 0.1)]
    for k in rng.permutation(len(places)):
        face, s = places[int(k)]
        if face.free(float(s), w, COUNTER - h / 2, COUNTER + h / 2, 0.03):
            yield face.hang(design, float(s), COUNTER)
            return


def _anywhere(faces: Sequence[Face], design: Design, z: float, rng: np.random.Generator) -> Iterator[Hung]:
    """A thing at some free place of that height, the longer walls the likelier."""
    _, w, h = design.size
    for k in rng.permutation(len(faces)):
        face = faces[int(k)]
        for s in rng.permutation(np.arange(w / 2 + 0.1, face.length - w / 2 - 0.1, 0.15)):
            if face.free(float(s), w, z - h / 2, z + h / 2, 0.08):
                yield face.hang(design, float(s), z)
                return


def _pictures(
    places: Sequence[tuple[Face, float, float]], models: Sequence[Design], count: int
) -> Iterator[Hung]:
    """At the first of these places; each picture once, the first that fits."""
    left = list(models)
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


def _over(faces: Sequence[Face], here: Sequence[Furnishing]) -> Iterator[tuple[Face, float, float]]:
    under = [o for o in here if o.category in _UNDER]
    for o in sorted(under, key=lambda o: (categories.TABLE[o.category].pictures, o.id)):
        top = o.center[2] + o.size[2] / 2
        if top < 1.3:
            back = np.array([np.cos(o.yaw), np.sin(o.yaw)]) * -o.size[0] / 2 + o.center[:2]
            for face in faces:
                s, off = seen(face, back[None])
                if abs(off[0]) < 0.25 and 0 < s[0] < face.length:
                    yield face, float(s[0]), top


def _bare(
    faces: Sequence[Face], least: float = 0.6, low: float = EYE - 0.2, high: float = EYE + 0.2, shut: bool = False
) -> Iterator[tuple[Face, float, float]]:
    """Middles of the stretches longer than that which nothing covers at these heights, the longest first; of those with
    all doors `shut`, of what they leave free when they open.
    """
    found = []
    for face in faces:
        over, swept = ([(a, b) for a, b, z0, z1 in rows if z0 < high and z1 > low]
                       for rows in (face.covered, face.swept))
        for first, last in _gaps(over if shut else [*over, *swept], 0.0, face.length):
            free = max(_gaps(swept, first, last), key=lambda span: span[1] - span[0], default=None)
            if last - first > least and free is not None:
                found.append((last - first, face, (free[0] + free[1]) / 2))
    for _, face, s in sorted(found, key=lambda row: -row[0]):
        yield face, s, 0.0


def _gaps(cuts: Sequence[tuple[float, float]], first: float, last: float) -> Iterator[tuple[float, float]]:
    """What is left of a span between these."""
    at = first
    for a, b in [*sorted(cuts), (last, last)]:
        if min(a, last) > at:
            yield at, min(a, last)
        at = max(at, b)


KINDS = tuple(name for name, kind in small.TABLE.items() if kind.fixed)
"""What hangs."""
