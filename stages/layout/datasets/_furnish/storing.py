"""Storing: wardrobes, chests, shelves and cabinets with their backs to walls, rather in corners than in the way."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array

BEFORE = {"wardrobe": 0.8, "sliding_wardrobe": 0.75, "chest": 0.8, "bookshelf": 0.6, "sideboard": 0.7,
          "display_cabinet": 0.7, "filing_cabinet": 0.7, "console_table": 0.5, "shelving": 0.65, "shoe_cabinet": 0.6,
          "piano": 0.8, "workbench": 0.85, "clothes_rail": 0.6, "washing_machine": 0.7, "dryer": 0.7}
"""Floor kept free for use, m."""
FRIENDS = {"bookshelf": ("armchair", "pouffe"), "shelving": ("laundry_basket",), "piano": ("stool",)}


def row(name: str, size: Array, count: int = 1, gap: float = 0.0, at: int = -1) -> Group:
    """So many alike side by side, backs to the wall, with the floor before them."""
    pitch = float(size[1]) + gap
    ys = [(k - (count - 1) / 2) * pitch for k in range(count)]
    parts = tuple(Part(name, size[0] / 2, y, size, at=at if k == 0 else 0) for k, y in enumerate(ys))
    half = ((count - 1) * pitch + size[1]) / 2
    return Group(parts, (Zone(size[0], size[0] + BEFORE.get(name, 0.5), -half, half, FRIENDS.get(name, ())),))


def against_wall(
    space: Space, group: Group, corner: float = 0.6, window: float = -1.0, near: tuple[str, ...] = (),
    gaps: tuple[float, ...] = (0.006, anchors.BESIDE), middle: float = 0.0,
) -> int:
    """Put a group at a wall; weights of what is liked: a corner, a window behind, the wall's middle."""
    at = anchors.walls(space, group, gaps)
    if not len(at):
        return -1
    liking = corner * anchors.cornered(at, group, space) + window * anchors.windowed(at, group, space)
    liking -= 1.2 * (at.gap > 0.1) + middle * np.minimum(anchors.off_middle(at, group, space), 2.0)
    liking -= 0.3 * anchors.seen_from_doors(at, 0.3, space)
    if near:
        liking -= 0.5 * np.minimum(anchors.to_things(at.xy, space, *near), 4.0)
    return space.put(group, at, liking, 0.3)


def wardrobe(space: Space, most: float = 2.5) -> bool:
    """As much wardrobe as finds a wall: one, or two alike side by side."""
    rng = space.rng
    sliding = rng.random() < 0.35
    widths = [w for w in ((2.7, 2.4, 2.0, 1.8, 1.5, 1.2) if sliding else (2.5, 2.25, 2.0, 1.8, 1.5, 1.2, 1.0, 0.8))
              if w <= most]
    start = int(rng.integers(0, max(1, (len(widths) + 1) // 2)))
    for width in [*widths[start:], 0.8]:
        name = "sliding_wardrobe" if sliding and width >= 1.2 else "wardrobe"
        size = draw(name, rng, 0.0, width=width)
        size[2] = min(size[2], np.round(space.shape.height - 0.05, 2))
        two = name == "wardrobe" and 1.0 <= width <= 1.25 and rng.random() < 0.4
        for count in (2, 1) if two else (1,):
            if against_wall(space, row(name, size, count), 1.0, -3.0, gaps=(0.006,)) >= 0:
                return True
    return False


def chest(space: Space, mirror: float = 0.3, lamp: float = 0.3) -> bool:
    """A chest of drawers, now and then a mirror or a lamp with it."""
    rng = space.rng
    for lean in (None, -0.8):
        size = draw("chest", rng, lean)
        group = row("chest", size)
        if rng.random() < mirror:
            glass = draw("mirror", rng, -0.3)
            glass[1] = min(glass[1], size[1] * 0.9)
            glass[2] = min(glass[2], space.shape.height - size[2] - 0.3)
            group = group.with_part(Part("mirror", 0.03, 0.0, glass, z=round(float(size[2]) + 0.12, 3), at=0))
        elif rng.random() < lamp:
            group = group.with_part(_lamp(space, size))
        if against_wall(space, group, 0.2, -0.6, gaps=(0.004,) if len(group.parts) > 1 else (0.006,)) >= 0:
            return True
    return False


def _lamp(space: Space, size: Array) -> Part:
    lamp = draw("table_lamp", space.rng, -0.3)
    lamp[:2] = np.minimum(lamp[:2], size[0] - 0.04)
    y = float(space.rng.choice([-1, 1])) * (size[1] / 2 - lamp[1] / 2 - 0.05)
    return Part("table_lamp", size[0] / 2, y, lamp, z=float(size[2]), at=0)


def cabinet(space: Space, name: str, count: int = 1, near: tuple[str, ...] = (), lamp: float = 0.0) -> bool:
    """Cabinets or shelves, so many alike side by side or the next fewer."""
    rng = space.rng
    for n in range(count, 0, -1):
        for lean in (None, -0.7):
            size = space.model(name) if lean is None else draw(name, rng, lean)
            size[2] = min(size[2], np.round(space.shape.height - 0.05, 2))
            group = row(name, size, n)
            if n == 1 and rng.random() < lamp:
                group = group.with_part(_lamp(space, size))
            tall = size[2] > 1.1
            if space.left >= len(group.parts) and against_wall(
                    space, group, 0.6 if tall else 0.1, -2.0 if tall else -0.4, near,
                    (0.006,) if tall else (0.006, anchors.BESIDE), 0.0 if tall else 0.2) >= 0:
                return True
    return False


def plant(space: Space, small: bool = False) -> bool:
    """A plant in a corner, rather a light one."""
    size = draw("plant", space.rng, -0.6 if small else None)
    group = Group((Part("plant", size[0] / 2, 0.0, size),))
    at = anchors.walls(space, group, (0.03,))
    if not len(at):
        return False
    at = at.take((anchors.cornered(at, group, space) > 0) | (space.rng.random(len(at)) < 0.15))
    liking = 1.2 * anchors.cornered(at, group, space) - 0.35 * np.minimum(anchors.to_windows(at.xy, space), 4.0)
    return space.put(group, at, liking, 0.3) >= 0


def loose(space: Space, name: str, lean: float | None = None, near: tuple[str, ...] = ()) -> bool:
    """Something small in a corner or at a wall, out of the way."""
    size = draw(name, space.rng, lean)
    group = Group((Part(name, size[0] / 2, 0.0, size),))
    return against_wall(space, group, 0.9, 0.0, near, (0.02,)) >= 0


def piano(space: Space) -> bool:
    """A piano with its stool."""
    size, stool = draw("piano", space.rng), draw("stool", space.rng, height=0.5)
    group = row("piano", size).with_part(Part("stool", size[0] + 0.3 + stool[0] / 2, 0.0, stool, np.pi, at=0))
    return against_wall(space, group, 0.2, -0.6, gaps=(0.01,)) >= 0
