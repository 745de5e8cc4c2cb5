"""The types every artifact is made of."""

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

RoomType = Literal[
    "living_room", "kitchen", "dining_room", "bedroom", "bathroom", "hallway",
    "study", "utility", "storage", "closet", "balcony",
]
ROOM_TYPES: tuple[RoomType, ...] = RoomType.__args__  # type: ignore[attr-defined]

Positive = Annotated[float, Field(gt=0, allow_inf_nan=False)]
Number = Annotated[float, Field(allow_inf_nan=False)]
Point = tuple[Number, Number]
Vector = tuple[Number, Number, Number]
Polygon = Annotated[list[Point], Field(min_length=3)]


class Record(BaseModel):
    """Fields of later stages and of newer minor additions are read over, never an error; numbers are finite.

    What checks a record is built when one is first made, for most commands meet few of all kinds.
    """

    model_config = ConfigDict(extra="ignore", validate_assignment=True, allow_inf_nan=False, defer_build=True)
