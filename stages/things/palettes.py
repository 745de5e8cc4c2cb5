"""What a home is finished with, drawn from the styles of `palettes.toml`: once for all rooms, and for each."""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TypeVar

from numpy.random import Generator
from pydantic import ConfigDict, TypeAdapter

from apartgen.schemas.plan import Finish, Room
from apartgen.stages import seeds

Names = tuple[str, ...]
Any = TypeVar("Any")

TILED = ("bathroom",)
"""Rooms whose walls are tiled."""
WET = (*TILED, "utility")
"""Rooms whose floors are tiled; some kitchens' are, too."""
BARE = ("balcony", "storage")
"""Rooms that are finished as usual, whatever the style."""
TILED_KITCHENS = 0.5
"""Share of homes whose kitchen has a tiled floor."""
OWN_WALLS = ("living_room", "bedroom", "dining_room", "study")
"""Rooms that have walls of their own; the others have the home's."""


@dataclass(frozen=True, kw_only=True)
class Style:
    """One style; `palettes.toml` says what each list is."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    floors: Names
    walls: Names
    joinery: Names
    doors: Names
    windows: Names
    metals: Names
    woods: tuple[Names, ...]
    cloth: Names
    rugs: Names
    beds: Names
    kitchens: tuple[tuple[str, str, str], ...]
    wet_floors: Names
    wet_walls: Names


@cache
def styles() -> dict[str, Style]:
    """Every style by its name."""
    rows = tomllib.loads((Path(__file__).parent / "palettes.toml").read_text(encoding="utf-8"))
    return TypeAdapter(dict[str, Style]).validate_python(rows)


def drawn(rooms: Sequence[Room], rng: Generator) -> dict[str, Finish]:
    """The finishes of a home's rooms; a room's own are drawn in a lane of its own."""
    table = styles()
    name = _one(tuple(table), rng)
    style = table[name]
    home, tiled = _home(name, style, rng), rng.random() < TILED_KITCHENS
    wet_floor, walls = _one(style.wet_floors, rng), _one(style.walls, rng)
    found = {}
    for room in (room for room in rooms if room.base not in BARE):
        own = seeds.lane(rng, room.id)
        wet = room.base in WET or (room.base == "kitchen" and tiled)
        wall = _one(style.wet_walls if room.base in TILED else style.walls, own)
        found[room.id] = home.model_copy(update={
            "floor": wet_floor if wet else home.floor,
            "wall": wall if room.base in (*TILED, *OWN_WALLS) else walls,
            "cloth": [_one(style.cloth, own), _one(style.cloth, own)],
            "rug": _one(style.rugs, own), "bedding": _one(style.beds, own),
        })  # fmt: skip
    return found


def _home(name: str, style: Style, rng: Generator) -> Finish:
    """What all rooms of a home share."""
    front, worktop, handles = _one(style.kitchens, rng)
    return Finish(
        style=name, floor=_one(style.floors, rng), joinery=_one(style.joinery, rng), door=_one(style.doors, rng),
        window=_one(style.windows, rng), metal=_one(style.metals, rng), woods=list(_one(style.woods, rng)),
        front=front, worktop=worktop, handles=handles,
    )  # fmt: skip


def _one(options: Sequence[Any], rng: Generator) -> Any:
    return options[int(rng.integers(len(options)))]
