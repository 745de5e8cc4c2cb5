"""A room being furnished: what stands in it, what fits, and whether one can still walk to everything."""

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from apartgen.stages.layout.datasets._furnish import kernels
from apartgen.stages.layout.datasets._furnish.group import NOTHING, Group, Placed, Poses, rows
from apartgen.stages.layout.datasets._furnish.shape import SWING, WINDOW, Shape
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.things.categories import TABLE, belong_together

TOUCH = 0.004
"""Contact no deeper than this is none, m."""
WALK = 0.27
"""Radius of what must be able to pass, m."""
ARM = 0.75
"""How far in front of open parts one may stand to use them, m."""
ASIDE = 0.22
COMES_WITHIN = 0.62
"""How near one must come to anything else that stands on the floor, m."""
POCKET = 0.5
"""No more floor than this may be cut off, m²."""
UNDERFOOT = 1.5
"""What hangs above this is no obstacle, m."""
LOOKS = 6
"""How many of the liked places are tried for passage."""
GIVEN_UP = 50.0
MOST = 24
"""Objects a room holds at most."""


class Space:
    """A room and what stands in it."""

    def __init__(self, shape: Shape, rng: Generator, most: int = MOST, taste: dict[str, float] | None = None,
                 strict: bool = False) -> None:
        self.shape, self.rng, self.most = shape, rng, most
        self.taste = {} if taste is None else taste
        self.missed, self.strict = 0.0, strict
        self.placed = Placed()
        self.models: dict[str, Array] = {}
        self._marks: list[tuple[int, int]] = []
        self.seeds, self.share = self._door_cells()

    @property
    def n(self) -> int:
        """How many objects there are."""
        return len(self.placed.name)

    @property
    def left(self) -> int:
        """How many more there may be."""
        return self.most - self.n

    def find(self, *names: str) -> list[int]:
        """Indices of the objects of these categories."""
        return [i for i, name in enumerate(self.placed.name) if name in names]

    def has(self, *names: str) -> bool:
        """Whether there is any of these categories."""
        return bool(self.find(*names))

    @property
    def lost(self) -> bool:
        """Whether it is better to begin again."""
        if self.strict and self.missed > 0:
            self.missed += GIVEN_UP
            return True
        return False

    def wants(self, what: str, share: float) -> bool:
        """Whether those who live here want something that a share of people have; asked again, the answer stays."""
        if what not in self.taste:
            self.taste[what] = float(self.rng.random())
        return self.taste[what] < share

    def wish(self, what: str, share: float, put: Callable[[], object]) -> bool:
        """Put what is wanted; whether it stands. What is wanted and finds no place is counted."""
        if not self.wants(what, share):
            return False
        done = bool(put())
        self.need(done)
        return done

    def need(self, done: bool, worth: float = 1.0) -> None:
        """Count what was needed and found no place."""
        self.missed += 0.0 if done else worth

    def model(self, name: str) -> Array:
        """The size that all of the category have in this room."""
        if name not in self.models:
            self.models[name] = draw(name, self.rng)
        return self.models[name].copy()

    def fits(self, group: Group, at: Poses) -> Mask:
        """At which poses the group stands inside, touching nothing, all that opens and all that is used free."""
        if group.parts and len(group.parts) > self.left:
            return np.zeros(len(at), bool)
        some, shape = rows(group, at), self.shape
        names = [p.name for p in group.parts]
        asked = np.ones(2 * len(names) + len(group.zones), bool)
        every = np.ascontiguousarray(np.concatenate([some.body, some.sweep, some.zone], 1))
        moving = np.array([p.opens > 0 for p in group.parts], bool)
        asked[len(names) : 2 * len(names)] = moving
        asked[2 * len(names) :] = [zone.inside for zone in group.zones]
        ok = ~kernels.leaves(every, asked, shape.start, 2e-3)
        if len(shape.zone_kind):
            ok[ok] = ~kernels.clash(every[ok], shape.zone_rows, self._openings(group), TOUCH)
        if self.n and ok.any():
            others, forbidden = self._forbidden(group)
            ok[ok] = ~kernels.clash(every[ok], others, forbidden, TOUCH)
        return np.asarray(ok)

    def _openings(self, group: Group) -> Mask:
        """Which parts, sweeps and zones (p + p + z, o) must keep off which zones of openings."""
        kind, p, z = self.shape.zone_kind, len(group.parts), len(group.zones)
        out = np.zeros((2 * p + z, len(kind)), bool)
        for i, part in enumerate(group.parts):
            flat, soft = TABLE[part.name].place == "flat", TABLE[part.name].soft
            out[i] = (kind == SWING) if flat else (kind != WINDOW) if soft else True
            out[p + i] = (kind == SWING) & (part.opens > 0)
        return out

    def _forbidden(self, group: Group) -> tuple[Array, Mask]:
        """Boxes of what stands (bodies, sweeps, zones), and which of the group's (p + p + z, q) may not meet them."""
        placed, p, n = self.placed, len(group.parts), self.n
        body = np.array([[_apart(part.name, name) for name in placed.name] for part in group.parts], bool)
        ours = np.array([part.name for part in group.parts])
        opens = np.array([part.opens > 0 for part in group.parts], bool)
        out = np.zeros((2 * p + len(group.zones), 2 * n + len(placed.zone)), bool)
        out[:p, :n] = body
        out[:p, n : 2 * n] = body
        out[p : 2 * p, :n] = body & opens[:, None]
        stands = np.array([TABLE[name].place == "floor" for name in placed.name], bool)
        for k, zone in enumerate(group.zones):
            out[2 * p + k, :n] = stands & [name not in zone.friends for name in placed.name]
        for k, friends in enumerate(placed.friends):
            out[:p, 2 * n + k] = [TABLE[name].place == "floor" and name not in friends for name in ours]
        return np.ascontiguousarray(np.stack([*placed.row, *placed.sweep, *placed.zone])), out

    def put(self, group: Group, at: Poses, liking: Array, noise: float = 0.3, looks: int = LOOKS) -> int:
        """Place the group at one of the poses, the more liked the likelier; index of its first object, -1 for none."""
        if not len(at):
            return -1
        ok = np.flatnonzero(self.fits(group, at))
        taste = liking[ok] + self.rng.gumbel(0, noise, len(ok))
        for k in ok[np.argsort(-taste)[:looks]]:
            before = self.n
            self._add(_only(group, int(k), len(at)), at.take(np.array([k])))
            if self.open():
                return before
            self.undo(before)
        return -1

    def _add(self, group: Group, at: Poses) -> None:
        placed, n = self.placed, self.n
        some = rows(group, at)
        side = int(at.side[0])
        for i, part in enumerate(group.parts):
            placed.name.append(part.name)
            placed.row.append(some.body[0, i])
            placed.sweep.append(some.sweep[0, i])
            placed.at.append(n + part.at if part.at >= 0 else f"wall {side}" if side >= 0 else "free")
        for i, zone in enumerate(group.zones):
            placed.zone.append(some.zone[0, i])
            placed.friends.append(zone.friends)
        self._marks.append((n, len(group.zones)))

    def undo(self, n: int) -> None:
        """Forget all groups placed after the first `n` objects."""
        placed = self.placed
        while self._marks and self._marks[-1][0] >= n:
            zones = self._marks.pop()[1]
            del placed.zone[len(placed.zone) - zones :], placed.friends[len(placed.friends) - zones :]
        del placed.name[n:], placed.row[n:], placed.sweep[n:], placed.at[n:]

    def open(self) -> bool:
        """Whether every door and everything that stands here can be walked to, and little floor is cut off."""
        if not len(self.seeds):
            return True
        part, main, joined = self._parts()
        if main == 0 or joined < self.share - 1e-9:
            return False
        small = int((part > 0).sum() - (part == main).sum())
        if small * self.shape.cell**2 > POCKET + self.shape.cut:
            return False
        placed = self.placed
        asked = [(i, use) for i, name in enumerate(placed.name) if _used(name, placed.row[i])
                 for use in _uses(name, placed.sweep[i])]
        if not asked:
            return True
        some = np.ascontiguousarray(np.stack([placed.row[i] for i, _ in asked]))
        return bool(kernels.got_to(self.shape.grid, part, main, some, np.array([use for _, use in asked])).all())

    def _parts(self) -> tuple[NDArray[np.int32], int, float]:
        """Parts of the floor that hang together, which of them has most doors, and its share of doors."""
        free = self.shape.clear >= WALK
        some = [row for name, row in zip(self.placed.name, self.placed.row, strict=True) if _obstructs(name, row)]
        if some:
            free &= kernels.away(self.shape.grid, np.ascontiguousarray(np.stack(some)), WALK + 0.1) >= WALK
        part = kernels.parts(np.ascontiguousarray(free))
        found = part.ravel()[self.seeds]
        home = np.bincount(found, minlength=1)
        home[0] = 0
        main = int(home.argmax()) if len(home) > 1 else 0
        return part, main, float((found == main).mean()) if main else 0.0

    def _door_cells(self) -> tuple[NDArray[np.int64], float]:
        """The walkable grid cell just inside each door, and the share of doors joined in the empty room."""
        shape = self.shape
        part = kernels.parts(np.ascontiguousarray(shape.clear >= WALK)).ravel()
        flat, cells = shape.grid.reshape(-1, 2), []
        for x, y, nx, ny, _ in shape.doors:
            apart = np.hypot(*(flat - (x + 0.4 * nx, y + 0.4 * ny)).T)
            apart[part == 0] = np.inf
            cells.append(int(apart.argmin()))
        seeds = np.array(cells, np.int64)
        home = np.bincount(part[seeds], minlength=1) if len(seeds) else np.zeros(1, int)
        home[0] = 0
        return seeds, float(home.max() / max(1, len(seeds)))


