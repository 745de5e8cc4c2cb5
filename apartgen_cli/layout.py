"""Furnish every room of a plan with a guided diffusion model."""

from collections.abc import Callable
from typing import Any

from apartgen.steps import LAYOUT
from apartgen_cli.stage import Stage


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"layout": Stage(LAYOUT).command()}
