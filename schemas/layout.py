"""The furnished plan: every object as an oriented box with a shape latent."""

from pydantic import Field

from apartgen.schemas.base import Number, Positive, Record, Vector
from apartgen.schemas.plan import Plan


class Box(Record):
    """An oriented box: `size` is [depth, width, height] along its own x (front), y (left), z."""

    id: str
    room: str
    category: str
    center: Vector
    size: tuple[Positive, Positive, Positive]
    yaw: Number
    latent: list[Number] = Field(default_factory=list, description="32-d shape latent f")
    on: str | None = Field(None, description="what carries it: another object's id, floor, wall or ceiling")


class Layout(Plan):
    """Body of a `layout` artifact."""

    objects: list[Box] = Field(default_factory=list)
