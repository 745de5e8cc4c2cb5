"""A room being furnished: what stands in it, what fits, and whether one can still walk to everything."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import label

from apartgen.stages.layout.datasets._furnish.shape import CELL, SWING, Shape, within
from apartgen.stages.layout.datasets._furnish.step import friends_of
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Boxes, Mask
from apartgen.stages.things.categories import TABLE, reach

TOUCH = 0.004
"""Contact no deeper than this is none, m."""
ROBOT = 0.25
"""Radius of what must be able to pass, m."""
ARM = 0.75
"""How far in front of a moving part one may stand to use it, m."""
NEAR = 0.6
"""How near one must come to anything else that stands on the floor, m."""
COUNTER = 0.3
"""How much farther one reaches over a counter, m."""
USE_HEIGHT = 1.6
UNDERFOOT = 1.8
"""What hangs above this is no obstacle, m."""
CAPACITY = 48

Use = tuple[float, float, float, float]
"""Floor kept free for use in front, to the left, to the right and behind, m."""
NO_USE: Use = (0.0, 0.0, 0.0, 0.0)


@dataclass
class Space:
    """Objects placed so far, as padded arrays; `body` ⊂ `swept` (open parts) and `used` (room to use it)."""

    shape: Shape
    category: list[str] = field(default_factory=list)
    gap: list[float] = field(default_factory=list)
    near: list[NDArray[np.int64] | None] = field(default_factory=list)

    def __post_init__(self) -> None:
        def empty() -> Boxes:
            return Boxes(np.zeros((CAPACITY, 3)), np.zeros((CAPACITY, 3)), np.zeros(CAPACITY))

        self._body, self._swept, self._used = empty(), empty(), empty()
        self.clear = self.shape.clear.copy()
        self.flat_grid = self.shape.grid.reshape(-1, 2)
        self.seeds = self._door_cells()

    @property
    def n(self) -> int:
        """How many objects there are."""
        return len(self.category)

    @property
    def body(self) -> Boxes:
        """The objects' boxes, (n,)."""
        return self._body.take(slice_to(self.n))

    def find(self, names: tuple[str, ...]) -> list[int]:
        """Indices of the objects of these categories."""
        return [i for i, name in enumerate(self.category) if name in names]

    def fits(self, name: str, at: Boxes, use: Use, partner: int = -1) -> Mask:
        """Which of the boxes (m,) can be had: inside, touching nothing, sweeps and use free, openings respected.

        `partner` may be touched.
        """
        kind = TABLE[name]
        swept = forward(at, reach(name, at.size))
        ok = self._outside_zones(name, at, swept)
        if ok.any():
            ok[ok] = inside(swept.take(ok), self.shape)
        if kind.place == "flat" or not ok.any() or not self.n:
            return ok
        others = np.array([i for i in range(self.n) if i != partner and TABLE[self.category[i]].place != "flat"], int)
        where = np.flatnonzero(ok)
        bad = boxes.penetration(swept.take(where), self._swept.take(others)) > TOUCH
        if kind.place == "floor":
            bad |= self._disturbs(name, at.take(where), use, others)
        ok[where] = ~bad.any(1)
        return ok

    def _outside_zones(self, name: str, at: Boxes, swept: Boxes) -> Mask:
        zones, kind = self.shape.zones, self.shape.zone_kind
        if not len(kind):
            return np.ones(at.n, bool)
        hit = boxes.penetration(at, zones) > TOUCH
        if name == "curtain":
            hit = hit & (kind != 2)
        elif TABLE[name].place == "flat":
            hit = hit & (kind == SWING)
        hit = hit | ((boxes.penetration(swept, zones) > TOUCH) & (kind == SWING))
        return np.asarray(~hit.any(1))

    def _disturbs(self, name: str, at: Boxes, use: Use, others: NDArray[np.int64]) -> Mask:
        """Whether new and old (m, n) stand where the other is used."""
        names = [self.category[i] for i in others]
        stands = np.array([TABLE[other].place == "floor" for other in names], bool)
        stranger = np.array([name not in friends_of(other) for other in names], bool)
        hit = (boxes.penetration(at, self._used.take(others)) > TOUCH) & stands & stranger
        if max(use) > 0:
            stranger = np.array([other not in friends_of(name) for other in names], bool)
            hit |= (boxes.penetration(used(at, use), self._body.take(others)) > TOUCH) & stands & stranger
        return np.asarray(hit)

    def add(self, name: str, at: Boxes, use: Use = NO_USE, gap: float = 0.0) -> int:
        """Place the single box `at` (1,); its index."""
        i = self.n
        swept = forward(at, reach(name, at.size))
        for store, box in ((self._body, at), (self._swept, swept), (self._used, used(at, use))):
            store.center[i], store.size[i], store.yaw[i] = box.center[0], box.size[0], box.yaw[0]
        self.category.append(name)
        self.gap.append(gap)
        self.near.append(self._approach(name, at))
        if obstructs(name, at):
            self.clear = self._cleared(at)
        return i

    def drop_last(self, n: int) -> None:
        """Forget what was placed after the first `n`."""
        del self.category[n:], self.gap[n:], self.near[n:]
        self.clear = self.shape.clear.copy()
        for i in range(n):
            if obstructs(self.category[i], self._body.take([i])):
                self.clear = self._cleared(self._body.take([i]))

    def _cleared(self, at: Boxes) -> Array:
        return np.minimum(self.clear, boxes.distance(self.flat_grid, at)[:, 0].reshape(self.clear.shape))

    def stays_open(self, name: str, at: Boxes) -> bool:
        """Whether every door and every object can still be walked to with the box `at` (1,) in place."""
        if not obstructs(name, at) and not TABLE[name].articulated:
            return True
        clear = self._cleared(at) if obstructs(name, at) else self.clear
        parts, _ = label(clear >= ROBOT)
        flat = parts.ravel()
        if not len(self.seeds):
            return True
        home = np.bincount(flat[self.seeds], minlength=1)
        home[0] = 0
        main = int(home.argmax()) if len(home) > 1 else 0
        if main == 0 or (flat[self.seeds] == main).mean() < self.start_share - 1e-9:
            return False
        approaches = [*self.near, self._approach(name, at)]
        return all(bool((flat[cells] == main).any()) for cells in approaches if cells is not None)

    def _door_cells(self) -> NDArray[np.int64]:
        """The walkable grid cell just inside each door; doors that no robot passes even when empty are left out."""
        parts, _ = label(self.clear >= ROBOT)
        flat, cells = parts.ravel(), []
        for x, y, nx, ny, _ in self.shape.doors:
            point = np.array([x + 0.35 * nx, y + 0.35 * ny])
            apart = np.hypot(*(self.flat_grid - point).T)
            apart[flat == 0] = np.inf
            cells.append(int(apart.argmin()))
        seeds = np.array(cells, np.int64)
        home = np.bincount(flat[seeds], minlength=1) if len(seeds) else np.zeros(1)
        self.start_share = float(home.max() / max(1, len(seeds)))
        return seeds

    def _approach(self, name: str, at: Boxes) -> NDArray[np.int64] | None:
        """Grid cells from which the object can be used; None where that does not matter."""
        kind = TABLE[name]
        if kind.articulated and at.center[0, 2] - at.size[0, 2] / 2 < UNDERFOOT:
            seen = boxes.local(self.flat_grid, at)[0]
            front, half = seen[:, 0] - at.size[0, 0] / 2, at.size[0, 1] / 2
            arm = ARM if kind.place == "floor" else ARM + COUNTER
            return np.flatnonzero((front > 0) & (front < arm) & (np.abs(seen[:, 1]) < half + CELL))
        if kind.place == "floor" and at.size[0, :2].min() > 0.3:
            return np.flatnonzero(boxes.distance(self.flat_grid, at)[:, 0] < NEAR)
        return None


