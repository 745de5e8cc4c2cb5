"""Surfaces of the building: what a room's floor, walls and joinery are made of, as its plan says or as is usual."""

import logging
from functools import cache
from typing import NamedTuple

from apartgen.schemas.base import RoomType
from apartgen.schemas.plan import Finish, Opening, Plan, Room
from apartgen.stages.things.asset import Material
from apartgen.stages.things.materials import PALETTE

log = logging.getLogger("apartgen")

WALL = Material("wall_render", (0.80, 0.785, 0.76, 1.0), 0.9)
CONCRETE = PALETTE["concrete"]
CEILING = Material("ceiling_paint", (0.96, 0.96, 0.95, 1.0), 0.9)
FRAME = Material("joinery_paint", (0.94, 0.93, 0.91, 1.0), 0.45)
LEAF = Material("door_paint", (0.90, 0.89, 0.86, 1.0), 0.45)
SKIRTING = Material("skirting_paint", (0.95, 0.94, 0.92, 1.0), 0.5)
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
_USUAL = Finish()


class Joinery(NamedTuple):
    """Of what doors and windows are made, and in which designs."""

    frame: Material = FRAME
    leaf: Material = LEAF
    metal: Material = METAL
    door: str = "panelled"
    window: str = "single"


def floor(room: Room, plan: Plan) -> Material:
    """What a room is floored with."""
    return _said(plan, room.id, "floor") or _FLOORS.get(room.base, _OAK)


def wall(room: Room, plan: Plan) -> Material:
    """What a room shows on its walls."""
    return _said(plan, room.id, "wall") or _WALLS.get(room.base, _PAINT)


def skirting(room: Room, plan: Plan) -> Material:
    """What boards at the foot of the walls are painted with."""
    return _said(plan, room.id, "joinery") or SKIRTING


def threshold(plan: Plan) -> Material:
    """What is underfoot in doorways: wood, as in most rooms."""
    floors = [found for room in plan.rooms if (found := _said(plan, room.id, "floor"))]
    wooden = [found for found in floors if found.name.startswith(("floor_", "herringbone")) and found.texture]
    return wooden[0] if wooden else PALETTE["oak"]


def joinery(opening: Opening, plan: Plan) -> Joinery:
    """What an opening's door or window is like: as in the room that it opens to."""
    room = opening.into or opening.rooms[0]
    said = plan.finishes.get(room, _USUAL)
    paint = _said(plan, room, "joinery")
    leaf = ENTRANCE if opening.kind == "entrance" else paint or LEAF
    return Joinery(paint or FRAME, leaf, _said(plan, room, "metal") or METAL, said.door or "panelled",
                   said.window or "single")


def has_skirting(room: RoomType) -> bool:
    """Tiled rooms and the open air have none."""
    return room not in ("bathroom", "balcony")


@cache
def named(name: str) -> Material | None:
    """The material of that name; None, with a warning, where there is none: the usual one is taken then."""
    if name not in PALETTE:
        log.warning("finishes: %r is no material and is passed over; stages/things/materials.py has them", name)
    return PALETTE.get(name)


def _said(plan: Plan, room: str, part: str) -> Material | None:
    name = getattr(plan.finishes.get(room, _USUAL), part)
    return named(name) if name else None
