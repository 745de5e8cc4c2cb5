"""Kitchen runs: units side by side along one wall, round a corner or two, in the order in which one cooks. The tall
stand at an end, worktop between sink and hob; the hood hangs over the hob, wall units over the rest but before windows.
"""

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish import anchors, corners, hanging
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone
from apartgen.stages.layout.datasets._furnish.hanging import Style
from apartgen.stages.layout.datasets._furnish.legs import Leg, length, paths, stretches
from apartgen.stages.layout.datasets._furnish.shape import WINDOW
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array

TALL = ("fridge", "tower")
LOW = ("kitchen_base", "kitchen_drawers", "dishwasher", "washing_machine")
"""Units with worktop."""
WORKTOP, GOOD = 1.2, 4.0
"""Worktop in one piece beside sink or hob, m, and what a run that has it is worth."""
AROUND = 1.7
"""What meets in a corner stands no further from the unit that fills it, middle to middle, m."""
AISLE, AISLE_LEAST = 1.0, 0.8
BAKES = 0.8
"""Share of the hobs with drawers below that have an oven there instead, where no tall one stands."""
TRIES, ENOUGH, MORE = 90, 24, 4
"""Runs drawn up, of how many the most liked is tried first, and how often so many are drawn while none has worktop."""


@dataclass(frozen=True)
class Unit:
    """A unit of the run: what it is (a `tower` is a tall oven) and its size."""

    name: str
    size: Array

    @property
    def category(self) -> str:
        """The category of its box."""
        return "oven" if self.name == "tower" else self.name


def furnish(space: Space, reserve: int, laundry: bool) -> list[int]:
    """The run and what hangs above it, `reserve` objects left for others; indices of the units that stand."""
    style = _style(space)
    free = stretches(space, style.depth, style.height)
    ways = [path for path in paths(space, free, style.depth) if sum(leg.high - leg.low for leg in path) > 1.5]
    if not ways:
        return []
    budget = min(space.left - reserve - 1, 17)
    pose = anchors.free(np.zeros((1, 2)), np.zeros(1))
    for apart in (True, False):
        for group in _liked(space, ways, style, budget, laundry, apart):
            before = space.n
            if space.put(group, pose, np.zeros(1)) >= 0:
                return _stand(space, before, group)
    return []


def _liked(space: Space, ways: list[list[Leg]], style: Style, budget: int, laundry: bool, apart: bool) -> list[Group]:
    """Runs that could stand, the most liked first; where `apart`, none of their units open into one another."""
    tries: list[tuple[float, Group]] = []
    good = False
    for k in range(MORE * TRIES):
        if len(tries) >= ENOUGH and good or k >= TRIES and good:
            break
        path = ways[int(space.rng.integers(len(ways)))]
        nth = k % TRIES
        units = _units(path, style, space.rng, budget, laundry, nth)
        aisle = AISLE if nth < TRIES // 2 else AISLE_LEAST
        if group := _built(space, path, units, style, space.rng, budget, aisle, apart):
            worth = _worth(space, group, path)
            good |= worth > GOOD
            tries.append((worth + space.rng.gumbel(0, 0.5), group))
    return [group for _, group in sorted(tries, key=lambda row: -row[0])]


def _stand(space: Space, before: int, group: Group) -> list[int]:
    """Say by which wall each unit stands; indices of those on the floor."""
    floor = [before + i for i, p in enumerate(group.parts) if p.z == 0]
    for i in range(before, space.n):
        if space.placed.at[i] == "free":
            row = space.placed.row[i]
            off = np.abs(((row[:2] - space.shape.start) * space.shape.normal).sum(1) - row[3] / 2)
            off += 9.0 * (space.shape.normal @ row[6:8] < 0.99)
            space.placed.at[i] = f"wall {int(off.argmin())}"
    return floor


def _style(space: Space) -> Style:
    rng = space.rng
    sills = [float(w[5]) for w in space.shape.windows if 0.84 <= w[5] <= 0.93]
    height = min([float(rng.choice([0.86, 0.9, 0.9, 0.92])), *sills])
    hang = round(max(height + 0.5, 1.38), 3)
    wall = draw("wall_unit", rng)
    wall[0], wall[2] = rng.choice([0.32, 0.35, 0.37]), min(wall[2], space.shape.height - hang - 0.06, 0.95)
    return Style(float(rng.choice([0.6, 0.6, 0.62, 0.65])), height, np.round(wall, 3), hang)


