"""Furnish every room of a plan with a guided diffusion model."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from apartgen_cli.stage import Stage
from schemas.layout import Layout
from schemas.plan import Plan
from stages.layout.config import LayoutConfig


def furnish(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> Iterable[Layout]:
    """All apartments in one batch."""
    from stages import layout

    return layout.run_many(plans, config, rngs) if plans else []


STAGE = Stage("layout", Plan, LayoutConfig, furnish)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"layout": STAGE.command()}
