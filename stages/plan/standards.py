"""Housing standards by room type; the data is `standards.toml`."""

import tomllib
from dataclasses import dataclass
from pathlib import Path

from apartgen.schemas.base import ROOM_TYPES, RoomType

LINK_WALL = 1.1
"""Straight wall two linked rooms share: a 0.9 m door and its frames."""


@dataclass(frozen=True)
class Standard:
    """What a room of one type must offer; see `standards.toml` for the fields."""

    width: float
    area: float
    aspect: float
    face: float
    door: float
    glass: float
    sill: float
    head: float
    wet: bool = False
    functional: bool = False
    outer: bool = False
    across: float = 0.0

    @property
    def lit(self) -> bool:
        """Whether it may not go without a window."""
        return self.face > 0 and self.glass > 0


def _load() -> dict[RoomType, Standard]:
    table = tomllib.loads((Path(__file__).parent / "standards.toml").read_text())
    return {kind: Standard(**table[kind]) for kind in ROOM_TYPES}


STANDARDS: dict[RoomType, Standard] = _load()
