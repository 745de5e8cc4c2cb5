"""Make room to walk: swap, nudge or drop furniture until a robot gets everywhere."""

from collections.abc import Callable
from typing import Any

from apartgen.steps import WALKABLE
from apartgen_cli.stage import Stage


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"walkable": Stage(WALKABLE, {"libraries": "library"}).command()}
