"""Rooms in order, small enough to see at a glance, and furniture to put them out of order."""

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Room
from apartgen.stages import use
from apartgen.stages.things.categories import TABLE

WEST, EAST, NORTH, SOUTH = np.pi, 0.0, np.pi / 2, -np.pi / 2


def thing(category: str, x: float, y: float, yaw: float = 0.0, size=None, bottom=None, id: str = "") -> Box:  # type: ignore
    size = size or TABLE[category].size
    bottom = TABLE[category].z if bottom is None else bottom
    return Box(id=id or f"{category}@{x:g},{y:g}", room="r_1", category=category,
               center=(x, y, bottom + size[2] / 2), size=size, yaw=yaw)


def room(kind: str, width: float, depth: float, *things: Box) -> use.Furnished:
    polygon = [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)]
    return use.Furnished(use.alone(Room(id="r_1", type=kind, polygon=polygon)), things)  # type: ignore[arg-type]


def living() -> list[Box]:
    """Sofa at the south wall of a 5 × 4 m room, coffee table, television across."""
    return [thing("sofa", 2.5, 0.47, NORTH), thing("coffee_table", 2.5, 1.6, NORTH),
            thing("tv_stand", 2.5, 3.77, SOUTH),
            thing("armchair", 0.8, 1.9, EAST)]


def bedroom() -> list[Box]:
    """A double bed with its head at the west wall of a 4 × 4 m room, two nightstands, a wardrobe."""
    stand = (0.42, 0.48, 0.52)
    return [thing("double_bed", 1.06, 2.0, EAST), thing("nightstand", 0.22, 3.1, EAST, stand),
            thing("nightstand", 0.22, 0.9, EAST, stand), thing("wardrobe", 3.69, 2.0, WEST)]


def table() -> list[Box]:
    seats = [(2.0 + dx, 1.5 + dy, SOUTH if dy > 0 else NORTH) for dx in (-0.4, 0.4) for dy in (-0.6, 0.6)]
    return [thing("dining_table", 2.0, 1.5, NORTH), *(thing("chair", *seat) for seat in seats)]


KITCHEN = [("fridge", 0.3), ("kitchen_base", 0.9), ("kitchen_base", 1.5), ("kitchen_sink", 2.2),
           ("kitchen_drawers", 2.9), ("hob", 3.5)]


def kitchen() -> list[Box]:
    """One run along the south wall, a hood above the hob."""
    units = [thing(name, x, TABLE[name].size[0] / 2 + 0.01, NORTH) for name, x in KITCHEN]
    return [*units, thing("hood", 3.5, 0.25, NORTH)]


def bathroom() -> list[Box]:
    return [thing("toilet", 0.34, 1.0, EAST), thing("vanity", 2.2, 1.25, WEST), thing("mirror", 2.42, 1.25, WEST),
            thing("shower", 0.46, 2.53, EAST)]


ROOMS = {"living_room": (5.0, 4.0, living), "bedroom": (4.0, 4.0, bedroom), "dining_room": (4.0, 3.0, table),
         "kitchen": (4.2, 3.0, kitchen), "bathroom": (2.45, 3.0, bathroom)}
