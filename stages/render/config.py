"""What is rendered."""

from pydantic import Field

from apartgen.schemas.base import Positive, Record
from apartgen.schemas.render import Seeing

KINDS: tuple[Seeing, ...] = ("eye", "panorama", "above", "route")


class RenderConfig(Record):
    """Settings of the stage."""

    kind: list[Seeing] = Field(default_factory=lambda: list(KINDS), description="kinds of view, all by default")
    views: int = Field(8, ge=1, le=200, description="views at the height of eyes")
    frames: int = Field(24, ge=2, le=2000, description="frames along the robot's way through all rooms")
    width: int = Field(640, ge=32, le=4096, description="pixels from left to right")
    height: int = Field(480, ge=32, le=4096, description="pixels from top to bottom")
    field: Positive = Field(80.0, lt=150, description="degrees seen from left to right")
    eye: Positive = Field(1.5, description="height of eyes above the floor, m")
    robot: Positive = Field(1.2, description="height of the robot's camera above the floor, m")
    points: int = Field(200_000, ge=0, le=20_000_000, description="points of the point cloud, 0 for none")
    video: bool = Field(False, description="film the robot's way, doors opening before it, as walk.mp4")
    rate: int = Field(10, ge=1, le=60, description="frames a second of the film")
    speed: Positive = Field(1.0, le=5, description="how fast the robot goes in it, m/s")
    film: int = Field(0, ge=0, le=4096, description="pixels from left to right of it, by default those of pictures")
    back: bool = Field(False, description="film the way from its end back to the entrance")