def slice_to(n: int) -> NDArray[np.int64]:
    """Indices 0 … n-1."""
    return np.arange(n)


def obstructs(name: str, at: Boxes) -> bool:
    """Whether one has to walk round it."""
    return TABLE[name].place in ("floor", "wall") and float(at.center[0, 2] - at.size[0, 2] / 2) < UNDERFOOT


def forward(at: Boxes, by: Array) -> Boxes:
    """The boxes grown to the front by `by` (m,)."""
    if not np.any(by):
        return at
    shift = boxes.axes(at)[:, 0] * (np.asarray(by)[:, None] / 2)
    center = at.center.copy()
    center[:, :2] += shift
    size = at.size.copy()
    size[:, 0] += by
    return Boxes(center, size, at.yaw)


def used(at: Boxes, use: Use) -> Boxes:
    """The boxes with the room around them that their use takes."""
    if max(use) <= 0:
        return at
    front, left, right, back = use
    half = at.size / 2
    lo = np.stack([-half[:, 0] - back, -half[:, 1] - right, -half[:, 2]], 1)
    hi = np.stack([half[:, 0] + front, half[:, 1] + left, np.maximum(half[:, 2], USE_HEIGHT - at.center[:, 2])], 1)
    return boxes.spread(at, lo, hi)


def inside(at: Boxes, shape: Shape) -> Mask:
    """Which boxes (m,) lie in the room: centre inside, no side of the room crosses them."""
    half = (at.size[:, None, :2] / 2 - 1e-3).clip(1e-4)
    a, b = boxes.local(shape.start, at), boxes.local(shape.end, at)
    apart = (np.maximum(a, b) < -half) | (np.minimum(a, b) > half)
    d = b - a
    across = np.abs(d[..., 0] * a[..., 1] - d[..., 1] * a[..., 0])
    apart_on_normal = across > half[..., 0] * np.abs(d[..., 1]) + half[..., 1] * np.abs(d[..., 0])
    crossing = ~(apart.any(-1) | apart_on_normal)
    return np.asarray(~crossing.any(1) & within(at.center[:, :2], shape.start))
