"""Layout: a guided set diffusion model places every object of an apartment (paper 3.2-3.4, Algorithm 1)."""

from typing import TYPE_CHECKING

from apartgen.stages.layout.config import LayoutConfig

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.random import Generator

    from apartgen.schemas.layout import Layout
    from apartgen.schemas.plan import Plan


def run(previous: "Plan", config: LayoutConfig, rng: "Generator") -> "Layout":
    """Furnish one apartment. BadInput for a wish that no layout can meet."""
    return next(run_many([previous], config, [rng]))


def check(previous: "Plan") -> None:
    """BadInput for wishes of the programme that no layout can meet."""
    from apartgen.stages.layout import wishes

    wishes.check(previous)


def run_many(previous: "list[Plan]", config: LayoutConfig, rngs: "list[Generator]") -> "Iterator[Layout]":
    """Furnish several apartments, each as if it were alone, and give each as it is done; rooms draw by their names.

    BadInput for a wish that no layout can meet, Unmet where sampling diverged.
    """
    from apartgen.stages.layout.batch import furnished
    from apartgen.stages.things.carrying import recorded

    for plan in previous:
        check(plan)
    return map(recorded, furnished(previous, config, rngs))
