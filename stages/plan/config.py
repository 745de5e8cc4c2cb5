"""What the plan solver can be told beside the programme."""

from pydantic import Field

from schemas.base import Positive, Record
from schemas.plan import Walls


class PlanConfig(Record):
    """Effort and building constants; none of them changes what is asked for."""

    restarts: int = Field(48, ge=1, le=10_000, description="annealing runs at most, per relaxation step")
    wave: int = Field(4, ge=1, le=64, description="runs between two looks at whether good plans were found")
    enough: int = Field(3, ge=1, le=64, description="valid arrangements to choose from before stopping")
    proposals: int = Field(800, ge=10, le=100_000, description="proposals of a run, per rectangle of the plan")
    processes: int = Field(2, ge=1, le=64, description="annealing threads; the plan does not depend on it")
    height: Positive = 2.6
    walls: Walls = Walls()
    candidates: int = Field(12, ge=1, le=64, description="plans drawn for each variant wanted")
