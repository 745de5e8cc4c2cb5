"""Coming in and putting away: halls with a place for coats, closets, store rooms; and balconies."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors, dressing, storing
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone
from apartgen.stages.layout.datasets._furnish.household import Household, one_of
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space


def hallway(space: Space, home: Household) -> None:
    """A place for coats first, shoes beside it, a mirror, somewhere to sit; no more than two cabinets."""
    rng, area = space.rng, space.shape.area
    closed = space.wants("wardrobe", 0.55) and area > 4
    coats = any(_coats(space, name) for name in (("wardrobe", "coat_rack") if closed else ("coat_rack", "wardrobe")))
    space.need(coats, 3)
    if not space.wish("shoes", 0.75, lambda: _shoes(space)) and area > 6:
        space.wish("console", 0.4, lambda: storing.cabinet(space, one_of(rng, "console_table", "chest"), lamp=0.4))
    if not space.has("mirror"):
        space.wish("mirror", 0.6, lambda: dressing.on_wall(space, "mirror", ("shoe_cabinet", "wardrobe", "coat_rack")))
    if area > 5:
        space.wish("bench", 0.3, lambda: _bench(space))
    dressing.ceiling_lamps(space)
    space.wish("lamp", 0.2, lambda: dressing.on_wall(space, "wall_lamp"))
    if area > 6:
        space.wish("plant", 0.2, lambda: storing.plant(space, small=True))
    if area > 5:
        space.wish("runner", 0.3, lambda: _runner(space))


def _coats(space: Space, name: str) -> bool:
    if name == "coat_rack":
        return any(storing.loose(space, name, lean, ("shoe_cabinet",)) for lean in (-0.3, -0.8, -1.0))
    rng = space.rng
    for width in (*rng.permutation([1.0, 1.2, 1.5]), 0.8, 0.7):
        size = draw("wardrobe", rng, -0.3, width=float(width), depth=float(rng.choice([0.45, 0.5, 0.6])))
        size[2] = min(size[2], space.shape.height - 0.1)
        if storing.against_wall(space, storing.row(name, size), 0.8, -3.0, gaps=(0.006,)) >= 0:
            return True
    return False


def _shoes(space: Space) -> bool:
    rng = space.rng
    for lean in (0.0, -0.6, -1.0):
        size = draw("shoe_cabinet", rng, lean)
        group = storing.row("shoe_cabinet", size)
        if rng.random() < 0.5:
            mirror = draw("mirror", rng, -0.2)
            mirror[1] = min(mirror[1], size[1])
            mirror[2] = min(mirror[2], 2.1 - size[2])
            z = round(float(size[2]) + 0.1, 3)
            group = group.with_part(Part("mirror", 0.03, 0.0, np.round(mirror, 3), z=z, at=0))
        near = ("wardrobe", "coat_rack")
        if storing.against_wall(space, group, 0.3, -1.0, near, (0.004,)) >= 0:
            return True
    return False


def _bench(space: Space) -> bool:
    for lean in (-0.2, -0.8):
        size = draw("bench", space.rng, lean, height=0.46)
        group = Group((Part("bench", size[0] / 2, 0.0, size),), (Zone(size[0], size[0] + 0.5, -0.3, 0.3),))
        if storing.against_wall(space, group, 0.3, 0.2, ("coat_rack", "shoe_cabinet"), (0.006,)) >= 0:
            return True
    return False


def _runner(space: Space) -> bool:
    size = draw("rug", space.rng, -1.0)
    size[:2] = [float(np.clip(size[0], 0.6, 0.9)), float(np.clip(size[1], 1.2, 2.0))]
    at, shape = anchors.middle(space), space.shape
    k = int(shape.length.argmax())
    at = at.take(np.abs(np.stack([np.cos(at.yaw), np.sin(at.yaw)], -1) @ shape.along[k]) < 0.1)
    return len(at) > 0 and (
        space.put(Group((Part("rug", 0.0, 0.0, size),)), at, -np.abs(anchors.facing(at, space) - 0.9), 0.1) >= 0)


def closet(space: Space, home: Household) -> None:
    """Clothes along the walls."""
    rng, area = space.rng, space.shape.area
    for _ in range(1 + int(area > 3) + int(area > 5)):
        kind = one_of(rng, "wardrobe", "sliding_wardrobe", "clothes_rail", "shelving", "wardrobe")
        if kind in ("clothes_rail", "shelving"):
            storing.cabinet(space, kind)
        else:
            storing.wardrobe(space, 2.0)
    if (rng.random() < 0.4):
        storing.cabinet(space, one_of(rng, "chest", "shoe_cabinet"))
    if (rng.random() < 0.3):
        dressing.on_wall(space, "mirror")
    if area > 4 and (rng.random() < 0.25):
        storing.loose(space, "pouffe")
    if (rng.random() < 0.3):
        storing.loose(space, "laundry_basket")
    dressing.ceiling_lamps(space)


def storage(space: Space, home: Household) -> None:
    """Shelves, now and then a workbench."""
    rng, area = space.rng, space.shape.area
    if area > 5 and (rng.random() < 0.25):
        storing.cabinet(space, "workbench")
    for _ in range(1 + int(area > 2.5) + int(area > 4.5)):
        storing.cabinet(space, "shelving", int(rng.integers(1, 3)))
    for name, share in (("chest", 0.2), ("wardrobe", 0.25), ("filing_cabinet", 0.12)):
        if (rng.random() < share):
            storing.cabinet(space, name)
    if (rng.random() < 0.25):
        storing.loose(space, "ironing_board")
    dressing.ceiling_lamps(space)


def balcony(space: Space, home: Household) -> None:
    """A small table with its chairs, flowers along the edge."""
    rng, area = space.rng, space.shape.area
    if not _table(space, 2 if area > 2 else 1) and (rng.random() < 0.6):
        _table(space, 1)
    for _ in range(int(rng.integers(1, 3))):
        storing.loose(space, "planter", -0.5)
    if area > 5 and (rng.random() < 0.25):
        _bench(space)
    if (rng.random() < 0.5):
        storing.plant(space, small=True)
    if (rng.random() < 0.3):
        dressing.on_wall(space, "wall_lamp")


def _table(space: Space, count: int) -> bool:
    """Chairs on both sides of a table that stands at the wall or railing."""
    rng = space.rng
    chair = draw("balcony_chair", rng, -0.5)
    for lean in (0.0, -0.8, -1.0):
        size = draw("balcony_table", rng, lean)
        y = size[1] / 2 + chair[0] / 2 + 0.02
        x = max(size[0], chair[1]) / 2
        some = [Part("balcony_chair", x, side * y, chair, -side * np.pi / 2, at=0) for side in (1.0, -1.0)[:count]]
        group = Group((Part("balcony_table", x, 0.0, size), *some))
        at = anchors.walls(space, group, (0.02,))
        if len(at) and space.put(group, at, anchors.to_doors(at.xy, space) * 0.2, 0.3) >= 0:
            return True
    return False
