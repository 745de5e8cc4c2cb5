"""Furnish every room of a plan with a guided diffusion model."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan
from apartgen.stages import layout
from apartgen.stages.layout.config import LayoutConfig
from apartgen_cli.stage import Outcome, Stage


def furnish(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> Iterable[Outcome]:
    """The apartments, but those that ask for what no layout can have."""
    wrong = [_fault(plan) for plan in plans]
    good = [i for i, fault in enumerate(wrong) if fault is None]
    made = layout.run_many([plans[i] for i in good], config, [rngs[i] for i in good])
    for fault in wrong:
        yield fault or next(made)


def _fault(plan: Plan) -> ApartgenError | None:
    try:
        layout.check(plan)
    except ApartgenError as error:
        return error
    return None


def weights(config: LayoutConfig) -> dict[str, Path]:
    """The weights file; named without torch, so that a finished layout is known again in no time."""
    shipped = Path(layout.__file__).with_name("weights.safetensors")
    return {"weights": Path(config.weights) if config.weights else shipped}


STAGE = Stage("layout", Plan, LayoutConfig, furnish, data=weights)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"layout": STAGE.command()}
