"""What hangs on walls: pictures, clocks, hooks, switches beside doors, sockets."""

from collections.abc import Iterator, Sequence

import numpy as np

from apartgen.schemas.plan import Plan, Room
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.stages.populate import pictures
from apartgen.stages.populate.faces import Array, Face, Hung, faces_of, seen
from apartgen.stages.space import polygons
from apartgen.stages.things import categories, small
from apartgen.stages.things.small import Design

SWITCH, SOCKET, COUNTER = 1.05, 0.30, 1.12
"""Heights of switches, of sockets, and of sockets above worktops, m."""
ASIDE = 0.15
"""From the edge of a door to its switch, m."""
ALONE = 0.3
"""Free about a clock, m."""
_WALLED = ("living_room", "bedroom", "hallway", "study", "dining_room", "kitchen", "bathroom", "utility", "storage",
           "closet")
_POWERED = categories.those(lambda kind: kind.socket)
"""Furniture that sockets are beside."""


def hung(
    home: Retrieve, room: Room, models: dict[str, list[Design]], density: float, rng: np.random.Generator
) -> list[Hung]:
    """All that hangs in a room; fittings first, since pictures find room elsewhere, and a clock where pictures leave it
    some.
    """
    if room.base not in _WALLED:
        return []
    here = [o for o in home.objects if o.room == room.id]
    faces = faces_of(home, room, here)
    found = [*_switches(home, room, faces, models["light_switch"]), *_sockets(room, faces, here, models["socket"], rng)]
    timed = room.base in ("kitchen", "living_room") and rng.random() < 0.6 * density
    if room.base == "hallway" and not any(o.category == "coat_rack" for o in here):
        found += _anywhere(faces, models["coat_hooks"][0], 1.65, rng)
    if room.base == "bathroom" and rng.random() < 0.5 * density:
        found += _anywhere(faces, models["coat_hooks"][0], 1.6, rng)
    found += pictures.hung(room, faces, here, pictures.dealt(home.rooms, models["picture"], room), density, rng)
    return [*found, *(_anywhere(faces, models["wall_clock"][0], 1.95, rng, ALONE) if timed else ())]


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


def _anywhere(
    faces: Sequence[Face], design: Design, z: float, rng: np.random.Generator, margin: float = 0.08
) -> Iterator[Hung]:
    """A thing at some free place of that height, the longer walls the likelier."""
    _, w, h = design.size
    for k in rng.permutation(len(faces)):
        face = faces[int(k)]
        for s in rng.permutation(np.arange(w / 2 + 0.1, face.length - w / 2 - 0.1, 0.15)):
            if face.free(float(s), w, z - h / 2, z + h / 2, margin):
                yield face.hang(design, float(s), z)
                return


KINDS = tuple(name for name, kind in small.TABLE.items() if kind.fixed)
"""What hangs."""
