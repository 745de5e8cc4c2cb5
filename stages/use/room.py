"""A furnished room as those who live there meet it: what stands where in the frame of what.

Relations are matrices [i, j] of object j as seen from object i, in metres and degrees.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cache, cached_property

import numpy as np

from apartgen.schemas.errors import near
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan
from apartgen.stages.space import boxes, footprints
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.kernels import free, within
from apartgen.stages.use.kinds import ON_THE_FLOOR, basic
from apartgen.stages.use.site import Site, site

OVERHEAD = 1.2
"""What hangs above this leaves the floor below it to those who stand there, m."""
Names = frozenset[str]


class Furnished:
    """A room with its objects; everything asked of it is computed once."""

    def __init__(self, site: Site, objects: Sequence[Box]) -> None:
        self.site, self.objects = site, list(objects)
        self.names = [basic(o.category) for o in self.objects]
        self.boxes: Boxes = boxes.of(self.objects)
        self.count = Counter(self.names)
        self._which: dict[Names | str, list[int]] = {}

    def which(self, names: Names | str) -> list[int]:
        """Indices of the objects of these categories or of one, and of what is like them; ValueError for what is no
        category."""
        if names not in self._which:
            wanted = frozenset({names}) if isinstance(names, str) else names
            newcomers = _newcomers(wanted)
            self._which[names] = [i for i, name in enumerate(self.names) if name in wanted or newcomers
                                  and not newcomers.isdisjoint(_lineage(self.objects[i].category))]
        return self._which[names]

    def number(self, names: Iterable[str]) -> int:
        """How many objects of these categories there are, and of what is like them."""
        return len(self.which(frozenset(names)))

    def ids(self, *index: int) -> tuple[str, ...]:
        """Ids of objects."""
        return tuple(self.objects[i].id for i in index)

    @cached_property
    def depth(self) -> list[float]:
        """Of each object, m."""
        return [o.size[0] for o in self.objects]

    @cached_property
    def width(self) -> list[float]:
        """Of each object, m."""
        return [o.size[1] for o in self.objects]

    @cached_property
    def bottom(self) -> list[float]:
        """Of each object above the floor, m."""
        return [o.center[2] - o.size[2] / 2 for o in self.objects]

    @cached_property
    def top(self) -> list[float]:
        """Of each object above the floor, m."""
        return [o.center[2] + o.size[2] / 2 for o in self.objects]

    @cached_property
    def stands(self) -> list[bool]:
        """Whether each is in the way of someone on the floor."""
        return [footprints.is_obstacle(o) and not footprints.gives_way(o) and bottom < OVERHEAD
                for o, bottom in zip(self.objects, self.bottom)]

    @cached_property
    def upright(self) -> list[int]:
        """Indices of what stands on the floor, rugs left out."""
        return [i for i, name in enumerate(self.names)
                if self.stands[i] and (name in ON_THE_FLOOR or name not in TABLE)]

    @cached_property
    def axes(self) -> Array:
        """Unit vectors to the front and to the left, (n, 2, 2)."""
        return boxes.axes(self.boxes)

    @cached_property
    def corners(self) -> Array:
        """Of the footprints, (n, 4, 2)."""
        return boxes.corners(self.boxes)

    @cached_property
    def seen(self) -> Array:
        """Corners of j and its middle in the frame of i, (n, n, 5, 2)."""
        points = np.concatenate([self.corners, self.boxes.center[:, None, :2]], 1)
        offset = points[None] - self.boxes.center[:, None, None, :2]
        return np.asarray(np.einsum("ijpk,iak->ijpa", offset, self.axes))

    @cached_property
    def ahead(self) -> Array:
        """How far j's middle lies in front of i's."""
        return np.asarray(self.seen[:, :, 4, 0])

    @cached_property
    def left(self) -> Array:
        """How far j's middle lies to the left of i's."""
        return np.asarray(self.seen[:, :, 4, 1])

    @cached_property
    def least(self) -> Array:
        """Least extents (ahead, left) of j in i's frame, (n, n, 2)."""
        return np.asarray(self.seen.min(2))

    @cached_property
    def most(self) -> Array:
        """Greatest extents (ahead, left) of j in i's frame, (n, n, 2)."""
        return np.asarray(self.seen.max(2))

    @cached_property
    def aside(self) -> Array:
        """Angle between where i looks and j's middle."""
        return np.asarray(np.degrees(np.abs(np.arctan2(self.left, self.ahead))))

    @cached_property
    def look(self) -> Array:
        """Angle between where i looks and the nearest bit of j; 0 where its axis meets j."""
        angles = np.degrees(np.abs(np.arctan2(self.seen[..., 1], self.seen[..., 0]))).min(-1)
        met = (self.least[..., 1] <= 0) & (self.most[..., 1] >= 0) & (self.most[..., 0] > 0)
        return np.where(met, 0.0, angles)

    @cached_property
    def turn(self) -> Array:
        """Angle between where i looks and where j looks, 0 to 180."""
        off = self.boxes.yaw[None] - self.boxes.yaw[:, None]
        return np.asarray(np.degrees(np.abs((off + np.pi) % (2 * np.pi) - np.pi)))

    @cached_property
    def gap(self) -> Array:
        """Plan distance between footprints; inf on the diagonal."""
        return boxes.gap(self.boxes)

    @cached_property
    def deep(self) -> Array:
        """How deep i and j stand in one another; negative where they are apart."""
        return boxes.penetration(self.boxes)

    @cached_property
    def back(self) -> Array:
        """Distance of the middle of each back to the nearest wall, (n,)."""
        return self._to_walls(self.boxes.center[:, :2] - self.axes[:, 0] * self.boxes.size[:, :1] / 2)

    @cached_property
    def wall(self) -> Array:
        """Distance of each footprint to the nearest wall by its corners and sides, (n,)."""
        middles = (self.corners + np.roll(self.corners, 1, 1)) / 2
        points = np.concatenate([self.corners, middles], 1)
        return np.asarray(self._to_walls(points.reshape(-1, 2)).reshape(-1, 8).min(1))

    def wall_beside(self, i: int) -> float:
        """From the sides of an object to the nearest wall, m; walls at its back do not count."""
        ahead, left = self.axes[i]
        middle = self.boxes.center[i, :2] + 0.2 * self.depth[i] * ahead
        ends = [middle + side * self.width[i] / 2 * left for side in (-1, 1)]
        return float(self._to_walls(np.array(ends)).min())

    def lies_between(self, i: int, a: int, b: int) -> bool:
        """Whether an object's footprint is on the straight line between two others' middles."""
        p, q = (self.boxes.center[k, :2] - self.boxes.center[i, :2] for k in (a, b))
        (px, py), (qx, qy) = self.axes[i] @ p, self.axes[i] @ q
        t = np.linspace(0, 1, 33)
        inside = (np.abs(px + t * (qx - px)) < self.depth[i] / 2) & (np.abs(py + t * (qy - py)) < self.width[i] / 2)
        return bool(inside.any())

    @cached_property
    def outside(self) -> Array:
        """How far each footprint's corners lie beyond the walls, (n,)."""
        points = self.corners.reshape(-1, 2)
        place = self.site
        out = [not within(x, y, place.start, place.end) for x, y in points]
        return np.asarray(np.where(out, self._to_walls(points), 0.0).reshape(-1, 4).max(1))

    def _to_walls(self, points: Array) -> Array:
        """Distance of points (p, 2) to the nearest wall, (p,)."""
        place = self.site
        offset = points[:, None] - place.start[None]
        share = (offset * place.along).sum(-1).clip(0, place.length)
        return np.asarray(np.hypot(*np.moveaxis(offset - share[..., None] * place.along, -1, 0)).min(-1))

    @cached_property
    def _rows(self) -> Array:
        """(n, 6) for `free`."""
        c, s = np.cos(self.boxes.yaw), np.sin(self.boxes.yaw)
        return np.column_stack([self.boxes.center[:, :2], c, s, self.boxes.size[:, :2] / 2])

    def frame(self, i: int) -> Array:
        """(x, y, cos, sin) of an object's own frame."""
        return np.asarray(self._rows[i, :4])

    def beside(self, i: int, names: Names, far: float) -> bool:
        """Whether any of these categories stands within `far` of an object."""
        return any(self.gap[i, k] < far for k in self.which(names) if k != i)

    def open(self, i: int, ahead: tuple[float, float], left: tuple[float, float], but: Names = frozenset()) -> float:
        """Share of a rectangle in i's frame that is floor on which nothing stands, but categories `but` and i."""
        return self.clear(self.frame(i), ahead, left, (k for k, name in enumerate(self.names)
                                                       if k != i and name not in but))

    def clear(self, frame: Array, ahead: tuple[float, float], left: tuple[float, float], of: Iterable[int]) -> float:
        """The same in any frame (x, y, cos, sin), clear of the objects `of`."""
        mask = np.zeros(len(self.names), bool)
        for k in of:
            mask[k] = self.stands[k]
        zone = np.array([*ahead, *left], float)
        return float(free(np.ascontiguousarray(frame), zone, self.site.start, self.site.end, self._rows, mask))

    def front(self, i: int, depth: float, spare: float = 0.0, but: Names = frozenset()) -> float:
        """Free share of the floor before i, `depth` deep and as wide as it is, less `spare` on either side."""
        d, w = self.depth[i] / 2, self.width[i] / 2 - spare
        return self.open(i, (d + 0.02, d + depth), (-w, w), but)


@cache
def _newcomers(names: Names) -> Names:
    """Those of some categories that are like others; ValueError for what is no category."""
    if strange := sorted(names - TABLE.keys()):
        raise ValueError(f"no category {strange[0]!r}; {near(strange[0], TABLE)}")
    return frozenset(name for name in names if TABLE[name].like)


def _lineage(category: str) -> tuple[str, ...]:
    return TABLE[category].lineage if category in TABLE else ()


def of_plan(plan: Plan, room_id: str, objects: Iterable[Box]) -> Furnished:
    """A room of a plan with those of the objects that are in it."""
    return Furnished(site(plan, room_id), [o for o in objects if o.room == room_id])
