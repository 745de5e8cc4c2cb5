"""What can be set in the walkable stage."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from apartgen.schemas.base import Positive, Record

Share = Annotated[float, Field(ge=0, lt=1)]


class WalkableConfig(Record):
    """Target, effort, and which steps beyond Algorithm 2 are taken."""

    target: float | None = Field(None, ge=0, le=1, description="least share of floor that stays free (τ); by default "
                                 "what furnished rooms of these types have, about .66 of a two-bedroom flat")
    scope: Literal["apartment", "rooms"] = Field("apartment", description="meets it: all floors together, or each")
    top_k: int = Field(3, ge=1, le=1000, description="largest objects replaced in an iteration (k)")
    max_iterations: int = Field(20, ge=0, le=10_000, description="iterations at most (M), each time the loop runs")
    share: float = Field(0.9, gt=0, lt=1, description="sides of a smaller candidate, at most this share of the old")
    gentle: Share = Field(0.8, description="least share of its sides an object keeps while there is decoration to "
                          "spare; 0 runs the loop of Algorithm 2 once")
    drop: bool = Field(True, description="leave out the least important objects where smaller ones do not suffice")
    connect: bool = Field(True, description="make the free space connected for a robot, up to all that opens")
    unblock: bool = Field(True, description="let all parts of furniture and all doors move through their whole range")
    robot_radius: Positive = 0.25
    reach: Positive = Field(0.8, description="from the robot's centre to the front of what it uses, m")
    resolution: Positive = Field(0.05, ge=0.01, le=0.1, description="cells of the occupancy raster, m")
    write_anyway: bool = Field(False, description="give the best apartment found although it misses the target")

    @model_validator(mode="after")
    def _reaching(self) -> "WalkableConfig":
        if self.reach <= self.robot_radius:
            raise ValueError(f"--reach {self.reach:g}: ends within the robot, whose radius is {self.robot_radius:g} m; "
                             "give more, or a smaller --robot-radius")
        return self
