"""Single rooms of random shape and size with random doors and windows, furnished by rule and search.

They vary more than the rooms of planned flats do. `homes(None)` needs no files and never ends by itself.
"""

from collections.abc import Iterator
from itertools import count, islice
from pathlib import Path

import numpy as np
from numpy.random import Generator

from apartgen.schemas.base import ROOM_TYPES, RoomType
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import AskedRoom, Opening, Plan, Program, Room
from apartgen.stages.layout.datasets.furnisher import furnish
from apartgen.stages.space.boxes import Array

AREA: dict[str, tuple[float, float]] = {
    "living_room": (21.0, 0.35), "kitchen": (9.5, 0.32), "dining_room": (12.0, 0.3), "bedroom": (12.5, 0.3),
    "bathroom": (5.0, 0.35), "hallway": (7.0, 0.45), "study": (9.5, 0.28), "utility": (4.5, 0.35),
    "storage": (3.2, 0.4), "closet": (3.5, 0.4), "balcony": (5.5, 0.4),
}
"""Median floor area in m² and spread of its logarithm."""
LEAST = {"living_room": 3.0, "kitchen": 1.8, "dining_room": 2.4, "bedroom": 2.4, "bathroom": 1.5, "hallway": 1.1,
         "study": 2.0, "utility": 1.5, "storage": 1.0, "closet": 1.0, "balcony": 1.2}
"""Least clear width, m."""
SHARE = {"living_room": 5.0, "bedroom": 5.0, "kitchen": 3.0, "dining_room": 2.2, "study": 2.2, "bathroom": 2.0,
         "hallway": 1.0, "utility": 0.6, "storage": 0.5, "closet": 0.6, "balcony": 0.7}
"""How often each type is made, relative to the others."""
SMALL_WINDOW = ("bathroom", "utility")
SILL = {"living_room": (0.0, 0.3, 0.6, 0.6), "bathroom": (1.4,), "kitchen": (1.0, 1.05, 1.1), "study": (0.6, 0.9),
        "utility": (1.4,), "hallway": (0.9,), "dining_room": (0.0, 0.6, 0.9), "bedroom": (0.6, 0.9, 0.9)}


def homes(root: Path | None = None, seed: int = 0, rooms: int | None = None) -> Iterator[Layout]:
    """`rooms` furnished rooms, endlessly many when None; `root` is not used."""
    for k in islice(count(), rooms):
        rng = np.random.default_rng([seed, k])
        plan = draw(rng)
        yield Layout(**dict(plan), objects=furnish(plan, rng))


def draw(rng: Generator, type: RoomType | None = None) -> Plan:
    """An empty plan of one random room."""
    if type is None:
        share = np.array([SHARE[name] for name in ROOM_TYPES])
        type = ROOM_TYPES[int(rng.choice(len(ROOM_TYPES), p=share / share.sum()))]
    id = f"{type}_1"
    corners = _corners(type, rng)
    openings = _openings(type, id, corners, rng)
    height = float(rng.choice([2.4, 2.5, 2.6, 2.6, 2.7, 2.8, 3.0]))
    return Plan(
        program=Program(rooms=[AskedRoom(id=id, type=type)]), height=height, openings=openings,
        rooms=[Room(id=id, type=type, polygon=[(float(x), float(y)) for x, y in corners])],
    )


def _corners(type: RoomType, rng: Generator) -> Array:
    """A rectangle, or one with a corner or two cut out."""
    median, spread = AREA[type]
    area = median * rng.lognormal(0, spread)
    aspect = rng.uniform(2.0, 4.5) if type in ("hallway", "balcony") else 1 + abs(rng.normal(0, 0.35))
    short = max(LEAST[type], float(np.sqrt(area / aspect)))
    x, y = np.round([max(short, min(area / short, 9.0)), short], 2)
    points = np.array([[0, 0], [x, 0], [x, y], [0, y]], float)
    if rng.random() < 0.28 and short > 1.6 * LEAST[type]:
        cut = np.round([rng.uniform(0.1, 0.45) * x, rng.uniform(0.1, 0.45) * y], 2)
        cut = np.maximum(cut, 0.15)
        points = np.array([[0, 0], [x, 0], [x, y - cut[1]], [x - cut[0], y - cut[1]], [x - cut[0], y], [0, y]])
    for _ in range(int(rng.integers(4))):
        points = np.stack([-points[:, 1], points[:, 0]], 1)
    return np.asarray(points - points.min(0))


