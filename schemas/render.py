"""What cameras saw: a frame for each, and which number in its pictures is which thing."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Number, Record, Vector
from apartgen.schemas.export import File

Seeing = Literal["eye", "panorama", "above", "route"]
Row4 = tuple[Number, Number, Number, Number]


class Instance(Record):
    """One thing: its number in instance pictures, its class's number in semantic ones. `id` is the artifact's, empty
    for what has none there; `box` is [x, y, z, depth, width, height, yaw] of objects, in the world.
    """

    number: int
    id: str
    category: str
    label: int
    room: str = ""
    box: tuple[Number, Number, Number, Number, Number, Number, Number] | None = None


class Visible(Record):
    """What of an instance a frame shows: its pixels, the least rectangle about them, [x, y, width, height], and
    `inmost`, the pixel farthest from its borders, [x, y], with how many steps it takes to one.
    """

    number: int
    pixels: int
    rectangle: tuple[int, int, int, int]
    inmost: tuple[int, int, int] = (0, 0, 0)


class View(Record):
    """One frame. `pose` takes points of the camera (x right, y down, z ahead) to the world; a panorama's camera is
    level and looks along the world's +x, its depth is along the ray and not along z.

    `intrinsics` are fx, fy, cx, cy in pixels, None of a panorama; the middle of the first pixel is at (0.5, 0.5).
    """

    name: str
    kind: Seeing
    room: str = ""
    width: int
    height: int
    intrinsics: Row4 | None = None
    pose: tuple[Row4, Row4, Row4, Row4]
    visible: list[Visible] = Field(default_factory=list)

    @property
    def eye(self) -> Vector:
        """Where the camera is."""
        return self.pose[0][3], self.pose[1][3], self.pose[2][3]


class Shown(Record):
    """A frame of a film: when it is seen, in which room its camera stands, and of each instance that it shows the
    number and the pixels.
    """

    seconds: Number
    room: str = ""
    visible: list[tuple[int, int]] = Field(default_factory=list)


class Film(Record):
    """A film of the robot's way: its file, frames a second, and what each frame shows."""

    file: str
    rate: int
    width: int
    height: int
    frames: list[Shown] = Field(default_factory=list)


class Render(Record):
    """Body of a `render` artifact."""

    views: list[View] = Field(default_factory=list)
    film: Film | None = None
    instances: list[Instance] = Field(default_factory=list)
    labels: dict[str, int] = Field(default_factory=dict, description="number of each class")
    files: list[File] = Field(default_factory=list)
