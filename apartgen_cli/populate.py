"""Put small things where people keep them: on tops and shelves, in drawers and cupboards, on walls."""

from collections.abc import Callable
from typing import Any

from apartgen.steps import POPULATE
from apartgen_cli.stage import Stage


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"populate": Stage(POPULATE, {"libraries": "library"}).command()}