def _units(path: list[Leg], style: Style, rng: Generator, budget: int, laundry: bool, nth: int) -> list[Unit]:
    """Units in line, as many as the way is long; later tries are content with less."""
    corner, slack = 0.5 * (len(path) - 1), 1.2 * nth / TRIES
    room = length(path) - 0.02 * len(path) - rng.uniform(0.0, corner + slack)
    cooker = rng.random() < 0.35
    basins = [0.6, 0.8, 0.8, 1.0] if room > 3.9 else [0.6, 0.8] if room > 3.3 else [0.6]
    heat, sink = "oven" if cooker else "hob", float(rng.choice(basins))
    hob = 0.6 if cooker or room < 4.0 else float(rng.choice([0.6, 0.6, 0.8]))
    fridge = draw("fridge", rng)
    fridge[1] = fridge[1] if room > 3.6 else min(fridge[1], 0.6)
    if room < 2.0:
        sink, hob, fridge[1] = 0.5, 0.5, 0.55
    left = room - sink - hob - fridge[1]
    between: list[tuple[str, float]] = []
    if left >= 0.6 and rng.random() < 0.8:
        between.append(("dishwasher", 0.6 if left > 1.0 or left < 0.75 else 0.45))
    want = WORKTOP - sum(w for _, w in between)
    if left - sum(w for _, w in between) >= min(want, 0.4):
        w = min(_sold(left - sum(w for _, w in between), rng, want), 1.2)
        between.append((str(rng.choice(["kitchen_drawers", "kitchen_base"])), w))
    left -= sum(w for _, w in between)
    ends: list[tuple[str, float]] = [("washing_machine", 0.6)] if laundry and left > 0.61 else []
    left -= 0.6 * len(ends)
    towers = [("tower", 0.6)] if not cooker and left > 1.0 and rng.random() < 0.55 else []
    left -= 0.6 * len(towers)
    if not towers and rng.random() < BAKES:
        heat, hob = "oven", min(hob, 0.6)
    limit = min(3 + int(room > 5), max(0, budget - 9))
    while left > 0.32 and len(ends) < limit and (rng.random() < 0.85 or room < 4.5):
        w = _sold(min(left, 0.9), rng, 0.6)
        ends.append((str(rng.choice(["kitchen_base", "kitchen_drawers" if w >= 0.4 else "kitchen_base"])), w))
        left -= w
    if rng.random() < 0.5:
        between.reverse()
    if between and between[0][0] != "dishwasher" and any(n == "dishwasher" for n, _ in between):
        between.reverse()
    k, turned = int(rng.integers(0, len(ends) + 1)), bool(rng.random() < 0.4 and ends)
    k = max(k, 1) if turned else k  # what cooks stands not right beside what is tall
    wet = [("kitchen_sink", sink), *between, (heat, hob)]
    line = [("fridge", float(fridge[1])), *towers, *ends[:k], *(wet[::-1] if turned else wet), *ends[k:]]
    return [Unit(name, _size(name, w, style, fridge)) for name, w in line]


def _sold(most: float, rng: Generator, liked: float) -> float:
    """A width as sold, no more than `most`, about what is liked."""
    some = [w for w in (0.3, 0.4, 0.5, 0.6, 0.8, 0.9, 1.0, 1.2) if w <= most + 1e-9]
    return float(min(some, key=lambda w: abs(w - liked) + rng.uniform(0, 0.15))) if some else 0.3


def _size(name: str, width: float, style: Style, fridge: Array) -> Array:
    if name == "fridge":
        return np.asarray(np.round(fridge, 3))
    if name == "tower":
        return np.array([style.depth, 0.6, 2.1])
    height = min(style.height, 0.9) if name == "dishwasher" else style.height
    depth = min(style.depth, {"dishwasher": 0.65, "washing_machine": 0.64}.get(name, 1.0))
    return np.round(np.array([depth, width, height]), 3)


def _built(
    space: Space, path: list[Leg], units: list[Unit], style: Style, rng: Generator, budget: int, aisle: float,
    apart: bool,
) -> Group | None:
    """The run along the path, either way round, broken at corners where it fits."""
    line = _filling(path, units if rng.random() < 0.5 else units[::-1], rng)
    spread = _divided(path, [float(u.size[1]) for u in line], rng)
    if spread is None:
        return None
    legs: list[list[Part]] = []
    for leg, (s, some) in zip(path, spread, strict=True):
        legs.append([])
        for u in (line[i] for i in some):
            legs[-1].append(_at(space, leg.side, s + float(u.size[1]) / 2, u.category, u.size))
            s += float(u.size[1])
    turned = corners.joined(space, path, legs, style.depth, style.height, apart)
    if turned is None:
        return None
    parts = [p for leg in turned[0] for p in leg]
    zones = [_before(p, aisle) for p in parts]
    parts += turned[1]
    windows = space.shape.zone_rows[space.shape.zone_kind == WINDOW]
    for p in parts:
        if (p.size[2] > 1.3 or p.name in ("hob", "oven")) and hanging.lit(p, windows, 2.0):
            return None
    hung = hanging.over_units(parts, style, rng, windows, budget - len(parts), space.shape.height)
    return None if corners.hinder([*parts, *hung], apart) else Group((*parts, *hung), tuple(zones))


