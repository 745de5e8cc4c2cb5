"""Requirements as wishes that the solver weighs: rows of kind, room, other, direction or lengths, and a weight."""

from collections.abc import Mapping

import numpy as np

from apartgen.schemas.plan import Program, Requirement, Side
from apartgen.stages.plan import wished
from apartgen.stages.plan.slicing import Floats

DIRECTIONS: Mapping[str, tuple[int, int]] = {
    "north": (0, 1), "south": (0, -1), "east": (1, 0), "west": (-1, 0),
    "right": (1, 0), "left": (-1, 0), "top": (0, 1), "bottom": (0, -1),
    "north_east": (1, 1), "north_west": (-1, 1), "south_east": (1, -1), "south_west": (-1, -1),
}  # fmt: skip
"""Where on the drawing a place is, north up."""
COUNTS = {wished.PLACE: 600.0, wished.CENTRE: 400.0, wished.BESIDE: 100.0, wished.NEAR_ENTRANCE: 12.0,
          wished.FAR_FROM_ENTRANCE: 8.0, wished.ADJACENT: 60.0, wished.APART: 40.0, wished.LENGTHS: 25.0,
          wished.LONG: 200.0, wished.WIDE: 400.0, wished.SIZE: 1000.0}  # fmt: skip
"""What each lack counts: of places in half extents of the home, of areas in parts of them, of others in metres."""
ENTRANCE = {"front": wished.NEAR_ENTRANCE, "near": wished.NEAR_ENTRANCE, "back": wished.FAR_FROM_ENTRANCE,
            "apart": wished.FAR_FROM_ENTRANCE}  # fmt: skip


EXTENTS = {"length": wished.LONG, "width": wished.WIDE}
UNLIMITED = 1e3
"""Metres, and square metres, that no room has."""
CLOSE = 0.02
"""Part by which an area may be off that was said."""
BESIDE_PLACES = 0.5
"""Share that areas count where places are told, which are the harder to keep."""


def placed(program: Program) -> bool:
    """Whether it tells where rooms lie."""
    return any(asked.kind == "position" for asked in program.requirements)


def wishes(program: Program) -> Floats:
    """One row (6,) for each requirement of rooms of the programme that an arrangement can be better or worse at."""
    index = {room.id: i for i, room in enumerate(program.rooms)}
    rows = [row for asked in program.requirements if asked.of in index for row in _row(asked, index)]
    counts = {**COUNTS, wished.SIZE: COUNTS[wished.SIZE] * (BESIDE_PLACES if placed(program) else 1.0)}
    return np.array([(*row, counts[row[0]]) for row in rows], float).reshape(-1, 6)


def _row(asked: Requirement, index: dict[str, int]) -> list[tuple[int, int, int, float, float]]:
    room, value = index[asked.of], str(asked.value or "")
    other = index.get(asked.to or "", -1)
    x, y = DIRECTIONS.get(value, (0, 0))
    match asked.kind:
        case "position" if asked.to is None and value == "centre":
            return [(wished.CENTRE, room, -1, 0, 0)]
        case "position" | "orientation" if asked.to is None and value in DIRECTIONS:
            return [(wished.PLACE, room, -1, x, y)]
        case "position" if other >= 0 and value in DIRECTIONS:
            return [(wished.BESIDE, room, other, x, y)]
        case "position" if asked.to is None and value in ENTRANCE:
            return [(ENTRANCE[value], room, -1, 0, 0)]
        case "near" | "apart" if asked.to == "entrance":
            return [(ENTRANCE[asked.kind], room, -1, 0, 0)]
        case "adjacent" | "apart" if other >= 0:
            return [(wished.ADJACENT if asked.kind == "adjacent" else wished.APART, room, other, 0, 0)]
        case "dimension":
            return [(wished.LENGTHS, room, -1, *lengths(value))]
        case "area":
            return [(wished.SIZE, room, -1, float(value) * (1 + CLOSE), float(value) * (1 - CLOSE))]
        case "at_least" | "at_most" if asked.to is None:
            most, least = (float(value), 0.0) if asked.kind == "at_most" else (UNLIMITED, float(value))
            return [(wished.SIZE, room, -1, most, least)]
        case "at_least" | "at_most" if asked.to in EXTENTS:
            most, least = (float(value), 0.0) if asked.kind == "at_most" else (UNLIMITED, float(value))
            return [(EXTENTS[asked.to], room, -1, most, least)]
    return []


def lengths(value: str) -> tuple[float, float]:
    """The two of `5 x 4`."""
    a, _, b = value.partition(" x ")
    return float(a), float(b)


def sunny(program: Program) -> set[Side]:
    """Sides that must have windows, for rooms are to face them."""
    asked = {str(r.value) for r in program.requirements if r.kind == "orientation"}
    sides: tuple[Side, ...] = ("south", "east", "north", "west")
    return {side for side in sides if any(side in value for value in asked)}
