"""The layout with real assets: each box has an asset and its joints."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Number, Record, Vector
from apartgen.schemas.layout import Box, Layout


class AssetKey(Record):
    """Where an asset is found."""

    library: str
    id: str


class Joint(Record):
    """One moving part in the object's frame (origin at the box's centre); metres, radians."""

    name: str
    type: Literal["hinge", "slide"]
    axis: Vector
    origin: Vector
    range: tuple[Number, Number]
    part: str = Field(description="GAPartNet class, e.g. hinge_door, slider_drawer, hinge_lid")
    extent: tuple[Vector, Vector] | None = Field(
        None, description="least and greatest corner of the moving part, all joints at zero, object's frame"
    )


class Furnishing(Box):
    """A placed asset; `joints` is empty when nothing moves."""

    asset: AssetKey
    joints: list[Joint] = Field(default_factory=list)


class Retrieve(Layout):
    """Body of a `retrieve` artifact."""

    objects: list[Furnishing] = Field(default_factory=list)  # type: ignore[assignment]
