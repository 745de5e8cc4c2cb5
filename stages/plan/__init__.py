"""Programme to floor plan: simulated annealing of slicing trees, then doors and windows.

`build` makes one plan, `build_variants` several different ones; `from_polygons` gives walls, doors and windows to
a plan drawn by hand; `validate` checks any plan.
"""

from typing import TYPE_CHECKING

from apartgen.stages.plan.config import PlanConfig

if TYPE_CHECKING:
    from numpy.random import Generator

    from apartgen.schemas.plan import Plan, Program, Room

__all__ = ["PlanConfig", "build", "build_variants", "from_polygons", "validate", "warm"]


def build(program: "Program", config: PlanConfig, rng: "Generator", prompt: str = "") -> "Plan":
    """A floor plan for a programme.

    Raises BadInput for a programme that names rooms wrongly, Unmet (naming the contradiction) where no plan exists.
    """
    from apartgen.stages.plan.newcomers import named, plain
    from apartgen.stages.plan.solve import solve

    return _finished(named(solve(plain(program), config, rng), program.rooms), prompt, rng, "finishes")


def build_variants(
    program: "Program", config: PlanConfig, rng: "Generator", k: int, prompt: str = ""
) -> "list[Plan]":
    """`k` clearly different floor plans for a programme; raises as `build` does."""
    from apartgen.stages.plan.newcomers import named, plain
    from apartgen.stages.plan.variants import several

    plans = several(plain(program), config, rng, k)
    return [_finished(named(plan, program.rooms), prompt, rng, f"finishes {i}") for i, plan in enumerate(plans)]


def _finished(plan: "Plan", prompt: str, rng: "Generator", lane: str) -> "Plan":
    """The plan with what its rooms are finished with, for which nothing is drawn that anything else hangs on."""
    from apartgen.stages import seeds
    from apartgen.stages.things import palettes

    return plan.model_copy(update={"prompt": prompt, "finishes": palettes.drawn(plan.rooms, seeds.lane(rng, lane))})


def from_polygons(rooms: "list[Room]", config: PlanConfig, program: "Program | None" = None) -> "Plan":
    """A plan drawn by hand, rooms touching or a wall apart, with walls, doors and windows.

    Without a programme the links are what touches, corridors first. Raises BadInput for overlapping or broken
    polygons, Unmet naming the door that finds no place.
    """
    from apartgen.stages.plan.drawn import built
    from apartgen.stages.plan.newcomers import as_base, named, plain

    return named(built([as_base(room) for room in rooms], config, program and plain(program)), rooms)


def validate(plan: "Plan") -> list[str]:
    """What is wrong with a plan, in words; empty when every hard requirement is met."""
    from apartgen.stages.plan.judge import faults

    return faults(plan)


def warm() -> None:
    """Compile the solver into its cache, so that the first plan does not wait for it; needs write access to it."""
    import numpy as np

    from apartgen.stages.plan.study import archetypes

    build(archetypes()["studio"], PlanConfig(), np.random.default_rng(0))