def _filling(path: list[Leg], line: list[Unit], rng: Generator) -> list[Unit]:
    """With a cupboard so much wider that units fill the leg between two corners, where that is little."""
    if len(path) < 3:
        return line
    room, widths = path[1].high - path[1].low - 0.006, [float(u.size[1]) for u in line]
    spans = [(k, j) for k in range(1, len(line)) for j in range(k + 1, len(line))
             if 0 <= room - sum(widths[k:j]) < 0.25]
    if not spans:
        return line
    k, j = spans[int(rng.integers(len(spans)))]
    spare = room - sum(widths[k:j]) - 0.004
    for i in range(k, j):
        if line[i].name in ("kitchen_base", "kitchen_drawers") and widths[i] + spare <= 1.2:
            size = line[i].size + np.array([0.0, max(spare, 0.0), 0.0])
            return [*line[:i], Unit(line[i].name, size), *line[i + 1 :]]
    return line


def _divided(path: list[Leg], widths: list[float], rng: Generator) -> list[tuple[float, list[int]]] | None:
    """For each leg where its first unit begins and which units stand there; None where they don't fit."""
    rooms = [leg.high - leg.low - 0.006 for leg in path]
    if len(path) == 1:
        spare = rooms[0] - sum(widths)
        if spare < 0:
            return None
        s = path[0].low + 0.003 + spare * float(rng.choice([0.0, 0.0, 1.0, 1.0, 0.5]))
        return [(s, list(range(len(widths))))]
    cuts = [k for k in range(1, len(widths)) if sum(widths[:k]) <= rooms[0]]
    rng.shuffle(cuts)
    for k in cuts:
        rest = _rest(path[1:], rooms[1:], widths, k)
        if rest is not None:
            return [(path[0].high - 0.003 - sum(widths[:k]), list(range(k))), *rest]
    return None


def _rest(path: list[Leg], rooms: list[float], widths: list[float], k: int) -> list[tuple[float, list[int]]] | None:
    """The units from `k` on along the remaining legs: a middle leg is filled from corner to corner."""
    if len(path) == 1:
        return [(path[0].low + 0.003, list(range(k, len(widths))))] if sum(widths[k:]) <= rooms[0] else None
    for j in range(k + 1, len(widths)):
        if rooms[0] - 0.02 <= sum(widths[k:j]) <= rooms[0] and sum(widths[j:]) <= rooms[1]:
            return [(path[0].low + 0.003, list(range(k, j))), (path[1].low + 0.003, list(range(j, len(widths))))]
    return None


def _at(space: Space, side: int, s: float, name: str, size: Array, z: float = 0.0, at: int = -1) -> Part:
    shape = space.shape
    xy = shape.start[side] + shape.along[side] * s + shape.normal[side] * (size[0] / 2 + anchors.OFF)
    yaw = float(np.arctan2(shape.normal[side, 1], shape.normal[side, 0]))
    return Part(name, float(xy[0]), float(xy[1]), size, yaw, z, at)


def _before(p: Part, depth: float) -> Zone:
    """Floor before a unit, along the world's axes."""
    c, s = np.cos(p.yaw), np.sin(p.yaw)
    near, far, half = p.size[0] / 2, p.size[0] / 2 + depth, p.size[1] / 2
    xs, ys = zip(*((p.x + u * c - v * s, p.y + u * s + v * c) for u in (near, far) for v in (-half, half)), strict=True)
    return Zone(min(xs), max(xs), min(ys), max(ys))


def _worth(space: Space, group: Group, path: list[Leg]) -> float:
    """What a run is liked for: worktop in one piece beside sink or hob, units, a sink at the window, corners."""
    stand = [p for p in group.parts if p.z == 0 and p.name != corners.NAME]
    best = _worktop(stand, [p for p in group.parts if p.name == corners.NAME])
    sink = [p for p in stand if p.name == "kitchen_sink"]
    xy = np.array([[p.x, p.y] for p in sink])
    near = float(anchors.to_windows(xy, space)[0]) if len(sink) else 9.0
    good = GOOD * (best >= WORKTOP - 1e-6)
    return 0.45 * len(stand) + good + 0.5 * best + min(best, WORKTOP) - 0.15 * min(near, 4.0) + 0.2 * len(path)


def _worktop(stand: list[Part], filling: list[Part]) -> float:
    """The longest piece of worktop beside sink or hob, m; on round a corner where a unit fills it."""
    best, piece, hot = 0.0, 0.0, False
    for before, p in zip([None, *stand], [*stand, None], strict=True):
        if before is not None and p is not None and abs(np.cos(before.yaw - p.yaw)) < 0.9:
            between = [c for c in filling if max(np.hypot(c.x - q.x, c.y - q.y) for q in (before, p)) < AROUND]
            if not between:
                best, piece, hot = max(best, piece if hot else 0.0), 0.0, False
            piece += sum(float(c.size[1]) for c in between)
        if p is not None and p.name in LOW:
            piece += float(p.size[1])
            continue
        wet = p is not None and p.name in ("kitchen_sink", "hob", "oven")
        best, piece, hot = max(best, piece if wet or hot else 0.0), 0.0, wet
    return best