def _openings(type: RoomType, id: str, corners: Array, rng: Generator) -> list[Opening]:
    step = np.roll(corners, -1, 0) - corners
    length = np.hypot(*step.T)
    taken: list[tuple[int, float, float]] = []
    found: list[Opening] = []
    outside = [int(k) for k in rng.permutation(len(length)) if length[k] > 1.0][: int(rng.integers(1, 3))]
    inner = [k for k in range(len(length)) if k not in outside[:1]]
    for kind in _kinds(type, rng):
        wide = _width(kind, type, rng)
        sides = outside if kind == "window" else inner
        place = _free_place(sides, length, wide, taken, rng)
        if place is None:
            continue
        side, s = place
        taken.append((side, s, s + wide))
        along = step[side] / length[side]
        off = -0.15 if kind in ("window", "entrance") else -0.05
        a = corners[side] + along * s + off * np.array([-along[1], along[0]])
        b = a + along * wide
        found.append(_opening(kind, type, id, len(found), a, b, rng))
    return found


def _kinds(type: RoomType, rng: Generator) -> list[str]:
    doors = {"hallway": int(rng.integers(2, 6)), "living_room": int(rng.integers(1, 4))}
    extra = doors.get(type, 1 + int(rng.random() < 0.2)) - 1
    kinds = ["entrance" if type == "hallway" and rng.random() < 0.5 else "door"] + ["door"] * extra
    if type in ("living_room", "dining_room", "kitchen", "hallway") and rng.random() < 0.35:
        kinds.append("opening")
    habitable = type in ("living_room", "dining_room", "kitchen", "bedroom", "study")
    some = int(rng.random() < 0.4 * (type in SMALL_WINDOW))
    windows = int(rng.choice([1, 1, 2, 2, 3])) if habitable else some
    return kinds + ["window"] * windows


def _width(kind: str, type: RoomType, rng: Generator) -> float:
    if kind == "window":
        return float(rng.choice([0.6, 0.9] if type in SMALL_WINDOW else [0.9, 1.2, 1.4, 1.5, 1.8, 2.1, 2.4]))
    if kind == "opening":
        return float(rng.choice([1.0, 1.2, 1.6, 2.4]))
    return 1.0 if kind == "entrance" else float(rng.choice([0.8, 0.9, 0.9]))


def _free_place(
    sides: list[int], length: Array, wide: float, taken: list[tuple[int, float, float]], rng: Generator
) -> tuple[int, float] | None:
    """A side and where on it an opening of that width begins; None where none is found."""
    for _ in range(12):
        side = int(rng.choice(sides)) if sides else -1
        if side < 0 or length[side] < wide + 0.21:
            continue
        last = length[side] - wide - 0.1
        s = float(np.round(rng.choice([0.1, last, rng.uniform(0.1, last)]), 3))
        if all(k != side or s > hi + 0.1 or s + wide < lo - 0.1 for k, lo, hi in taken):
            return side, s
    return None


def _opening(kind: str, type: RoomType, id: str, n: int, a: Array, b: Array, rng: Generator) -> Opening:
    window = kind == "window"
    sill = float(rng.choice(SILL.get(type, (0.9,)))) if window else 0.0
    outward = type in ("hallway", "closet", "storage", "balcony")
    inwards = kind in ("door", "entrance") and rng.random() < (0.3 if outward else 0.75)
    return Opening(
        id=f"{kind}_{n + 1}", kind=kind, rooms=[id],
        segment=((float(a[0]), float(a[1])), (float(b[0]), float(b[1]))), sill=sill, head=2.2 if window else 2.05,
        hinge=1 if rng.random() < 0.5 else 0, into=id if inwards else None,
    )
