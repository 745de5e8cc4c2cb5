"""How much is put into a home."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Record


class PopulateConfig(Record):
    """Settings of the stage."""

    density: float = Field(1.0, ge=0.0, le=4.0, description="how much there is of everything, 1 as people have it")
    walls: bool = Field(True, description="pictures, clocks, hooks, switches and sockets on walls")
    doors_open: bool = Field(False, description="doors between rooms stand open")
    parts: Literal["shut", "random"] = Field("shut", description="how doors and drawers of furniture stand")
    grasps: bool = Field(True, description="how a parallel gripper takes hold of each thing")
