"""Surfaces of the building: what floors and walls of each type of room are made of."""

from apartgen.schemas.base import RoomType
from apartgen.stages.things.asset import Material
from apartgen.stages.things.materials import PALETTE

WALL = Material("wall_render", (0.80, 0.785, 0.76, 1.0), 0.9)
CONCRETE = PALETTE["concrete"]
CEILING = Material("ceiling_paint", (0.96, 0.96, 0.95, 1.0), 0.9)
SKIRTING = Material("skirting_paint", (0.95, 0.94, 0.92, 1.0), 0.5)
THRESHOLD = PALETTE["oak"]
FRAME = Material("joinery_paint", (0.94, 0.93, 0.91, 1.0), 0.45)
LEAF = Material("door_paint", (0.90, 0.89, 0.86, 1.0), 0.45)
ENTRANCE = PALETTE["dark_oak"]
METAL = Material("brushed_steel", (0.62, 0.62, 0.62, 1.0), 0.35, 0.9)
GLASS = Material("window_glass", (0.72, 0.85, 0.90, 0.25), 0.05)

_OAK, _TILE, _DECK = PALETTE["floor_oak"], PALETTE["floor_tile"], PALETTE["decking"]
_PAINT = Material("wall_paint", (0.93, 0.91, 0.87, 1.0), 0.9)
_WARM = Material("wall_paint_sand", (0.90, 0.86, 0.78, 1.0), 0.9)
_COOL = Material("wall_paint_mist", (0.84, 0.88, 0.88, 1.0), 0.9)
_RENDER = Material("balcony_render", (0.86, 0.85, 0.82, 1.0), 0.95)
_TILED = PALETTE["tile_white"]

_FLOORS: dict[RoomType, Material] = {
    "kitchen": _TILE, "bathroom": _TILE, "utility": _TILE, "storage": PALETTE["concrete"], "balcony": _DECK,
}
_WALLS: dict[RoomType, Material] = {
    "bathroom": _TILED, "bedroom": _COOL, "study": _COOL, "kitchen": _PAINT, "living_room": _WARM,
    "dining_room": _WARM, "balcony": _RENDER,
}


def floor(room: RoomType) -> Material:
    """What a room of this type is floored with."""
    return _FLOORS.get(room, _OAK)


def wall(room: RoomType) -> Material:
    """What a room of this type shows on its walls."""
    return _WALLS.get(room, _PAINT)


def has_skirting(room: RoomType) -> bool:
    """Tiled rooms and the open air have none."""
    return room not in ("bathroom", "balcony")
