"""Kitchen runs: units side by side along one wall or two, tall ones at an end, wall units and hood above."""

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import NO_USE, Space
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Boxes

USE = (0.75, 0.0, 0.0, 0.0)
"""Floor kept free before a run, m."""
TRIES = 7
WORTH = {"kitchen_sink": 3.0, "hob": 2.6, "oven": 2.2, "fridge": 2.0}
"""How much more than a filler a unit matters."""
FILLERS = ("kitchen_base", "kitchen_drawers", "kitchen_base")


@dataclass
class Kitchen:
    """One kitchen's choices: a common depth and height, the order of its units."""

    depth: float
    height: float
    tall_oven: bool


def furnish(space: Space, budget: int, rng: Generator) -> None:
    """Put up to `budget` kitchen units and what hangs above them."""
    depth, height = float(rng.choice([0.6, 0.6, 0.62])), float(rng.choice([0.88, 0.9, 0.92]))
    style = Kitchen(depth, height, tall_oven=bool(rng.random() < 0.45))
    units = _units(budget, style, rng)
    rest = _best_run(space, units, style, rng)
    for _ in range(2):
        if rest:
            rest = _best_run(space, rest, style, rng)
    for name in rest:
        if name in ("fridge", "kitchen_sink", "hob", "oven"):
            _single(space, name, style, rng)
    _hang(space, budget - space.n, rng)


def _units(budget: int, style: Kitchen, rng: Generator) -> list[str]:
    """Which units, most needed first."""
    cooking = ["hob", "oven"] if budget > 5 and rng.random() < 0.6 else ["oven"] if rng.random() < 0.6 else ["hob"]
    if cooking == ["oven"]:
        style.tall_oven = False
    wanted = ["kitchen_sink", cooking[0], "fridge", "kitchen_base", *cooking[1:]]
    more = ["dishwasher"] * int(rng.random() < 0.75) + ["kitchen_drawers"] * int(rng.random() < 0.8)
    more += [str(rng.choice(FILLERS)) for _ in range(int(rng.integers(0, 4)))]
    wanted += [more[k] for k in rng.permutation(len(more))]
    share = 0.62 if budget > 6 else 0.8
    return wanted[: max(3, round(share * budget))]


