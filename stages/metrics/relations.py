"""Realism: how furniture stands to walls and to its companions, against real rooms."""

from collections.abc import Iterable, Sequence

import numpy as np
from shapely.geometry import Polygon

from schemas.layout import Box, Layout
from schemas.metrics import Value
from schemas.plan import Plan, Program
from stages import boxes, categories, footprints, polygons
from stages.boxes import Array
from stages.metrics._sets import ALL, SEED, types
from stages.metrics._table import interval

NEEDS = Layout
BEDS = ("double_bed", "single_bed")
TABLES = ("dining_table", "round_table", "desk", "dressing_table", "balcony_table")
SEATS = ("chair", "office_chair", "balcony_chair")
SOFAS = ("sofa", "corner_sofa")
NEAR = 0.35
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
    return [_value(name, found, "apartment", "ours") for name, found in _pooled([home], None).items()]


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """Each relation in the generated and in the real rooms, in all of the real rooms' types and by type."""
    every = types(real)
    values = []
    for version, group in (("generated", homes), ("real", real)):
        for kind in (ALL, *every):
            found = _pooled(group, every if kind == ALL else [kind])
            values += [_with_interval(_value(name, sample, kind, version), sample) for name, sample in found.items()]
    return values


def _value(name: str, found: list[float], of: str, version: str) -> Value:
    unit = "objects" if name == "objects_a_room" else "share"
    return Value(name=name, value=float(np.mean(found)) if found else None, unit=unit, version=version, of=of,
                 n=len(found))


def _with_interval(value: Value, found: list[float]) -> Value:
    if not found:
        return value
    _, low, high = interval(np.array([(v, 1.0) for v in found]), np.random.default_rng(SEED))
    return value.model_copy(update={"low": low, "high": high})


def _pooled(homes: Iterable[Plan], kinds: Sequence[str] | None) -> Sample:
    total: Sample = {name: [] for name in RELATIONS}
    for home in homes:
        every = home.objects if isinstance(home, Layout) else []
        for room in home.rooms:
            if kinds is None or room.type in kinds:
                for name, found in of_room(polygons.floor(room), [o for o in every if o.room == room.id]).items():
                    total[name] += found
    return total


def of_room(floor: Polygon, things: Sequence[Box]) -> Sample:
    """One entry an object that the relation is about, or one for the room."""
    standing = [o for o in things if footprints.is_obstacle(o) and o.category in categories.TABLE]
    upright = [o for o in standing if categories.TABLE[o.category].place == "floor"]
    return {
        "nightstand_at_bed": _beside(standing, ("nightstand",), BEDS),
        "seat_at_table": _beside(standing, SEATS, TABLES, facing=True),
        "tv_faces_sofa": _beside(standing, ("tv", "tv_stand"), SOFAS, near=np.inf, facing=True),
        "back_to_wall": [float(_at_wall(o, floor)) for o in upright if categories.TABLE[o.category].back],
        "yaw_aligned": [float(_aligned(o, floor)) for o in upright],
        "density": [1 - footprints.walkable_ratio(floor, things)],
        "objects_a_room": [float(len(things))],
    }


def _beside(
    things: Sequence[Box], own: Sequence[str], other: Sequence[str], near: float = NEAR, facing: bool = False
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
