"""Furnished homes to send there and back, and how much of them comes back; shares nothing with the reading of files."""

from functools import cache
from typing import NamedTuple

import numpy as np
from plan.flats import flat
from shapely.affinity import rotate, translate
from shapely.geometry import Point, Polygon, box

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan

THINGS = {
    "bedroom": [("double_bed", (2.0, 1.6, 0.5)), ("wardrobe", (0.6, 1.8, 2.2)), ("chest", (0.45, 0.9, 0.8))],
    "living_room": [("sofa", (0.9, 2.1, 0.8)), ("bookshelf", (0.3, 0.9, 1.9)), ("coffee_table", (0.6, 1.0, 0.4))],
    "kitchen": [("fridge", (0.65, 0.6, 1.8)), ("chair", (0.5, 0.45, 0.9))],
    "bathroom": [("toilet", (0.65, 0.38, 0.8)), ("vanity", (0.45, 0.6, 0.85))],
    "study": [("desk", (0.7, 1.4, 0.75)), ("office_chair", (0.6, 0.6, 1.0))],
}
NAMES = ("studio", "one_bedroom", "two_bedroom", "three_bedroom")


@cache
def furnished(name: str, seed: int) -> Layout:
    """A plan with a few pieces anywhere in its rooms, clear of walls and of each other."""
    plan, rng = flat(name, seed), np.random.default_rng([seed, 7])
    objects: list[Box] = []
    for room in plan.rooms:
        free = Polygon(room.polygon).buffer(-0.02, join_style="mitre")
        for category, size in THINGS.get(room.base, []):
            found = _anywhere(free, size, rng)
            if found is None:
                continue
            x, y, yaw, mark = found
            free = free.difference(mark)
            objects.append(
                Box(
                    id=f"{room.id}.{category}_1",
                    room=room.id,
                    category=category,
                    center=(round(x, 3), round(y, 3), size[2] / 2),
                    size=size,
                    yaw=round(yaw, 4),
                )
            )
    return Layout(**dict(plan), objects=objects)


def _anywhere(free, size, rng):
    x0, y0, x1, y1 = free.bounds
    for _ in range(200):
        yaw = float(rng.choice([0.0, np.pi / 2, -np.pi / 2, np.pi - 1e-4, rng.uniform(-3, 3)]))
        x, y = rng.uniform((x0, y0), (x1, y1))
        mark = translate(rotate(box(-size[0] / 2, -size[1] / 2, size[0] / 2, size[1] / 2), yaw, (0, 0), True), x, y)
        if free.contains(mark):
            return float(x), float(y), yaw, mark
    return None


class Kept(NamedTuple):
    """How much of a home came back: the least room IoU, openings missed, furniture missed, the farthest moved, m."""

    iou: float
    types: bool
    openings: list[str]
    lost: list[str]
    moved: float
    turned: float


def compared(given: Layout, back: Plan) -> Kept:
    """Rooms by best overlap, openings by kind, middle and rooms, furniture by category and nearest middle."""
    shapes = {room.id: Polygon(room.polygon) for room in back.rooms}
    ious, partner = [], {}
    for room in given.rooms:
        own = Polygon(room.polygon)
        overlaps = {id: own.intersection(s).area / own.union(s).area for id, s in shapes.items()}
        partner[room.id] = max(overlaps, key=overlaps.get)
        ious.append(overlaps[partner[room.id]])
    kinds = {room.id: room.type for room in back.rooms}
    same = len(back.rooms) == len(given.rooms) and all(kinds[partner[r.id]] == r.type for r in given.rooms)
    missed = [o.id for o in given.openings if not any(_alike(o, p, partner) for p in back.openings)]
    missed += ["added"] * (len(back.openings) - len(given.openings))
    lost, moved, turned = [], 0.0, 0.0
    there = list(back.objects) if isinstance(back, Layout) else []
    for o in given.objects:
        near = [p for p in there if p.category == o.category and p.room == partner[o.room]]
        if not near:
            lost.append(o.id)
            continue
        p = min(near, key=lambda p: np.hypot(*np.subtract(p.center, o.center)[:2]))
        moved = max(
            moved,
            float(np.abs(np.subtract(p.center, o.center)).max()),
            float(np.abs(np.subtract(p.size, o.size)).max()),
        )
        turned = max(turned, abs(float((p.yaw - o.yaw + np.pi) % (2 * np.pi) - np.pi)))
    return Kept(min(ious), same, missed, lost, moved, turned)


def _alike(o: Opening, p: Opening, partner: dict[str, str]) -> bool:
    (a, b), (c, d) = np.array(o.segment), np.array(p.segment)
    middle = Point((a + b) / 2).distance(Point((c + d) / 2))
    widths = abs(np.hypot(*(b - a)) - np.hypot(*(d - c)))
    heights = abs(o.sill - p.sill) + abs(o.head - p.head)
    return (
        o.kind == p.kind
        and {partner[r] for r in o.rooms} == set(p.rooms)
        and max(middle, widths) < 0.05
        and heights < 0.02
    )


def leaves(plan: Plan) -> set[tuple[float, float, str]]:
    """Where leaves are hinged, to 5 cm, and the type of room they open into."""
    types = {room.id: room.type for room in plan.rooms}
    hung = [(o.segment[o.hinge], types[o.into]) for o in plan.openings if o.into]
    return {(round(x * 20) / 20, round(y * 20) / 20, type) for (x, y), type in hung}
