"""Other places in its room for an object and its company, when small shifts do not do."""

from collections.abc import Iterator

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.space import boxes, footprints
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things import categories
from apartgen.stages.things.carrying import carried
from apartgen.stages.walkable.site import COMPANY, SLACK, Changes, Scene, Site, in_room

STEP = 0.15
"""Between places tried, m."""
MOST = 40
"""Places tried of one object, the nearest ones."""
TURN = 0.5
"""A turn by 90° counts as this many metres."""
ALIGNED = 0.99
"""What hangs over an object faces as it does, by this cosine."""
_BESIDE = 0.06
"""Units no farther apart are of one run, m."""
_UNITS = categories.those(lambda kind: kind.run in ("unit", "fitted"))
_RUN = _UNITS | categories.those(lambda kind: kind.run == "beside")
_APART = 0.002  # from a wall, so that rounding puts nothing into it, m


def places(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """Places near first: with its back to any wall for what stands at walls, else anywhere with the same heading.

    What stands on the object, hangs over it or belongs to it comes along; a unit of a kitchen's run has no other place.
    Whether a door stays within reach is not looked at.
    """
    if o.category not in categories.TABLE or categories.TABLE[o.category].place != "floor" or _in_run(o, scene):
        return
    floor = site.floors[o.room]
    group = [o, *kin(o, scene), *hung(o, scene)]
    company = [p for member in group for p in (member, *carried(member, scene))]
    spots = _along_walls(floor, o, group) if categories.TABLE[o.category].back else _all_over(floor, o)
    rest = [p for p in in_room(scene, o.room) if p not in company and not footprints.gives_way(p)]
    for member in group:
        spots = spots[_clear(site, member, _followed(member, o, spots), rest)]
    way = np.hypot(*(spots[:, :2] - o.center[:2]).T) + TURN * (1 - np.cos(spots[:, 2] - o.yaw))
    for x, y, yaw in spots[np.argsort(way, kind="stable")][:MOST].tolist():
        yield {p.id: _along(p, o, (x, y, yaw)) for p in company}


def _in_run(o: Furnishing, scene: Scene) -> bool:
    """Whether it stands side by side with a unit of a kitchen's run, or with a fridge or machine that is part of it."""
    others = [p for p in in_room(scene, o.room) if p.id != o.id and p.category in _RUN]
    if o.category not in _RUN or not any(p.category in _UNITS for p in (o, *others)):
        return False
    return bool(others) and float(boxes.gap(boxes.of([o]), boxes.of(others)).min()) < _BESIDE


def kin(o: Furnishing, scene: Scene) -> list[Furnishing]:
    """What belongs to an object and stands close to it."""
    kin = [p for p in in_room(scene, o.room) if p.category in categories.TABLE and p.id != o.id
           and o.category in categories.TABLE[p.category].belongs and categories.TABLE[p.category].place == "floor"]
    near = boxes.gap(boxes.of([o]), boxes.of(kin))[0] <= COMPANY if kin else []
    return [p for p, close in zip(kin, near, strict=True) if close]


def hung(o: Furnishing, scene: Scene) -> list[Furnishing]:
    """What hangs over an object for its use, as the mirror over a basin."""
    own = [p for p in in_room(scene, o.room) if p.category in categories.TABLE
           and o.category in categories.TABLE[p.category].belongs and categories.TABLE[p.category].place == "wall"
           and np.cos(p.yaw - o.yaw) > ALIGNED]
    near = boxes.gap(boxes.of([o]), boxes.of(own))[0] <= COMPANY if own else []
    return [p for p, close in zip(own, near, strict=True) if close]


def _along_walls(floor: Polygon, o: Furnishing, group: list[Furnishing]) -> Array:
    """Centres and headings (n, 3) of the object with its group's back to each wall, from end to end."""
    seen = boxes.local(boxes.corners(boxes.of(group)).reshape(-1, 2), boxes.of([o]))[0]
    (rear, right), (_, left) = seen.min(0), seen.max(0)
    corners = shapely.get_coordinates(shapely.geometry.polygon.orient(floor).exterior)
    rows = []
    for a, b in zip(corners[:-1], corners[1:], strict=True):
        length = float(np.hypot(*(b - a)))
        room = length - (left - right) - 2 * _APART
        if room < 0:
            continue
        along = (b - a) / length
        inward = np.array([-along[1], along[0]])
        # Seen from the wall, the object's left is towards the start.
        for s in left + _APART + np.linspace(0, room, max(2, int(room / STEP) + 1)):
            rows.append([*(a + s * along + (_APART - rear) * inward), np.arctan2(inward[1], inward[0])])
    return np.array(rows, float).reshape(-1, 3)


def _all_over(floor: Polygon, o: Furnishing) -> Array:
    x0, y0, x1, y1 = floor.bounds
    x, y = np.meshgrid(np.arange(x0 + STEP, x1, STEP), np.arange(y0 + STEP, y1, STEP))
    return np.stack([x.ravel(), y.ravel(), np.full(x.size, o.yaw)], -1)


def _clear(site: Site, o: Furnishing, spots: Array, rest: list[Furnishing]) -> boxes.Mask:
    """Which places an object stands clear at: on the floor, off the doors, in nothing else, (n,)."""
    n = len(spots)
    there = Boxes(np.column_stack([spots[:, :2], np.full(n, o.center[2])]), np.tile(o.size, (n, 1)), spots[:, 2])
    areas = boxes.footprints(there)
    clear = shapely.covers(site.floors[o.room].buffer(_APART / 2), areas)
    clear &= ~shapely.intersects(site.doors.buffer(-_APART), areas)
    others = [p for p in rest if not categories.tucks(p.category, o.category)]
    if others:
        clear &= (boxes.penetration(there, boxes.of(others)) <= SLACK).all(-1)
    return np.asarray(clear, bool)


def _followed(p: Furnishing, o: Furnishing, spots: Array) -> Array:
    """Centres and headings (n, 3) of a member of the company where the object goes to `spots` (n, 3)."""
    turn = spots[:, 2] - o.yaw
    c, s = np.cos(turn), np.sin(turn)
    dx, dy = p.center[0] - o.center[0], p.center[1] - o.center[1]
    return np.stack([spots[:, 0] + c * dx - s * dy, spots[:, 1] + s * dx + c * dy, p.yaw + turn], -1)


def _along(p: Furnishing, o: Furnishing, spot: tuple[float, float, float]) -> Furnishing:
    """A member of the company carried to where the object goes, turned with it."""
    x, y, yaw = _followed(p, o, np.array([spot]))[0].tolist()
    turned = float((yaw + np.pi) % (2 * np.pi) - np.pi)
    return p.model_copy(update={"center": (x, y, p.center[2]), "yaw": turned})
