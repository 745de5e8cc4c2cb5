"""Realism: how furniture stands to walls and to its companions, against real rooms."""

from collections.abc import Collection, Sequence

import numpy as np
from shapely.geometry import Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._sets import ALL, every, types
from apartgen.stages.metrics._shares import objects
from apartgen.stages.metrics._table import averaged
from apartgen.stages.space import boxes, footprints, polygons
from apartgen.stages.space.boxes import Array
from apartgen.stages.things import categories

NEEDS = Layout
SEATS = categories.those(lambda kind: kind.is_for("sit") and kind.faces)
TABLES = categories.parents(SEATS)
BEDSIDE = categories.those(
    lambda kind: kind.is_for("store") and not categories.used_for("sleep").isdisjoint(kind.belongs))
BEDS = categories.parents(BEDSIDE)
SCREENS = categories.used_for("watch")
SOFAS = categories.those(lambda kind: kind.is_for("lounge") and not kind.loose)
APART = 0.35
"""Companions stand no further apart, m."""
WALL = 0.12
"""A back this close to a wall stands at it, m."""
FACING = np.deg2rad(45)
ALIGNED = np.deg2rad(5)
RELATIONS = ("nightstand_at_bed", "seat_at_table", "tv_faces_sofa", "back_to_wall", "yaw_aligned", "density",
             "objects_a_room")
Sample = dict[str, list[float]]


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Mean of each relation over the apartment's objects or rooms; None where it has none of the kind."""
    things = objects(home)
    rooms = [of_room(polygons.floor(room), [o for o in things if o.room == room.id]) for room in home.rooms]
    means = [_mean(name, rooms, "apartment", "ours") for name in RELATIONS]
    return [value.model_copy(update={"low": None, "high": None}) for value in means]


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """Each relation in the generated and in the real rooms, in all of the real rooms' types and by type."""
    values = []
    for version, group in (("generated", homes), ("real", real)):
        for kind in (ALL, *types(real)):
            rooms = [of_room(polygons.floor(room), inside) for room, inside in every(group, real, kind)]
            values += [_mean(name, rooms, kind, version) for name in RELATIONS]
    return values


def _mean(name: str, rooms: Sequence[Sample], of: str, version: str) -> Value:
    """Over all cases; the interval is over rooms, because what stands in one room depends on one another."""
    cases = [found[name] for found in rooms if found[name]]
    unit = "objects" if name == "objects_a_room" else "share"
    value = Value(name=name, value=None, unit=unit, version=version, of=of, n=sum(map(len, cases)))
    return averaged(value, [(float(np.mean(found)), float(len(found))) for found in cases])


def of_room(floor: Polygon, things: Sequence[Box]) -> Sample:
    """One entry an object that the relation is about, or one for the room."""
    standing = [o for o in things if footprints.is_obstacle(o) and o.category in categories.TABLE]
    upright = [o for o in standing if categories.TABLE[o.category].place == "floor"]
    return {
        "nightstand_at_bed": _beside(standing, BEDSIDE, BEDS),
        "seat_at_table": _beside(standing, SEATS, TABLES, facing=True),
        "tv_faces_sofa": _beside(standing, SCREENS, SOFAS, near=np.inf, facing=True),
        "back_to_wall": [float(_at_wall(o, floor)) for o in upright if categories.TABLE[o.category].back],
        "yaw_aligned": [float(_aligned(o, floor)) for o in upright],
        "density": [1 - footprints.walkable_ratio(floor, things)],
        "objects_a_room": [float(len(things))],
    }


def _beside(
    things: Sequence[Box], own: Collection[str], other: Collection[str], near: float = APART, facing: bool = False
) -> list[float]:
    """For each of `own` in a room that has any of `other`: whether one is near, and in front if `facing`."""
    a, b = ([o for o in things if o.category in names] for names in (own, other))
    if not a or not b:
        return []
    hit = boxes.gap(boxes.of(a), boxes.of(b)) <= near
    if facing:
        hit &= _ahead(a, b)
    return [float(row.any()) for row in hit]


def _ahead(a: Sequence[Box], b: Sequence[Box]) -> boxes.Mask:
    """Whether each of `b` is within 45° of where each of `a` looks, (n, m)."""
    first, second = boxes.of(a), boxes.of(b)
    seen = boxes.local(second.center[:, :2], first)
    return np.asarray(np.abs(np.arctan2(seen[..., 1], seen[..., 0])) <= FACING)


def _walls(floor: Polygon) -> tuple[Array, Array]:
    """Starts of the walls and vectors along them, (n, 2) each."""
    ring = np.asarray(floor.exterior.coords)
    return ring[:-1], np.diff(ring, axis=0)


def _at_wall(o: Box, floor: Polygon) -> bool:
    """Whether the back is parallel to a wall and within `WALL` of it."""
    box = boxes.of([o])
    front = boxes.axes(box)[0, 0]
    back = box.center[0, :2] - o.size[0] / 2 * front
    starts, spans = _walls(floor)
    length = np.hypot(*spans.T)
    normal = np.stack([-spans[:, 1], spans[:, 0]], -1) / length[:, None]
    normal = normal if floor.exterior.is_ccw else -normal
    away = ((back - starts) * normal).sum(-1)
    along = ((back - starts) * spans).sum(-1) / length
    beside = (along > -o.size[1] / 2) & (along < length + o.size[1] / 2)
    return bool((beside & (np.abs(away) < WALL) & (normal @ front > np.cos(ALIGNED))).any())


def _aligned(o: Box, floor: Polygon) -> bool:
    """Whether the yaw is that of a wall, to a quarter turn."""
    _, spans = _walls(floor)
    off = (o.yaw - np.arctan2(spans[:, 1], spans[:, 0]) + np.pi / 4) % (np.pi / 2) - np.pi / 4
    return bool((np.abs(off) < ALIGNED).any())
