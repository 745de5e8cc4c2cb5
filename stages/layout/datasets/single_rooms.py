"""Single rooms of random shape and size with random doors and windows, furnished by rule and search.

They vary more than the rooms of planned flats do. `homes(None)` needs no files and never ends by itself.
"""

import os
from collections.abc import Iterator
from functools import partial
from itertools import count, islice
from pathlib import Path

import numpy as np
from numpy.random import Generator
from shapely.geometry import Polygon

from apartgen.schemas.base import ROOM_TYPES, RoomType
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import AskedRoom, Opening, Plan, Program, Room
from apartgen.stages.layout.batch import spreading
from apartgen.stages.layout.datasets.furnisher import furnish
from apartgen.stages.space.boxes import Array

MANY = 200
"""Rooms that are worth processes of their own."""
AREA: dict[str, tuple[float, float]] = {
    "living_room": (26.0, 0.34), "kitchen": (9.8, 0.3), "dining_room": (12.5, 0.28), "bedroom": (12.6, 0.26),
    "bathroom": (5.2, 0.28), "hallway": (7.5, 0.4), "study": (9.5, 0.28), "utility": (4.5, 0.35),
    "storage": (3.2, 0.4), "closet": (3.5, 0.4), "balcony": (5.5, 0.4),
}
"""Median floor area in m² and spread of its logarithm."""
LEAST = {"living_room": 3.1, "kitchen": 1.9, "dining_room": 2.6, "bedroom": 2.5, "bathroom": 1.65, "hallway": 1.15,
         "study": 2.1, "utility": 1.5, "storage": 1.0, "closet": 1.1, "balcony": 1.2}
"""Least clear width, m."""
SHARE = {"living_room": 5.0, "bedroom": 4.5, "kitchen": 3.5, "dining_room": 1.8, "study": 1.6, "bathroom": 2.8,
         "hallway": 1.6, "utility": 0.7, "storage": 0.5, "closet": 0.6, "balcony": 0.6}
"""How often each type is made, relative to the others."""
FACADES = {"living_room": (0.5, 0.4, 0.1), "bedroom": (0.72, 0.26, 0.02), "kitchen": (0.8, 0.2, 0.0),
           "dining_room": (0.65, 0.3, 0.05), "study": (0.75, 0.25, 0.0), "balcony": (0.2, 0.3, 0.5)}
"""Shares of rooms with one, two, three outer walls; other types have one."""
HABITABLE = ("living_room", "dining_room", "kitchen", "bedroom", "study")
SMALL_WINDOW = ("bathroom", "utility")
SILL = {"living_room": (0.0, 0.3, 0.6, 0.6, 0.9), "bathroom": (1.4,), "kitchen": (0.95, 1.0, 1.05, 1.1),
        "study": (0.6, 0.9), "utility": (1.4,), "hallway": (0.9,), "dining_room": (0.0, 0.6, 0.9),
        "bedroom": (0.6, 0.9, 0.9)}
CUT = {"living_room": (0.35, 0.4, 0.25), "bedroom": (0.65, 0.3, 0.05), "dining_room": (0.7, 0.25, 0.05),
       "study": (0.75, 0.25, 0.0), "kitchen": (0.82, 0.18, 0.0), "hallway": (0.6, 0.3, 0.1)}
"""Shares of rooms without a corner cut out, with one, with two; few of other types have one."""
OUTER, INNER = 0.15, 0.05
"""From a wall's face to where its openings are drawn, m."""


def homes(root: Path | None = None, seed: int = 0, rooms: int | None = None) -> Iterator[Layout]:
    """`rooms` furnished rooms on all cores, endlessly many on one when None; `root` is not used."""
    with spreading((os.cpu_count() or 1) if rooms is not None and rooms > MANY else 1) as spread:
        yield from spread(partial(_furnished, seed), islice(count(), rooms))


def _furnished(seed: int, k: int) -> Layout:
    rng = np.random.default_rng([seed, k])
    plan = draw(rng)
    return Layout(**dict(plan), objects=furnish(plan, rng))


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
    cuts = int(rng.choice(3, p=CUT.get(type, (0.85, 0.15, 0.0))))
    median, spread = AREA[type]
    area = median * float(np.exp(np.clip(rng.normal(0, spread), -2 * spread, 1.8 * spread)))
    aspect = rng.uniform(1.6, 4.0) if type in ("hallway", "balcony") else 1 + abs(rng.normal(0, 0.35))
    if type == "living_room":
        aspect = np.clip(rng.normal(0.85 + 0.024 * area, 0.25), 1.0, 2.4)
    area *= 1 + 0.14 * cuts
    short = max(LEAST[type], float(np.sqrt(area / aspect)))
    x, y = np.round([max(short, min(area / short, 10.0)), short], 2)
    points = _cut(np.array([x, y]), cuts, 0.8 * LEAST[type], rng)
    for _ in range(int(rng.integers(4))):
        points = np.stack([-points[:, 1], points[:, 0]], 1)
    return np.asarray(points - points.min(0))


def _cut(size: Array, cuts: int, least: float, rng: Generator) -> Array:
    """A rectangle from (0, 0) to `size`, so many corners cut out of which neither side is left shorter than `least`."""
    where = set(rng.permutation(4)[:cuts].tolist()) if size.min() > 1.6 * least else set[int]()
    points = list[Array]()
    for k, corner in enumerate(([0, 0], [1, 0], [1, 1], [0, 1])):
        at = np.array(corner) * size
        if k not in where:
            points.append(at)
            continue
        most = np.minimum(0.48 * size, 0.5 * (size - least) if cuts > 1 else size - least)
        inward = np.maximum(np.round(rng.uniform(0.1, 1.0, 2) * most, 2), 0.15) * (1 - 2 * np.array(corner))
        by = [at + inward * [0, 1], at + inward, at + inward * [1, 0]]
        points += by if k % 2 == 0 else by[::-1]
    return np.array(points, float)


