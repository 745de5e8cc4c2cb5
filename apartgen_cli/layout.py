"""Furnish every room of a plan, by relations to walls and things or by guided diffusion."""

from collections.abc import Callable
from typing import Any

from apartgen.steps import LAYOUT
from apartgen_cli.stage import Stage


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"layout": Stage(LAYOUT).command()}
