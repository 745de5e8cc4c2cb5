"""Give every object of a layout a real asset, by category, size and shape."""

from collections.abc import Callable
from typing import Any

from apartgen.steps import RETRIEVE
from apartgen_cli.stage import Stage


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"retrieve": Stage(RETRIEVE, {"libraries": "library"}).command()}