def _openings(type: RoomType, id: str, corners: Array, rng: Generator) -> list[Opening]:
    """Windows in the outer walls, doors in the others, most in corners with the leaf against the wall there."""
    step = np.roll(corners, -1, 0) - corners
    length = np.hypot(*step.T)
    sides = [int(k) for k in rng.permutation(len(length)) if length[k] > 1.0]
    share = FACADES.get(type, (1.0, 0.0, 0.0))
    outer = sides[: min(int(rng.choice(3, p=share)) + 1, len(sides) - 1)]
    inner = [k for k in range(len(length)) if k not in outer]
    taken: list[tuple[int, float, float]] = []
    keep: list[Polygon] = []
    found: list[Opening] = []
    for kind in _kinds(type, len(outer), rng):
        for _ in range(14):
            place = _place(kind, type, outer if kind == "window" else inner, length, rng)
            if place is None:
                continue
            if any(k == place[0] and place[1] < hi + 0.1 and place[2] > lo - 0.1 for k, lo, hi in taken):
                continue
            one = _opening(kind, type, id, len(found), corners, place, rng)
            zone = _kept(one, corners, place[0])
            if any(zone.intersects(other) for other in keep):
                continue
            taken.append(place[:3])
            found.append(one)
            if kind != "window":
                keep.append(zone)
            break
    return found


def _kinds(type: RoomType, facades: int, rng: Generator) -> list[str]:
    doors = {"hallway": int(rng.integers(2, 7)), "living_room": int(rng.choice([1, 1, 1, 2, 2, 3]))}
    count = doors.get(type, 1 + int(rng.random() < 0.08))
    wide = {"living_room": 0.4, "dining_room": 0.5, "kitchen": 0.35, "hallway": 0.3}.get(type, 0.0)
    kinds = ["entrance" if type == "hallway" and rng.random() < 0.7 else "door"] + ["door"] * (count - 1)
    if rng.random() < wide:
        kinds = [*kinds[: len(kinds) - 1], "opening"] if type == "kitchen" else [*kinds, "opening"]
    if type in HABITABLE:
        more = [0, 0, 1, 1, 2] if type == "living_room" else [0, 0, 0, 1]
        return kinds + ["window"] * (facades + int(rng.choice(more)))
    return kinds + ["window"] * int(type in SMALL_WINDOW and rng.random() < 0.4)


def _place(
    kind: str, type: RoomType, sides: list[int], length: Array, rng: Generator
) -> tuple[int, float, float, int] | None:
    """A side, where on it an opening begins and ends, and at which end the leaf hangs; None where it is too short."""
    side, wide = int(rng.choice(sides)), _width(kind, type, rng)
    last = float(length[side]) - wide - 0.1
    if last < 0.1:
        return None
    near = float(rng.choice([0.1, 0.12, 0.2]))
    corner = rng.random() < (0.75 if kind in ("door", "entrance") else 0.0)
    s = (near if rng.random() < 0.5 else last + 0.1 - near) if corner else float(rng.uniform(0.1, last))
    if kind == "window" and rng.random() < 0.5:
        s = (0.1 + last) / 2
    s = float(np.round(np.clip(s, 0.1, last), 3))
    hinge = int(s > (0.1 + last) / 2) if corner else int(rng.integers(2))
    return side, s, s + wide, hinge


def _width(kind: str, type: RoomType, rng: Generator) -> float:
    if kind == "window":
        return float(rng.choice([0.6, 0.9] if type in SMALL_WINDOW else [0.9, 1.0, 1.2, 1.2, 1.4, 1.5, 1.8, 2.1, 2.4]))
    if kind == "opening":
        return float(rng.choice([0.9, 1.2, 1.6, 2.4]))
    return 1.0 if kind == "entrance" else float(rng.choice([0.8, 0.9, 0.9]))


def _kept(one: Opening, corners: Array, side: int) -> Polygon:
    """The floor before an opening, as deep as it is wide."""
    a, b = np.array(one.segment)
    along = np.roll(corners, -1, 0)[side] - corners[side]
    normal = np.array([-along[1], along[0]]) / np.hypot(*along)
    deep = max(float(np.hypot(*(b - a))) if one.into else 0.6, 0.6)
    return Polygon([a, b, b + deep * normal, a + deep * normal])


def _opening(
    kind: str, type: RoomType, id: str, n: int, corners: Array, place: tuple[int, float, float, int], rng: Generator
) -> Opening:
    side, low, high, hinge = place
    window = kind == "window"
    along = np.roll(corners, -1, 0)[side] - corners[side]
    along = along / np.hypot(*along)
    off = corners[side] - (OUTER if kind in ("window", "entrance") else INNER) * np.array([-along[1], along[0]])
    (ax, ay), (bx, by) = off + along * low, off + along * high
    outward = type in ("hallway", "closet", "storage", "balcony")
    inwards = kind in ("door", "entrance") and rng.random() < (0.2 if outward and kind == "door" else 0.85)
    return Opening(
        id=f"{kind}_{n + 1}", kind=kind, rooms=[id], segment=((float(ax), float(ay)), (float(bx), float(by))),
        sill=float(rng.choice(SILL.get(type, (0.9,)))) if window else 0.0, head=2.2 if window else 2.05, hinge=hinge,
        into=id if inwards else None,
    )
