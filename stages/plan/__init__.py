"""Programme to floor plan: simulated annealing of slicing trees, then doors and windows.

`build` makes one plan, `build_variants` several different ones; `from_polygons` gives walls, doors and windows to
a plan drawn by hand; `validate` checks any plan.
"""

from typing import TYPE_CHECKING

from stages.plan.config import PlanConfig

if TYPE_CHECKING:
    from numpy.random import Generator

    from schemas.plan import Plan, Program

__all__ = ["PlanConfig", "build", "validate"]


def build(program: "Program", config: PlanConfig, rng: "Generator", prompt: str = "") -> "Plan":
    """A floor plan for a programme.

    Raises BadInput for a programme that names rooms wrongly, Unmet (naming the contradiction) where no plan exists.
    """
    from stages.plan.solve import solve

    return solve(program, config, rng).model_copy(update={"prompt": prompt})


def validate(plan: "Plan") -> list[str]:
    """What is wrong with a plan, in words; empty when every hard requirement is met."""
    from stages.plan.validate import faults

    return faults(plan)