@lru_cache(maxsize=8192)
def _apart(a: str, b: str) -> bool:
    """Whether two categories must not touch."""
    return "flat" not in (TABLE[a].place, TABLE[b].place) and not belong_together(a, b)


def _obstructs(name: str, row: Array) -> bool:
    return TABLE[name].place in ("floor", "wall") and float(row[2] - row[5] / 2) < UNDERFOOT


def _used(name: str, row: Array) -> bool:
    if TABLE[name].place == "floor":
        return bool(min(row[3], row[4]) > 0.3 or TABLE[name].articulated)
    return False


def _uses(name: str, sweep: Array) -> list[tuple[float, float, float, float]]:
    """What `kernels.got_to` asks of a thing: shut, and with its parts open."""
    if not TABLE[name].articulated:
        return [(-1.0, COMES_WITHIN, 0.0, 0.0)]
    opened = float(sweep[3]) if sweep[2] > NOTHING[2] + 1 else 0.0
    return [(0.0, ARM, ASIDE, 0.0), (opened, ARM, ASIDE, WALK)]


def _only(group: Group, k: int, m: int) -> Group:
    """The group as it is at pose `k` of `m`."""
    def one(value: float | Array) -> float | Array:
        return value[k : k + 1] if isinstance(value, np.ndarray) and value.shape == (m,) else value

    parts = tuple(replace(p, x=one(p.x), y=one(p.y), yaw=one(p.yaw)) for p in group.parts)
    zones = tuple(replace(z, x0=one(z.x0), x1=one(z.x1), y0=one(z.y0), y1=one(z.y1)) for z in group.zones)
    return Group(parts, zones)
