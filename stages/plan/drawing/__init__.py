"""What the file of a floor plan shows, whatever its format: rooms, walls, holes in them, furniture.

Metres, x to the right, y up, z from the floor. A format fills a `Drawing`; `completed.plan_of` makes a plan of it.
"""

from dataclasses import dataclass, field
from typing import Literal

from shapely.geometry import Polygon

from apartgen.schemas.base import Point, Vector


@dataclass(frozen=True)
class Space:
    """A room: its name, empty where it has none, and its floor, which may reach into its walls."""

    name: str
    floor: Polygon


@dataclass(frozen=True)
class Hole:
    """A door, a passage without a leaf, or a window: the line it takes out of a wall.

    `hinge` is where the leaf turns and `swung` where its free end is when it stands open; None where the file does
    not say. So are `sill` and `head`.
    """

    name: str
    kind: Literal["door", "opening", "window"]
    ends: tuple[Point, Point]
    sill: float | None = None
    head: float | None = None
    hinge: Point | None = None
    swung: Point | None = None


@dataclass(frozen=True)
class Thing:
    """A piece of furniture: what the file calls it, the middle of its box, [depth, width, height], its yaw.

    Not `turned`, the yaw tells how the box lies, but not which of its sides is the front; not `sized`, the file has no
    sizes, and this is the usual one.
    """

    name: str
    middle: Vector
    size: tuple[float, float, float]
    yaw: float
    turned: bool = True
    sized: bool = True


@dataclass(frozen=True)
class Label:
    """A text of the drawing, which names the room that it stands in."""

    text: str
    at: Point


@dataclass(frozen=True)
class Drawing:
    """One storey. `walls` are the floors that walls stand on, over doors too; `outer` is how thick outside walls are,
    where the walls do not show it.

    `said` is what the format left out or took for granted, in words for the user.
    """

    spaces: list[Space] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)
    walls: list[Polygon] = field(default_factory=list)
    holes: list[Hole] = field(default_factory=list)
    things: list[Thing] = field(default_factory=list)
    height: float | None = None
    outer: float | None = None
    said: list[str] = field(default_factory=list)
