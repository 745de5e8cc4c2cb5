"""Furnish every room of a plan with a guided diffusion model."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from apartgen_cli.stage import Stage
from schemas.layout import Layout
from schemas.plan import Plan
from stages import layout
from stages.layout.config import LayoutConfig


def furnish(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> Iterable[Layout]:
    """All apartments in one batch."""
    return layout.run_many(plans, config, rngs) if plans else []


def weights(config: LayoutConfig) -> dict[str, Path]:
    """The weights file; named without torch, so that a finished layout is known again in no time."""
    shipped = Path(layout.__file__).with_name("weights.safetensors")
    return {"weights": Path(config.weights) if config.weights else shipped}


STAGE = Stage("layout", Plan, LayoutConfig, furnish, data=weights)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"layout": STAGE.command()}
