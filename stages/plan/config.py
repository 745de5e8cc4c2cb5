"""What the plan solver can be told beside the programme."""

from pydantic import Field

from apartgen.schemas.base import Positive, Record
from apartgen.schemas.plan import Walls


class PlanConfig(Record):
    """Effort and building constants; none of them changes what is asked for."""

    whims: int = Field(default=60, ge=1, le=1000, description="draws of what is left open, half as many "
                                                              "once something is given up")
    wave: int = Field(default=2, ge=1, le=64, description="annealing runs between two looks at the plans found")
    enough: int = Field(default=12, ge=1, le=64, description="valid arrangements to choose from before stopping")
    proposals: int = Field(default=800, ge=10, le=100_000, description="proposals of a run, per rectangle of the plan")
    processes: int = Field(default=2, ge=1, le=64, description="annealing threads; the plan does not depend on it")
    height: Positive = Field(default=2.6, le=20, description="ceiling height, m")
    walls: Walls = Walls()
    candidates: int = Field(default=4, ge=1, le=64, description="plans drawn for each variant wanted")