def _order(units: list[str], style: Kitchen, rng: Generator) -> list[str]:
    """Units in line: tall at one end, dishwasher by the sink, sink and hob apart."""
    tall = [u for u in units if u == "fridge" or (u == "oven" and style.tall_oven)]
    low = [u for u in units if u not in tall]
    wet = [u for u in low if u == "kitchen_sink"] + [u for u in low if u == "dishwasher"]
    hot = [u for u in low if u in ("hob", "oven")]
    fill = [u for u in low if u in FILLERS]
    if rng.random() < 0.5:
        wet.reverse()
    if rng.random() < 0.5:
        hot.reverse()
    k = int(rng.integers(0, len(fill) + 1))
    middle, ends = fill[: max(k, min(1, len(fill)))], fill[max(k, min(1, len(fill))) :]
    line = [*tall, *ends[: len(ends) // 2], *wet, *middle, *hot, *ends[len(ends) // 2 :]]
    return line if rng.random() < 0.5 else line[::-1]


def _size(name: str, style: Kitchen, rng: Generator) -> Array:
    size = draw(name, rng)
    if name == "fridge":
        return size
    size[0] = style.depth
    size[2] = style.height if not (name == "oven" and style.tall_oven) else 2.1
    if name == "dishwasher":
        size[2] = min(style.height, 0.9)
    return size


def _best_run(space: Space, units: list[str], style: Kitchen, rng: Generator) -> list[str]:
    """Build the longest run found; the units that did not fit."""
    best: list[tuple[str, Boxes]] = []
    for k in range(TRIES):
        keep = units if k < 2 else units[: max(2, len(units) - k + 1)]
        line = _order(keep, style, rng)
        run = _run(space, line, [_size(name, style, rng) for name in line], rng)
        if _worth(run) > _worth(best) and _passable(space, run):
            best = run
        if len(best) == len(units):
            break
    left = list(units)
    for name, box in best:
        space.add(name, box, USE)
        left.remove(name)
    return left


def _worth(run: list[tuple[str, Boxes]]) -> float:
    return sum(WORTH.get(name, 1.0) for name, _ in run)


def _passable(space: Space, run: list[tuple[str, Boxes]]) -> bool:
    """Whether doors and what stands already can still be reached, and every unit of the run too."""
    before = space.n
    for name, box in run:
        space.add(name, box, USE)
    ok = bool(run) and space.stays_open(run[-1][0], run[-1][1])
    space.drop_last(before)
    return ok


def _run(space: Space, line: list[str], sizes: list[Array], rng: Generator) -> list[tuple[str, Boxes]]:
    """The longest stretch of the line that fits along any wall, at a corner rather than anywhere."""
    widths = np.array([size[1] for size in sizes])
    side, start, liking = _starts(space, float(widths.sum()), rng)
    middle = start[:, None] + np.cumsum(widths) - widths / 2
    along, normal = space.shape.along[side], space.shape.normal[side]
    yaw = np.arctan2(normal[:, 1], normal[:, 0])
    fitting = np.zeros((len(side), len(line)), bool)
    placed: list[Boxes] = []
    for k, (name, size) in enumerate(zip(line, sizes, strict=True)):
        xy = space.shape.start[side] + along * middle[:, k, None] + normal * (size[0] / 2 + 1e-3)
        at = Boxes(np.column_stack([xy, np.full(len(xy), size[2] / 2)]), np.tile(size, (len(xy), 1)), yaw)
        placed.append(at)
        fitting[:, k] = space.fits(name, at, USE)
    spans = [_longest(row, line) for row in fitting]
    worth = [WORTH.get(name, 1.0) for name in line]
    score = np.array([sum(worth[lo:hi]) for lo, hi in spans]) + liking
    best = int(score.argmax())
    lo, hi = spans[best]
    return [(line[k], placed[k].take([best])) for k in range(lo, hi)]


def _starts(space: Space, wide: float, rng: Generator) -> tuple[NDArray[np.int64], Array, Array]:
    """Where a run of that width may begin: side, place along it, how much it is liked (below 1)."""
    side, start, liking = [], [], []
    for k, length in enumerate(space.shape.length):
        free = float(length) - wide
        ends = [1e-3, free - 1e-3] if free > 2e-3 else [1e-3, length - wide - 1e-3]
        for s in [*ends, free / 2, *rng.uniform(min(free, 0.0), max(free, 0.01), 6)]:
            side.append(k)
            start.append(s)
            liking.append(0.5 * (s in ends) + 0.4 * rng.random())
    return np.array(side), np.array(start), np.array(liking)


def _longest(fitting: NDArray[np.bool_], line: list[str]) -> tuple[int, int]:
    """First and past-the-last unit of the stretch without a gap that matters most."""
    best, start, most = (0, 0), 0, 0.0
    for k, good in enumerate([*fitting, False]):
        if not good:
            worth = sum(WORTH.get(name, 1.0) for name in line[start:k])
            if worth > most:
                best, most = (start, k), worth
            start = k + 1
    return best


def _single(space: Space, name: str, style: Kitchen, rng: Generator) -> None:
    """A needed unit on its own."""
    for _ in range(6):
        run = _run(space, [name], [_size(name, style, rng)], rng)
        if run and _passable(space, run):
            space.add(name, run[0][1], USE)
            return


def _hang(space: Space, budget: int, rng: Generator) -> None:
    """A hood over the hob or cooker and wall units over the rest."""
    low = [i for i in range(space.n) if space.body.size[i, 2] < 1.2]
    cookers = [i for i in low if space.category[i] == "hob"] or [i for i in low if space.category[i] == "oven"]
    low = [i for i in low if space.category[i] not in ("fridge", "hob", "oven")]
    hung = [("hood", i) for i in cookers] + [("wall_unit", int(i)) for i in rng.permutation(low)]
    unit = draw("wall_unit", rng)
    for name, i in hung:
        if budget <= 0 or (name == "hood" and rng.random() < 0.15):
            continue
        size = draw("hood", rng) if name == "hood" else unit.copy()
        size[1] = np.clip(space.body.size[i, 1], *((0.5, 0.95) if name == "hood" else (0.3, 1.2)))
        box = _over(space, name, i, size)
        if space.fits(name, box, NO_USE)[0] and space.stays_open(name, box):
            space.add(name, box)
            budget -= 1


def _over(space: Space, name: str, i: int, size: Array) -> Boxes:
    """The wall behind unit `i`, at the height it hangs."""
    low = space.body.take([i])
    back = (size[0] - low.size[0, 0]) / 2
    xy = low.center[0, :2] + boxes.axes(low)[0, 0] * back
    z = (1.45 if name == "wall_unit" else 1.55) + size[2] / 2
    return Boxes(np.array([[*xy, min(z, space.shape.height - size[2] / 2 - 0.02)]]), size[None], low.yaw)
